//! What the lab shows of objects against the frustum.

use super::{
    super::planes::{PlaneMask, Reach, Side},
    Event, Input, Verdict, picture,
};
use crate::{
    clip::polygon::Plane,
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Row, Table, Vantage, View},
    message::{Message, Value},
    replay::State,
};

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) input: Input,
    verdicts: Vec<Option<Verdict>>,
    /// The object that the step is about, and the planes of it known so far.
    pub(super) now: Option<usize>,
    sides: Vec<(Plane, Side)>,
    pub(super) triangle: Option<(usize, usize)>,
    plane_tests: usize,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(input: Input) -> Self {
        let verdicts = vec![None; input.objects.len()];
        Self { input, verdicts, now: None, sides: Vec::new(), triangle: None, plane_tests: 0 }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Vec<Verdict> {
        self.verdicts.iter().flatten().cloned().collect()
    }

    /// What an object is in the picture.
    pub(super) fn role(&self, object: usize) -> Role {
        match &self.verdicts[object] {
            None => Role::Candidate,
            Some(Verdict::Outside(_)) => Role::Rejected,
            Some(Verdict::Inside) => Role::Accepted,
            Some(Verdict::Crosses(_)) => Role::Tie,
        }
    }

    /// Whether a triangle is known to be outside.
    pub(super) fn lost(&self, object: usize, triangle: usize) -> bool {
        match &self.verdicts[object] {
            Some(Verdict::Outside(_)) => true,
            Some(Verdict::Crosses(outside)) => outside.get(triangle).is_some_and(Option::is_some),
            _ => false,
        }
    }

    fn triangles(&self, object: u32) -> usize {
        self.input.objects[object as usize].clip.len()
    }

    /// How many objects have such a verdict.
    fn count(&self, wanted: fn(&Verdict) -> bool) -> usize {
        self.verdicts.iter().flatten().filter(|verdict| wanted(verdict)).count()
    }

    /// Triangles that were not tested, and triangles that were.
    fn tested(&self) -> [usize; 2] {
        let mut counts = [0, 0];
        for (verdict, object) in self.verdicts.iter().zip(self.input.objects.iter()) {
            match verdict {
                Some(Verdict::Crosses(outside)) => counts[1] += outside.len(),
                Some(_) => counts[0] += object.clip.len(),
                None => {}
            }
        }
        counts
    }
}

fn side_word(side: Side) -> &'static str {
    match side {
        Side::Outside => "frustum-culling-outside",
        Side::Inside => "frustum-culling-inside",
        Side::Crosses => "frustum-culling-crosses",
    }
}

/// A body outside, inside or across a plane, and the role that it wears.
fn side_role(side: Side) -> Role {
    match side {
        Side::Outside => Role::Rejected,
        Side::Inside => Role::Accepted,
        Side::Crosses => Role::Tie,
    }
}

