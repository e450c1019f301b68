//! The document: plain values, one struct for each object of the scene file.

use crate::{
    blend::{AlphaTest, BlendState},
    compare::Setting,
    cull::{CullMode, FrontFace},
    depth::{DepthFormat, DepthPlacement, DepthState},
    labs::LabInput,
    raster::{FillRule, Scissor, YAxis},
    shade::{Light, Material},
    stencil::StencilState,
    transform::{Camera, DepthRange},
};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Everything that determines the image, in drawing order, and the lab that is open.
///
/// World space is right-handed with y up. The document holds no derived data: equal scenes give
/// equal images. Meshes stand behind [`Arc`]s, so that a copy for undo is cheap.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// What the scene is called: text, or the id of a message.
    pub name: String,
    /// One sentence why it matters: text, or the id of a message.
    pub note: String,
    /// Width and height of the image in pixels, each in 1..=16384, together at most 2^28 pixels.
    pub size: [u32; 2],
    /// What colour, depth and stencil hold before the first draw.
    pub clear: Clear,
    /// Where the scene is seen from.
    pub camera: Camera,
    /// Which depths in NDC are visible.
    pub depth_range: DepthRange,
    /// How depths are stored.
    pub depth_format: DepthFormat,
    /// Whether the near plane has depth 1 and the far plane depth 0.
    pub reversed: bool,
    /// Who draws a pixel whose centre lies exactly on an edge.
    pub fill_rule: FillRule,
    /// Samples in each pixel; only 1 so far.
    pub samples: u32,
    /// Which way y grows in screen space.
    pub y_axis: YAxis,
    /// What lights the draws that are shaded; none: one light in the eye.
    pub lights: Vec<Light>,
    /// What is drawn, in this order.
    pub draws: Vec<Draw>,
    /// The lab that the scene opens, with its inputs.
    pub lab: Option<Lab>,
}

impl Scene {
    /// The scene-file version that this program writes, and the newest that it reads.
    pub const VERSION: u32 = 1;

    /// The setting in which side B of a split view differs, if there are two sides.
    pub fn compared(&self) -> Option<Setting> {
        self.lab.as_ref().and_then(|lab| lab.compare)
    }

    /// Whether two scenes differ in nothing but what they are compared with.
    pub fn same_side_a(&self, other: &Self) -> bool {
        let input = |scene: &Self| scene.lab.as_ref().map(|lab| lab.input.clone());
        self.same_picture(other) && input(self) == input(other)
    }

    /// Whether two scenes differ at most in the lab that is open.
    pub fn same_picture(&self, other: &Self) -> bool {
        let Self {
            name,
            note,
            size,
            clear,
            camera,
            depth_range,
            depth_format,
            reversed,
            fill_rule,
            samples,
            y_axis,
            lights,
            draws,
            lab: _, // every other field stands here: a new one is not forgotten
        } = self;
        (name, note, size, clear, camera)
            == (&other.name, &other.note, &other.size, &other.clear, &other.camera)
            && (depth_range, depth_format, reversed)
                == (&other.depth_range, &other.depth_format, &other.reversed)
            && (fill_rule, samples, y_axis) == (&other.fill_rule, &other.samples, &other.y_axis)
            && (lights, draws) == (&other.lights, &other.draws)
    }

    /// A scene that draws nothing, with the defaults of the scene file.
    pub fn empty(size: [u32; 2]) -> Self {
        Self {
            name: String::new(),
            note: String::new(),
            size,
            clear: Clear::default(),
            camera: Camera::default(),
            depth_range: DepthRange::default(),
            depth_format: DepthFormat::default(),
            reversed: false,
            fill_rule: FillRule::default(),
            samples: 1,
            y_axis: YAxis::default(),
            lights: Vec::new(),
            draws: Vec::new(),
            lab: None,
        }
    }
}

/// What colour, depth and stencil hold before the first draw.
///
/// The default colour is transparent black, as in WebGPU: the canvas shows where nothing is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Clear {
    /// Red, green, blue, alpha, each in 0..=1.
    pub color: [f32; 4],
    /// In 0..=1.
    pub depth: f32,
    /// The stencil value.
    pub stencil: u8,
}

impl Default for Clear {
    fn default() -> Self {
        Self { color: [0.0; 4], depth: 1.0, stencil: 0 }
    }
}

/// One mesh with the state that it is drawn with.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    /// Shown on the canvas and in the history of a pixel: `A`, `B`; may be empty.
    pub name: String,
    /// The triangles.
    pub geometry: Geometry,
    /// From object space to world space.
    pub transform: Transform,
    /// Which facing is thrown away.
    pub cull: CullMode,
    /// Which turning sense is the front.
    pub front: FrontFace,
    /// The depth test.
    pub depth: DepthState,
    /// What is added to its depths before that, and whether near and far plane clip.
    pub placement: DepthPlacement,
    /// The pixels that it may draw to; `None` is all of them.
    pub scissor: Option<Scissor>,
    /// Which of its fragments are discarded; `None` is none of them.
    pub alpha_test: Option<AlphaTest>,
    /// The stencil test; `None` leaves the stencil alone.
    pub stencil: Option<StencilState>,
    /// `None` replaces the stored colour.
    pub blend: Option<BlendState>,
    /// Multiplies the colour; needs texture coordinates.
    pub texture: Option<Texture>,
    /// How the colour depends on the direction of the surface.
    pub shade: Shade,
    /// How the surface answers to light, if it is shaded.
    pub material: Material,
}

impl Draw {
    /// A draw of `geometry` where it stands, with the defaults of the scene file.
    pub fn new(name: impl Into<String>, geometry: Geometry) -> Self {
        Self {
            name: name.into(),
            geometry,
            transform: Transform::default(),
            cull: CullMode::default(),
            front: FrontFace::default(),
            depth: DepthState::default(),
            placement: DepthPlacement::default(),
            scissor: None,
            alpha_test: None,
            stencil: None,
            blend: None,
            texture: None,
            shade: Shade::default(),
            material: Material::default(),
        }
    }
}

