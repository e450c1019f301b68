//! The crate euc: a pipeline with shaders, binary32, the bounding box of each triangle.

use crate::{
    frames::{SIZE, Soup},
    meshes::{self, Sight},
    painter::Painter,
};
use euc::{Interpolate, Pipeline, Target, buffer::Buffer2d, rasterizer};
use rasterscope_core::scene::Mesh;
use std::sync::Arc;

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

pub fn painter() -> Box<dyn Painter<Soup>> {
    let size = [SIZE; 2];
    Box::new(Euc { color: Buffer2d::new(size, 0), depth: Buffer2d::new(size, 1.0), vertices: Vec::new() })
}

impl Painter<Soup> for Euc {
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

/// As in its example of a teapot: vertices are indices, the shader looks them up.
struct Shader<'m> {
    matrix: [[f32; 4]; 4],
    mesh: &'m Mesh,
}

#[derive(Clone)]
struct Mixed([f32; 3]);

impl Interpolate for Mixed {
    #[inline(always)]
    fn lerp2(Self(a): Self, Self(b): Self, x: f32, y: f32) -> Self {
        Self([0, 1, 2].map(|i| a[i].mul_add(x, b[i] * y)))
    }

    #[inline(always)]
    fn lerp3(Self(a): Self, Self(b): Self, Self(c): Self, x: f32, y: f32, z: f32) -> Self {
        Self([0, 1, 2].map(|i| a[i].mul_add(x, b[i].mul_add(y, c[i] * z))))
    }
}

impl Pipeline for Shader<'_> {
    type Vertex = u32;
    type VsOut = Mixed;
    type Pixel = u32;

    #[inline(always)]
    fn vert(&self, index: &u32) -> ([f32; 4], Mixed) {
        let index = *index as usize;
        let [x, y, z] = self.mesh.positions[index];
        let [r, g, b, _] = self.mesh.colors[index];
        (self.matrix.map(|[a, b, c, d]| a.mul_add(x, b.mul_add(y, c.mul_add(z, d)))), Mixed([r, g, b]))
    }

    #[inline(always)]
    fn frag(&self, Mixed(color): &Mixed) -> u32 {
        let [r, g, b] = color.map(|channel| (channel * 255.0 + 0.5) as u8);
        u32::from_ne_bytes([r, g, b, 255])
    }
}

struct Meshes {
    color: Buffer2d<u32>,
    depth: Buffer2d<f32>,
    mesh: Arc<Mesh>,
    matrices: Vec<[[f32; 4]; 4]>,
}

pub fn mesh_painter() -> Box<dyn Painter<Sight>> {
    let (color, depth) = (Buffer2d::new(meshes::SIZE, 0), Buffer2d::new(meshes::SIZE, 1.0));
    Box::new(Meshes { color, depth, mesh: Arc::default(), matrices: Vec::new() })
}

impl Painter<Sight> for Meshes {
    fn name(&self) -> &'static str {
        "euc 0.5.3"
    }

    fn take(&mut self, sight: &Sight) {
        (self.mesh, self.matrices) = (Arc::clone(&sight.mesh), sight.rounded_matrices());
    }

    fn draw(&mut self) {
        for matrix in &self.matrices {
            self.color.clear(0);
            self.depth.clear(1.0);
            Shader { matrix: *matrix, mesh: &self.mesh }.draw::<rasterizer::Triangles<'_, _>, _>(
                self.mesh.triangles.as_flattened(),
                &mut self.color,
                Some(&mut self.depth),
            );
        }
    }

    fn colors(&self) -> Vec<u32> {
        self.color.as_ref().to_vec()
    }
}
