//! From the history of a pixel to the lab in which an entry of it was decided.

use super::{BackFace, ClipTriangle, Family, FillTriangle, FrustumCulling, LabInput, Pipeline, Stencil};
use crate::{
    pipeline::{Outcome, PixelEntry, ScreenTriangle, screen_triangles},
    raster::Algorithm,
    scene::Scene,
};

/// The lab that steps what became of a triangle at a pixel, about that triangle. Fragments are stepped by
/// the whole scene's run, or, where the stencil test decided, by that of the stencil.
pub fn lab_of(entry: &PixelEntry, scene: &Scene) -> LabInput {
    let triangle = entry.triangle.unwrap_or(0) as usize;
    match entry.outcome {
        Outcome::ObjectOutside(_) => FrustumCulling::default().into(),
        Outcome::Outside(_) | Outcome::ClippedAway(_) | Outcome::CutOff(_) => {
            let meshes = scene.draws[..entry.draw].iter().filter_map(|draw| draw.geometry.mesh());
            let before: usize = meshes.map(|mesh| mesh.triangles.len()).sum();
            ClipTriangle { vertices: None, triangle: before + triangle, ..ClipTriangle::first() }.into()
        }
        Outcome::Culled { .. } => BackFace { draw: entry.draw, triangle, ..BackFace::default() }.into(),
        Outcome::ZeroArea | Outcome::OutsideEdge { .. } | Outcome::LostTie { .. } => {
            let all = screen_triangles(scene);
            let own = |screen: &ScreenTriangle| {
                let part = entry.part.is_none_or(|part| part == screen.part);
                (screen.draw as usize, screen.triangle as usize) == (entry.draw, triangle) && part
            };
            let triangle = all.iter().position(own).unwrap_or(0);
            let input = FillTriangle { vertices: None, triangle, ..FillTriangle::first() };
            input.named(Algorithm::Aabb.name()).into()
        }
        Outcome::Stencil { .. } => Stencil::default().into(),
        Outcome::Scissored(_)
        | Outcome::Discarded { .. }
        | Outcome::Depth { .. }
        | Outcome::Written { .. } => Pipeline {}.into(),
    }
}
