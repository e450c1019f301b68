//! The colours of a row of pixels of one triangle: what [`Shader`](super::shader::Shader) gives for each, as far as a
//! proven error leaves one answer.
//!
//! *Source:* Heckbert and Moreton, Interpolation for Polygon Texture Mapping and Shading, 1991; Higham, Accuracy and
//! Stability of Numerical Algorithms, 2nd ed. 2002, section 3.1 (the errors).

use crate::engine::{Lanes, greatest, least};

/// The unit roundoff of binary64.
const U: f64 = f64::EPSILON / 2.0;

/// Vertex colours over a triangle: each channel is a quotient of two planes, `sum(E r c) / sum(E r)` with the edge
/// functions E, which are linear in the distance from the first vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gradient {
    /// The first vertex, in pixels.
    origin: [f64; 2],
    /// The denominator: its value there, and what it grows by per pixel to the right and down.
    weight: [f64; 3],
    /// The numerators of red, green, blue, alpha, times what the codes are scaled by.
    channels: [[f64; 4]; 3],
    /// A quotient that is no farther than this from a whole number has it as its code.
    certain: f64,
}

impl Gradient {
    /// Of vertices (x, y, r) with a colour each: codes, not rounded, from 0 to 255. `None` if the error might not be
    /// small: for slivers, and where r is not positive.
    ///
    /// With differences from the first vertex, a plane's value is `D p0 + gx dx + gy dy`, D being twice the area. No
    /// term of it goes through more than eleven roundings, so it is off by at most `16u T`, T being the sum of the
    /// terms' magnitudes where dx and dy are greatest inside the triangle; that of a numerator is M times that of the
    /// denominator or less, M the greatest code. Inside, the denominator is at least `|D|` times the least r, so
    /// quotients are off by at most `32u M T` through that less the error; inverting and multiplying add two
    /// roundings. What is left of 40 and 8 covers the roundings of the bound itself.
    #[inline(always)]
    pub(super) fn new(vertices: [[f32; 3]; 3], colors: [[f64; 4]; 3]) -> Option<Self> {
        let [[x0, y0, r0], [x1, y1, r1], [x2, y2, r2]] = vertices.map(|vertex| vertex.map(f64::from));
        let (ax, ay, bx, by) = (x1 - x0, y1 - y0, x2 - x0, y2 - y0);
        let area = ax * by - ay * bx;
        let plane = |p0: f64, p1: f64, p2: f64| {
            let (p1, p2) = (p1 - p0, p2 - p0);
            [area * p0, by * p1 - ay * p2, ax * p2 - bx * p1]
        };
        let [c0, c1, c2] = colors;
        let mut channels = [[0.0; 4]; 3];
        let mut codes = [[0.0; 4], [1.0; 4]];
        for c in 0..4 {
            let [at, right, down] = plane(r0 * c0[c], r1 * c1[c], r2 * c2[c]);
            (channels[0][c], channels[1][c], channels[2][c]) = (at, right, down);
            for code in [c0[c], c1[c], c2[c]] {
                codes[0][c] = least(code, codes[0][c]);
                codes[1][c] = greatest(code, codes[1][c]);
            }
        }
        let [low, high] = codes;
        let low = least(least(low[0], low[1]), least(low[2], low[3]));
        let high = greatest(greatest(high[0], high[1]), greatest(high[2], high[3]));
        let size = |a: f64, b: f64| greatest(a.abs(), b.abs());
        let (p1, p2) = (r1 + r0, r2 + r0);
        let products = (ax * by).abs() + (ay * bx).abs();
        let terms = products * r0
            + (by.abs() * p1 + ay.abs() * p2) * size(ax, bx)
            + (bx.abs() * p1 + ax.abs() * p2) * size(ay, by);
        let error = 16.0 * U * terms;
        let least_weight = (area.abs() - 4.0 * U * products) * least(least(r0, r1), r2) - error;
        let bound = 40.0 * U * high * terms / least_weight + 8.0 * U * (high + 1.0);
        // What is not a number is less than nothing.
        let small = least_weight > 0.0 && bound < 0.25 && low >= 0.0 && high <= 255.0;
        let (origin, weight) = ([x0, y0], plane(r0, r1, r2));
        small.then_some(Self { origin, weight, channels, certain: 0.5 - bound })
    }

    /// Codes of the pixels of a row from `x` on, at most 64, all inside the triangle. Returns the pixels whose codes
    /// are not certain, a bit each, the first lowest.
    pub(super) fn row(&self, lanes: Lanes, [x, y]: [u32; 2], colors: &mut [[u8; 4]]) -> u64 {
        lanes.run(
            #[inline(always)]
            || self.row_in_lanes([x, y], colors),
        )
    }

    #[inline(always)]
    fn row_in_lanes(&self, [x, y]: [u32; 2], colors: &mut [[u8; 4]]) -> u64 {
        let Self { origin, weight, channels, certain } = self;
        let [left, dy] = [f64::from(x) + 0.5 - origin[0], f64::from(y) + 0.5 - origin[1]];
        let weight_here = weight[0] + weight[2] * dy;
        let mut here = [0.0; 4];
        for c in 0..4 {
            here[c] = channels[0][c] + channels[2][c] * dy;
        }
        let mut uncertain = 0;
        for (i, color) in (0..).zip(colors) {
            let dx = left + f64::from(i);
            let inverse = 1.0 / (weight_here + weight[1] * dx);
            let (mut sure, mut codes) = (true, [0; 4]);
            for c in 0..4 {
                let quotient = (here[c] + channels[1][c] * dx) * inverse;
                // The nearest whole number.
                let shifted = quotient + SHIFT;
                codes[c] = shifted.to_bits() as u8;
                sure &= (quotient - (shifted - SHIFT)).abs() < *certain;
            }
            *color = codes;
            uncertain |= u64::from(!sure) << i;
        }
        uncertain
    }
}

/// The whole number nearest to one from 0 to 2^51.
#[inline(always)]
pub(super) fn nearest(value: f64) -> f64 {
    value + SHIFT - SHIFT
}

/// Added to a number, leaves it rounded in the low bits: 1.5 * 2^52.
const SHIFT: f64 = 6_755_399_441_055_744.0;
