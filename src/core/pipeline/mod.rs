//! The whole pipeline: from a scene to its image, with what every stage did.
//!
//! Model, view, projection, culling, clipping in clip space, divide, viewport, scan conversion,
//! stencil, depth, blend, write. Each stage is exact for the binary32 values that it is given. Facing
//! and degeneracy are decided once, by the unclipped vertices. Every piece of work that can be left
//! out has a switch in [`Skips`] and a counter in [`Stats`], and never changes the image.

mod counts;
mod cut;
mod draw;
mod enlarged;
mod evaluate;
mod fragments;
mod frame;
mod gradient;
mod lit;
mod multisample;
mod names;
mod objects;
mod outcome;
mod overlay;
mod picture;
mod pixel;
mod pixel_light;
mod pixel_why;
mod pixel_words;
mod range;
mod rasterizer;
mod screen_triangle;
mod shader;
mod skips;
mod stages;
mod stats;
mod visible;
mod watch;
mod whole;
mod work;

pub use draw::{DrawOutputs, DrawRuns};
pub use enlarged::enlarged_triangles;
pub use evaluate::{Outputs, Pipeline};
pub use frame::Frame;
pub use lit::Lit;
pub use names::{draw_name, screen_names, triangle_name};
pub use objects::Bounding;
pub use outcome::{Later, Outcome, PixelEntry, PixelHistory, Placed, SampleEntry};
pub use overlay::{Changed, Layer, Overlay, Wires};
pub use picture::Picture;
pub use pixel::{pixel_history, pixel_history_of};
pub use pixel_light::pixel_light;
pub use range::out_of_range;
pub use rasterizer::Rasterizer;
pub use screen_triangle::ScreenTriangle;
pub(crate) use shader::Shader;
pub use skips::{Skip, Skips};
pub use stages::{Clipped, ClippedPolygon, Culled, Decision, Fate, Piece, Point};
pub use stats::{Reason, StageCount, Stats, Unit};
pub use visible::{Planes, Removed};
pub use watch::PixelCounts;
pub use work::Work;

use crate::scene::Scene;

/// Draws a resolved scene; a model that is not loaded draws nothing.
pub fn render(scene: &Scene, skips: &Skips) -> Frame {
    let mut pipeline = Pipeline::default();
    pipeline.update(scene, skips);
    pipeline.into_frame()
}

/// The stages before the image, for a lab that draws it in its own way.
pub(crate) fn geometry(scene: &Scene) -> Outputs {
    let mut pipeline = Pipeline::default();
    pipeline.update_geometry(scene, Skips::ALL);
    pipeline.into_outputs()
}

/// The triangles that are scan converted, in drawing order.
pub fn screen_triangles(scene: &Scene) -> Vec<ScreenTriangle> {
    // Nothing is drawn: only the stages before the image are needed.
    let mut pipeline = Pipeline::default();
    pipeline.update_geometry(scene, Skips::ALL);
    pipeline.outputs().triangles().collect()
}
