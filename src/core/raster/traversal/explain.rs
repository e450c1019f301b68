//! What the lab shows of a traversal.

use super::{
    Area, Direction, Event, Show, Traversal, Verdict,
    cells::{Cell, Cells},
    probe::{Says, says},
    visits::{Visits, of_each_way},
};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, PixelReport, Role, Table, View},
    math::Tally,
    message::{Message, Value},
    raster::{
        Algorithm, Edges, Settings, Span,
        report::{Fate, Subject, ends_of},
        view::view_of,
    },
    replay::State,
};
use std::{marker::PhantomData, sync::Arc};

/// The edges by name.
pub(super) const NAMES: [&str; 3] = ["E0", "E1", "E2"];

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot<A> {
    /// As given; drawn beside the snapped ones if they differ.
    pub(super) given: [[f32; 2]; 3],
    pub(super) vertices: [[f32; 2]; 3],
    settings: Settings,
    /// The edges in the order of the bits; `None` if the area is zero.
    pub(super) edges: Option<Edges>,
    pub(super) show: Show,
    /// What each way looks at; empty if the triangle is large.
    pub(super) ways: Arc<[(Algorithm, Visits)]>,
    pub(super) cells: Cells,
    /// Centres looked at, drawn, and left out behind the triangle.
    pub(super) counts: [u32; 3],
    /// Tiles outside, inside and split, by size.
    pub(super) tiles: [[u32; 3]; 3],
    /// The tiles that were split or decided last, from coarse to fine.
    pub(super) nested: Vec<(u16, u16, u8, Verdict)>,
    /// The centre looked at last.
    pub(super) now: Option<[u16; 2]>,
    way: PhantomData<A>,
}

impl<A: Traversal> Snapshot<A> {
    /// Before the first event.
    pub fn new(given: [[f32; 2]; 3], settings: Settings, show: Show) -> Self {
        let vertices = settings.vertices(given);
        Self {
            given,
            vertices,
            settings,
            edges: Edges::new(vertices, &settings, &mut Tally::default()),
            show,
            ways: of_each_way(given, &settings).into(),
            cells: Cells::default(),
            counts: [0; 3],
            tiles: [[0; 3]; 3],
            nested: Vec::new(),
            now: None,
            way: PhantomData,
        }
    }

    /// The spans found so far, sorted by row.
    pub fn result(&self) -> Vec<Span> {
        self.cells.spans()
    }

    /// What each edge says of a centre, as it was computed.
    pub(super) fn says(&self, [x, y]: [u16; 2]) -> Option<[Says; 3]> {
        self.edges.as_ref().map(|edges| says(edges, &self.settings, [x.into(), y.into()]))
    }

    /// The name of an edge by its ends, such as `V0V1`.
    pub(super) fn ends_of(&self, edge: usize) -> String {
        self.edges.as_ref().map_or_else(String::new, |edges| ends_of(&edges.0[edge], self.vertices))
    }

    /// Whether a tie rule decided about a centre: it lies on an edge and outside of none.
    pub(super) fn tie(&self, at: [u16; 2]) -> Option<usize> {
        let says = self.says(at)?;
        let on = says.iter().position(|edge| edge.tie);
        on.filter(|_| says.iter().all(|edge| edge.tie || edge.draws))
    }

    fn test_sentence(&self, at: [u16; 2], keeps_out: u8) -> Message {
        let [x, y] = at;
        let about = |id| Message::new(id).with("x", u32::from(x)).with("y", u32::from(y));
        let edge = keeps_out.trailing_zeros() as usize;
        let named = |id, edge: usize| {
            about(id).with("edge", Value::text(NAMES[edge])).with("ends", Value::text(self.ends_of(edge)))
        };
        match (keeps_out, self.tie(at)) {
            (0, None) => about("traversal-test-in"),
            (0, Some(edge)) => named("traversal-test-tie-drawn", edge),
            (_, Some(edge)) => named("traversal-test-tie-lost", edge),
            (_, None) => named("traversal-test-out", edge.min(2)),
        }
    }
}

