//! The z-buffer: laws, golden logs, and an oracle that asks every triangle at every pixel.

use crate::support::{Coverage, Random, check_golden, check_laws, covered, log_text, plane_code};
use rasterscope_core::{
    blend::AlphaTest,
    depth::{
        CompareFunction, Cutout, DepthBias, DepthFormat, DepthPlacement, DepthState, Rules,
        z_buffer::{self, Event, Image, Settings, Snapshot, Triangle},
    },
    explain::{Level, Mark},
    math::{Arithmetic, Tally},
    message::Value,
    raster::{Algorithm, Scissor},
    replay::{Budget, Playback},
    trace::NoTrace,
};

/// The picture in LOOK: B goes through A.
const A: Triangle = [[0.3, 0.7, 0.30], [7.8, 1.6, 0.78], [2.2, 6.8, 0.46]];
const B: Triangle = [[7.7, 0.4, 0.22], [7.2, 6.3, 0.44], [0.6, 5.2, 0.74]];

fn run(triangles: &[Triangle], settings: &Settings) -> (Image, Vec<Event>) {
    let mut events = Vec::new();
    let image = z_buffer::draw_traced(triangles, settings, &mut Tally::default(), &mut events);
    (image, events)
}

/// Which triangle each pixel shows.
fn picture(image: &Image) -> String {
    let [width, height] = image.depth.size();
    let letter = |pixel| image.owner(pixel).map_or('.', |n| char::from(b'A' + n as u8));
    let rows = (0..height).map(|y| (0..width).map(|x| letter([x, y])).collect::<String>());
    rows.collect::<Vec<_>>().join("\n")
}

#[test]
fn interpenetrating_triangles_split_along_their_common_line() {
    let expected = [
        "........", //
        ".AAAAABB", ".AAAABBB", ".AAABBB.", ".AAABBB.", "..AABBB.", "..A.....",
    ]
    .join("\n");
    let settings = Settings { format: DepthFormat::Unorm16, ..Settings::new([8, 7]) };
    assert_eq!(picture(&z_buffer::draw(&[A, B], &settings)), expected);
    assert_eq!(
        picture(&z_buffer::draw(&[B, A], &settings)),
        expected.replace('A', "?").replace('B', "A").replace('?', "B")
    );
}

#[test]
fn two_triangles_step_by_step() {
    for (name, format) in [("f32", DepthFormat::F32), ("unorm16", DepthFormat::Unorm16)] {
        let (_, events) = run(&[A, B], &Settings { format, ..Settings::new([8, 7]) });
        check_golden(&format!("z_buffer/{name}"), &log_text(&events));
    }
}

#[test]
fn zero_area_draws_nothing() {
    let sliver = [[0.5, 0.5, 0.1], [3.5, 3.5, 0.1], [6.5, 6.5, 0.1]];
    let (image, events) = run(&[sliver], &Settings::new([8, 7]));
    assert_eq!(events, [Event::Triangle { index: 0 }, Event::Done { passed: 0, failed: 0 }]);
    assert!(picture(&image).chars().all(|c| ".\n".contains(c)));
}

#[test]
fn pass_step_says_before_arrives_and_after() {
    let settings = Settings { format: DepthFormat::Unorm16, ..Settings::new([8, 7]) };
    let mut player = z_buffer::play(vec![A, B], Vec::new(), settings, Budget::default());
    player.seek(player.len());
    while player.sentence().args[1..3] != [("x", Value::Int(4)), ("y", Value::Int(4))] {
        player.back(Level::Detail);
    }
    assert_eq!(player.sentence().id, "z-buffer-pass-nearer");
    let codes: Vec<_> = player.tables()[0].rows.iter().map(|row| row.cells[2].clone()).collect();
    assert_eq!(codes, [38689, 33961, 33961].map(Value::text));
}

/// Until the test, what the pixel will hold is not known: the row of the fragment is the lit one.
#[test]
fn an_arriving_fragment_has_no_after() {
    let settings = Settings { format: DepthFormat::Unorm16, ..Settings::new([8, 7]) };
    let mut player = z_buffer::play(vec![A, B], Vec::new(), settings, Budget::default());
    let (mut arrived, mut decided) = (0, 0);
    for step in 1..=player.len() {
        player.seek(step);
        let tables = player.tables();
        let lit: Vec<_> = tables[0].rows.iter().filter(|row| row.active).map(|row| &*row.name).collect();
        let after = || tables.iter().flat_map(|table| &table.rows).filter(|row| row.name == "row-after");
        match player.event() {
            Some(Event::Fragment { .. }) => {
                arrived += 1;
                assert_eq!(lit, ["row-arrives"]);
                assert!(after().all(|row| row.cells.iter().all(|cell| *cell == Value::None)));
            }
            Some(Event::Pass | Event::Fail) => {
                decided += 1;
                assert_eq!(lit, ["row-after"]);
                assert!(after().all(|row| row.cells.last() != Some(&Value::None)));
            }
            _ => {}
        }
    }
    assert!(arrived > 0 && arrived == decided);
}

