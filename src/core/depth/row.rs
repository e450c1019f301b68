//! The depths of the pixels that a triangle covers, fast: a plane's value with a proven error, and the
//! exact quotient only where the error leaves two answers.
//!
//! *Source:* Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 15.4 (the plane);
//! Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed. 2002, section 3.1 (its error).

use super::{DepthFormat, DepthPlacement, DepthPlane};
use crate::{
    math::{Approx, Arithmetic, Tally},
    raster::edge::centre,
};

/// Depth codes of one triangle in one format.
#[derive(Clone, Copy, Debug)]
pub struct DepthRows {
    plane: DepthPlane,
    format: DepthFormat,
    /// The code of all pixels, if the depth is constant.
    constant: Option<u32>,
    /// A vertex (x, y, z), and how z changes with x and y.
    start: [f64; 3],
    slope: [f64; 2],
    /// What a computed depth is off by at most, at a covered centre.
    error: f64,
    /// The same for a unorm code before it is cut to an integer.
    code_error: f64,
}

/// One row of [`DepthRows`].
#[derive(Clone, Copy, Debug)]
pub struct DepthRow<'r> {
    rows: &'r DepthRows,
    y: u32,
    /// The depth at the height of the row and the x of the starting vertex.
    depth: f64,
}

impl DepthRows {
    /// From vertices (x, y, z) as [`DepthPlane::new`] takes them, in exact arithmetic.
    ///
    /// The slopes are known with their errors (`Approx`). A covered centre is no farther from the first
    /// vertex than the box is wide and high, and on the way to a depth each of the three terms goes
    /// through at most four roundings. Six times the unit roundoff also covers the roundings of the
    /// bound itself.
    pub fn new(vertices: [[f32; 3]; 3], format: DepthFormat, tally: &mut Tally) -> Self {
        const U: f64 = f64::EPSILON / 2.0;
        let plane = DepthPlane::new(vertices, Arithmetic::Exact, tally);
        let [z0, z1, z2] = vertices.map(|[_, _, z]| z);
        let constant =
            (z0.to_bits() == z1.to_bits() && z1.to_bits() == z2.to_bits()).then(|| format.encode(z0));
        let [a, b, c] = vertices.map(|vertex| vertex.map(Approx::from));
        let [[ax, ay, az], [bx, by, bz]] = [b, c].map(|v| [v[0] - a[0], v[1] - a[1], v[2] - a[2]]);
        let area = ax * by - bx * ay;
        let slope = [(az * by - bz * ay) / area, (bz * ax - az * bx) / area];
        let reach = [0, 1].map(|axis| {
            let side = |v: &[f32; 3]| (f64::from(v[axis]) - f64::from(vertices[0][axis])).abs();
            vertices.iter().map(side).fold(0.0, f64::max)
        });
        let start = vertices[0].map(f64::from);
        let terms = start[2].abs() + slope[0].value.abs() * reach[0] + slope[1].value.abs() * reach[1];
        let inherited = slope[0].error * reach[0] + slope[1].error * reach[1];
        let error = inherited * (1.0 + 8.0 * U) + 6.0 * U * terms + f64::MIN_POSITIVE;
        // One product and one sum below 2^33 are off by less than 2^-19 of a code together.
        let code_error = 2.0 * error * f64::from(format.max_code().unwrap_or(0)) + 1.0 / f64::from(1 << 19);
        Self { plane, format, constant, start, slope: slope.map(|slope| slope.value), error, code_error }
    }

    /// The same with a bias. Every code is asked of the plane then: some 20 ns.
    #[must_use]
    pub fn placed(mut self, placement: &DepthPlacement, tally: &mut Tally) -> Self {
        if !placement.is_plain() {
            self.plane = self.plane.placed(placement, self.format);
            self.constant = self.constant.map(|_| self.plane.code([0, 0], self.format, tally));
            // No depth is certain within such an error.
            (self.error, self.code_error) = (f64::INFINITY, f64::INFINITY);
        }
        self
    }

