//! Attributes and depths against quotients of big integers.

use crate::support::{Random, areas, plane_value, triangle};
use rasterscope_core::{
    depth::{DepthFormat, DepthPlane, DepthRows},
    interpolate::{InterpolateError, Interpolator, Mode, interpolate, unorm},
    math::{Arithmetic, Dyadic, Sign, Tally, orient2d},
    raster::{Algorithm, Settings, rows},
};
use rasterscope_figure::words::Words;

fn dot(weights: &[Dyadic; 3], values: [f32; 3]) -> Dyadic {
    let [a, b, c] = values.map(Dyadic::from);
    &weights[0] * &a + &weights[1] * &b + &weights[2] * &c
}

/// `sum(l a / w) / sum(l / w)`, with numerator and denominator times all three w.
fn oracle(
    mode: Mode,
    vertices: [[f32; 3]; 3],
    attribute: [f32; 3],
    at: [f32; 2],
) -> Result<f32, InterpolateError> {
    let mut weights = areas(vertices.map(|[x, y, _]| [x, y]), at);
    let area = &(&weights[0] + &weights[1]) + &weights[2];
    if area.is_zero() {
        return Err(InterpolateError::ZeroArea);
    }
    if weights.iter().any(|weight| (weight.sign() * area.sign()).is_negative()) {
        return Err(InterpolateError::Outside);
    }
    if mode == Mode::Perspective {
        let w = vertices.map(|[_, _, w]| Dyadic::from(w));
        if w.iter().any(Dyadic::is_zero) {
            return Err(InterpolateError::ZeroW);
        }
        weights = [0, 1, 2].map(|i| &weights[i] * &w[(i + 1) % 3] * &w[(i + 2) % 3]);
    }
    let sum = dot(&weights, [1.0; 3]);
    if sum.is_zero() {
        return Err(InterpolateError::Infinite);
    }
    Ok(Dyadic::ratio_to_f32(&dot(&weights, attribute), &sum))
}

/// Three values of one of several families.
fn values(random: &mut Random) -> [f32; 3] {
    let family = random.below(6);
    [0; 3].map(|_| match family {
        0 => random.below(5) as f32 / 4.0,
        1 => random.uniform(0.0, 1.0),
        2 => random.near(0.5),
        3 => random.any(),
        4 => random.uniform(-1.0, 1.0),
        _ => random.below(511) as f32 / 510.0,
    })
}

#[test]
fn interpolate_equals_the_oracle() {
    let mut random = Random::new(41);
    let (mut inside, mut tally) = (0, Tally::default());
    for _ in 0..30_000 {
        let points = triangle(&mut random);
        let w = match random.below(3) {
            0 => [0; 3].map(|_| random.uniform(0.5, 20.0)),
            1 => values(&mut random),
            _ => [0; 3].map(|_| random.pick(&[1.0, -1.0, 2.0, -0.5])),
        };
        let vertices = [0, 1, 2].map(|i| [points[i][0], points[i][1], w[i]]);
        let attribute = values(&mut random);
        let at = match random.below(4) {
            0 => [random.below(9) as f32 + 0.5, random.below(7) as f32 + 0.5],
            1 => random.pick(&points),
            2 => [0, 1].map(|axis| (points[0][axis] + points[1][axis] + points[2][axis]) / 3.0),
            _ => [0, 1].map(|axis| (points[0][axis] + points[1][axis]) / 2.0),
        };
        if !at.iter().all(|value| value.is_finite()) {
            continue;
        }
        let mode = random.pick(&Mode::ALL);
        let expected = oracle(mode, vertices, attribute, at);
        let value = interpolate(mode, vertices, attribute, at, Arithmetic::Exact, &mut tally);
        assert_eq!(value, expected, "{mode:?} {vertices:?} {attribute:?} {at:?}");
        inside += u32::from(value.is_ok());
    }
    assert!((8_000..25_000).contains(&inside), "the families are lopsided: {inside} inside");
    assert!(tally.exact > 100, "the tail is never used: {tally:?}");
}

#[test]
fn vertices_and_constants_come_back_bit_for_bit() {
    let mut random = Random::new(42);
    for _ in 0..2_000 {
        let points = triangle(&mut random);
        if orient2d(points[0], points[1], points[2], &mut Tally::default()) == Sign::Zero {
            continue;
        }
        let vertices = points.map(|[x, y]| [x, y, random.uniform(0.1, 9.0)]);
        let attribute = values(&mut random);
        for (i, point) in points.into_iter().enumerate() {
            for mode in Mode::ALL {
                let get = |attribute| {
                    interpolate(mode, vertices, attribute, point, Arithmetic::Exact, &mut Tally::default())
                };
                assert_eq!(get(attribute).map(f32::to_bits), Ok(attribute[i].to_bits()));
                assert_eq!(get([-0.0; 3]).map(f32::to_bits), Ok((-0.0_f32).to_bits()));
            }
        }
    }
}

