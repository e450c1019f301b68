//! Six back-face tests side by side, for one triangle on its way to the screen.
//!
//! Each is exact for the binary32 values of its own space, or rounds as taught. Where all w are positive,
//! the model is not mirrored and nothing was rounded on the way, all six agree; where they do not, the
//! reason is named.
//!
//! *Source:* the files of the six tests; Akenine-Möller et al., Real-Time Rendering, 4th ed. 2018, section
//! 19.3. Deviation: the edge-on triangle, about which the sources disagree, is a setting.

mod explain;
mod formulas;
mod input;
mod picture;

pub use explain::Snapshot;
pub use input::{Input, Numbers, Spaces, Test};

use super::{
    CullMode, Facing, FrontFace,
    degenerate::{Degeneracy, degeneracy},
    facing,
};
use crate::{
    math::{Arithmetic, Sign, Tally},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::{Deserialize, Serialize};

/// What a triangle is whose value is exactly zero: the lectures disagree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum EdgeOn {
    /// Neither: it covers nothing. What the pipeline does.
    #[default]
    Neither,
    /// Its back is seen, as in `(e - p0) . n <= 0`.
    Back,
    /// Its front is seen, as where only `Ax + By + Cz + D < 0` is a back.
    Front,
    /// As each test is usually printed: `<= 0` with a normal, `< 0` with the plane and with z; the area
    /// and the determinant leave it open.
    AsTaught,
}

impl EdgeOn {
    /// Every setting, the default first.
    pub const ALL: [Self; 4] = [Self::Neither, Self::Back, Self::Front, Self::AsTaught];

    /// The id of the words for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Neither => "back-face-rule-neither",
            Self::Back => "back-face-rule-back",
            Self::Front => "back-face-rule-front",
            Self::AsTaught => "back-face-rule-as-taught",
        }
    }

    /// What a test makes of the value zero.
    fn facing(self, test: Test) -> Facing {
        match (self, test) {
            (Self::Back, _) | (Self::AsTaught, Test::Camera | Test::Object) => Facing::Back,
            (Self::Front, _) | (Self::AsTaught, Test::Plane | Test::Ndc) => Facing::Front,
            (Self::Neither | Self::AsTaught, _) => Facing::Degenerate,
        }
    }
}

/// The conventions of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// Which turning sense is the front.
    pub front: FrontFace,
    /// Which facing is thrown away.
    pub cull: CullMode,
    /// What the value zero means.
    pub edge_on: EdgeOn,
    /// How the tests compute. Fixed point is exact here.
    pub arithmetic: Arithmetic,
}

impl Settings {
    /// What a test says of a value with this sign.
    pub fn facing(&self, test: Test, sign: Sign) -> Facing {
        match (sign, self.front) {
            (Sign::Zero, _) => self.edge_on.facing(test),
            (Sign::Positive, FrontFace::Ccw) | (Sign::Negative, FrontFace::Cw) => Facing::Front,
            _ => Facing::Back,
        }
    }
}

/// How a test's answer stands to that of the exact determinant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Why {
    /// The same.
    Same,
    /// None: a vertex has w = 0 and no image, or the eye has no place in object space.
    NoAnswer,
    /// Different, because the model matrix mirrors.
    Mirrored,
    /// Different, because an odd number of vertices lies behind the eye.
    BehindEye,
    /// Different, because the rules for zero are.
    EdgeOnRule,
    /// Different, because something was rounded: in the test, or on the way to its space.
    Rounded,
}

