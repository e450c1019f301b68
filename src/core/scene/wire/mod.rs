//! The scene file, field by field as it is written, and its way to the document and back.
//!
//! Where the file offers a choice (vertices or a model, parts or a matrix, one colour or many), all
//! fields of the choice stand here side by side; joining them to one value is where a wrong
//! combination is found.

mod camera;
mod compare;
mod depth;
mod draw;
mod lab;
mod light;

use super::{
    document::{Clear, Scene},
    path::FieldError,
};
use crate::{
    depth::DepthFormat,
    raster::{FillRule, YAxis},
    transform::DepthRange,
};
use camera::CameraWire;
use draw::DrawWire;
use lab::LabWire;
use light::LightWire;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneWire {
    rasterscope: u32,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    name: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    note: String,
    size: [u32; 2],
    #[serde(default)]
    clear: Clear,
    #[serde(default)]
    camera: CameraWire,
    #[serde(default)]
    depth_range: DepthRange,
    #[serde(default)]
    depth_format: DepthFormat,
    #[serde(default)]
    reversed: bool,
    #[serde(default)]
    fill_rule: FillRule,
    #[serde(default = "one")]
    samples: u32,
    #[serde(default)]
    y_axis: YAxis,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    lights: Vec<LightWire>,
    draws: Vec<DrawWire>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    lab: Option<LabWire>,
}

fn one() -> u32 {
    1
}

impl SceneWire {
    pub(super) fn into_scene(self) -> Result<Scene, FieldError> {
        let light =
            |(i, light): (usize, LightWire)| light.into_light().map_err(|e| e.within(i).within("lights"));
        let draw = |(i, draw): (usize, DrawWire)| draw.into_draw().map_err(|e| e.within(i).within("draws"));
        Ok(Scene {
            name: self.name,
            note: self.note,
            size: self.size,
            clear: self.clear,
            camera: self.camera.into_camera().map_err(|e| e.within("camera"))?,
            depth_range: self.depth_range,
            depth_format: self.depth_format,
            reversed: self.reversed,
            fill_rule: self.fill_rule,
            samples: self.samples,
            y_axis: self.y_axis,
            lights: self.lights.into_iter().enumerate().map(light).collect::<Result<_, _>>()?,
            draws: self.draws.into_iter().enumerate().map(draw).collect::<Result<_, _>>()?,
            lab: self.lab.map(LabWire::into_lab).transpose().map_err(|e| e.within("lab"))?,
        })
    }
}

impl From<&Scene> for SceneWire {
    fn from(scene: &Scene) -> Self {
        Self {
            rasterscope: Scene::VERSION,
            name: scene.name.clone(),
            note: scene.note.clone(),
            size: scene.size,
            clear: scene.clear,
            camera: CameraWire::from(&scene.camera),
            depth_range: scene.depth_range,
            depth_format: scene.depth_format,
            reversed: scene.reversed,
            fill_rule: scene.fill_rule,
            samples: scene.samples,
            y_axis: scene.y_axis,
            lights: scene.lights.iter().map(LightWire::from).collect(),
            draws: scene.draws.iter().map(DrawWire::from).collect(),
            lab: scene.lab.as_ref().map(LabWire::from),
        }
    }
}
