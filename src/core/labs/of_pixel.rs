//! From the history of a pixel to the lab in which an entry of it was decided.

use super::{
    BackFace, ClipTriangle, Family, FillTriangle, FrustumCulling, LabInput, Msaa, Pipeline, Stencil,
};
use crate::{
    pipeline::{Outcome, PixelEntry, ScreenTriangle, screen_triangles},
    raster::{Algorithm, Samples, msaa::Shading},
    scene::Scene,
};

/// The lab that steps what became of a triangle at a pixel, about that triangle. Fragments are stepped by
/// the whole scene's run, or, where the stencil test decided, by that of the stencil; with several samples a pixel, the
/// samples that the triangle covers are.
pub fn lab_of(entry: &PixelEntry, scene: &Scene) -> LabInput {
    let triangle = entry.triangle.unwrap_or(0) as usize;
    let on_screen = |all: &[ScreenTriangle]| {
        let part = |screen: &ScreenTriangle| entry.part.is_none_or(|part| part == screen.part);
        let own = |screen: &ScreenTriangle| {
            (screen.draw as usize, screen.triangle as usize) == (entry.draw, triangle) && part(screen)
        };
        all.iter().position(own).unwrap_or(0)
    };
    match entry.outcome {
        Outcome::ObjectOutside(_) => FrustumCulling::default().into(),
        Outcome::Outside(_) | Outcome::ClippedAway(_) | Outcome::CutOff(_) => {
            let meshes = scene.draws[..entry.draw].iter().filter_map(|draw| draw.geometry.mesh());
            let before: usize = meshes.map(|mesh| mesh.triangles.len()).sum();
            ClipTriangle { vertices: None, triangle: before + triangle, ..ClipTriangle::first() }.into()
        }
        Outcome::Culled { .. } => BackFace { draw: entry.draw, triangle, ..BackFace::default() }.into(),
        Outcome::Stencil { .. } => Stencil::default().into(),
        // Which samples are covered is not stepped by the scene's run.
        _ if scene.samples > 1 => {
            let all = screen_triangles(scene);
            let shaded =
                |ScreenTriangle { vertices, .. }: &ScreenTriangle| vertices.map(|[x, y, ..]| [x, y, 1.0]);
            let triangles = all.get(on_screen(&all)).map(shaded).into_iter().collect();
            let samples = Samples::try_from(scene.samples).unwrap_or_default();
            Msaa { triangles, samples, shading: Shading::Centroid }.into()
        }
        Outcome::ZeroArea | Outcome::OutsideEdge { .. } | Outcome::LostTie { .. } => {
            let triangle = on_screen(&screen_triangles(scene));
            let input = FillTriangle { vertices: None, triangle, ..FillTriangle::first() };
            input.named(Algorithm::Aabb.name()).into()
        }
        Outcome::NoSample
        | Outcome::Scissored(_)
        | Outcome::Discarded { .. }
        | Outcome::Depth { .. }
        | Outcome::Written { .. } => Pipeline {}.into(),
    }
}
