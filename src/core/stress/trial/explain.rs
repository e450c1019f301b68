//! What the lab says of cases under stress: sentences, tables, the timeline.

use std::sync::Arc;

use super::{CASES, Event, Outcome, Subject, Total};
use crate::{
    compare::{Fact, Subject as Part},
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, Vantage, View},
    labs::LabInput,
    math::Arithmetic,
    message::{Message, Value},
    replay::State,
    stress::{
        dial::{self, Operation},
        judge::{Deviation, TOLERATED, Verdict, right_bits},
        shrink::{numbers, with_number},
    },
};

/// Most parts of a case that are listed.
const MOST_ROWS: usize = 8;

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) subject: Arc<Subject>,
    /// The case in hand, from 0, and as it is now.
    index: usize,
    pub(super) case: LabInput,
    /// The same before any number was made simpler.
    pub(super) before: Option<LabInput>,
    /// What is drawn.
    pub(super) drawn: Arithmetic,
    /// What came of each arithmetic in the case in hand, as far as it is judged.
    verdicts: Vec<(Arithmetic, Verdict)>,
    totals: Vec<Total>,
    /// What came of the arithmetic that is drawn in each case so far.
    judged: Vec<Verdict>,
    shrunk: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(subject: Arc<Subject>) -> Self {
        let totals = subject.rounded().map(Total::new).collect();
        let (case, drawn) = (subject.case(0), Arithmetic::Exact);
        let (verdicts, judged) = (Vec::new(), Vec::new());
        Self { subject, index: 0, case, before: None, drawn, verdicts, totals, judged, shrunk: false }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Outcome {
        Outcome { totals: self.totals.clone(), shrunk: self.shrunk.then(|| self.case.clone()) }
    }

    /// Every part of the case in which the arithmetic that is drawn differs from the exact one.
    pub(super) fn deviations(&self) -> Vec<Deviation> {
        if self.drawn == Arithmetic::Exact {
            return Vec::new();
        }
        self.subject.deviations(&self.case, self.drawn)
    }

    /// What came of each arithmetic in the case in hand; one that is made small is judged anew.
    fn verdicts(&self) -> Vec<(Arithmetic, Verdict)> {
        if self.before.is_none() {
            return self.verdicts.clone();
        }
        let anew = |arithmetic| (arithmetic, self.subject.verdict(&self.case, arithmetic));
        self.subject.rounded().map(anew).collect()
    }

    fn named(&self, id: &'static str) -> Message {
        Message::new(id)
            .with("operation", Value::Word(self.subject.operation.word()))
            .with("family", Value::Word(dial::word(self.subject.family)))
            .with("arithmetic", Value::text(self.subject.arithmetic.name()))
            .with("number", self.index + 1)
    }

    /// What came of the arithmetic that is drawn in the case in hand; exact never differs.
    fn drawn_verdict(&self) -> Verdict {
        let drawn = self.verdicts.iter().find(|(each, _)| *each == self.subject.arithmetic);
        drawn.map_or_else(Verdict::default, |(_, verdict)| *verdict)
    }

    /// How many numbers are simpler than before.
    fn changed(&self) -> usize {
        let Some(before) = &self.before else { return 0 };
        let pairs = numbers(before).into_iter().zip(numbers(&self.case));
        pairs.filter(|((_, old), (_, new))| old.to_bits() != new.to_bits()).count()
    }

    /// Each arithmetic in the case in hand, and each part that the one that is drawn gets wrong.
    fn tables_of_case(&self, out: &mut Vec<Table>) {
        let operation = self.subject.operation;
        let rows = self.verdicts().into_iter().map(|(arithmetic, verdict)| {
            Row::new(arithmetic.name(), errors(operation, verdict.wrong, verdict.ulps))
                .role(if verdict.breaks() { Role::Rejected } else { Role::Accepted })
                .active(self.drawn == arithmetic)
        });
        out.push(Table {
            title: "stress-case-table",
            columns: columns(operation).to_vec(),
            rows: rows.collect(),
        });
        let deviations = self.deviations();
        if deviations.is_empty() {
            return;
        }
        let mut rows: Vec<_> = deviations.iter().take(MOST_ROWS).flat_map(rows_of).collect();
        let mut columns = vec!["column-stress-here", "column-exact", "ULP"];
        if operation == Operation::Coverage {
            columns.pop();
            rows.iter_mut().for_each(|row| row.cells.truncate(columns.len()));
        }
        out.push(Table { title: "stress-parts", columns, rows });
    }

    /// What the numbers of the case are, and what they were.
    fn table_of_numbers(&self) -> Table {
        let before = self.before.as_ref().map(numbers).unwrap_or_default();
        let rows = numbers(&self.case).into_iter().enumerate().map(|(i, (name, now))| {
            let old = before.get(i).map(|(_, old)| *old);
            let simpler = old.is_some_and(|old| old.to_bits() != now.to_bits());
            let old = old.filter(|_| simpler).map_or(Value::BLANK, digits);
            Row::new(name, vec![old, digits(now)]).role(simpler.then_some(Role::Changed))
        });
        Table {
            title: "stress-numbers",
            columns: vec!["column-stress-before", "column-stress-now"],
            rows: rows.collect(),
        }
    }
}

