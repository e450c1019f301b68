//! What the lab shows of a value by area ratios.

use super::{Event, Outcome, Subject, interpolate};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, View},
    interpolate::{InterpolateError, Mode},
    math::{Arithmetic, Tally, ulps_between},
    message::{Message, Value},
    replay::State,
};

/// The arithmetics that the last table holds against each other.
const ARITHMETICS: [(Arithmetic, &str); 3] =
    [(Arithmetic::Exact, "row-exact"), (Arithmetic::F64, "row-f64"), (Arithmetic::F32, "row-f32")];

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) mode: Mode,
    pub(super) subject: Subject,
    pub(super) arithmetic: Arithmetic,
    view: View,
    pub(super) whole: Option<f64>,
    /// By vertex: twice the area opposite, what it weighs, a/w and 1/w.
    pub(super) parts: [Option<f64>; 3],
    pub(super) l: [Option<f64>; 3],
    pub(super) over: [Option<f64>; 3],
    pub(super) reciprocal: [Option<f64>; 3],
    /// a/w and 1/w at the point.
    pub(super) sums: [Option<f64>; 2],
    pub(super) outcome: Option<Outcome>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(mode: Mode, subject: Subject, arithmetic: Arithmetic, view: View) -> Self {
        Self {
            mode,
            subject,
            arithmetic,
            view,
            whole: None,
            parts: [None; 3],
            l: [None; 3],
            over: [None; 3],
            reciprocal: [None; 3],
            sums: [None; 2],
            outcome: None,
        }
    }

    /// The value, once it is known.
    pub fn result(&self) -> Option<Outcome> {
        self.outcome
    }

    /// The vertices as they are weighed.
    pub(super) fn points(&self) -> [[f32; 2]; 3] {
        self.subject.points(self.arithmetic)
    }
}

/// Its name in the listing.
pub(super) fn vertex_name(index: usize) -> &'static str {
    ["V0", "V1", "V2"][index]
}

