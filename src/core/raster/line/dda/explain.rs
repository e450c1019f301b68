//! What the lab shows of a DDA run.

use super::{
    super::{Pixel, Segment, major_axis, picture, pixel_of},
    Event,
};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    math::Arithmetic,
    message::{Message, Value},
    replay::State,
};

/// A pixel of the line and the position that it was rounded from.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Step {
    /// The coordinate that does not change by whole pixels.
    minor: f64,
    pixel: Pixel,
    tie: bool,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    given: Segment,
    size: [u32; 2],
    arithmetic: Arithmetic,
    /// The axis along which each step is one pixel.
    major: usize,
    differences: Option<[i32; 2]>,
    count: Option<u32>,
    increments: [Option<f64>; 2],
    /// Where the walk is along the other axis.
    minor: f64,
    steps: Vec<Step>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(given: Segment, size: [u32; 2], arithmetic: Arithmetic) -> Self {
        let ends = given.map(pixel_of);
        let major = major_axis(ends);
        let minor = f64::from(ends[0][1 - major]);
        let (differences, count, increments) = (None, None, [None; 2]);
        Self { given, size, arithmetic, major, differences, count, increments, minor, steps: Vec::new() }
    }

    /// The pixels so far, on and off the image.
    pub fn pixels(&self) -> Vec<Pixel> {
        self.steps.iter().map(|step| step.pixel).collect()
    }

    fn ends(&self) -> [Pixel; 2] {
        self.given.map(pixel_of)
    }

    /// Where the walk is along the axis of whole steps, once `made` of them are made.
    fn whole(&self, made: usize) -> i32 {
        let [from, to] = self.ends().map(|end| end[self.major]);
        let made = made as i32;
        if to < from { from - made } else { from + made }
    }

    /// Both coordinates of a position.
    fn position(&self, made: usize, minor: f64) -> [f64; 2] {
        let mut at = [minor; 2];
        at[self.major] = self.whole(made).into();
        at
    }

    /// Where that is in the drawing.
    fn place(&self, made: usize, minor: f64) -> [f32; 2] {
        self.position(made, minor).map(|x| (x + 0.5) as f32)
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Start { dx, dy } => self.differences = Some([dx, dy]),
            Event::Steps { steps } => self.count = Some(steps),
            Event::Increment { axis, by } => self.increments[usize::from(axis != 0)] = Some(by),
            Event::Advance { to } => self.minor = to,
            Event::Plot { x, y, tie } => {
                self.steps.push(Step { minor: self.minor, pixel: [x, y], tie });
            }
            Event::Done => {}
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.steps.len() * size_of::<Step>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "dda";

    const LISTING: &'static [&'static str] = &[
        "dx ← x2 − x1, dy ← y2 − y1",
        "steps ← max(|dx|, |dy|)",
        "x inc ← dx / steps, y inc ← dy / steps",
        "x ← x1, y ← y1; repeat until all steps are made",
        "  draw (⌊x + 0.5⌋, ⌊y + 0.5⌋)",
        "  x ← x + x inc, y ← y + y inc",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Start { .. } => 0,
            Event::Steps { .. } => 1,
            Event::Increment { .. } => 2,
            Event::Done => 3,
            Event::Plot { .. } => 4,
            Event::Advance { .. } => 5,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Steps { .. } | Event::Plot { .. } => Operations::new(1, 0, 0),
            Event::Increment { .. } => Operations::new(0, 0, 1),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::Plot { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Plot { tie: true, .. } => (Role::Tie, None),
            Event::Plot { .. } => (Role::Neutral, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("dda-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Start { dx, dy } => Message::new("dda-start").with("dx", dx).with("dy", dy),
            Event::Steps { steps } => {
                Message::new("dda-steps").with("count", steps).with("axis", name(self.major))
            }
            Event::Increment { axis, by } => {
                Message::new("dda-increment").with("axis", name(axis.into())).with("by", by)
            }
            Event::Advance { to } => {
                Message::new("dda-advance").with("axis", name(1 - self.major)).with("to", to)
            }
            Event::Plot { x, y, tie } => Message::new(if tie { "dda-plot-tie" } else { "dda-plot" })
                .with("axis", name(1 - self.major))
                .with("at", self.minor)
                .with("x", x)
                .with("y", y),
            Event::Done => Message::new("dda-done").with("count", self.steps.len()),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let steps = Piece::Number(self.count.into());
        match *event {
            Event::Increment { axis, by } => {
                let axis = usize::from(axis != 0);
                let difference = self.differences.map(|differences| differences[axis]);
                let numbers = vec![
                    Piece::Text("= "),
                    Piece::Number(difference.into()),
                    Piece::Text(" / "),
                    steps,
                    Piece::Text(" = "),
                    Piece::Result(by.into()),
                ];
                let general = ["x inc = dx / steps", "y inc = dy / steps"][axis];
                out.push(Formula { general, numbers });
            }
            Event::Advance { to } => {
                let minor = 1 - self.major;
                let before = self.steps.last().map(|step| step.minor);
                let increment = Piece::Number(self.increments[minor].into());
                let numbers = if self.arithmetic.is_exact() {
                    let start = Piece::Number(self.ends()[0][minor].into());
                    let made = Piece::Number(self.steps.len().into());
                    vec![Piece::Text("= "), start, Piece::Text(" + "), made, Piece::Text(" · "), increment]
                } else {
                    vec![Piece::Text("= "), Piece::Number(before.into()), Piece::Text(" + "), increment]
                };
                let result = [Piece::Text(" = "), Piece::Result(to.into())];
                let general = match (self.arithmetic.is_exact(), minor) {
                    (true, 0) => "x = x1 + k · x inc",
                    (true, _) => "y = y1 + k · y inc",
                    (false, 0) => "x = x + x inc",
                    (false, _) => "y = y + y inc",
                };
                out.push(Formula { general, numbers: numbers.into_iter().chain(result).collect() });
            }
            Event::Plot { x, y, .. } => {
                let minor = 1 - self.major;
                let numbers = vec![
                    Piece::Text("= ⌊"),
                    Piece::Number(self.minor.into()),
                    Piece::Text(" + 0.5⌋ = "),
                    Piece::Result([x, y][minor].into()),
                ];
                let general = ["pixel x = ⌊x + 0.5⌋", "pixel y = ⌊y + 0.5⌋"][minor];
                out.push(Formula { general, numbers });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let last = self.steps.len().checked_sub(1);
        let row = |(made, step): (usize, &Step)| {
            let [x, y] = self.position(made, step.minor).map(Value::from);
            let [column, row] = step.pixel.map(Value::from);
            Row::new(made.to_string(), vec![x, y, column, row])
                .active(last == Some(made))
                .role(step.tie.then_some(Role::Tie))
        };
        let rows = self.steps.iter().enumerate().map(row).collect();
        out.push(Table { title: "dda-steps-made", columns: vec!["x", "y", "pixel x", "pixel y"], rows });
        let [dx, dy] = [0, 1].map(|axis| Value::from(self.differences.map(|by| by[axis])));
        let [x_inc, y_inc] = self.increments.map(Value::from);
        let columns = vec!["dx", "dy", "steps", "x inc", "y inc"];
        let cells = vec![dx, dy, self.count.into(), x_inc, y_inc];
        out.push(Table { title: "dda-increments", columns, rows: vec![Row::new("P1P2", cells)] });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::pixels(&self.pixels(), self.size, out);
        picture::line(self.given, self.ends().map(picture::centre), out);
        let (made, role) = match event {
            Some(Event::Advance { .. }) => (self.steps.len(), Role::Active),
            Some(Event::Plot { tie, .. }) => {
                (self.steps.len() - 1, if *tie { Role::Tie } else { Role::Active })
            }
            _ => return,
        };
        let label = Label::new(["x", "y"][1 - self.major], self.minor);
        out.push(Mark::Point { at: self.place(made, self.minor), role, label: Some(label) });
    }

    fn view(&self) -> View {
        picture::view(self.given, self.size)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        picture::facts(&self.pixels(), self.size, out);
    }
}

/// The name of an axis.
fn name(axis: usize) -> Value {
    Value::text(if axis == 0 { "x" } else { "y" })
}
