//! What the lab shows of a row by the plane equation.

use super::{Event, Pixels, Quantity, Subject, fill_row};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Role, Table, View},
    interpolate::{InterpolateError, Mode},
    math::Arithmetic,
    message::{Message, Value},
    raster::{Settings, view::view_of},
    replay::State,
};
use std::sync::Arc;

/// A plane as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlaneState {
    pub(super) quantity: Quantity,
    /// A, B, C.
    pub(super) normal: [Option<f64>; 3],
    pub(super) d: Option<f64>,
    /// Along x and y.
    pub(super) slopes: [Option<f64>; 2],
    /// At the pixel in hand, and at the one before.
    pub(super) value: Option<f64>,
    pub(super) before: Option<f64>,
}

impl PlaneState {
    fn new(quantity: Quantity) -> Self {
        let (normal, slopes) = ([None; 3], [None; 2]);
        Self { quantity, normal, d: None, slopes, value: None, before: None }
    }

    /// What it is a plane of, as the listing calls it.
    pub(super) fn name(&self) -> &'static str {
        match self.quantity {
            Quantity::Value => "a",
            Quantity::Over => "a/w",
            Quantity::Reciprocal => "1/w",
        }
    }
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) mode: Mode,
    pub(super) subject: Subject,
    pub(super) arithmetic: Arithmetic,
    settings: Settings,
    /// Row, first column and the one past the last.
    pub(super) row: Option<[u32; 3]>,
    pub(super) planes: Vec<PlaneState>,
    /// Column of the pixel in hand.
    pub(super) x: Option<u32>,
    pub(super) pixels: Pixels,
    /// The correctly rounded values of the whole row.
    pub(super) exact: Arc<[(u32, f32)]>,
    done: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(mode: Mode, subject: Subject, arithmetic: Arithmetic, settings: Settings) -> Self {
        let exact = if arithmetic.is_exact() { arithmetic } else { Arithmetic::Exact };
        Self {
            mode,
            subject,
            arithmetic,
            settings,
            row: None,
            planes: Vec::new(),
            x: None,
            pixels: Vec::new(),
            exact: fill_row(mode, &subject, exact, &settings).into(),
            done: false,
        }
    }

    /// The pixels filled so far.
    pub fn result(&self) -> Pixels {
        self.pixels.clone()
    }

    /// The correctly rounded value of a pixel of the row.
    pub(super) fn exact_at(&self, x: u32) -> Option<f32> {
        let first = self.exact.first()?.0;
        self.exact.get(x.checked_sub(first)? as usize).map(|(_, value)| *value)
    }

    fn is_off(&self, (x, value): (u32, f32)) -> bool {
        self.exact_at(x) != Some(value)
    }

    /// The plane that a step is about.
    pub(super) fn plane(&self, quantity: Quantity) -> Option<&PlaneState> {
        self.planes.iter().find(|plane| plane.quantity == quantity)
    }

    fn plane_mut(&mut self, quantity: Quantity) -> &mut PlaneState {
        let index = self.planes.iter().position(|plane| plane.quantity == quantity).unwrap_or_else(|| {
            self.planes.push(PlaneState::new(quantity));
            self.planes.len() - 1
        });
        &mut self.planes[index]
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Row { y, begin, end } => self.row = Some([y, begin, end]),
            Event::Normal { quantity, axis, value } => {
                self.plane_mut(quantity).normal[usize::from(axis)] = Some(value);
            }
            Event::Offset { quantity, value } => self.plane_mut(quantity).d = Some(value),
            Event::Slope { quantity, axis, value } => {
                self.plane_mut(quantity).slopes[usize::from(axis)] = Some(value);
            }
            Event::Start { quantity, x, value } | Event::Step { quantity, x, value } => {
                self.x = Some(x.into());
                let plane = self.plane_mut(quantity);
                plane.before = plane.value;
                plane.value = Some(value);
            }
            Event::Value { x, value, .. } => self.pixels.push((x.into(), value)),
            Event::Refused { .. } => self.done = true,
            Event::Done => (self.done, self.x) = (true, None),
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + 2 * size_of::<PlaneState>() + self.exact.len() * size_of::<(u32, f32)>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "plane-equation";

    const LISTING: &'static [&'static str] = &[
        "no area, or a w of 0: stop",
        "the row: pixels with their centre inside; none: stop",
        "q ← a if affine; a/w and 1/w in perspective",
        "each q: (A, B, C) ← (V1 − V0) × (V2 − V0)",
        "  D ← −(A x0 + B y0 + C q0)",
        "  dq/dx ← −A/C, dq/dy ← −B/C",
        "  q ← (−A x − B y − D) / C at the first centre",
        "each pixel of the row, affine: a ← q",
        "  in perspective: a ← (a/w) / (1/w)",
        "  for the next pixel: q ← q − A/C",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Refused { why: InterpolateError::Outside } | Event::Row { .. } => 1,
            Event::Refused { .. } => 0,
            Event::Normal { axis: 0, .. } => 2,
            Event::Normal { .. } => 3,
            Event::Offset { .. } => 4,
            Event::Slope { .. } => 5,
            Event::Start { .. } => 6,
            Event::Value { mode: Mode::Affine, .. } | Event::Done => 7,
            Event::Value { mode: Mode::Perspective, .. } => 8,
            Event::Step { .. } => 9,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Normal { .. } => Operations::new(0, 2, 0),
            Event::Offset { .. } => Operations::new(0, 3, 0),
            Event::Slope { .. } | Event::Value { mode: Mode::Perspective, .. } => Operations::new(0, 0, 1),
            Event::Start { .. } => Operations::new(0, 2, 1),
            // One addition is all that a pixel costs.
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done | Event::Refused { .. } => Level::Primitive,
            Event::Row { .. } | Event::Start { .. } | Event::Value { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Normal { axis: 0, .. } => (Role::Neutral, Some("plane-equation-marker-plane")),
            Event::Start { .. } => (Role::Neutral, Some("plane-equation-marker-start")),
            Event::Value { .. } => (Role::Accepted, None),
            Event::Refused { .. } => (Role::Skipped, Some("plane-equation-marker-none")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new(match self.mode {
            Mode::Affine => "plane-equation-opening-affine",
            Mode::Perspective => "plane-equation-opening-perspective",
        })
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, quantity| {
            let name = self.plane(quantity).map_or("q", PlaneState::name);
            Message::new(id).with("q", Value::text(name))
        };
        match *event {
            Event::Row { y, begin, end } => Message::new("plane-equation-row")
                .with("y", y)
                .with("first", begin)
                .with("end", end)
                .with("count", end - begin),
            Event::Normal { quantity, axis, value } => about("plane-equation-normal", quantity)
                .with("name", Value::text(["A", "B", "C"][usize::from(axis)]))
                .with("value", value),
            Event::Offset { quantity, value } => {
                about("plane-equation-offset", quantity).with("value", value)
            }
            Event::Slope { quantity, axis, value } => {
                let id = ["plane-equation-slope-x", "plane-equation-slope-y"][usize::from(axis)];
                about(id, quantity).with("value", value)
            }
            Event::Start { quantity, x, value } => {
                about("plane-equation-start", quantity).with("x", u32::from(x)).with("value", value)
            }
            Event::Step { quantity, x, value } => {
                about("plane-equation-step", quantity).with("x", u32::from(x)).with("value", value)
            }
            Event::Value { x, mode, value } => {
                let off = self.is_off((x.into(), value));
                let id = match (mode, off) {
                    (Mode::Affine, false) => "plane-equation-value",
                    (Mode::Perspective, false) => "plane-equation-quotient",
                    (_, true) => "plane-equation-drift",
                };
                let exact: Value = self.exact_at(x.into()).into();
                Message::new(id).with("x", u32::from(x)).with("value", value).with("exact", exact)
            }
            Event::Refused { why } => Message::new(match why {
                InterpolateError::ZeroArea => "plane-equation-zero-area",
                InterpolateError::ZeroW => "plane-equation-zero-w",
                InterpolateError::Outside | InterpolateError::Infinite => "plane-equation-no-pixel",
            }),
            Event::Done => {
                let off = self.pixels.iter().filter(|pixel| self.is_off(**pixel)).count();
                let id = if off == 0 { "plane-equation-done" } else { "plane-equation-done-drift" };
                Message::new(id).with("count", self.pixels.len()).with("off", off)
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        out.extend(self.formula(event));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        self.list(out);
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        let points = self.subject.points(self.arithmetic);
        if let Some([y, begin, end]) = self.row {
            for x in begin..end {
                let at = [x as i32, y as i32];
                let known = self.pixels.iter().find(|(column, _)| *column == x);
                let (role, value) = match known {
                    None => (Role::Candidate, Value::None),
                    Some(pixel) if self.is_off(*pixel) => (Role::Changed, pixel.1.into()),
                    Some(pixel) => (Role::Neutral, pixel.1.into()),
                };
                out.push(Mark::Pixel { at, role, object: known.map(|_| 0), value: value.clone() });
                if self.x == Some(x) {
                    out.push(Mark::Pixel { at, role: Role::Active, object: known.map(|_| 0), value });
                }
            }
        }
        out.push(Mark::Polygon { points: points.to_vec(), role: Role::Neutral, object: None, label: None });
        for (i, &at) in points.iter().enumerate() {
            let label = Label::new(format!("V{i} a"), self.subject.attribute[i]).of(0);
            out.push(Mark::Point { at, role: Role::Neutral, label: Some(label) });
        }
        out.push(Mark::Point { at: self.subject.at, role: Role::Candidate, label: Some(Label::name("P")) });
    }

    fn view(&self) -> View {
        view_of(&[self.subject.points(self.arithmetic)], &self.settings)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let Some([y, ..]) = self.row else { return };
        out.extend(
            self.pixels
                .iter()
                .map(|(x, value)| Fact::pixel([*x, y], vec![("column-value", (*value).into())])),
        );
    }
}