/// The two ends of a body over a plane: what lies outside has both negative.
pub(in crate::cull) fn reach_formulas(reach: Reach) -> [Formula; 2] {
    let Reach { distance, spread, .. } = reach;
    let numbers = |sign: &'static str, value: f64| {
        vec![
            Piece::Text("= "),
            Piece::Number(distance.into()),
            Piece::Text(sign),
            Piece::Number(spread.into()),
            Piece::Text(" = "),
            Piece::Result(value.into()),
        ]
    };
    [
        Formula { general: "farthest inside: d + r", numbers: numbers(" + ", distance + spread) },
        Formula { general: "farthest outside: d − r", numbers: numbers(" − ", distance - spread) },
    ]
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.triangle = None;
        match *event {
            Event::Object { object } => {
                self.now = Some(object as usize);
                self.sides.clear();
            }
            Event::Plane { plane, side, .. } => {
                self.sides.push((plane, side));
                self.plane_tests += 1;
            }
            Event::Reject { object, plane } => {
                self.verdicts[object as usize] = Some(Verdict::Outside(plane));
            }
            Event::Accept { object } => self.verdicts[object as usize] = Some(Verdict::Inside),
            Event::Cross { object } => self.verdicts[object as usize] = Some(Verdict::Crosses(Vec::new())),
            Event::Triangle { object, triangle, outside } => {
                self.triangle = Some((object as usize, triangle as usize));
                if let Some(Verdict::Crosses(known)) = &mut self.verdicts[object as usize] {
                    known.push(outside);
                }
            }
            Event::Done => self.now = None,
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.verdicts.len() * size_of::<Option<Verdict>>() + self.tested()[1]
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "frustum-culling";

    const LISTING: &'static [&'static str] = &[
        "for each object: its sphere or box",
        "  each plane: d ← n · m + D, reach r",
        "    d − r ≥ 0: inside this plane",
        "    d + r < 0: outside this plane",
        "  outside one plane: reject the object",
        "  inside all planes: accept the object",
        "  else test its triangles one by one:",
        "    all vertices outside one plane?",
        "no object is left: stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Object { .. } => 0,
            Event::Plane { side: Side::Crosses, .. } => 1,
            Event::Plane { side: Side::Inside, .. } => 2,
            Event::Plane { side: Side::Outside, .. } => 3,
            Event::Reject { .. } => 4,
            Event::Accept { .. } => 5,
            Event::Cross { .. } => 6,
            Event::Triangle { .. } => 7,
            Event::Done => 8,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::Reject { .. } | Event::Accept { .. } | Event::Cross { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // n . m, and |n| . h: of a sphere |n| is kept with the plane.
            Event::Plane { side, .. } => Operations::new(1 + u64::from(*side != Side::Outside), 6, 0),
            Event::Triangle { outside, .. } => {
                // Up to the plane that rejects it, at most three comparisons a plane.
                let planes = outside.map_or(6, |plane| plane as u64 + 1);
                Operations::new(3 * planes, 0, 0)
            }
            _ => Operations::NONE,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let role = match event {
            Event::Reject { .. } => Role::Rejected,
            Event::Accept { .. } => Role::Accepted,
            Event::Cross { .. } => Role::Tie,
            _ => return None,
        };
        Some(Marker { role, label: None })
    }

    fn opening(&self) -> Message {
        Message::new("frustum-culling-opening")
            .with("count", self.input.objects.len())
            .with("body", Value::Word(self.input.body.word()))
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, object: u32| {
            let name = Value::text(&self.input.objects[object as usize].name);
            let body = Value::Word(self.input.body.word());
            Message::new(id).with("object", name).with("body", body).with("count", self.triangles(object))
        };
        let plane_word = |plane: Plane| Value::Word(plane.word());
        match *event {
            Event::Object { object } => about("frustum-culling-object", object),
            Event::Plane { object, plane, side } => about(
                match side {
                    Side::Outside => "frustum-culling-plane-outside",
                    Side::Inside => "frustum-culling-plane-inside",
                    Side::Crosses => "frustum-culling-plane-crosses",
                },
                object,
            )
            .with("plane", plane_word(plane)),
            Event::Reject { object, plane } => {
                about("frustum-culling-reject", object).with("plane", plane_word(plane))
            }
            Event::Accept { object } => about("frustum-culling-accept", object),
            Event::Cross { object } => about("frustum-culling-cross", object),
            Event::Triangle { object, triangle, outside: Some(plane) } => {
                about("frustum-culling-triangle-outside", object)
                    .with("triangle", triangle + 1)
                    .with("plane", plane_word(plane))
            }
            Event::Triangle { object, triangle, outside: None } => {
                about("frustum-culling-triangle-kept", object).with("triangle", triangle + 1)
            }
            Event::Done => {
                let [saved, tested] = self.tested();
                Message::new("frustum-culling-done")
                    .with("outside", self.count(|verdict| matches!(verdict, Verdict::Outside(_))))
                    .with("inside", self.count(|verdict| matches!(verdict, Verdict::Inside)))
                    .with("crossing", self.count(|verdict| matches!(verdict, Verdict::Crosses(_))))
                    .with("tests", self.plane_tests)
                    .with("saved", saved)
                    .with("tested", tested)
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        if let Event::Plane { object, plane, .. } = *event {
            let object = &self.input.objects[object as usize];
            out.extend(reach_formulas(object.frustum.reach(plane, &object.volume)));
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let rows = self.input.objects.iter().zip(&self.verdicts).enumerate().map(|(i, (object, verdict))| {
            let (word, lost) = match verdict {
                None => (Value::None, Value::None),
                Some(Verdict::Outside(plane)) => (Value::Word(plane.word()), object.clip.len().into()),
                Some(Verdict::Inside) => (Value::Word("frustum-culling-inside"), 0.into()),
                Some(Verdict::Crosses(outside)) => {
                    let lost = outside.iter().flatten().count();
                    (Value::Word("frustum-culling-crosses"), lost.into())
                }
            };
            let role = verdict.as_ref().map(|_| self.role(i));
            let cells = vec![object.clip.len().into(), word, lost];
            Row::new(object.name.clone(), cells).active(self.now == Some(i)).role(role)
        });
        out.push(Table {
            title: "frustum-culling-objects",
            columns: vec![
                "column-frustum-culling-triangles",
                "column-frustum-culling-is",
                "column-frustum-culling-lost",
            ],
            rows: rows.collect(),
        });
        out.extend(self.planes());
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::marks(self, event, out);
    }

    fn view(&self) -> View {
        View::SPACE
    }

    fn vantage(&self) -> Option<Vantage> {
        Some(picture::vantage(self))
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for (i, (object, verdict)) in self.input.objects.iter().zip(&self.verdicts).enumerate() {
            let Some(verdict) = verdict else { continue };
            let word = match verdict {
                Verdict::Outside(_) => Value::Word("frustum-culling-outside"),
                Verdict::Inside => Value::Word("frustum-culling-inside"),
                Verdict::Crosses(_) => Value::Word("frustum-culling-crosses"),
            };
            let lost = (0..object.clip.len()).filter(|&triangle| self.lost(i, triangle)).count();
            let values =
                vec![("column-frustum-culling-is", word), ("column-frustum-culling-lost", lost.into())];
            out.push(Fact::named(object.name.clone(), values));
        }
    }
}

impl Snapshot {
    /// The object of this step against the planes tested so far.
    fn planes(&self) -> Option<Table> {
        let object = &self.input.objects[self.now?];
        let last = self.sides.last().map(|(plane, _)| *plane);
        let rows = PlaneMask::ALL.planes().map(|plane| {
            let side = self.sides.iter().find(|(of, _)| *of == plane).map(|(_, side)| *side);
            let cells = match side {
                None => vec![Value::None, Value::None, Value::None],
                Some(side) => {
                    let Reach { distance, spread, .. } = object.frustum.reach(plane, &object.volume);
                    vec![distance.into(), spread.into(), Value::Word(side_word(side))]
                }
            };
            let row = Row::new(row_name(plane), cells).active(last == Some(plane));
            row.role(side.map(side_role))
        });
        let columns = vec!["d", "r", "column-frustum-culling-is"];
        Some(Table { title: "frustum-culling-planes", columns, rows: rows.collect() })
    }
}

/// The id of a plane's row.
fn row_name(plane: Plane) -> &'static str {
    match plane {
        Plane::Left => "row-frustum-culling-left",
        Plane::Right => "row-frustum-culling-right",
        Plane::Bottom => "row-frustum-culling-bottom",
        Plane::Top => "row-frustum-culling-top",
        Plane::Near => "row-frustum-culling-near",
        Plane::Far => "row-frustum-culling-far",
    }
}
