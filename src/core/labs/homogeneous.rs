//! The lab that fills a triangle before the division by w.

use super::{Family, fill_triangle::is_default, nothing_to_step, scan_settings};
use crate::{
    compare::{Choice, Setting},
    math::Arithmetic,
    message::Message,
    raster::{
        self, Mistake, YAxis,
        homogeneous::{self, Vertex},
    },
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, each_row_finite, refuse_if},
    transform::{Projection, chain},
};
use serde::{Deserialize, Serialize};

/// One triangle with w.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Homogeneous {
    /// x and y in pixels times w, and w; y growing as the scene says. `None` takes a triangle of the scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<[Vertex; 3]>,
    /// Which of the scene's triangles, counted through all draws, when there are no vertices.
    #[serde(default, skip_serializing_if = "is_default")]
    pub triangle: usize,
    /// The smallest w that is drawn, more than 0. Left out: no near plane, or the camera's where the
    /// triangle is the scene's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub near: Option<f32>,
    /// What the adjugate and the edges are computed in; fixed point has nothing to snap here.
    #[serde(default, skip_serializing_if = "is_default")]
    pub arithmetic: Arithmetic,
    /// What is got wrong on purpose.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub mistake: Option<Mistake>,
}

impl Homogeneous {
    /// Of these vertices, without a near plane.
    pub fn of(vertices: [Vertex; 3]) -> Self {
        Self { vertices: Some(vertices), ..Self::first() }
    }

    /// The vertices that are run: its own, or those of the scene's triangle.
    pub fn corners(&self, scene: &Scene) -> Option<[Vertex; 3]> {
        self.vertices.or_else(|| of_scene(scene, self.triangle))
    }

    /// The near plane that is run.
    pub fn near(&self, scene: &Scene) -> Option<f32> {
        let of_camera = match scene.camera.projection {
            Projection::Perspective { .. } if self.vertices.is_none() => Some(scene.camera.near),
            _ => None,
        };
        self.near.or(of_camera)
    }
}

/// A triangle of the scene: clip space with the viewport's scale and shift, each times w, rounded once.
fn of_scene(scene: &Scene, index: usize) -> Option<[Vertex; 3]> {
    let mut before = 0;
    for draw in &scene.draws {
        let mesh = draw.geometry.mesh()?;
        if let Some(triangle) = mesh.triangles.get(index.wrapping_sub(before)) {
            let corners = triangle.map(|vertex| mesh.positions[vertex as usize]);
            let paths = chain::run(&corners, &chain::Chain::of(scene, draw));
            let [half_width, half_height] = scene.size.map(|n| f64::from(n) / 2.0);
            let place = |path: &chain::Path| {
                let [x, y, _, w] = path[3].map(f64::from);
                let down = if scene.y_axis == YAxis::Down { w - y } else { w + y };
                [(half_width * (x + w)) as f32, (half_height * down) as f32, w as f32]
            };
            return Some([place(&paths[0]), place(&paths[1]), place(&paths[2])]);
        }
        before += mesh.triangles.len();
    }
    None
}

impl Family for Homogeneous {
    fn first() -> Self {
        Self { vertices: None, triangle: 0, near: None, arithmetic: Arithmetic::Exact, mistake: None }
    }

    fn name(&self) -> &'static str {
        "homogeneous"
    }

    fn is_of_scene(&self) -> bool {
        self.vertices.is_none()
    }

    fn check(&self, _: &Scene) -> Checked {
        self.vertices.iter().try_for_each(|vertices| each_row_finite("vertices", vertices))?;
        let near = self.near.unwrap_or(1.0);
        refuse_if(!near.is_finite(), "near", Problem::NotFinite)?;
        refuse_if(near <= 0.0, "near", Problem::NotPositive)?;
        super::fill_triangle::check_mistake(self.mistake, &Mistake::OF_HOMOGENEOUS)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        let vertices = self.corners(scene).ok_or_else(|| nothing_to_step(self))?;
        let Self { arithmetic, mistake, .. } = *self;
        let settings = raster::Settings { arithmetic, mistake, ..scan_settings(scene) };
        Ok(Box::new(homogeneous::play(vertices, self.near(scene), settings, budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        let arithmetics = [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32].map(Setting::Arithmetic);
        [arithmetics.to_vec(), Setting::of_scan()].concat()
    }

    fn choices(&self) -> Vec<Choice> {
        let mistakes = [
            ("null", "mistake-none"),
            ("\"divide-first\"", "mistake-divide-first"),
            ("\"epsilon-small\"", "mistake-epsilon-small"),
            ("\"epsilon-large\"", "mistake-epsilon-large"),
        ];
        Choice::all("mistake", "compare-mistake", mistakes).to_vec()
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
