//! Meshes in two ways: as a picture and nothing else, and through the whole pipeline as the window does it, with all
//! stages' outputs and counts.

use crate::{meshes::Sight, painter::Painter};
use rasterscope_core::{
    pipeline::{Picture, Pipeline, Skips},
    scene::Scene,
    transform::Camera,
};

#[derive(Default)]
pub struct Direct {
    picture: Picture,
    task: Option<(Scene, Vec<Camera>)>,
}

pub fn picture_painter() -> Box<dyn Painter<Sight>> {
    Box::new(Direct::default())
}

impl Painter<Sight> for Direct {
    fn name(&self) -> &'static str {
        "rasterscope picture"
    }

    fn take(&mut self, sight: &Sight) {
        self.task = Some((sight.scene(), sight.cameras.clone()));
    }

    fn draw(&mut self) {
        let Some((scene, cameras)) = &mut self.task else { return };
        for camera in cameras {
            scene.camera = *camera;
            self.picture.draw(scene);
        }
    }

    fn colors(&self) -> Vec<u32> {
        let (codes, _) = self.picture.frame().color.as_chunks();
        codes.iter().map(|codes| u32::from_ne_bytes(*codes)).collect()
    }
}

#[derive(Default)]
pub struct Whole {
    pipeline: Pipeline,
    task: Option<(Scene, Vec<Camera>)>,
}

pub fn mesh_painter() -> Box<dyn Painter<Sight>> {
    Box::new(Whole::default())
}

impl Painter<Sight> for Whole {
    fn name(&self) -> &'static str {
        "rasterscope pipeline, with all counts"
    }

    fn take(&mut self, sight: &Sight) {
        self.task = Some((sight.scene(), sight.cameras.clone()));
    }

    fn draw(&mut self) {
        let Some((scene, cameras)) = &mut self.task else { return };
        for camera in cameras {
            scene.camera = *camera;
            self.pipeline.update(scene, &Skips::ALL);
        }
    }

    fn colors(&self) -> Vec<u32> {
        let (codes, _) = self.pipeline.outputs().frame.color.as_chunks();
        codes.iter().map(|codes| u32::from_ne_bytes(*codes)).collect()
    }
}
