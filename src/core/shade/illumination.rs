//! What lights a draw of a scene: its lights, its material, and the eye that sees it.
//!
//! *Source:* Gouraud, Continuous Shading of Curved Surfaces, 1971 (a brightness at each vertex); Bouknight,
//! A Procedure for Generation of Three-dimensional Half-toned Computer Graphics Presentations, 1970 (one
//! for each face). Deviation: a face is lit at its centroid, on the side that the eye sees, and has no
//! highlight.

use super::{
    Brightness, Light, Material, Mistake, NormalMatrix, Place, Surface,
    lighting::{self, Vector, brightness_traced, unit},
    normals::face_normal,
};
use crate::{
    trace::{NoTrace, Tracer},
    transform::{Camera, Matrix, Projection},
};
use std::sync::Arc;

/// Eye, lights and material of a draw, in world space.
#[derive(Clone, Debug, PartialEq)]
pub struct Illumination {
    /// Where it is seen from.
    pub eye: Place,
    /// At least one.
    pub lights: Arc<[Light]>,
    /// How the surface answers.
    pub material: Material,
}

impl Illumination {
    /// Without lights one stands in the eye.
    pub fn new(camera: &Camera, lights: &[Light], material: Material) -> Self {
        let eye = match camera.projection {
            Projection::Perspective { .. } => Place::Position(camera.eye),
            Projection::Orthographic { .. } => {
                Place::Direction([0, 1, 2].map(|axis| camera.eye[axis] - camera.target[axis]))
            }
        };
        let in_the_eye = [Light::new(eye)];
        let lights = Arc::from(if lights.is_empty() { &in_the_eye } else { lights });
        Self { eye, lights, material }
    }

    /// What turns normals to world space.
    pub fn normal_matrix(&self, model: &Matrix) -> NormalMatrix {
        match self.material.mistake {
            Mistake::ModelNormals => NormalMatrix::mistaken(model),
            _ => NormalMatrix::new(model),
        }
    }

    /// How bright a point is, by the whole material.
    pub fn at(&self, surface: Surface) -> Brightness {
        self.at_traced(surface, &mut NoTrace)
    }

    /// [`at`](Self::at), step by step.
    pub fn at_traced<T: Tracer<lighting::Event>>(&self, surface: Surface, t: &mut T) -> Brightness {
        let parts = surface.upright::<f64, T>(t);
        brightness_traced(parts, self.eye, &self.lights, &self.material, t)
    }

    /// How bright a pixel is, whose normal is interpolated.
    pub fn at_pixel_traced<T: Tracer<lighting::Event>>(&self, surface: Surface, t: &mut T) -> Brightness {
        if self.material.mistake != Mistake::NotRenormalised {
            return self.at_traced(surface, t);
        }
        t.emit(|| lighting::Event::AsItIs { normal: surface.normal });
        brightness_traced::<f64, T>(surface.parts(), self.eye, &self.lights, &self.material, t)
    }

    /// One factor for a whole face, rounded once; 1 without area.
    pub fn of_face(&self, corners: [[f32; 3]; 3]) -> f32 {
        self.of_face_traced(corners, &mut NoTrace)
    }

    /// [`of_face`](Self::of_face), step by step.
    pub fn of_face_traced<T: Tracer<lighting::Event>>(&self, corners: [[f32; 3]; 3], t: &mut T) -> f32 {
        let normal = face_normal(corners);
        if normal == [0.0; 3] {
            return 1.0;
        }
        let parts = [centroid(corners), unit(normal, Vector::Normal, t)];
        brightness_traced(parts, self.eye, &self.lights, &self.matte(), t).of_white()
    }

    /// The material of a face.
    pub(super) fn matte(&self) -> Material {
        Material { specular: 0.0, two_sided: true, ..self.material }
    }
}

/// The middle of a face.
pub(super) fn centroid([a, b, c]: [[f32; 3]; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| (f64::from(a[axis]) + f64::from(b[axis]) + f64::from(c[axis])) / 3.0)
}
