//! What no single field can tell: ranges, counts and combinations.
//!
//! Works on the document, so that an edited scene is held to the same rules as a file.

use super::{
    document::{Draw, Geometry, Mesh, Scene, Texture, Transform},
    error::{Problem, SceneError},
    path::{FieldError, Step},
};
use crate::{
    blend::AlphaTest,
    compare::Setting,
    depth::DepthBias,
    raster::{Samples, Scissor},
    transform::{Camera, Projection},
};

/// Largest width and height of an image.
pub const MAX_SIDE: u32 = 16384;
/// Largest number of pixels of an image.
pub const MAX_PIXELS: u32 = 1 << 28;

/// Whether a part of the document makes sense; else the path of its first bad field.
pub(crate) type Checked = Result<(), FieldError>;

impl Scene {
    /// Whether the scene makes sense. Cost: linear in its numbers.
    ///
    /// # Errors
    /// The path of the first bad field, in the order of the file.
    pub fn validate(&self) -> Result<(), SceneError> {
        self.check().map_err(SceneError::from)
    }

    fn check(&self) -> Checked {
        let [width, height] = self.size;
        for (i, side) in [width, height].into_iter().enumerate() {
            if !(1..=MAX_SIDE).contains(&side) {
                let range = Problem::Range { min: 1.0, max: f64::from(MAX_SIDE) };
                return Err(FieldError::at(i, range).within("size"));
            }
        }
        // Both sides are at most 2^14, so the product cannot overflow.
        refuse_if(width * height > MAX_PIXELS, "size", Problem::TooManyPixels { limit: MAX_PIXELS })?;
        each_in_unit(&self.clear.color).map_err(|e| e.within("color").within("clear"))?;
        unit(self.clear.depth).map_err(|e| e.within("depth").within("clear"))?;
        camera(&self.camera).map_err(|e| e.within("camera"))?;
        refuse_if(Samples::try_from(self.samples).is_err(), "samples", Problem::Samples)?;
        let limit = MAX_PIXELS / self.samples;
        refuse_if(width * height > limit, "size", Problem::TooManyPixels { limit })?;
        for (i, light) in self.lights.iter().enumerate() {
            light.check().map_err(|e| e.within(i).within("lights"))?;
        }
        for (i, item) in self.draws.iter().enumerate() {
            draw(item).map_err(|e| e.within(i).within("draws"))?;
        }
        match &self.lab {
            Some(lab) => {
                lab.input.check(self).and_then(|()| self.compare(lab.compare)).map_err(|e| e.within("lab"))
            }
            None => Ok(()),
        }
    }

    /// Refuses a setting that the open lab does not read, or a value that it cannot have there.
    fn compare(&self, setting: Option<Setting>) -> Checked {
        let Some(setting) = setting.filter(|setting| !setting.applies(self)) else { return Ok(()) };
        let (known, fields) = setting.known(self);
        let problem = if known.is_empty() {
            Problem::UnknownField { known: fields }
        } else {
            Problem::UnknownName { name: setting.name().into(), known }
        };
        Err(FieldError::at(setting.field(), problem).within("compare"))
    }
}

/// Refuses a field that is wrong.
pub(crate) fn refuse_if(wrong: bool, field: &str, problem: Problem) -> Checked {
    if wrong { Err(FieldError::at(field, problem)) } else { Ok(()) }
}

fn finite(value: f32) -> Checked {
    if value.is_finite() { Ok(()) } else { Err(FieldError::here(Problem::NotFinite)) }
}

fn unit(value: f32) -> Checked {
    finite(value)?;
    if (0.0..=1.0).contains(&value) {
        Ok(())
    } else {
        Err(FieldError::here(Problem::Range { min: 0.0, max: 1.0 }))
    }
}

fn each(values: &[f32], check: fn(f32) -> Checked) -> Checked {
    values.iter().enumerate().try_for_each(|(i, value)| check(*value).map_err(|e| e.within(i)))
}

/// Whether all values are finite.
pub(crate) fn each_finite(values: &[f32]) -> Checked {
    each(values, finite)
}

/// Whether all values lie in 0..=1, as colours must.
pub(crate) fn each_in_unit(values: &[f32]) -> Checked {
    each(values, unit)
}

/// Whether all values of a list of points are finite.
pub(crate) fn each_row_finite<const N: usize>(
    field: impl Into<Step> + Clone,
    points: &[[f32; N]],
) -> Checked {
    points
        .iter()
        .enumerate()
        .try_for_each(|(i, point)| each_finite(point).map_err(|e| e.within(i).within(field.clone())))
}

fn rows<const N: usize>(field: &str, rows: &[[f32; N]], check: fn(f32) -> Checked) -> Checked {
    rows.iter().enumerate().try_for_each(|(i, row)| each(row, check).map_err(|e| e.within(i).within(field)))
}

