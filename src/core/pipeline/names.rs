//! What triangles are called, on the canvas, in the history of a pixel and in a z-buffer run.

use crate::scene::Draw;

/// A, B, C, ..., Z; a number from 27 on: the name of object `index` (from 0) if it has no other.
pub fn letter(index: usize) -> String {
    match u8::try_from(index) {
        Ok(index @ 0..26) => char::from(b'A' + index).to_string(),
        _ => (index + 1).to_string(),
    }
}

/// The draw's name or letter; behind it the triangle's number, from 1, if the draw has several; and
/// `.1`, `.2`, ... if clipping left it in several parts.
pub fn triangle_name((index, draw): (usize, &Draw), triangle: u32, part: Option<u32>) -> String {
    let mut name = if draw.name.is_empty() { letter(index) } else { draw.name.clone() };
    if draw.geometry.mesh().is_some_and(|mesh| mesh.triangles.len() > 1) {
        name += &format!(" {}", triangle + 1);
    }
    if let Some(part) = part {
        name += &format!(".{}", part + 1);
    }
    name
}
