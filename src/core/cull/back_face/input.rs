//! What the six tests are given: one triangle in every space.

use super::{
    super::{
        Facing,
        camera_normal::{self, EYE_AT_ORIGIN, EYE_FAR_ALONG_Z},
        facing, ndc_normal,
        number::Number,
        object_eye::{eye_in_object_space, mirrors},
        plane_equation, screen_area, xyw_determinant,
    },
    Settings,
};
use crate::{
    math::{Arithmetic, Dyadic, Sign, Tally},
    raster::YAxis,
    scene::Scene,
    transform::{
        Matrix, Projection,
        chain::{self, Chain, Space},
    },
};
use serde::Serialize;
use std::sync::Arc;

/// The six tests, in the order of the pipeline; the one that decides is last.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Test {
    /// [`camera_normal`]: the normal against the eye, in camera space.
    Camera,
    /// [`object_eye`](super::super::object_eye): the same in object space, where the eye was taken to.
    Object,
    /// [`plane_equation`]: the eye put into the plane's equation, in world space.
    Plane,
    /// [`ndc_normal`]: the sign of the normal's z in NDC.
    Ndc,
    /// [`screen_area`]: the sign of the area on the screen.
    Screen,
    /// [`xyw_determinant`]: the sign of the determinant with the rows (x, y, w) of clip space.
    Determinant,
}

impl Test {
    /// All of them.
    pub const ALL: [Self; 6] =
        [Self::Camera, Self::Object, Self::Plane, Self::Ndc, Self::Screen, Self::Determinant];

    /// The space that its vertices are in.
    pub fn space(self) -> Space {
        match self {
            Self::Camera => Space::View,
            Self::Object => Space::Object,
            Self::Plane => Space::World,
            Self::Ndc => Space::Ndc,
            Self::Screen => Space::Screen,
            Self::Determinant => Space::Clip,
        }
    }

    /// The id of the words for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Camera => "back-face-test-camera",
            Self::Object => "back-face-test-object",
            Self::Plane => "back-face-test-plane",
            Self::Ndc => "back-face-test-ndc",
            Self::Screen => "back-face-test-screen",
            Self::Determinant => "back-face-test-determinant",
        }
    }
}

/// The triangle where each test takes it from, every coordinate rounded to binary32 as the pipeline does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spaces {
    /// As modelled.
    pub object: [[f32; 3]; 3],
    /// In the scene.
    pub world: [[f32; 3]; 3],
    /// The eye at the origin.
    pub camera: [[f32; 3]; 3],
    /// Before the divide.
    pub clip: [[f32; 4]; 3],
    /// After the divide.
    pub ndc: [[f32; 2]; 3],
    /// In pixels.
    pub screen: [[f32; 2]; 3],
    /// Which way y grows there.
    pub y_axis: YAxis,
    /// The eye in object, world and camera space: a point with w = 1, a direction with w = 0. In object
    /// space it may have no place.
    pub eyes: (Option<[f32; 4]>, [f32; 4], [f32; 4]),
    /// Whether world and camera space have w = 1; else the tests there have no answer.
    pub affine: bool,
    /// Whether the model matrix mirrors.
    pub mirrored: bool,
}

/// What a test computed, rounded to binary64 to be shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// A normal, a plane, products or minors; nothing for [`Test::Ndc`].
    pub terms: Vec<f64>,
    /// What the sign is taken of.
    pub value: f64,
}

impl Numbers {
    fn new<N: Number>(terms: &[N], value: &N) -> Self {
        Self { terms: terms.iter().map(N::to_f64).collect(), value: value.to_f64() }
    }
}

impl Spaces {
    /// Takes a triangle through the chain; `eye` in world space, with w = 1 or as a direction with w = 0.
    pub fn new(object: [[f32; 3]; 3], chain: &Chain, eye: [f32; 4]) -> Self {
        let paths = chain::run(&object, chain);
        let at = |space: Space| [0, 1, 2].map(|i: usize| paths[i][space as usize]);
        let three = |space| at(space).map(|[x, y, z, _]| [x, y, z]);
        let two = |space| at(space).map(|[x, y, _, _]| [x, y]);
        let upright = |space| at(space).iter().all(|point| point[3] == 1.0);
        Self {
            object,
            world: three(Space::World),
            camera: three(Space::View),
            clip: at(Space::Clip),
            ndc: two(Space::Ndc),
            screen: two(Space::Screen),
            y_axis: chain.viewport.y_axis,
            eyes: (
                eye_in_object_space(&chain.model, eye),
                eye,
                if eye[3] == 0.0 { EYE_FAR_ALONG_Z } else { EYE_AT_ORIGIN },
            ),
            affine: upright(Space::World) && upright(Space::View),
            mirrored: mirrors(&chain.model),
        }
    }

    /// The vertices and the eye of the tests that look at a plane of space.
    fn seen(&self, test: Test) -> Option<([[f32; 3]; 3], [f32; 4])> {
        let (object, world, camera) = self.eyes;
        match test {
            Test::Object => object.map(|eye| (self.object, eye)),
            Test::Plane => Some((self.world, world)),
            _ => Some((self.camera, camera)),
        }
        .filter(|_| self.affine)
    }

    /// Whether every vertex has an image.
    fn has_image(&self) -> bool {
        self.clip.iter().all(|vertex| vertex[3] != 0.0)
    }

