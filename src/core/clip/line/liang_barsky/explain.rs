//! What the lab shows of a Liang-Barsky run.

use super::{
    Course, Event, Parameter,
    forms::{Exact, Form, crossing},
};
use crate::{
    clip::line::{
        Border, End, Segment, Window, cohen_sutherland,
        subject::{Subject, draw_borders, draw_window},
        view,
    },
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Role, Row, Table, View},
    math::{Arithmetic, Sign, Tally},
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
    /// What the line does at each border, in the order of [`Border::ALL`], once known.
    courses: [Option<Course>; 4],
    /// t0 and t1, not divided.
    pub(super) parameters: [Parameter; 2],
    /// The border that the loop is at.
    now: Option<Border>,
    /// t0 and t1, once divided.
    pub(super) quotients: [Option<f32>; 2],
}

impl Snapshot {
    /// Before the first event.
    pub fn new(segment: Segment, window: Window, arithmetic: Arithmetic) -> Self {
        Self {
            window,
            subject: Subject::new(segment, arithmetic),
            right: cohen_sutherland::clip(segment, &window),
            courses: [None; 4],
            parameters: End::ALL.map(Parameter::Of),
            now: None,
            quotients: [None; 2],
        }
    }

    /// The result that the events so far amount to: the ends and their parameters.
    pub fn result(&self) -> Option<super::Visible> {
        let [t0, t1] = self.quotients;
        let t = [t0.unwrap_or(0.0), t1.unwrap_or(1.0)];
        self.subject.result().map(|segment| super::Visible { segment, t })
    }

    /// How many divisions the listing has done.
    pub fn divisions(&self) -> usize {
        self.quotients.iter().flatten().count()
    }

    /// The parameters of the borders seen so far and of both ends, from the first to the last.
    ///
    /// The order is the exact one in every arithmetic: where rounding decides otherwise, the two
    /// can be held against each other.
    pub fn ordered(&self) -> Vec<Parameter> {
        let crossed = Border::ALL.into_iter().zip(self.courses);
        let crossed = crossed.filter(|(_, course)| course.is_some_and(|course| course != Course::Parallel));
        let mut all: Vec<_> = [Parameter::Of(End::P1)]
            .into_iter()
            .chain(crossed.map(|(border, _)| Parameter::At(border)))
            .chain([Parameter::Of(End::P2)])
            .collect();
        let mut tally = Tally::default();
        let mut line = Exact::new(self.subject.original, &self.window, &mut tally);
        all.sort_by(|a, b| line.order(*a, *b).cmp(&Sign::Zero));
        all
    }
}

/// The name of a border's parameter, as the figures of the textbooks number them.
pub(super) fn alpha(border: Border) -> &'static str {
    match border {
        Border::Bottom => "α1",
        Border::Left => "α2",
        Border::Top => "α3",
        Border::Right => "α4",
    }
}

