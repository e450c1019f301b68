//! What the lab shows of a traversal.

use super::{
    Direction, Event, Traversal, Verdict,
    cells::{Cell, Cells},
};
use crate::{
    compare::Fact,
    explain::{
        Explain, Formula, Label, Level, MOST_PIXELS, Mark, Marker, Operations, Role, Row, Table, View,
    },
    math::{Sign, Tally, edge_value},
    message::{Message, Value},
    raster::{Edges, Settings, Span, edge::centre, view::view_of},
    replay::State,
};
use std::marker::PhantomData;

/// The edges by name.
const NAMES: [&str; 3] = ["E0", "E1", "E2"];

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot<A> {
    /// As given; drawn beside the snapped ones if they differ.
    given: [[f32; 2]; 3],
    vertices: [[f32; 2]; 3],
    settings: Settings,
    /// The edges in the order of the bits; `None` if the area is zero.
    pub(super) edges: Option<Edges>,
    cells: Cells,
    /// Centres looked at, drawn, and left out behind the triangle.
    counts: [u32; 3],
    /// Tiles outside, inside and split, by size.
    tiles: [[u32; 3]; 3],
    /// The tiles that were split or decided last, from coarse to fine.
    nested: Vec<(u16, u16, u8, Verdict)>,
    /// The centre looked at last.
    now: Option<[u16; 2]>,
    way: PhantomData<A>,
}

