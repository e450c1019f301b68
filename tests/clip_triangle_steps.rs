//! Clipping a triangle step by step: laws, golden logs, the pipeline's bits, exact oracles of every space
//! and plane set, and what each mistake breaks.

use crate::support::{Coverage, Random, check_golden, check_laws, clipped_corners, log_text};
use rasterscope_core::{
    clip::polygon::{
        Origin, Plane, PlaneSet,
        clip_space::{self, TaughtCorner},
        clip_triangle::{self as ct, Event, Mistake, Outcome, Pieces, Settings, Snapshot, Space, Subject},
    },
    labs::LabInput,
    math::{Arithmetic, Dyadic, Tally},
    scene::{Scene, preset},
    transform::{Camera, DepthRange, Projection, divide},
};

const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64];

fn traced(subject: &Subject) -> (Outcome, Vec<Event>) {
    let mut events = Vec::new();
    let outcome = ct::run_traced(subject, &mut Tally::default(), &mut events);
    (outcome, events)
}

/// What the lab of a preset runs.
fn subject_of(name: &str) -> Subject {
    let scene = Scene::from_json(preset(name).expect("it is built in").json.as_bytes()).expect("it is valid");
    match &scene.lab.as_ref().expect("it opens a lab").input {
        LabInput::ClipTriangle(input) => input.subject(&scene),
        other => panic!("{name} opens {}", other.name()),
    }
}

#[track_caller]
fn check(name: &str) {
    let (_, events) = traced(&subject_of(name));
    check_golden(&format!("clip_triangle/{}", name.replace('-', "_")), &log_text(&events));
}

#[test]
fn each_preset_takes_its_own_steps() {
    check("clip-behind-and-right");
    check("clip-one-in");
    check("clip-two-in");
    check("clip-frustum-corner");
    check("clip-divide-first");
    check("clip-crack");
    check("clip-camera-space");
}

/// A camera and a triangle before it: round numbers, near borders, around the eye, any binary32.
fn subject(random: &mut Random) -> Subject {
    let near = random.pick(&[1.0, 0.5, 0.1]);
    let projection = match random.below(4) {
        0 => Projection::Orthographic { height: 4.0 },
        1 => Projection::Perspective { fovy_degrees: 60.0 },
        _ => Projection::Perspective { fovy_degrees: 90.0 },
    };
    let camera = Camera { near, far: 3.0, projection, ..Camera::default() };
    let family = random.below(5);
    let mut coordinate = |axis: usize| match (family, axis) {
        (0, _) => random.below(9) as f32 - 4.0,
        (1, _) => random.grid(-4, 4),
        (2, 2) => {
            let border = random.pick(&[-near, -3.0, 0.0, -2.0]);
            random.near(border)
        }
        (2, _) => {
            let border = random.pick(&[2.0, -2.0, 0.5]);
            random.near(border)
        }
        (3, _) => random.uniform(-1e3, 1e3),
        _ => random.uniform(-3.0, 3.0),
    };
    let vertices = [0; 3].map(|_| [0, 1, 2].map(&mut coordinate));
    let range = random.pick(&DepthRange::ALL);
    let aspect = random.pick(&[1.0, 1.5]);
    Subject::new((vertices, [0.0, 1.0, 0.25]), (camera, aspect), range, Settings::default())
}

fn every_setting() -> Vec<Settings> {
    let mut all = Vec::new();
    for arithmetic in ARITHMETICS {
        for mistake in Mistake::ALL {
            for space in Space::ALL {
                let planes = PlaneSet::ALL[all.len() % 3];
                let pieces = Pieces::ALL[all.len() % 2];
                all.push(Settings { space, planes, pieces, mistake, arithmetic });
            }
        }
    }
    all
}

/// Corners with their sources and the bits of their numbers, and the triangles of the fan: a NaN is equal
/// to itself.
type Bits = (Vec<(Origin, [u32; 5])>, Vec<[u8; 3]>);