/// What the run did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// The terms before the value were computed: a normal, a plane, products or minors.
    Terms {
        /// Whose.
        test: Test,
    },
    /// The value was computed whose sign decides. In exact arithmetic it is shown rounded to binary64.
    Value {
        /// Whose.
        test: Test,
        /// The value.
        value: f64,
    },
    /// The test has no value.
    NoValue {
        /// Which test.
        test: Test,
    },
    /// The test has answered.
    Answer {
        /// Which test.
        test: Test,
        /// What it said; `None` if its value is no number.
        facing: Option<Facing>,
    },
    /// The exact determinant is zero; this is why.
    NoArea {
        /// The reason.
        why: Degeneracy,
    },
    /// The answer was compared with that of the exact determinant.
    Compare {
        /// Whose answer.
        test: Test,
        /// How the two stand to each other.
        why: Why,
    },
    /// What the pipeline does with the triangle.
    Fate {
        /// How the triangle stands to the eye, by the exact determinant.
        facing: Facing,
        /// Whether it is dropped.
        culled: bool,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// What came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// The answers, in the order of [`Test::ALL`].
    pub answers: [Option<Facing>; 6],
    /// How each stands to the exact determinant.
    pub compared: [Why; 6],
    /// Whether the pipeline drops the triangle.
    pub culled: bool,
}

/// Asks all six tests about one triangle.
///
/// All finite vertices and matrices are legal. In exact arithmetic about 100 ns; `tally` counts.
pub fn run(input: &Input, tally: &mut Tally) -> Outcome {
    run_traced(input, tally, &mut NoTrace)
}

/// [`run`] as a run that can be scrubbed.
pub fn play(input: Input, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(input.clone()), budget, move |t| {
        run_traced(&input, &mut Tally::default(), t);
    })
}

/// The algorithm: [`run`] and [`play`] are this with two tracers.
pub fn run_traced<T: Tracer<Event>>(input: &Input, tally: &mut Tally, t: &mut T) -> Outcome {
    let Input { spaces, settings, .. } = input;
    let answers = Test::ALL.map(|test| ask(test, input, tally, t));
    let exact = spaces.sign(Test::Determinant, tally).unwrap_or(Sign::Zero);
    if exact.is_zero() {
        let [object, camera] = [&spaces.object, &spaces.camera];
        let why = degeneracy(*object, *camera, tally);
        t.emit(|| Event::NoArea { why });
    }
    let compared = Test::ALL.map(|test| {
        let why = compare(test, answers[test as usize], exact, input);
        t.emit(|| Event::Compare { test, why });
        why
    });
    let facing = facing(spaces.clip, settings.front, tally);
    let culled = settings.cull.drops(facing);
    t.emit(|| Event::Fate { facing, culled });
    Outcome { answers, compared, culled }
}

/// One test: the terms, the value, the answer.
fn ask<T: Tracer<Event>>(test: Test, input: &Input, tally: &mut Tally, t: &mut T) -> Option<Facing> {
    let Input { spaces, settings, .. } = input;
    let exact = settings.arithmetic.is_exact();
    // In exact arithmetic only the sign is needed: the numbers are there to be shown.
    let numbers = if T::ENABLED || !exact { spaces.numbers(test, settings.arithmetic) } else { None };
    if T::ENABLED {
        match &numbers {
            Some(Numbers { terms, value }) => {
                if !terms.is_empty() {
                    t.emit(|| Event::Terms { test });
                }
                t.emit(|| Event::Value { test, value: *value });
            }
            None => t.emit(|| Event::NoValue { test }),
        }
    }
    let sign = if exact {
        spaces.sign(test, tally)
    } else {
        numbers.map(|numbers| numbers.value).filter(|value| !value.is_nan()).map(Sign::of)
    };
    let facing = sign.map(|sign| settings.facing(test, sign));
    t.emit(|| Event::Answer { test, facing });
    facing
}

/// How an answer stands to that of the exact determinant with the sign `exact`.
fn compare(test: Test, answer: Option<Facing>, exact: Sign, input: &Input) -> Why {
    let Input { spaces, settings, .. } = input;
    let right = settings.facing(Test::Determinant, exact);
    // What the test would say if nothing was rounded.
    let expected = settings.facing(test, exact * spaces.turn(test));
    match answer {
        None => Why::NoAnswer,
        Some(answer) if answer == right => Why::Same,
        Some(answer) if answer != expected => Why::Rounded,
        Some(_) if exact.is_zero() => Why::EdgeOnRule,
        Some(_) if test == Test::Object => Why::Mirrored,
        Some(_) => Why::BehindEye,
    }
}
