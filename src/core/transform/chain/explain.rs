//! What the lab shows of the transform chain.

use super::{
    Chain, Event, Path, Space,
    formulas::{divide_formula, product_formula, text},
    picture::{self, Frame},
    run,
};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
    raster::YAxis,
    replay::State,
    transform::{DepthRange, matrices::row},
};

/// The vertex in each space, as the listing and the lectures write it.
pub(super) const NAMES: [&str; 6] = ["v", "W v", "C⁻¹ W v", "v′", "v″", "v‴"];

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) chain: Chain,
    pub(super) vertices: Vec<[f32; 3]>,
    /// Components known so far, for each vertex in each space.
    known: Vec<[[Option<f32>; 4]; 6]>,
    /// The vertex the step is about.
    pub(super) vertex: usize,
    /// The space that is being computed.
    pub(super) to: Space,
    /// The row that was computed last.
    row: Option<usize>,
    /// What the pictures show of each space: from the front and from the side.
    pub(super) frames: [[Frame; 2]; 6],
}

impl Snapshot {
    /// Before the first event.
    pub fn new(vertices: &[[f32; 3]], chain: Chain) -> Self {
        let paths = run(vertices, &chain);
        let frames = Frame::all(&chain, &paths);
        Self {
            chain,
            vertices: vertices.to_vec(),
            known: vec![[[None; 4]; 6]; paths.len()],
            vertex: 0,
            to: Space::Object,
            row: None,
            frames,
        }
    }

    /// The vertices that have come to the screen so far, in every space.
    pub fn result(&self) -> Vec<Path> {
        let whole = |point: [Option<f32>; 4]| point.map(Option::unwrap_or_default);
        let complete = self.known.iter().filter(|path| path[5].iter().all(Option::is_some));
        complete.map(|path| path.map(whole)).collect()
    }

    /// The current vertex in `space`, as far as it is known.
    pub(super) fn at(&self, space: Space) -> [Option<f32>; 4] {
        self.known.get(self.vertex).map_or([None; 4], |path| path[space as usize])
    }
}

impl Snapshot {
    /// w of the current vertex in clip space.
    pub(super) fn w(&self) -> f32 {
        self.at(Space::Clip)[3].unwrap_or(1.0)
    }

    /// Whether the current vertex is known to lie in the visible box.
    pub(super) fn is_visible(&self) -> bool {
        let [x, y, z, w] = self.at(Space::Clip).map(|c| c.unwrap_or(f32::NAN));
        let low = if self.chain.viewport.depth_range == DepthRange::ZeroToOne { 0.0 } else { -w };
        w > 0.0 && x.abs() <= w && y.abs() <= w && low <= z && z <= w
    }

    fn say_component(&self, to: Space, row: usize, value: f32) -> Message {
        let [width, height] = self.chain.viewport.size;
        let message = match (to, row) {
            (Space::Ndc, _) if self.w() == 0.0 => Message::new("transform-divide-zero"),
            (Space::Ndc, 3) => Message::new("transform-reciprocal"),
            (Space::Ndc, _) if self.w() < 0.0 => Message::new("transform-divide-behind"),
            (Space::Ndc, 2) => Message::new("transform-divide-depth"),
            (Space::Ndc, _) => Message::new("transform-divide"),
            (Space::Screen, 0) => Message::new("transform-viewport-x").with("size", width),
            (Space::Screen, 1) => match self.chain.viewport.y_axis {
                YAxis::Down => Message::new("transform-viewport-down"),
                YAxis::Up => Message::new("transform-viewport-up"),
            }
            .with("size", height),
            (Space::Screen, 2) => match self.chain.viewport.depth_range {
                DepthRange::ZeroToOne => Message::new("transform-viewport-depth"),
                DepthRange::MinusOneToOne => Message::new("transform-viewport-depth-stretched"),
            },
            (Space::Screen, _) => Message::new("transform-reciprocal-stays"),
            _ => {
                let matrix = ["", "W", "C⁻¹", "P"][to as usize % 4];
                Message::new("transform-component").with("matrix", Value::text(matrix))
            }
        };
        message.with("axis", Value::text(["x", "y", "z", "w"][row])).with("value", value)
    }

