//! Lines of one pixel's width: which pixels a segment draws.
//!
//! Coordinates are pixels, centres at + 0.5, y down. [`dda`] and [`bresenham`] move both ends to the centres
//! of their pixels first and draw one pixel for each column, or for each row if the segment is steep: the one
//! whose centre is nearest to it, of two that are equally near the right or lower one. So in exact arithmetic
//! both draw the same pixels, from either end. [`diamond_exit`] rounds nothing and leaves out the pixel in
//! which the segment ends, so that lines which follow each other draw each pixel of a straight line once.

pub mod bresenham;
pub mod dda;
pub mod diamond_exit;
mod picture;

use crate::math::{Arithmetic, Tally};

/// Both ends, in pixels.
pub type Segment = [[f32; 2]; 2];

/// A pixel: column and row, on or off the image.
pub type Pixel = [i32; 2];

/// Ends farther from the origin than this, in pixels, are for a clipper: these algorithms walk the whole line.
pub const FARTHEST: i32 = 1 << 16;

/// The algorithms that draw a line.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Algorithm {
    /// A slope, added and rounded: [`dda`].
    Dda,
    /// One whole number that decides: [`bresenham`].
    #[default]
    Bresenham,
    /// The diamonds that the segment leaves: [`diamond_exit`].
    DiamondExit,
}

impl Algorithm {
    /// Every algorithm.
    pub const ALL: [Self; 3] = [Self::Dda, Self::Bresenham, Self::DiamondExit];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Dda => "dda",
            Self::Bresenham => "bresenham",
            Self::DiamondExit => "diamond-exit",
        }
    }

    /// What it can compute in. Fixed point is for triangles.
    pub fn arithmetics(self) -> &'static [Arithmetic] {
        match self {
            Self::Dda => &[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64],
            Self::Bresenham | Self::DiamondExit => &[Arithmetic::Exact],
        }
    }
}

/// The pixels of the image that a segment draws, from its first end to its second.
///
/// Any finite ends; for [`Algorithm::Dda`] and [`Algorithm::Bresenham`] those beyond [`FARTHEST`] are taken
/// there. Cost: a few ns for each pixel of the line; of a diamond-exit line only those in the image count.
pub fn pixels(
    algorithm: Algorithm,
    ends: Segment,
    size: [u32; 2],
    arithmetic: Arithmetic,
    tally: &mut Tally,
) -> Vec<[u32; 2]> {
    let mut out = Vec::new();
    let mut emit = |pixel| out.push(pixel);
    match algorithm {
        Algorithm::Dda => dda::draw(ends.map(pixel_of), size, arithmetic, &mut emit),
        Algorithm::Bresenham => bresenham::draw(ends.map(pixel_of), size, &mut emit),
        Algorithm::DiamondExit => diamond_exit::draw(ends, size, tally, &mut emit),
    }
    out
}

/// The pixel that holds a point; one beyond [`FARTHEST`] is taken there.
pub fn pixel_of(at: [f32; 2]) -> Pixel {
    // Whole and small, so nothing is lost.
    at.map(|x| x.floor().clamp(-FARTHEST as f32, FARTHEST as f32) as i32)
}

/// The pixel in the image, if it is there.
fn on_image(pixel: Pixel, size: [u32; 2]) -> Option<[u32; 2]> {
    let [Ok(x), Ok(y)] = pixel.map(u32::try_from) else { return None };
    (x < size[0] && y < size[1]).then_some([x, y])
}

/// The axis along which a line between two pixels is longer: 0 for x, also if it is diagonal.
fn major_axis([a, b]: [Pixel; 2]) -> usize {
    usize::from(a[1].abs_diff(b[1]) > a[0].abs_diff(b[0]))
}
