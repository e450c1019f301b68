//! What the lab shows of a Nicholl-Lee-Nicholl run.

use super::{
    Event, Question,
    regions::{corner, name, names, rays},
};
use crate::{
    clip::line::{
        Border, End, Outcode, Segment, Window, cohen_sutherland,
        subject::{Subject, bits, draw_borders, draw_window, with_borders},
        view,
    },
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Role, Row, Table, View},
    math::Arithmetic,
    message::{Message, Value},
    replay::State,
};

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) window: Window,
    pub(super) subject: Subject,
    /// In exact arithmetic.
    right: Option<Segment>,
    /// The code of P1, once it is placed.
    place: Option<Outcode>,
    /// What is known of P2: the borders it was compared with, and those it lies beyond.
    compared: [Outcode; 2],
    /// E and F, as far as they are known.
    cuts: [Option<Border>; 2],
    work: Operations,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(segment: Segment, window: Window, arithmetic: Arithmetic) -> Self {
        Self {
            window,
            subject: Subject::new(segment, arithmetic),
            right: cohen_sutherland::clip(segment, &window),
            place: None,
            compared: [Outcode::default(); 2],
            cuts: [None; 2],
            work: Operations::NONE,
        }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Option<Segment> {
        self.subject.result()
    }

    fn compare(&mut self, border: Border, beyond: bool) {
        let [known, far] = &mut self.compared;
        known.0 |= Outcode::bit(border).0;
        far.0 |= if beyond { Outcode::bit(border).0 } else { 0 };
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.work += Self::operations(event);
        match *event {
            Event::Place { code } => {
                self.place = Some(code);
                // Of two borders, a slope will tell.
                self.cuts[0] = code.first().filter(|border| Outcode::bit(*border) == code);
            }
            Event::Same { border, beyond } => self.compare(border, beyond),
            Event::Far { border, beyond } => {
                self.compare(border, beyond);
                if beyond {
                    self.cuts[1].get_or_insert(border);
                }
            }
            Event::Slope { question: Question::Entry, corner, later, .. } => {
                self.cuts[0] = Some(corner[usize::from(!later)]);
            }
            Event::Slope { question: Question::Exit, corner, later, .. } => {
                self.cuts[1] = Some(corner[usize::from(later)]);
            }
            Event::Slope { question: Question::Miss, .. } => {}
            Event::Cut { end, to, .. } => {
                self.subject.move_end(end, to);
            }
            Event::Accept => self.subject.accepted = Some(true),
            Event::Reject => self.subject.accepted = Some(false),
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "nicholl-lee-nicholl";

    const LISTING: &'static [&'static str] = &[
        "place P1: inside, beyond a border, or two",
        "each of these: reject if P2 is beyond it",
        "E ← of these, the one crossed last",
        "each other border F: is P2 beyond it?",
        "  F across E: reject if crossed before E",
        "F ← of these, the one crossed first",
        "P1 ← where the line crosses E",
        "P2 ← where the line crosses F",
        "accept",
        "if rejected: nothing is visible",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Place { .. } => 0,
            Event::Same { .. } => 1,
            Event::Slope { question: Question::Entry, .. } => 2,
            Event::Far { .. } => 3,
            Event::Slope { question: Question::Miss, .. } => 4,
            Event::Slope { question: Question::Exit, .. } => 5,
            Event::Cut { end: End::P1, .. } => 6,
            Event::Cut { end: End::P2, .. } => 7,
            Event::Accept => 8,
            Event::Reject => 9,
        }
    }

    fn operations(event: &Event) -> Operations {
        match *event {
            // Across each axis, the second border is looked at only if P1 is not beyond the first.
            Event::Place { code } => {
                let first = [Border::Right, Border::Top].into_iter().filter(|border| code.has(*border));
                Operations::new(4 - first.map(|_| 1).sum::<u64>(), 0, 0)
            }
            Event::Same { .. } | Event::Far { .. } => Operations::new(1, 0, 0),
            Event::Slope { products, .. } => Operations::new(1, products.into(), 0),
            Event::Cut { products, .. } => Operations::new(0, products.into(), 1),
            Event::Accept | Event::Reject => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Accept | Event::Reject => Level::Primitive,
            Event::Place { .. } | Event::Slope { .. } | Event::Cut { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Slope { .. } => (Role::Neutral, "nicholl-lee-nicholl-marker-slope"),
            Event::Cut { .. } => (Role::Changed, "nicholl-lee-nicholl-marker-cut"),
            Event::Accept => (Role::Accepted, "word-accept"),
            Event::Reject => (Role::Rejected, "word-reject"),
            _ => return None,
        };
        Some(Marker { role, label: Some(label) })
    }

    fn opening(&self) -> Message {
        Message::new("nicholl-lee-nicholl-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, border: Border| Message::new(id).with("border", Value::Word(border.word()));
        let yes = |yes: bool, ids: [&'static str; 2]| ids[usize::from(!yes)];
        match *event {
            Event::Place { code } if code.0 == 0 => Message::new("nicholl-lee-nicholl-place-inside"),
            Event::Place { code } => with_borders(Message::new("nicholl-lee-nicholl-place"), code),
            Event::Same { border, beyond } => {
                about(yes(beyond, ["nicholl-lee-nicholl-same-beyond", "nicholl-lee-nicholl-same"]), border)
            }
            Event::Far { border, beyond } => {
                about(yes(beyond, ["nicholl-lee-nicholl-far-beyond", "nicholl-lee-nicholl-far"]), border)
            }
            Event::Slope { question, corner: [a, b], later, .. } => {
                let (first, last) = if later { (b, a) } else { (a, b) };
                let id = match question {
                    Question::Entry => "nicholl-lee-nicholl-slope-entry",
                    Question::Exit => "nicholl-lee-nicholl-slope-exit",
                    Question::Miss => {
                        yes(later, ["nicholl-lee-nicholl-slope-missed", "nicholl-lee-nicholl-slope-hit"])
                    }
                };
                about(id, first).with("other", Value::Word(last.word()))
            }
            Event::Cut { border, end, to, .. } => {
                about("nicholl-lee-nicholl-cut", border).with("end", Value::text(end.name())).with("to", to)
            }
            Event::Accept => {
                let name = name(self.cuts);
                Message::new("nicholl-lee-nicholl-accept")
                    .with("cuts", name.len())
                    .with("region", Value::text(name))
                    .with("divisions", Value::Int(i64::try_from(self.work.divisions).unwrap_or(i64::MAX)))
            }
            Event::Reject => Message::new("nicholl-lee-nicholl-reject"),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Slope { corner, .. } => out.extend(corner.map(|border| self.slope(border))),
            Event::Cut { border, to, .. } => out.push(self.cut(border, to)),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let given = End::ALL.into_iter().map(|end| {
            let [x, y] = self.subject.original[end as usize];
            let code = match end {
                End::P1 => self.place.map_or(Value::None, bits),
                End::P2 => self.known_bits(),
            };
            let cut = self.cuts[end as usize].map_or(Value::None, |border| Value::Word(border.word()));
            Row::new(end.name(), vec![x.into(), y.into(), code, cut])
        });
        // Codes and borders are those of the given ends: a cut computes no code.
        let moved = End::ALL.into_iter().filter(|end| self.subject.has_moved(*end)).map(|end| {
            let [x, y] = self.subject.ends[end as usize];
            Row::new(self.subject.name(end), vec![x.into(), y.into(), Value::BLANK, Value::BLANK])
        });
        out.push(Table {
            title: "nicholl-lee-nicholl-ends",
            columns: vec!["x", "y", "T B R L", "E, F"],
            rows: given.chain(moved).collect(),
        });
        let Operations { comparisons, multiplications, divisions } = self.work;
        let count = |n: u64| Value::Int(i64::try_from(n).unwrap_or(i64::MAX));
        out.push(Table {
            title: "nicholl-lee-nicholl-work",
            columns: vec!["column-clip-line-count"],
            rows: vec![
                Row::new("row-clip-line-comparisons", vec![count(comparisons)]),
                Row::new("row-clip-line-multiplications", vec![count(multiplications)]),
                Row::new("row-clip-line-divisions", vec![count(divisions)]),
            ],
        });
        if !self.subject.is_exact() {
            out.push(self.subject.comparison(self.right));
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        draw_window(&self.window.corners(), out);
        let (mut active, mut now, mut slope) = (None, None, None);
        match event {
            Some(Event::Same { border, .. } | Event::Far { border, .. }) => active = Some(*border),
            Some(Event::Slope { corner, .. }) => slope = Some(*corner),
            Some(Event::Cut { border, end, .. }) => (active, now) = (Some(*border), Some(*end)),
            _ => {}
        }
        draw_borders(&self.window, active, None, out);
        self.draw_regions(slope, out);
        self.subject.draw_removed(out);
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
    /// The bits of P2 that comparisons have told; nothing before the first.
    fn known_bits(&self) -> Value {
        let [known, far] = self.compared;
        if known.0 == 0 { Value::None } else { bits(far) }
    }

    /// The rays from P1 through the corners and the names of the regions between them, once P1 is
    /// placed; the ray that a slope is compared with stands out.
    fn draw_regions(&self, slope: Option<[Border; 2]>, out: &mut Vec<Mark>) {
        let Some(code) = self.place else { return };
        let ([p1, _], view) = (self.subject.original, self.view());
        for ends in rays(p1, &self.window, &view) {
            out.push(Mark::Segment { ends, role: Role::Candidate, label: None });
        }
        if let Some(borders) = slope {
            let ends = [p1, corner(&self.window, borders)];
            out.push(Mark::Segment { ends, role: Role::Active, label: None });
        }
        let here = (self.subject.accepted == Some(true)).then(|| name(self.cuts));
        for (name, at) in names(p1, code, &self.window, &view) {
            let role = if here.as_ref() == Some(&name) { Role::Neutral } else { Role::Candidate };
            out.push(Mark::Text { at, label: Label::name(name), role, big: true });
        }
    }
}
