//! What the lab shows of the six back-face tests.

use super::{Degeneracy, Event, Input, Numbers, Outcome, Test, Why, formulas, picture};
use crate::{
    compare::Fact,
    cull::Facing,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, Vantage, View},
    message::{Message, Value},
    replay::State,
};

/// What is known of one test.
#[derive(Clone, Debug, PartialEq, Default)]
pub(super) struct Known {
    /// Its numbers, from the step on in which they are computed.
    pub(super) terms: bool,
    pub(super) value: Option<f64>,
    /// `Some(None)`: it has none.
    pub(super) answer: Option<Option<Facing>>,
    pub(super) why: Option<Why>,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) input: Input,
    /// What each test computes.
    pub(super) numbers: [Option<Numbers>; 6],
    pub(super) known: [Known; 6],
    pub(super) no_area: Option<Degeneracy>,
    pub(super) fate: Option<(Facing, bool)>,
    /// The test that the step is about.
    pub(super) now: Option<Test>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(input: Input) -> Self {
        let numbers = Test::ALL.map(|test| input.spaces.numbers(test, input.settings.arithmetic));
        Self { input, numbers, known: Default::default(), no_area: None, fate: None, now: None }
    }

    /// The result that the events so far amount to; none before the end.
    pub fn result(&self) -> Option<Outcome> {
        let (_, culled) = self.fate?;
        let of = |test: Test| &self.known[test as usize];
        Some(Outcome {
            answers: Test::ALL.map(|test| of(test).answer.flatten()),
            compared: Test::ALL.map(|test| of(test).why.unwrap_or(Why::NoAnswer)),
            culled,
        })
    }

    fn disagreeing(&self) -> usize {
        let differ = |known: &&Known| known.why.is_some_and(|why| why != Why::Same);
        self.known.iter().filter(differ).count()
    }
}

/// The id of the word for a facing.
fn facing_word(facing: Facing) -> &'static str {
    match facing {
        Facing::Front => "back-face-front",
        Facing::Back => "back-face-back",
        Facing::Degenerate => "back-face-neither",
    }
}

fn answer_word(answer: Option<Facing>) -> Value {
    Value::Word(answer.map_or("back-face-no-answer", facing_word))
}

impl Why {
    /// The id of a word for it.
    fn word(self) -> &'static str {
        match self {
            Self::Same => "back-face-why-same",
            Self::NoAnswer => "back-face-why-no-answer",
            Self::Mirrored => "back-face-why-mirrored",
            Self::BehindEye => "back-face-why-behind-eye",
            Self::EdgeOnRule => "back-face-why-edge-on-rule",
            Self::Rounded => "back-face-why-rounded",
        }
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.now = match *event {
            Event::Terms { test }
            | Event::Value { test, .. }
            | Event::NoValue { test }
            | Event::Answer { test, .. }
            | Event::Compare { test, .. } => Some(test),
            Event::NoArea { .. } => Some(Test::Determinant),
            Event::Fate { .. } => None,
        };
        match *event {
            Event::Terms { test } => self.known[test as usize].terms = true,
            Event::Value { test, value } => self.known[test as usize].value = Some(value),
            Event::NoValue { .. } => {}
            Event::Answer { test, facing } => self.known[test as usize].answer = Some(facing),
            Event::NoArea { why } => self.no_area = Some(why),
            Event::Compare { test, why } => self.known[test as usize].why = Some(why),
            Event::Fate { facing, culled } => self.fate = Some((facing, culled)),
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.numbers.iter().flatten().count() * 4 * size_of::<f64>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "back-face";

    const LISTING: &'static [&'static str] = &[
        "camera: n ← (p1 − p0) × (p2 − p0)",
        "  s ← (e − p0) · n",
        "object: e ← W⁻¹ e; n as before",
        "  s ← (e − p0) · n",
        "world: A, B, C, D ← plane of p0 p1 p2",
        "  s ← A ex + B ey + C ez + D",
        "NDC: s ← z of (p1 − p0) × (p2 − p0)",
        "screen: a, b, c ← xi yj − xj yi",
        "  s ← ± ½ (a + b + c), − if y is down",
        "clip: r ← rows (x, y, w); m ← r1 × r2",
        "  s ← r0 · m",
        "each: s > 0 front, s < 0 back, 0 rule",
        "det = 0: name the reason",
        "each: same as the determinant?",
        "cull by the determinant",
    ];

