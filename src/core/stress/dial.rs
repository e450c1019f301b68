//! Cases from mild to extreme: what a dial does to ordinary ones.
//!
//! A case is the input of the lab that teaches its operation, so that it opens there as it is.

use serde::{Deserialize, Serialize};

use super::{Family, Random, segments};
use crate::{
    interpolate::Mode,
    labs::{
        AreaRatios, ClipLine, ClipPolygon, ClipTriangle, Family as _, FillTriangle, Interpolation, LabInput,
        PlaneEquation,
    },
    raster::Algorithm,
    scene::Scene,
};

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
            Self::LineClipping => &[Beside, NearlyParallel, Huge, Denormal],
            Self::PolygonClipping => &[Beside, NearlyParallel, Sliver, Huge, Denormal],
            Self::TriangleClipping => &[Beside, NearlyParallel, Sliver, NearWZero, Huge],
            Self::Coverage => &[Beside, NearlyParallel, Sliver, Huge, Denormal, Long],
            Self::Depth => &[Beside, NearlyParallel, Sliver, Huge, Long],
            Self::Attributes => &[Beside, NearlyParallel, Sliver, NearWZero, Huge, Denormal],
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
/// Cases of one number have the same numbers at every dial, driven more or less far. Every number is finite.
/// The labs' own range of binary32 is kept: at most 2^125.
pub fn case(operation: Operation, family: Family, dial: u8, index: usize, scene: &Scene) -> LabInput {
    let seed = 1_000_000 * operation as u64 + 10_000 * family as u64 + index as u64;
    let mut drive = Drive { family, dial: f64::from(dial.min(MOST)), random: Random::new(seed) };
    match operation {
        Operation::LineClipping => drive.line().into(),
        Operation::PolygonClipping => drive.polygon().into(),
        Operation::TriangleClipping => drive.triangle(scene).into(),
        Operation::Coverage => {
            let vertices = drive.on_screen(scene).map(|point| point.map(narrow));
            FillTriangle::of(Algorithm::Scanline, vertices).into()
        }
        Operation::Depth => {
            let row = Interpolation { mode: Mode::Affine, ..drive.weighed(scene) };
            PlaneEquation(row).into()
        }
        Operation::Attributes => AreaRatios(drive.weighed(scene)).into(),
    }
}

/// One case on its way.
struct Drive {
    family: Family,
    dial: f64,
    random: Random,
}

type Point = [f64; 2];

/// Rounds to binary32, within its finite range.
fn narrow(x: f64) -> f32 {
    let most = libm::exp2(125.0);
    x.clamp(-most, most) as f32
}

