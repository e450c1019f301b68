//! Homogeneous edges: laws, golden logs, and an oracle in numbers of any size, whatever the signs of w.

use crate::{
    presets::scene,
    support::{Coverage, Random, check_golden, check_laws, log_text},
};
use rasterscope_core::{
    compare::Pair,
    labs::LabInput,
    math::{Arithmetic, Dyadic, Sign, Tally},
    raster::{
        FillRule, Mistake, Settings, Span, YAxis,
        homogeneous::{self, Event, Snapshot, Vertex},
    },
    replay::Budget,
};

type Triangle = [Vertex; 3];

fn run(vertices: Triangle, near: Option<f32>, settings: &Settings) -> (Vec<Span>, Vec<Event>) {
    let (mut events, mut spans) = (Vec::new(), Vec::new());
    let mut emit = |span| spans.push(span);
    homogeneous::fill_traced(vertices, near, settings, &mut Tally::default(), &mut events, &mut emit);
    spans.sort_unstable_by_key(|span| span.y);
    (spans, events)
}

/// A triangle whose corners may lie behind the eye, beside it or on centres.
fn triangle(random: &mut Random) -> Triangle {
    let family = random.below(4);
    let mut vertices = [0; 3].map(|_| {
        let w = match family {
            0 => random.pick(&[0.5, 1.0, 2.0]),
            1 => random.pick(&[-2.0, -1.0, 0.0, 1.0, 2.0]),
            _ => random.uniform(-2.0, 4.0),
        };
        let mut place = |most: u32| match family {
            0 | 1 => random.below(2 * most) as f32 / 2.0 - 1.0,
            2 => random.uniform(-2.0, most as f32),
            _ => random.near(2.5),
        };
        let (x, y) = (place(11), place(9));
        // On the screen where w is not 0, else a direction.
        if w == 0.0 { [x - 4.0, y - 3.0, w] } else { [x * w, y * w, w] }
    });
    if random.below(8) == 0 {
        vertices[2] = [0, 1, 2].map(|i| vertices[0][i] + vertices[1][i]);
    }
    vertices
}

/// What an edge function, its growth with x and its growth downwards decide.
fn lets_in([value, right, below]: [Sign; 3], fill_rule: FillRule) -> bool {
    match fill_rule {
        FillRule::TopLeft => {
            [value, right, below].into_iter().find(|sign| !sign.is_zero()) == Some(Sign::Positive)
        }
        FillRule::RightOfPoint => value.is_positive() || value.is_zero() && !right.is_negative(),
        FillRule::Inclusive => !value.is_negative(),
        FillRule::Strict => value.is_positive(),
    }
}

/// The oracle: a point of the triangle's plane on the ray through a centre has weights of one sign; its w
/// is their sum's share of the determinant.
fn covered(vertices: Triangle, near: Option<f32>, settings: &Settings) -> Vec<Span> {
    let [a, b, c] = vertices.map(|vertex| vertex.map(Dyadic::from));
    let cross = |p: &[Dyadic; 3], q: &[Dyadic; 3]| {
        [[1, 2], [2, 0], [0, 1]].map(|[i, j]| &p[i] * &q[j] - &p[j] * &q[i])
    };
    let edges = [cross(&b, &c), cross(&c, &a), cross(&a, &b)];
    let determinant = &a[0] * &edges[0][0] + &a[1] * &edges[0][1] + &a[2] * &edges[0][2];
    let turned = determinant.sign();
    if turned.is_zero() {
        return Vec::new();
    }
    let down = if settings.y_axis == YAxis::Down { Sign::Positive } else { Sign::Negative };
    let drawn = |x: u32, y: u32| {
        let [x, y] = [x, y].map(|n| Dyadic::from(n as f32 + 0.5));
        let values = edges.each_ref().map(|[a, b, c]| a * &x + b * &y + c);
        let inside = values.iter().zip(&edges).all(|(value, [a, b, _])| {
            let signs = [value.sign() * turned, a.sign() * turned, b.sign() * turned * down];
            lets_in(signs, settings.fill_rule)
        });
        let [u, v, w] = values;
        let beyond = near.is_none_or(|near| {
            let rest = &determinant - &(Dyadic::from(near) * (u + v + w));
            !(rest.sign() * turned).is_negative()
        });
        inside && beyond
    };
    let rows = (0..settings.size[1]).filter_map(|y| {
        let xs: Vec<u32> = (0..settings.size[0]).filter(|&x| drawn(x, y)).collect();
        let (&begin, &last) = (xs.first()?, xs.last()?);
        assert_eq!(xs.len() as u32, last + 1 - begin, "what is seen of a triangle is convex");
        Some(Span { y, begin, end: last + 1 })
    });
    rows.collect()
}

fn settings(random: &mut Random) -> Settings {
    Settings {
        fill_rule: random.pick(&FillRule::ALL),
        y_axis: random.pick(&[YAxis::Down, YAxis::Up]),
        ..Settings::new([9, 7])
    }
}