/// t0 or t1.
pub(super) fn bound(end: End) -> &'static str {
    ["t0", "t1"][end as usize]
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Start | Event::Along { .. } | Event::Order { .. } => {}
            Event::Measure { border, course } => {
                self.now = Some(border);
                self.courses[border as usize] = Some(course);
            }
            Event::Enter { border, later } if later => self.parameters[0] = Parameter::At(border),
            Event::Leave { border, earlier } if earlier => self.parameters[1] = Parameter::At(border),
            Event::Enter { .. } | Event::Leave { .. } => {}
            Event::Reject => self.subject.accepted = Some(false),
            Event::Divide { border, end, t } => {
                self.now = Some(border);
                self.quotients[end as usize] = Some(t);
            }
            Event::Cut { end, to, .. } => {
                self.subject.move_end(end, to);
            }
            Event::Accept => (self.subject.accepted, self.now) = (Some(true), None),
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "liang-barsky";

    const LISTING: &'static [&'static str] = &[
        "t0 ← 0; t1 ← 1",
        "for each border: p, q",
        "  if p = 0: hopeless if q < 0",
        "  if p < 0: t0 ← the later of t0 and q / p",
        "  if p > 0: t1 ← the earlier of t1 and q / p",
        "  hopeless if t0 > t1",
        "  if hopeless: reject; stop",
        "for each end cut off: divide t = q / p",
        "  move the end to P1 + t (P2 − P1)",
        "accept",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Start => 0,
            Event::Measure { .. } => 1,
            Event::Along { .. } => 2,
            Event::Enter { .. } => 3,
            Event::Leave { .. } => 4,
            Event::Order { .. } => 5,
            Event::Reject => 6,
            Event::Divide { .. } => 7,
            Event::Cut { .. } => 8,
            Event::Accept => 9,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Measure { .. } | Event::Along { .. } => Operations::new(1, 0, 0),
            Event::Enter { .. } | Event::Leave { .. } | Event::Order { .. } => Operations::new(1, 2, 0),
            Event::Divide { .. } => Operations::new(0, 0, 1),
            Event::Cut { .. } => Operations::new(0, 2, 0),
            Event::Start | Event::Reject | Event::Accept => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Accept | Event::Reject => Level::Primitive,
            Event::Along { .. } | Event::Enter { .. } | Event::Leave { .. } | Event::Cut { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Measure { course, .. } => (
                Role::Neutral,
                Some(match course {
                    Course::Enters => "liang-barsky-marker-enter",
                    Course::Leaves => "liang-barsky-marker-leave",
                    Course::Parallel => "liang-barsky-marker-parallel",
                }),
            ),
            Event::Enter { later: true, .. } | Event::Leave { earlier: true, .. } => (Role::Changed, None),
            Event::Divide { .. } => (Role::Changed, Some("liang-barsky-marker-divide")),
            Event::Accept => (Role::Accepted, Some("word-accept")),
            Event::Reject => (Role::Rejected, Some("word-reject")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("liang-barsky-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, border: Border| {
            Message::new(id)
                .with("border", Value::Word(border.word()))
                .with("at", Value::text(border.name()))
                .with("name", Value::text(alpha(border)))
        };
        match *event {
            Event::Start => Message::new("liang-barsky-start"),
            Event::Measure { border, course } => about(
                match course {
                    Course::Enters => "liang-barsky-measure-enters",
                    Course::Leaves => "liang-barsky-measure-leaves",
                    Course::Parallel => "liang-barsky-measure-parallel",
                },
                border,
            ),
            Event::Along { border, outside: true } => about("liang-barsky-along-outside", border),
            Event::Along { border, outside: false } => about("liang-barsky-along-inside", border),
            Event::Enter { border, later: true } => about("liang-barsky-enter-later", border),
            Event::Enter { border, later: false } => about("liang-barsky-enter-earlier", border),
            Event::Leave { border, earlier: true } => about("liang-barsky-leave-earlier", border),
            Event::Leave { border, earlier: false } => about("liang-barsky-leave-later", border),
            Event::Order { crossed: true } => Message::new("liang-barsky-order-crossed"),
            Event::Order { crossed: false } => Message::new("liang-barsky-order-right"),
            Event::Reject => Message::new("liang-barsky-reject"),
            Event::Divide { border, end, t } => {
                about("liang-barsky-divide", border).with("bound", Value::text(bound(end))).with("t", t)
            }
            Event::Cut { border, end, to } => {
                about("liang-barsky-cut", border).with("end", Value::text(end.name())).with("to", to)
            }
            Event::Accept => Message::new("liang-barsky-accept").with("divisions", self.divisions()),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Measure { border, .. } => out.extend(self.measurement(border)),
            Event::Divide { border, t, .. } => out.push(self.division(border, t)),
            Event::Cut { border, end, to } => out.extend(self.cut(border, end, to)),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = Border::ALL.into_iter().map(|border| {
            let cells = match self.courses[border as usize] {
                Some(course) => {
                    let [p, q, t] = self.numbers(border);
                    vec![p, q, t, course.word()]
                }
                None => vec![Value::None, Value::None, Value::None, Value::None],
            };
            Row::new(border.name(), cells).active(self.now == Some(border))
        });
        out.push(Table {
            title: "liang-barsky-borders",
            columns: vec!["p", "q", "q / p", "column-liang-barsky-course"],
            rows: rows.collect(),
        });
        let rows = self.ordered().into_iter().map(|parameter| match parameter {
            Parameter::Of(end) => {
                let t: f32 = [0.0, 1.0][end as usize];
                let row = Row::new(["0", "1"][end as usize], vec![t.into(), Value::text(end.name())]);
                row.role(self.role(parameter))
            }
            Parameter::At(border) => {
                let [_, _, t] = self.numbers(border);
                let course = self.courses[border as usize].map_or(Value::None, Course::word);
                let row = Row::new(alpha(border), vec![t, course]).active(self.now == Some(border));
                row.role(self.role(parameter))
            }
        });
        out.push(Table {
            title: "liang-barsky-order",
            columns: vec!["t", "column-liang-barsky-course"],
            rows: rows.collect(),
        });
        let mut rows: Vec<Row> = End::ALL
            .into_iter()
            .map(|end| {
                let from = self.parameters[end as usize].border().map_or(["0", "1"][end as usize], alpha);
                let at = match (self.parameters[end as usize].border(), self.quotients[end as usize]) {
                    (None, _) => [0.0_f32, 1.0][end as usize].into(),
                    (Some(_), t) => t.into(),
                };
                Row::new(bound(end), vec![Value::text(from), at])
            })
            .collect();
        let count = vec![Value::BLANK, self.divisions().into()];
        rows.push(Row::new("row-liang-barsky-divisions", count));
        let columns = vec!["column-liang-barsky-from", "column-liang-barsky-value"];
        out.push(Table { title: "liang-barsky-part", columns, rows });
        if !self.subject.is_exact() {
            out.push(self.subject.comparison(self.right));
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        draw_window(&self.window.corners(), out);
        let active = self.now.filter(|_| self.subject.accepted.is_none());
        let course = active.filter(|_| event.is_some()).and_then(|border| self.courses[border as usize]);
        let note = active.zip(course).map(|(border, course)| {
            Message::new("liang-barsky-note")
                .with("name", Value::text(alpha(border)))
                .with("course", course.word())
        });
        draw_borders(&self.window, active, note, out);
        self.subject.draw_removed(out);
        self.subject.draw_rest(self.right, out);
        self.crossings(out);
        let now = match event {
            Some(Event::Cut { end, .. }) => Some(*end),
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
    /// What a parameter is to the visible part.
    fn role(&self, parameter: Parameter) -> Option<Role> {
        let role = if self.subject.accepted == Some(false) { Role::Rejected } else { Role::Accepted };
        self.parameters.contains(&parameter).then_some(role)
    }

    /// Where the line meets the borders seen so far, as far as that is in the picture.
    fn crossings(&self, out: &mut Vec<Mark>) {
        let View { min, max, .. } = self.view();
        for parameter in self.ordered() {
            let Parameter::At(border) = parameter else { continue };
            let at = crossing(self.subject.original, &self.window, border);
            let shown = (0..2).all(|axis| (min[axis]..=max[axis]).contains(&at[axis]));
            let replaced = End::ALL
                .into_iter()
                .any(|end| self.subject.has_moved(end) && self.parameters[end as usize] == parameter);
            if shown && !replaced {
                let course = self.courses[border as usize].map_or(Value::None, Course::word);
                let role = match self.now {
                    Some(now) if now == border && self.subject.accepted.is_none() => Role::Active,
                    _ => self.role(parameter).unwrap_or(Role::Candidate),
                };
                out.push(Mark::Point { at, role, label: Some(Label::new(alpha(border), course)) });
            }
        }
    }
}