impl Drive {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        f64::from(self.random.uniform(low, high))
    }

    /// From 1 down to 2 to the power of `-bits`, the further the dial is turned.
    fn shrunk(&self, bits: f64) -> f64 {
        libm::exp2(-bits * self.dial / f64::from(MOST))
    }

    /// As many steps beside a number as a random number below one that the dial halves: at most one at the end.
    fn beside(&mut self, at: f64) -> f64 {
        let most = libm::exp2(2.0 * (f64::from(MOST) - self.dial));
        let steps = (self.uniform(-most, most)).round() as i32;
        // The order of binary32 numbers of one sign is that of their bits.
        f64::from(f32::from_bits((at as f32).to_bits().wrapping_add_signed(steps)))
    }

    /// A window and points in it and around it, driven.
    fn in_plane(&mut self, mut points: Vec<Point>) -> ([f32; 4], Vec<[f32; 2]>) {
        let sides = segments::sides(Family::Ordinary).map(f64::from);
        let border = |random: &mut Random, axis: usize| random.pick(&[sides[axis], sides[axis + 2]]);
        let mut scale = 1.0;
        match self.family {
            Family::Beside => {
                for point in &mut points {
                    let axis = self.random.below(2);
                    let at = border(&mut self.random, axis);
                    point[axis] = self.beside(at);
                }
            }
            Family::NearlyParallel => {
                let axis = self.random.below(2);
                let at = border(&mut self.random, axis);
                let by = self.shrunk(24.0);
                points.iter_mut().take(2).for_each(|point| point[axis] = at + (point[axis] - at) * by);
            }
            Family::Sliver => {
                let middle = points[0][1];
                let by = self.shrunk(26.0);
                points.iter_mut().for_each(|point| point[1] = middle + (point[1] - middle) * by);
            }
            Family::Huge => {
                let by = 1.0 / self.shrunk(118.0);
                points.iter_mut().skip(1).for_each(|point| *point = point.map(|c| c * by));
            }
            Family::Denormal => scale = self.shrunk(139.0),
            _ => {}
        }
        let points = points.iter().map(|point| point.map(|c| narrow(c * scale))).collect();
        (sides.map(|side| narrow(side * scale)), points)
    }

    fn line(&mut self) -> ClipLine {
        let around = |drive: &mut Self| [drive.uniform(-9.0, 11.0), drive.uniform(-7.0, 8.0)];
        let ends = vec![around(self), around(self)];
        let (window, points) = self.in_plane(ends);
        let [[x0, y0], [x1, y1]] = [points[0], points[1]];
        ClipLine { window, segment: [x0, y0, x1, y1], ..ClipLine::first() }
    }

    fn polygon(&mut self) -> ClipPolygon {
        let [x, y] = [self.uniform(-2.0, 4.0), self.uniform(-1.5, 2.5)];
        let corner = |drive: &mut Self, i: u32| {
            let turn = (f64::from(i) + drive.uniform(0.0, 0.8)) / 5.0 * std::f64::consts::TAU;
            let (sin, cos) = libm::sincos(turn);
            let far = drive.uniform(2.0, 6.0);
            [x + far * cos, y + far * sin]
        };
        let corners = (0..5).map(|i| corner(self, i)).collect();
        let (window, polygon) = self.in_plane(corners);
        ClipPolygon { window, polygon, ..ClipPolygon::first() }
    }

    /// A triangle in camera space around the near plane.
    fn triangle(&mut self, scene: &Scene) -> ClipTriangle {
        let near = f64::from(scene.camera.near);
        let mut vertices: [[f64; 3]; 3] = std::array::from_fn(|_| {
            let depth = near * self.uniform(0.2, 4.0);
            [self.uniform(-2.0, 2.0) * depth, self.uniform(-2.0, 2.0) * depth, -depth]
        });
        match self.family {
            Family::Beside => {
                for vertex in &mut vertices[..2] {
                    vertex[2] = self.beside(-near);
                }
            }
            Family::NearlyParallel => {
                let by = self.shrunk(24.0);
                vertices[..2].iter_mut().for_each(|vertex| vertex[2] = -near + (vertex[2] + near) * by);
            }
            Family::Sliver => {
                let ([a, b, c], by) = (vertices, self.shrunk(26.0));
                vertices[2] = [0, 1, 2].map(|i| {
                    let on = 0.4 * a[i] + 0.6 * b[i];
                    on + (c[i] - on) * by
                });
            }
            Family::NearWZero => {
                let by = self.shrunk(100.0);
                vertices[0][2] *= by;
                vertices[1][2] *= -by;
            }
            Family::Huge => {
                let by = 1.0 / self.shrunk(110.0);
                vertices[1..].iter_mut().for_each(|vertex| *vertex = vertex.map(|c| c * by));
            }
            _ => {}
        }
        ClipTriangle { vertices: Some(vertices.map(|vertex| vertex.map(narrow))), ..ClipTriangle::first() }
    }

    /// A triangle in the scene's image, driven.
    fn on_screen(&mut self, scene: &Scene) -> [Point; 3] {
        let [width, height] = scene.size.map(f64::from);
        let mut points: [Point; 3] =
            std::array::from_fn(|_| [self.uniform(0.0, width), self.uniform(0.0, height)]);
        match self.family {
            Family::Beside => {
                points = points.map(|point| point.map(|c| self.beside(c.floor() + 0.5)));
            }
            Family::NearlyParallel => {
                let (row, by) = (points[0][1].floor() + 0.5, self.shrunk(26.0));
                points[..2].iter_mut().for_each(|point| point[1] = row + (point[1] - row) * by);
            }
            // Along a diagonal through centres: elsewhere hardly one covers a pixel.
            Family::Sliver => {
                let ([start, _, c], by) = (points, self.shrunk(24.0));
                let start = start.map(|c| (c / 2.0).floor() + 0.5);
                let length = (width.min(height) / 2.0).floor();
                let end = start.map(|c| c + length);
                let on = start.map(|c| c + 0.4 * length);
                points = [start, end, [0, 1].map(|i| on[i] + (c[i] - on[i]) * by)];
            }
            Family::Huge => {
                let by = 1.0 / self.shrunk(118.0);
                let back = self.uniform(0.5, 2.0);
                let away = [points[1][0] - width / 2.0, points[1][1] - height / 2.0];
                points[1] = away.map(|c| c * by);
                points[2] = away.map(|c| -c * by * back);
            }
            // A side through the corner of the image, but for next to nothing.
            Family::Denormal => {
                let by = self.shrunk(140.0);
                let far = self.uniform(0.5, 1.0) * width.min(height);
                points[0] = [self.uniform(-1.0, 1.0) * by, self.uniform(-1.0, 1.0) * by];
                points[1] = [far, far];
            }
            Family::Long => {
                let rows = (height * (self.dial + 1.0) / f64::from(MOST + 1)).max(2.0);
                points[0][1] = self.uniform(0.0, 0.1) * rows;
                points[1][1] = self.uniform(0.3, 0.6) * rows;
                points[2][1] = rows * self.uniform(0.9, 1.0);
            }
            _ => {}
        }
        points
    }

    /// A triangle with w and an attribute, and a point of it.
    fn weighed(&mut self, scene: &Scene) -> Interpolation {
        let scale = if self.family == Family::Denormal { self.shrunk(140.0) } else { 1.0 };
        let corners = if self.family == Family::Denormal {
            let [width, height] = scene.size.map(f64::from);
            std::array::from_fn(|_| [self.uniform(0.0, width), self.uniform(0.0, height)])
        } else {
            self.on_screen(scene)
        };
        let corners = corners.map(|corner| corner.map(|c| c * scale));
        let by = if self.family == Family::NearWZero { self.shrunk(100.0) } else { 1.0 };
        let mut w = [0, 1, 2].map(|_| self.uniform(0.5, 9.0));
        w[0] *= by;
        let [a, b, c] = corners;
        let (k, l) = (self.uniform(0.1, 0.5), self.uniform(0.1, 0.5));
        let (k, l) = match self.family {
            // On a side, or as near to it as the dial says.
            Family::Beside => (k, 0.0),
            Family::NearlyParallel | Family::Sliver => (k, l * self.shrunk(20.0)),
            _ => (k, l),
        };
        // No difference that could be infinite: the weights first.
        let mut at = [0, 1].map(|i| narrow((1.0 - k - l) * a[i] + k * b[i] + l * c[i]));
        if self.family == Family::Beside {
            at = at.map(|c| narrow(self.beside(f64::from(c))));
        }
        let vertex = |i: usize| [corners[i][0], corners[i][1], w[i]].map(narrow);
        Interpolation {
            vertices: [vertex(0), vertex(1), vertex(2)],
            attribute: std::array::from_fn(|_| narrow(self.uniform(0.0, 1.0))),
            at,
            mode: Mode::Perspective,
            arithmetic: Default::default(),
        }
    }
}
