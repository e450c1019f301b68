//! Sutherland-Hodgman polygon clipping: cut the whole polygon at one side, give what is left to the next.
//!
//! *Source:* Sutherland and Hodgman, Reentrant Polygon Clipping, CACM 17, 1974; Foley et al., Computer
//! Graphics: Principles and Practice, 2nd ed., section 3.14.1. Deviations: one side after the other
//! instead of corner by corner through all sides; in exact arithmetic each corner remembers its source,
//! so that every side decides and cuts by the polygon as it was given; a corner on a border is its own
//! cut and is not emitted twice; at the end, corners that repeat or do not turn are dropped. Where nobody
//! watches, only what leads out of the window is clipped.

mod bridges;
mod detours;
mod explain;
mod forms;
mod formulas;
mod picture;
mod snapshot;

pub use bridges::bridges;
pub use snapshot::{Crack, Snapshot};

pub use super::outline::{Carrier, Corner, Place, Source, Why};

use super::outline::Given;
use crate::{
    clip::line::{Border, Point, Window},
    math::{Arithmetic, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use forms::{Exact, Form, Taught};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// In which order the sides cut. The covered set is the same, bridging edges may differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum SideOrder {
    /// Left, right, bottom, top.
    #[default]
    LeftRightBottomTop,
    /// Bottom, top, left, right.
    BottomTopLeftRight,
    /// Top, right, bottom, left: around the window.
    TopRightBottomLeft,
    /// Left, bottom, right, top: around the window the other way.
    LeftBottomRightTop,
}

impl SideOrder {
    /// Every order, the default first.
    pub const ALL: [Self; 4] = [
        Self::LeftRightBottomTop,
        Self::BottomTopLeftRight,
        Self::TopRightBottomLeft,
        Self::LeftBottomRightTop,
    ];

    /// The name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::LeftRightBottomTop => "left-right-bottom-top",
            Self::BottomTopLeftRight => "bottom-top-left-right",
            Self::TopRightBottomLeft => "top-right-bottom-left",
            Self::LeftBottomRightTop => "left-bottom-right-top",
        }
    }

    /// The sides in order.
    pub fn sides(self) -> [Border; 4] {
        use Border::{Bottom, Left, Right, Top};
        match self {
            Self::LeftRightBottomTop => [Left, Right, Bottom, Top],
            Self::BottomTopLeftRight => [Bottom, Top, Left, Right],
            Self::TopRightBottomLeft => [Top, Right, Bottom, Left],
            Self::LeftBottomRightTop => [Left, Bottom, Right, Top],
        }
    }
}

/// Mistakes that are often made, to be shown beside the right run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mistake {
    /// Only the left and the bottom side cut: right there, and nowhere else.
    TwoSides,
    /// A cut is computed from whichever end comes first. Neighbours walk along a shared edge in opposite
    /// directions, and rounding then gives them different corners: a crack. In exact arithmetic the
    /// direction cannot matter, and from the inner end it does not.
    EitherEnd,
}

impl Mistake {
    /// Every mistake.
    pub const ALL: [Self; 2] = [Self::TwoSides, Self::EitherEnd];

    /// The name in documents.
    pub fn name(self) -> &'static str {
        match self {
            Self::TwoSides => "two-sides",
            Self::EitherEnd => "either-end",
        }
    }
}

/// The conventions of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Settings {
    /// What cuts are computed in. `F32` and `F64` cut at the corners as they stand, as taught; fixed point
    /// belongs to scan conversion, here it is the exact form.
    pub arithmetic: Arithmetic,
    /// The order of the sides.
    pub order: SideOrder,
    /// What is done wrong on purpose.
    pub mistake: Option<Mistake>,
}

impl Settings {
    /// The sides that cut, in order.
    pub(super) fn sides(&self) -> Vec<Border> {
        let cuts = |border: &Border| {
            self.mistake != Some(Mistake::TwoSides) || matches!(border, Border::Left | Border::Bottom)
        };
        self.order.sides().into_iter().filter(cuts).collect()
    }
}

