//! The depth of a triangle at its pixels: every arithmetic, and row by row.

use rasterscope_core::{
    depth::{DepthFormat, DepthPlane, DepthRows},
    math::{Arithmetic, Tally},
    raster::{Algorithm, Settings, Span, rows},
    stress::{
        Family,
        triangles::{size, with_depths},
    },
};

use super::{
    Row,
    heat::{Answer, Contender, Errors, Heat},
};
use crate::Stopwatch;

pub(super) const STAGE: &str = "depth";
pub(super) use rasterscope_core::stress::triangles::FAMILIES;

const COUNT: usize = 24;

/// The depths of a triangle's pixels, row by row.
pub(super) struct Depths(Vec<f32>);

impl Answer for Depths {
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.values(self.0.iter().zip(&exact.0));
    }
}

/// A triangle with depths, and the pixels that it covers.
struct Covered {
    vertices: [[f32; 3]; 3],
    spans: Vec<Span>,
}

impl Covered {
    /// One depth for each pixel.
    fn depths(&self, depth: impl FnMut([u32; 2]) -> f32) -> Depths {
        let pixels = self.spans.iter().flat_map(|span| (span.begin..span.end).map(|x| [x, span.y]));
        Depths(pixels.map(depth).collect())
    }
}

fn covered(family: Family) -> Vec<Covered> {
    let settings = Settings::new(size(family));
    let covered = |vertices: [[f32; 3]; 3]| {
        let flat = vertices.map(|[x, y, _]| [x, y]);
        Covered { vertices, spans: rows(Algorithm::Scanline, flat, &settings, &mut Tally::default()) }
    };
    with_depths(family, COUNT).into_iter().map(covered).collect()
}

pub(super) fn run(family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let inputs = &covered(family);
    let items = inputs.iter().flat_map(|input| &input.spans).map(|span| span.len() as usize).sum();
    let mut contenders = Vec::new();
    for arithmetic in Arithmetic::ALL {
        contenders.push(Contender::text("plane", arithmetic, inputs, move |input: &Covered, tally| {
            let plane = DepthPlane::new(input.vertices, arithmetic, tally);
            input.depths(|pixel| plane.depth(pixel, tally))
        }));
    }
    contenders.push(Contender::text("rows", Arithmetic::Exact, inputs, by_rows));
    // Turned round: an exact answer does not depend on the winding.
    let exact = |input: &Covered| {
        let [a, b, c] = input.vertices;
        let plane = DepthPlane::new([c, b, a], Arithmetic::Exact, &mut Tally::default());
        input.depths(|pixel| plane.depth(pixel, &mut Tally::default()))
    };
    let exact = inputs.iter().map(exact).collect();
    Heat { stage: STAGE, family, items, item: "pixel", contenders, exact }.run(stopwatch)
}

/// What a frame does.
fn by_rows(input: &Covered, tally: &mut Tally) -> Depths {
    let rows = DepthRows::new(input.vertices, DepthFormat::F32, tally);
    let mut depths = Vec::new();
    for span in &input.spans {
        let row = rows.row(span.y);
        depths.extend((span.begin..span.end).map(|x| f32::from_bits(row.code(x, tally))));
    }
    Depths(depths)
}