    /// A row of pixels.
    #[inline]
    pub fn row(&self, y: u32) -> DepthRow<'_> {
        let [_, at] = centre(0, y);
        let depth = self.start[2] + self.slope[1] * (f64::from(at) - self.start[1]);
        DepthRow { rows: self, y, depth }
    }
}

impl DepthRow<'_> {
    /// The code at the centre of a pixel that the triangle covers: what [`DepthPlane::code`] gives. A few
    /// ns; `tally` counts the exact quotients as calls and tails.
    #[inline]
    pub fn code(&self, x: u32, tally: &mut Tally) -> u32 {
        let rows = self.rows;
        if let Some(code) = rows.constant {
            return code;
        }
        let [at, _] = centre(x, self.y);
        let depth = self.depth + rows.slope[0] * (f64::from(at) - rows.start[0]);
        match rows.format.max_code() {
            None => {
                // Outward by more than the rounding of these sums: the error is at least u |depth|. Infinite
                // and NaN ends differ.
                let [low, high] = [-2.0, 2.0].map(|by| (depth + by * rows.error) as f32 + 0.0);
                if low == high {
                    return low.to_bits();
                }
            }
            Some(max) => {
                let scaled = depth * f64::from(max) + 0.5;
                let code = scaled as u32;
                // Certain if neither neighbouring code is within the error; NaN is never.
                let rest = scaled - f64::from(code);
                if rest > rows.code_error && rest < 1.0 - rows.code_error {
                    return code.min(max);
                }
            }
        }
        self.exact(x, tally)
    }

    #[cold]
    fn exact(&self, x: u32, tally: &mut Tally) -> u32 {
        self.rows.plane.code([x, self.y], self.rows.format, tally)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        depth::DepthBias,
        raster::{Algorithm, Settings, cover},
    };

    /// Every format, without and with a bias.
    fn placements() -> impl Iterator<Item = (DepthFormat, DepthPlacement)> {
        let bias = DepthBias { constant: -3, slope: 0.5, clamp: -1e-3 };
        let placed = DepthPlacement { bias, unclipped: true };
        DepthFormat::ALL
            .into_iter()
            .flat_map(move |format| [(format, DepthPlacement::default()), (format, placed)])
    }

    /// Nearly flat and steep, tiny and huge, ties between codes: always the plane's own codes.
    #[test]
    fn rows_give_the_codes_of_the_plane() {
        let triangles = [
            [[1.5, 1.5, 0.25], [60.5, 3.5, 0.75], [10.5, 44.5, 0.5]],
            [[0.1, 0.2, 0.0], [63.9, 1.3, 1.0], [31.7, 47.9, 1e-30]],
            [[-1e30, -1e30, 0.1], [1e30, -1e29, 0.9], [3.0, 1e30, 0.3]],
            [[5.0, 5.0, 0.5], [50.0, 5.0, 0.5], [5.0, 40.0, f32::from_bits(0x3F00_0001)]],
            [[0.0, 0.0, 0.5], [64.0, 0.0, 0.5], [0.0, 48.0, 0.5]],
            [[0.0, 0.0, 0.3], [64.0, 48.0, 0.7], [63.999, 47.999, 0.1]],
        ];
        let mut tally = Tally::default();
        for vertices in triangles {
            let plane = DepthPlane::new(vertices, Arithmetic::Exact, &mut tally);
            for (format, placement) in placements() {
                let plane = plane.placed(&placement, format);
                let rows = DepthRows::new(vertices, format, &mut tally).placed(&placement, &mut tally);
                let points = vertices.map(|[x, y, _]| [x, y]);
                let settings = Settings::new([64, 48]);
                let mut covered = 0;
                cover(Algorithm::Scanline, points, &settings, &mut Tally::default(), &mut |span| {
                    let row = rows.row(span.y);
                    for x in span.begin..span.end {
                        let expected = plane.code([x, span.y], format, &mut tally);
                        assert_eq!(
                            row.code(x, &mut tally),
                            expected,
                            "{vertices:?} {format:?} {placement:?} {x} {}",
                            span.y
                        );
                        covered += 1;
                    }
                });
                assert!(covered > 0 || vertices[2][0] == 63.999, "{vertices:?} covers nothing");
            }
        }
    }
}
