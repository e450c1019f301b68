//! Several samples a pixel: laws, golden logs, masks against an exact oracle, meshes without seams.

use crate::support::{Coverage, Oracle, Random, areas, check_golden, check_laws, log_text, triangle};
use rasterscope_core::{
    math::{Arithmetic, Dyadic, Tally},
    raster::{
        Algorithm, FillRule, Samples, Settings, YAxis, cover_samples,
        msaa::{self, Conventions, Event, Image, Shading, Snapshot, Triangle},
        rows,
    },
};

const SIZE: [u32; 2] = [9, 7];

fn conventions(samples: Samples, shading: Shading) -> Conventions {
    Conventions { samples, shading, raster: Settings::new(SIZE) }
}

fn run(triangles: &[Triangle], conventions: &Conventions) -> (Image, Vec<Event>) {
    let mut events = Vec::new();
    let image = msaa::draw_traced(triangles, conventions, &mut Tally::default(), &mut events);
    (image, events)
}

/// The masks of all pixels of the image.
fn masks(vertices: [[f32; 2]; 3], samples: Samples, settings: &Settings) -> Vec<u8> {
    let mut masks = vec![0; (settings.size[0] * settings.size[1]) as usize];
    cover_samples(vertices, samples, settings, &mut Tally::default(), &mut |[x, y], mask| {
        let stored = &mut masks[(y * settings.size[0] + x) as usize];
        assert_eq!(*stored, 0, "a pixel comes once");
        *stored = mask;
    });
    masks
}

#[test]
fn one_pixel_of_each_kind_is_logged() {
    let corner = [[[0.25, 0.25, 0.0], [2.0, 0.5, 1.0], [0.5, 1.75, 0.5]]];
    for (shading, name) in
        [(Shading::Centre, "centre"), (Shading::Centroid, "centroid"), (Shading::PerSample, "per_sample")]
    {
        let raster = Settings::new([2, 2]);
        let (_, events) = run(&corner, &Conventions { samples: Samples::Four, shading, raster });
        check_golden(&format!("msaa/{name}"), &log_text(&events));
    }
}

/// What pixels show, in hundredths of white.
fn picture(image: &Image) -> String {
    let rows = image.codes.chunks(image.size[0] as usize);
    rows.map(|row| row.iter().map(|code| format!("{code:>4}")).collect::<String>() + "\n").collect()
}

#[test]
fn an_edge_becomes_a_ramp_and_a_sliver_a_grey_line() {
    let edge = [[[0.5, 5.75, 1.0], [7.5, 5.75, 1.0], [7.5, 2.25, 1.0]]];
    let sliver = [[[0.25, 3.0, 1.0], [7.75, 2.55, 1.0], [7.75, 3.45, 1.0]]];
    let mut text = String::new();
    for (name, triangles) in [("edge", edge), ("sliver", sliver)] {
        for samples in Samples::ALL {
            let image = msaa::draw(&triangles, &conventions(samples, Shading::Centre));
            text += &format!("{name}, {} samples\n{}", samples.count(), picture(&image));
        }
    }
    check_golden("msaa/pictures", &text);
}

/// The published pattern: no two of eight samples share a row or a column of the grid of sixteenths, and
/// every pattern is centred on the pixel or turned about it.
#[test]
fn the_patterns_are_the_standard_ones() {
    for samples in Samples::ALL {
        let offsets = samples.offsets();
        assert_eq!(offsets.len(), samples.count() as usize);
        for axis in 0..2 {
            let mut values: Vec<_> = offsets.iter().map(|offset| offset[axis]).collect();
            values.sort_unstable();
            values.dedup();
            assert_eq!(values.len(), offsets.len(), "{samples:?}");
            assert!(values.iter().all(|value| (-8..8).contains(value)));
        }
        assert_eq!(Samples::try_from(samples.count()), Ok(samples));
    }
    assert_eq!(Samples::Four.point([3, 2], 1, YAxis::Down), [3.875, 2.375]);
    assert_eq!(Samples::Four.point([3, 2], 1, YAxis::Up), [3.875, 2.625]);
    assert!(Samples::try_from(3).is_err());
}

