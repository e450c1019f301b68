//! What the lab shows of a scan line run.

use super::{Between, Event, Side, fill};
use crate::{
    compare::Fact,
    explain::{
        Explain, Formula, Label, Level, MOST_PIXELS, Mark, Marker, Operations, PixelReport, Role, Row, Table,
        View,
    },
    math::{Arithmetic, Tally},
    message::{Message, Value},
    raster::{
        Edges, Settings, Span,
        report::{Fate, Subject},
        view::view_of,
    },
    replay::State,
};
use std::sync::Arc;

/// Of triangles up to this many pixels those still to come are shown.
const SHOWS_PENDING: u64 = 2048;

/// A row of the span table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SpanRow {
    pub(super) y: u32,
    /// Where the row meets the edges, by side, once computed.
    pub(super) crossings: [Option<(Between, f64)>; 2],
    /// First column and the one past the last, once found.
    pub(super) ends: [Option<u32>; 2],
    /// The centre that lies on the edge of each side, and whether that edge draws it.
    ties: [Option<(u32, bool)>; 2],
    pub(super) span: Option<[u32; 2]>,
    /// Pixels drawn so far.
    drawn: u32,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// As given; drawn beside the snapped ones if they differ.
    given: [[f32; 2]; 3],
    pub(super) vertices: [[f32; 2]; 3],
    pub(super) settings: Settings,
    pub(super) order: Option<[u8; 3]>,
    /// Slopes by edge; a horizontal edge has none.
    pub(super) slopes: [Option<f64>; 3],
    pub(super) rows: Vec<SpanRow>,
    /// Whether the last row of the table is being worked on.
    in_row: bool,
    /// The spans that the run will find; none of a large triangle.
    outcome: Arc<[Span]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(vertices: [[f32; 2]; 3], settings: Settings) -> Self {
        let mut outcome = Vec::new();
        let counts = fill(vertices, &settings, &mut Tally::default(), &mut |span| outcome.push(span));
        if counts.covered > SHOWS_PENDING {
            outcome.clear();
        }
        Self {
            given: vertices,
            vertices: settings.vertices(vertices),
            settings,
            order: None,
            slopes: [None; 3],
            rows: Vec::new(),
            in_row: false,
            outcome: outcome.into(),
        }
    }

    /// The spans found so far, in the order of the walk.
    pub fn result(&self) -> Vec<Span> {
        let spans =
            self.rows.iter().filter_map(|row| row.span.map(|[begin, end]| Span { y: row.y, begin, end }));
        spans.filter(|span| !span.is_empty()).collect()
    }

    /// The row being worked on.
    pub(super) fn row(&self) -> Option<&SpanRow> {
        self.rows.last().filter(|_| self.in_row)
    }

    /// Indices of an edge's ends: the upper one first.
    pub(super) fn ends(&self, edge: Between) -> [usize; 2] {
        let order = self.order.unwrap_or([0, 1, 2]);
        edge.ends().map(|end| usize::from(order[end]))
    }

    pub(super) fn vertex_name(index: usize) -> &'static str {
        ["V0", "V1", "V2"][index]
    }

    /// Such as `V0V2`.
    pub(super) fn edge_name(&self, edge: Between) -> String {
        let [a, b] = self.ends(edge);
        [a.min(b), a.max(b)].map(Self::vertex_name).concat()
    }

    pub(super) fn pixels(&self) -> u64 {
        self.rows.iter().map(|row| u64::from(row.drawn)).sum()
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        if let Event::Row { y } = *event {
            self.rows.push(SpanRow {
                y,
                crossings: [None; 2],
                ends: [None; 2],
                ties: [None; 2],
                span: None,
                drawn: 0,
            });
            self.in_row = true;
            return;
        }
        match (*event, self.rows.last_mut()) {
            (Event::Sorted { order }, _) => self.order = Some(order),
            (Event::Slope { edge, dx_dy }, _) => self.slopes[edge as usize] = Some(dx_dy),
            (Event::Half { .. } | Event::Done, _) => self.in_row = false,
            (Event::Crossing { side, edge, x }, Some(row)) => row.crossings[side as usize] = Some((edge, x)),
            (Event::End { side, x, .. }, Some(row)) => row.ends[side as usize] = Some(x),
            (Event::Tie { side, x, drawn, .. }, Some(row)) => row.ties[side as usize] = Some((x, drawn)),
            (Event::Span { begin, end }, Some(row)) => row.span = Some([begin, end]),
            (Event::Pixel { .. }, Some(row)) => row.drawn += 1,
            _ => {}
        }
    }

    fn size_hint(&self) -> usize {
        let height = self.vertices.map(|[_, y]| f64::from(y).clamp(0.0, self.settings.size[1].into()));
        let [a, b, c] = height;
        let rows = a.max(b).max(c) - a.min(b).min(c);
        size_of::<Self>() + rows as usize * size_of::<SpanRow>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "scanline";

    const LISTING: &'static [&'static str] = &[
        "top, middle, bottom ← vertices by height",
        "if the area is 0: draw nothing; stop",
        "for each edge: dx/dy ← (x1 − x0) / (y1 − y0)",
        "for each half: top to middle, middle to bottom",
        "  for each row y with its centre in the half",
        "    x left ← where the centre line meets the left edge",
        "    first ← ⌈x left − 0.5⌉",
        "    x right ← where it meets the right edge",
        "    end ← ⌈x right − 0.5⌉",
        "    a centre exactly on an edge: the tie rule decides",
        "    the span is first ≤ x < end",
        "    draw the pixels of the span",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Sorted { .. } => 0,
            Event::ZeroArea => 1,
            Event::Slope { .. } => 2,
            Event::Half { .. } | Event::Done => 3,
            Event::Row { .. } => 4,
            Event::Crossing { side: Side::Left, .. } => 5,
            Event::End { side: Side::Left, .. } => 6,
            Event::Crossing { side: Side::Right, .. } => 7,
            Event::End { side: Side::Right, .. } => 8,
            Event::Tie { .. } => 9,
            Event::Span { .. } => 10,
            Event::Pixel { .. } => 11,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // Three comparisons sort; the area is two products and a sign.
            Event::Sorted { .. } => Operations::new(4, 2, 0),
            Event::Slope { .. } => Operations::new(1, 0, 1),
            Event::Crossing { .. } => Operations::new(0, 1, 0),
            Event::Span { .. } => Operations::new(1, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::ZeroArea | Event::Done => Level::Primitive,
            Event::Span { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::ZeroArea => (Role::Skipped, Some("scanline-marker-zero-area")),
            Event::Half { edge: Between::TopMiddle, .. } => (Role::Neutral, Some("scanline-marker-upper")),
            Event::Half { .. } => (Role::Neutral, Some("scanline-marker-lower")),
            Event::Tie { .. } => (Role::Tie, None),
            Event::Span { .. } => (Role::Neutral, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("scanline-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        self.say(event)
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        out.extend(self.formula(event));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let current = self.row().map(|row| row.y);
        let rows = self.rows.iter().map(|row| {
            let [left, right] = row.crossings.map(|crossing| Value::from(crossing.map(|(_, x)| x)));
            let [first, end] = row.ends.map(Value::from);
            let pixels = Value::from(row.span.map(|[begin, end]| end - begin));
            Row::new(row.y.to_string(), vec![left, right, first, end, pixels])
                .active(current == Some(row.y))
                .role(row.ties.iter().flatten().next().map(|_| Role::Tie))
        });
        out.push(Table {
            title: "scanline-spans",
            columns: vec!["x left", "x right", "first", "end", "column-pixels"],
            rows: rows.collect(),
        });
        let active =
            |edge| self.row().is_some_and(|row| row.crossings.iter().flatten().any(|(e, _)| *e == edge));
        let slopes = Between::ALL.into_iter().map(|edge| {
            Row::new(self.edge_name(edge), vec![self.slopes[edge as usize].into()]).active(active(edge))
        });
        out.push(Table { title: "scanline-slopes", columns: vec!["dx/dy"], rows: slopes.collect() });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let many =
            self.outcome.iter().map(|span| (span.end - span.begin) as usize).sum::<usize>() > MOST_PIXELS;
        for row in &self.rows {
            let begin = row.span.map_or(0, |[begin, _]| begin);
            let drawn = begin..begin + row.drawn;
            if many {
                let columns = [drawn.start, drawn.end].map(|x| x as i32);
                out.push(Mark::Run { y: row.y as i32, columns, role: Role::Accepted, object: Some(0) });
            } else {
                out.extend(drawn.map(|x| pixel(x, row.y, Role::Accepted, Some(0))));
            }
        }
        if !self.rows.is_empty() && !many {
            self.mark_pending(out);
        }
        if self.given != self.vertices {
            out.push(outline(self.given, Role::Exact));
        }
        out.push(outline(self.vertices, Role::Neutral));
        for edge in Between::ALL {
            let now = matches!(event, Some(Event::Slope { edge: e, .. }) if *e == edge);
            if let Some(slope) = self.slopes[edge as usize] {
                out.push(Mark::Segment {
                    ends: self.ends(edge).map(|end| self.vertices[end]),
                    role: if now { Role::Active } else { Role::Neutral },
                    label: Some(Label::new("dx/dy", slope)),
                });
            }
        }
        if let Some(row) = self.row() {
            self.mark_row(row, event, out);
        }
        for (index, at) in self.vertices.into_iter().enumerate() {
            let label = Some(Label::new(Self::vertex_name(index), at));
            out.push(Mark::Point { at, role: Role::Neutral, label });
        }
    }

    fn view(&self) -> View {
        view_of(&[self.vertices], &self.settings)
    }

    fn pixel(&self, [x, y]: [u32; 2]) -> Option<PixelReport> {
        let mut drawn = false;
        fill(self.given, &self.settings, &mut Tally::default(), &mut |span| {
            drawn |= span.y == y && (span.begin..span.end).contains(&x);
        });
        // The edges are asked exactly: where rounded crossings say otherwise, the report warns.
        let settings = Settings { arithmetic: Arithmetic::Exact, mistake: None, ..self.settings };
        let edges = Edges::new(self.vertices, &settings, &mut Tally::default());
        let (given, vertices, edges) = (self.given, self.vertices, edges.as_ref());
        Subject { given, vertices, edges, settings: &settings, fate: Fate::Known(drawn) }.report([x, y])
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for row in &self.rows {
            let begin = row.span.map_or(0, |[begin, _]| begin);
            out.extend((begin..begin + row.drawn).map(|x| Fact::pixel([x, row.y], Vec::new())));
        }
    }
}

impl Snapshot {
    /// The pixels that the run has not come to yet.
    fn mark_pending(&self, out: &mut Vec<Mark>) {
        for span in self.outcome.iter() {
            let row = self.rows.iter().find(|row| row.y == span.y);
            let drawn = row.map_or(0, |row| row.drawn);
            let tie = |x: u32| row.is_some_and(|row| row.ties.iter().flatten().any(|(tie, _)| *tie == x));
            let pending = (span.begin + drawn..span.end).filter(|&x| !tie(x));
            out.extend(pending.map(|x| pixel(x, span.y, Role::Candidate, None)));
        }
    }

    /// The row being worked on: its centre line, crossings, span and tie.
    fn mark_row(&self, row: &SpanRow, event: Option<&Event>, out: &mut Vec<Mark>) {
        let centre = row.y as f32 + 0.5;
        out.push(Mark::Guide { axis: 1, at: centre, role: Role::Active, label: None, note: None });
        let crossings = row.crossings.map(|crossing| crossing.map(|(_, x)| x as f32));
        let mut spanned = false;
        if let ([Some(left), Some(right)], Some([begin, end])) = (crossings, row.span)
            && begin < end
        {
            spanned = true;
            out.push(Mark::Span { y: row.y as i32, ends: [left, right], role: Role::Active });
        }
        for side in [Side::Left, Side::Right] {
            let Some(x) = crossings[side as usize].filter(|x| x.is_finite()) else { continue };
            let name = ["x left", "x right"][side as usize];
            let now = match event {
                Some(Event::Crossing { side: of, .. } | Event::End { side: of, .. }) => *of == side,
                _ => spanned,
            };
            let tie = row.ties[side as usize].filter(|(column, _)| x == *column as f32 + 0.5);
            let role = match tie {
                Some(_) => Role::Tie,
                None if now => Role::Active,
                None => Role::Accepted,
            };
            out.push(Mark::Point { at: [x, centre], role, label: Some(Label::new(name, x)) });
            if let Some((_, drawn)) = tie {
                let verdict = if drawn { "scanline-tie-drawn" } else { "scanline-tie-lost" };
                let label = Some(Label::new("", Value::Word(verdict)));
                out.push(Mark::Point { at: [x, centre], role: Role::Tie, label });
            }
        }
        if let Some(Event::Pixel { x }) = event {
            out.push(pixel(*x, row.y, Role::Active, Some(0)));
        }
        for &(x, drawn) in row.ties.iter().flatten() {
            out.push(pixel(x, row.y, Role::Tie, drawn.then_some(0)));
        }
    }
}

fn pixel(x: u32, y: u32, role: Role, object: Option<usize>) -> Mark {
    Mark::Pixel { at: [x as i32, y as i32], role, object, value: Value::None }
}

fn outline(vertices: [[f32; 2]; 3], role: Role) -> Mark {
    Mark::Polygon { points: vertices.to_vec(), role, object: None, label: None }
}
