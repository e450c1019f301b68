//! What is left of a triangle on the screen.

use super::{Piece, Point};
use crate::{
    depth::{Cutout, Rules},
    scene::Scene,
};

/// A piece on the screen, as the labs take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenTriangle {
    /// x and y in pixels, depth.
    pub vertices: [[f32; 3]; 3],
    /// 1/w at each vertex.
    pub r: [f32; 3],
    /// Alpha at each vertex.
    pub alpha: [f32; 3],
    /// Which draw.
    pub draw: u32,
    /// Which triangle of its mesh.
    pub triangle: u32,
    /// Which part of the clipped triangle, from 0.
    pub part: u32,
}

impl ScreenTriangle {
    pub(super) fn new(draw: u32, screen: &[Point], colors: &[[f32; 4]], piece: &Piece) -> Self {
        let corners = piece.corners.map(|i| screen[i as usize]);
        Self {
            vertices: corners.map(|[x, y, z, _]| [x, y, z]),
            r: corners.map(|[.., r]| r),
            alpha: piece.corners.map(|i| colors[i as usize][3]),
            draw,
            triangle: piece.triangle,
            part: piece.part,
        }
    }

    /// What its fragments meet before the depth test, by the state of its draw.
    pub fn rules(&self, scene: &Scene) -> Rules {
        let draw = &scene.draws[self.draw as usize];
        let Self { alpha, r, .. } = *self;
        Rules {
            placement: draw.placement,
            scissor: draw.scissor,
            cutout: draw.alpha_test.map(|test| Cutout { test, alpha, r }),
        }
    }
}
