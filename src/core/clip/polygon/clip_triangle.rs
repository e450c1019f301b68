//! Clipping a triangle, step by step: the pipeline's own lines, in the space one chooses, with the
//! mistakes that one meets.
//!
//! In clip space, in exact arithmetic and without a mistake this is what the pipeline does to every
//! triangle, line by line: both are [`clip_exact`].
//!
//! *Source:* Sutherland and Hodgman 1974; Blinn and Newell 1978; the spaces and the intersection as in
//! Foley et al., Computer Graphics: Principles and Practice, 2nd ed., sections 3.14 and 6.5.

mod explain;
mod formulas;
mod picture;
mod sentences;
mod snapshot;
mod tables;

pub use snapshot::Snapshot;

use super::{
    Plane, PlaneSet,
    clip_space::{
        self, CameraSpace, ClipSpace, Corner, Order, Origin, Region, TaughtCorner, clip_exact, clip_taught,
        fan,
    },
};
use crate::{
    math::{Arithmetic, Tally},
    replay::{Budget, Player},
    trace::{Lift, NoTrace, Tracer},
    transform::{Camera, DepthRange, Matrix, divide, matrices},
};
use serde::{Deserialize, Serialize};

/// Where the triangle is clipped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Space {
    /// In four coordinates, before the divide.
    #[default]
    Clip,
    /// In camera space: the eye at the origin, looking along -z; distances `(v - p) · n`.
    Camera,
}

impl Space {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Clip, Self::Camera];
}

/// What is done wrong on purpose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mistake {
    /// Nothing.
    #[default]
    None,
    /// Divided by w before clipping: wrong for every vertex with `w <= 0`.
    DivideFirst,
    /// The near plane is left out: what lies between it and the eye stays.
    NoNearPlane,
    /// New corners have no attributes: they get 0.
    NoAttributes,
    /// The intersection is computed from the end that the walk comes to first, so that the neighbour
    /// computes it from the other one. In rounded arithmetic they do not meet.
    WalkOrder,
}

impl Mistake {
    /// None, and then each.
    pub const ALL: [Self; 5] =
        [Self::None, Self::DivideFirst, Self::NoNearPlane, Self::NoAttributes, Self::WalkOrder];
}

/// What the result is made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Pieces {
    /// One convex polygon.
    #[default]
    Polygon,
    /// A fan of triangles.
    Triangles,
}

impl Pieces {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Polygon, Self::Triangles];
}

/// How a triangle is clipped.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Settings {
    /// Where.
    pub space: Space,
    /// Against which planes.
    pub planes: PlaneSet,
    /// What the result is made of.
    pub pieces: Pieces,
    /// What is done wrong.
    pub mistake: Mistake,
    /// In which arithmetic; fixed point is the exact form.
    pub arithmetic: Arithmetic,
}

/// A triangle before a camera, and how it is clipped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject {
    /// In camera space: the eye at the origin, looking along -z, y up. Finite.
    pub vertices: [[f32; 3]; 3],
    /// One number at each vertex, such as a texture coordinate.
    pub attribute: [f32; 3],
    /// Only its planes and its projection count.
    pub camera: Camera,
    /// Camera to clip space.
    pub projection: Matrix,
    /// Which depths are visible.
    pub range: DepthRange,
    /// How it is clipped.
    pub settings: Settings,
}

impl Subject {
    /// A triangle before that camera, whose image is `aspect` times as wide as high.
    pub fn new(
        (vertices, attribute): ([[f32; 3]; 3], [f32; 3]),
        (camera, aspect): (Camera, f64),
        range: DepthRange,
        settings: Settings,
    ) -> Self {
        let projection = matrices::projection(&camera, aspect, range, false);
        Self { vertices, attribute, camera, projection, range, settings }
    }

    /// The vertices in clip space, each coordinate rounded once.
    pub fn in_clip_space(&self) -> [[f32; 4]; 3] {
        self.vertices.map(|[x, y, z]| matrices::apply(&self.projection, [x, y, z, 1.0]))
    }

    /// The vertices where they are clipped; before the divide if that comes first.
    pub fn entering(&self) -> [[f32; 4]; 3] {
        if self.space() == Space::Camera {
            self.vertices.map(|[x, y, z]| [x, y, z, 1.0])
        } else {
            self.in_clip_space()
        }
    }

    /// Where the triangle is clipped; what is divided first was in clip space.
    pub(super) fn space(&self) -> Space {
        if self.divides_first() { Space::Clip } else { self.settings.space }
    }

    pub(super) fn divides_first(&self) -> bool {
        self.settings.mistake == Mistake::DivideFirst
    }

    pub(super) fn camera_space(&self) -> CameraSpace {
        CameraSpace::new(&self.camera, &self.projection, self.settings.planes.guard())
    }

    pub(super) fn clip_space(&self) -> ClipSpace {
        ClipSpace { range: self.range, guard: self.settings.planes.guard() }
    }

