//! What the lab shows of a triangle against one plane.

use super::{Corner, Event, HalfSpace, Outcome};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Row, Table, Vantage, View},
    math::{Arithmetic, Sign},
    message::{Message, Value},
    replay::State,
};

/// A new corner as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct New {
    /// The end inside and the end outside.
    pub(super) ends: [usize; 2],
    /// What the end inside weighs.
    pub(super) t: f64,
    pub(super) at: Option<[f64; 3]>,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) vertices: [[f32; 3]; 3],
    pub(super) plane: HalfSpace,
    arithmetic: Arithmetic,
    pub(super) distances: [Option<(Sign, f64)>; 3],
    pub(super) alone: Option<(usize, bool)>,
    pub(super) new: [Option<New>; 2],
    pub(super) triangles: Vec<[Corner; 3]>,
    /// `Some(true)`: all inside; `Some(false)`: none.
    pub(super) decided: Option<bool>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(vertices: [[f32; 3]; 3], plane: HalfSpace, arithmetic: Arithmetic) -> Self {
        Self {
            vertices,
            plane,
            arithmetic,
            distances: [None; 3],
            alone: None,
            new: [None; 2],
            triangles: Vec::new(),
            decided: None,
        }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Outcome {
        let new = self.new.iter().flatten().filter_map(|new| new.at);
        Outcome { new: new.map(|at| at.map(|c| c as f32)).collect(), triangles: self.triangles.clone() }
    }

    /// Where a corner is.
    pub(super) fn at(&self, corner: Corner) -> [f32; 3] {
        match corner {
            Corner::Vertex(i) => self.vertices[usize::from(i)],
            Corner::New(i) => {
                let at = self.new[usize::from(i)].and_then(|new| new.at).unwrap_or_default();
                at.map(|c| c as f32)
            }
        }
    }

    pub(super) fn is_inside(&self, vertex: usize) -> bool {
        self.distances[vertex].is_some_and(|(side, _)| side != Sign::Negative)
    }
}

/// Its name in the listing.
pub(super) fn name(corner: Corner) -> String {
    match corner {
        Corner::Vertex(i) => format!("v{i}"),
        Corner::New(i) => format!("x{i}"),
    }
}

fn names(corners: [Corner; 3]) -> Value {
    Value::text(corners.map(name).join(", "))
}

