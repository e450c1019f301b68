//! What the lab shows of a Cyrus-Beck run.

use super::{Course, Edge, Event, Parameter, Quotient, Visible};
use crate::{
    clip::line::{
        ConvexWindow, End, Segment,
        parametric::point_at,
        subject::{Subject, draw_window, view},
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
    pub(super) window: ConvexWindow,
    pub(super) subject: Subject,
    /// In exact arithmetic.
    right: Option<Segment>,
    /// What the line does at each edge, and its t, once known.
    edges: Vec<(Option<Course>, Option<Quotient>)>,
    /// tE and tL, by the edge that they come from, and as numbers.
    parameters: [Parameter<Edge>; 2],
    pub(super) bounds: [f32; 2],
    /// The edge that the loop is at.
    now: Option<Edge>,
    divisions: usize,
}

/// tE or tL.
fn bound(end: End) -> &'static str {
    ["tE", "tL"][end as usize]
}

/// The name of an edge: e1, e2, ...
fn name(edge: Edge) -> String {
    format!("e{}", usize::from(edge) + 1)
}

impl Snapshot {
    /// Before the first event.
    pub fn new(segment: Segment, window: ConvexWindow, arithmetic: Arithmetic) -> Self {
        Self {
            subject: Subject::new(segment, arithmetic),
            right: super::clip(segment, &window),
            edges: vec![(None, None); window.edges().len()],
            window,
            parameters: End::ALL.map(Parameter::Of),
            bounds: [0.0, 1.0],
            now: None,
            divisions: 0,
        }
    }

    /// The result that the events so far amount to: the ends and their parameters.
    pub fn result(&self) -> Option<Visible> {
        self.subject.result().map(|segment| Visible { segment, t: self.bounds })
    }

