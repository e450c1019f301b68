//! The colours of a row of pixels of one triangle, a few at once: what [`Shader`](super::shader::Shader) gives for each,
//! as far as a proven error leaves one answer.
//!
//! *Source:* Heckbert and Moreton, Interpolation for Polygon Texture Mapping and Shading, 1991; Higham, Accuracy and
//! Stability of Numerical Algorithms, 2nd ed. 2002, section 3.1 (the errors).

use crate::{engine::Lanes, interpolate::Interpolator};

/// The unit roundoff of binary64.
const U: f64 = f64::EPSILON / 2.0;

/// Pixels that go through the loops together.
const LANES: usize = 8;

/// Vertex colours over a triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Gradient {
    /// A point of the edge opposite to each vertex, and the direction of that edge times the vertex's factor.
    starts: [[f64; 2]; 3],
    directions: [[f64; 2]; 3],
    /// Vertex values of red, green, blue, alpha, times what the codes are scaled by.
    channels: [[f64; 3]; 4],
    /// The codes of channels that are the same everywhere.
    constant: [Option<u8>; 4],
    /// No scaled value is greater.
    greatest: f64,
}

impl Gradient {
    /// `channels` at the vertices; `scales` multiply them to codes; `constant`: codes that are known already.
    pub(super) fn new(
        interpolator: &Interpolator,
        channels: &[[f32; 3]; 4],
        scales: [f64; 4],
        constant: [Option<u8>; 4],
    ) -> Self {
        let (edges, factors) = interpolator.edges();
        let starts = edges.map(|[a, _]| a.map(f64::from));
        let directions = [0, 1, 2].map(|i| {
            let [a, b] = edges[i];
            [0, 1].map(|axis| (f64::from(b[axis]) - f64::from(a[axis])) * factors[i])
        });
        let channels = [0, 1, 2, 3].map(|c| channels[c].map(|value| f64::from(value) * scales[c]));
        let greatest = channels.as_flattened().iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        Self { starts, directions, channels, constant, greatest }
    }

    /// Codes of the pixels of a row from `x` on, at most 64. Returns the pixels whose codes are not certain, a bit
    /// each, the first lowest.
    ///
    /// The weight of a vertex, `factor * (across - along)`, comes out of at most five roundings of each of its two
    /// terms; a sum of three weights, or of three weighted values, of four more: below `10u` times the sum T of all
    /// terms' magnitudes, and M times that. While the sum S of weights is at least twice its error e, the quotient
    /// is off by less than `4 M e / S`; scaling, inverting, multiplying and adding 1/2 add four roundings.
    pub(super) fn row(&self, lanes: Lanes, [x, y]: [u32; 2], colors: &mut [[u8; 4]]) -> u64 {
        lanes.run(
            #[inline(always)]
            || self.row_in_lanes([x, y], colors),
        )
    }

    #[inline(always)]
    fn row_in_lanes(&self, [x, y]: [u32; 2], colors: &mut [[u8; 4]]) -> u64 {
        let [x, y] = [f64::from(x) + 0.5, f64::from(y) + 0.5];
        let last = x + colors.len() as f64;
        let (mut across, mut terms) = ([0.0; 3], 0.0);
        for i in 0..3 {
            across[i] = self.directions[i][0] * (y - self.starts[i][1]);
            let start = self.starts[i][0];
            let farthest = (x - start).abs().max((last - start).abs());
            terms += across[i].abs() + self.directions[i][1].abs() * farthest;
        }
        let error = 10.0 * U * terms;
        let scaled = 4.0 * error * self.greatest;
        let rounding = 8.0 * U * (self.greatest + 1.0);
        let mut uncertain = 0;
        for (chunk, colors) in colors.chunks_mut(LANES).enumerate() {
            let mut weights = [[0.0; LANES]; 3];
            for i in 0..3 {
                for lane in 0..LANES {
                    let at = x + (chunk * LANES + lane) as f64;
                    weights[i][lane] = across[i] - self.directions[i][1] * (at - self.starts[i][0]);
                }
            }
            let (mut inverse, mut bound, mut sure) = ([0.0; LANES], [0.0; LANES], [0_u32; LANES]);
            for lane in 0..LANES {
                let sum = weights[0][lane] + weights[1][lane] + weights[2][lane];
                inverse[lane] = 1.0 / sum;
                bound[lane] = scaled * inverse[lane] + rounding;
                // What is not a number is less than nothing.
                sure[lane] = u32::from(2.0 * error < sum);
            }
            let mut codes = [[0_u32; LANES]; 4];
            for c in 0..4 {
                if let Some(code) = self.constant[c] {
                    codes[c] = [u32::from(code); LANES];
                    continue;
                }
                let [a, b, c2] = self.channels[c];
                for lane in 0..LANES {
                    let value = weights[0][lane] * a + weights[1][lane] * b + weights[2][lane] * c2;
                    let value = value * inverse[lane] + 0.5;
                    let whole = value.floor();
                    let rest = value - whole;
                    sure[lane] &= u32::from(rest > bound[lane]) & u32::from(rest < 1.0 - bound[lane]);
                    codes[c][lane] = (whole + SHIFT).to_bits() as u32;
                }
            }
            for (lane, color) in colors.iter_mut().enumerate() {
                *color = [0, 1, 2, 3].map(|c| codes[c][lane] as u8);
                uncertain |= u64::from(1 - sure[lane]) << (chunk * LANES + lane);
            }
        }
        uncertain
    }
}

/// Added to a whole number, leaves it in the low bits: 1.5 * 2^52.
const SHIFT: f64 = 6_755_399_441_055_744.0;