    /// What the step computes with: matrix, vector and product; or the divide; or the viewport.
    fn step_table(&self) -> Option<Table> {
        let from = *Space::ALL.get((self.to as usize).checked_sub(1)?)?;
        let [before, after] = [from, self.to].map(|space| self.at(space).map(Value::from));
        let [name_before, name_after] = [from, self.to].map(|space| NAMES[space as usize]);
        let rows = |names: [&str; 4], cells: &dyn Fn(usize) -> Vec<Value>| {
            let row = |i: usize| Row::new(names[i], cells(i)).active(self.row == Some(i));
            [0, 1, 2, 3].map(row).to_vec()
        };
        let [last_before, last_after] = [before.clone(), after.clone()];
        Some(match (self.chain.matrix(self.to), self.to) {
            (Some(matrix), to) => Table {
                title: match to {
                    Space::World => "transform-table-world",
                    Space::View => "transform-table-view",
                    _ => "transform-table-clip",
                },
                columns: vec!["x", "y", "z", "w", name_before, name_after],
                rows: rows(["x′", "y′", "z′", "w′"], &|i| {
                    let mut cells = row(matrix, i).map(Value::from).to_vec();
                    cells.extend([before[i].clone(), after[i].clone()]);
                    cells
                }),
            },
            (None, Space::Ndc) => Table {
                title: "transform-table-divide",
                columns: vec![name_before, "w", name_after],
                rows: rows(["x″", "y″", "z″", "r"], &|i| {
                    let above = if i < 3 { last_before[i].clone() } else { Value::Int(1) };
                    vec![above, last_before[3].clone(), last_after[i].clone()]
                }),
            },
            _ => Table {
                title: "transform-table-viewport",
                columns: vec![name_before, name_after],
                rows: rows(["x‴", "y‴", "z‴", "r"], &|i| vec![before[i].clone(), after[i].clone()]),
            },
        })
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.row = None;
        match *event {
            Event::Vertex { vertex } => {
                self.vertex = usize::from(vertex);
                self.to = Space::Object;
                let [x, y, z] = self.vertices[self.vertex];
                self.known[self.vertex][0] = [x, y, z, 1.0].map(Some);
            }
            Event::Matrix { to, .. } => self.to = to,
            Event::Component { to, row, value, .. } => {
                self.to = to;
                self.row = Some(usize::from(row));
                self.known[self.vertex][to as usize][usize::from(row)] = Some(value);
            }
            Event::Reached { .. } | Event::Sight { .. } | Event::Done => {}
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.known.len() * size_of::<[[Option<f32>; 4]; 6]>()
    }
}

/// The name of a space.
pub(super) fn word(space: Space) -> Value {
    Value::Word(match space {
        Space::Object => "transform-space-object",
        Space::World => "transform-space-world",
        Space::View => "transform-space-view",
        Space::Clip => "transform-space-clip",
        Space::Ndc => "transform-space-ndc",
        Space::Screen => "transform-space-screen",
    })
}

impl Explain for Snapshot {
    const NAME: &'static str = "transform";

