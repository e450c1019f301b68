//! The state of a Sutherland-Hodgman run: the fold of its events.

use super::{
    super::outline::{Carrier, Corner, Place, Source, drop_corner},
    Event, Settings,
};
use crate::{
    clip::line::{Border, Point, Window},
    math::ulps_between,
    replay::State,
};
use std::sync::Arc;

/// An edge that was looked at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Looked {
    pub(super) from: Place,
    pub(super) to: Place,
    /// How many corners had been emitted before.
    pub(super) emitted: usize,
}

/// A side that has cut, with the corners before and after.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sided {
    pub(super) border: Border,
    pub(super) before: usize,
    pub(super) after: Option<usize>,
}

/// What the user sees between two events.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) given: Arc<[Vec<Point>]>,
    pub(super) window: Window,
    pub(super) settings: Settings,
    /// Which polygon is being clipped.
    pub(super) current: Option<usize>,
    /// It as it stands, and what the side at work has emitted.
    pub(super) polygon: Vec<Corner>,
    pub(super) out: Vec<Corner>,
    /// The sides that have cut it; the last one may be at work.
    pub(super) sides: Vec<Sided>,
    /// The edges that this side has looked at.
    pub(super) looked: Vec<Looked>,
    /// Where the first corner lies, once known.
    pub(super) first: Option<Place>,
    /// What is left of the polygons that are done.
    pub(super) results: Vec<Vec<Corner>>,
}

/// A cut of an edge that two polygons share, computed twice with different results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crack {
    /// Where the edge was cut.
    pub border: Border,
    /// The corner that each polygon got.
    pub ends: [Point; 2],
}

impl Crack {
    /// How far apart the two are, in units of the last place of binary32.
    pub fn ulps(&self) -> u64 {
        let free = 1 - self.border.axis();
        ulps_between(self.ends[0][free], self.ends[1][free])
    }
}

impl Snapshot {
    /// Before the first event.
    pub fn new(given: Arc<[Vec<Point>]>, window: Window, settings: Settings) -> Self {
        Self {
            given,
            window,
            settings,
            current: None,
            polygon: Vec::new(),
            out: Vec::new(),
            sides: Vec::new(),
            looked: Vec::new(),
            first: None,
            results: Vec::new(),
        }
    }

    /// What is left of each polygon that is done.
    pub fn results(&self) -> &[Vec<Corner>] {
        &self.results
    }

    /// The side at work.
    pub(super) fn side(&self) -> Option<Border> {
        self.sides.last().filter(|side| side.after.is_none()).map(|side| side.border)
    }

    /// The corners of the polygon at hand as they were given.
    pub(super) fn points(&self) -> &[Point] {
        self.current.map_or(&[], |current| &self.given[current])
    }

    /// Start and end of the edge that was looked at last.
    pub(super) fn edge(&self) -> Option<[&Corner; 2]> {
        let last = self.looked.len().checked_sub(1)?;
        Some([&self.polygon[last], &self.polygon[(last + 1) % self.polygon.len()]])
    }

    /// Whether the edge that was looked at last leads back to the first corner.
    pub(super) fn is_closing(&self) -> bool {
        self.looked.len() == self.polygon.len()
    }

    /// The name of a corner: `V3` is given, `i3` is edge 3 cut at the first side (`j3` at the second),
    /// `C2` is a corner of the window. Those of a neighbour have a prime.
    pub(super) fn name(&self, source: Source, polygon: usize) -> String {
        let name = match source {
            Source::Vertex(index) => format!("V{index}"),
            Source::Crossing { edge, border } => {
                let stage = self.settings.order.sides().into_iter().position(|side| side == border);
                format!("{}{edge}", ["i", "j", "k", "l"][stage.unwrap_or_default()])
            }
            Source::Window(borders) => {
                let upper = |axis: usize| borders.iter().any(|b| b.axis() == axis && b.is_upper());
                let corner = match (upper(0), upper(1)) {
                    (false, false) => 0,
                    (true, false) => 1,
                    (true, true) => 2,
                    (false, true) => 3,
                };
                format!("C{corner}")
            }
        };
        name + &"′".repeat(polygon.min(3))
    }

    /// The name of a corner of the polygon at hand.
    pub(super) fn name_here(&self, source: Source) -> String {
        self.name(source, self.current.unwrap_or_default())
    }

    /// Cuts of shared edges, where both polygons have one, that differ.
    pub fn cracks(&self) -> Vec<Crack> {
        let mut cracks = Vec::new();
        for (first, ours) in self.results.iter().enumerate() {
            for (second, theirs) in self.results.iter().enumerate().skip(first + 1) {
                for corner in ours {
                    let Source::Crossing { edge, border } = corner.source else { continue };
                    let [p, q] = self.given_edge(first, edge);
                    let twin = theirs.iter().find(|twin| match twin.source {
                        Source::Crossing { edge, border: same } => {
                            same == border && self.given_edge(second, edge) == [q, p]
                        }
                        _ => false,
                    });
                    if let Some(twin) = twin.filter(|twin| twin.at != corner.at) {
                        cracks.push(Crack { border, ends: [corner.at, twin.at] });
                    }
                }
            }
        }
        cracks
    }

    fn given_edge(&self, polygon: usize, edge: u32) -> [Point; 2] {
        let (points, edge) = (&self.given[polygon], edge as usize);
        [points[edge], points[(edge + 1) % points.len()]]
    }

    fn cut(&mut self, at: Point, source: Source) {
        let (Some(border), Some([s, _]), Some(looked)) = (self.side(), self.edge(), self.looked.last())
        else {
            return;
        };
        let next = if looked.to == Place::Out { Carrier::Border(border) } else { s.next };
        self.out.push(Corner { at, source, next });
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Begin { polygon } => {
                let polygon = polygon as usize;
                self.current = Some(polygon);
                self.polygon =
                    self.given[polygon].iter().enumerate().map(|(i, &at)| Corner::given(i, at)).collect();
                self.sides.clear();
                self.looked.clear();
            }
            Event::Side { border } => {
                self.sides.push(Sided { border, before: self.polygon.len(), after: None });
                self.looked.clear();
                self.first = None;
            }
            Event::First { place } => {
                self.first = Some(place);
                self.out.extend(self.polygon.first().filter(|_| place != Place::Out));
            }
            Event::Edge { from, to } => self.looked.push(Looked { from, to, emitted: self.out.len() }),
            Event::Cut { at, source } => self.cut(at, source),
            Event::Touch => {
                let leaves = self.looked.last().is_some_and(|looked| looked.to == Place::Out);
                if let (true, Some(border), Some(last)) = (leaves, self.side(), self.out.last_mut()) {
                    last.next = Carrier::Border(border);
                }
            }
            Event::Keep => {
                let end = self.edge().map(|[_, e]| *e);
                self.out.extend(end);
            }
            Event::SideDone { .. } => {
                self.polygon = std::mem::take(&mut self.out);
                self.looked.clear();
                if let Some(side) = self.sides.last_mut() {
                    side.after = Some(self.polygon.len());
                }
            }
            Event::Drop { corner, why } => drop_corner(&mut self.polygon, corner as usize, why),
            Event::Done { .. } => self.results.push(std::mem::take(&mut self.polygon)),
        }
    }

    fn size_hint(&self) -> usize {
        let corners = self.polygon.len() + self.out.len() + self.results.iter().map(Vec::len).sum::<usize>();
        size_of::<Self>() + corners * size_of::<Corner>() + self.looked.len() * size_of::<Looked>()
    }
}