#[test]
fn refusals_name_their_reason() {
    let flat = [[0.0, 0.0, 1.0], [1.0, 1.0, 1.0], [2.0, 2.0, 1.0]];
    let get = |vertices, at| {
        interpolate(
            Mode::Perspective,
            vertices,
            [1.0, 2.0, 3.0],
            at,
            Arithmetic::Exact,
            &mut Tally::default(),
        )
    };
    assert_eq!(get(flat, [1.0, 1.0]), Err(InterpolateError::ZeroArea));
    let with_w = |w: [f32; 3]| [[0.0, 0.0, w[0]], [4.0, 0.0, w[1]], [0.0, 4.0, w[2]]];
    assert_eq!(get(with_w([1.0; 3]), [3.0, 3.0]), Err(InterpolateError::Outside));
    assert_eq!(get(with_w([1.0, 0.0, 1.0]), [1.0, 1.0]), Err(InterpolateError::ZeroW));
    assert_eq!(get(with_w([1.0, -1.0, 1.0]), [2.0, 0.0]), Err(InterpolateError::Infinite));
    assert_eq!(get(with_w([1.0, 2.0, 4.0]), [2.0, 2.0]), Ok(7.0 / 3.0));
    for error in [
        InterpolateError::ZeroArea,
        InterpolateError::Outside,
        InterpolateError::ZeroW,
        InterpolateError::Infinite,
    ] {
        assert!(Words::default().try_message(&error.message()).is_ok(), "{error:?} has no words");
    }
}

#[test]
fn taught_forms_are_near_the_exact_value_but_not_equal() {
    let mut random = Random::new(43);
    let mut wrong = [0; 2];
    for _ in 0..2_000 {
        let vertices =
            [0; 3].map(|_| [random.uniform(0.0, 9.0), random.uniform(0.0, 9.0), random.uniform(1.0, 9.0)]);
        let attribute = values(&mut random);
        let get = |arithmetic| {
            interpolate(Mode::Perspective, vertices, attribute, [4.5, 3.5], arithmetic, &mut Tally::default())
        };
        for (wrong, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            *wrong += u32::from(get(arithmetic) != get(Arithmetic::Exact));
        }
    }
    assert!(wrong[0] > 10 * wrong[1].max(1), "{wrong:?}");
}

/// The engine's form: weights once a pixel, then values and codes of many attributes.
#[test]
fn frame_engine_equals_the_oracle() {
    let mut random = Random::new(44);
    for _ in 0..4_000 {
        let points = triangle(&mut random);
        let r = [0; 3].map(|_| random.uniform(0.1, 1.0));
        let vertices = [0, 1, 2].map(|i| [points[i][0], points[i][1], r[i]]);
        let mut tally = Tally::default();
        let Some(interpolator) = Interpolator::new(vertices, &mut tally) else { continue };
        let pixel = [random.below(9), random.below(7)];
        let weights = areas(points, pixel.map(|n| n as f32 + 0.5));
        let turned = (&(&weights[0] + &weights[1]) + &weights[2]).sign();
        // Outside, what lies beyond an edge counts as on it.
        let clamped = [0, 1, 2].map(|i| {
            let weight = &weights[i] * &Dyadic::from(r[i]);
            if (weight.sign() * turned).is_negative() { Dyadic::zero() } else { weight }
        });
        let attribute = values(&mut random);
        let (num, den) = (dot(&clamped, attribute), dot(&clamped, [1.0; 3]));
        let at = interpolator.at(pixel, &mut tally);
        assert_eq!(
            at.value(attribute, &mut tally),
            Dyadic::ratio_to_f32(&num, &den),
            "{vertices:?} {attribute:?}"
        );
        let code = Dyadic::ratio_to_code(&num, &den, 255);
        assert_eq!(u32::from(at.code8(attribute, &mut tally)), code, "{vertices:?} {attribute:?}");
        assert_eq!(interpolator.code8(attribute, pixel, &mut tally), at.code8(attribute, &mut tally));
    }
}

#[test]
fn depth_equals_the_oracle_within_the_vertices_range() {
    let mut random = Random::new(45);
    let (mut checked, mut tally) = (0, Tally::default());
    for _ in 0..30_000 {
        let (points, z) = (triangle(&mut random), values(&mut random));
        let vertices = [0, 1, 2].map(|i| [points[i][0], points[i][1], z[i]]);
        let pixel = [random.below(9), random.below(7)];
        let plane = DepthPlane::new(vertices, Arithmetic::Exact, &mut tally);
        let weights = areas(points, pixel.map(|n| n as f32 + 0.5));
        let area = (&(&weights[0] + &weights[1]) + &weights[2]).sign();
        if area.is_zero() || weights.iter().any(|weight| (weight.sign() * area).is_negative()) {
            continue;
        }
        checked += 1;
        let (num, den) = plane_value(&vertices, pixel);
        let depth = plane.depth(pixel, &mut tally);
        assert_eq!(depth, Dyadic::ratio_to_f32(&num, &den), "{vertices:?} {pixel:?}");
        let [least, greatest] = [z[0].min(z[1]).min(z[2]), z[0].max(z[1]).max(z[2])];
        assert!((least..=greatest).contains(&depth));
        for format in DepthFormat::ALL {
            let expected = match format.max_code() {
                None => depth.to_bits(),
                Some(max) => Dyadic::ratio_to_code(&num, &den, max),
            };
            assert_eq!(plane.code(pixel, format, &mut tally), expected, "{format:?} {vertices:?} {pixel:?}");
        }
    }
    assert!(checked > 3_000, "{checked} of all pixels are inside");
}

