//! What the lab shows of a scan line run.

use super::{Between, Event, Side};
use crate::{
    explain::{Explain, Formula, Label, Level, Mark, Marker, Role, Row, Table, View},
    message::{Message, Value},
    raster::{Settings, Span, YAxis, view::view_of},
    replay::State,
};

/// A row of the span table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SpanRow {
    pub(super) y: u32,
    /// Where the row meets the edges, by side, once computed.
    pub(super) crossings: [Option<(Between, f64)>; 2],
    /// First column and the one past the last, once found.
    ends: [Option<u32>; 2],
    /// The centre that lies on the edge of each side, and whether that edge draws it.
    ties: [Option<(u32, bool)>; 2],
    span: Option<[u32; 2]>,
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
    order: Option<[u8; 3]>,
    /// Slopes by edge; a horizontal edge has none.
    pub(super) slopes: [Option<f64>; 3],
    pub(super) rows: Vec<SpanRow>,
    /// Whether the last row of the table is being worked on.
    in_row: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(vertices: [[f32; 2]; 3], settings: Settings) -> Self {
        Self {
            given: vertices,
            vertices: settings.vertices(vertices),
            settings,
            order: None,
            slopes: [None; 3],
            rows: Vec::new(),
            in_row: false,
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

    fn vertex_name(index: usize) -> &'static str {
        ["V0", "V1", "V2"][index]
    }

    /// Such as `V0V2`.
    fn edge_name(&self, edge: Between) -> String {
        let [a, b] = self.ends(edge);
        [a.min(b), a.max(b)].map(Self::vertex_name).concat()
    }

    fn pixels(&self) -> u64 {
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
        let y = Value::from(self.row().map_or(0, |row| row.y));
        match *event {
            Event::Sorted { order } => {
                let [top, middle, bottom] =
                    order.map(|index| Value::text(Self::vertex_name(usize::from(index))));
                Message::new("scanline-sorted").with("top", top).with("middle", middle).with("bottom", bottom)
            }
            Event::ZeroArea => Message::new("scanline-zero-area"),
            Event::Slope { edge, dx_dy } => Message::new("scanline-slope")
                .with("edge", Value::text(self.edge_name(edge)))
                .with("slope", dx_dy),
            Event::Half { edge, begin, end } => {
                let [from, to] = self.ends(edge).map(|end| Value::text(Self::vertex_name(end)));
                let id = if begin == end { "scanline-half-empty" } else { "scanline-half" };
                let message = Message::new(id).with("from", from).with("to", to);
                if begin == end {
                    return message;
                }
                let [first, last] = match self.settings.y_axis {
                    YAxis::Down => [begin, end - 1],
                    YAxis::Up => [end - 1, begin],
                };
                message.with("first", first).with("last", last).with("count", end - begin)
            }
            Event::Row { y } => Message::new("scanline-row").with("y", y).with("centre", y as f32 + 0.5),
            Event::Crossing { side, edge, x } => Message::new(match side {
                Side::Left => "scanline-crossing-left",
                Side::Right => "scanline-crossing-right",
            })
            .with("edge", Value::text(self.edge_name(edge)))
            .with("x", x),
            Event::End { x, corrected: true, .. } => Message::new("scanline-corrected").with("x", x),
            Event::End { side: Side::Left, x, .. } => Message::new("scanline-first").with("x", x),
            Event::End { side: Side::Right, x, .. } => Message::new("scanline-end").with("x", x),
            Event::Tie { side, edge, x, drawn } => Message::new(match (side, drawn) {
                (Side::Left, true) => "scanline-tie-left-drawn",
                (Side::Left, false) => "scanline-tie-left-lost",
                (Side::Right, true) => "scanline-tie-right-drawn",
                (Side::Right, false) => "scanline-tie-right-lost",
            })
            .with("x", x)
            .with("y", y)
            .with("edge", Value::text(self.edge_name(edge))),
            Event::Span { begin, end } if begin == end => Message::new("scanline-span-empty").with("y", y),
            Event::Span { begin, end } => Message::new("scanline-span")
                .with("y", y)
                .with("first", begin)
                .with("end", end)
                .with("count", end - begin),
            Event::Pixel { x } => Message::new("scanline-pixel").with("x", x).with("y", y),
            Event::Done => Message::new("scanline-done")
                .with("count", Value::count(usize::try_from(self.pixels()).unwrap_or(usize::MAX))),
        }
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
        for row in &self.rows {
            let begin = row.span.map_or(0, |[begin, _]| begin);
            out.extend((begin..begin + row.drawn).map(|x| pixel(x, row.y, Role::Accepted, Some(0))));
        }
        if self.given != self.vertices {
            out.push(outline(self.given, Role::Exact));
        }
        out.push(outline(self.vertices, Role::Neutral));
        for edge in Between::ALL {
            let slope = self.slopes[edge as usize];
            let walked =
                self.row().is_some_and(|row| row.crossings.iter().flatten().any(|(e, _)| *e == edge));
            let now = matches!(event, Some(Event::Slope { edge: e, .. }) if *e == edge);
            if slope.is_some() || now {
                out.push(Mark::Segment {
                    ends: self.ends(edge).map(|end| self.vertices[end]),
                    role: if walked || now { Role::Active } else { Role::Neutral },
                    label: slope.map(|slope| Label::new("dx/dy", slope)),
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
}

impl Snapshot {
    /// The row being worked on: its centre line, crossings, span and tie.
    fn mark_row(&self, row: &SpanRow, event: Option<&Event>, out: &mut Vec<Mark>) {
        let centre = row.y as f32 + 0.5;
        out.push(Mark::Guide { axis: 1, at: centre, role: Role::Active, label: None });
        let crossings = row.crossings.map(|crossing| crossing.map(|(_, x)| x as f32));
        if let ([Some(left), Some(right)], Some([begin, end])) = (crossings, row.span)
            && begin < end
        {
            out.push(Mark::Span { y: row.y as i32, ends: [left, right], role: Role::Active });
        }
        for (name, x) in ["x left", "x right"].into_iter().zip(crossings) {
            if let Some(x) = x.filter(|x| x.is_finite()) {
                out.push(Mark::Point {
                    at: [x, centre],
                    role: Role::Active,
                    label: Some(Label::new(name, x)),
                });
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