    fn rows(&self) -> [[f32; 3]; 3] {
        self.clip.map(|[x, y, _, w]| [x, y, w])
    }

    /// The exact sign of a test's value, positive where it sees the front of a counter-clockwise
    /// triangle; `None` if it has no answer.
    pub fn sign(&self, test: Test, tally: &mut Tally) -> Option<Sign> {
        match test {
            Test::Camera | Test::Object => {
                self.seen(test).map(|(vertices, eye)| camera_normal::sign(vertices, eye, tally))
            }
            Test::Plane => self.seen(test).map(|(vertices, eye)| plane_equation::sign(vertices, eye, tally)),
            Test::Ndc => self.has_image().then(|| ndc_normal::sign(self.ndc, tally)),
            Test::Screen => self.has_image().then(|| screen_area::sign(self.screen, self.y_axis, tally)),
            Test::Determinant => Some(xyw_determinant::sign(self.rows(), tally)),
        }
    }

    /// The numbers of a test in an arithmetic; `None` if it has no answer. Exact ones are rounded once.
    pub fn numbers(&self, test: Test, arithmetic: Arithmetic) -> Option<Numbers> {
        match arithmetic {
            Arithmetic::F32 => self.numbers_in::<f32>(test),
            Arithmetic::F64 => self.numbers_in::<f64>(test),
            _ => self.numbers_in::<Dyadic>(test),
        }
    }

    fn numbers_in<N: Number>(&self, test: Test) -> Option<Numbers> {
        match test {
            Test::Camera | Test::Object => self.seen(test).map(|(vertices, eye)| {
                let terms = camera_normal::formula::<N>(vertices, eye);
                Numbers::new(&terms.normal, &terms.value)
            }),
            Test::Plane => self.seen(test).map(|(vertices, eye)| {
                let terms = plane_equation::formula::<N>(vertices, eye);
                Numbers::new(&terms.plane, &terms.value)
            }),
            Test::Ndc => self.has_image().then(|| Numbers::new(&[], &ndc_normal::formula::<N>(self.ndc))),
            Test::Screen => self.has_image().then(|| {
                let terms = screen_area::formula::<N>(self.screen, self.y_axis);
                Numbers::new(&terms.products, &terms.value)
            }),
            Test::Determinant => {
                let terms = xyw_determinant::formula::<N>(self.rows());
                Some(Numbers::new(&terms.minors, &terms.value))
            }
        }
    }

    /// What turns a test's sign against that of the determinant if nothing is rounded: a mirrored model
    /// in object space, an odd number of vertices behind the eye after the divide.
    pub(super) fn turn(&self, test: Test) -> Sign {
        match test {
            Test::Object if self.mirrored => Sign::Negative,
            Test::Ndc | Test::Screen => {
                self.clip.iter().fold(Sign::Positive, |sign, vertex| sign * Sign::of(vertex[3].into()))
            }
            _ => Sign::Positive,
        }
    }
}

/// One triangle with its conventions.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// The triangle in every space.
    pub spaces: Spaces,
    /// What leads it there.
    pub chain: Chain,
    /// The conventions.
    pub settings: Settings,
    /// Which draw it is of, for its fill.
    pub draw: usize,
    /// All triangles of the draw in world space and how they stand to the eye; empty if it stands alone.
    pub object: Arc<[([[f32; 3]; 3], Facing)]>,
}

impl Input {
    /// A triangle of object space.
    pub fn new(object: [[f32; 3]; 3], chain: Chain, eye: [f32; 4], settings: Settings) -> Self {
        Self { spaces: Spaces::new(object, &chain, eye), chain, settings, draw: 0, object: Arc::new([]) }
    }

    /// Triangle `triangle` of draw `draw` of a resolved scene, if there is one; facing and cull mode are
    /// the draw's.
    pub fn of(scene: &Scene, draw: usize, triangle: usize, settings: Settings) -> Option<Self> {
        let of = scene.draws.get(draw)?;
        let mesh = of.geometry.mesh()?;
        let object = mesh.triangles.get(triangle)?.map(|i| mesh.positions[i as usize]);
        let chain = Chain::of(scene, of);
        let settings = Settings { front: of.front, cull: of.cull, ..settings };
        let paths = chain::run(&mesh.positions, &chain);
        let mut tally = Tally::default();
        let facings = mesh.triangles.iter().filter(|_| mesh.positions.len() == paths.len()).map(|triangle| {
            let at = |space: Space| triangle.map(|i| paths[i as usize][space as usize]);
            let facing = facing(at(Space::Clip), of.front, &mut tally);
            (at(Space::World).map(|[x, y, z, _]| [x, y, z]), facing)
        });
        let facings = facings.collect();
        let input = Self::new(object, chain, eye(scene, &chain.view), settings);
        Some(Self { draw, object: facings, ..input })
    }
}

/// The eye of a scene in world space: a point, or for parallel lines of sight the direction to it.
fn eye(scene: &Scene, view: &Matrix) -> [f32; 4] {
    let [x, y, z] = scene.camera.eye;
    match scene.camera.projection {
        Projection::Perspective { .. } => [x, y, z, 1.0],
        Projection::Orthographic { .. } => [view[2], view[6], view[10], 0.0],
    }
}
