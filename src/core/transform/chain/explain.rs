//! What the lab shows of the transform chain.

use super::{Chain, Event, Path, Space, run};
use crate::{
    explain::{Explain, Formula, Grid, Label, Level, Mark, Marker, Piece, Role, Row, Table, View},
    message::{Message, Value},
    raster::YAxis,
    replay::State,
    transform::{DepthRange, matrices::row},
};

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    chain: Chain,
    vertices: Vec<[f32; 3]>,
    /// Components known so far, for each vertex in each space.
    known: Vec<[[Option<f32>; 4]; 6]>,
    /// The vertex the step is about.
    vertex: usize,
    /// The space that is being computed.
    to: Space,
    /// The row that was computed last.
    row: Option<usize>,
    /// For each space, how much of it its picture shows: half of its width.
    extent: [f32; 6],
}

impl Snapshot {
    /// Before the first event.
    pub fn new(vertices: &[[f32; 3]], chain: Chain) -> Self {
        let paths = run(vertices, &chain);
        let [half_width, half_height] = half_size(&chain);
        let extent = Space::ALL.map(|space| {
            let reach = |path: &Path| match (space, path[space as usize]) {
                (Space::Clip, [x, y, _, w]) => x.abs().max(y.abs()).max(w),
                (Space::Screen, [x, y, ..]) => (x - half_width).abs().max((y - half_height).abs()),
                (_, [x, y, ..]) => x.abs().max(y.abs()),
            };
            let least = if space == Space::Screen { half_width.max(half_height) } else { 1.0 };
            1.1 * paths.iter().map(reach).fold(least, f32::max)
        });
        Self {
            chain,
            vertices: vertices.to_vec(),
            known: vec![[[None; 4]; 6]; paths.len()],
            vertex: 0,
            to: Space::Object,
            row: None,
            extent,
        }
    }

    /// The vertices that have come to the screen so far, in every space.
    pub fn result(&self) -> Vec<Path> {
        let whole = |point: [Option<f32>; 4]| point.map(Option::unwrap_or_default);
        let complete = self.known.iter().filter(|path| path[5].iter().all(Option::is_some));
        complete.map(|path| path.map(whole)).collect()
    }

    /// The current vertex in `space`, as far as it is known.
    fn at(&self, space: Space) -> [Option<f32>; 4] {
        self.known.get(self.vertex).map_or([None; 4], |path| path[space as usize])
    }

    /// Where a point of a space lies in the picture of that space.
    fn place(&self, space: Space, [x, y]: [f32; 2]) -> [f32; 2] {
        let [left, top] = middle(space);
        let scale = 1.0 / self.extent[space as usize];
        if space != Space::Screen {
            return [left + x * scale, top + y * scale];
        }
        let [half_width, half_height] = half_size(&self.chain);
        let up = if self.chain.viewport.y_axis == YAxis::Down { -scale } else { scale };
        [left + (x - half_width) * scale, top + (y - half_height) * up]
    }

    /// Half the size of what is visible of a space, if that is a box there.
    fn visible(&self, space: Space) -> Option<[f32; 2]> {
        match space {
            Space::Clip => self.at(space)[3].filter(|w| *w > 0.0).map(|w| [w; 2]),
            Space::Ndc => Some([1.0; 2]),
            Space::Screen => Some(half_size(&self.chain)),
            Space::Object | Space::World | Space::View => None,
        }
    }

    /// The picture of one space: its frame, what is visible, the vertices that have come there.
    fn panel(&self, space: Space, out: &mut Vec<Mark>) {
        let [cx, cy] = middle(space);
        let rectangle = |[width, height]: [f32; 2], role| Mark::Polygon {
            points: vec![
                [cx - width, cy - height],
                [cx + width, cy - height],
                [cx + width, cy + height],
                [cx - width, cy + height],
            ],
            role,
            object: None,
            label: None,
        };
        out.push(rectangle([1.0; 2], Role::Candidate));
        if let Some(half) = self.visible(space) {
            out.push(rectangle(half.map(|n| n / self.extent[space as usize]), Role::Neutral));
        }
        let role = if space == self.to { Role::Active } else { Role::Neutral };
        let label = Label::new("", word(space));
        out.push(Mark::Text { at: [cx - 1.0, cy + 1.25], label, role, big: false });
        let points: Vec<(usize, [f32; 2])> = (self.known.iter().enumerate())
            .filter_map(|(index, path)| match path[space as usize] {
                [Some(x), Some(y), Some(_), Some(_)] => Some((index, [x, y])),
                _ => None,
            })
            .collect();
        if points.len() == 3 && self.vertices.len() == 3 {
            let corners = points.iter().map(|&(_, at)| self.place(space, at)).collect();
            out.push(Mark::Polygon { points: corners, role: Role::Neutral, object: Some(0), label: None });
        }
        for (index, at) in points {
            let active = space == self.to && index == self.vertex;
            let role = if active { Role::Active } else { Role::Accepted };
            let label = active.then(|| Label::new(format!("P{}", index + 1), at));
            out.push(Mark::Point { at: self.place(space, at), role, label });
        }
    }