#[test]
fn one_sample_covers_what_every_rasterizer_covers() {
    let mut random = Random::new(91);
    let mut seen = 0;
    for _ in 0..4_000 {
        let vertices = triangle(&mut random);
        let settings = Settings {
            fill_rule: random.pick(&FillRule::ALL),
            y_axis: random.pick(&YAxis::ALL),
            ..Settings::new(SIZE)
        };
        let mut pixels = vec![0_u8; (SIZE[0] * SIZE[1]) as usize];
        for span in rows(random.pick(&Algorithm::ALL), vertices, &settings, &mut Tally::default()) {
            (span.begin..span.end).for_each(|x| pixels[(span.y * SIZE[0] + x) as usize] = 1);
            seen += span.len();
        }
        assert_eq!(masks(vertices, Samples::One, &settings), pixels, "{vertices:?} {settings:?}");
    }
    assert!(seen > 10_000, "{seen}");
}

#[test]
fn every_bit_of_a_mask_is_the_oracles() {
    let mut random = Random::new(92);
    let mut partial = 0;
    for _ in 0..1_500 {
        let vertices = triangle(&mut random);
        let settings = Settings {
            fill_rule: random.pick(&FillRule::ALL),
            y_axis: random.pick(&YAxis::ALL),
            ..Settings::new(SIZE)
        };
        let samples = random.pick(&Samples::ALL);
        let oracle = Oracle::new(vertices, &settings);
        for (mask, index) in masks(vertices, samples, &settings).into_iter().zip(0..) {
            let pixel = [index % SIZE[0], index / SIZE[0]];
            let expected = (0..samples.count()).filter(|&sample| {
                let point = samples.point(pixel, sample as usize, settings.y_axis);
                oracle.as_ref().is_some_and(|oracle| oracle.covers(point))
            });
            let expected = expected.fold(0, |mask, sample| mask | 1 << sample);
            assert_eq!(mask, expected, "{samples:?} {vertices:?} {pixel:?} {settings:?}");
            partial += u32::from(mask != 0 && mask != samples.full());
        }
    }
    assert!(partial > 1_000, "{partial}");
}

/// A fan around a point, closed by the border of the image: each sample once.
#[test]
fn a_mesh_covers_each_sample_exactly_once() {
    let mut random = Random::new(93);
    let settings = Settings::new(SIZE);
    let rim = [[-1.0, -1.0], [4.5, -1.0], [11.0, -1.0], [11.0, 3.5], [11.0, 9.0], [3.0, 9.0], [-1.0, 9.0]];
    for samples in Samples::ALL {
        for _ in 0..60 {
            // On samples and centres, and anywhere.
            let hub = match random.below(3) {
                0 => [random.below(9) as f32 + 0.5, random.below(7) as f32 + 0.5],
                1 => [random.below(144) as f32 / 16.0, random.below(112) as f32 / 16.0],
                _ => [random.uniform(0.0, 9.0), random.uniform(0.0, 7.0)],
            };
            let mut union = vec![0; (SIZE[0] * SIZE[1]) as usize];
            for i in 0..rim.len() {
                let part = masks([hub, rim[i], rim[(i + 1) % rim.len()]], samples, &settings);
                for (union, mask) in union.iter_mut().zip(part) {
                    assert_eq!(*union & mask, 0, "{samples:?}: twice, hub {hub:?}");
                    *union |= mask;
                }
            }
            assert!(union.iter().all(|mask| *mask == samples.full()), "{samples:?}: a hole, hub {hub:?}");
        }
    }
}