/// What the algorithm did.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The next polygon was taken as it was given.
    Begin {
        /// Its index.
        polygon: u32,
    },
    /// The next side begins to cut.
    Side {
        /// The side.
        border: Border,
    },
    /// The first corner was looked at; if it is not beyond the side, it is emitted.
    First {
        /// Where it lies.
        place: Place,
    },
    /// The next edge was looked at.
    Edge {
        /// Where it starts.
        from: Place,
        /// Where it ends.
        to: Place,
    },
    /// The edge crosses the side: the cut was emitted.
    Cut {
        /// The cut.
        at: Point,
        /// Where it comes from.
        source: Source,
    },
    /// The edge comes from beyond and ends on the side, or the other way round: that end is the cut.
    Touch,
    /// The end of the edge was emitted.
    Keep,
    /// The side is done; what was emitted is the polygon now.
    SideDone {
        /// How many corners it has.
        corners: u32,
    },
    /// A corner of the result was dropped.
    Drop {
        /// Its index among those that are left.
        corner: u32,
        /// Why.
        why: Why,
    },
    /// The polygon is clipped.
    Done {
        /// How many corners are left; none if nothing with an area is.
        corners: u32,
    },
}
// A cut is its place and its source, eight bytes each, and the kind of event.
const _: () = assert!(size_of::<Event>() <= 20);

/// Room for the corners during clipping, kept from call to call so that nothing is allocated.
#[derive(Clone, Debug, Default)]
pub struct Buffers {
    polygon: Vec<Corner>,
    out: Vec<Corner>,
    room: detours::Room,
}

/// Clips a closed polygon of finite corners against a window.
///
/// Any number of corners in either winding; convex, concave, self-crossing, degenerate. The winding
/// number around every inner point of the window is kept; pieces that fall apart stay joined by bridging
/// edges along the borders. Each corner of the result is a given one bit for bit, a corner of the window,
/// or the point where a given edge crosses a border, rounded once. So the result does not depend on where
/// the polygon starts, which way it turns, or what its neighbours are, and no corner is outside.
///
/// No corner occurs twice in a row, and none lies on the straight line through its neighbours. What lies
/// on one line has no area and gives no corner. Costs about 3 ns a corner and 20 ns a cut.
pub fn clip(polygon: &[Point], window: &Window) -> Vec<Point> {
    let mut out = Vec::new();
    clip_into(polygon, window, &mut Buffers::default(), &mut out);
    out
}

/// [`clip`] into a list of the caller's, which is emptied first; does not allocate once `buffers` and
/// `out` have grown.
pub fn clip_into(polygon: &[Point], window: &Window, buffers: &mut Buffers, out: &mut Vec<Point>) {
    out.clear();
    if detours::clip(polygon, window, &mut buffers.room, out).is_some() {
        return;
    }
    let some = buffers.room.some;
    let cutting = SideOrder::default().sides().into_iter().filter(|&border| some.has(border));
    let mut tally = Tally::default();
    run(&mut Exact::new(Given::one(polygon, window), &mut tally), cutting, buffers, &mut NoTrace);
    out.clear();
    out.extend(buffers.polygon.iter().map(|corner| corner.at));
}

/// [`clip_traced`] as a run that can be scrubbed.
pub fn play(polygons: &[Vec<Point>], window: Window, settings: Settings, budget: Budget) -> Player<Snapshot> {
    let polygons: Arc<[Vec<Point>]> = polygons.into();
    Player::new(Snapshot::new(polygons.clone(), window, settings), budget, move |t| {
        clip_traced(&polygons, &window, settings, &mut Tally::default(), t);
    })
}

