//! Wavefront OBJ models, from bytes.
//!
//! The parser is tobj. It names no line, gives up on one byte that is not UTF-8 and can overflow on
//! a hostile index; so one cheap pass ([`check`]) reads every statement first and names the first
//! bad line, and tobj is fed (by [`statements`]) only what that pass has seen: `v`, `vt`, `vn` and
//! `f`, without comments. Groups and materials never reach it, so all of them become one mesh with
//! shared vertices, and no other file is ever asked for.

mod check;
mod error;
mod statements;

pub use error::{ObjError, ObjProblem};

use super::document::{DEFAULT_COLOR, Mesh};
use check::check;
use statements::feed;
use tobj::{LoadError, LoadOptions, load_obj_buf};

impl Mesh {
    /// Reads an OBJ file, in its own space and units.
    ///
    /// Polygons become fans of triangles about their first corner (right for convex ones),
    /// degenerate faces included. Vertices that differ in position, texture coordinates or normal
    /// are told apart, in the order of their first use; those of no face are left out. Texture
    /// coordinates or normals are kept if every corner has them. Colours after the position are
    /// kept; without them all vertices are white. Lines, points, curves, groups and materials are
    /// ignored. Cost: linear, in time and memory.
    ///
    /// # Errors
    /// The first bad line and what is wrong with it; or that there are no faces.
    pub fn from_obj(bytes: &[u8]) -> Result<Self, ObjError> {
        check(bytes)?;
        let options = LoadOptions { triangulate: true, single_index: true, ..LoadOptions::default() };
        let no_materials = |_: &std::path::Path| Err(LoadError::OpenFileFailed);
        let (models, _) = load_obj_buf(&mut feed(bytes), &options, no_materials)
            .map_err(|error| ObjError::whole(ObjProblem::Refused { what: error.to_string() }))?;
        // Without groups there is exactly one.
        let raw = models.into_iter().next().map(|model| model.mesh).unwrap_or_default();
        let positions = rows(&raw.positions);
        let each = |count: usize| count == positions.len();
        let uvs: Vec<[f32; 2]> = rows(&raw.texcoords);
        let normals: Vec<[f32; 3]> = rows(&raw.normals);
        let colors: Vec<[f32; 3]> = rows(&raw.vertex_color);
        Ok(Self {
            triangles: rows(&raw.indices),
            colors: if each(colors.len()) {
                colors.into_iter().map(|[r, g, b]| [r, g, b, 1.0]).collect()
            } else {
                vec![DEFAULT_COLOR; positions.len()]
            },
            uvs: if each(uvs.len()) { uvs } else { Vec::new() },
            normals: if each(normals.len()) { normals } else { Vec::new() },
            positions,
        })
    }
}

fn rows<const N: usize, T: Copy>(flat: &[T]) -> Vec<[T; N]> {
    flat.as_chunks().0.to_vec()
}