/// The name of what a vertex weighs.
pub(super) fn share_name(index: usize) -> &'static str {
    ["l0", "l1", "l2"][index]
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Whole { area } => self.whole = Some(area),
            Event::Part { vertex, area } => self.parts[usize::from(vertex)] = Some(area),
            Event::Share { vertex, l } => self.l[usize::from(vertex)] = Some(l),
            Event::Over { vertex, value } => self.over[usize::from(vertex)] = Some(value),
            Event::Reciprocal { vertex, value } => self.reciprocal[usize::from(vertex)] = Some(value),
            Event::SumOver { value } => self.sums[0] = Some(value),
            Event::SumReciprocal { value } => self.sums[1] = Some(value),
            Event::Value { value, .. } => self.outcome = Some(Ok(value)),
            Event::Refused { why } => self.outcome = Some(Err(why)),
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "area-ratios";

    const LISTING: &'static [&'static str] = &[
        "area ← (V1 − V0) × (V2 − V0)",
        "it is 0: there is no inside; stop",
        "each vertex: part ← area of P and the edge opposite",
        "a part has the other sign: P is outside; stop",
        "each vertex: l ← part / area",
        "affine: a ← l0 a0 + l1 a1 + l2 a2; stop",
        "a w is 0: the vertex is nowhere on the screen; stop",
        "each vertex: a/w",
        "each vertex: 1/w",
        "a/w at P ← l0 a0/w0 + l1 a1/w1 + l2 a2/w2",
        "1/w at P ← l0/w0 + l1/w1 + l2/w2",
        "1/w at P is 0: P is infinitely far; stop",
        "a ← (a/w) / (1/w)",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Whole { .. } => 0,
            Event::Refused { why: InterpolateError::ZeroArea } => 1,
            Event::Part { .. } => 2,
            Event::Refused { why: InterpolateError::Outside } => 3,
            Event::Share { .. } => 4,
            Event::Value { mode: Mode::Affine, .. } => 5,
            Event::Refused { why: InterpolateError::ZeroW } => 6,
            Event::Over { .. } => 7,
            Event::Reciprocal { .. } => 8,
            Event::SumOver { .. } => 9,
            Event::SumReciprocal { .. } => 10,
            Event::Refused { why: InterpolateError::Infinite } => 11,
            Event::Value { mode: Mode::Perspective, .. } => 12,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Whole { .. } | Event::Part { .. } => Operations::new(1, 2, 0),
            Event::Share { .. } | Event::Over { .. } | Event::Reciprocal { .. } => Operations::new(0, 0, 1),
            Event::SumOver { .. } | Event::SumReciprocal { .. } => Operations::new(0, 3, 0),
            Event::Value { mode: Mode::Affine, .. } => Operations::new(0, 3, 0),
            Event::Value { mode: Mode::Perspective, .. } => Operations::new(0, 0, 1),
            Event::Refused { .. } => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Value { .. } | Event::Refused { .. } => Level::Primitive,
            Event::Whole { .. }
            | Event::Share { vertex: 2, .. }
            | Event::Reciprocal { vertex: 2, .. }
            | Event::SumReciprocal { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Part { vertex: 0, .. } => (Role::Neutral, Some("area-ratios-marker-areas")),
            Event::Share { vertex: 0, .. } => (Role::Neutral, Some("area-ratios-marker-shares")),
            Event::Over { vertex: 0, .. } => (Role::Neutral, Some("area-ratios-marker-over")),
            Event::SumOver { .. } => (Role::Neutral, Some("area-ratios-marker-sums")),
            Event::Value { .. } => (Role::Accepted, Some("area-ratios-marker-value")),
            Event::Refused { .. } => (Role::Rejected, Some("area-ratios-marker-none")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new(match self.mode {
            Mode::Affine => "area-ratios-opening-affine",
            Mode::Perspective => "area-ratios-opening-perspective",
        })
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, i: u8| Message::new(id).with("vertex", Value::text(vertex_name(usize::from(i))));
        match *event {
            Event::Whole { area } => Message::new("area-ratios-whole").with("area", area.abs() / 2.0),
            Event::Part { vertex, area } => {
                let id = if self.whole.is_some_and(|whole| area * whole < 0.0) {
                    "area-ratios-part-outside"
                } else {
                    "area-ratios-part"
                };
                about(id, vertex).with("area", area.abs() / 2.0)
            }
            Event::Share { vertex, l } => {
                about("area-ratios-share", vertex).with("l", l).with("percent", 100.0 * l)
            }
            Event::Over { vertex, value } => about("area-ratios-over", vertex).with("value", value),
            Event::Reciprocal { vertex, value } => {
                about("area-ratios-reciprocal", vertex).with("value", value)
            }
            Event::SumOver { value } => Message::new("area-ratios-sum-over").with("value", value),
            Event::SumReciprocal { value } => {
                Message::new("area-ratios-sum-reciprocal").with("value", value).with("w", 1.0 / value)
            }
            Event::Value { mode: Mode::Affine, value } => {
                Message::new("area-ratios-affine").with("value", value)
            }
            Event::Value { mode: Mode::Perspective, value } => {
                let affine = self.value(Mode::Affine, self.arithmetic).ok();
                Message::new("area-ratios-perspective").with("value", value).with("affine", affine)
            }
            Event::Refused { why } => Message::new(match why {
                InterpolateError::ZeroArea => "area-ratios-zero-area",
                InterpolateError::Outside => "area-ratios-outside",
                InterpolateError::ZeroW => "area-ratios-zero-w",
                InterpolateError::Infinite => "area-ratios-infinite",
            }),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        out.extend(self.formula(event));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.weights());
        if self.mode == Mode::Perspective {
            out.push(self.over_w());
        }
        if let Some(Ok(_)) = self.outcome {
            out.push(self.values());
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        self.view
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for (i, l) in self.l.iter().enumerate() {
            if let Some(l) = *l {
                out.push(Fact::named(share_name(i), vec![("column-value", Value::F32(l as f32))]));
            }
        }
        match self.outcome {
            None => {}
            Some(Ok(value)) => out.push(Fact::named("a", vec![("column-value", value.into())])),
            Some(Err(_)) => out.push(Fact::answer("word-reject")),
        }
    }
}

impl Snapshot {
    /// The value in another mode or arithmetic.
    fn value(&self, mode: Mode, arithmetic: Arithmetic) -> Outcome {
        interpolate(mode, &self.subject, arithmetic, &mut Tally::default())
    }

    /// Whether a column was filled in last, at this row.
    fn is_last(column: &[Option<f64>; 3], next: bool, i: usize) -> bool {
        !next && column[i].is_some() && column.get(i + 1).is_none_or(Option::is_none)
    }

    /// Areas, what they make each vertex weigh, and the attribute.
    fn weights(&self) -> Table {
        let decided = self.outcome.is_some();
        let rows = (0..3).map(|i| {
            let part = self.parts[i].map(|area| area / 2.0);
            let cells = vec![part.into(), self.l[i].into(), self.subject.attribute[i].into()];
            let later = decided || self.over[0].is_some();
            let now = Self::is_last(&self.l, later, i)
                || Self::is_last(&self.parts, later || self.l[0].is_some(), i);
            Row::new(vertex_name(i), cells).active(now)
        });
        let mut rows: Vec<_> = rows.collect();
        let whole = self.whole.map(|area| area / 2.0);
        let [l, a] = match self.outcome {
            Some(Ok(value)) if self.mode == Mode::Affine => [Value::F64(1.0), value.into()],
            _ => [Value::BLANK, Value::BLANK],
        };
        rows.push(Row::new("row-sum", vec![whole.into(), l, a]).active(decided && self.mode == Mode::Affine));
        Table { title: "area-ratios-weights", columns: vec!["column-area", "l", "a"], rows }
    }

    /// What changes evenly on the screen in perspective.
    fn over_w(&self) -> Table {
        let rows = (0..3).map(|i| {
            let cells = vec![self.subject.w()[i].into(), self.over[i].into(), self.reciprocal[i].into()];
            let summed = self.sums[0].is_some();
            let now = Self::is_last(&self.reciprocal, summed, i)
                || Self::is_last(&self.over, summed || self.reciprocal[0].is_some(), i);
            Row::new(vertex_name(i), cells).active(now)
        });
        let mut rows: Vec<_> = rows.collect();
        let w = self.sums[1].map(|reciprocal| 1.0 / reciprocal);
        let cells = vec![w.into(), self.sums[0].into(), self.sums[1].into()];
        rows.push(Row::new("P", cells).active(self.sums[0].is_some()));
        Table { title: "area-ratios-over-w", columns: vec!["w", "a/w", "1/w"], rows }
    }

    /// The value in every arithmetic and both modes.
    fn values(&self) -> Table {
        let exact = self.value(self.mode, Arithmetic::Exact);
        let rows = ARITHMETICS.map(|(arithmetic, name)| {
            let [affine, perspective] =
                [Mode::Affine, Mode::Perspective].map(|mode| self.value(mode, arithmetic).ok());
            let off = match (self.value(self.mode, arithmetic), exact) {
                (Ok(value), Ok(exact)) => {
                    Value::Int(i64::try_from(ulps_between(value, exact)).unwrap_or(i64::MAX))
                }
                _ => Value::None,
            };
            let cells = vec![affine.into(), perspective.into(), off];
            Row::new(name, cells).active(arithmetic == self.arithmetic)
        });
        let columns = vec!["column-affine", "column-perspective", "ULP"];
        Table { title: "area-ratios-values", columns, rows: rows.to_vec() }
    }
}
