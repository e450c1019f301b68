//! The crate euc: a pipeline with shaders, binary32, the bounding box of each triangle.

use crate::frames::{Painter, SIZE, Soup};
use euc::{Interpolate, Pipeline, Target, buffer::Buffer2d, rasterizer};

/// Vertices are on the screen already: back to NDC, exact but for the smallest coordinates.
struct Flat;

#[derive(Clone)]
struct Color(u32);

impl Interpolate for Color {
    fn lerp2(a: Self, _: Self, _: f32, _: f32) -> Self {
        a
    }

    fn lerp3(a: Self, _: Self, _: Self, _: f32, _: f32, _: f32) -> Self {
        a
    }
}

impl Pipeline for Flat {
    type Vertex = ([f32; 4], u32);
    type VsOut = Color;
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, (position, color): &Self::Vertex) -> ([f32; 4], Color) {
        (*position, Color(*color))
    }

    #[inline(always)]
    fn frag(&self, color: &Color) -> u32 {
        color.0
    }
}

pub struct Euc {
    color: Buffer2d<u32>,
    depth: Buffer2d<f32>,
    vertices: Vec<([f32; 4], u32)>,
}

pub fn painter() -> Box<dyn Painter> {
    let size = [SIZE; 2];
    Box::new(Euc { color: Buffer2d::new(size, 0), depth: Buffer2d::new(size, 1.0), vertices: Vec::new() })
}

impl Painter for Euc {
    fn name(&self) -> &'static str {
        "euc 0.5.3"
    }

    fn take(&mut self, soup: &Soup) {
        let half = SIZE as f32 / 2.0;
        let ndc = |[x, y, z]: [f32; 3]| [x / half - 1.0, 1.0 - y / half, z, 1.0];
        let vertices = soup.triangles().flat_map(|(triangle, color)| triangle.map(|v| (ndc(v), color)));
        self.vertices = vertices.collect();
    }

    fn draw(&mut self) {
        self.color.clear(0);
        self.depth.clear(1.0);
        Flat.draw::<rasterizer::Triangles<'_, _, rasterizer::BackfaceCullingDisabled>, _>(
            &self.vertices,
            &mut self.color,
            Some(&mut self.depth),
        );
    }

    fn colors(&self) -> Vec<u32> {
        self.color.as_ref().to_vec()
    }
}
