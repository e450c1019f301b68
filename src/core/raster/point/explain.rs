//! What the lab shows of a point run.

use super::{Event, Settings, Side};
use crate::{
    compare::Fact,
    explain::{
        Explain, Formula, Label, Level, MOST_PIXELS, Mark, Marker, Operations, Piece, Role, Row, Table, View,
    },
    message::{Message, Value},
    raster::{Span, YAxis, view::view_around},
    replay::State,
};

/// A side of the square, as far as it is known.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Found {
    at: Option<f64>,
    index: Option<u32>,
    tie: bool,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    at: [f32; 2],
    width: f32,
    settings: Settings,
    sides: [Found; 4],
    rows: Vec<u32>,
}

impl Snapshot {
    /// Before the first event of a point and its size.
    pub fn new((at, width): ([f32; 2], f32), settings: Settings) -> Self {
        Self { at, width, settings, sides: [Found::default(); 4], rows: Vec::new() }
    }

    /// The spans drawn so far.
    pub fn result(&self) -> Vec<Span> {
        let [begin, end] = [Side::Left, Side::Right].map(|side| self.index(side));
        self.rows.iter().map(|&y| Span { y, begin, end }).collect()
    }

    fn index(&self, side: Side) -> u32 {
        self.sides[side as usize].index.unwrap_or(0)
    }

