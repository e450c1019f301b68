//! What the lab shows of a Cohen-Sutherland run.

use super::{Event, MOST_CUTS, Settings};
use crate::{
    clip::line::{
        Border, End, Mistake, Mistakes, Outcode, Point, Segment, Window,
        subject::{Subject, bits, draw_borders, draw_region_codes, draw_window, joined, with_borders},
        view,
    },
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, View},
    math::Tally,
    message::{Message, Value},
    replay::State,
    trace::NoTrace,
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
    pub(super) settings: Settings,
    pub(super) subject: Subject,
    /// What is right: without the mistakes, or, if none is made, in exact arithmetic.
    right: Option<Segment>,
    /// The codes of the ends, once computed.
    codes: [Option<Outcode>; 2],
    or: Option<Outcode>,
    and: Option<Outcode>,
    chosen: Option<(Border, End)>,
    removed: [Option<Removed>; MOST_CUTS],
}

impl Snapshot {
    /// Before the first event.
    pub fn new(segment: Segment, window: Window, settings: impl Into<Settings>) -> Self {
        let settings = settings.into();
        let right = match settings {
            Settings { mistakes: Mistakes::NONE, .. } => super::clip(segment, &window),
            Settings { arithmetic, .. } => {
                super::clip_traced(segment, &window, arithmetic, &mut Tally::default(), &mut NoTrace)
            }
        };
        Self {
            window,
            settings,
            subject: Subject::new(segment, settings.arithmetic),
            right,
            codes: [None; 2],
            or: None,
            and: None,
            chosen: None,
            removed: [None; MOST_CUTS],
        }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Option<Segment> {
        self.subject.result()
    }

    pub(super) fn removed(&self) -> impl DoubleEndedIterator<Item = Removed> {
        self.removed.iter().flatten().copied()
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Code { end, code } => self.codes[end as usize] = Some(code),
            Event::Or { code } => (self.or, self.and, self.chosen) = (Some(code), None, None),
            Event::And { code } => self.and = Some(code),
            Event::Accept => self.subject.accepted = Some(true),
            Event::Reject | Event::GiveUp => self.subject.accepted = Some(false),
            Event::Choose { border, end } => self.chosen = Some((border, end)),
            Event::Cut { border, end, code, to } => {
                let from = self.subject.move_end(end, to);
                if let Some(free) = self.removed.iter_mut().find(|piece| piece.is_none()) {
                    *free = Some(Removed { end, border, from });
                }
                self.codes[end as usize] = Some(code);
                // They were of the old codes.
                (self.or, self.and) = (None, None);
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
                let message = Message::new("cohen-sutherland-code").with("end", Value::text(end.name()));
                with_borders(message, code)
            }
            Event::Or { code } if code.0 == 0 => Message::new("cohen-sutherland-or-zero"),
            Event::Or { code } => Message::new("cohen-sutherland-or").with("code", bits(code)),
            Event::Accept => Message::new("cohen-sutherland-accept"),
            Event::And { code } if code.0 == 0 => Message::new("cohen-sutherland-and-zero"),
            Event::And { code } if self.settings.mistakes.has(Mistake::OrForAnd) => {
                Message::new("cohen-sutherland-and-mistaken").with("code", bits(code))
            }
            Event::And { code } => Message::new("cohen-sutherland-and")
                .with("code", bits(code))
                .with("border", Value::Word(code.first().unwrap_or(Border::Top).word())),
            Event::Reject => match self.shared() {
                Some(border) => {
                    Message::new("cohen-sutherland-reject").with("border", Value::Word(border.word()))
                }
                None => Message::new("cohen-sutherland-reject-mistaken"),
            },
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
            Event::And { code } if self.settings.mistakes.has(Mistake::OrForAnd) => {
                out.push(joined("c1 OR c2", " OR ", [c1, c2, code]));
            }
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
                let [x, y] = self.subject.ends[end as usize];
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
        if !self.subject.is_exact() || self.settings.mistakes != Mistakes::NONE {
            out.push(self.subject.comparison(self.right));
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        draw_window(&self.window.corners(), out);
        let cutting = self.chosen.filter(|_| self.subject.accepted.is_none()).map(|(border, _)| border);
        let (now, note) = match event {
            Some(Event::Cut { end, border, .. }) => {
                let note = Message::new("cohen-sutherland-cutting")
                    .with("axis", Value::text(["x", "y"][border.axis()]))
                    .with("border", Value::text(border.name()));
                (Some(*end), Some(note))
            }
            _ => (None, None),
        };
        draw_borders(&self.window, cutting, note, out);
        let named = End::ALL.map(|end| (self.subject.name(end), self.codes[end as usize]));
        draw_region_codes(self.view(), &self.window, &named, out);
        for piece in self.removed() {
            let to = self
                .removed()
                .skip_while(|other| *other != piece)
                .skip(1)
                .find(|later| later.end == piece.end)
                .map_or(self.subject.ends[piece.end as usize], |later| later.from);
            out.push(Mark::Segment { ends: [piece.from, to], role: Role::Rejected, label: None });
        }
        self.subject.draw_rest(self.right, out);
        self.subject.draw_ends(now, self.right, out);
    }

    fn view(&self) -> View {
        view(self.subject.original, &self.window)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        self.subject.facts(out);
    }
}

impl Snapshot {
    /// A border that both ends lie beyond.
    fn shared(&self) -> Option<Border> {
        let [c1, c2] = self.codes.map(Option::unwrap_or_default);
        Outcode(c1.0 & c2.0).first()
    }
}