/// Clips each polygon, in any arithmetic: what [`clip`] does with its corners' sources, and what the
/// steppable run is made of.
///
/// Rounded arithmetic may answer wrongly or with coordinates that are not finite: showing that is what
/// it is for. `tally` counts exact decisions.
pub fn clip_traced<T: Tracer<Event>>(
    polygons: &[Vec<Point>],
    window: &Window,
    settings: Settings,
    tally: &mut Tally,
    t: &mut T,
) -> Vec<Vec<Corner>> {
    let sides = settings.sides();
    let inner_first = settings.mistake != Some(Mistake::EitherEnd);
    let mut results = Vec::new();
    for (index, points) in polygons.iter().enumerate() {
        t.emit(|| Event::Begin { polygon: index as u32 });
        let (given, sides) = (Given::one(points, window), sides.iter().copied());
        let mut buffers = Buffers::default();
        match settings.arithmetic {
            Arithmetic::F32 => run(&mut Taught::<f32>::new(given, inner_first), sides, &mut buffers, t),
            Arithmetic::F64 => run(&mut Taught::<f64>::new(given, inner_first), sides, &mut buffers, t),
            _ => {
                run(&mut Exact::new(given, tally), sides, &mut buffers, t);
            }
        }
        results.push(buffers.polygon);
    }
    results
}

/// The text of the algorithm, in any form of arithmetic; the result is left in `buffers`.
fn run<F: Form, T: Tracer<Event>>(
    form: &mut F,
    sides: impl Iterator<Item = Border>,
    buffers: &mut Buffers,
    t: &mut T,
) {
    let [mut polygon, mut out] = form.begin(buffers);
    for border in sides {
        t.emit(|| Event::Side { border });
        clip_side(form, border, &polygon, &mut out, t);
        std::mem::swap(&mut polygon, &mut out);
        t.emit(|| Event::SideDone { corners: polygon.len() as u32 });
        if polygon.is_empty() {
            break;
        }
    }
    form.finish(polygon, out, buffers, |corner, why| {
        t.emit(|| Event::Drop { corner: corner as u32, why });
    });
    t.emit(|| Event::Done { corners: buffers.polygon.len() as u32 });
}

/// What one side leaves of a polygon.
fn clip_side<F: Form, T: Tracer<Event>>(
    form: &mut F,
    border: Border,
    polygon: &[Corner<F::At>],
    out: &mut Vec<Corner<F::At>>,
    t: &mut T,
) {
    out.clear();
    let Some(&first) = polygon.first() else { return };
    let place = form.place(&first, border);
    t.emit(|| Event::First { place });
    if place != Place::Out {
        out.push(first);
    }
    out.reserve(polygon.len() + 1);
    let (mut s, mut from) = (first, place);
    for i in 1..=polygon.len() {
        // The last edge leads back to the first corner, which has been dealt with.
        let closing = i == polygon.len();
        let (e, to) = if closing { (first, place) } else { (polygon[i], form.place(&polygon[i], border)) };
        t.emit(|| Event::Edge { from, to });
        match (from, to) {
            (Place::In, Place::Out) | (Place::Out, Place::In) => {
                let leaves = to == Place::Out;
                let at = form.cut(&s, &e, border, leaves);
                let source = match s.next {
                    Carrier::Edge(edge) => Source::Crossing { edge, border },
                    Carrier::Border(own) => Source::Window([own, border]),
                };
                out.push(Corner { at, source, next: if leaves { Carrier::Border(border) } else { s.next } });
                t.emit(|| Event::Cut { at: F::shown(at), source });
            }
            (Place::On, Place::Out) => {
                // From here on the polygon runs along the border.
                if let Some(last) = out.last_mut() {
                    last.next = Carrier::Border(border);
                }
                t.emit(|| Event::Touch);
            }
            (Place::Out, Place::On) => t.emit(|| Event::Touch),
            _ => {}
        }
        if to != Place::Out && !closing {
            out.push(e);
            t.emit(|| Event::Keep);
        }
        (s, from) = (e, to);
    }
}
