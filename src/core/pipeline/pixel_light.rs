//! How bright a fragment is and why: what its stage was given, and the terms of the light.

use super::{Outputs, PixelEntry, Shader};
use crate::{
    interpolate::Barycentric,
    math::Tally,
    message::Message,
    scene::{Scene, Shade},
    trace::NoTrace,
};

/// A few short lines about a fragment of a shaded draw; none for any other entry. `outputs` are those of
/// the same scene.
pub fn pixel_light(scene: &Scene, outputs: &Outputs, entry: &PixelEntry) -> Vec<Message> {
    let (Some(draw), Some(stages)) = (scene.draws.get(entry.draw), outputs.draws.get(entry.draw)) else {
        return Vec::new();
    };
    let Some(at) = entry.at.filter(|_| draw.shade != Shade::None && entry.is_fragment()) else {
        return Vec::new();
    };
    let mut tally = Tally::default();
    let own = stages.clipped().pieces.iter().filter(|piece| Some(piece.triangle) == entry.triangle);
    let here = |piece: &&super::Piece| {
        let points = piece.corners.map(|i| stages.screen()[i as usize]).map(|[x, y, ..]| [x, y]);
        Barycentric::new(points, &mut Tally::default())
            .is_some_and(|triangle| triangle.contains(at, &mut Tally::default()))
    };
    let Some(piece) = own.clone().find(here) else { return Vec::new() };
    if let Some(factor) = stages.lit().factors.get(piece.triangle as usize) {
        return vec![Message::new("pipeline-pixel-light-flat").with("factor", *factor)];
    }
    let Some(shader) = Shader::new(stages, piece, draw.texture, &mut tally) else { return Vec::new() };
    let inputs = shader.inputs(at, &mut tally);
    let [r, g, b, _] = inputs.color;
    let (Some(surface), Some(illumination)) = (inputs.surface, &stages.lit().illumination) else {
        return vec![Message::new("pipeline-pixel-light-gouraud").with("color", [r, g, b])];
    };
    let light = illumination.at_pixel_traced(surface, &mut NoTrace);
    let ambient = f64::from(illumination.material.ambient);
    vec![
        Message::new("pipeline-pixel-light-inputs")
            .with("place", surface.position)
            .with("normal", surface.normal),
        Message::new("pipeline-pixel-light-terms")
            .with("ambient", ambient)
            .with("diffuse", light.matte - ambient)
            .with("specular", light.gloss),
    ]
}
