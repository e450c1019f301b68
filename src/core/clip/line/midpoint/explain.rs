//! What the lab shows of a midpoint subdivision.

use super::Event;
use crate::{
    clip::line::{
        End, Outcode, Point, Segment, Window, cohen_sutherland,
        subject::{Subject, bits, draw_borders, draw_region_codes, draw_window, joined, with_borders},
        view,
    },
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    math::Arithmetic,
    message::{Message, Value},
    replay::State,
};

/// A search: A, E and M with their codes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Search {
    /// The end that will move.
    end: End,
    near: (Point, Outcode),
    far: (Point, Outcode),
    /// Half-way, once computed.
    middle: Option<(Point, Outcode)>,
    /// A and E as M was computed.
    halved: Segment,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    window: Window,
    subject: Subject,
    /// The correctly rounded answer.
    right: Option<Segment>,
    /// The codes of the given ends, once computed.
    codes: [Option<Outcode>; 2],
    search: Option<Search>,
    halvings: usize,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(segment: Segment, window: Window, arithmetic: Arithmetic) -> Self {
        Self {
            window,
            subject: Subject::new(segment, arithmetic),
            right: cohen_sutherland::clip(segment, &window),
            codes: [None; 2],
            search: None,
            halvings: 0,
        }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Option<Segment> {
        self.subject.result()
    }

    /// How often the listing has halved.
    pub fn halvings(&self) -> usize {
        self.halvings
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Code { end, code } => self.codes[end as usize] = Some(code),
            Event::Or { .. } | Event::And { .. } | Event::Lost { .. } | Event::Close { .. } => {}
            Event::Search { end } => {
                let given = |end: End| {
                    let code = self.codes[end as usize].unwrap_or_default();
                    (self.subject.original[end as usize], code)
                };
                let [near, far] = [end.other(), end].map(given);
                self.search = Some(Search { end, near, far, middle: None, halved: [near.0, far.0] });
            }
            Event::Halve { code, to } => {
                self.halvings += 1;
                if let Some(search) = &mut self.search {
                    search.middle = Some((to, code));
                    search.halved = [search.near.0, search.far.0];
                }
            }
            Event::Drop | Event::Keep => {
                if let Some(Search { near, far, middle: Some(middle), .. }) = &mut self.search {
                    *(if *event == Event::Keep { near } else { far }) = *middle;
                }
            }
            Event::Move { end, to } => {
                self.subject.move_end(end, to);
            }
            Event::Accept => self.subject.accepted = Some(true),
            Event::Reject => self.subject.accepted = Some(false),
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "midpoint";

    const LISTING: &'static [&'static str] = &[
        "c1 ← code(P1); c2 ← code(P2)",
        "if c1 OR c2 = 0: accept; stop",
        "if c1 AND c2 ≠ 0: reject; stop",
        "for each end E outside: A ← the other",
        "  repeat: M ← (A + E) / 2",
        "    if code(M) AND code(E) ≠ 0: E ← M",
        "    else: A ← M",
        "    if code(A) AND code(E) ≠ 0: reject",
        "  until A, E are neighbours: A visible?",
        "  move the end to A",
        "accept",
        "reject: nothing is visible",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Code { .. } => 0,
            Event::Or { .. } => 1,
            Event::And { .. } => 2,
            Event::Search { .. } => 3,
            Event::Halve { .. } => 4,
            Event::Drop => 5,
            Event::Keep => 6,
            Event::Lost { .. } => 7,
            Event::Close { .. } => 8,
            Event::Move { .. } => 9,
            Event::Accept => 10,
            Event::Reject => 11,
        }
    }

    /// A halving is a shift; a midpoint's code costs what that of an end does.
    fn operations(event: &Event) -> Operations {
        match event {
            Event::Code { .. } | Event::Halve { .. } => Operations::new(4, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Accept | Event::Reject => Level::Primitive,
            Event::Drop | Event::Keep | Event::Move { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Search { .. } => (Role::Neutral, "midpoint-marker-search"),
            Event::Move { .. } => (Role::Changed, "midpoint-marker-move"),
            Event::Accept => (Role::Accepted, "word-accept"),
            Event::Reject => (Role::Rejected, "word-reject"),
            _ => return None,
        };
        Some(Marker { role, label: Some(label) })
    }

    fn opening(&self) -> Message {
        Message::new("midpoint-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let shared = |id, code: Outcode| {
            let border = code.first().map(|border| Value::Word(border.word()));
            Message::new(id).with("code", bits(code)).with("border", border)
        };
        match *event {
            Event::Code { end, code } if code.0 == 0 => {
                Message::new("midpoint-code-inside").with("end", Value::text(end.name()))
            }
            Event::Code { end, code } => {
                with_borders(Message::new("midpoint-code").with("end", Value::text(end.name())), code)
            }
            Event::Or { code } if code.0 == 0 => Message::new("midpoint-or-zero"),
            Event::Or { code } => Message::new("midpoint-or").with("code", bits(code)),
            Event::And { code } if code.0 == 0 => Message::new("midpoint-and-zero"),
            Event::And { code } => shared("midpoint-and", code),
            Event::Search { end } => Message::new("midpoint-search")
                .with("end", Value::text(end.name()))
                .with("other", Value::text(end.other().name())),
            Event::Halve { code, to } => {
                Message::new("midpoint-halve").with("to", to).with("code", bits(code))
            }
            Event::Drop => {
                let code = self.search.map(|search| search.far.1).unwrap_or_default();
                shared("midpoint-drop", code)
            }
            Event::Keep => Message::new("midpoint-keep"),
            Event::Lost { code } => shared("midpoint-lost", code),
            Event::Close { visible: true } => Message::new("midpoint-close"),
            Event::Close { visible: false } => Message::new("midpoint-close-missed"),
            Event::Move { end, to } => {
                Message::new("midpoint-move").with("end", Value::text(end.name())).with("to", to)
            }
            Event::Accept => Message::new("midpoint-accept").with("halvings", self.halvings),
            Event::Reject => Message::new("midpoint-reject"),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let [c1, c2] = self.codes.map(Option::unwrap_or_default);
        match *event {
            Event::Or { code } => out.push(joined("c1 OR c2", " OR ", [c1, c2, code])),
            Event::And { code } => out.push(joined("c1 AND c2", " AND ", [c1, c2, code])),
            Event::Halve { to, .. } => {
                let Some(Search { halved: [near, far], .. }) = self.search else { return };
                out.extend([0, 1].map(|axis| Formula {
                    general: ["x = (xA + xE) / 2", "y = (yA + yE) / 2"][axis],
                    numbers: vec![
                        Piece::Text("= ("),
                        Piece::Number(near[axis].into()),
                        Piece::Text(" + "),
                        Piece::Number(far[axis].into()),
                        Piece::Text(") / 2 = "),
                        Piece::Result(to[axis].into()),
                    ],
                }));
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let row = |name: &str, at: Option<Point>, code: Option<Outcode>| {
            let [x, y] = [0, 1].map(|axis| at.map(|at| at[axis]).into());
            Row::new(name, vec![x, y, code.map_or(Value::None, bits)])
        };
        let mut rows: Vec<Row> = End::ALL
            .into_iter()
            .map(|end| {
                let at = self.subject.original[end as usize];
                row(end.name(), Some(at), self.codes[end as usize])
            })
            .collect();
        let near = self.search.map(|search| search.near);
        let far = self.search.map(|search| search.far);
        let middle = self.search.and_then(|search| search.middle);
        for (name, place) in [("A", near), ("E", far), ("M", middle)] {
            let row = row(name, place.map(|(at, _)| at), place.map(|(_, code)| code));
            rows.push(row.active(name == "M" && middle.is_some() && self.subject.accepted.is_none()));
        }
        rows.push(Row::new("row-midpoint-halvings", vec![Value::BLANK, Value::BLANK, self.halvings.into()]));
        out.push(Table { title: "midpoint-points", columns: vec!["x", "y", "T B R L"], rows });
        out.push(self.subject.comparison(self.right));
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        draw_window(&self.window.corners(), out);
        draw_borders(&self.window, None, None, out);
        let named = End::ALL.map(|end| (end.name(), self.codes[end as usize]));
        draw_region_codes(self.view(), &self.window, &named, out);
        self.subject.draw_removed(out);
        match self.search.filter(|_| self.subject.accepted.is_none()) {
            Some(search) => self.draw_search(search, event, out),
            None => self.subject.draw_rest(self.right, out),
        }
        let now = match event {
            Some(Event::Move { end, .. }) => Some(*end),
            _ => None,
        };
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
    /// What was dropped, what is behind A, and what is halved next.
    fn draw_search(&self, search: Search, event: Option<&Event>, out: &mut Vec<Mark>) {
        let Search { end, near: (near, _), far: (far, _), middle, .. } = search;
        let mut segment = |ends: Segment, role| out.push(Mark::Segment { ends, role, label: None });
        segment([self.subject.ends[end.other() as usize], near], Role::Neutral);
        if !self.subject.has_moved(end) {
            segment([far, self.subject.original[end as usize]], Role::Rejected);
            segment([near, far], Role::Active);
        }
        if let (Some((at, _)), Some(Event::Halve { .. } | Event::Keep | Event::Drop)) = (middle, event) {
            let label = Some(Label::new("M", at));
            out.push(Mark::Point { at, role: Role::Active, label });
        }
    }
}