fn bits(outcome: &Outcome) -> Bits {
    let corner = |TaughtCorner { corner, attribute }: &TaughtCorner| {
        let [x, y, z, w] = corner.position;
        (corner.origin, [x, y, z, w, *attribute].map(f32::to_bits))
    };
    (outcome.corners.iter().map(corner).collect(), outcome.triangles.clone())
}

#[test]
fn keeps_the_laws_with_every_setting() {
    let mut random = Random::new(6);
    let mut coverage = Coverage::default();
    for round in 0..12 {
        for settings in every_setting() {
            let mut subject = Subject { settings, ..subject(&mut random) };
            if round == 0 {
                // On a rounding tie or far beyond any: so that corners are merged, and one is lost.
                let far = 1e30;
                subject.vertices = [[far, far, -1.5], [-far, far, -1e-30], [0.0, -far, -2.0]];
            }
            let (outcome, events) = traced(&subject);
            check_laws(
                (&bits(&ct::run(&subject)), &bits(&outcome)),
                &events,
                |budget| ct::play(subject, budget),
                |state: &Snapshot| bits(&state.result()),
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
}

fn sorted(corners: &[TaughtCorner]) -> Vec<[u32; 4]> {
    let mut all: Vec<_> =
        corners.iter().map(|there| there.corner.position.map(|c| (c + 0.0).to_bits())).collect();
    all.sort_unstable();
    all
}

#[test]
fn the_default_is_what_the_pipeline_does_bit_for_bit() {
    let mut random = Random::new(7);
    let mut cut = 0;
    for _ in 0..20_000 {
        let subject = subject(&mut random);
        let mut tally = Tally::default();
        let polygon =
            clip_space::clip_triangle(subject.in_clip_space(), subject.range, PlaneSet::All, &mut tally);
        let outcome = ct::run(&subject);
        let positions = |corners: &[clip_space::Corner]| {
            corners.iter().map(|c| c.position.map(f32::to_bits)).collect::<Vec<_>>()
        };
        let ours: Vec<_> = outcome.corners.iter().map(|there| there.corner).collect();
        assert_eq!(positions(&ours), positions(polygon.corners()), "{subject:?}");
        for (there, corner) in outcome.corners.iter().zip(polygon.corners()) {
            assert_eq!(there.attribute, polygon.attribute(corner, subject.attribute, &mut tally));
        }
        cut += u32::from(!polygon.is_whole() && !ours.is_empty());
    }
    assert!(cut > 4_000, "{cut} were cut");
}

/// The exact distances of the vertices from a plane, by the inequalities of the space.
fn distances(subject: &Subject, plane: Plane) -> [Dyadic; 3] {
    let exact = Dyadic::from;
    let guard = exact(subject.settings.planes.guard());
    let matrix = subject.projection;
    subject.entering().map(|vertex| {
        let [x, y, z, w] = vertex.map(exact);
        let camera = subject.settings.space == Space::Camera;
        let (x, y, w) = match (camera, subject.camera.projection) {
            (false, _) => (x, y, w),
            (true, Projection::Perspective { .. }) => (&x * &exact(matrix[0]), &y * &exact(matrix[5]), -&z),
            (true, Projection::Orthographic { .. }) => {
                (&x * &exact(matrix[0]), &y * &exact(matrix[5]), exact(1.0))
            }
        };
        let side = &guard * &w;
        match plane {
            Plane::Left => side + x,
            Plane::Right => side - x,
            Plane::Bottom => side + y,
            Plane::Top => side - y,
            Plane::Near if camera => -z - exact(subject.camera.near),
            Plane::Far if camera => exact(subject.camera.far) + z,
            Plane::Near if subject.range == DepthRange::MinusOneToOne => w + z,
            Plane::Near => z,
            Plane::Far => w - z,
        }
    })
}

#[test]
fn every_space_and_plane_set_agrees_with_the_oracle() {
    let mut random = Random::new(8);
    let mut cut = [0; 2];
    let guards = [PlaneSet::Guard(1), PlaneSet::Guard(3), PlaneSet::Near, PlaneSet::All];
    for _ in 0..8_000 {
        for space in Space::ALL {
            let planes = random.pick(&guards);
            let settings = Settings { space, planes, ..Settings::default() };
            let subject = Subject { settings, ..subject(&mut random) };
            let outcome = ct::run(&subject);
            let planes = subject.planes().iter().map(|&plane| distances(&subject, plane));
            let mut expected = clipped_corners(subject.entering(), planes);
            let whole = outcome.corners.len() == 3
                && outcome.corners.iter().all(|c| matches!(c.corner.origin, Origin::Vertex(_)));
            if !whole {
                expected.dedup();
                if expected.len() < 3 {
                    expected.clear();
                }
                cut[space as usize] += u32::from(!expected.is_empty());
            }
            assert_eq!(sorted(&outcome.corners), expected, "{subject:?}");
            if space == Space::Clip {
                fulfils(&subject, &outcome);
            }
        }
    }
    assert!(cut.iter().all(|&cut| cut > 1_000), "{cut:?} were cut");
}

/// The inequalities hold exactly in the output.
#[track_caller]
fn fulfils(subject: &Subject, outcome: &Outcome) {
    let guard = f64::from(subject.settings.planes.guard());
    for there in &outcome.corners {
        let [x, y, z, w] = there.corner.position.map(f64::from);
        let low = if subject.range == DepthRange::ZeroToOne { 0.0 } else { -w };
        let inside = |plane: &Plane| match plane {
            Plane::Left => -guard * w <= x,
            Plane::Right => x <= guard * w,
            Plane::Bottom => -guard * w <= y,
            Plane::Top => y <= guard * w,
            Plane::Near => low <= z,
            Plane::Far => z <= w,
        };
        assert!(subject.planes().iter().all(inside), "{there:?} of {subject:?}");
    }
}

#[test]
fn the_fan_covers_the_polygon_with_triangles_that_turn_like_it() {
    let mut random = Random::new(9);
    let mut large = 0;
    for _ in 0..3_000 {
        let settings = Settings { pieces: Pieces::Triangles, ..Settings::default() };
        let subject = Subject { settings, ..subject(&mut random) };
        let Outcome { corners, triangles } = ct::run(&subject);
        assert_eq!(triangles.len(), corners.len().saturating_sub(2));
        for [a, b, c] in triangles {
            let after = |i: u8, j: u8| (usize::from(j) + corners.len() - usize::from(i)) % corners.len();
            assert!(0 < after(a, b) && after(a, b) < after(a, c), "{a} {b} {c}");
        }
        large += u32::from(corners.len() > 4);
    }
    assert!(large > 100, "{large} polygons had more than four corners");
}

fn with(mistake: Mistake, arithmetic: Arithmetic) -> Settings {
    Settings { mistake, arithmetic, ..Settings::default() }
}

#[test]
fn dividing_first_is_wrong_only_with_a_vertex_at_the_eye_or_behind_it() {
    let mut random = Random::new(10);
    let (mut wrong, mut right) = (0, 0);
    for _ in 0..6_000 {
        let subject =
            Subject { settings: with(Mistake::DivideFirst, Arithmetic::Exact), ..subject(&mut random) };
        let divided: Vec<_> = ct::run(&subject.corrected())
            .corners
            .iter()
            .map(|there| divide(there.corner.position).map(|c| c + 0.0))
            .collect();
        let found: Vec<_> = ct::run(&subject).corners.iter().map(|there| there.corner.position).collect();
        let near = |[a, b]: [[f32; 4]; 2]| (0..3).all(|axis| (a[axis] - b[axis]).abs() <= 1e-3);
        let same = divided.len() == found.len() && divided.iter().zip(&found).all(|(&a, &b)| near([a, b]));
        let clip = subject.in_clip_space();
        // Rounding alone may merge corners, or tell them apart.
        right += u32::from(clip.iter().all(|v| v[3] > 0.2) && same);
        wrong += u32::from(clip.iter().any(|v| v[3] <= 0.0) && !same);
    }
    assert!(wrong > 1_000, "{wrong} wrong with a vertex behind");
    assert!(right > 1_000, "{right} right with all in front");
}

#[test]
fn without_the_near_plane_depths_leave_their_range() {
    let mut random = Random::new(11);
    let mut outside = 0;
    for _ in 0..3_000 {
        let subject =
            Subject { settings: with(Mistake::NoNearPlane, Arithmetic::Exact), ..subject(&mut random) };
        let left = ct::run(&subject).corners;
        let low = |w: f32| if subject.range == DepthRange::ZeroToOne { 0.0 } else { -w };
        outside += u32::from(left.iter().any(|c| c.corner.position[2] < low(c.corner.position[3])));
        assert!(
            ct::run(&subject.corrected())
                .corners
                .iter()
                .all(|there| { low(there.corner.position[3]) <= there.corner.position[2] })
        );
    }
    assert!(outside > 300, "{outside}");
}

#[test]
fn without_attributes_only_new_corners_are_wrong() {
    let mut random = Random::new(12);
    let mut wrong = 0;
    for _ in 0..3_000 {
        let subject =
            Subject { settings: with(Mistake::NoAttributes, Arithmetic::Exact), ..subject(&mut random) };
        let (found, right) = (ct::run(&subject), ct::run(&subject.corrected()));
        assert_eq!(found.corners.len(), right.corners.len());
        for (found, right) in found.corners.iter().zip(&right.corners) {
            assert_eq!(found.corner, right.corner);
            let new = !matches!(found.corner.origin, Origin::Vertex(_));
            assert_eq!(found.attribute, if new { 0.0 } else { right.attribute });
            wrong += u32::from(found.attribute != right.attribute);
        }
    }
    assert!(wrong > 1_000, "{wrong}");
}

/// The new corners on the edge that both triangles share, of a triangle and of its neighbour.
fn shared_edge(subject: &Subject) -> [Vec<[u32; 4]>; 2] {
    let [a, b, c] = subject.vertices;
    let neighbour = Subject { vertices: [b, a, [-c[0], -c[1], c[2]]], ..*subject };
    [*subject, neighbour].map(|subject| {
        let outcome = ct::run(&subject);
        let on_edge = |there: &&TaughtCorner| matches!(there.corner.origin, Origin::Edge { edge: 2, .. });
        let mut all: Vec<_> =
            outcome.corners.iter().filter(on_edge).map(|c| c.corner.position.map(f32::to_bits)).collect();
        all.sort_unstable();
        all
    })
}

#[test]
fn only_the_walk_order_in_rounded_arithmetic_opens_cracks() {
    let mut random = Random::new(13);
    let mut cracks = [[0; 3]; 2];
    let mut met = 0;
    for _ in 0..4_000 {
        let given = subject(&mut random);
        for (mistake, counts) in [Mistake::None, Mistake::WalkOrder].into_iter().zip(&mut cracks) {
            for (arithmetic, count) in ARITHMETICS.into_iter().zip(counts) {
                // One plane alone: what is cut twice is another story.
                let settings = Settings { planes: PlaneSet::Near, ..with(mistake, arithmetic) };
                let [ours, theirs] = shared_edge(&Subject { settings, ..given });
                if ours.len() == 1 && theirs.len() == 1 {
                    *count += u32::from(ours != theirs);
                    met += 1;
                }
            }
        }
    }
    let [inside_first, [walk_exact, walk_f32, walk_f64]] = cracks;
    assert!(met > 3_000, "{met} edges were cut in both");
    assert_eq!((inside_first, walk_exact), ([0; 3], 0));
    assert!(walk_f32 > 100, "{walk_f32} cracks in f32, {walk_f64} in f64");
}

#[test]
fn rounded_arithmetic_misses_the_exact_corners() {
    let mut random = Random::new(14);
    let mut wrong = [0; 2];
    for _ in 0..4_000 {
        let given = subject(&mut random);
        let right = sorted(&ct::run(&given).corners);
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            let subject = Subject { settings: with(Mistake::None, arithmetic), ..given };
            *count += u32::from(sorted(&ct::run(&subject).corners) != right);
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[0] > 500, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}
