//! What triangles are called, on the canvas, in the history of a pixel and in a z-buffer run.

use super::ScreenTriangle;
use crate::{
    explain::letter,
    scene::{Draw, Scene},
};

/// The draw's name, or its letter.
pub fn draw_name((index, draw): (usize, &Draw)) -> String {
    if draw.name.is_empty() { letter(index) } else { draw.name.clone() }
}

/// The draw's name; behind it the triangle's number, from 1, if the draw has several; and
/// `.1`, `.2`, ... if clipping left it in several parts.
pub fn triangle_name((index, draw): (usize, &Draw), triangle: u32, part: Option<u32>) -> String {
    let mut name = draw_name((index, draw));
    if draw.geometry.mesh().is_some_and(|mesh| mesh.triangles.len() > 1) {
        name += &format!(" {}", triangle + 1);
    }
    if let Some(part) = part {
        name += &format!(".{}", part + 1);
    }
    name
}

/// The names of all screen triangles of a scene, in drawing order.
pub fn screen_names<'a>(
    scene: &'a Scene,
    triangles: &'a [ScreenTriangle],
) -> impl Iterator<Item = String> + 'a {
    triangles.iter().enumerate().map(|(i, piece)| {
        // The parts of a triangle follow each other.
        let cut = piece.part > 0 || triangles.get(i + 1).is_some_and(|next| next.part > 0);
        let index = piece.draw as usize;
        triangle_name((index, &scene.draws[index]), piece.triangle, cut.then_some(piece.part))
    })
}
