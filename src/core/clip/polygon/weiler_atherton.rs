//! Weiler-Atherton polygon clipping: walk along the polygon where it is inside the window, and along the
//! window's border where that is inside the polygon.
//!
//! The border is labelled inside and outside by turns, as Greiner and Hormann do it, not by the turning
//! sense of the polygon: so contours may cross themselves and each other, in any direction, and what they
//! surround is decided by the even-odd rule. Against a rectangle that is all there is to be decided, so
//! that it can be decided without an error: the window counts as smaller by ε on the left and the right
//! and by ε² at the bottom and the top, with ε too small for any number. Then no corner lies on a border
//! and no edge along one or through a corner; every crossing is a real one. See `crossings.rs`.
//!
//! *Source:* Weiler and Atherton, Hidden Surface Removal Using Polygon Area Sorting, SIGGRAPH 1977;
//! Greiner and Hormann, Efficient Clipping of Arbitrary Polygons, ACM Transactions on Graphics 17, 1998;
//! Edelsbrunner and Mücke, Simulation of Simplicity, 1990 (the ε). Deviations: the window is a
//! rectangle; the labels come from one winding number and the order around the window.

mod crossings;
mod explain;
mod picture;
mod rings;
mod snapshot;

pub use snapshot::Snapshot;

pub use super::outline::{Carrier, Corner, Source, Why};

use super::outline::Given;
use crate::{
    clip::line::{Border, Point, Window},
    math::Tally,
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use crossings::{Crossing, Crossings};
use serde::Serialize;
use std::sync::Arc;

/// The borders in the order in which the walk around the window meets them, from its lower left corner
/// on, counter-clockwise.
pub const ROUND: [Border; 4] = [Border::Bottom, Border::Right, Border::Top, Border::Left];

/// A closed outline: what it surrounds is inside the window, and inside or outside the polygon.
pub type Ring = Vec<Corner>;

/// A connected part of what is left.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Around it.
    pub outer: Ring,
    /// Around what is missing in it.
    pub holes: Vec<Ring>,
}