/// Of slivers, huge and denormal triangles: each pixel that a rasterizer finds, in the forms that the frame
/// engine uses.
#[test]
fn every_covered_centre_has_the_oracles_depth_and_attribute() {
    let mut random = Random::new(48);
    let (mut seen, mut tally) = (0, Tally::default());
    for _ in 0..2_500 {
        let (points, z, a) = (triangle(&mut random), values(&mut random), values(&mut random));
        let with_z = [0, 1, 2].map(|i| [points[i][0], points[i][1], z[i]]);
        let r = [0; 3].map(|_| random.uniform(0.05, 1.0));
        let with_r = [0, 1, 2].map(|i| [points[i][0], points[i][1], r[i]]);
        let plane = DepthPlane::new(with_z, Arithmetic::Exact, &mut tally);
        let fast = DepthFormat::ALL.map(|format| DepthRows::new(with_z, format, &mut tally));
        let interpolator = Interpolator::new(with_r, &mut tally);
        for span in rows(random.pick(&Algorithm::ALL), points, &Settings::new([9, 7]), &mut tally) {
            for x in span.begin..span.end {
                let pixel = [x, span.y];
                let (num, den) = plane_value(&with_z, pixel);
                for (format, fast) in DepthFormat::ALL.into_iter().zip(&fast) {
                    let code = match format.max_code() {
                        None => Dyadic::ratio_to_f32(&num, &den).to_bits(),
                        Some(max) => Dyadic::ratio_to_code(&num, &den, max),
                    };
                    assert_eq!(
                        plane.code(pixel, format, &mut tally),
                        code,
                        "{format:?} {with_z:?} {pixel:?}"
                    );
                    assert_eq!(fast.row(span.y).code(x, &mut tally), code, "{format:?} {with_z:?} {pixel:?}");
                }
                let weights = areas(points, pixel.map(|n| n as f32 + 0.5));
                let weights = [0, 1, 2].map(|i| &weights[i] * &Dyadic::from(r[i]));
                let (num, den) = (dot(&weights, a), dot(&weights, [1.0; 3]));
                let at = interpolator.as_ref().expect("it covers a pixel").at(pixel, &mut tally);
                assert_eq!(at.value(a, &mut tally), Dyadic::ratio_to_f32(&num, &den), "{with_r:?} {a:?}");
                let code = Dyadic::ratio_to_code(&num, &den, 255);
                assert_eq!(u32::from(at.code8(a, &mut tally)), code, "{with_r:?} {a:?} {pixel:?}");
                seen += 1;
            }
        }
    }
    assert!(seen > 10_000, "{seen}");
}

#[test]
fn unorm_codes_of_f32_are_exact() {
    let mut random = Random::new(46);
    for _ in 0..20_000 {
        let value = match random.below(4) {
            0 => random.any(),
            1 => random.uniform(0.0, 1.0),
            2 => random.below(65536) as f32 / 65535.0,
            _ => random.near(0.5),
        };
        for max in [0xFF, 0xFFFF, 0xFF_FFFF, u32::MAX] {
            let expected = Dyadic::ratio_to_code(&Dyadic::from(value), &Dyadic::one(), max);
            assert_eq!(unorm(value, max), expected, "{value} of {max}");
        }
    }
    assert_eq!([f32::NAN, f32::INFINITY, f32::NEG_INFINITY].map(|value| unorm(value, 255)), [0, 255, 0]);
}

#[test]
fn taught_depth_slopes_stay_within_the_vertices_range() {
    let mut random = Random::new(47);
    let mut wrong = [0; 2];
    for _ in 0..2_000 {
        let vertices =
            [0; 3].map(|_| [random.uniform(0.0, 9.0), random.uniform(0.0, 9.0), random.uniform(0.0, 1.0)]);
        let pixel = [random.below(9), random.below(9)];
        let depth = |arithmetic| {
            DepthPlane::new(vertices, arithmetic, &mut Tally::default()).depth(pixel, &mut Tally::default())
        };
        let [a, b, c] = vertices.map(|[_, _, z]| z);
        for (wrong, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            assert!((a.min(b).min(c)..=a.max(b).max(c)).contains(&depth(arithmetic)));
            *wrong += u32::from(depth(arithmetic) != depth(Arithmetic::Exact));
        }
    }
    assert!(wrong[0] > wrong[1], "{wrong:?}");
}