/// Where a draw's triangles come from.
#[derive(Clone, Debug)]
pub enum Geometry {
    /// They stand in the scene file.
    Mesh(Arc<Mesh>),
    /// They stand in an OBJ file, which the scene file names.
    Model {
        /// As written in the scene file.
        file: String,
        /// Replaces the model's own colours.
        color: Option<[f32; 4]>,
        /// `None` until the scene is resolved; kept out of the scene file.
        mesh: Option<Arc<Mesh>>,
    },
}

/// Equal triangles behind one [`Arc`] are not looked at: scenes are compared in every frame.
impl PartialEq for Geometry {
    fn eq(&self, other: &Self) -> bool {
        let same = |a: &Arc<Mesh>, b: &Arc<Mesh>| Arc::ptr_eq(a, b) || a == b;
        match (self, other) {
            (Self::Mesh(a), Self::Mesh(b)) => same(a, b),
            (Self::Model { file, color, mesh }, Self::Model { file: f, color: c, mesh: m }) => {
                let loaded = match (mesh, m) {
                    (Some(a), Some(b)) => same(a, b),
                    (a, b) => a.is_none() && b.is_none(),
                };
                file == f && color == c && loaded
            }
            _ => false,
        }
    }
}

impl Geometry {
    /// The triangles; `None` for a model that is not loaded.
    pub fn mesh(&self) -> Option<&Arc<Mesh>> {
        match self {
            Self::Mesh(mesh) => Some(mesh),
            Self::Model { mesh, .. } => mesh.as_ref(),
        }
    }
}

/// The colour of a vertex that has none: opaque white.
pub const DEFAULT_COLOR: [f32; 4] = [1.0; 4];

/// Triangles over shared vertices, in object space.
///
/// Every index is less than the number of positions. Degenerate triangles are kept: culling shows
/// them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The vertices, in the order of the file.
    pub positions: Vec<[f32; 3]>,
    /// Three vertices each.
    pub triangles: Vec<[u32; 3]>,
    /// Red, green, blue, alpha in 0..=1, straight alpha, one for each vertex.
    pub colors: Vec<[f32; 4]>,
    /// Texture coordinates, one for each vertex, or none at all.
    pub uvs: Vec<[f32; 2]>,
    /// Normals of any length, one for each vertex, or none at all.
    pub normals: Vec<[f32; 3]>,
}

impl Mesh {
    /// Every three positions are a triangle, all of one colour; a rest of one or two is left out.
    pub fn soup(positions: Vec<[f32; 3]>, color: [f32; 4]) -> Self {
        Self {
            triangles: consecutive(positions.len()),
            colors: vec![color; positions.len()],
            positions,
            uvs: Vec::new(),
            normals: Vec::new(),
        }
    }
}

/// The triangles of a mesh without indices: (0, 1, 2), (3, 4, 5), ...
pub(super) fn consecutive(vertices: usize) -> Vec<[u32; 3]> {
    let whole = u32::try_from(vertices / 3).unwrap_or(u32::MAX / 3);
    (0..whole).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect()
}

/// From object space to world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Transform {
    /// Scaled first, then rotated about x, then y, then z, then moved.
    Parts {
        /// Added last, in world units.
        translate: [f32; 3],
        /// Angles about x, y and z in degrees, counter-clockwise seen against the axis.
        rotate_degrees: [f32; 3],
        /// Factors along x, y and z; a negative one mirrors and so flips the facing.
        scale: [f32; 3],
    },
    /// Any matrix, column by column.
    Matrix([f32; 16]),
}

impl Transform {
    /// Leaves everything where it is.
    pub const IDENTITY: Self = Self::Parts { translate: [0.0; 3], rotate_degrees: [0.0; 3], scale: [1.0; 3] };
}

impl Default for Transform {
    fn default() -> Self {
        Self::IDENTITY
    }
}

/// What multiplies the colour, looked up by texture coordinates: nearest, repeating.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Texture {
    /// Squares of factor 1 and a darker factor by turns; (0, 0) begins a light one.
    Checker {
        /// Squares along each side of the unit square, positive.
        squares: u32,
    },
}

/// How the colour depends on the direction of the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shade {
    /// Not at all: the numbers shown are the numbers stored.
    #[default]
    None,
    /// One factor for each triangle, from its normal, so that a model without colours is readable.
    Flat,
    /// Lit at the vertices, by their normals; the colours are interpolated.
    Gouraud,
    /// Lit at each pixel, by the interpolated normal.
    Phong,
}

impl Shade {
    /// All of them, the default first.
    pub const ALL: [Self; 4] = [Self::None, Self::Flat, Self::Gouraud, Self::Phong];

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Flat => "flat",
            Self::Gouraud => "gouraud",
            Self::Phong => "phong",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::None => "word-shade-none",
            Self::Flat => "word-shade-flat",
            Self::Gouraud => "word-shade-gouraud",
            Self::Phong => "word-shade-phong",
        }
    }
}

/// The lab that a scene opens.
#[derive(Clone, Debug, PartialEq)]
pub struct Lab {
    /// The step at which it opens; `None` is the end.
    pub step: Option<usize>,
    /// Which lab, with its inputs.
    pub input: LabInput,
    /// The setting in which side B of a split view differs; `None` if there is one side only.
    pub compare: Option<Setting>,
}

impl Lab {
    /// A lab that opens at its end, with one side.
    pub fn new(input: impl Into<LabInput>) -> Self {
        Self { step: None, input: input.into(), compare: None }
    }
}
