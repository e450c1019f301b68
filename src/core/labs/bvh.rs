//! The lab that tests a tree of boxes against the frustum.

use super::Family;
use crate::{
    compare::Setting,
    cull::{
        bvh::{self, Input, Split},
        object_frustum::world_frustum,
        planes::Frustum,
    },
    message::Message,
    pipeline::{draw_name, triangle_name},
    replay::{Budget, Playback},
    scene::{Checked, Scene},
    transform::{DepthRange, apply, chain::model_matrix, matrices},
};
use serde::{Deserialize, Serialize};

/// What the boxes of the tree are around.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Over {
    /// Each object.
    #[default]
    Objects,
    /// Each triangle of each object.
    Triangles,
}

impl Over {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Objects, Self::Triangles];

    /// The id of the word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Objects => "bvh-over-objects",
            Self::Triangles => "bvh-over-triangles",
        }
    }
}

/// All objects of the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Bvh {
    /// How the tree is built.
    #[serde(default)]
    pub split: Split,
    /// What its boxes are around.
    #[serde(default)]
    pub over: Over,
}

impl Family for Bvh {
    fn first() -> Self {
        Self::default()
    }

    fn name(&self) -> &'static str {
        "bvh"
    }

    fn is_of_scene(&self) -> bool {
        true
    }

    fn check(&self, _: &Scene) -> Checked {
        Ok(())
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        Ok(Box::new(bvh::play(input(scene, self.split, self.over), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        DepthRange::ALL.map(Setting::DepthRange).to_vec()
    }
}

/// The boxes of a resolved scene in world space, with their names.
fn input(scene: &Scene, split: Split, over: Over) -> Input {
    let (mut boxes, mut names, mut triangles) = (Vec::new(), Vec::new(), Vec::new());
    for (index, draw) in scene.draws.iter().enumerate() {
        let Some(mesh) = draw.geometry.mesh() else { continue };
        let model = model_matrix(&draw.transform);
        let place = |[x, y, z]: [f32; 3]| {
            let [x, y, z, _] = apply(&model, [x, y, z, 1.0]);
            [[x, y, z]; 2]
        };
        let world: Vec<_> = mesh.positions.iter().map(|&p| place(p)).collect();
        match over {
            Over::Objects if !world.is_empty() => {
                boxes.push(bvh::union(world.iter().copied()));
                names.push(draw_name((index, draw)));
            }
            Over::Objects => {}
            Over::Triangles => {
                for (number, triangle) in (0..).zip(&mesh.triangles) {
                    boxes.push(bvh::union(triangle.iter().map(|&i| world[i as usize])));
                    names.push(triangle_name((index, draw), number, None));
                    triangles.push(triangle.map(|i| world[i as usize][0]));
                }
            }
        }
    }
    let aspect = f64::from(scene.size[0]) / f64::from(scene.size[1]);
    let view = matrices::view(&scene.camera);
    let projection = matrices::projection(&scene.camera, aspect, scene.depth_range, scene.reversed);
    Input {
        boxes: boxes.into(),
        names: names.into(),
        triangles: triangles.into(),
        split,
        frustum: Frustum::before(&[&view, &projection], scene.depth_range),
        corners: world_frustum(scene),
    }
}
