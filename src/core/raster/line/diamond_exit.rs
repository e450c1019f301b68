//! The diamond-exit rule: a line between any two points draws the pixels whose diamonds it leaves.
//!
//! The diamond of a pixel holds what is nearer than half a pixel to its centre, counted along the axes:
//! `|x - cx| + |y - cy| < 1/2`, and of its outline the two lower edges with the corner between them; if the
//! line is steep, the right corner as well. A line that ends in a diamond does not leave it. So the last pixel
//! is not drawn, and a line that goes straight on from there draws it: pieces of a straight line draw what
//! the whole line draws, each pixel once.
//!
//! *Source:* Direct3D 11.3 functional specification, section 3.4.3 (aliased lines); Vulkan specification,
//! Bresenham Line Segment Rasterization. Deviations: nothing is snapped, every decision is the exact sign of
//! the inequality. Vulkan moves both ends by an infinitesimal step instead of naming edges, which gives the
//! right edges to the diamond rather than the lower ones.

mod explain;

pub use explain::Snapshot;

use super::Segment;
use crate::{
    math::{Expansion, Sign, Tally, orient2d},
    raster::edge::first_reached,
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case", rename_all_fields = "snake_case")]
pub enum Event {
    /// The axis of the walk was chosen.
    Start {
        /// Whether it is x.
        along_x: bool,
    },
    /// The next column, or row if the walk is along y.
    Next {
        /// Which.
        at: u32,
    },
    /// The line crosses its centre line.
    Crossing {
        /// Where along the other axis, as computed.
        at: f64,
    },
    /// The line starts beyond the centre line.
    StartsBeyond {
        /// Whether a diamond holds the start.
        in_diamond: bool,
    },
    /// The line ends before the centre line, so it leaves no diamond there.
    EndsBefore,
    /// The pixel in question is known.
    Candidate {
        /// Its column.
        x: u32,
        /// Its row.
        y: u32,
        /// Whether the exact sign moved what the crossing suggested.
        corrected: bool,
    },
    /// It is not in the image.
    OffImage,
    /// The line ends in its diamond, so it does not leave it.
    EndsInside,
    /// The line leaves its diamond: drawn.
    Leaves,
    /// All columns or rows are done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Draws the line from the first end to the second; any finite ends.
///
/// `emit` gets the pixels that are in the image, in order, at most one for each column, or for each row if the
/// line is steep. Equal ends draw nothing. Cost: a division for the line, and about three signs for each
/// column or row in the image; `tally` counts the signs.
pub fn draw(ends: Segment, size: [u32; 2], tally: &mut Tally, emit: &mut impl FnMut([u32; 2])) {
    draw_traced(ends, size, tally, &mut NoTrace, emit);
}

/// [`draw`] as a run that can be scrubbed.
pub fn play(ends: Segment, size: [u32; 2], budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(ends, size), budget, move |t| {
        draw_traced(ends, size, &mut Tally::default(), t, &mut |_| {});
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
pub fn draw_traced<T: Tracer<Event>>(
    ends: Segment,
    size: [u32; 2],
    tally: &mut Tally,
    t: &mut T,
    emit: &mut impl FnMut([u32; 2]),
) {
    let walk = Walk::new(ends, size);
    t.emit(|| Event::Start { along_x: walk.major == 0 });
    for at in walk.columns() {
        t.emit(|| Event::Next { at });
        let centre = at as f32 + 0.5;
        let aside = match walk.meets(centre) {
            Meets::StartsBeyond => {
                // Off its centre line a diamond is where its pixel is.
                let aside = walk.ends[0][1 - walk.major].floor();
                let near = (0.0..walk.limit() as f32).contains(&aside).then_some(aside as u32);
                let held = near.filter(|&aside| walk.diamond_holds(walk.pixel(at, aside), walk.ends[0]));
                t.emit(|| Event::StartsBeyond { in_diamond: held.is_some() });
                if let Some(aside) = held {
                    let [x, y] = walk.pixel(at, aside);
                    t.emit(|| Event::Candidate { x, y, corrected: false });
                }
                held
            }
            Meets::EndsBefore => {
                t.emit(|| Event::EndsBefore);
                None
            }
            Meets::Crosses => {
                let crossing = walk.crossing(centre);
                t.emit(|| Event::Crossing { at: crossing });
                // The diamond reaches from its pixel's one side, without it, to the other.
                let guess = (crossing.ceil() as u32).min(walk.limit() + 1);
                let next = first_reached(guess, walk.limit() + 1, |n| walk.reaches(centre, n as f32, tally));
                match next.checked_sub(1).filter(|&aside| aside < walk.limit()) {
                    Some(aside) => {
                        let [x, y] = walk.pixel(at, aside);
                        t.emit(|| Event::Candidate { x, y, corrected: next != guess });
                        Some(aside)
                    }
                    None => {
                        t.emit(|| Event::OffImage);
                        None
                    }
                }
            }
        };
        let Some(aside) = aside else { continue };
        let pixel = walk.pixel(at, aside);
        if walk.diamond_holds(pixel, walk.ends[1]) {
            t.emit(|| Event::EndsInside);
        } else {
            t.emit(|| Event::Leaves);
            emit(pixel);
        }
    }
    t.emit(|| Event::Done);
}

/// How the line and the centre line of a column meet.
enum Meets {
    StartsBeyond,
    EndsBefore,
    Crosses,
}

/// A line and the axis along which it is walked; "columns" are rows if that is y.
struct Walk {
    ends: Segment,
    size: [u32; 2],
    /// 0: along x, 1: along y.
    major: usize,
    forward: bool,
    slope: f64,
}

impl Walk {
    fn new(ends: Segment, size: [u32; 2]) -> Self {
        let [a, b] = ends;
        let major = usize::from(!is_x_major(ends));
        let minor = 1 - major;
        let length = |axis: usize| f64::from(b[axis]) - f64::from(a[axis]);
        Self { ends, size, major, forward: b[major] > a[major], slope: length(minor) / length(major) }
    }

    /// How many pixels there are across.
    fn limit(&self) -> u32 {
        self.size[1 - self.major]
    }

    fn pixel(&self, at: u32, aside: u32) -> [u32; 2] {
        if self.major == 0 { [at, aside] } else { [aside, at] }
    }

    /// The columns of the image that the line touches, in order.
    fn columns(&self) -> impl Iterator<Item = u32> + use<> {
        let [a, b] = self.ends.map(|end| end[self.major]);
        let size = self.size[self.major];
        // `as` saturates. A corner of a diamond on the line between two columns belongs to the first.
        let first = ((a.min(b).ceil() - 1.0) as u32).min(size);
        let end = if a.max(b) < 0.0 { 0 } else { (a.max(b).floor() as u32).saturating_add(1).min(size) };
        let end = if self.ends[0] == self.ends[1] { first } else { end.max(first) };
        let forward = self.forward;
        (first..end).map(move |at| if forward { at } else { first + (end - 1 - at) })
    }

    fn meets(&self, centre: f32) -> Meets {
        let [a, b] = self.ends.map(|end| end[self.major]);
        let (beyond, before) = if self.forward { (a > centre, b < centre) } else { (a < centre, b > centre) };
        match (beyond, before) {
            (true, _) => Meets::StartsBeyond,
            (_, true) => Meets::EndsBefore,
            _ => Meets::Crosses,
        }
    }

    /// Where the line crosses a centre line, nearly.
    fn crossing(&self, centre: f32) -> f64 {
        let start = self.ends[0].map(f64::from);
        start[1 - self.major] + (f64::from(centre) - start[self.major]) * self.slope
    }

    /// Whether the line crosses a centre line at or before `aside`, exactly.
    fn reaches(&self, centre: f32, aside: f32, tally: &mut Tally) -> bool {
        let [a, b] = self.ends;
        let [low, high] = if self.forward { [a, b] } else { [b, a] };
        let (point, beyond) = if self.major == 0 {
            ([centre, aside], Sign::Positive)
        } else {
            ([aside, centre], Sign::Negative)
        };
        let side = orient2d(low, high, point, tally);
        side == beyond || side.is_zero()
    }

    /// Whether a point lies in the diamond of a pixel, exactly.
    fn diamond_holds(&self, pixel: [u32; 2], point: [f32; 2]) -> bool {
        let centre = pixel.map(|n| n as f32 + 0.5);
        let sign = |axis: usize| if point[axis] >= centre[axis] { 1.0 } else { -1.0 };
        let [sx, sy] = [sign(0), sign(1)];
        let [px, py] = point.map(f64::from);
        // |x - cx| + |y - cy| - 1/2; what stands last is a multiple of 1/2.
        let rest = -(sx * f64::from(centre[0]) + sy * f64::from(centre[1])) - 0.5;
        let below = point[1] > centre[1];
        let right_corner = point[1] == centre[1] && point[0] > centre[0] && self.major == 1;
        match Expansion::sum_of([sx * px, sy * py, rest]).sign() {
            Sign::Negative => true,
            Sign::Zero => below || right_corner,
            Sign::Positive => false,
        }
    }
}

/// Whether `|dx| >= |dy|`, exactly.
fn is_x_major([a, b]: Segment) -> bool {
    let terms = |axis: usize| {
        let [low, high] = [a[axis].min(b[axis]), a[axis].max(b[axis])].map(f64::from);
        [high, -low]
    };
    let ([x1, x0], [y1, y0]) = (terms(0), terms(1));
    Expansion::sum_of([x1, x0, -y1, -y0]).sign() != Sign::Negative
}