impl<A: Traversal> State for Snapshot<A> {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        let before = |cells: &Cells, x, y| cells.at(x, y).is_some_and(Cell::is_drawn);
        match *event {
            Event::Test { x, y, keeps_out } => {
                self.counts[0] += 1;
                self.counts[1] += u32::from(keeps_out == 0 && !before(&self.cells, x, y));
                self.now = Some([x, y]);
            }
            Event::Tile { x, y, size, verdict } => {
                let level = super::super::tiled::SIZES.iter().position(|s| *s == u32::from(size));
                let kind = match verdict {
                    Verdict::Outside { .. } => 0,
                    Verdict::Inside => 1,
                    Verdict::Split => 2,
                };
                self.tiles[level.unwrap_or_default()][kind] += 1;
                self.nested.retain(|tile| tile.2 > size);
                self.nested.push((x, y, size, verdict));
                self.now = None;
            }
            Event::Skip { centres } => self.counts[2] += u32::from(centres),
            Event::Row { .. } | Event::Done => {
                self.now = None;
                self.nested.clear();
            }
            _ => {}
        }
        let drawn = |cells: &Cells| cells.all().filter(|(_, cell)| cell.is_drawn()).count() as u32;
        self.cells.apply(event);
        if matches!(event, Event::Tile { verdict: Verdict::Inside, .. }) {
            self.counts[1] = drawn(&self.cells);
        }
    }

    fn size_hint(&self) -> usize {
        let [width, height] = [0, 1].map(|axis| {
            let [a, b, c] =
                self.vertices.map(|v| f64::from(v[axis]).clamp(0.0, self.settings.size[axis].into()));
            a.max(b).max(c) - a.min(b).min(c) + 1.0
        });
        size_of::<Self>() + Cells::size_hint(width, height)
    }
}

impl<A: Traversal> Explain for Snapshot<A> {
    const NAME: &'static str = A::NAME;

    const PREFIX: &'static str = "traversal";

    const LISTING: &'static [&'static str] = A::LISTING;

    fn line(event: &Event) -> usize {
        A::line(event)
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done | Event::ZeroArea => Level::Primitive,
            Event::Row { .. } | Event::Tile { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // Three edge functions: two products and a comparison each.
            Event::Test { .. } => Operations::new(3, 6, 0),
            Event::Tile { verdict: Verdict::Outside { edge }, .. } => {
                // Two values of each edge that lets the tile pass, one of the edge that does not.
                let values = 2 * u64::from(*edge) + 1;
                Operations::new(values, 2 * values, 0)
            }
            Event::Tile { .. } => Operations::new(6, 12, 0),
            Event::Box { .. } => Operations::new(8, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::ZeroArea => (Role::Skipped, Some("traversal-marker-zero-area")),
            Event::Tile { verdict: Verdict::Outside { .. }, size: 16.., .. } => (Role::Rejected, None),
            Event::Tile { verdict: Verdict::Inside, .. } => (Role::Accepted, None),
            Event::Row { .. } => (Role::Neutral, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("traversal-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::ZeroArea => Message::new("traversal-zero-area"),
            Event::Box { columns: [left, right], rows: [top, bottom] } => Message::new("traversal-box")
                .with("count", self.cells.len())
                .with("left", u32::from(left))
                .with("right", u32::from(right.saturating_sub(1)))
                .with("top", u32::from(top))
                .with("bottom", u32::from(bottom.saturating_sub(1))),
            Event::Row { y } => Message::new("traversal-row").with("y", u32::from(y)),
            Event::Turn { x, to } => {
                let id = match to {
                    Direction::Left => "traversal-turn-left",
                    Direction::Right => "traversal-turn-right",
                };
                Message::new(id).with("x", u32::from(x))
            }
            Event::Tile { x, y, size, verdict } => {
                let about = |id| {
                    Message::new(id)
                        .with("x", u32::from(x))
                        .with("y", u32::from(y))
                        .with("size", u32::from(size))
                };
                match verdict {
                    Verdict::Outside { edge } => {
                        let edge = usize::from(edge);
                        about("traversal-tile-outside")
                            .with("edge", Value::text(NAMES[edge]))
                            .with("ends", Value::text(self.ends_of(edge)))
                    }
                    Verdict::Inside => about("traversal-tile-inside"),
                    Verdict::Split if size == 4 => about("traversal-tile-tested"),
                    Verdict::Split => about("traversal-tile-split").with("part", u32::from(size / 4)),
                }
            }
            Event::Test { x, y, keeps_out } => self.test_sentence([x, y], keeps_out),
            Event::Skip { centres } => Message::new("traversal-skip").with("count", u32::from(centres)),
            Event::Done => {
                let [tested, drawn, _] = self.counts;
                Message::new("traversal-done").with("tested", tested).with("count", drawn)
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        out.extend(self.formula(event));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        self.list(out);
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        view_of(&[self.vertices], &self.settings)
    }

    fn pixel(&self, at @ [x, y]: [u32; 2]) -> Option<PixelReport> {
        let Self { given, vertices, settings, .. } = *self;
        let area = Area::new(vertices, &settings);
        let in_box = area.columns.contains(&x) && area.rows.contains(&y);
        let fate = if in_box { Fate::Asked } else { Fate::OutsideBox };
        Subject { given, vertices, edges: self.edges.as_ref(), settings: &settings, fate }.report(at)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for Span { y, begin, end } in self.result() {
            out.extend((begin..end).map(|x| Fact::pixel([x, y], Vec::new())));
        }
    }
}
