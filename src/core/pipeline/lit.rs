//! What the vertex stage makes of light, and what it hands on to the fragment stage.

use super::Point;
use crate::{
    scene::{Mesh, Shade},
    shade::{Illumination, Surface, smooth_normals},
    transform::Matrix,
};
use std::sync::Arc;

/// The light on a draw, as far as it is known before there are pixels; empty if it is not shaded.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lit {
    /// One factor for each triangle: flat.
    pub factors: Vec<f32>,
    /// One colour for each vertex: Gouraud.
    pub colors: Vec<[f32; 4]>,
    /// One normal for each vertex in world space, of any length: Gouraud and Phong.
    pub normals: Vec<[f32; 3]>,
    /// The place of each vertex in world space: Phong.
    pub places: Vec<[f32; 3]>,
    /// What pixels are lit by: Phong.
    pub illumination: Option<Arc<Illumination>>,
}

impl Lit {
    /// Of vertices in world space; nothing if there are none. Linear in the mesh.
    pub(super) fn new(
        shade: Shade,
        mesh: &Mesh,
        model: &Matrix,
        world: &[Point],
        illumination: &Illumination,
    ) -> Self {
        if shade == Shade::None || world.is_empty() {
            return Self::default();
        }
        let places: Vec<_> = world.iter().map(|&[x, y, z, _]| [x, y, z]).collect();
        if shade == Shade::Flat {
            let face = |triangle: &[u32; 3]| illumination.of_face(triangle.map(|i| places[i as usize]));
            return Self { factors: mesh.triangles.iter().map(face).collect(), ..Self::default() };
        }
        let matrix = illumination.normal_matrix(model);
        let turned = |normals: &[[f32; 3]]| normals.iter().map(|normal| matrix.apply(*normal)).collect();
        let normals: Vec<_> =
            if mesh.normals.is_empty() { turned(&smooth_normals(mesh)) } else { turned(&mesh.normals) };
        if shade == Shade::Phong {
            let illumination = Some(Arc::new(illumination.clone()));
            return Self { normals, places, illumination, ..Self::default() };
        }
        let vertices = places.iter().zip(&normals).zip(&mesh.colors);
        let colors = vertices
            .map(|((&position, &normal), &color)| illumination.at(Surface { position, normal }).of(color));
        Self { colors: colors.collect(), normals, ..Self::default() }
    }
}

/// What is interpolated over each triangle, one value for each vertex or none at all.
#[derive(Clone, Copy, Debug)]
pub(super) struct Varyings<'m> {
    pub(super) triangles: &'m [[u32; 3]],
    pub(super) colors: &'m [[f32; 4]],
    pub(super) uvs: &'m [[f32; 2]],
    /// Normals and places in world space, where pixels are lit.
    pub(super) normals: &'m [[f32; 3]],
    pub(super) places: &'m [[f32; 3]],
}

impl<'m> Varyings<'m> {
    pub(super) fn new(mesh: &'m Mesh, lit: &'m Lit) -> Self {
        let Mesh { triangles, colors, uvs, .. } = mesh;
        let colors = if lit.colors.is_empty() { colors } else { &lit.colors };
        let pixels = lit.illumination.is_some();
        Self { triangles, colors, uvs, normals: if pixels { &lit.normals } else { &[] }, places: &lit.places }
    }
}