/// What the algorithm did. Edge `i` runs from corner `i` to the next of its contour; corners are counted
/// through all contours.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The next edge was looked at.
    Edge {
        /// The edge.
        edge: u32,
    },
    /// It crosses a border of the window.
    Cross {
        /// Where.
        at: Point,
        /// The edge.
        edge: u32,
        /// The border.
        border: Border,
        /// Whether the edge comes into the window there.
        enters: bool,
    },
    /// The walk around the window starts at its lower left corner.
    Origin {
        /// How often the contours wind around that corner; odd is inside.
        winding: i32,
    },
    /// The next crossing around the window.
    Next {
        /// The crossing, as they were found.
        crossing: u32,
        /// Whether the border behind it is inside the polygon.
        inside: bool,
    },
    /// A ring starts at an entering crossing.
    Start {
        /// The crossing.
        crossing: u32,
    },
    /// The ring follows the polygon to a corner of it.
    Follow {
        /// The corner.
        corner: u32,
    },
    /// The ring follows the polygon to its next crossing.
    Reach {
        /// The crossing.
        crossing: u32,
    },
    /// The ring follows the border to a corner of the window.
    Turn {
        /// Which, counter-clockwise from the lower left one.
        corner: u8,
    },
    /// The ring follows the border to the next crossing.
    Arrive {
        /// The crossing.
        crossing: u32,
    },
    /// The ring is back where it started.
    Close,
    /// A contour that crosses nothing and is inside the window is a ring of its own.
    Whole {
        /// The contour.
        contour: u32,
        /// Whether it surrounds what is outside of the polygon.
        hole: bool,
    },
    /// The border is crossed nowhere and inside the polygon: the window is a ring.
    Window,
    /// A corner of the ring was dropped.
    Drop {
        /// Its index among those that are left.
        corner: u32,
        /// Why.
        why: Why,
    },
    /// The ring is done.
    RingDone {
        /// How many corners it has; none if it has no area.
        corners: u32,
    },
    /// A hole was given to the piece around it.
    Hole {
        /// The ring, among those that are left.
        ring: u32,
        /// The outer ring, likewise.
        outer: u32,
    },
    /// Everything is done.
    Done {
        /// How many pieces there are.
        pieces: u32,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Clips a polygon of one or more closed contours against a window: the pieces that are left, with their
/// holes.
///
/// Contours of finite corners, any number of them, any shape and direction; what is inside follows the
/// even-odd rule. Each corner of the result is a given one bit for bit, a corner of the window, or a
/// crossing rounded once. What has no area is left out: touching is not enough. The covered set is that of
/// Sutherland-Hodgman. Rings of one contour that does not cross itself keep its direction. Costs four
/// signs an edge that is not inside, and a sort of the crossings.
pub fn clip(contours: &[Vec<Point>], window: &Window) -> Vec<Piece> {
    clip_traced(contours, window, &mut Tally::default(), &mut NoTrace)
}

/// [`clip`] as a run that can be scrubbed.
pub fn play(contours: &[Vec<Point>], window: Window, budget: Budget) -> Player<Snapshot> {
    let contours: Arc<[Vec<Point>]> = contours.into();
    Player::new(Snapshot::new(&contours, window), budget, move |t| {
        clip_traced(&contours, &window, &mut Tally::default(), t);
    })
}

/// The algorithm: [`clip`] and [`play`] are this with two tracers. `tally` counts exact decisions.
pub fn clip_traced<T: Tracer<Event>>(
    contours: &[Vec<Point>],
    window: &Window,
    tally: &mut Tally,
    t: &mut T,
) -> Vec<Piece> {
    // A window without area holds nothing that has one.
    if window.xmin == window.xmax || window.ymin == window.ymax {
        t.emit(|| Event::Done { pieces: 0 });
        return Vec::new();
    }
    let points: Vec<Point> = contours.concat();
    let starts = starts(contours);
    let given = Given { points: &points, starts: &starts, window };

    let found = Crossings::find(&given, tally, t);
    let mut rings = Vec::new();
    let mut finish = |ring: Ring, hole: bool, tally: &mut Tally, t: &mut T| {
        let mut ring = ring;
        given.tidy(&mut ring, tally, |corner, why| t.emit(|| Event::Drop { corner: corner as u32, why }));
        t.emit(|| Event::RingDone { corners: ring.len() as u32 });
        if !ring.is_empty() {
            rings.push((ring, hole));
        }
    };
    let mut used = vec![false; found.list.len()];
    for start in 0..found.list.len() {
        if found.list[start].enters && !used[start] {
            let ring = walk(&given, &found, start, &mut used, t);
            finish(ring, false, tally, t);
        }
    }
    for contour in 0..starts.len() {
        if found.of_contour(contour).is_empty() && given.is_inside(starts[contour]) {
            let hole = given.is_hole(contour, tally);
            t.emit(|| Event::Whole { contour: contour as u32, hole });
            finish(
                given.contour(contour).map(|i| Corner::given(i as usize, points[i as usize])).collect(),
                hole,
                tally,
                t,
            );
        }
    }
    if found.list.is_empty() && found.winding % 2 != 0 {
        t.emit(|| Event::Window);
        finish(whole_window(&given, found.winding), false, tally, t);
    }
    let pieces = given.pieces(rings, tally, |ring, outer| {
        t.emit(|| Event::Hole { ring: ring as u32, outer: outer as u32 });
    });
    t.emit(|| Event::Done { pieces: pieces.len() as u32 });
    pieces
}

/// Where each contour starts among the corners of all.
fn starts(contours: &[Vec<Point>]) -> Vec<u32> {
    let lengths = contours.iter().map(|contour| contour.len() as u32);
    lengths.scan(0, |end, length| Some(std::mem::replace(end, *end + length))).collect()
}

/// One ring: from an entering crossing along the polygon, then along the border inside it, by turns.
fn walk<T: Tracer<Event>>(
    given: &Given<'_>,
    found: &Crossings,
    start: usize,
    used: &mut [bool],
    t: &mut T,
) -> Ring {
    t.emit(|| Event::Start { crossing: start as u32 });
    let mut ring = Vec::new();
    let mut here = start;
    loop {
        let there = found.partner(here);
        follow(given, [&found.list[here], &found.list[there]], &mut ring, t);
        (used[here], used[there]) = (true, true);
        t.emit(|| Event::Reach { crossing: there as u32 });

        let (next, turns) = found.along_border(there);
        let leaving = &found.list[there];
        let mut corner = leaving.corner(leaving.border);
        for (turn, after) in turns {
            ring.push(corner);
            t.emit(|| Event::Turn { corner: turn });
            corner = window_corner(given, turn, after);
        }
        ring.push(corner);
        if next == start {
            t.emit(|| Event::Close);
            return ring;
        }
        t.emit(|| Event::Arrive { crossing: next as u32 });
        here = next;
    }
}

/// Appends the first crossing and the corners between the two, along the polygon in either direction.
fn follow<T: Tracer<Event>>(given: &Given<'_>, [from, to]: [&Crossing; 2], ring: &mut Ring, t: &mut T) {
    ring.push(Corner { next: Carrier::Edge(from.edge), ..from.corner(from.border) });
    let [first, last] = if from.enters { [from, to] } else { [to, from] };
    let mut between = Vec::new();
    let mut edge = first.edge;
    while edge != last.edge {
        edge = given.next(edge);
        between.push(edge);
    }
    if !from.enters {
        between.reverse();
    }
    for (i, &corner) in between.iter().enumerate() {
        // Backwards, a corner is followed by the edge that leads to it.
        let next = match (from.enters, between.get(i + 1)) {
            (true, _) => corner,
            (false, Some(before)) => *before,
            (false, None) => to.edge,
        };
        let at = given.points[corner as usize];
        ring.push(Corner { at, source: Source::Vertex(corner), next: Carrier::Edge(next) });
        t.emit(|| Event::Follow { corner });
    }
}

/// Corner `index` of the window, counter-clockwise from the lower left one, and the border after it.
fn window_corner(given: &Given<'_>, index: u8, after: Border) -> Corner {
    let index = usize::from(index);
    let borders = [ROUND[(index + 3) % 4], ROUND[index % 4]];
    let next = Carrier::Border(after);
    Corner { at: given.window_corner(borders), source: Source::Window(borders), next }
}

/// The window, in the direction in which the polygon winds around it.
fn whole_window(given: &Given<'_>, winding: i32) -> Ring {
    match winding {
        1.. => [0, 1, 2, 3].map(|i| window_corner(given, i, ROUND[usize::from(i)])).into(),
        _ => [3, 2, 1, 0].map(|i| window_corner(given, i, ROUND[usize::from(i + 3) % 4])).into(),
    }
}
