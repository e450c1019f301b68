//! The drawing: the image with a number in each pixel, the triangles, and the normals at their vertices.

use super::{Event, Snapshot, surface};
use crate::{
    explain::{Label, Mark, Role},
    message::Value,
    pipeline::DrawOutputs,
    scene::Shade,
    transform::{apply, divide},
};
use std::sync::Arc;

/// Of more triangles only the one in hand has an outline.
const MOST_OUTLINES: usize = 64;
/// Of more vertices in all none has a name or a normal.
const MOST_VERTICES: usize = 12;
/// Larger images show no numbers.
const MOST_VALUES: usize = 4096;
/// How long a normal is drawn, as a part of the distance between the vertices that are farthest apart.
const LENGTH: f64 = 0.2;

impl Snapshot {
    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.image_marks(out);
        let few = self.triangles().take(MOST_OUTLINES + 1).count() <= MOST_OUTLINES;
        for (object, piece, corners) in self.triangles() {
            let now = object == self.object && self.piece == Some(piece);
            if few || now {
                let role = if now { Role::Neutral } else { Role::Candidate };
                out.push(Mark::Polygon { points: corners.to_vec(), role, object: None, label: None });
            }
        }
        let vertices: usize = self.subject.outputs.draws.iter().map(|stages| stages.clip().len()).sum();
        if vertices <= MOST_VERTICES {
            for (object, stages) in self.subject.outputs.draws.iter().enumerate() {
                self.vertex_marks(object, stages, event, out);
            }
        } else if let (Some(vertex), Some((_, stages))) = (self.vertex, self.object())
            && let Some(at) = self.place(stages, vertex)
        {
            let label = Some(Label::name(format!("v{vertex}")));
            out.push(Mark::Point { at, role: Role::Active, label });
        }
        if let Some(pixel) = self.pixel {
            let role = if self.hidden { Role::Rejected } else { Role::Active };
            let value = self.output.map_or(Value::None, |(_, value)| hundredths(value));
            out.push(Mark::Pixel { at: pixel.map(|n| n as i32), role, object: None, value });
        }
    }

    /// What is drawn so far, and the number of each pixel.
    fn image_marks(&self, out: &mut Vec<Mark>) {
        let pixels = &self.image.pixels;
        if pixels.iter().any(Option::is_some) {
            let rgba = pixels.iter().flat_map(|shown| shown.map_or([0; 4], |shown| shown.code)).collect();
            let size = self.image.size.map(|side| side as usize);
            out.push(Mark::Image { size, rgba: Arc::new(rgba) });
        }
        if pixels.len() <= MOST_VALUES {
            let [width, height] = self.image.size;
            for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
                if let Some(shown) = self.image.at(pixel) {
                    let at = pixel.map(|n| n as i32);
                    let value = hundredths(shown.value);
                    out.push(Mark::Pixel { at, role: Role::Neutral, object: None, value });
                }
            }
        }
    }

    /// Where a vertex is on the screen, if it is before the eye.
    fn place(&self, stages: &DrawOutputs, vertex: usize) -> Option<[f32; 2]> {
        self.seen(*stages.clip().get(vertex)?)
    }

    fn seen(&self, clip: [f32; 4]) -> Option<[f32; 2]> {
        let [x, y, ..] = self.subject.outputs.viewport.to_screen(divide(clip));
        (clip[3] > 0.0 && x.is_finite() && y.is_finite()).then_some([x, y])
    }

    /// The vertices of an object by name, with their normals where these are used.
    fn vertex_marks(&self, object: usize, stages: &DrawOutputs, event: Option<&Event>, out: &mut Vec<Mark>) {
        let outputs = &self.subject.outputs;
        let smooth = self.subject.objects.get(object).is_some_and(|object| object.shade != Shade::Flat);
        let length = LENGTH * extent(stages);
        for vertex in 0..stages.clip().len() {
            let Some(at) = self.place(stages, vertex) else { continue };
            let now = object == self.object && self.vertex == Some(vertex);
            let in_stage =
                matches!(event, Some(Event::Vertex { .. } | Event::VertexColor { .. } | Event::Light(_)));
            let role = if now && in_stage { Role::Active } else { Role::Neutral };
            if let Some(surface) = surface(stages, vertex).filter(|_| smooth) {
                let size = surface.normal.iter().map(|c| f64::from(*c) * f64::from(*c)).sum::<f64>();
                let scale = if size > 0.0 { length / libm::sqrt(size) } else { 0.0 };
                let [x, y, z] = [0, 1, 2].map(|axis| {
                    (f64::from(surface.position[axis]) + scale * f64::from(surface.normal[axis])) as f32
                });
                let tip = self.seen(apply(&outputs.projection, apply(&outputs.view, [x, y, z, 1.0])));
                if let Some(tip) = tip {
                    out.push(Mark::Segment { ends: [at, tip], role, label: None });
                }
            }
            let label = Some(Label::name(format!("v{vertex}")));
            out.push(Mark::Point { at, role, label });
        }
    }
}

/// A brightness as its cell has room for it; the tables have all digits.
fn hundredths(value: f32) -> Value {
    ((value * 100.0).round() / 100.0).into()
}

/// The largest side of the box around an object in world space.
fn extent(stages: &DrawOutputs) -> f64 {
    let side = |axis: usize| {
        let values = stages.world().iter().map(|point| f64::from(point[axis]));
        let (low, high) = values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        if low < high { high - low } else { 0.0 }
    };
    (0..3).map(side).fold(0.0, f64::max)
}