    fn line(event: &Event) -> usize {
        match *event {
            Event::Terms { test } => match test {
                Test::Camera => 0,
                Test::Object => 2,
                Test::Plane => 4,
                Test::Ndc => 6,
                Test::Screen => 7,
                Test::Determinant => 9,
            },
            Event::Value { test, .. } | Event::NoValue { test } => match test {
                Test::Camera => 1,
                Test::Object => 3,
                Test::Plane => 5,
                Test::Ndc => 6,
                Test::Screen => 8,
                Test::Determinant => 10,
            },
            Event::Answer { .. } => 11,
            Event::NoArea { .. } => 12,
            Event::Compare { .. } => 13,
            Event::Fate { .. } => 14,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Fate { .. } => Level::Primitive,
            Event::Answer { .. } | Event::Compare { .. } | Event::NoArea { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // The eye is taken to object space once for all triangles.
            Event::Terms { test: Test::Plane } => Operations::new(0, 9, 0),
            Event::Terms { .. } => Operations::new(0, 6, 0),
            Event::Value { test: Test::Ndc, .. } => Operations::new(0, 2, 0),
            Event::Value { test: Test::Screen, .. } => Operations::new(0, 1, 0),
            Event::Value { .. } => Operations::new(0, 3, 0),
            Event::Answer { .. } => Operations::new(1, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        match *event {
            // Where a test begins: the product in NDC has no terms, a test without a value neither.
            Event::Terms { test } | Event::Value { test: test @ Test::Ndc, .. } | Event::NoValue { test } => {
                Some(Marker { role: Role::Neutral, label: Some(short(test)) })
            }
            Event::Answer { facing, .. } => {
                let role = match facing {
                    Some(Facing::Front) => Role::Accepted,
                    Some(Facing::Back) => Role::Rejected,
                    Some(Facing::Degenerate) => Role::Tie,
                    None => Role::Skipped,
                };
                Some(Marker { role, label: None })
            }
            Event::Compare { why, .. } if why != Why::Same => {
                Some(Marker { role: Role::Changed, label: None })
            }
            Event::Fate { culled, .. } => {
                let (role, label) =
                    if culled { (Role::Rejected, "word-reject") } else { (Role::Accepted, "word-accept") };
                Some(Marker { role, label: Some(label) })
            }
            _ => None,
        }
    }

    fn opening(&self) -> Message {
        Message::new("back-face-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, test: Test| Message::new(id).with("test", Value::Word(test.word()));
        match *event {
            Event::Terms { test } => Message::new(match test {
                Test::Camera => "back-face-terms-camera",
                Test::Object => "back-face-terms-object",
                Test::Plane => "back-face-terms-plane",
                Test::Screen => "back-face-terms-screen",
                Test::Ndc | Test::Determinant => "back-face-terms-determinant",
            }),
            Event::Value { test, value } => about("back-face-value", test).with("value", value),
            Event::NoValue { test: test @ (Test::Ndc | Test::Screen) } => about("back-face-no-image", test),
            Event::NoValue { test } => about("back-face-no-eye", test),
            Event::Answer { test, facing } => {
                let known = &self.known[test as usize];
                let id = match (facing, known.value) {
                    (None, _) => "back-face-answer-none",
                    (Some(_), Some(0.0)) => "back-face-answer-zero",
                    (Some(_), Some(value)) if value > 0.0 => "back-face-answer-positive",
                    _ => "back-face-answer-negative",
                };
                about(id, test).with("answer", answer_word(facing))
            }
            Event::NoArea { why } => Message::new(match why {
                Degeneracy::Coincident => "back-face-no-area-coincident",
                Degeneracy::Collinear => "back-face-no-area-collinear",
                Degeneracy::Flattened => "back-face-no-area-flattened",
                Degeneracy::EdgeOn => "back-face-no-area-edge-on",
            }),
            Event::Compare { test, why } => about(
                match why {
                    Why::Same => "back-face-compare-same",
                    Why::NoAnswer => "back-face-compare-no-answer",
                    Why::Mirrored => "back-face-compare-mirrored",
                    Why::BehindEye => "back-face-compare-behind-eye",
                    Why::EdgeOnRule => "back-face-compare-edge-on-rule",
                    Why::Rounded => "back-face-compare-rounded",
                },
                test,
            )
            .with("answer", answer_word(self.known[test as usize].answer.flatten())),
            Event::Fate { facing, culled } => Message::new(match (facing, culled) {
                (Facing::Degenerate, _) => "back-face-fate-no-area",
                (_, true) => "back-face-fate-culled",
                (_, false) => "back-face-fate-kept",
            })
            .with("answer", Value::Word(facing_word(facing)))
            .with("disagreeing", self.disagreeing()),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Terms { test } => out.extend(formulas::terms(self, test)),
            Event::Value { test, value } => out.extend(formulas::value(self, test, value)),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = Test::ALL.map(|test| {
            let known = &self.known[test as usize];
            let cells = vec![
                known.value.into(),
                known.answer.map_or(Value::None, answer_word),
                known.why.map_or(Value::None, |why| Value::Word(why.word())),
            ];
            let differs = known.why.is_some_and(|why| why != Why::Same);
            let row = Row::new(row_name(test), cells).active(self.now == Some(test));
            row.role(differs.then_some(Role::Changed))
        });
        let columns = vec!["s", "column-back-face-answer", "column-back-face-against-determinant"];
        out.push(Table { title: "back-face-tests", columns, rows: rows.to_vec() });
        out.push(self.vertices(self.now.unwrap_or(Test::Determinant)));
        out.extend(self.object());
        out.push(self.conventions());
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::marks(self, out);
    }

    fn view(&self) -> View {
        View::SPACE
    }

    fn vantage(&self) -> Option<Vantage> {
        Some(picture::vantage(self))
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for (test, known) in Test::ALL.into_iter().zip(&self.known) {
            if let Some(answer) = known.answer {
                let values =
                    vec![("s", known.value.into()), ("column-back-face-answer", answer_word(answer))];
                out.push(Fact::named(row_name(test), values));
            }
        }
        out.extend(
            self.fate
                .map(|(_, culled)| Fact::answer(if culled { "back-face-culled" } else { "back-face-kept" })),
        );
    }
}

/// The id of a short name of a test, for the timeline.
fn short(test: Test) -> &'static str {
    match test {
        Test::Camera => "back-face-marker-camera",
        Test::Object => "back-face-marker-object",
        Test::Plane => "back-face-marker-plane",
        Test::Ndc => "back-face-marker-ndc",
        Test::Screen => "back-face-marker-screen",
        Test::Determinant => "back-face-marker-determinant",
    }
}

/// The id of a test's row.
fn row_name(test: Test) -> &'static str {
    match test {
        Test::Camera => "row-back-face-camera",
        Test::Object => "row-back-face-object",
        Test::Plane => "row-back-face-plane",
        Test::Ndc => "row-back-face-ndc",
        Test::Screen => "row-back-face-screen",
        Test::Determinant => "row-back-face-determinant",
    }
}

impl Snapshot {
    /// The vertices, and the eye, that a test looks at.
    fn vertices(&self, test: Test) -> Table {
        let spaces = &self.input.spaces;
        let of = |p: &[f32]| p.iter().copied().map(Value::F32).collect::<Vec<_>>();
        let (title, columns, cells) = match test {
            Test::Camera => ("back-face-vertices-camera", vec!["x", "y", "z"], spaces.camera.map(|p| of(&p))),
            Test::Object => ("back-face-vertices-object", vec!["x", "y", "z"], spaces.object.map(|p| of(&p))),
            Test::Plane => ("back-face-vertices-world", vec!["x", "y", "z"], spaces.world.map(|p| of(&p))),
            Test::Ndc => ("back-face-vertices-ndc", vec!["x", "y"], spaces.ndc.map(|p| of(&p))),
            Test::Screen => ("back-face-vertices-screen", vec!["x", "y"], spaces.screen.map(|p| of(&p))),
            Test::Determinant => (
                "back-face-vertices-clip",
                vec!["x", "y", "w"],
                spaces.clip.map(|[x, y, _, w]| of(&[x, y, w])),
            ),
        };
        let mut rows: Vec<Row> =
            ["p0", "p1", "p2"].into_iter().zip(cells).map(|(name, cells)| Row::new(name, cells)).collect();
        let (object, world, camera) = spaces.eyes;
        let eye = match test {
            Test::Camera => Some(camera),
            Test::Object => object,
            Test::Plane => Some(world),
            _ => None,
        };
        rows.extend(eye.map(|[x, y, z, _]| Row::new("e", of(&[x, y, z]))));
        Table { title, columns, rows }
    }

    /// How the triangles of the whole object stand to the eye, if it has several.
    fn object(&self) -> Option<Table> {
        let object = &self.input.object;
        let count = |facing: Facing| object.iter().filter(|(_, of)| *of == facing).count();
        let row = |name, facing| Row::new(name, vec![count(facing).into()]);
        (object.len() > 1).then(|| Table {
            title: "back-face-object",
            columns: vec!["column-back-face-triangles"],
            rows: vec![
                row("row-back-face-of-front", Facing::Front),
                row("row-back-face-of-back", Facing::Back),
                row("row-back-face-of-none", Facing::Degenerate),
            ],
        })
    }

    fn conventions(&self) -> Table {
        let settings = &self.input.settings;
        let [front, cull] = [settings.front.word(), settings.cull.word()];
        let row = |name, word| Row::new(name, vec![Value::Word(word)]);
        Table {
            title: "back-face-conventions",
            columns: vec!["column-back-face-setting"],
            rows: vec![row("row-back-face-front", front), row("row-back-face-cull", cull)],
        }
    }
}