impl<A: Traversal> Snapshot<A> {
    /// Before the first event.
    pub fn new(given: [[f32; 2]; 3], settings: Settings) -> Self {
        let vertices = settings.vertices(given);
        Self {
            given,
            vertices,
            settings,
            edges: Edges::new(vertices, &settings, &mut Tally::default()),
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
        let mut spans: Vec<Span> = Vec::new();
        for ([x, y], cell) in self.cells.all().filter(|(_, cell)| cell.is_drawn()) {
            let _: Cell = cell;
            let [x, y] = [x, y].map(u32::from);
            match spans.last_mut() {
                Some(span) if span.y == y => span.end = x + 1,
                _ => spans.push(Span { y, begin: x, end: x + 1 }),
            }
        }
        spans
    }

    /// The value of an edge function at a centre, rounded for show, and its exact sign.
    pub(super) fn value(&self, edge: usize, [x, y]: [u16; 2]) -> Option<(f64, Sign)> {
        let edge = self.edges.as_ref()?.0[edge];
        let at = centre(x.into(), y.into());
        let sign = edge.side(at, &mut Tally::default());
        let value = edge_value(edge.ends[0], edge.ends[1], at).value;
        Some((if sign.is_zero() { 0.0 } else { value }, sign))
    }

    /// The name of an edge by its ends, such as `V0V1`.
    fn ends_of(&self, edge: usize) -> String {
        let name = |p: [f32; 2]| {
            let index = self.vertices.iter().position(|vertex| *vertex == p).unwrap_or_default();
            format!("V{index}")
        };
        self.edges.as_ref().map_or_else(String::new, |edges| edges.0[edge].ends.map(name).concat())
    }

    /// Whether a tie rule decided about a centre: it lies on an edge and outside of none.
    fn tie(&self, at: [u16; 2]) -> Option<usize> {
        let signs = [0, 1, 2].map(|edge| self.value(edge, at).map_or(Sign::Positive, |(_, sign)| sign));
        let on = signs.iter().position(|sign| sign.is_zero());
        on.filter(|_| signs.iter().all(|sign| !sign.is_negative()))
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
        let rows = NAMES.into_iter().enumerate().map(|(edge, name)| {
            let value = self.now.and_then(|at| self.value(edge, at));
            let kept = self.now.and_then(|at| self.cells.at(at[0], at[1]));
            let out = kept.is_some_and(|cell| cell.keeps_out() & 1 << edge != 0);
            let word = match value {
                None => Value::None,
                Some((_, sign)) if sign.is_zero() && out => Value::Word("traversal-tie-lost"),
                Some((_, sign)) if sign.is_zero() => Value::Word("traversal-tie-drawn"),
                Some(_) if out => Value::Word("traversal-keeps-out"),
                Some(_) => Value::Word("traversal-lets-in"),
            };
            let role = match value {
                Some((_, sign)) if sign.is_zero() => Some(Role::Tie),
                Some(_) if out => Some(Role::Rejected),
                _ => None,
            };
            let cells = vec![Value::text(self.ends_of(edge)), value.map(|(value, _)| value).into(), word];
            Row::new(name, cells).role(role)
        });
        out.push(Table {
            title: "traversal-edges",
            columns: vec!["column-traversal-edge", "column-traversal-value", "column-traversal-verdict"],
            rows: rows.collect(),
        });
        let [tested, drawn, skipped] = self.counts;
        let count = |name: &str, count: u32| Row::new(name, vec![count.into()]);
        let mut rows = vec![
            count("row-traversal-box", self.cells.len() as u32),
            count("row-traversal-tested", tested),
            count("row-traversal-drawn", drawn),
            count("row-traversal-wasted", self.wasted()),
            count("row-traversal-skipped", skipped),
        ];
        rows.retain(|row| row.name != "row-traversal-skipped" || skipped > 0);
        out.push(Table { title: "traversal-counts", columns: vec!["column-traversal-centres"], rows });
        if A::NAME == super::super::tiled::Tiled::NAME {
            let rows = super::super::tiled::SIZES.into_iter().zip(self.tiles).map(|(size, counts)| {
                let active = self.nested.last().is_some_and(|tile| u32::from(tile.2) == size);
                Row::new(format!("{size} × {size}"), counts.map(Value::from).to_vec()).active(active)
            });
            out.push(Table {
                title: "traversal-tiles",
                columns: vec![
                    "column-traversal-outside",
                    "column-traversal-inside",
                    "column-traversal-split",
                ],
                rows: rows.collect(),
            });
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let many = self.cells.len() > MOST_PIXELS;
        if many {
            let spans = self.result().into_iter();
            out.extend(spans.map(|Span { y, begin, end }| Mark::Run {
                y: y as i32,
                columns: [begin as i32, end as i32],
                role: Role::Accepted,
                object: Some(0),
            }));
        } else {
            for ([x, y], cell) in self.cells.all() {
                let again = if cell.tests() > 1 { Value::from(cell.tests()) } else { Value::BLANK };
                if cell.is_drawn() {
                    out.push(pixel([x, y], Role::Accepted, Some(0), again));
                } else if cell.tests() > 0 {
                    out.push(pixel([x, y], Role::Skipped, None, again));
                }
            }
        }
        if self.given != self.vertices {
            out.push(outline(self.given.to_vec(), Role::Exact));
        }
        for &(x, y, size, verdict) in &self.nested {
            let [left, top] = [x, y].map(f32::from);
            let (right, bottom) = (left + f32::from(size), top + f32::from(size));
            let now = matches!(event, Some(Event::Tile { size: of, .. }) if *of == size);
            let role = match verdict {
                _ if now => Role::Active,
                Verdict::Outside { .. } => Role::Rejected,
                Verdict::Inside => Role::Accepted,
                Verdict::Split => Role::Candidate,
            };
            out.push(outline(vec![[left, top], [right, top], [right, bottom], [left, bottom]], role));
        }
        out.push(outline(self.vertices.to_vec(), Role::Neutral));
        if let Some(edges) = &self.edges {
            let keeping = match event {
                Some(Event::Test { keeps_out, .. }) => *keeps_out,
                Some(Event::Tile { verdict: Verdict::Outside { edge }, .. }) => 1 << edge,
                _ => 0,
            };
            for (i, edge) in edges.0.iter().enumerate() {
                let role = if keeping & 1 << i == 0 { Role::Neutral } else { Role::Rejected };
                out.push(Mark::Segment { ends: edge.ends, role, label: Some(Label::name(NAMES[i])) });
            }
        }
        if let Some(at) = self.now {
            let object = self.cells.at(at[0], at[1]).filter(|cell| cell.is_drawn()).map(|_| 0);
            let role = if self.tie(at).is_some() { Role::Tie } else { Role::Active };
            out.push(pixel(at, role, object, Value::BLANK));
        }
        for (index, at) in self.vertices.into_iter().enumerate() {
            let label = Some(Label::new(["V0", "V1", "V2"][index], at));
            out.push(Mark::Point { at, role: Role::Neutral, label });
        }
    }

    fn view(&self) -> View {
        view_of(&[self.vertices], &self.settings)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for Span { y, begin, end } in self.result() {
            out.extend((begin..end).map(|x| Fact::pixel([x, y], Vec::new())));
        }
    }
}

impl<A> Snapshot<A> {
    /// Tests that drew nothing new.
    fn wasted(&self) -> u32 {
        let drawing = self.cells.all().filter(|(_, cell)| cell.is_drawn() && cell.tests() > 0).count();
        self.counts[0].saturating_sub(drawing as u32)
    }
}

fn pixel([x, y]: [u16; 2], role: Role, object: Option<usize>, value: Value) -> Mark {
    Mark::Pixel { at: [x.into(), y.into()], role, object, value }
}

fn outline(points: Vec<[f32; 2]>, role: Role) -> Mark {
    Mark::Polygon { points, role, object: None, label: None }
}
