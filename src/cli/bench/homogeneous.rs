//! Clipping in clip space: exact, and as taught in two arithmetics.

use rasterscope_core::{
    clip::polygon::{
        PlaneSet,
        clip_space::{ClipSpace, Order, clip_taught},
        clip_triangle,
    },
    math::{Arithmetic, Real},
    trace::NoTrace,
    transform::DepthRange,
};

use super::{
    family::Family,
    race::{Answer, Contender, Errors, Heat, Row},
    random::Random,
};

pub(super) const STAGE: &str = "homogeneous-clipping";
pub(super) const FAMILIES: &[Family] =
    &[Family::Ordinary, Family::Beside, Family::NearWZero, Family::Sliver, Family::Huge, Family::Denormal];

const COUNT: usize = 1_024;
const RANGE: DepthRange = DepthRange::ZeroToOne;

type Vertex = [f32; 4];

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

fn triangles(family: Family) -> Vec<[Vertex; 3]> {
    let mut random = Random::new(200 + family as u64);
    (0..COUNT).map(|_| triangle(family, &mut random)).collect()
}

fn triangle(family: Family, random: &mut Random) -> [Vertex; 3] {
    let mut vertices: [Vertex; 3] = std::array::from_fn(|_| {
        let w = random.uniform(0.5, 3.0);
        let reach = 2.0 * f64::from(w);
        let [x, y, z] = std::array::from_fn(|_| random.uniform(-reach, reach));
        [x, y, z, w]
    });
    for vertex in &mut vertices {
        let w = vertex[3];
        match family {
            Family::Beside => {
                let axis = random.below(3);
                let border = random.pick(&[w, -w]);
                vertex[axis] = random.beside(border);
            }
            Family::NearWZero => vertex[3] = random.magnitude(-8.0, 0.0),
            Family::Huge => *vertex = vertex.map(|x| x * random.magnitude(20.0, 37.0).abs()),
            Family::Denormal => *vertex = vertex.map(|x| x * 1e-39),
            _ => {}
        }
    }
    if family == Family::Sliver {
        let [a, b, _] = vertices;
        let t = random.uniform(0.2, 0.8);
        vertices[2] = std::array::from_fn(|i| random.beside(a[i] + t * (b[i] - a[i])));
    }
    vertices
}

pub(super) fn run(family: Family, rounds: u32) -> Vec<Row> {
    let triangles = &triangles(family);
    let contenders = vec![
        Contender::text("clip-triangle", Arithmetic::Exact, triangles, |vertices, tally| {
            let left = clip_triangle(*vertices, RANGE, PlaneSet::All, tally);
            Corners(left.corners().iter().map(|corner| corner.position).collect())
        }),
        Contender::text("clip-triangle", Arithmetic::F32, triangles, |vertices, _| taught::<f32>(*vertices)),
        Contender::text("clip-triangle", Arithmetic::F64, triangles, |vertices, _| taught::<f64>(*vertices)),
    ];
    let exact = triangles.iter().map(|vertices| turned(*vertices)).collect();
    Heat { stage: STAGE, family, items: COUNT, item: "triangle", contenders, exact }.run(rounds)
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