fn camera(camera: &Camera) -> Checked {
    for (field, vector) in [("eye", camera.eye), ("target", camera.target), ("up", camera.up)] {
        each_finite(&vector).map_err(|e| e.within(field))?;
    }
    let [eye, target, up] = [camera.eye, camera.target, camera.up].map(|v| v.map(f64::from));
    refuse_if(eye == target, "target", Problem::EyeIsTarget)?;
    // Scaled to 1 so that no product vanishes or overflows.
    let along = scaled([0, 1, 2].map(|i| target[i] - eye[i]));
    let up = scaled(up);
    let cross = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| along[i] * up[j] - along[j] * up[i]);
    refuse_if(cross == [0.0; 3], "up", Problem::UpParallel)?;
    finite(camera.near).map_err(|e| e.within("near"))?;
    finite(camera.far).map_err(|e| e.within("far"))?;
    match camera.projection {
        Projection::Perspective { fovy_degrees } => {
            refuse_if(camera.near <= 0.0, "near", Problem::NotPositive)?;
            let wrong = !(fovy_degrees > 0.0 && fovy_degrees < 180.0);
            refuse_if(wrong, "fovy_degrees", Problem::FieldOfView).map_err(|e| e.within("projection"))?;
        }
        Projection::Orthographic { height } => {
            finite(height)
                .and_then(
                    |()| if height > 0.0 { Ok(()) } else { Err(FieldError::here(Problem::NotPositive)) },
                )
                .map_err(|e| e.within("height").within("projection"))?;
        }
    }
    refuse_if(camera.far <= camera.near, "far", Problem::FarBeforeNear)
}

/// The vector divided by its largest component; zero stays zero.
fn scaled(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest > 0.0 { vector.map(|x| x / largest) } else { vector }
}

fn draw(draw: &Draw) -> Checked {
    match &draw.geometry {
        Geometry::Mesh(mesh) => check_mesh(mesh)?,
        Geometry::Model { file, color, .. } => {
            refuse_if(file.is_empty() || file.contains('\0'), "model", Problem::NoFileName)?;
            if let Some(color) = color {
                each_in_unit(color).map_err(|e| e.within("color"))?;
            }
        }
    }
    let parts: &[(&str, &[f32])] = match &draw.transform {
        Transform::Parts { translate, rotate_degrees, scale } => {
            &[("translate", translate), ("rotate_degrees", rotate_degrees), ("scale", scale)]
        }
        Transform::Matrix(matrix) => &[("matrix", matrix)],
    };
    for (field, values) in parts {
        each_finite(values).map_err(|e| e.within(*field).within("transform"))?;
    }
    draw.material.check().map_err(|e| e.within("material"))?;
    check_bias(draw.placement.bias).map_err(|e| e.within("bias").within("depth"))?;
    check_cut(draw.scissor, draw.alpha_test)?;
    let constant = draw.blend.map_or([0.0; 4], |blend| blend.constant);
    each_in_unit(&constant).map_err(|e| e.within("constant").within("blend"))?;
    if let Some(Texture::Checker { squares }) = draw.texture {
        refuse_if(squares == 0, "squares", Problem::NotPositive).map_err(|e| e.within("texture"))?;
        let bare = draw.geometry.mesh().is_some_and(|mesh| mesh.uvs.is_empty() && !mesh.triangles.is_empty());
        refuse_if(bare, "texture", Problem::NoTextureCoordinates)?;
    }
    Ok(())
}

/// Whether a bias is a number.
pub(crate) fn check_bias(bias: DepthBias) -> Checked {
    let numbers = [("slope", bias.slope), ("clamp", bias.clamp)];
    numbers.into_iter().try_for_each(|(field, value)| finite(value).map_err(|e| e.within(field)))
}

/// Whether what keeps fragments from the tests makes sense.
pub(crate) fn check_cut(scissor: Option<Scissor>, alpha_test: Option<AlphaTest>) -> Checked {
    for (i, side) in scissor.map_or([0; 4], <[u32; 4]>::from).into_iter().enumerate() {
        if side > MAX_SIDE {
            let range = Problem::Range { min: 0.0, max: f64::from(MAX_SIDE) };
            return Err(FieldError::at(i, range).within("scissor"));
        }
    }
    let reference = alpha_test.map_or(0.0, |test| test.reference);
    unit(reference).map_err(|e| e.within("reference").within("alpha_test"))
}

fn check_mesh(mesh: &Mesh) -> Checked {
    rows("vertices", &mesh.positions, finite)?;
    let vertices = mesh.positions.len();
    for (i, triangle) in mesh.triangles.iter().enumerate() {
        for (j, index) in triangle.iter().copied().enumerate() {
            if usize::try_from(index).map_or(true, |index| index >= vertices) {
                let problem = Problem::NoSuchVertex { index, vertices };
                return Err(FieldError::at(j, problem).within(i).within("indices"));
            }
        }
    }
    let counts = [
        ("colors", mesh.colors.len(), true),
        ("uvs", mesh.uvs.len(), !mesh.uvs.is_empty()),
        ("normals", mesh.normals.len(), !mesh.normals.is_empty()),
    ];
    for (field, found, there) in counts {
        refuse_if(there && found != vertices, field, Problem::NotOneEach { found, vertices })?;
    }
    rows("colors", &mesh.colors, unit)?;
    rows("uvs", &mesh.uvs, finite)?;
    rows("normals", &mesh.normals, finite)
}
