//! Where the samples of a pixel lie, and which of them a triangle covers.
//!
//! *Source:* Direct3D 11.3 functional specification, section 19.2.4.1 (standard multisample quality pattern):
//! positions in sixteenths of a pixel.

use super::{Edges, Settings, YAxis};
use crate::math::Tally;
use serde::{Deserialize, Serialize};

/// How many samples a pixel has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "u32", into = "u32")]
pub enum Samples {
    /// The centre alone.
    #[default]
    One,
    /// On a diagonal.
    Two,
    /// On a turned square.
    Four,
    /// No two in a row or a column of the 16 x 16 grid.
    Eight,
}

/// No standard pattern has this number of samples.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("error-scene-samples")]
pub struct NoPattern;

impl TryFrom<u32> for Samples {
    type Error = NoPattern;

    fn try_from(count: u32) -> Result<Self, NoPattern> {
        Self::ALL.into_iter().find(|samples| samples.count() == count).ok_or(NoPattern)
    }
}

impl From<Samples> for u32 {
    fn from(samples: Samples) -> Self {
        samples.count()
    }
}

impl Samples {
    /// All patterns, the default first.
    pub const ALL: [Self; 4] = [Self::One, Self::Two, Self::Four, Self::Eight];
    /// The most samples that a pixel has.
    pub const MOST: usize = 8;

    /// How many samples.
    #[inline]
    pub fn count(self) -> u32 {
        1 << self as u32
    }

    /// Each sample's distance from the pixel's centre in sixteenths of a pixel, x to the right and y down.
    pub fn offsets(self) -> &'static [[i8; 2]] {
        match self {
            Self::One => &[[0, 0]],
            Self::Two => &[[4, 4], [-4, -4]],
            Self::Four => &[[-2, -6], [6, -2], [-6, 2], [2, 6]],
            Self::Eight => &[[1, -3], [-1, 3], [5, 1], [-3, -5], [-5, 5], [-7, -1], [3, 7], [7, -7]],
        }
    }

    /// Where a sample of a pixel lies, in pixels; exact for every image. Where y points up the pattern is
    /// turned over, so that the picture is the same.
    #[inline]
    pub fn point(self, [x, y]: [u32; 2], index: usize, y_axis: YAxis) -> [f32; 2] {
        let [dx, dy] = self.offsets()[index].map(|sixteenths| 0.5 + f32::from(sixteenths) / 16.0);
        let dy = if y_axis == YAxis::Down { dy } else { 1.0 - dy };
        [x as f32 + dx, y as f32 + dy]
    }

    /// The mask of all samples.
    pub fn full(self) -> u8 {
        u8::MAX >> (Self::MOST as u32 - self.count())
    }

    /// The samples of a pixel that lie inside, the first one in the lowest bit.
    #[inline]
    pub fn mask(self, edges: &Edges, pixel: [u32; 2], y_axis: YAxis, tally: &mut Tally) -> u8 {
        let mut mask = 0;
        for index in 0..self.count() {
            let covered = edges.cover(self.point(pixel, index as usize, y_axis), tally);
            mask |= u8::from(covered) << index;
        }
        mask
    }

    /// The mean of the first codes, rounded to the nearest; halves go up.
    pub fn resolve(self, codes: &[u8; Self::MOST]) -> u8 {
        let count = self.count();
        let sum: u32 = codes[..count as usize].iter().map(|code| u32::from(*code)).sum();
        ((2 * sum + count) / (2 * count)) as u8
    }
}

/// Finds the pixels of which a triangle covers a sample, row by row, with their masks; returns how many
/// samples are covered.
///
/// Contract as of [`cover`](super::cover), with each sample in the place of the centre: so the neighbours
/// of a mesh share the samples of a pixel, none twice and none left out. Cost: up to three signs a sample
/// of the bounding box, 1 to 2 ns each.
pub fn cover_samples(
    vertices: [[f32; 2]; 3],
    samples: Samples,
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut([u32; 2], u8),
) -> u64 {
    let vertices = settings.vertices(vertices);
    let Some(edges) = Edges::new(vertices, settings, tally) else { return 0 };
    let [columns, rows] = pixel_box(vertices, settings.size);
    let mut count = 0;
    for y in rows {
        let mut drawn = false;
        for x in columns.clone() {
            let mask = samples.mask(&edges, [x, y], settings.y_axis, tally);
            if mask != 0 {
                drawn = true;
                count += u64::from(mask.count_ones());
                emit([x, y], mask);
            } else if drawn && settings.skip_row && samples == Samples::One {
                // Of one sample the row is one span; several samples may leave gaps between slivers.
                break;
            }
        }
    }
    count
}

/// The pixels of the image that the bounding box touches: columns, then rows.
pub(crate) fn pixel_box(vertices: [[f32; 2]; 3], size: [u32; 2]) -> [std::ops::Range<u32>; 2] {
    [0, 1].map(|axis| {
        let [a, b, c] = vertices.map(|vertex| vertex[axis]);
        // `as` saturates, so far off the image is still off the image.
        let first = a.min(b).min(c).floor() as u32;
        let end = (a.max(b).max(c).floor() as i64).saturating_add(1).clamp(0, size[axis].into()) as u32;
        first.min(end)..end
    })
}
