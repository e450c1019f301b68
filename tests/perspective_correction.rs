//! A checkered parallelogram both ways: laws, golden logs, an exact oracle.

use crate::{
    presets::scene,
    support::{Coverage, Random, check_golden, check_laws, log_text},
};
use rasterscope_core::{
    interpolate::{
        Mode, interpolate,
        perspective_correction::{self as pc, Event, Snapshot, Subject, Texel},
    },
    labs::LabInput,
    math::{Arithmetic, Tally},
    raster::Settings,
};

fn run(mode: Mode, subject: &Subject, settings: &Settings) -> (Vec<Texel>, Vec<Event>) {
    let mut events = Vec::new();
    let texels = pc::draw_traced(mode, subject, settings, &mut Tally::default(), &mut events);
    (texels, events)
}

/// A small one: 4 to 8 pixels wide, twice as far at its head.
const SUBJECT: Subject = Subject {
    corners: [[1.0, 6.0, 0.25, 1.0], [9.0, 6.0, 0.25, 1.0], [7.0, 2.0, 0.5, 0.5], [3.0, 2.0, 0.5, 0.5]],
    squares: 2,
    line: [[5.0, 6.0], [5.0, 2.0]],
};

#[test]
fn both_ways_are_logged() {
    for mode in Mode::ALL {
        let (_, events) = run(mode, &SUBJECT, &Settings::new([10, 8]));
        check_golden(&format!("perspective_correction/{}", mode.name()), &log_text(&events));
    }
}

/// `#` light, `.` dark, as in the window.
fn picture(texels: &[Texel], size: [u32; 2]) -> String {
    let mut rows = vec![vec![' '; size[0] as usize]; size[1] as usize];
    for Texel { pixel: [x, y], light, .. } in texels {
        rows[*y as usize][*x as usize] = if *light { '#' } else { '.' };
    }
    rows.iter().map(|row| row.iter().collect::<String>().trim_end().to_owned() + "\n").collect()
}

#[test]
fn the_presets_look_as_they_should() {
    for name in ["tilt-floor", "tilt-steep"] {
        let scene = scene(name);
        let Some(LabInput::PerspectiveCorrection(input)) = scene.lab.as_ref().map(|lab| &lab.input) else {
            panic!("{name} opens another lab")
        };
        let subject = input.subject(&scene).expect("in front of the eye");
        let both = Mode::ALL.map(|mode| {
            let texels = pc::draw(mode, &subject, &Settings::new(scene.size));
            format!("{}\n{}", mode.name(), picture(&texels, scene.size))
        });
        check_golden(&format!("perspective_correction/{}", name.replace('-', "_")), &both.concat());
    }
}

fn subject(random: &mut Random) -> Subject {
    let corner = |random: &mut Random, x: f32, y: f32| {
        [x + random.uniform(-2.0, 2.0), y + random.uniform(-2.0, 2.0), random.uniform(0.0, 1.0), 0.0]
    };
    let mut corners = [[1.0, 6.0], [8.0, 6.0], [7.0, 1.0], [2.0, 1.0]].map(|[x, y]| corner(random, x, y));
    let equal = random.below(4) == 0;
    for corner in &mut corners {
        corner[3] = if equal { 0.25 } else { random.uniform(0.1, 1.0) };
    }
    let line = [[random.uniform(0.0, 9.0), 6.0], [4.0, random.uniform(0.0, 2.0)]];
    Subject { corners, squares: 1 + random.below(9), line }
}

/// Each pixel's coordinates are those of the value by area ratios, with w for 1/w.
#[test]
fn every_coordinate_is_the_interpolated_one() {
    let mut random = Random::new(81);
    let (mut seen, mut tally) = (0, Tally::default());
    for _ in 0..300 {
        let mut subject = subject(&mut random);
        // Powers of two, whose reciprocals are exact.
        for corner in &mut subject.corners {
            corner[3] = random.pick(&[0.125, 0.25, 0.5, 1.0]);
        }
        for mode in Mode::ALL {
            let (mut vertices, mut uvs, mut row) = ([[0.0; 3]; 3], [[0.0; 3]; 2], 0);
            for event in run(mode, &subject, &Settings::new([10, 8])).1 {
                match event {
                    Event::Triangle { index } => {
                        let corners = [[0, 1, 2], [0, 2, 3]][usize::from(index)];
                        vertices = corners.map(|i| subject.corners[i]).map(|[x, y, _, r]| [x, y, 1.0 / r]);
                        let uv = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
                        uvs = [0, 1].map(|axis| corners.map(|i| uv[i][axis]));
                    }
                    Event::Row { y, .. } => row = y,
                    Event::Pixel { x, u, v, .. } => {
                        let at = [f32::from(x) + 0.5, row as f32 + 0.5];
                        for (value, corners) in [u, v].into_iter().zip(uvs) {
                            let expected =
                                interpolate(mode, vertices, corners, at, Arithmetic::Exact, &mut tally);
                            assert_eq!(Ok(value), expected, "{subject:?} {at:?}");
                        }
                        seen += 1;
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(seen > 3_000, "{seen}");
}

#[test]
fn with_one_w_both_ways_are_the_same() {
    let mut random = Random::new(82);
    for _ in 0..200 {
        let mut subject = subject(&mut random);
        for corner in &mut subject.corners {
            corner[3] = 0.3;
        }
        let [a, b] = Mode::ALL.map(|mode| pc::draw(mode, &subject, &Settings::new([10, 8])));
        assert_eq!(a, b, "{subject:?}");
    }
}

#[test]
fn keeps_the_laws_in_both_modes() {
    let mut random = Random::new(83);
    let mut coverage = Coverage::default();
    let settings = Settings::new([10, 8]);
    for _ in 0..12 {
        let subject = subject(&mut random);
        for mode in Mode::ALL {
            let (traced, events) = run(mode, &subject, &settings);
            check_laws(
                (&pc::draw(mode, &subject, &settings), &traced),
                &events,
                |budget| pc::play(mode, subject, settings, budget),
                Snapshot::result,
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
}
