//! One draw of a scene file.

use super::super::{
    document::{DEFAULT_COLOR, Draw, Geometry, Mesh, Shade, Texture, Transform, consecutive},
    error::Problem,
    path::FieldError,
    validate::each_in_unit,
};
use super::depth::DepthWire;
use crate::{
    blend::{AlphaTest, BlendState},
    cull::{CullMode, FrontFace},
    raster::Scissor,
    shade::Material,
    stencil::StencilState,
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct DrawWire {
    #[serde(skip_serializing_if = "String::is_empty")]
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    model: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<[f32; 3]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    indices: Option<Vec<[u32; 3]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    color: Option<[f32; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    colors: Option<Vec<[f32; 4]>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    uvs: Vec<[f32; 2]>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    normals: Vec<[f32; 3]>,
    #[serde(skip_serializing_if = "is_default")]
    transform: TransformWire,
    #[serde(skip_serializing_if = "is_default")]
    cull: CullMode,
    #[serde(skip_serializing_if = "is_default")]
    front: FrontFace,
    #[serde(skip_serializing_if = "is_default")]
    depth: DepthWire,
    #[serde(skip_serializing_if = "Option::is_none")]
    scissor: Option<Scissor>,
    #[serde(skip_serializing_if = "Option::is_none")]
    alpha_test: Option<AlphaTest>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stencil: Option<StencilState>,
    #[serde(skip_serializing_if = "Option::is_none")]
    blend: Option<BlendState>,
    #[serde(skip_serializing_if = "Option::is_none")]
    texture: Option<TextureWire>,
    #[serde(skip_serializing_if = "is_default")]
    shade: Shade,
    #[serde(skip_serializing_if = "is_default")]
    material: Material,
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

impl DrawWire {
    pub(super) fn into_draw(self) -> Result<Draw, FieldError> {
        let geometry = geometry(
            self.model,
            MeshWire {
                vertices: self.vertices,
                indices: self.indices,
                color: self.color,
                colors: self.colors,
                uvs: self.uvs,
                normals: self.normals,
            },
        )?;
        Ok(Draw {
            name: self.name,
            geometry,
            transform: self.transform.into_transform().map_err(|e| e.within("transform"))?,
            cull: self.cull,
            front: self.front,
            depth: self.depth.state(),
            placement: self.depth.placement(),
            scissor: self.scissor,
            alpha_test: self.alpha_test,
            stencil: self.stencil,
            blend: self.blend,
            texture: self
                .texture
                .map(|TextureWire { kind: TextureKind::Checker, squares }| Texture::Checker { squares }),
            shade: self.shade,
            material: self.material,
        })
    }
}

impl From<&Draw> for DrawWire {
    fn from(draw: &Draw) -> Self {
        let wire = match &draw.geometry {
            Geometry::Model { file, color, .. } => {
                Self { model: Some(file.clone()), color: *color, ..Self::default() }
            }
            Geometry::Mesh(mesh) => {
                let first = mesh.colors.first().copied().unwrap_or(DEFAULT_COLOR);
                let plain = mesh.colors.iter().all(|color| *color == first);
                let listed = mesh.triangles != consecutive(mesh.positions.len());
                Self {
                    vertices: Some(mesh.positions.clone()),
                    indices: listed.then(|| mesh.triangles.clone()),
                    color: (plain && first != DEFAULT_COLOR).then_some(first),
                    colors: (!plain).then(|| mesh.colors.clone()),
                    uvs: mesh.uvs.clone(),
                    normals: mesh.normals.clone(),
                    ..Self::default()
                }
            }
        };
        Self {
            name: draw.name.clone(),
            transform: TransformWire::from(draw.transform),
            cull: draw.cull,
            front: draw.front,
            depth: DepthWire::new(draw.depth, draw.placement),
            scissor: draw.scissor,
            alpha_test: draw.alpha_test,
            stencil: draw.stencil,
            blend: draw.blend,
            texture: draw
                .texture
                .map(|Texture::Checker { squares }| TextureWire { kind: TextureKind::Checker, squares }),
            shade: draw.shade,
            material: draw.material,
            ..wire
        }
    }
}

/// The fields of a draw that make up its mesh.
struct MeshWire {
    vertices: Option<Vec<[f32; 3]>>,
    indices: Option<Vec<[u32; 3]>>,
    color: Option<[f32; 4]>,
    colors: Option<Vec<[f32; 4]>>,
    uvs: Vec<[f32; 2]>,
    normals: Vec<[f32; 3]>,
}

fn geometry(model: Option<String>, mesh: MeshWire) -> Result<Geometry, FieldError> {
    let both = |field: &'static str, other| FieldError::at(field, Problem::Both { other });
    let Some(file) = model else { return Ok(Geometry::Mesh(Arc::new(mesh.into_mesh()?))) };
    let own = [
        ("vertices", mesh.vertices.is_some()),
        ("indices", mesh.indices.is_some()),
        ("colors", mesh.colors.is_some()),
        ("uvs", !mesh.uvs.is_empty()),
        ("normals", !mesh.normals.is_empty()),
    ];
    match own.into_iter().find(|(_, there)| *there) {
        Some((field, _)) => Err(both(field, "model")),
        None => Ok(Geometry::Model { file, color: mesh.color, mesh: None }),
    }
}

impl MeshWire {
    fn into_mesh(self) -> Result<Mesh, FieldError> {
        if let Some(color) = &self.color {
            each_in_unit(color).map_err(|e| e.within("color"))?;
        }
        let positions = self.vertices.ok_or_else(|| FieldError::at("vertices", Problem::Missing))?;
        let colors = match (self.color, self.colors) {
            (Some(_), Some(_)) => {
                return Err(FieldError::at("colors", Problem::Both { other: "color" }));
            }
            (None, Some(colors)) => colors,
            (color, None) => vec![color.unwrap_or(DEFAULT_COLOR); positions.len()],
        };
        let triangles = match self.indices {
            Some(indices) => indices,
            None if positions.len() % 3 == 0 => consecutive(positions.len()),
            None => {
                return Err(FieldError::at("vertices", Problem::NotTriples { found: positions.len() }));
            }
        };
        Ok(Mesh { positions, triangles, colors, uvs: self.uvs, normals: self.normals })
    }
}

#[derive(Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct TransformWire {
    #[serde(skip_serializing_if = "Option::is_none")]
    translate: Option<[f32; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rotate_degrees: Option<[f32; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    scale: Option<[f32; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    matrix: Option<[f32; 16]>,
}

impl TransformWire {
    fn into_transform(self) -> Result<Transform, FieldError> {
        match self {
            Self { matrix: Some(matrix), translate: None, rotate_degrees: None, scale: None } => {
                Ok(Transform::Matrix(matrix))
            }
            Self { matrix: Some(_), translate, rotate_degrees, .. } => {
                let other = match (translate, rotate_degrees) {
                    (Some(_), _) => "translate",
                    (None, Some(_)) => "rotate_degrees",
                    (None, None) => "scale",
                };
                Err(FieldError::at("matrix", Problem::Both { other }))
            }
            Self { matrix: None, translate, rotate_degrees, scale } => Ok(Transform::Parts {
                translate: translate.unwrap_or([0.0; 3]),
                rotate_degrees: rotate_degrees.unwrap_or([0.0; 3]),
                scale: scale.unwrap_or([1.0; 3]),
            }),
        }
    }
}

impl From<Transform> for TransformWire {
    fn from(transform: Transform) -> Self {
        match transform {
            Transform::Parts { translate, rotate_degrees, scale } => Self {
                translate: (translate != [0.0; 3]).then_some(translate),
                rotate_degrees: (rotate_degrees != [0.0; 3]).then_some(rotate_degrees),
                scale: (scale != [1.0; 3]).then_some(scale),
                matrix: None,
            },
            Transform::Matrix(matrix) => Self { matrix: Some(matrix), ..Self::default() },
        }
    }
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct TextureWire {
    kind: TextureKind,
    squares: u32,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum TextureKind {
    Checker,
}
