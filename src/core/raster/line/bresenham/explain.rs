//! What the lab shows of a Bresenham run.

use super::{
    super::{Pixel, Segment, major_axis, picture, pixel_of},
    Event,
};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
    replay::State,
};

/// A pixel of the line and what led to it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Plotted {
    pixel: Pixel,
    /// The decision variable that was looked at, and whether the step went aside; not of the first pixel.
    decided: Option<(i64, bool)>,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    given: Segment,
    size: [u32; 2],
    major: usize,
    lengths: Option<[u32; 2]>,
    /// The decision variable for the next step.
    d: Option<i64>,
    /// What the last step looked at and did.
    decided: Option<(i64, bool)>,
    plotted: Vec<Plotted>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(given: Segment, size: [u32; 2]) -> Self {
        let major = major_axis(given.map(pixel_of));
        Self { given, size, major, lengths: None, d: None, decided: None, plotted: Vec::new() }
    }

    /// The pixels so far, on and off the image.
    pub fn pixels(&self) -> Vec<Pixel> {
        self.plotted.iter().map(|plotted| plotted.pixel).collect()
    }

    fn ends(&self) -> [Pixel; 2] {
        self.given.map(pixel_of)
    }

    /// Where a step goes along an axis.
    fn towards(&self, axis: usize) -> i32 {
        let [from, to] = self.ends().map(|end| end[axis]);
        if to > from { 1 } else { -1 }
    }

    /// Lengths along the major and the minor axis.
    fn major_minor(&self) -> [Option<u32>; 2] {
        [self.major, 1 - self.major].map(|axis| self.lengths.map(|lengths| lengths[axis]))
    }

    /// Straight on and aside from the last pixel.
    fn next(&self) -> Option<[Pixel; 2]> {
        let mut straight = self.plotted.last()?.pixel;
        straight[self.major] += self.towards(self.major);
        let mut aside = straight;
        aside[1 - self.major] += self.towards(1 - self.major);
        Some([straight, aside])
    }

    /// The direction of a step along an axis, as the id of a word.
    fn direction(&self, axis: usize) -> Value {
        Value::Word(match (axis, self.towards(axis)) {
            (0, 1) => "bresenham-right",
            (0, _) => "bresenham-left",
            (_, 1) => "bresenham-down",
            _ => "bresenham-up",
        })
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Start { dx, dy } => self.lengths = Some([dx, dy]),
            Event::Decision { d } => self.d = Some(d),
            Event::Step { aside, d } => {
                self.decided = self.d.map(|looked_at| (looked_at, aside));
                self.d = Some(d);
            }
            Event::Plot { x, y } => {
                self.plotted.push(Plotted { pixel: [x, y], decided: self.decided });
            }
            Event::Done => {}
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.plotted.len() * size_of::<Plotted>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "bresenham";

    const LISTING: &'static [&'static str] = &[
        "dx ← |x2 − x1|, dy ← |y2 − y1|",
        "major ← max(dx, dy), minor ← min(dx, dy), d ← 2 · minor − major",
        "repeat until all steps are made",
        "  draw (x, y)",
        "  if d > 0, or d = 0 and aside is right or down: one step aside, d ← d − 2 · major + 2 · minor",
        "  else: straight on, d ← d + 2 · minor",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Start { .. } => 0,
            Event::Decision { .. } => 1,
            Event::Done => 2,
            Event::Plot { .. } => 3,
            Event::Step { aside: true, .. } => 4,
            Event::Step { aside: false, .. } => 5,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Decision { .. } => Operations::new(1, 0, 0),
            // Of d, and of the steps that are made.
            Event::Step { .. } => Operations::new(2, 0, 0),
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
        let role = match event {
            Event::Plot { .. } => Role::Neutral,
            Event::Step { aside: true, .. } => Role::Changed,
            _ => return None,
        };
        Some(Marker { role, label: None })
    }

    fn opening(&self) -> Message {
        Message::new("bresenham-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Start { dx, dy } => Message::new("bresenham-start")
                .with("dx", dx)
                .with("dy", dy)
                .with("axis", Value::text(["x", "y"][self.major])),
            Event::Decision { d } => Message::new("bresenham-decision").with("d", d),
            Event::Step { aside, .. } => {
                let looked_at = self.decided.map(|(d, _)| d);
                let id = match (looked_at, aside) {
                    (Some(0), true) => "bresenham-tie-aside",
                    (Some(0), false) => "bresenham-tie-straight",
                    (_, true) => "bresenham-aside",
                    (_, false) => "bresenham-straight",
                };
                Message::new(id)
                    .with("d", looked_at)
                    .with("straight", self.direction(self.major))
                    .with("aside", self.direction(1 - self.major))
            }
            Event::Plot { x, y } => Message::new("bresenham-plot").with("x", x).with("y", y),
            Event::Done => Message::new("bresenham-done").with("count", self.plotted.len()),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let [major, minor] = self.major_minor().map(|length| Piece::Number(length.into()));
        let looked_at = self.decided.map(|(d, _)| d);
        let before = [Piece::Text("= "), Piece::Number(looked_at.into())];
        let (general, numbers, d) = match *event {
            Event::Decision { d } => {
                let numbers = vec![Piece::Text("= 2 · "), minor, Piece::Text(" − "), major];
                ("d = 2 · minor − major", numbers, d)
            }
            Event::Step { aside: true, d } => {
                let rest = [Piece::Text(" − 2 · "), major, Piece::Text(" + 2 · "), minor];
                ("d = d − 2 · major + 2 · minor", before.into_iter().chain(rest).collect(), d)
            }
            Event::Step { aside: false, d } => {
                let rest = [Piece::Text(" + 2 · "), minor];
                ("d = d + 2 · minor", before.into_iter().chain(rest).collect(), d)
            }
            _ => return,
        };
        let result = [Piece::Text(" = "), Piece::Result(d.into())];
        out.push(Formula { general, numbers: numbers.into_iter().chain(result).collect() });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let last = self.plotted.len().checked_sub(1);
        let row = |(step, plotted): (usize, &Plotted)| {
            let [x, y] = plotted.pixel.map(Value::from);
            let d = plotted.decided.map(|(d, _)| d);
            let way = plotted.decided.map(|(_, aside)| match aside {
                true => Value::Word("bresenham-way-aside"),
                false => Value::Word("bresenham-way-straight"),
            });
            Row::new(step.to_string(), vec![d.into(), way.unwrap_or(Value::BLANK), x, y])
                .active(last == Some(step))
                .role((d == Some(0)).then_some(Role::Tie))
        };
        let rows = self.plotted.iter().enumerate().map(row).collect();
        out.push(Table { title: "bresenham-steps", columns: vec!["d", "column-way", "x", "y"], rows });
        let [dx, dy] = [0, 1].map(|axis| Value::from(self.lengths.map(|lengths| lengths[axis])));
        let [major, minor] = self.major_minor().map(Value::from);
        let columns = vec!["dx", "dy", "major", "minor", "d"];
        let cells = vec![dx, dy, major, minor, self.d.into()];
        out.push(Table { title: "bresenham-values", columns, rows: vec![Row::new("P1P2", cells)] });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::pixels(&self.pixels(), self.size, out);
        if let (Some(Event::Step { .. }), Some(next)) = (event, self.next()) {
            out.extend(next.map(|at| picture::pixel(at, Role::Candidate, None)));
        }
        picture::line(self.given, self.ends().map(picture::centre), out);
        if let (Some(Event::Step { .. }), Some([straight, aside]), Some((d, _))) =
            (event, self.next(), self.decided)
        {
            let [a, b] = [straight, aside].map(picture::centre);
            let at = [0, 1].map(|axis| (a[axis] + b[axis]) / 2.0);
            let role = if d == 0 { Role::Tie } else { Role::Active };
            out.push(Mark::Point { at, role, label: Some(Label::new("d", d)) });
        }
    }

    fn view(&self) -> View {
        picture::view(self.given, self.size)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        picture::facts(&self.pixels(), self.size, out);
    }
}
