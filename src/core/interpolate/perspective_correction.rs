//! Perspective correction on a checkered parallelogram: texture coordinates of every pixel, evenly on the
//! screen or evenly in space; and depth, 1/w and distance along a line of the screen.
//!
//! *Source:* Heckbert and Moreton, Interpolation for Polygon Texture Mapping and Shading, State of the Art
//! in Computer Graphics, 1991; Blinn, Hyperbolic Interpolation, 1992. Deviation: each coordinate is the exact
//! quotient, rounded once.

mod explain;
mod picture;
mod tables;

pub use explain::Snapshot;

use super::{Interpolator, Mode};
use crate::{
    math::Tally,
    raster::{self, Algorithm},
    replay::{Budget, Player},
    scene::Texture,
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// So many steps along the line.
pub const STEPS: u8 = 8;

/// A parallelogram on the screen, with a checker on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject {
    /// The corners with (u, v) = (0, 0), (1, 0), (1, 1), (0, 1): x and y in pixels, depth, 1/w > 0.
    pub corners: [[f32; 4]; 4],
    /// Squares of the checker along each side.
    pub squares: u32,
    /// Both ends of the line on the screen, in pixels.
    pub line: [[f32; 2]; 2],
}

/// The corners of both triangles.
const TRIANGLES: [[usize; 3]; 2] = [[0, 1, 2], [0, 2, 3]];
/// u and v of the corners.
const UVS: [[f32; 4]; 2] = [[0.0, 1.0, 1.0, 0.0], [0.0, 0.0, 1.0, 1.0]];

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// One of both triangles begins.
    Triangle {
        /// Which.
        index: u8,
    },
    /// A row of its pixels begins.
    Row {
        /// The row.
        y: u32,
        /// First column.
        begin: u32,
        /// One past the last column.
        end: u32,
    },
    /// The texture coordinates of a pixel.
    Pixel {
        /// How they are interpolated.
        mode: Mode,
        /// Its column; images have at most 16384.
        x: u16,
        /// Across.
        u: f32,
        /// Along.
        v: f32,
    },
    /// The square of the checker that the pixel shows.
    Texel {
        /// Whether it is a light one.
        light: bool,
    },
    /// The line begins.
    Line,
    /// A point of the line, at `step / STEPS` of its length.
    Along {
        /// From 0 to [`STEPS`].
        step: u8,
        /// Depth: it changes evenly on the screen.
        z: f32,
        /// 1/w: so does this.
        r: f32,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// A pixel of the parallelogram.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Texel {
    /// Column and row.
    pub pixel: [u32; 2],
    /// Texture coordinates, correctly rounded.
    pub uv: [f32; 2],
    /// Whether the square there is a light one.
    pub light: bool,
}

/// The pixels of the parallelogram, triangle by triangle and row by row.
///
/// Any finite corners with 1/w > 0; what is off the image is left out, a triangle of no area, too.
/// About 100 ns a pixel.
pub fn draw(mode: Mode, subject: &Subject, settings: &raster::Settings) -> Vec<Texel> {
    draw_traced(mode, subject, settings, &mut Tally::default(), &mut NoTrace)
}

/// [`draw`] as a run that can be scrubbed.
pub fn play(mode: Mode, subject: Subject, settings: raster::Settings, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(mode, subject, settings), budget, move |t| {
        draw_traced(mode, &subject, &settings, &mut Tally::default(), t);
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
///
/// The points along the line are part of the trace alone. `tally` counts exact decisions.
pub fn draw_traced<T: Tracer<Event>>(
    mode: Mode,
    subject: &Subject,
    settings: &raster::Settings,
    tally: &mut Tally,
    t: &mut T,
) -> Vec<Texel> {
    let mut texels = Vec::new();
    let texture = Texture::Checker { squares: subject.squares };
    for (triangle, index) in TRIANGLES.into_iter().zip(0..) {
        t.emit(|| Event::Triangle { index });
        let corners = triangle.map(|i| subject.corners[i]);
        let vertices = corners.map(|[x, y, _, r]| match mode {
            Mode::Perspective => [x, y, r],
            Mode::Affine => [x, y, 1.0],
        });
        let Some(interpolator) = Interpolator::new(vertices, tally) else { continue };
        let uvs = UVS.map(|values| triangle.map(|i| values[i]));
        let mut signs = Tally::default();
        let points = corners.map(|[x, y, ..]| [x, y]);
        raster::cover(Algorithm::Scanline, points, settings, &mut signs, &mut |span| {
            let raster::Span { y, begin, end } = span;
            t.emit(|| Event::Row { y, begin, end });
            for x in begin..end {
                let weights = interpolator.at([x, y], tally);
                let [u, v] = uvs.map(|values| weights.value(values, tally));
                t.emit(|| Event::Pixel { mode, x: x as u16, u, v });
                let light = texture.factor(u, v) == 1.0;
                t.emit(|| Event::Texel { light });
                texels.push(Texel { pixel: [x, y], uv: [u, v], light });
            }
        });
        *tally += signs;
    }
    if T::ENABLED {
        trace_line(subject, t);
    }
    texels
}

/// Depth and 1/w at the ends of the line are values of planes; between them both change evenly.
fn trace_line<T: Tracer<Event>>(subject: &Subject, t: &mut T) {
    let Some([from, to]) = ends(subject) else { return };
    t.emit(|| Event::Line);
    for step in 0..=STEPS {
        let share = f64::from(step) / f64::from(STEPS);
        let [z, r] = [0, 1].map(|i| (from[i] + share * (to[i] - from[i])) as f32);
        t.emit(|| Event::Along { step, z, r });
    }
}

/// Depth and 1/w at both ends of the line; `None` if the parallelogram has no area on the screen.
pub(super) fn ends(subject: &Subject) -> Option<[[f64; 2]; 2]> {
    let [a, b, c] = TRIANGLES[0].map(|i| subject.corners[i].map(f64::from));
    let side = |p: [f64; 4]| [p[0] - a[0], p[1] - a[1]];
    let ([ux, uy], [vx, vy]) = (side(b), side(c));
    let area = ux * vy - uy * vx;
    let value = |at: [f32; 2], i: usize| {
        let [x, y] = [f64::from(at[0]) - a[0], f64::from(at[1]) - a[1]];
        let (s, t) = ((x * vy - y * vx) / area, (ux * y - uy * x) / area);
        a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i])
    };
    (area != 0.0).then(|| subject.line.map(|at| [value(at, 2), value(at, 3)]))
}