    /// The corners of the square.
    fn square(&self) -> Vec<[f32; 2]> {
        let half = self.width.max(0.0) / 2.0;
        let [x, y] = self.at;
        vec![[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]
    }

    fn pixels(&self) -> u32 {
        self.result().iter().map(Span::len).sum()
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Side { side, at } => self.sides[side as usize].at = Some(at),
            Event::First { side, index, .. } => self.sides[side as usize].index = Some(index),
            Event::Tie { side, .. } => self.sides[side as usize].tie = true,
            Event::Row { y } => self.rows.push(y),
            Event::Done => {}
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.rows.len() * size_of::<u32>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "points";

    const LISTING: &'static [&'static str] = &[
        "for each side: s ← x − size / 2, x + size / 2, y − size / 2, y + size / 2",
        "  first ← ⌈s − 0.5⌉: the first centre at or beyond it",
        "  centres on it: in at the left and upper, out at the right and lower side",
        "for each row from the upper to the lower side",
        "  draw the pixels from the left to the right side",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Side { .. } => 0,
            Event::First { .. } => 1,
            Event::Tie { .. } => 2,
            Event::Done => 3,
            Event::Row { .. } => 4,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Side { .. } => Operations::new(0, 1, 0),
            Event::Row { .. } => Operations::new(1, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::Row { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let role = match event {
            Event::Tie { .. } => Role::Tie,
            Event::Row { .. } => Role::Neutral,
            _ => return None,
        };
        Some(Marker { role, label: None })
    }

    fn opening(&self) -> Message {
        Message::new("points-opening").with("size", self.width)
    }

    fn sentence(&self, event: &Event) -> Message {
        let name = |side: Side| Value::Word(word(side));
        match *event {
            Event::Side { side, at } => Message::new("points-side").with("side", name(side)).with("at", at),
            Event::First { side, index, corrected } => {
                let none = index == self.settings.size[side.axis()];
                let id = match (corrected, none, side.axis()) {
                    (true, ..) => "points-corrected",
                    (_, true, _) => "points-first-none",
                    (_, _, 0) => "points-first-column",
                    _ => "points-first-row",
                };
                Message::new(id)
                    .with("side", name(side))
                    .with("index", index)
                    .with("centre", index as f32 + 0.5)
            }
            Event::Tie { side, index } => {
                Message::new(if side.is_far() { "points-tie-out" } else { "points-tie-in" })
                    .with("side", name(side))
                    .with("axis", Value::text(["x", "y"][side.axis()]))
                    .with("centre", index as f32 + 0.5)
            }
            Event::Row { y } => {
                let [begin, end] = [Side::Left, Side::Right].map(|side| self.index(side));
                Message::new("points-row")
                    .with("y", y)
                    .with("begin", begin)
                    .with("end", end)
                    .with("count", end - begin)
            }
            Event::Done => Message::new("points-done").with("count", self.pixels()),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Side { side, at } => {
                let general = match side {
                    Side::Left => "s = x − size / 2",
                    Side::Right => "s = x + size / 2",
                    Side::Upper => "s = y − size / 2",
                    Side::Lower => "s = y + size / 2",
                };
                let numbers = vec![
                    Piece::Text("= "),
                    Piece::Number(self.at[side.axis()].into()),
                    Piece::Text(if side.is_far() { " + " } else { " − " }),
                    Piece::Number(self.width.into()),
                    Piece::Text(" / 2 = "),
                    Piece::Result(at.into()),
                ];
                out.push(Formula { general, numbers });
            }
            Event::First { side, index, .. } => {
                let at = self.sides[side as usize].at;
                let numbers = vec![
                    Piece::Text("= ⌈"),
                    Piece::Number(at.into()),
                    Piece::Text(" − 0.5⌉ → "),
                    Piece::Result(index.into()),
                ];
                out.push(Formula { general: "first = ⌈s − 0.5⌉", numbers });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let now = self.sides.iter().rposition(|side| side.at.is_some()).filter(|_| self.rows.is_empty());
        let sides = Side::ALL.into_iter().zip(&self.sides).enumerate().map(|(index, (side, found))| {
            Row::new(row_name(side), vec![found.at.into(), found.index.into()])
                .active(now == Some(index))
                .role(found.tie.then_some(Role::Tie))
        });
        out.push(Table { title: "points-sides", columns: vec!["s", "first"], rows: sides.collect() });
        let last = self.rows.last();
        let rows = self.result().into_iter().map(|span| {
            Row::new(span.y.to_string(), vec![span.begin.into(), span.end.into(), span.len().into()])
                .active(last == Some(&span.y))
        });
        let columns = vec!["begin", "end", "column-pixels"];
        out.push(Table { title: "points-rows", columns, rows: rows.collect() });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let many = self.pixels() as usize > MOST_PIXELS;
        for span in self.result() {
            let y = span.y as i32;
            let role = if event == Some(&Event::Row { y: span.y }) { Role::Active } else { Role::Accepted };
            let columns = [span.begin, span.end].map(|x| x as i32);
            if many {
                out.push(Mark::Run { y, columns, role, object: Some(0) });
            } else {
                let pixel = |x| Mark::Pixel { at: [x, y], role, object: Some(0), value: Value::None };
                out.extend((columns[0]..columns[1]).map(pixel));
            }
        }
        out.push(Mark::Polygon { points: self.square(), role: Role::Neutral, object: None, label: None });
        if let Some(Event::Side { side, .. } | Event::First { side, .. } | Event::Tie { side, .. }) = event
            && let Some(at) = self.sides[*side as usize].at
        {
            let role = if self.sides[*side as usize].tie { Role::Tie } else { Role::Active };
            let label = Some(Label::new("s", at));
            out.push(Mark::Guide { axis: side.axis() as u8, at: at as f32, role, label, note: None });
        }
        let label = Some(Label::new("P", self.at));
        out.push(Mark::Point { at: self.at, role: Role::Neutral, label });
    }

    fn view(&self) -> View {
        view_around(self.square().into_iter(), self.settings.size, YAxis::Down)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let pixels = |span: Span| (span.begin..span.end).map(move |x| Fact::pixel([x, span.y], Vec::new()));
        out.extend(self.result().into_iter().flat_map(pixels));
    }
}

/// The id of the word for a side.
fn word(side: Side) -> &'static str {
    match side {
        Side::Left => "points-left",
        Side::Right => "points-right",
        Side::Upper => "points-upper",
        Side::Lower => "points-lower",
    }
}

/// The id of a side as the heading of a row.
fn row_name(side: Side) -> &'static str {
    match side {
        Side::Left => "row-points-left",
        Side::Right => "row-points-right",
        Side::Upper => "row-points-upper",
        Side::Lower => "row-points-lower",
    }
}
