//! A row by the plane equation: laws, golden logs, an exact oracle, and the sibling by area ratios.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text, plane_value, triangle};
use rasterscope_core::{
    depth::DepthPlane,
    interpolate::{
        Mode, Subject, interpolate,
        plane_equation::{self as pe, Event, Pixels, Snapshot},
    },
    math::{Arithmetic, Dyadic, Tally, ulps_between},
    raster::{Algorithm, Settings, rows},
};

const SUBJECT: Subject = Subject {
    vertices: [[0.5, 7.5, 2.0], [11.5, 6.5, 6.0], [4.0, 0.5, 3.0]],
    attribute: [0.0, 1.0, 0.5],
    at: [5.5, 4.5],
};

fn run(mode: Mode, subject: &Subject, arithmetic: Arithmetic, settings: &Settings) -> (Pixels, Vec<Event>) {
    let mut events = Vec::new();
    let pixels = pe::fill_row_traced(mode, subject, arithmetic, settings, &mut Tally::default(), &mut events);
    (pixels, events)
}

#[track_caller]
fn check(name: &str, mode: Mode, subject: &Subject, arithmetic: Arithmetic) {
    let (_, events) = run(mode, subject, arithmetic, &Settings::new([12, 9]));
    check_golden(&format!("plane_equation/{name}"), &log_text(&events));
}

#[test]
fn a_plane_takes_one_addition_a_pixel() {
    check("affine", Mode::Affine, &SUBJECT, Arithmetic::Exact);
}

#[test]
fn perspective_takes_two_planes_and_a_division() {
    check("perspective", Mode::Perspective, &SUBJECT, Arithmetic::Exact);
}

#[test]
fn additions_in_f32_go_astray() {
    check("f32", Mode::Perspective, &SUBJECT, Arithmetic::F32);
}

#[test]
fn a_row_between_centres_is_empty() {
    let vertices = [[1.0, 4.0, 1.0], [11.0, 4.25, 1.0], [6.0, 4.375, 1.0]];
    check("empty", Mode::Affine, &Subject { vertices, at: [6.0, 4.25], ..SUBJECT }, Arithmetic::Exact);
}

fn subject(random: &mut Random) -> Subject {
    let points = triangle(random);
    let w = match random.below(3) {
        0 => [1.0; 3],
        1 => [0; 3].map(|_| random.uniform(0.5, 9.0)),
        _ => [0; 3].map(|_| random.pick(&[1.0, 2.0, 0.0, -0.5])),
    };
    let vertices = [0, 1, 2].map(|i| [points[i][0], points[i][1], w[i]]);
    let attribute = [0; 3].map(|_| random.uniform(0.0, 1.0));
    Subject { vertices, attribute, at: [4.5, random.below(7) as f32 + 0.5] }
}

const SETTINGS: [u32; 2] = [9, 7];

#[test]
fn the_row_is_the_rasterizers_and_each_value_the_oracles() {
    let mut random = Random::new(71);
    let settings = Settings::new(SETTINGS);
    let (mut seen, mut tally) = (0, Tally::default());
    for _ in 0..6_000 {
        let subject = subject(&mut random);
        let points = subject.vertices.map(|[x, y, _]| [x, y]);
        let y = subject.at[1] as u32;
        let pixels = pe::fill_row(Mode::Affine, &subject, Arithmetic::Exact, &settings);
        let spans = rows(Algorithm::Aabb, points, &settings, &mut tally);
        let columns = spans.iter().find(|span| span.y == y).map_or(0..0, |span| span.begin..span.end);
        assert!(pixels.iter().map(|(x, _)| *x).eq(columns), "{subject:?}");
        let z = subject.attribute;
        let with_z = [0, 1, 2].map(|i| [points[i][0], points[i][1], z[i]]);
        let depth = DepthPlane::new(with_z, Arithmetic::Exact, &mut tally);
        for (x, value) in pixels {
            seen += 1;
            let (above, below) = plane_value(&with_z, [x, y]);
            assert_eq!(value, Dyadic::ratio_to_f32(&above, &below), "{subject:?} {x}");
            assert_eq!(value, depth.depth([x, y], &mut tally), "{subject:?} {x}");
        }
        let pixels = pe::fill_row(Mode::Perspective, &subject, Arithmetic::Exact, &settings);
        for (x, value) in pixels {
            let at = [x as f32 + 0.5, y as f32 + 0.5];
            let ratios =
                interpolate(Mode::Perspective, subject.vertices, z, at, Arithmetic::Exact, &mut tally);
            assert_eq!(value, ratios.unwrap_or(f32::INFINITY), "{subject:?} {x}");
        }
    }
    assert!(seen > 3_000, "{seen}");
}

#[test]
fn the_error_of_accumulated_slopes_grows_along_the_row() {
    let subject = Subject {
        vertices: [[0.2, 0.3, 1.0], [61.7, 2.4, 1.0], [3.1, 7.9, 1.0]],
        attribute: [0.1, 0.9, 0.3],
        at: [30.5, 2.5],
    };
    let settings = Settings::new([64, 9]);
    let row = |arithmetic| pe::fill_row(Mode::Affine, &subject, arithmetic, &settings);
    let exact = row(Arithmetic::Exact);
    let errors = |arithmetic| -> Vec<u64> {
        row(arithmetic).iter().zip(&exact).map(|(a, b)| ulps_between(a.1, b.1)).collect()
    };
    let [f32s, f64s] = [Arithmetic::F32, Arithmetic::F64].map(errors);
    assert!(f32s.len() > 40);
    let (first, last) = f32s.split_at(f32s.len() / 2);
    assert!(last.iter().sum::<u64>() > 2 * first.iter().sum::<u64>().max(1), "{f32s:?}");
    assert!(f64s.iter().all(|&error| error == 0), "{f64s:?}");
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    let mut random = Random::new(72);
    let mut coverage = Coverage::default();
    let settings = Settings::new(SETTINGS);
    for _ in 0..150 {
        let subject = subject(&mut random);
        for arithmetic in Arithmetic::ALL {
            for mode in Mode::ALL {
                let (traced, events) = run(mode, &subject, arithmetic, &settings);
                if log_text(&events).contains("NaN") {
                    continue; // taught arithmetic on huge numbers, and no NaN equals itself
                }
                check_laws(
                    (&pe::fill_row(mode, &subject, arithmetic, &settings), &traced),
                    &events,
                    |budget| pe::play(mode, subject, arithmetic, settings, budget),
                    Snapshot::result,
                    &mut coverage,
                );
            }
        }
    }
    coverage.check_every_line::<Snapshot>();
}