    fn bound(&mut self, end: End, edge: Edge) {
        self.parameters[end as usize] = Parameter::At(edge);
        self.bounds[end as usize] = self.edges[usize::from(edge)].1.map_or(0.0, |t| t.0);
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Start | Event::Along { .. } => {}
            Event::Order { .. } => self.now = None,
            Event::Measure { edge, course } => {
                self.now = Some(edge);
                self.edges[usize::from(edge)].0 = Some(course);
            }
            Event::Divide { edge, t } => {
                self.divisions += 1;
                self.edges[usize::from(edge)].1 = Some(t);
            }
            Event::Enter { edge, later: true } => self.bound(End::P1, edge),
            Event::Leave { edge, earlier: true } => self.bound(End::P2, edge),
            Event::Enter { .. } | Event::Leave { .. } => {}
            Event::Reject => self.subject.accepted = Some(false),
            Event::Cut { edge, end, to } => {
                self.now = Some(edge);
                self.subject.move_end(end, to);
            }
            Event::Accept => (self.subject.accepted, self.now) = (Some(true), None),
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "cyrus-beck";

    const LISTING: &'static [&'static str] = &[
        "tE ← 0; tL ← 1",
        "for each edge: D·n, w·n",
        "  if D·n = 0: hopeless if w·n < 0",
        "  else t ← −(w·n) / (D·n)",
        "    if D·n > 0: tE ← max(tE, t)",
        "    if D·n < 0: tL ← min(tL, t)",
        "hopeless if tE > tL",
        "if hopeless: reject; stop",
        "move each end cut off to P1 + t D",
        "accept",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Start => 0,
            Event::Measure { .. } => 1,
            Event::Along { .. } => 2,
            Event::Divide { .. } => 3,
            Event::Enter { .. } => 4,
            Event::Leave { .. } => 5,
            Event::Order { .. } => 6,
            Event::Reject => 7,
            Event::Cut { .. } => 8,
            Event::Accept => 9,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Measure { .. } => Operations::new(1, 4, 0),
            Event::Along { .. } | Event::Enter { .. } | Event::Leave { .. } | Event::Order { .. } => {
                Operations::new(1, 0, 0)
            }
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
                    Course::Enters => "cyrus-beck-marker-enter",
                    Course::Leaves => "cyrus-beck-marker-leave",
                    Course::Parallel => "cyrus-beck-marker-parallel",
                }),
            ),
            Event::Enter { later: true, .. } | Event::Leave { earlier: true, .. } => (Role::Changed, None),
            Event::Cut { .. } => (Role::Changed, Some("cyrus-beck-marker-cut")),
            Event::Accept => (Role::Accepted, Some("word-accept")),
            Event::Reject => (Role::Rejected, Some("word-reject")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("cyrus-beck-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, edge| Message::new(id).with("edge", Value::text(name(edge)));
        let at = |end: End| Value::F32(self.bounds[end as usize]);
        match *event {
            Event::Start => Message::new("cyrus-beck-start"),
            Event::Measure { edge, course } => about(
                match course {
                    Course::Enters => "cyrus-beck-measure-enters",
                    Course::Leaves => "cyrus-beck-measure-leaves",
                    Course::Parallel => "cyrus-beck-measure-parallel",
                },
                edge,
            ),
            Event::Along { edge, outside: true } => about("cyrus-beck-along-outside", edge),
            Event::Along { edge, .. } => about("cyrus-beck-along-inside", edge),
            Event::Divide { edge, t } => about("cyrus-beck-divide", edge).with("t", t.0),
            Event::Enter { edge, later: true } => about("cyrus-beck-enter-later", edge),
            Event::Enter { edge, .. } => about("cyrus-beck-enter-earlier", edge).with("bound", at(End::P1)),
            Event::Leave { edge, earlier: true } => about("cyrus-beck-leave-earlier", edge),
            Event::Leave { edge, .. } => about("cyrus-beck-leave-later", edge).with("bound", at(End::P2)),
            Event::Order { crossed } => {
                let ids = ["cyrus-beck-order-right", "cyrus-beck-order-crossed"];
                Message::new(ids[usize::from(crossed)]).with("enter", at(End::P1)).with("leave", at(End::P2))
            }
            Event::Reject => Message::new("cyrus-beck-reject").with("divisions", self.divisions),
            Event::Cut { edge, end, to } => {
                about("cyrus-beck-cut", edge).with("end", Value::text(end.name())).with("to", to)
            }
            Event::Accept => Message::new("cyrus-beck-accept").with("divisions", self.divisions),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Measure { edge, .. } => out.extend(self.measurement(edge)),
            Event::Divide { edge, t } => out.push(self.division(edge, t.0)),
            Event::Cut { end, to, .. } => out.extend(self.cut(end, to)),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = (0..).zip(&self.edges).map(|(edge, (course, t))| {
            let [speed, distance, _] = match course {
                Some(_) => self.numbers(edge),
                None => [const { Value::None }; 3],
            };
            let there = course.map_or(Value::None, Course::word);
            let by = |end: End| self.parameters[end as usize] == Parameter::At(edge);
            let role = match self.subject.accepted {
                _ if !End::ALL.into_iter().any(by) => None,
                Some(false) => Some(Role::Rejected),
                _ => Some(Role::Accepted),
            };
            let row = Row::new(name(edge), vec![speed, distance, t.map(|t| t.0).into(), there]);
            row.active(self.now == Some(edge)).role(role)
        });
        out.push(Table {
            title: "cyrus-beck-edges",
            columns: vec!["D·n", "w·n", "t", "column-cyrus-beck-course"],
            rows: rows.collect(),
        });
        let mut rows: Vec<Row> = End::ALL
            .into_iter()
            .map(|end| {
                let from = match self.parameters[end as usize] {
                    Parameter::Of(end) => end.name().to_owned(),
                    Parameter::At(edge) => name(edge),
                };
                Row::new(bound(end), vec![Value::text(from), self.bounds[end as usize].into()])
            })
            .collect();
        rows.push(Row::new("row-clip-line-divisions", vec![Value::BLANK, self.divisions.into()]));
        let columns = vec!["column-cyrus-beck-from", "column-cyrus-beck-value"];
        out.push(Table { title: "cyrus-beck-part", columns, rows });
        if !self.subject.is_exact() {
            out.push(self.subject.comparison(self.right));
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        draw_window(self.window.corners(), out);
        self.draw_edges(out);
        self.subject.draw_removed(out);
        self.subject.draw_rest(self.right, out);
        self.draw_crossings(out);
        let now = match event {
            Some(Event::Cut { end, .. }) => Some(*end),
            _ => None,
        };
        self.subject.draw_ends(now, self.right, out);
    }

    fn view(&self) -> View {
        view(self.window.corners().iter().copied().chain(self.subject.original))
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        self.subject.facts(out);
    }
}

impl Snapshot {
    /// The names of the edges; the one at hand stands out, with the direction of its normal.
    fn draw_edges(&self, out: &mut Vec<Mark>) {
        for (edge, [a, b]) in (0..).zip(self.window.edges()) {
            let active = self.now == Some(edge) && self.subject.accepted.is_none();
            let label = Some(Label::name(name(edge)));
            let role = if active { Role::Active } else { Role::Neutral };
            out.push(Mark::Segment { ends: [*a, *b], role, label });
            if active {
                // As long as a third of the edge, inward.
                let middle = [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0);
                let [x, y] = [0, 1].map(|axis| b[axis] / 3.0 - a[axis] / 3.0);
                let tip = [middle[0] - y, middle[1] + x];
                out.push(Mark::Segment { ends: [middle, tip], role, label: None });
                out.push(Mark::Point { at: tip, role, label: Some(Label::name("n")) });
            }
        }
    }

    /// Where the line meets the edges divided so far, as far as that is in the picture and no end
    /// stands there.
    fn draw_crossings(&self, out: &mut Vec<Mark>) {
        let View { min, max, .. } = self.view();
        for (edge, (course, t)) in (0..).zip(&self.edges) {
            let (Some(course), Some(t)) = (course, t) else { continue };
            let at = point_at(self.subject.original, f64::from(t.0));
            let shown = (0..2).all(|axis| (min[axis]..=max[axis]).contains(&at[axis]));
            let bounding = |end: End| self.parameters[end as usize] == Parameter::At(edge);
            let replaced = |end: End| bounding(end) && self.subject.has_moved(end);
            if !shown || End::ALL.into_iter().any(replaced) {
                continue;
            }
            let role = match self.subject.accepted {
                None if self.now == Some(edge) => Role::Active,
                _ if !End::ALL.into_iter().any(bounding) => Role::Candidate,
                Some(false) => Role::Rejected,
                _ => Role::Accepted,
            };
            out.push(Mark::Point { at, role, label: Some(Label::new(name(edge), course.word())) });
        }
    }
}