    /// The planes that clip, in order.
    pub fn planes(&self) -> &'static [Plane] {
        const NOT_NEAR: [Plane; 5] = [Plane::Left, Plane::Right, Plane::Bottom, Plane::Top, Plane::Far];
        match (self.settings.mistake, self.settings.planes) {
            (Mistake::NoNearPlane, PlaneSet::Near) => &[],
            (Mistake::NoNearPlane, _) => &NOT_NEAR,
            (_, planes) => planes.planes(),
        }
    }

    /// The same triangle, clipped right: in clip space, exactly, without the mistake.
    #[must_use]
    pub fn corrected(&self) -> Self {
        let space = self.settings.space;
        let settings =
            Settings { space, mistake: Mistake::None, arithmetic: Arithmetic::Exact, ..self.settings };
        Self { settings, ..*self }
    }
}

/// What the algorithm did. It holds the events of [`clip_space`], and is as long as those.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// A vertex was divided by its w, which is a mistake here.
    Divide {
        /// Which.
        vertex: u8,
        /// x / w, y / w, z / w, and 1.
        at: [f32; 4],
    },
    /// A vertex is not finite after the division: nothing can be clipped.
    Lost {
        /// Which.
        vertex: u8,
    },
    /// A step of clipping in that space.
    Clip(Space, clip_space::Event),
    /// The attribute at a corner of the result is known.
    Attribute {
        /// The corner's number, from 0.
        corner: u8,
        /// The attribute.
        value: f32,
    },
    /// A triangle of the fan.
    Triangle {
        /// Its corners.
        corners: [u8; 3],
    },
    /// The end.
    Done {
        /// How many corners are left.
        corners: u8,
    },
}

/// What is left of a triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// A convex polygon in the space of clipping, with the attribute at each corner.
    pub corners: Vec<TaughtCorner>,
    /// The fan, if it was asked for.
    pub triangles: Vec<[u8; 3]>,
}

/// Clips a triangle. Total: what is not finite after a mistaken division leaves nothing.
pub fn run(subject: &Subject) -> Outcome {
    run_traced(subject, &mut Tally::default(), &mut NoTrace)
}

/// [`run`] as a run that can be scrubbed.
pub fn play(subject: Subject, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(subject), budget, move |t| {
        run_traced(&subject, &mut Tally::default(), t);
    })
}

/// The algorithm: [`run`] and [`play`] are this with two tracers.
pub fn run_traced<T: Tracer<Event>>(subject: &Subject, tally: &mut Tally, t: &mut T) -> Outcome {
    let mut vertices = subject.entering();
    if subject.divides_first() {
        for (vertex, at) in (0..).zip(&mut vertices) {
            let [x, y, z, _] = divide(*at);
            *at = [x, y, z, 1.0];
            t.emit(|| Event::Divide { vertex, at: *at });
        }
        let broken = vertices.iter().position(|v| v.iter().any(|c| !c.is_finite()));
        if let Some(vertex) = broken {
            t.emit(|| Event::Lost { vertex: vertex as u8 });
            t.emit(|| Event::Done { corners: 0 });
            return Outcome::default();
        }
    }
    let mut corners = match subject.space() {
        Space::Camera => clip(subject, vertices, subject.camera_space(), tally, t),
        Space::Clip => clip(subject, vertices, subject.clip_space(), tally, t),
    };
    for (corner, there) in (0..).zip(&mut corners) {
        let new = !matches!(there.corner.origin, Origin::Vertex(_));
        if new && subject.settings.mistake == Mistake::NoAttributes {
            there.attribute = 0.0;
        }
        t.emit(|| Event::Attribute { corner, value: there.attribute });
    }
    let mut triangles = Vec::new();
    if subject.settings.pieces == Pieces::Triangles {
        let positions: Vec<Corner> = corners.iter().map(|there| there.corner).collect();
        for corners in fan(&positions) {
            let corners = corners.map(|corner| corner as u8);
            t.emit(|| Event::Triangle { corners });
            triangles.push(corners);
        }
    }
    t.emit(|| Event::Done { corners: corners.len() as u8 });
    Outcome { corners, triangles }
}

fn clip<R: Region, T: Tracer<Event>>(
    subject: &Subject,
    vertices: [[f32; 4]; 3],
    region: R,
    tally: &mut Tally,
    t: &mut T,
) -> Vec<TaughtCorner> {
    let planes = subject.planes();
    let order = match subject.settings.mistake {
        Mistake::WalkOrder => Order::Walk,
        _ => Order::InsideFirst,
    };
    let space = subject.space();
    let t = &mut Lift(t, |event| Event::Clip(space, event));
    let given = (vertices, subject.attribute);
    match subject.settings.arithmetic {
        Arithmetic::F32 => clip_taught::<f32, _, _>(given, region, planes, order, t),
        Arithmetic::F64 => clip_taught::<f64, _, _>(given, region, planes, order, t),
        _ => {
            let polygon = clip_exact(vertices, region, planes, tally, t);
            let attribute = |corner: &Corner| TaughtCorner {
                corner: *corner,
                attribute: polygon.attribute(corner, subject.attribute, &mut Tally::default()),
            };
            polygon.corners().iter().map(attribute).collect()
        }
    }
}
