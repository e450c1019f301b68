//! The lab that clips a triangle at the planes of the frustum.

use super::Family;
use crate::{
    clip::polygon::{
        PlaneSet,
        clip_triangle::{self, Mistake, Pieces, Settings, Space, Subject},
    },
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_finite, refuse_if},
    transform::{DepthRange, Viewport, chain::model_matrix, matrices},
};
use serde::{Deserialize, Serialize};

/// Fixed point is for scan conversion.
const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64];

/// The triangle of a scene that has none.
const TRIANGLE: [[f32; 3]; 3] = [[-0.5, 1.5, -2.5], [0.5, 0.25, -0.5], [3.5, -1.5, -2.5]];

/// A triangle before the scene's camera.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClipTriangle {
    /// In camera space: the eye at the origin, looking along -z, y up. Left out: a triangle of the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<[[f32; 3]; 3]>,
    /// Which triangle of the scene, counted through all draws.
    #[serde(default)]
    pub triangle: usize,
    /// One number at each vertex, such as a texture coordinate.
    #[serde(default = "attribute")]
    pub attribute: [f32; 3],
    /// Where it is clipped.
    #[serde(default)]
    pub space: Space,
    /// Against which planes.
    #[serde(default)]
    pub planes: PlaneSet,
    /// What the result is made of.
    #[serde(default)]
    pub pieces: Pieces,
    /// What is done wrong on purpose.
    #[serde(default)]
    pub mistake: Mistake,
    /// In which arithmetic.
    #[serde(default)]
    pub arithmetic: Arithmetic,
}

fn attribute() -> [f32; 3] {
    [0.0, 1.0, 0.5]
}

impl ClipTriangle {
    /// The vertices in camera space: its own, those of the scene's triangle, or of one that is at hand.
    pub fn corners(&self, scene: &Scene) -> [[f32; 3]; 3] {
        self.vertices.or_else(|| of_scene(scene, self.triangle)).unwrap_or(TRIANGLE)
    }

    /// What is run.
    pub fn subject(&self, scene: &Scene) -> Subject {
        let viewport = Viewport { size: scene.size, depth_range: scene.depth_range, y_axis: scene.y_axis };
        let Self { space, planes, pieces, mistake, arithmetic, .. } = *self;
        Subject::new(
            (self.corners(scene), self.attribute),
            (scene.camera, viewport.aspect()),
            scene.depth_range,
            Settings { space, planes, pieces, mistake, arithmetic },
        )
    }
}

/// A triangle of the scene in camera space.
fn of_scene(scene: &Scene, index: usize) -> Option<[[f32; 3]; 3]> {
    let mut before = 0;
    for draw in &scene.draws {
        let mesh = draw.geometry.mesh()?;
        if let Some(triangle) = mesh.triangles.get(index.wrapping_sub(before)) {
            let (model, view) = (model_matrix(&draw.transform), matrices::view(&scene.camera));
            return Some(triangle.map(|vertex| {
                let [x, y, z] = mesh.positions[vertex as usize];
                let [x, y, z, _] = matrices::apply(&view, matrices::apply(&model, [x, y, z, 1.0]));
                [x, y, z]
            }));
        }
        before += mesh.triangles.len();
    }
    None
}

impl Family for ClipTriangle {
    fn first() -> Self {
        Self {
            vertices: None,
            triangle: 0,
            attribute: attribute(),
            space: Space::default(),
            planes: PlaneSet::default(),
            pieces: Pieces::default(),
            mistake: Mistake::default(),
            arithmetic: Arithmetic::default(),
        }
    }

    fn name(&self) -> &'static str {
        "clip-triangle"
    }

    fn is_of_scene(&self) -> bool {
        self.vertices.is_none()
    }

    fn check(&self, _: &Scene) -> Checked {
        for (i, vertex) in self.vertices.iter().flatten().enumerate() {
            each_finite(vertex).map_err(|e| e.within(i).within("vertices"))?;
        }
        each_finite(&self.attribute).map_err(|e| e.within("attribute"))?;
        let range = Problem::Range { min: 1.0, max: f64::from(PlaneSet::MOST_GUARD) };
        let power = match self.planes {
            PlaneSet::Guard(power) => power,
            PlaneSet::All | PlaneSet::Near => 1,
        };
        refuse_if(!(1..=PlaneSet::MOST_GUARD).contains(&power), "planes", range)?;
        let problem = Problem::UnknownName {
            name: self.arithmetic.name().into(),
            known: ARITHMETICS.map(Arithmetic::name).to_vec(),
        };
        refuse_if(!ARITHMETICS.contains(&self.arithmetic), "arithmetic", problem)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        Ok(Box::new(clip_triangle::play(self.subject(scene), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        let ranges = DepthRange::ALL.map(Setting::DepthRange);
        ARITHMETICS.map(Setting::Arithmetic).into_iter().chain(ranges).collect()
    }

    fn choices(&self) -> Vec<Choice> {
        let mistakes = [
            ("\"none\"", "mistake-none"),
            ("\"divide-first\"", "mistake-divide-first"),
            ("\"no-near-plane\"", "mistake-no-near-plane"),
            ("\"no-attributes\"", "mistake-no-attributes"),
            ("\"walk-order\"", "mistake-walk-order"),
        ];
        let spaces = [("\"clip\"", "word-space-clip"), ("\"camera\"", "word-space-camera")];
        let planes = [
            ("\"all\"", "word-planes-all"),
            ("\"near\"", "word-planes-near"),
            ("{\"guard\":2}", "word-planes-guard"),
        ];
        let pieces = [("\"polygon\"", "word-pieces-polygon"), ("\"triangles\"", "word-pieces-triangles")];
        let mut all = Choice::all("mistake", "compare-mistake", mistakes).to_vec();
        all.extend(Choice::all("space", "compare-space", spaces));
        all.extend(Choice::all("planes", "compare-planes", planes));
        all.extend(Choice::all("pieces", "compare-pieces", pieces));
        all
    }

    fn setting(&self, like: Setting) -> Option<Setting> {
        matches!(like, Setting::Arithmetic(_)).then_some(Setting::Arithmetic(self.arithmetic))
    }

    fn set(&mut self, setting: Setting) {
        if let Setting::Arithmetic(arithmetic) = setting {
            self.arithmetic = arithmetic;
        }
    }
}