#[test]
fn equals_the_oracle_behind_the_eye_and_before_it() {
    let mut random = Random::new(41);
    let (mut pixels, mut behind) = (0, 0);
    for _ in 0..3_000 {
        let vertices = triangle(&mut random);
        let settings = settings(&mut random);
        let near = random.pick(&[None, None, Some(0.5), Some(1.0)]);
        let (spans, _) = run(vertices, near, &settings);
        assert_eq!(spans, covered(vertices, near, &settings), "{vertices:?} {near:?} {settings:?}");
        let count: u32 = spans.iter().map(Span::len).sum();
        pixels += count;
        behind += if vertices.iter().any(|[_, _, w]| *w <= 0.0) { count } else { 0 };
    }
    assert!(pixels > 10_000 && behind > 4_000, "{pixels} pixels, {behind} of triangles that reach behind");
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(43);
    let mut coverage = Coverage::default();
    for case in 0..300 {
        let vertices = triangle(&mut random);
        let near = random.pick(&[None, Some(0.75)]);
        let settings = Settings {
            arithmetic: random.pick(&Arithmetic::ALL),
            mistake: Some(random.pick(&Mistake::OF_HOMOGENEOUS)).filter(|_| case % 3 == 0),
            ..settings(&mut random)
        };
        let mut fast = Vec::new();
        homogeneous::fill(vertices, near, &settings, &mut Tally::default(), &mut |span| fast.push(span));
        fast.sort_unstable_by_key(|span| span.y);
        let (traced, events) = run(vertices, near, &settings);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| homogeneous::play(vertices, near, settings, budget),
            Snapshot::result,
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

fn subject(name: &str) -> (Triangle, Option<f32>, Settings) {
    let scene = scene(name);
    let Some(LabInput::Homogeneous(input)) = scene.lab.map(|lab| lab.input) else {
        panic!("{name} opens the lab");
    };
    (input.vertices.expect("a triangle of its own"), input.near, Settings::new(scene.size))
}

#[test]
fn each_case_has_a_log() {
    for (file, preset) in [
        ("in_front", "homogeneous-in-front"),
        ("one_behind", "homogeneous-one-behind"),
        ("two_behind", "homogeneous-two-behind"),
        ("w_zero", "homogeneous-w-zero"),
        ("near_plane", "homogeneous-near-plane"),
        ("edge_on", "homogeneous-edge-on"),
    ] {
        let (vertices, near, settings) = subject(preset);
        let (_, events) = run(vertices, near, &settings);
        // Row by row it says nothing that the other logs of the way over the box do not.
        let centres = |event: &&Event| {
            matches!(
                event,
                Event::Walk { event: rasterscope_core::raster::traversal::Event::Test { .. }, .. }
            )
        };
        let most = if file == "near_plane" { usize::MAX } else { 12 };
        let tests = events.iter().filter(centres).take(most).count();
        let end = events.iter().enumerate().filter(|(_, event)| centres(event)).nth(tests).map(|(i, _)| i);
        check_golden(&format!("homogeneous/{file}"), &log_text(&events[..end.unwrap_or(events.len())]));
    }
}

#[test]
fn presets_are_what_their_sentences_say() {
    let drawn = |name: &str| {
        let (vertices, near, settings) = subject(name);
        let spans = run(vertices, near, &settings).0;
        assert_eq!(spans, covered(vertices, near, &settings), "{name}");
        spans.iter().map(Span::len).sum::<u32>()
    };
    let behind = |name: &str| subject(name).0.iter().filter(|[_, _, w]| *w < 0.0).count();
    assert_eq!((behind("homogeneous-one-behind"), behind("homogeneous-two-behind")), (1, 2));
    for (name, pixels) in [
        ("homogeneous-in-front", 38),
        ("homogeneous-one-behind", 76),
        ("homogeneous-two-behind", 46),
        ("homogeneous-w-zero", 72),
        ("homogeneous-near-plane", 27),
        ("homogeneous-edge-on", 0),
    ] {
        assert_eq!(drawn(name), pixels, "{name}");
    }
    let pair = Pair::play(&scene("homogeneous-divide-first"), Budget::default()).expect("it compares");
    let pair = pair.unwrap_or_else(|problem| panic!("{}", problem.id));
    assert!(pair.difference().count() > 10, "the mistake draws another triangle");
}

/// The camera's triangle comes out where the pipeline draws it, if nothing was clipped.
#[test]
fn a_triangle_of_the_scene_is_the_one_on_the_screen() {
    use rasterscope_core::{labs, pipeline::screen_triangles, scene::Lab};
    let mut scene = scene("two-through-each-other");
    scene.lab = Some(Lab::new(labs::default_input("homogeneous").expect("a lab")));
    let Some(LabInput::Homogeneous(input)) = scene.lab.as_ref().map(|lab| &lab.input) else {
        panic!("it is the lab's");
    };
    let corners = input.corners(&scene).expect("the scene draws a triangle");
    let on_screen = screen_triangles(&scene)[0].vertices;
    let is_there = |[x, y, w]: &&Vertex| {
        on_screen.iter().any(|[a, b, _]| (x / w - a).abs() < 1e-4 && (y / w - b).abs() < 1e-4)
    };
    // The third one lies to the right of the image: clipping has cut it off.
    assert_eq!(corners.iter().filter(is_there).count(), 2, "{corners:?} {on_screen:?}");
    assert_eq!(input.near(&scene), Some(1.0), "the camera's");
    let run = labs::play(&scene, Budget::default()).unwrap_or_else(|problem| panic!("{}", problem.id));
    assert!(run.len() > 20);
}
