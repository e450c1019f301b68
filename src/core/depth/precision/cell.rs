//! The stretch of the line of sight that has one code.

use crate::{
    depth::DepthFormat,
    math::Dyadic,
    transform::{Camera, Projection},
};

/// The line of sight of a camera, with how depths along it are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Distances of the near and the far plane, 0 < near < far.
    pub planes: [f32; 2],
    /// Whether depth grows with 1/distance, not with distance.
    pub perspective: bool,
    /// How a depth is stored.
    pub format: DepthFormat,
    /// Whether the near plane has depth 1.
    pub reversed: bool,
}

/// The bits of the float 1.
const ONE: u32 = 0x3F80_0000;
/// Codes of one binade of floats.
const BINADE: u32 = 1 << 23;

impl Line {
    /// That of a camera.
    pub fn new(camera: &Camera, format: DepthFormat, reversed: bool) -> Self {
        let perspective = matches!(camera.projection, Projection::Perspective { .. });
        Self { planes: [camera.near, camera.far], perspective, format, reversed }
    }

    /// The place of the last code, that of the far plane; the first is 0.
    pub fn last(&self) -> u32 {
        self.format.max_code().unwrap_or(ONE)
    }

    /// The code at a place, counted from the near plane; and the place of a code.
    pub fn code(&self, place: u32) -> u32 {
        if self.reversed { self.last() - place } else { place }
    }

    /// Ranges of places in which the step only grows with the distance, in order.
    ///
    /// Codes stand evenly in depth, or, as floats, ever closer towards 0. A perspective spreads them
    /// over ever longer stretches. Only reversed floats do both against each other: there every binade is
    /// a range of its own, and so is the power of two between two of them. The far plane cuts the last
    /// stretch in half, so it stands alone too.
    pub(super) fn ranges(&self) -> Vec<[u32; 2]> {
        let last = self.last();
        let mut ranges = Vec::new();
        if self.format == DepthFormat::F32 && self.reversed {
            for power in (0..ONE).step_by(BINADE as usize) {
                ranges.extend([[power, power], [power + 1, power + BINADE - 1]]);
            }
        } else {
            ranges.push([0, last - 1]);
        }
        ranges.push([last, last]);
        ranges
    }

    /// What has the code at a place.
    pub fn cell(&self, place: u32) -> Cell {
        let code = self.code(place);
        let (ends, one) = match self.format.max_code() {
            Some(max) => {
                let [low, high] = [2.0 * f64::from(code) - 1.0, 2.0 * f64::from(code) + 1.0];
                ([low, high].map(Dyadic::from), Dyadic::from(2.0 * f64::from(max)))
            }
            None => {
                // Half-way to the neighbours; twice as much here, so that `one` is 2.
                let float = |code: u32| Dyadic::from(f32::from_bits(code));
                let low = float(code.saturating_sub(1)) + float(code);
                let high = float(code) + float((code + 1).min(ONE));
                ([low, high], Dyadic::from(2))
            }
        };
        let ends = ends.map(|end| end.max(Dyadic::zero()).min(one.clone()));
        Cell { line: *self, ends, one }
    }

    /// The place of the code that a distance is stored as; in binary64, to be shown.
    pub(super) fn place_of(&self, distance: f64) -> u32 {
        let [near, far] = self.planes.map(f64::from);
        let z = if self.perspective {
            far * (distance - near) / ((far - near) * distance)
        } else {
            (distance - near) / (far - near)
        };
        let z = if self.reversed { 1.0 - z } else { z };
        self.code(self.format.encode(z as f32))
    }
}

/// All distances that have one code.
#[derive(Clone, Debug)]
pub struct Cell {
    line: Line,
    /// The least and the greatest depth, over `one`.
    ends: [Dyadic; 2],
    one: Dyadic,
}

impl Cell {
    /// Whether its length exceeds `gap`, exactly.
    ///
    /// With u = 1 - z, or z if depth is reversed, the distance is n f / (n + u (f - n)); so the length between
    /// two depths is n f (f - n) (u2 - u1) / ((n + u1 (f - n)) (n + u2 (f - n))).
    pub fn exceeds(&self, gap: f32) -> bool {
        let Self { line, ends: [low, high], one } = self;
        let [near, far] = line.planes.map(Dyadic::from);
        let span = &far - &near;
        let gap = Dyadic::from(gap);
        if !line.perspective {
            return &span * (high - low) > gap * one;
        }
        let scaled = |z: &Dyadic| {
            let u = if line.reversed { z.clone() } else { one - z };
            &near * one + u * &span
        };
        let length = &near * &far * &span * (high - low) * one;
        length > gap * scaled(low) * scaled(high)
    }

    /// The distances at which it begins and ends; in binary64, to be shown.
    pub fn distances(&self) -> [f64; 2] {
        let [near, far] = self.line.planes.map(f64::from);
        let one = self.one.to_f64_nearest();
        let at = |z: &Dyadic| {
            let from_far = if self.line.reversed { z.clone() } else { &self.one - z };
            let u = from_far.to_f64_nearest() / one;
            if self.line.perspective {
                near * far / (near + u * (far - near))
            } else {
                far - u * (far - near)
            }
        };
        let [a, b] = [&self.ends[0], &self.ends[1]].map(at);
        [a.min(b), a.max(b)]
    }

    /// Its length; in binary64, to be shown, without the cancellation of a difference.
    pub fn length(&self) -> f64 {
        let [near, far] = self.line.planes.map(f64::from);
        let difference = (&self.ends[1] - &self.ends[0]).to_f64_nearest() / self.one.to_f64_nearest();
        if !self.line.perspective {
            return (far - near) * difference;
        }
        let [a, b] = self.distances();
        difference * (far - near) / (near * far) * a * b
    }
}
