//! What the lab shows of a Cohen-Sutherland run.

use super::{
    Event, MOST_CUTS,
    formulas::{bits, joined},
};
use crate::{
    clip::line::{Border, End, Outcode, Point, Segment, Window, facts, view},
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Role, Row, Table, View},
    math::Arithmetic,
    message::{Message, Value},
    replay::State,
};

/// A piece of the segment that was cut off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Removed {
    end: End,
    border: Border,
    pub(super) from: Point,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) window: Window,
    pub(super) arithmetic: Arithmetic,
    pub(super) original: Segment,
    /// The ends as they stand.
    pub(super) ends: Segment,
    /// Their codes, once computed.
    codes: [Option<Outcode>; 2],
    or: Option<Outcode>,
    and: Option<Outcode>,
    chosen: Option<(Border, End)>,
    removed: [Option<Removed>; MOST_CUTS],
    /// `Some(true)` accepted, `Some(false)` rejected, `None` still running.
    accepted: Option<bool>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(segment: Segment, window: Window, arithmetic: Arithmetic) -> Self {
        Self {
            window,
            arithmetic,
            original: segment,
            ends: segment,
            codes: [None; 2],
            or: None,
            and: None,
            chosen: None,
            removed: [None; MOST_CUTS],
            accepted: None,
        }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Option<Segment> {
        (self.accepted == Some(true)).then_some(self.ends)
    }

    pub(super) fn removed(&self) -> impl DoubleEndedIterator<Item = Removed> {
        self.removed.iter().flatten().copied()
    }

    fn moved(&self, end: End) -> bool {
        self.removed().any(|piece| piece.end == end)
    }

    /// The name of an end as it stands.
    fn name(&self, end: End) -> &'static str {
        if self.moved(end) { ["P1′", "P2′"][end as usize] } else { end.name() }
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Code { end, code } => self.codes[end as usize] = Some(code),
            Event::Or { code } => (self.or, self.and, self.chosen) = (Some(code), None, None),
            Event::And { code } => self.and = Some(code),
            Event::Accept => self.accepted = Some(true),
            Event::Reject | Event::GiveUp => self.accepted = Some(false),
            Event::Choose { border, end } => self.chosen = Some((border, end)),
            Event::Cut { border, end, code, to } => {
                let from = std::mem::replace(&mut self.ends[end as usize], to);
                if let Some(free) = self.removed.iter_mut().find(|piece| piece.is_none()) {
                    *free = Some(Removed { end, border, from });
                }
                self.codes[end as usize] = Some(code);
            }
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "cohen-sutherland";

    const LISTING: &'static [&'static str] = &[
        "c1 ← code(P1)",
        "c2 ← code(P2)",
        "repeat: if c1 OR c2 = 0",
        "    accept; stop",
        "  if c1 AND c2 ≠ 0",
        "    reject; stop",
        "  b ← first bit that differs",
        "  move the end with b = 1 to border b",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Code { end: End::P1, .. } => 0,
            Event::Code { end: End::P2, .. } => 1,
            Event::Or { .. } => 2,
            Event::Accept => 3,
            Event::And { .. } => 4,
            Event::Reject | Event::GiveUp => 5,
            Event::Choose { .. } => 6,
            Event::Cut { .. } => 7,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Code { .. } => Operations::new(4, 0, 0),
            Event::Cut { .. } => Operations::new(4, 1, 1),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Accept | Event::Reject | Event::GiveUp => Level::Primitive,
            Event::Cut { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Cut { border, .. } => {
                let label = match border {
                    Border::Top => "cohen-sutherland-marker-top",
                    Border::Bottom => "cohen-sutherland-marker-bottom",
                    Border::Right => "cohen-sutherland-marker-right",
                    Border::Left => "cohen-sutherland-marker-left",
                };
                (Role::Neutral, label)
            }
            Event::Accept => (Role::Accepted, "word-accept"),
            Event::Reject | Event::GiveUp => (Role::Rejected, "word-reject"),
            _ => return None,
        };
        Some(Marker { role, label: Some(label) })
    }

    fn opening(&self) -> Message {
        Message::new("cohen-sutherland-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Code { end, code } if code.0 == 0 => {
                Message::new("cohen-sutherland-code-inside").with("end", Value::text(end.name()))
            }
            Event::Code { end, code } => {
                let mut beyond = Border::ALL.into_iter().filter(|&border| code.has(border)).map(Border::word);
                let [first, second] = [beyond.next(), beyond.next()].map(|id| id.map(Value::Word));
                Message::new("cohen-sutherland-code")
                    .with("end", Value::text(end.name()))
                    .with("borders", 1 + usize::from(second.is_some()))
                    .with("first", first)
                    .with("second", second)
                    .with("code", bits(code))
            }
            Event::Or { code } if code.0 == 0 => Message::new("cohen-sutherland-or-zero"),
            Event::Or { code } => Message::new("cohen-sutherland-or").with("code", bits(code)),
            Event::Accept => Message::new("cohen-sutherland-accept"),
            Event::And { code } if code.0 == 0 => Message::new("cohen-sutherland-and-zero"),
            Event::And { code } => Message::new("cohen-sutherland-and")
                .with("code", bits(code))
                .with("border", Value::Word(code.first().unwrap_or(Border::Top).word())),
            Event::Reject => {
                let border = self.and.and_then(Outcode::first).unwrap_or(Border::Top);
                Message::new("cohen-sutherland-reject").with("border", Value::Word(border.word()))
            }
            Event::GiveUp => Message::new("cohen-sutherland-give-up").with("cuts", MOST_CUTS),
            Event::Choose { border, end } => Message::new("cohen-sutherland-choose")
                .with("border", Value::Word(border.word()))
                .with("end", Value::text(end.name()))
                .with("other", Value::text(end.other().name()))
                .with("axis", Value::text(["x", "y"][border.axis()]))
                .with("at", Value::text(border.name())),
            Event::Cut { border, end, code, to } => Message::new("cohen-sutherland-cut")
                .with("end", Value::text(end.name()))
                .with("border", Value::text(border.name()))
                .with("axis", Value::text(["x", "y"][border.axis()]))
                .with("to", to)
                .with("code", bits(code)),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let [Some(c1), Some(c2)] = self.codes else { return };
        match *event {
            Event::Or { code } => out.push(joined("c1 OR c2", " OR ", [c1, c2, code])),
            Event::And { code } => out.push(joined("c1 AND c2", " AND ", [c1, c2, code])),
            Event::Cut { border, end, to, .. } => out.extend(self.cut(border, end, to)),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let active = self.chosen.map(|(_, end)| end);
        let mut rows: Vec<Row> = End::ALL
            .into_iter()
            .map(|end| {
                let [x, y] = self.ends[end as usize];
                let code = self.codes[end as usize].map_or(Value::None, bits);
                Row::new(end.name(), vec![x.into(), y.into(), code]).active(active == Some(end))
            })
            .collect();
        for (name, code) in [("OR", self.or), ("AND", self.and)] {
            rows.push(Row::new(name, vec![Value::BLANK, Value::BLANK, code.map_or(Value::None, bits)]));
        }
        out.push(Table { title: "cohen-sutherland-ends", columns: vec!["x", "y", "T B R L"], rows });
        let Window { xmin, ymin, xmax, ymax } = self.window;
        out.push(Table {
            title: "cohen-sutherland-window",
            columns: vec!["x", "y"],
            rows: vec![
                Row::new("min", vec![xmin.into(), ymin.into()]),
                Row::new("max", vec![xmax.into(), ymax.into()]),
            ],
        });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        out.push(Mark::Polygon {
            points: self.window.corners().to_vec(),
            role: Role::Neutral,
            object: None,
            label: None,
        });
        let cutting = self.chosen.filter(|_| self.accepted.is_none()).map(|(border, _)| border);
        for border in Border::ALL {
            let role = if cutting == Some(border) { Role::Active } else { Role::Candidate };
            let at = self.window.at(border);
            let label = Some(Label::new(border.name(), at));
            let now = matches!(event, Some(Event::Cut { border: cut, .. }) if *cut == border);
            let note = now.then(|| {
                Message::new("cohen-sutherland-cutting")
                    .with("axis", Value::text(["x", "y"][border.axis()]))
                    .with("border", Value::text(border.name()))
            });
            out.push(Mark::Guide { axis: border.axis() as u8, at, role, label, note });
        }
        self.region_codes(out);
        for piece in self.removed() {
            let to = self
                .removed()
                .skip_while(|other| *other != piece)
                .skip(1)
                .find(|later| later.end == piece.end)
                .map_or(self.ends[piece.end as usize], |later| later.from);
            out.push(Mark::Segment { ends: [piece.from, to], role: Role::Rejected, label: None });
        }
        let role = match self.accepted {
            None => Role::Active,
            Some(true) => Role::Accepted,
            Some(false) => Role::Rejected,
        };
        out.push(Mark::Segment { ends: self.ends, role, label: None });
        for end in End::ALL {
            let at = self.original[end as usize];
            out.push(Mark::Point { at, role: Role::Neutral, label: Some(Label::new(end.name(), at)) });
            if self.moved(end) {
                let at = self.ends[end as usize];
                let now = matches!(event, Some(Event::Cut { end: cut, .. }) if *cut == end);
                let role = match self.accepted {
                    _ if now => Role::Active,
                    Some(true) => Role::Accepted,
                    Some(false) => Role::Rejected,
                    None => Role::Neutral,
                };
                let label = Label::new(self.name(end), at);
                out.push(Mark::Point { at, role, label: Some(label) });
            }
        }
    }

    fn view(&self) -> View {
        view(self.original, &self.window)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        facts(self.accepted, self.ends, out);
    }
}

impl Snapshot {
    /// The code of each of the nine regions, at its upper left corner; those that hold an end
    /// stand out.
    fn region_codes(&self, out: &mut Vec<Mark>) {
        let View { min, max, .. } = self.view();
        let Window { xmin, ymin, xmax, ymax } = self.window;
        for (y, vertical) in [(max[1], 0b1000), (ymax, 0), (ymin, 0b0100)] {
            for (x, horizontal) in [(min[0], 0b0001), (xmin, 0), (xmax, 0b0010)] {
                let code = Outcode(vertical | horizontal);
                let here = End::ALL.into_iter().filter(|&end| self.codes[end as usize] == Some(code));
                let here: Vec<_> = here.map(|end| self.name(end)).collect();
                out.push(Mark::Text {
                    at: [x, y],
                    role: if here.is_empty() { Role::Candidate } else { Role::Neutral },
                    label: Label::new(
                        code.to_string(),
                        (!here.is_empty()).then(|| Value::text(here.join(", "))),
                    ),
                    big: true,
                });
            }
        }
        // What the four bits mean, under the first code.
        let label = Label::new("", Value::Word("cohen-sutherland-legend"));
        out.push(Mark::Text { at: [min[0], max[1]], label, role: Role::Candidate, big: false });
    }
}
