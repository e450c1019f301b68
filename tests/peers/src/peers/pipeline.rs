//! Meshes in two ways: as a picture and nothing else, and through the whole pipeline as the window does it, with all
//! stages' outputs and counts.

use crate::{
    meshes::Sight,
    painter::{Maker, Painter},
};
use rasterscope_core::{
    pipeline::{Frame, Picture, Pipeline, Skips},
    scene::Scene,
    transform::Camera,
};

/// From a scene to its image.
trait Draws: Default + 'static {
    const NAME: &'static str;

    fn draw(&mut self, scene: &Scene);
    fn frame(&self) -> &Frame;
}

impl Draws for Picture {
    const NAME: &'static str = "rasterscope picture";

    fn draw(&mut self, scene: &Scene) {
        self.draw(scene);
    }

    fn frame(&self) -> &Frame {
        self.frame()
    }
}

impl Draws for Pipeline {
    const NAME: &'static str = "rasterscope pipeline, with all counts";

    fn draw(&mut self, scene: &Scene) {
        self.update(scene, &Skips::ALL);
    }

    fn frame(&self) -> &Frame {
        &self.outputs().frame
    }
}

#[derive(Default)]
struct Ours<D> {
    by: D,
    task: Option<(Scene, Vec<Camera>)>,
}

/// Both ways.
pub fn mesh_painters() -> [Maker<Sight>; 2] {
    [Box::new(painter::<Picture>), Box::new(painter::<Pipeline>)]
}

fn painter<D: Draws>() -> Box<dyn Painter<Sight>> {
    Box::new(Ours::<D>::default())
}

impl<D: Draws> Painter<Sight> for Ours<D> {
    fn name(&self) -> &'static str {
        D::NAME
    }

    fn take(&mut self, sight: &Sight) {
        self.task = Some((sight.scene(), sight.cameras.clone()));
    }

    fn draw(&mut self) {
        let Some((scene, cameras)) = &mut self.task else { return };
        for camera in cameras {
            scene.camera = *camera;
            self.by.draw(scene);
        }
    }

    fn colors(&self) -> Vec<u32> {
        let (codes, _) = self.by.frame().color.as_chunks();
        codes.iter().map(|codes| u32::from_ne_bytes(*codes)).collect()
    }
}