/// How much is wrong; of an operation with numbers also how far the worst is off, and how many of its bits are right.
fn errors(operation: Operation, wrong: u32, ulps: u32) -> Vec<Value> {
    let all = [wrong.into(), ulps.into(), right_bits(ulps).into()];
    all[..columns(operation).len()].to_vec()
}

const ERRORS: [&str; 3] = ["column-stress-wrong", "column-stress-ulps", "column-stress-bits"];

/// Pixels have no numbers.
fn columns(operation: Operation) -> &'static [&'static str] {
    if operation == Operation::Coverage { &ERRORS[..1] } else { &ERRORS }
}

/// As many digits as tell a number from its neighbours.
fn digits(x: f32) -> Value {
    let plain = x == 0.0 || (1e-4..1e7).contains(&x.abs());
    let text = if plain { format!("{x}") } else { format!("{x:e}") };
    Value::Text(text.replace('-', "−"))
}

/// A part on both sides: each number that differs, or that only one side has it.
fn rows_of(deviation: &Deviation) -> Vec<Row> {
    let Some(fact) = deviation.either() else { return Vec::new() };
    let name = match &fact.subject {
        Part::Answer => "row-stress-answer".to_owned(),
        Part::Named(name) => name.clone().into_owned(),
        Part::Corner => "row-stress-corner".to_owned(),
        Part::Pixel([x, y]) => format!("({x}, {y})"),
    };
    let role = if deviation.breaks() { Role::Rejected } else { Role::Changed };
    let sides = [&deviation.rounded, &deviation.exact];
    let row = |cells: Vec<Value>, name: String| Row::new(name, cells).role(role);
    let (Some(rounded), Some(exact)) = (&deviation.rounded, &deviation.exact) else {
        let there = sides.map(|side| match side {
            Some(Fact { at: Some(at), .. }) => (*at).into(),
            Some(_) => Value::Word("stress-there"),
            None => Value::Word("stress-missing"),
        });
        let [here, exact] = there;
        return vec![row(vec![here, exact, Value::BLANK], name)];
    };
    let pairs =
        rounded.values.iter().zip(&exact.values).filter(|((_, a), (_, b))| !crate::compare::equal(a, b));
    let ulps = deviation.ulps.map_or(Value::BLANK, Value::from);
    let rows = pairs.map(|((value, a), (_, b))| {
        let name = if exact.values.len() == 1 { name.clone() } else { format!("{name} {value}") };
        let [here, exact] = [a, b].map(|value| match *value {
            Value::F32(x) => digits(x),
            _ => value.clone(),
        });
        row(vec![here, exact, ulps.clone()], name)
    });
    rows.collect()
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Case { index } => {
                self.index = index as usize;
                self.case = self.subject.case(self.index);
                self.verdicts.clear();
                self.drawn = Arithmetic::Exact;
            }
            Event::Exact { .. } | Event::Sound => {}
            Event::Judged { arithmetic, verdict } => {
                self.drawn = arithmetic;
                self.verdicts.push((arithmetic, verdict));
                if let Some(total) = self.totals.iter_mut().find(|total| total.arithmetic == arithmetic) {
                    total.add(verdict);
                }
            }
            Event::Done { .. } => {
                self.drawn = self.subject.arithmetic;
                self.judged.push(self.drawn_verdict());
            }
            Event::Failing { index } => {
                self.index = index as usize;
                self.case = self.subject.case(self.index);
                self.before = Some(self.case.clone());
                self.drawn = self.subject.arithmetic;
            }
            Event::Simpler { number, to } => {
                if let Some(case) = with_number(&self.case, number.into(), to) {
                    self.case = case;
                }
            }
            Event::Simplest => self.shrunk = true,
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "stress";

    const LISTING: &'static [&'static str] = &[
        "for each case of the family",
        "  exact ← the operation, exactly",
        "  each rounded arithmetic: what differs?",
        "  a wrong part, or a number far off:",
        "    the arithmetic breaks",
        "take the first case that breaks",
        "for each of its numbers, over and over",
        "  a simpler one, if it breaks as well",
        "until no number can be simpler",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Case { .. } => 0,
            Event::Exact { .. } => 1,
            Event::Judged { .. } => 2,
            Event::Done { broken: false, .. } => 3,
            Event::Done { broken: true, .. } => 4,
            Event::Failing { .. } | Event::Sound => 5,
            Event::Simpler { number: 0, .. } => 6,
            Event::Simpler { .. } => 7,
            Event::Simplest => 8,
        }
    }

    /// A primitive is a case, a row an arithmetic: so two runs go from case to case together, whichever of them break.
    fn level(event: &Event) -> Level {
        match event {
            Event::Case { .. } | Event::Exact { .. } => Level::Detail,
            Event::Judged { .. } | Event::Simpler { .. } => Level::Row,
            Event::Done { .. } | Event::Failing { .. } | Event::Sound | Event::Simplest => Level::Primitive,
        }
    }

    /// What the lab of the operation costs, it says itself.
    fn operations(_: &Event) -> Operations {
        Operations::NONE
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Done { broken: false, .. } => (Role::Neutral, None),
            Event::Done { broken: true, .. } => (Role::Rejected, None),
            Event::Failing { .. } => (Role::Changed, Some("stress-marker-failing")),
            Event::Sound => (Role::Accepted, Some("stress-marker-sound")),
            Event::Simplest => (Role::Accepted, Some("stress-marker-simplest")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        self.named("stress-opening").with("cases", CASES).with("dial", u32::from(self.subject.dial))
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Case { .. } => self.named("stress-case"),
            Event::Exact { parts } => Message::new("stress-exact").with("parts", parts),
            Event::Judged { arithmetic, verdict } => {
                let id = match verdict {
                    Verdict { wrong: 0, ulps: 0 } => "stress-same",
                    Verdict { wrong: 0, ulps: ..=TOLERATED } => "stress-close",
                    Verdict { wrong: 0, .. } => "stress-far",
                    Verdict { ulps: 0, .. } => "stress-otherwise",
                    _ => "stress-otherwise-and-off",
                };
                counted(Message::new(id).with("arithmetic", Value::text(arithmetic.name())), verdict)
            }
            Event::Done { .. } => {
                let verdict = self.drawn_verdict();
                let id = match verdict {
                    Verdict { wrong: 0, ulps: 0 } => "stress-done-same",
                    Verdict { wrong: 0, ulps: ..=TOLERATED } => "stress-done-close",
                    Verdict { wrong: 0, .. } => "stress-done-far",
                    Verdict { ulps: 0, .. } => "stress-done-otherwise",
                    _ => "stress-done-otherwise-and-off",
                };
                counted(self.named(id), verdict)
            }
            Event::Failing { .. } => self.named("stress-failing"),
            Event::Sound => self.named("stress-no-case"),
            Event::Simpler { number, to } => {
                let name = numbers(&self.case).into_iter().nth(number.into()).map(|(name, _)| name);
                self.named("stress-simpler")
                    .with("name", Value::Text(name.unwrap_or_default()))
                    .with("to", digits(to))
            }
            Event::Simplest => self
                .named("stress-simplest")
                .with("changed", self.changed())
                .with("all", numbers(&self.case).len()),
        }
    }

    fn formulas(&self, _: &Event, _: &mut Vec<Formula>) {}

    fn tables(&self, out: &mut Vec<Table>) {
        self.tables_of_case(out);
        let rows = self.totals.iter().map(|total| {
            let breaks = if total.broken > 0 { Role::Rejected } else { Role::Accepted };
            let mut cells = vec![Value::count(total.broken)];
            cells.extend(errors(self.subject.operation, total.wrong, total.worst));
            Row::new(total.arithmetic.name(), cells).role(breaks)
        });
        out.push(Table {
            title: "stress-totals",
            columns: [&["column-stress-broken"], columns(self.subject.operation)].concat(),
            rows: rows.collect(),
        });
        out.push(self.table_of_numbers());
    }

    fn marks(&self, _: Option<&Event>, out: &mut Vec<Mark>) {
        self.picture(out);
    }

    fn view(&self) -> View {
        self.frame()
    }

    fn vantage(&self) -> Option<Vantage> {
        self.subject.played(&self.case, self.drawn)?.vantage()
    }

    /// Each case, as the arithmetic that is drawn answers it. How far it is off is a text: it is not added up, nor held
    /// against another as a number of binary32.
    fn facts(&self, out: &mut Vec<Fact>) {
        out.extend(self.judged.iter().enumerate().map(|(index, verdict)| {
            let values = vec![
                ("column-stress-broken", Value::Int(verdict.breaks().into())),
                ("column-stress-wrong", verdict.wrong.into()),
                ("column-stress-ulps", Value::text(verdict.ulps)),
            ];
            Fact::named(format!("#{:02}", index + 1), values)
        }));
    }
}

/// A message with the numbers of a verdict.
fn counted(message: Message, verdict: Verdict) -> Message {
    message.with("wrong", verdict.wrong).with("ulps", verdict.ulps).with("bits", right_bits(verdict.ulps))
}
