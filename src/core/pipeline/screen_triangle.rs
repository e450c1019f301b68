//! What is left of a triangle on the screen.

use super::{Piece, Point};

/// A piece on the screen, as the labs take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenTriangle {
    /// x and y in pixels, depth.
    pub vertices: [[f32; 3]; 3],
    /// 1/w at each vertex.
    pub r: [f32; 3],
    /// Which draw.
    pub draw: u32,
    /// Which triangle of its mesh.
    pub triangle: u32,
    /// Which part of the clipped triangle, from 0.
    pub part: u32,
}

impl ScreenTriangle {
    pub(super) fn new(draw: u32, screen: &[Point], piece: &Piece) -> Self {
        let corners = piece.corners.map(|i| screen[i as usize]);
        Self {
            vertices: corners.map(|[x, y, z, _]| [x, y, z]),
            r: corners.map(|[.., r]| r),
            draw,
            triangle: piece.triangle,
            part: piece.part,
        }
    }
}