    /// The viewport's formula for component `i`, without its result.
    fn viewport_formula(&self, [x, y, z, r]: [Value; 4], i: usize) -> (&'static str, Vec<Piece>) {
        let viewport = &self.chain.viewport;
        let [width, height] = viewport.size.map(Value::from);
        match i {
            0 => ("x‴ = W / 2 · (x″ + 1)", vec![number(width), text(" / 2 · ("), number(x), text(" + 1)")]),
            1 if viewport.y_axis == YAxis::Down => {
                ("y‴ = H / 2 · (1 − y″)", vec![number(height), text(" / 2 · (1 − "), number(y), text(")")])
            }
            1 => ("y‴ = H / 2 · (y″ + 1)", vec![number(height), text(" / 2 · ("), number(y), text(" + 1)")]),
            2 if viewport.depth_range == DepthRange::ZeroToOne => ("z‴ = z″", vec![number(z)]),
            2 => ("z‴ = (z″ + 1) / 2", vec![text("("), number(z), text(" + 1) / 2")]),
            _ => ("r‴ = r", vec![number(r)]),
        }
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

/// Half the width and height of the image, in pixels.
fn half_size(chain: &Chain) -> [f32; 2] {
    chain.viewport.size.map(|n| n as f32 / 2.0)
}

/// The middle of the picture of a space: three pictures in a row, each 2 units wide.
fn middle(space: Space) -> [f32; 2] {
    let index = space as usize;
    [3.0 * (index % 3) as f32, -3.0 * (index / 3) as f32]
}

/// The name of a space.
fn word(space: Space) -> Value {
    Value::Word(match space {
        Space::Object => "transform-space-object",
        Space::World => "transform-space-world",
        Space::View => "transform-space-view",
        Space::Clip => "transform-space-clip",
        Space::Ndc => "transform-space-ndc",
        Space::Screen => "transform-space-screen",
    })
}

fn text(text: &'static str) -> Piece {
    Piece::Text(text)
}

fn number(value: Value) -> Piece {
    Piece::Number(value)
}

/// A row's formula, without its result.
fn product_formula(row: [f32; 4], v: [Value; 4], i: usize) -> (&'static str, Vec<Piece>) {
    let mut numbers = Vec::new();
    for (factor, component) in row.into_iter().zip(v) {
        if !numbers.is_empty() {
            numbers.push(text(" + "));
        }
        numbers.extend([number(factor.into()), text(" · "), number(component)]);
    }
    let general = [
        "x′ = m11 · x + m12 · y + m13 · z + m14 · w",
        "y′ = m21 · x + m22 · y + m23 · z + m24 · w",
        "z′ = m31 · x + m32 · y + m33 · z + m34 · w",
        "w′ = m41 · x + m42 · y + m43 · z + m44 · w",
    ];
    (general[i], numbers)
}

/// The divide's formula for component `i`, without its result.
fn divide_formula([x, y, z, w]: [Value; 4], i: usize) -> (&'static str, Vec<Piece>) {
    let (general, above) = match i {
        0 => ("x″ = x′ / w", x),
        1 => ("y″ = y′ / w", y),
        2 => ("z″ = z′ / w", z),
        _ => ("r = 1 / w", Value::Int(1)),
    };
    (general, vec![number(above), text(" / "), number(w)])
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
        "all vertices are on the screen",
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
            Event::Component { to, row, value, .. } => {
                let id = match (to, row) {
                    (Space::Ndc, 3) => "transform-reciprocal",
                    (Space::Ndc, _) => "transform-divide",
                    (Space::Screen, 3) => "transform-reciprocal-stays",
                    (Space::Screen, _) => "transform-viewport",
                    _ => "transform-component",
                };
                let axis = Value::text(["x", "y", "z", "w"][usize::from(row)]);
                Message::new(id).with("axis", axis).with("value", value)
            }
            Event::Reached { space, .. } => {
                let shown = if space < Space::Ndc { 4 } else { 3 };
                let at = self.at(space).into_iter().flatten().take(shown).collect();
                Message::new("transform-reached").with("at", Value::Vector(at)).with("space", word(space))
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
        numbers.extend([text(" = "), Piece::Result(value.into())]);
        out.push(Formula { general, numbers });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = Space::ALL.map(|space| {
            let mut cells = vec![word(space)];
            cells.extend(self.at(space).map(Value::from));
            let name = ["v", "W v", "C⁻¹ W v", "v′", "v″", "v‴"][space as usize];
            Row::new(name, cells).active(space == self.to)
        });
        let columns = vec!["column-space", "x", "y", "z", "column-w-or-r"];
        out.push(Table { title: "transform-spaces", columns, rows: rows.to_vec() });
        let Some(matrix) = self.chain.matrix(self.to) else { return };
        let rows = [0, 1, 2, 3].map(|i| {
            let name = ["x′", "y′", "z′", "w′"][i];
            Row::new(name, row(matrix, i).map(Value::from).to_vec()).active(self.row == Some(i))
        });
        let title = match self.to {
            Space::World => "transform-table-world",
            Space::View => "transform-table-view",
            _ => "transform-table-clip",
        };
        out.push(Table { title, columns: vec!["x", "y", "z", "w"], rows: rows.to_vec() });
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        for space in Space::ALL {
            self.panel(space, out);
        }
    }

    fn view(&self) -> View {
        View { min: [-1.2, -4.2], max: [7.2, 1.4], y_up: true, grid: Grid::None }
    }
}
