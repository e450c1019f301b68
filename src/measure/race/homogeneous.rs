//! Clipping in clip space: exact, and as taught in two arithmetics.

use rasterscope_core::{
    clip::polygon::{
        PlaneSet,
        clip_space::{ClipSpace, Order, clip_taught},
        clip_triangle,
    },
    math::{Arithmetic, Real},
    stress::{
        Family,
        clip_triangles::{Vertex, clip_triangles},
    },
    trace::NoTrace,
    transform::DepthRange,
};

use super::{
    Row,
    heat::{Answer, Contender, Errors, Heat},
};
use crate::Stopwatch;

pub(super) const STAGE: &str = "homogeneous-clipping";
pub(super) use rasterscope_core::stress::clip_triangles::FAMILIES;

const COUNT: usize = 1_024;
const RANGE: DepthRange = DepthRange::ZeroToOne;

/// The corners of what is left.
pub(super) struct Corners(Vec<Vertex>);

impl Answer for Corners {
    /// A corner outside is a wrong decision, and so is another number of corners.
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        let inside = |[x, y, z, w]: &Vertex| -w <= *x && x <= w && -w <= *y && y <= w && 0.0 <= *z && z <= w;
        self.0.iter().for_each(|corner| errors.decision(inside(corner)));
        let as_many = self.0.len() == exact.0.len();
        errors.decision(as_many);
        if as_many {
            errors.values(self.0.as_flattened().iter().zip(exact.0.as_flattened()));
        }
    }
}

pub(super) fn run(family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let triangles = &clip_triangles(family, COUNT);
    let contenders = vec![
        Contender::text("clip-triangle", Arithmetic::Exact, triangles, |vertices, tally| {
            let left = clip_triangle(*vertices, RANGE, PlaneSet::All, tally);
            Corners(left.corners().iter().map(|corner| corner.position).collect())
        }),
        Contender::text("clip-triangle", Arithmetic::F32, triangles, |vertices, _| taught::<f32>(*vertices)),
        Contender::text("clip-triangle", Arithmetic::F64, triangles, |vertices, _| taught::<f64>(*vertices)),
    ];
    let exact = triangles.iter().map(|vertices| turned(*vertices)).collect();
    Heat { stage: STAGE, family, items: COUNT, item: "triangle", contenders, exact }.run(stopwatch)
}

fn taught<R: Real>(vertices: [Vertex; 3]) -> Corners {
    let space = ClipSpace { range: RANGE, guard: PlaneSet::All.guard() };
    let planes = PlaneSet::All.planes();
    let left = clip_taught::<R, _, _>((vertices, [0.0; 3]), space, planes, Order::InsideFirst, &mut NoTrace);
    Corners(left.iter().map(|corner| corner.corner.position).collect())
}

/// The exact answer by way of the triangle that turns the other way: the same corners, and so a check.
fn turned([a, b, c]: [Vertex; 3]) -> Corners {
    let corners = |vertices| -> Vec<Vertex> {
        let left = clip_triangle(vertices, RANGE, PlaneSet::All, &mut Default::default());
        left.corners().iter().map(|corner| corner.position).collect()
    };
    let (right, mut turned) = (corners([a, b, c]), corners([c, b, a]));
    turned.reverse();
    // It starts elsewhere.
    let start = right.first().and_then(|first| turned.iter().position(|corner| corner == first));
    turned.rotate_left(start.unwrap_or(0));
    Corners(turned)
}