/// The least exact depth of all triangles that cover a pixel, rounded to the format.
#[test]
fn nearest_triangle_wins_whatever_the_order() {
    let mut random = Random::new(31);
    for round in 0..300 {
        let algorithm = random.pick(&Algorithm::ALL);
        let format = random.pick(&DepthFormat::ALL);
        let settings = Settings { algorithm, format, ..Settings::new([9, 7]) };
        let triangles: Vec<Triangle> = (0..4).map(|_| any_triangle(&mut random)).collect();
        let image = z_buffer::draw(&triangles, &settings);
        let mut nearest = vec![format.encode(1.0); 63];
        for triangle in &triangles {
            for span in covered(triangle.map(|[x, y, _]| [x, y]), &settings.raster) {
                for x in span.begin..span.end {
                    let stored = &mut nearest[(span.y * 9 + x) as usize];
                    let code = plane_code(triangle, [x, span.y], format);
                    if format.decode(code) < format.decode(*stored) {
                        *stored = code;
                    }
                }
            }
        }
        assert_eq!(image.depth.codes(), nearest, "round {round}: {triangles:?} {settings:?}");
        let reversed: Vec<_> = triangles.iter().rev().copied().collect();
        assert_eq!(z_buffer::draw(&reversed, &settings).depth, image.depth, "order matters");
    }
}

fn any_triangle(random: &mut Random) -> Triangle {
    let steps = random.below(2) == 0;
    let mut coordinate = |high: f32| {
        if steps { random.below(2 * high as u32) as f32 / 2.0 } else { random.uniform(-1.0, high + 1.0) }
    };
    [0; 3].map(|_| [coordinate(9.0), coordinate(7.0), coordinate(16.0) / 16.0])
}

fn any_rules(random: &mut Random) -> Rules {
    let test = AlphaTest { compare: random.pick(&CompareFunction::ALL), reference: 0.5 };
    let cutout = Cutout { test, alpha: [0; 3].map(|_| random.pick(&[0.0, 0.25, 1.0])), r: [1.0, 0.5, 1.0] };
    let bias = DepthBias { constant: random.pick(&[0, 0, -9]), slope: random.pick(&[0.0, -2.0]), clamp: 0.0 };
    Rules {
        placement: DepthPlacement { bias, unclipped: random.below(3) == 0 },
        scissor: (random.below(2) == 0).then(|| Scissor::from([0; 4].map(|_| random.below(7)))),
        cutout: (random.below(2) == 0).then_some(cutout),
    }
}

#[test]
fn a_leaf_with_a_hole_step_by_step() {
    let test = AlphaTest { reference: 0.8, ..AlphaTest::default() };
    let cutout = Cutout { test, alpha: [1.0, 0.0, 1.0], r: [1.0; 3] };
    let leaf = Rules { cutout: Some(cutout), scissor: Some(Scissor::from([2, 2, 3, 3])), ..Rules::default() };
    for (name, early_z) in [("early", true), ("late", false)] {
        let settings = Settings { early_z, ..Settings::new([8, 7]) };
        let mut events = Vec::new();
        let rules = [Rules::default(), leaf];
        z_buffer::draw_ruled_traced(&[A, B], &rules, &settings, &mut Tally::default(), &mut events);
        check_golden(&format!("z_buffer/{name}"), &log_text(&events));
    }
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(32);
    let mut coverage = Coverage::default();
    for _ in 0..120 {
        let mut settings = Settings {
            algorithm: random.pick(&Algorithm::ALL),
            format: random.pick(&DepthFormat::ALL),
            clear: random.pick(&[1.0, 0.5, 0.0]),
            state: DepthState {
                test: random.below(5) > 0,
                compare: random.pick(&CompareFunction::ALL),
                write: random.below(4) > 0,
            },
            ..Settings::new([9, 7])
        };
        settings.raster.arithmetic = random.pick(&Arithmetic::ALL);
        settings.early_z = random.below(2) == 0;
        let triangles: Vec<Triangle> = (0..3).map(|_| any_triangle(&mut random)).collect();
        let rules: Vec<Rules> = (0..random.below(4)).map(|_| any_rules(&mut random)).collect();
        let mut tally = Tally::default();
        let fast = z_buffer::draw_ruled_traced(&triangles, &rules, &settings, &mut tally, &mut NoTrace);
        if rules.is_empty() {
            assert_eq!(z_buffer::draw(&triangles, &settings), fast);
        }
        let mut events = Vec::new();
        let traced = z_buffer::draw_ruled_traced(&triangles, &rules, &settings, &mut tally, &mut events);
        let other = Settings { early_z: !settings.early_z, ..settings };
        let late = z_buffer::draw_ruled_traced(&triangles, &rules, &other, &mut tally, &mut NoTrace);
        assert_eq!(late, fast, "early z changes nothing");
        check_laws(
            (&fast, &traced),
            &events,
            |budget| z_buffer::play_ruled(triangles.clone(), rules.clone(), Vec::new(), settings, budget),
            |state: &Snapshot| state.result().clone(),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn many_pixels_are_drawn_in_runs() {
    let settings = Settings::new([300, 300]);
    let large = [[0.0, 0.0, 0.5], [600.0, 0.0, 0.5], [0.0, 600.0, 0.5]];
    let small = [[10.0, 10.0, 0.25], [20.0, 10.0, 0.25], [10.0, 20.0, 0.25]];
    let mut player = z_buffer::play(vec![large, small], Vec::new(), settings, Budget::default());
    player.seek(player.len());
    let mut shown = vec![None; 300 * 300];
    let marks = player.marks();
    assert!(marks.len() < 400, "{}", marks.len());
    for mark in marks {
        if let Mark::Run { y, columns: [begin, end], object, .. } = mark {
            (begin..end).for_each(|x| shown[(300 * y + x) as usize] = object);
        }
    }
    let image = player.state().result();
    let owners =
        (0..300).flat_map(|y| (0..300).map(move |x| image.owner([x, y]).map(|owner| owner as usize)));
    assert!(owners.eq(shown), "the runs are the image");
}
