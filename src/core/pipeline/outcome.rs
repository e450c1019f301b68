//! What the history of a pixel is made of.

use super::visible::Removed;
use crate::{
    clip::polygon::Plane,
    cull::Facing,
    raster::{Samples, Scissor},
};

/// What became of a triangle at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// Its object lies outside a plane of the frustum.
    ObjectOutside(Plane),
    /// It lies outside a plane of the frustum.
    Outside(Plane),
    /// It is culled for its facing, or degenerate.
    Culled {
        /// Its facing.
        facing: Facing,
        /// The determinant of its (x, y, w) before clipping, whose sign is the facing.
        determinant: f64,
        /// Whether it would have covered the pixel: one of its samples.
        would_cover: bool,
    },
    /// Nothing is left of it after clipping.
    ClippedAway(Removed),
    /// A plane cut off the part of it that is seen here.
    CutOff(Plane),
    /// It has no area on the screen: rounding made it so.
    ZeroArea,
    /// The centre lies outside an edge.
    OutsideEdge {
        /// Which edge, from 0.
        edge: u8,
        /// The edge function there, negative.
        value: f64,
    },
    /// The centre lies on an edge, and the fill rule gives it to the neighbour.
    LostTie {
        /// Which edge, from 0.
        edge: u8,
    },
    /// It covers none of several samples, though the centre lies in it or on an edge.
    NoSample,
    /// The scissor rectangle of its draw does not hold the pixel.
    Scissored(Scissor),
    /// The alpha test discarded it.
    Discarded {
        /// Its alpha, rounded.
        alpha: f32,
    },
    /// The stencil test failed.
    Stencil {
        /// The stored value before and after.
        stored: [u8; 2],
    },
    /// The depth test failed.
    Depth {
        /// The fragment's code.
        new: u32,
        /// The stored code.
        stored: u32,
        /// The stencil value before and after.
        stencil: [u8; 2],
    },
    /// It was written.
    Written {
        /// The fragment's depth code, if the draw tests depth.
        depth: Option<u32>,
        /// The depth code stored before.
        stored: u32,
        /// Colour codes before and after.
        color: [[u8; 4]; 2],
        /// The stencil value before and after.
        stencil: [u8; 2],
        /// What later fragments did to it.
        later: Later,
    },
}

/// What became of a written fragment's colour later; the least first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Later {
    /// A later fragment replaced it.
    Overwritten,
    /// Later fragments were blended over it.
    BlendedOver,
    /// It is what the pixel shows.
    Shown,
}

/// One triangle, or one piece of it, at a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelEntry {
    /// What it is called: `A`, `A.1`.
    pub name: String,
    /// Which draw.
    pub draw: usize,
    /// Which triangle of its mesh; `None` for the whole object.
    pub triangle: Option<u32>,
    /// Which part of it, if clipping left several.
    pub part: Option<u32>,
    /// What became of it; of several samples, that of the one where it came farthest.
    pub outcome: Outcome,
    /// What became of it at each sample that it covers, if it came as far as the tests.
    pub samples: Vec<SampleEntry>,
    /// Where it is shaded, if it is: x and y in pixels.
    pub at: Option<[f32; 2]>,
    /// What its colour was before it was blended or rounded, if it was written.
    pub source: Option<[f32; 4]>,
}

/// One triangle at one sample of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleEntry {
    /// Which sample, from 0.
    pub sample: u8,
    /// What became of it there.
    pub outcome: Outcome,
    /// What its depth is made of, if a bias or the planes change it.
    pub placed: Option<Placed>,
}

/// A fragment's depth before and with its bias; in binary64, to be shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The depth of the triangle's plane.
    pub plane: f64,
    /// What is added.
    pub bias: f64,
}

/// All that happened at one pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct PixelHistory {
    /// Column and row.
    pub pixel: [u32; 2],
    /// How many samples it has.
    pub samples: Samples,
    /// Colour codes after the clear.
    pub clear_color: [u8; 4],
    /// Depth code after the clear.
    pub clear_depth: u32,
    /// What came, in drawing order.
    pub entries: Vec<PixelEntry>,
    /// Colour codes at the end: the mean of the samples'.
    pub color: [u8; 4],
    /// Depth code at the end, of sample 0.
    pub depth: u32,
    /// Stencil value at the end, of sample 0.
    pub stencil: u8,
}
