//! Coverage: every algorithm against an edge function in integers at every centre.

use super::{Operation, path, same};
use crate::{
    case::{Case, Reader, fresh, points},
    integers::{integer, sign},
    random::Random,
};
use num_bigint::BigInt;
use rasterscope_core::{
    math::Tally,
    raster::{Algorithm, FillRule, Settings, Span, YAxis, rows},
};

pub(super) const OPERATION: Operation =
    Operation { name: "coverage", cases: 200_000, fresh: triangle, check, code };

/// Small, so that a case costs little; far away coordinates come from the families.
const SIZE: [u32; 2] = [9, 7];

fn triangle(random: &mut Random) -> Case {
    let mut case = fresh(random, 8);
    match random.below(3) {
        0 => {
            for place in 0..6 {
                let centre = random.below(9) as f32 + 0.5;
                case[place] = random.near(centre).to_bits();
            }
        }
        1 => {
            // A sliver: the third vertex on the line through the others, give or take an ULP.
            for axis in 0..2 {
                let [a, b] = [case[axis], case[2 + axis]].map(f32::from_bits);
                case[4 + axis] = random.near(a / 2.0 + b / 2.0).to_bits();
            }
        }
        _ => {}
    }
    case
}

pub(super) fn read(words: &[u32]) -> ([[f32; 2]; 3], Settings) {
    let mut reader = Reader(words);
    let vertices = [0; 3].map(|_| reader.numbers());
    let fill_rule = reader.choice(&FillRule::ALL);
    let y_axis = reader.choice(&[YAxis::Down, YAxis::Up]);
    (vertices, Settings { fill_rule, y_axis, ..Settings::new(SIZE) })
}

fn code(words: &[u32]) -> String {
    let (vertices, settings) = read(words);
    format!("let (vertices, settings) = ({}, {settings:?});", points(&vertices))
}

/// The spans: row by row the centres that are inside. The top-left rule is that of a point moved
/// right by an infinitesimal step and down by its square.
fn covered(vertices: [[f32; 2]; 3], settings: &Settings) -> Vec<Span> {
    let [a, b, c] = vertices.map(|vertex| vertex.map(integer));
    let edges = [[&a, &b], [&b, &c], [&c, &a]].map(|[[ax, ay], [bx, by]]| {
        let (along_x, along_y) = (ay - by, bx - ax);
        let at_origin = -(&along_x * ax + &along_y * ay);
        [along_x, along_y, at_origin]
    });
    let turned = sign(&(&edges[0][0] * &c[0] + &edges[0][1] * &c[1] + &edges[0][2]));
    let down = if settings.y_axis == YAxis::Down { 1 } else { -1 };
    let inside = |x: &BigInt, y: &BigInt| {
        turned != 0
            && edges.iter().all(|[along_x, along_y, at_origin]| {
                let value = sign(&(along_x * x + along_y * y + at_origin)) * turned;
                let (right, below) = (sign(along_x) * turned, sign(along_y) * turned * down);
                match settings.fill_rule {
                    FillRule::TopLeft => [value, right, below].into_iter().find(|&sign| sign != 0) == Some(1),
                    FillRule::RightOfPoint => value > 0 || value == 0 && right >= 0,
                    FillRule::Inclusive => value >= 0,
                    FillRule::Strict => value > 0,
                }
            })
    };
    let [xs, ys] = settings.size.map(|n| (0..n).map(|i| integer(i as f32 + 0.5)).collect::<Vec<_>>());
    let mut spans = Vec::new();
    for (y, row) in (0..).zip(&ys) {
        let drawn: Vec<u32> = (0..).zip(&xs).filter(|(_, x)| inside(x, row)).map(|(x, _)| x).collect();
        if let (Some(&begin), Some(&last)) = (drawn.first(), drawn.last()) {
            assert_eq!(drawn.len() as u32, last + 1 - begin, "a triangle is convex");
            spans.push(Span { y, begin, end: last + 1 });
        }
    }
    spans
}

fn check(words: &[u32]) -> Result<u64, String> {
    let (vertices, settings) = read(words);
    let expected = covered(vertices, &settings);
    let mut tally = Tally::default();
    let [a, b, c] = vertices;
    for algorithm in Algorithm::ALL {
        let found = rows(algorithm, vertices, &settings, &mut tally);
        same(algorithm.name(), &found, &expected)?;
        let found = rows(algorithm, [c, b, a], &settings, &mut tally);
        same(&format!("{} turned round", algorithm.name()), &found, &expected)?;
    }
    let shape: Vec<_> = expected.iter().map(|span| (span.y, span.begin, span.end)).collect();
    Ok(path((shape, tally.exact.min(64))))
}
