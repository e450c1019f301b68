//! Back-face test on the screen: the sign of the triangle's area.
//!
//! *Source:* Meister, Generalia de genesi figurarum planarum, 1769 (the area of a polygon); OpenGL 4.6
//! core, section 14.6.1; WebGPU, "Polygon Rasterization". Deviation: where y points down the sign is turned, so
//! that positive is counter-clockwise as seen.

use super::number::Number;
use crate::{
    math::{Sign, Tally, orient2d},
    raster::YAxis,
};

/// What the test computes.
#[derive(Clone, Debug)]
pub struct Terms<N> {
    /// `x0 y1 - x1 y0`, `x1 y2 - x2 y1`, `x2 y0 - x0 y2`.
    pub products: [N; 3],
    /// Half their sum, turned if y points down: the area in pixels, positive where the front is seen.
    pub value: N,
}

/// The formula in any arithmetic: six products.
///
/// Screen space, in pixels from the corner of pixel (0, 0), y as `y_axis` says; counter-clockwise as seen
/// is the front. An odd number of vertices behind the eye turns the answer round.
#[inline]
pub fn formula<N: Number>(screen: [[f32; 2]; 3], y_axis: YAxis) -> Terms<N> {
    let points = screen.map(|point| point.map(N::from));
    let products = [[0, 1], [1, 2], [2, 0]].map(|[i, j]: [usize; 2]| {
        let ([xi, yi], [xj, yj]) = (points[i].clone(), points[j].clone());
        xi * yj - xj * yi
    });
    let [a, b, c] = products.clone();
    let half = N::from(match y_axis {
        YAxis::Down => -0.5,
        YAxis::Up => 0.5,
    });
    Terms { products, value: half * (a + b + c) }
}

/// The exact sign of the area, for all finite coordinates; zero if there is none. About 2 ns.
#[inline]
pub fn sign([a, b, c]: [[f32; 2]; 3], y_axis: YAxis, tally: &mut Tally) -> Sign {
    let sign = orient2d(a, b, c, tally);
    match y_axis {
        YAxis::Down => -sign,
        YAxis::Up => sign,
    }
}
