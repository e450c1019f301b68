//! The depth of a triangle's pixels in every format, and the value of an attribute.

use super::{Operation, coverage, path, same};
use crate::{
    case::{Case, Reader, fresh, points},
    integers::{code as rounded_code, integer, nearest},
    random::Random,
};
use num_bigint::BigInt;
use num_traits::Zero;
use rasterscope_core::{
    depth::{DepthFormat, DepthPlane},
    math::{Arithmetic, Tally},
    raster::{Algorithm, Settings, rows},
};

pub(super) const OPERATION: Operation =
    Operation { name: "depth", cases: 60_000, fresh: triangle, check, code };

/// The six coordinates and two choices of `coverage`, then three depths and the format.
fn triangle(random: &mut Random) -> Case {
    let mut case = fresh(random, 12);
    for place in 0..6 {
        if random.below(2) == 0 {
            case[place] = random.grid(-2, 11).to_bits();
        }
    }
    for place in 8..11 {
        case[place] = match random.below(4) {
            0 => random.uniform(0.0, 1.0),
            1 => random.near(0.5),
            2 => random.below(65536) as f32 / 65535.0,
            _ => f32::from_bits(case[place]),
        }
        .to_bits();
    }
    case
}

fn read(words: &[u32]) -> ([[f32; 3]; 3], Settings, DepthFormat) {
    let (points, settings) = coverage::read(words);
    let mut reader = Reader(words.get(8..).unwrap_or_default());
    // A depth lies in 0..=1 when it comes to the buffer.
    let depths =
        reader.numbers::<3>().map(|z| if (0.0..=1.0).contains(&z) { z } else { z.abs().recip().min(1.0) });
    let format = reader.choice(&DepthFormat::ALL);
    ([0, 1, 2].map(|i| [points[i][0], points[i][1], depths[i]]), settings, format)
}

fn code(words: &[u32]) -> String {
    let (triangle, settings, format) = read(words);
    format!(
        "let (triangle, settings, format) = ({}, {settings:?}, DepthFormat::{format:?});",
        points(&triangle)
    )
}

fn check(words: &[u32]) -> Result<u64, String> {
    let (triangle, settings, format) = read(words);
    let flat = triangle.map(|[x, y, _]| [x, y]);
    let exact = triangle.map(|v| v.map(integer));
    let [a, b, c] = exact.each_ref().map(|[x, y, _]| [x, y]);
    let area = |a: [&BigInt; 2], b: [&BigInt; 2], p: [&BigInt; 2]| {
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let mut tally = Tally::default();
    let plane = DepthPlane::new(triangle, Arithmetic::Exact, &mut tally);
    let mut pixels = 0;
    for span in rows(Algorithm::Aabb, flat, &settings, &mut Tally::default()) {
        for x in span.begin..span.end {
            let pixel = [x, span.y];
            let [px, py] = pixel.map(|n| integer(n as f32 + 0.5));
            let p = [&px, &py];
            let weights = [area(b, c, p), area(c, a, p), area(a, b, p)];
            let sum = &weights[0] + &weights[1] + &weights[2];
            let value: BigInt =
                weights.iter().zip(&exact).fold(BigInt::zero(), |sum, (weight, v)| sum + weight * &v[2]);
            let expected = nearest(&value, &sum);
            same(&format!("depth at {pixel:?}"), &plane.depth(pixel, &mut tally), &expected)?;
            let expected = match format.max_code() {
                Some(max) => rounded_code(&value, &(sum * integer(1.0)), max),
                None => expected.to_bits(),
            };
            same(&format!("code at {pixel:?}"), &plane.code(pixel, format, &mut tally), &expected)?;
            pixels += 1;
        }
    }
    Ok(path((pixels, tally.exact.min(64), format as u32, settings.fill_rule as u32)))
}
