//! What the lab shows of cases under stress.

use std::sync::Arc;

use super::{CASES, Event, Outcome, Subject, Total, Verdict};
use crate::{
    compare::{Fact, Subject as Part, difference},
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, Vantage, View},
    labs::LabInput,
    math::Arithmetic,
    message::{Message, Value},
    replay::{Playback, State},
    stress::{
        dial,
        shrink::{numbers, with_number},
    },
};

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    subject: Arc<Subject>,
    /// The case in hand, from 0, and as it is now.
    index: usize,
    case: LabInput,
    /// The same before any number was made simpler.
    before: Option<LabInput>,
    /// The arithmetic that was judged last.
    judged: Option<Arithmetic>,
    totals: Vec<Total>,
    shrunk: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(subject: Arc<Subject>) -> Self {
        let total = |arithmetic| Total { arithmetic, broken: 0, wrong: 0, worst: 0 };
        let totals = subject.rounded().map(total).collect();
        let case = subject.case(0);
        Self { subject, index: 0, case, before: None, judged: None, totals, shrunk: false }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Outcome {
        Outcome { totals: self.totals.clone(), shrunk: self.shrunk.then(|| self.case.clone()) }
    }

    fn judge(&mut self, arithmetic: Arithmetic, verdict: Verdict) {
        self.judged = Some(arithmetic);
        if let Some(total) = self.totals.iter_mut().find(|total| total.arithmetic == arithmetic) {
            total.add(verdict);
        }
    }

    /// The run of the case in hand that is drawn: of the arithmetic in hand, else of the one that is chosen.
    fn drawn(&self, event: Option<&Event>) -> Option<Box<dyn Playback>> {
        let arithmetic = match event {
            Some(Event::Exact { .. }) => Arithmetic::Exact,
            Some(Event::Agrees { arithmetic, .. } | Event::Breaks { arithmetic, .. }) => *arithmetic,
            _ => self.subject.arithmetic,
        };
        self.subject.played(&self.case, arithmetic)
    }

    fn named(&self, message: Message) -> Message {
        message
            .with("operation", Value::Word(self.subject.operation.word()))
            .with("family", Value::Word(dial::word(self.subject.family)))
            .with("arithmetic", Value::text(self.subject.arithmetic.name()))
            .with("number", self.index + 1)
    }

    /// How many numbers are simpler than before.
    fn changed(&self) -> usize {
        let Some(before) = &self.before else { return 0 };
        let pairs = numbers(before).into_iter().zip(numbers(&self.case));
        pairs.filter(|((_, old), (_, new))| old.to_bits() != new.to_bits()).count()
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Case { index } | Event::Failing { index } => {
                self.index = index as usize;
                self.case = self.subject.case(self.index);
                self.before = matches!(event, Event::Failing { .. }).then(|| self.case.clone());
                self.judged = None;
            }
            Event::Exact { .. } | Event::Sound => {}
            Event::Agrees { arithmetic, ulps } => {
                self.judge(arithmetic, Verdict { wrong: 0, ulps: ulps.into() });
            }
            Event::Breaks { arithmetic, wrong, ulps } => {
                self.judge(arithmetic, Verdict { wrong: wrong.into(), ulps: ulps.into() });
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
        "  exact ← what the operation answers exactly",
        "  for each rounded arithmetic: decides alike?",
        "  else: count it, keep the worst error",
        "take the first case that breaks",
        "for each of its numbers, again and again:",
        "  a simpler one that breaks as well",
        "until no number can be simpler",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Case { .. } => 0,
            Event::Exact { .. } => 1,
            Event::Agrees { .. } => 2,
            Event::Breaks { .. } => 3,
            Event::Failing { .. } | Event::Sound => 4,
            Event::Simpler { number: 0, .. } => 5,
            Event::Simpler { .. } => 6,
            Event::Simplest => 7,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Exact { .. } | Event::Agrees { .. } | Event::Breaks { .. } => Level::Detail,
            Event::Case { .. } | Event::Simpler { .. } => Level::Row,
            Event::Failing { .. } | Event::Sound | Event::Simplest => Level::Primitive,
        }
    }

    /// What the lab of the operation costs, it says itself.
    fn operations(_: &Event) -> Operations {
        Operations::NONE
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Case { .. } => (Role::Neutral, None),
            Event::Breaks { .. } => (Role::Rejected, None),
            Event::Failing { .. } => (Role::Changed, Some("stress-marker-failing")),
            Event::Sound => (Role::Accepted, Some("stress-marker-sound")),
            Event::Simplest => (Role::Accepted, Some("stress-marker-simplest")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        self.named(Message::new("stress-opening"))
            .with("cases", CASES)
            .with("dial", u32::from(self.subject.dial))
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Case { .. } => self.named(Message::new("stress-case")),
            Event::Exact { parts } => Message::new("stress-exact").with("parts", parts),
            Event::Agrees { arithmetic, ulps } => Message::new("stress-agrees")
                .with("arithmetic", Value::text(arithmetic.name()))
                .with("ulps", ulps),
            Event::Breaks { arithmetic, wrong, ulps } => Message::new("stress-breaks")
                .with("arithmetic", Value::text(arithmetic.name()))
                .with("wrong", wrong)
                .with("ulps", ulps),
            Event::Failing { .. } => self.named(Message::new("stress-failing")),
            Event::Sound => self.named(Message::new("stress-no-case")),
            Event::Simpler { number, to } => {
                let name = numbers(&self.case).into_iter().nth(number.into()).map(|(name, _)| name);
                self.named(Message::new("stress-simpler"))
                    .with("name", Value::Text(name.unwrap_or_default()))
                    .with("to", to)
            }
            Event::Simplest => self
                .named(Message::new("stress-simplest"))
                .with("changed", self.changed())
                .with("all", numbers(&self.case).len()),
        }
    }

    fn formulas(&self, _: &Event, _: &mut Vec<Formula>) {}

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = self.totals.iter().map(|total| {
            let cells = vec![
                Value::count(total.broken),
                Value::Int(total.wrong as i64),
                Value::Int(i64::try_from(total.worst).unwrap_or(i64::MAX)),
            ];
            let breaks = (total.broken > 0).then_some(Role::Rejected);
            Row::new(total.arithmetic.name(), cells)
                .role(breaks)
                .active(self.judged == Some(total.arithmetic))
        });
        out.push(Table {
            title: "stress-totals",
            columns: vec!["column-stress-broken", "column-stress-wrong", "column-stress-worst"],
            rows: rows.collect(),
        });
        let before = self.before.as_ref().map(numbers).unwrap_or_default();
        let rows = numbers(&self.case).into_iter().enumerate().map(|(i, (name, now))| {
            let old = before.get(i).map(|(_, old)| *old);
            let simpler = old.is_some_and(|old| old.to_bits() != now.to_bits());
            let cells = vec![old.map_or(Value::None, Value::F32), Value::F32(now)];
            Row::new(name, cells).role(simpler.then_some(Role::Changed))
        });
        out.push(Table {
            title: "stress-numbers",
            columns: vec!["column-stress-before", "column-stress-now"],
            rows: rows.collect(),
        });
    }

    /// What the operation's own lab draws, with what is decided otherwise outlined.
    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let Some(run) = self.drawn(event) else { return };
        out.extend(run.marks());
        if matches!(event, Some(Event::Exact { .. })) {
            return;
        }
        let (facts, exact) =
            (crate::compare::sorted(run.facts()), self.subject.answer(&self.case, Arithmetic::Exact));
        for part in difference(&facts, &exact).parts() {
            let Some(fact) = part.either().filter(|_| !part.agrees()) else { continue };
            match (&fact.subject, fact.at) {
                (Part::Pixel(at), _) => out.push(Mark::Pixel {
                    at: at.map(|c| c as i32),
                    role: Role::Changed,
                    object: None,
                    value: Value::None,
                }),
                (_, Some(at)) => out.push(Mark::Point { at, role: Role::Changed, label: None }),
                _ => {}
            }
        }
    }

    fn view(&self) -> View {
        self.drawn(None).map_or(View::SPACE, |run| run.view())
    }

    fn vantage(&self) -> Option<Vantage> {
        self.drawn(None)?.vantage()
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        out.extend(self.totals.iter().map(|total| {
            let values = vec![
                ("column-stress-broken", Value::count(total.broken)),
                ("column-stress-wrong", Value::Int(total.wrong as i64)),
                ("column-stress-worst", Value::Int(i64::try_from(total.worst).unwrap_or(i64::MAX))),
            ];
            Fact::named(total.arithmetic.name(), values)
        }));
    }
}
