//! Cases from mild to extreme: what a dial does to ordinary ones.
//!
//! A case is the input of the lab that teaches its operation, so that it opens there as it is.

mod clipped;
mod screen;

use serde::{Deserialize, Serialize};

use super::{Family, Random};
use crate::{labs::LabInput, scene::Scene};

/// What is put under stress.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Operation {
    /// A line against a window.
    LineClipping,
    /// A polygon against a window.
    PolygonClipping,
    /// A triangle against the planes of the frustum.
    TriangleClipping,
    /// The pixels of a triangle.
    #[default]
    Coverage,
    /// The depth along a row of a triangle.
    Depth,
    /// An attribute at a point of a triangle.
    Attributes,
}

impl Operation {
    /// All, in the order of the pipeline.
    pub const ALL: [Self; 6] = [
        Self::LineClipping,
        Self::PolygonClipping,
        Self::TriangleClipping,
        Self::Coverage,
        Self::Depth,
        Self::Attributes,
    ];

    /// The lab that teaches it, step by step.
    pub fn lab(self) -> &'static str {
        match self {
            Self::LineClipping => "cohen-sutherland",
            Self::PolygonClipping => "sutherland-hodgman",
            Self::TriangleClipping => "clip-triangle",
            Self::Coverage => "scanline",
            Self::Depth => "plane-equation",
            Self::Attributes => "area-ratios",
        }
    }

    /// Message id of its name for people.
    pub fn word(self) -> &'static str {
        match self {
            Self::LineClipping => "stress-of-lines",
            Self::PolygonClipping => "stress-of-polygons",
            Self::TriangleClipping => "stress-of-triangles",
            Self::Coverage => "stress-of-coverage",
            Self::Depth => "stress-of-depth",
            Self::Attributes => "stress-of-attributes",
        }
    }

    /// What its cases can be driven to.
    pub fn families(self) -> &'static [Family] {
        use Family::{Beside, Denormal, Huge, Long, NearWZero, NearlyParallel, Sliver};
        match self {
            Self::LineClipping => &[NearlyParallel, Beside, Huge],
            Self::PolygonClipping => &[NearlyParallel, Beside, Huge],
            Self::TriangleClipping => &[NearlyParallel, Beside, Huge],
            Self::Coverage => &[Beside, Sliver, Huge, Denormal, Long],
            Self::Depth => &[Sliver, Huge, Long],
            Self::Attributes => &[Beside, Sliver, NearWZero, Huge],
        }
    }
}

/// The families that some operation has, mildest to tell first.
pub const DRIVEN: [Family; 7] = [
    Family::NearlyParallel,
    Family::Beside,
    Family::Huge,
    Family::Denormal,
    Family::Sliver,
    Family::NearWZero,
    Family::Long,
];

/// Message id of a family's name for people.
pub fn word(family: Family) -> &'static str {
    match family {
        Family::Ordinary => "stress-ordinary",
        Family::PastACorner => "stress-past-a-corner",
        Family::Beside => "stress-beside",
        Family::NearlyParallel => "stress-nearly-parallel",
        Family::Huge => "stress-huge",
        Family::Denormal => "stress-denormal",
        Family::Sliver => "stress-sliver",
        Family::NearWZero => "stress-near-w-zero",
        Family::Long => "stress-long",
    }
}

/// The most that the dial is turned to; at 0 cases are ordinary.
pub const MOST: u8 = 10;

/// Case number `index` of a family at a dial, in a scene whose image and camera it uses.
///
/// Cases of one number have the same random numbers at every dial, driven more or less far. Every number is finite,
/// and at most 2^125.
pub fn case(operation: Operation, family: Family, dial: u8, index: usize, scene: &Scene) -> LabInput {
    let seed = 1_000_000 * operation as u64 + 10_000 * family as u64 + index as u64;
    let far = f64::from(dial.min(MOST)) / f64::from(MOST);
    let mut drive = Drive { family, far, random: Random::new(seed) };
    match operation {
        Operation::LineClipping => drive.line().into(),
        Operation::PolygonClipping => drive.polygon().into(),
        Operation::TriangleClipping => drive.triangle(scene).into(),
        Operation::Coverage => drive.pixels(scene).into(),
        Operation::Depth => drive.row(scene).into(),
        Operation::Attributes => drive.at_point(scene).into(),
    }
}

/// One case on its way.
struct Drive {
    family: Family,
    /// How far the dial is turned, from 0 to 1.
    far: f64,
    random: Random,
}

/// Rounds to binary32, within its finite range.
fn narrow(x: f64) -> f32 {
    let most = libm::exp2(125.0);
    x.clamp(-most, most) as f32
}

impl Drive {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        f64::from(self.random.uniform(low, high))
    }

    fn sign(&mut self) -> f64 {
        self.random.pick(&[-1.0, 1.0])
    }

    /// From 1 down to 2 to the power of `-bits`, by as many bits at each turn of the dial.
    fn shrunk(&self, bits: f64) -> f64 {
        libm::exp2(-bits * self.far)
    }

    /// From 1 up to 2 to the power of `bits`, slowly at first.
    fn grown(&self, bits: f64) -> f64 {
        libm::exp2(bits * self.far * self.far)
    }

    /// A number so many binary32 steps beside another, which is not 0: a million at the start, at most one at the
    /// end.
    fn beside(&mut self, at: f64) -> f64 {
        let most = libm::exp2(20.0 * (1.0 - self.far));
        let steps = self.uniform(-most, most).round() as i32;
        // The order of binary32 numbers of one sign is that of their bits.
        f64::from(f32::from_bits((at as f32).to_bits().saturating_add_signed(steps)))
    }
}