    const LISTING: &'static [&'static str] = &[
        "for each vertex v = (x, y, z, 1)",
        "  for M in W, C⁻¹, P",
        "    x′, y′, z′, w′ ← rows of M · v",
        "    v ← (x′, y′, z′, w′)",
        "  w > 0: in front of the eye?",
        "  v″ ← (x / w, y / w, z / w), r ← 1 / w",
        "  v‴ ← D v″",
        "no vertex is left: stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Vertex { .. } => 0,
            Event::Matrix { .. } => 1,
            Event::Component { to: Space::Ndc, .. } | Event::Reached { space: Space::Ndc, .. } => 5,
            Event::Component { to: Space::Screen, .. } | Event::Reached { space: Space::Screen, .. } => 6,
            Event::Component { .. } => 2,
            Event::Reached { .. } => 3,
            Event::Sight { .. } => 4,
            Event::Done => 7,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Component { to: Space::Ndc, .. } => Operations::new(0, 0, 1),
            Event::Component { to: Space::Screen, row, .. } => {
                Operations::new(0, u64::from(*row < 3), 0) // 1/w goes through as it is
            }
            Event::Component { .. } => Operations::new(0, 4, 0),
            Event::Sight { .. } => Operations::new(1, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::Reached { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        match event {
            Event::Reached { space: Space::Screen, .. } => Some(Marker { role: Role::Accepted, label: None }),
            Event::Sight { w, .. } if *w <= 0.0 => {
                Some(Marker { role: Role::Rejected, label: Some("transform-marker-behind") })
            }
            _ => None,
        }
    }

    fn opening(&self) -> Message {
        Message::new("transform-opening").with("count", self.vertices.len())
    }

    fn sentence(&self, event: &Event) -> Message {
        let message = match *event {
            Event::Vertex { .. } => Message::new("transform-vertex").with("at", self.vertices[self.vertex]),
            Event::Matrix { to: Space::World, .. } => Message::new("transform-matrix-world"),
            Event::Matrix { to: Space::View, .. } => Message::new("transform-matrix-view"),
            Event::Matrix { .. } => Message::new("transform-matrix-clip"),
            Event::Component { to, row, value, .. } => self.say_component(to, usize::from(row), value),
            Event::Reached { space: Space::Screen, .. } => {
                let [x, y, z, _] = self.at(Space::Screen).map(Option::unwrap_or_default);
                Message::new(match (self.w() > 0.0, self.is_visible()) {
                    (true, true) => "transform-on-screen",
                    (true, false) => "transform-off-screen",
                    (false, _) => "transform-no-screen",
                })
                .with("at", [x, y])
                .with("depth", z)
            }
            Event::Reached { space, .. } => {
                let shown = if space < Space::Ndc { 4 } else { 3 };
                let at = self.at(space).into_iter().flatten().take(shown).collect();
                Message::new("transform-reached").with("at", Value::Vector(at)).with("space", word(space))
            }
            Event::Sight { w, .. } if row(&self.chain.projection, 3) == [0.0, 0.0, 0.0, 1.0] => {
                Message::new("transform-parallel").with("w", w)
            }
            Event::Sight { w, .. } if w > 0.0 => Message::new("transform-in-front").with("w", w),
            Event::Sight { w, .. } if w < 0.0 => Message::new("transform-behind").with("w", w),
            Event::Sight { .. } => Message::new("transform-no-image"),
            Event::Done => return Message::new("transform-done").with("count", self.vertices.len()),
        };
        message.with("vertex", Value::text(format_args!("P{}", self.vertex + 1)))
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let Event::Component { to, row: i, value, .. } = *event else { return };
        let i = usize::from(i);
        let before = self.at(Space::ALL[(to as usize).saturating_sub(1)]).map(Value::from);
        let (general, mut numbers) = match self.chain.matrix(to) {
            Some(matrix) => product_formula(row(matrix, i), before, i),
            None if self.at(Space::Clip)[3] == Some(0.0) => return, // nothing is divided by zero
            None if to == Space::Ndc => divide_formula(before, i),
            None => self.viewport_formula(before, i),
        };
        if numbers.len() > 2 {
            numbers.push(text(" = "));
        } else {
            numbers.truncate(1); // what stays is not written twice
        }
        numbers.push(Piece::Result(value.into()));
        out.push(Formula { general, numbers });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = Space::ALL.map(|space| {
            let mut cells = vec![word(space)];
            cells.extend(self.at(space).map(Value::from));
            Row::new(NAMES[space as usize], cells).active(space == self.to)
        });
        let columns = vec!["column-space", "x", "y", "z", "column-w-or-r"];
        out.push(Table { title: "transform-spaces", columns, rows: rows.to_vec() });
        out.extend(self.step_table());
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        self.picture(out);
    }

    fn view(&self) -> View {
        picture::VIEW
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for (path, number) in self.known.iter().zip(1..) {
            for (space, known) in Space::ALL.into_iter().zip(path) {
                if let [Some(x), Some(y), Some(z), Some(w)] = *known {
                    let last = if space < Space::Ndc { "w" } else { "r" };
                    let name = format!("P{number} {}", NAMES[space as usize]);
                    let values = ["x", "y", "z", last].into_iter().zip([x, y, z, w].map(Value::from));
                    out.push(Fact::named(name, values.collect()));
                }
            }
        }
    }
}