fn vertex(i: u8) -> Value {
    Value::text(format!("v{i}"))
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Distance { vertex, side, distance } => {
                self.distances[usize::from(vertex)] = Some((side, distance));
            }
            Event::Keep => {
                self.decided = Some(true);
                self.triangles.push([0, 1, 2].map(Corner::Vertex));
            }
            Event::Reject => self.decided = Some(false),
            Event::Alone { vertex, inside } => self.alone = Some((usize::from(vertex), inside)),
            Event::Share { new, a, b, t } => {
                self.new[usize::from(new)] = Some(New { ends: [a, b].map(usize::from), t, at: None });
            }
            Event::Cross { new, at } => {
                if let Some(new) = &mut self.new[usize::from(new)] {
                    new.at = Some(at);
                }
            }
            Event::Triangle { corners } => self.triangles.push(corners),
            Event::Flat { .. } => {}
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "clip-plane";

    const LISTING: &'static [&'static str] = &[
        "for each vertex: d ← (v − p) · n",
        "three d ≥ 0: keep the triangle; stop",
        "no d ≥ 0: reject it; stop",
        "find the vertex alone on its side",
        "each edge there: t ← db / (db − da)",
        "  x ← t a + (1 − t) b, a the end inside",
        "one inside: one triangle",
        "two inside: two triangles",
        "two corners are equal: no triangle",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Distance { .. } => 0,
            Event::Keep => 1,
            Event::Reject => 2,
            Event::Alone { .. } => 3,
            Event::Share { .. } => 4,
            Event::Cross { .. } => 5,
            Event::Triangle { corners: [_, Corner::New(1), _] } => 6,
            Event::Triangle { .. } => 7,
            Event::Flat { .. } => 8,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Distance { .. } => Operations::new(1, 3, 0),
            Event::Share { .. } => Operations::new(0, 0, 1),
            Event::Cross { .. } => Operations::new(0, 6, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Keep | Event::Reject => Level::Primitive,
            Event::Alone { .. } | Event::Cross { .. } | Event::Triangle { .. } | Event::Flat { .. } => {
                Level::Row
            }
            Event::Distance { .. } | Event::Share { .. } => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Distance { side: Sign::Negative, .. } => (Role::Rejected, None),
            Event::Distance { .. } => (Role::Accepted, None),
            Event::Cross { new: 0, .. } => (Role::Neutral, Some("clip-plane-marker-x0")),
            Event::Cross { .. } => (Role::Neutral, Some("clip-plane-marker-x1")),
            Event::Keep | Event::Triangle { .. } => (Role::Accepted, Some("clip-plane-marker-triangle")),
            Event::Reject | Event::Flat { .. } => (Role::Rejected, Some("word-reject")),
            Event::Alone { .. } | Event::Share { .. } => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("clip-plane-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, i: u8| Message::new(id).with("vertex", vertex(i));
        match *event {
            Event::Distance { vertex, side, distance } => about(
                match side {
                    Sign::Positive => "clip-plane-inside",
                    Sign::Zero => "clip-plane-on",
                    Sign::Negative => "clip-plane-outside",
                },
                vertex,
            )
            .with("d", distance),
            Event::Keep => Message::new("clip-plane-keep"),
            Event::Reject => Message::new("clip-plane-reject"),
            Event::Alone { vertex, inside: true } => about("clip-plane-alone-inside", vertex),
            Event::Alone { vertex, inside: false } => about("clip-plane-alone-outside", vertex),
            Event::Share { a, b, t, .. } => Message::new("clip-plane-share")
                .with("a", vertex(a))
                .with("b", vertex(b))
                .with("t", t)
                .with("other", 1.0 - t),
            Event::Cross { new, at } => Message::new("clip-plane-cross")
                .with("new", Value::text(format!("x{new}")))
                .with("at", at.map(|c| c as f32)),
            Event::Triangle { corners } => {
                let id = match (corners, self.triangles.len()) {
                    ([_, Corner::New(1), _], _) => "clip-plane-one",
                    (_, 1) => "clip-plane-first",
                    _ => "clip-plane-second",
                };
                Message::new(id).with("corners", names(corners))
            }
            Event::Flat { corners } => Message::new("clip-plane-flat").with("corners", names(corners)),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let text = Piece::Text;
        let number = |value: f64| Piece::Number(value.into());
        match *event {
            Event::Distance { vertex, distance, .. } => out.push(Formula {
                general: "d = (v − p) · n",
                numbers: vec![
                    text("= ("),
                    Piece::Number(self.vertices[usize::from(vertex)].into()),
                    text(" − "),
                    Piece::Number(self.plane.point.into()),
                    text(") · "),
                    Piece::Number(self.plane.normal.into()),
                    text(" = "),
                    Piece::Result(distance.into()),
                ],
            }),
            Event::Share { a, b, t, .. } => {
                let [Some((_, da)), Some((_, db))] = [a, b].map(|i| self.distances[usize::from(i)]) else {
                    return;
                };
                out.push(Formula {
                    general: "t = db / (db − da)",
                    numbers: vec![
                        text("= "),
                        number(db),
                        text(" / ("),
                        number(db),
                        text(" − "),
                        number(da),
                        text(") = "),
                        Piece::Result(t.into()),
                    ],
                });
            }
            Event::Cross { new, at } => {
                let Some(New { ends: [a, b], t, .. }) = self.new[usize::from(new)] else { return };
                out.push(Formula {
                    general: "x = t a + (1 − t) b",
                    numbers: vec![
                        text("= "),
                        number(t),
                        text(" · "),
                        Piece::Number(self.vertices[a].into()),
                        text(" + "),
                        number(1.0 - t),
                        text(" · "),
                        Piece::Number(self.vertices[b].into()),
                        text(" = "),
                        Piece::Result(at.map(|c| c as f32).into()),
                    ],
                });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = (0..3).map(|i| {
            let [x, y, z] = self.vertices[i];
            let distance = self.distances[i].map(|(_, d)| d);
            let inside = self.is_inside(i);
            let role = distance.map(|_| if inside { Role::Accepted } else { Role::Rejected });
            let now = self.distances[i].is_some() && (i == 2 || self.distances[i + 1].is_none());
            let now = now && self.alone.is_none() && self.decided.is_none();
            Row::new(format!("v{i}"), vec![x.into(), y.into(), z.into(), distance.into()])
                .role(role)
                .active(now)
        });
        let columns = vec!["x", "y", "z", "d"];
        out.push(Table { title: "clip-plane-vertices", columns, rows: rows.collect() });
        let rows = self.new.iter().enumerate().filter_map(|(i, new)| {
            let New { ends: [a, b], t, at } = (*new)?;
            let at = at.map_or([Value::None, Value::None, Value::None], |at| at.map(Value::from));
            let mut cells = vec![Value::text(format!("v{a}")), Value::text(format!("v{b}")), t.into()];
            cells.extend(at);
            let last = self.new[1].is_none() || i == 1;
            Some(Row::new(format!("x{i}"), cells).active(last && self.triangles.is_empty()))
        });
        let columns = vec!["a", "b", "t", "x", "y", "z"];
        out.push(Table { title: "clip-plane-new", columns, rows: rows.collect() });
        let rows = self.triangles.iter().enumerate().map(|(i, corners)| {
            let role = Role::Accepted;
            Row::new((i + 1).to_string(), vec![names(*corners)]).role(role)
        });
        let columns = vec!["column-clip-plane-corners"];
        out.push(Table { title: "clip-plane-triangles", columns, rows: rows.collect() });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        View::SPACE
    }

    fn vantage(&self) -> Option<Vantage> {
        Some(self.first_camera())
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        if self.decided.is_some() || !self.triangles.is_empty() {
            out.push(Fact::answer(if self.triangles.is_empty() { "word-reject" } else { "word-accept" }));
        }
        for (i, new) in self.new.iter().enumerate() {
            let Some(New { t, at: Some(at), .. }) = *new else { continue };
            let [x, y, z] = at.map(|c| Value::F32(c as f32));
            let t = if self.arithmetic == Arithmetic::F64 { Value::F64(t) } else { Value::F32(t as f32) };
            out.push(Fact::named(format!("x{i}"), vec![("x", x), ("y", y), ("z", z), ("t", t)]));
        }
    }
}
