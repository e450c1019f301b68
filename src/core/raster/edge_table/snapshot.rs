//! The state of an edge table run: the fold of its events.

use super::{Event, Point, Settings, active::order, fill, names};
use crate::{
    math::Tally,
    raster::{Span, YAxis},
    replay::State,
};
use std::sync::Arc;

/// Of polygons up to this many pixels those still to come are shown.
const SHOWS_PENDING: u64 = 2048;

/// An edge that was looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Listed {
    pub(super) edge: u32,
    /// The rows that it crosses, from the highest to the lowest; none if it was left out.
    pub(super) rows: Option<[u32; 2]>,
    pub(super) dx_dy: Option<f64>,
}

/// An edge that crosses the row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Live {
    pub(super) edge: u32,
    /// Where the centre line of the row before met it.
    pub(super) before: Option<f64>,
    /// Where the row's centre line meets it, once computed.
    pub(super) x: Option<f64>,
    /// The first column at or right of it, once found.
    pub(super) first: Option<u32>,
    pub(super) is_tie: bool,
    /// The winding number to its right, once stepped over.
    pub(super) winding: Option<i32>,
}

impl Live {
    /// An edge that the row has not looked at yet.
    fn new(edge: u32, before: Option<f64>) -> Self {
        Self { edge, before, x: None, first: None, is_tie: false, winding: None }
    }
}

/// What the user sees between two events.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) given: Arc<[Vec<Point>]>,
    /// As they are used: given, or snapped.
    pub(super) used: Arc<[Vec<Point>]>,
    pub(super) settings: Settings,
    /// In the order of the contours; by first row once the table is complete.
    pub(super) table: Vec<Listed>,
    pub(super) active: Vec<Live>,
    pub(super) row: Option<u32>,
    /// Those of the row so far included.
    pub(super) spans: Vec<Span>,
    /// The edge that the step is about.
    pub(super) at: Option<u32>,
    /// The spans that the run will find; none of a large polygon.
    pub(super) outcome: Arc<[Span]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(given: Arc<[Vec<Point>]>, settings: Settings) -> Self {
        let mut outcome = Vec::new();
        let counts = fill(&given, &settings, &mut Tally::default(), &mut |span| outcome.push(span));
        if counts.covered > SHOWS_PENDING {
            outcome.clear();
        }
        let used =
            given.iter().map(|corners| corners.iter().map(|&at| settings.corner(at)).collect()).collect();
        Self {
            given,
            used,
            settings,
            table: Vec::new(),
            active: Vec::new(),
            row: None,
            spans: Vec::new(),
            at: None,
            outcome: outcome.into(),
        }
    }

    /// The spans found so far.
    pub fn result(&self) -> &[Span] {
        &self.spans
    }

    pub(super) fn name(&self, edge: u32) -> String {
        names::edge(&self.used, edge)
    }

    pub(super) fn ends(&self, edge: u32) -> [Point; 2] {
        names::ends(&self.used, edge)
    }

    pub(super) fn live(&self, edge: u32) -> Option<&Live> {
        self.active.iter().find(|live| live.edge == edge)
    }

    /// What stepping over an edge from left to right adds to the winding number.
    pub(super) fn direction(&self, edge: u32) -> i32 {
        let [a, b] = self.ends(edge);
        if (a[1] < b[1]) == (self.settings.y_axis == YAxis::Down) { 1 } else { -1 }
    }

    fn pixels_of(spans: &[Span]) -> u64 {
        spans.iter().map(|span| u64::from(span.len())).sum()
    }

    /// How many pixels are drawn so far.
    pub(super) fn pixels(&self) -> u64 {
        Self::pixels_of(&self.spans)
    }

    /// The spans of the row.
    pub(super) fn here(&self) -> &[Span] {
        let first = self.spans.iter().rposition(|span| Some(span.y) != self.row).map_or(0, |last| last + 1);
        &self.spans[first..]
    }

    /// How many pixels are drawn in the row.
    pub(super) fn pixels_here(&self) -> u64 {
        Self::pixels_of(self.here())
    }

    fn draw(&mut self, begin: u32, end: u32) {
        let Some(y) = self.row.filter(|_| begin < end) else { return };
        match self.spans.last_mut() {
            Some(last) if last.y == y && last.end == begin => last.end = end,
            _ => self.spans.push(Span { y, begin, end }),
        }
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        let live = |active: &mut Vec<Live>, edge: u32, change: &dyn Fn(&mut Live)| {
            active.iter_mut().filter(|live| live.edge == edge).for_each(change);
        };
        self.at = event.edge();
        match *event {
            Event::LeftOut { edge } => {
                self.table.push(Listed { edge, rows: None, dx_dy: None });
            }
            Event::Edge { edge, first, last } => {
                self.table.push(Listed { edge, rows: Some([first, last]), dx_dy: None });
            }
            Event::Slope { dx_dy, .. } => {
                if let Some(last) = self.table.last_mut() {
                    last.dx_dy = Some(dx_dy);
                }
            }
            Event::Built { .. } => {
                // Those left out last. From line to row is from row to line as well.
                let settings = self.settings;
                self.table.sort_by_key(|listed| listed.rows.map_or(u32::MAX, |[y, _]| settings.row(y)));
            }
            Event::Row { y } => {
                self.row = Some(y);
                self.active.iter_mut().for_each(|live| *live = Live::new(live.edge, live.x));
            }
            Event::Take { edge } => {
                self.active.push(Live::new(edge, None));
            }
            Event::Crossing { edge, x } => {
                live(&mut self.active, edge, &|live| live.x = Some(x));
            }
            Event::First { edge, x, .. } => live(&mut self.active, edge, &|live| live.first = Some(x)),
            Event::Tie { edge, .. } => live(&mut self.active, edge, &|live| live.is_tie = true),
            Event::Sorted => {
                let key = |live: &Live| (live.first.unwrap_or(0), live.x.unwrap_or(0.0));
                self.active.sort_by(|a, b| order(key(a), key(b)));
            }
            Event::Across { edge, winding } => {
                live(&mut self.active, edge, &|live| live.winding = Some(winding));
            }
            Event::Span { begin, end } => self.draw(begin, end),
            Event::RowDone => {}
            Event::Drop { edge } => self.active.retain(|live| live.edge != edge),
            Event::Done => self.row = None,
        }
    }

    fn size_hint(&self) -> usize {
        let edges: usize = self.used.iter().map(Vec::len).sum();
        size_of::<Self>()
            + edges * (size_of::<Listed>() + size_of::<Live>())
            + self.outcome.len().max(self.spans.len()) * size_of::<Span>()
    }
}