/// Shades are the plane's exact values, extrapolated or not, and the mean is exact.
#[test]
fn shades_and_means_equal_the_oracle() {
    let mut random = Random::new(94);
    let (mut shades, mut outside) = (0, 0);
    for _ in 0..400 {
        let points = triangle(&mut random);
        let triangle = points.map(|[x, y]| [x, y, random.uniform(-0.2, 1.2)]);
        let conventions = conventions(random.pick(&Samples::ALL), random.pick(&Shading::ALL));
        let (image, events) = run(&[triangle], &conventions);
        let mut pixel = [0, 0];
        for event in events {
            match event {
                Event::Pixel { x, y } => pixel = [x, y].map(u32::from),
                Event::Shade { at, code, .. } => {
                    let point = match at {
                        Some(sample) => conventions.samples.point(pixel, sample.into(), YAxis::Down),
                        None => pixel.map(|n| n as f32 + 0.5),
                    };
                    let weights = areas(points, point);
                    let sum = &(&weights[0] + &weights[1]) + &weights[2];
                    outside += u32::from(weights.iter().any(|w| (w.sign() * sum.sign()).is_negative()));
                    let z = triangle.map(|[_, _, z]| Dyadic::from(z));
                    let value = &weights[0] * &z[0] + &weights[1] * &z[1] + &weights[2] * &z[2];
                    let expected = Dyadic::ratio_to_code(&value, &sum, 255);
                    assert_eq!(u32::from(code), expected, "{triangle:?} {point:?}");
                    shades += 1;
                }
                _ => {}
            }
        }
        for (codes, mean) in image.samples.iter().zip(&image.codes) {
            let count = conventions.samples.count();
            let sum: u32 = codes.iter().map(|code| u32::from(*code)).sum();
            assert_eq!(u32::from(*mean), (f64::from(sum) / f64::from(count) + 0.5).floor() as u32);
        }
    }
    assert!(shades > 2_000 && outside > 50, "{shades} {outside}");
}

#[test]
fn a_shade_by_centroid_never_leaves_the_vertices_range() {
    let mut random = Random::new(95);
    let mut clamped = 0;
    for _ in 0..300 {
        let triangle = triangle(&mut random).map(|[x, y]| [x, y, random.pick(&[0.25, 0.75])]);
        for (shading, extrapolates) in
            [(Shading::Centre, true), (Shading::Centroid, false), (Shading::PerSample, false)]
        {
            let image = msaa::draw(&[triangle], &conventions(Samples::Eight, shading));
            let codes = image.samples.iter().zip(&image.masks).flat_map(|(codes, mask)| {
                (0..8).filter(move |sample| mask & 1 << sample != 0).map(|sample| codes[sample])
            });
            let off = codes.filter(|code| !(64..=191).contains(code)).count();
            assert!(extrapolates || off == 0, "{triangle:?} {shading:?}");
            clamped += off;
        }
    }
    assert!(clamped > 100, "{clamped}");
}

#[test]
fn keeps_the_laws_in_every_pattern() {
    let mut random = Random::new(96);
    let mut coverage = Coverage::default();
    for round in 0..24 {
        let shading = Shading::ALL[round % 3];
        let samples = Samples::ALL[round % 4];
        let mut shaded = || triangle(&mut random).map(|[x, y]| [x, y, 0.5]);
        let flat = [[1.0, 1.0, 1.0], [2.0, 2.0, 1.0], [3.0, 3.0, 1.0]];
        let triangles = vec![shaded(), flat, shaded()];
        let arithmetic = if round % 5 == 0 { Arithmetic::Fixed8 } else { Arithmetic::Exact };
        let raster = Settings { arithmetic, ..Settings::new([5, 4]) };
        let conventions = Conventions { samples, shading, raster };
        let (traced, events) = run(&triangles, &conventions);
        check_laws(
            (&msaa::draw(&triangles, &conventions), &traced),
            &events,
            |budget| msaa::play(triangles.clone(), conventions, budget),
            Snapshot::result,
            &mut coverage,
        );
    }
    // A wide triangle, whose inner pixels are full.
    let triangles = vec![[[-9.0, -9.0, 0.0], [30.0, -9.0, 1.0], [-9.0, 30.0, 0.5]]];
    let conventions = conventions(Samples::Two, Shading::Centroid);
    let (traced, events) = run(&triangles, &conventions);
    check_laws(
        (&msaa::draw(&triangles, &conventions), &traced),
        &events,
        |budget| msaa::play(triangles.clone(), conventions, budget),
        Snapshot::result,
        &mut coverage,
    );
    coverage.check_every_line::<Snapshot>();
}
