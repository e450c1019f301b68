//! What the lectures say about cost, each claim as an experiment with numbers and a verdict.

mod attributes;
mod clipping;
mod culling;
mod pixels;
mod visibility;

use serde::{Serialize, Serializer};

use crate::Stopwatch;

/// Whether a claim is true on this machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Everywhere.
    Holds,
    /// It holds where the claim's own words below the numbers say.
    UnderACondition,
    /// Nowhere.
    DoesNotHold,
}

impl Verdict {
    /// From what each case of a claim says.
    fn of(cases: impl IntoIterator<Item = bool>) -> Self {
        let (mut some, mut all) = (false, true);
        cases.into_iter().for_each(|holds| (some, all) = (some | holds, all & holds));
        match (some, all) {
            (true, true) => Self::Holds,
            (true, false) => Self::UnderACondition,
            (false, _) => Self::DoesNotHold,
        }
    }

    /// `bench-verdict-NAME` says it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::UnderACondition => "under-a-condition",
            Self::DoesNotHold => "does-not-hold",
        }
    }
}

/// What was varied.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum At {
    /// The input's own name.
    Name(&'static str),
    /// Such as how many triangles there were.
    Number(f64),
}

impl From<&'static str> for At {
    fn from(name: &'static str) -> Self {
        Self::Name(name)
    }
}

impl From<f64> for At {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl std::fmt::Display for At {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Name(name) => f.write_str(name),
            Self::Number(number) => number.fmt(f),
        }
    }
}

impl Serialize for At {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// One number of an experiment.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Number {
    /// Where.
    pub at: At,
    /// What was found there.
    pub value: f64,
}

/// Numbers of one kind.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// `bench-series-NAME` is what it is and its unit.
    pub name: &'static str,
    /// Whether it counts, and so is the same on every machine.
    pub counted: bool,
    /// In the order of what was varied.
    pub numbers: Vec<Number>,
}

impl Series {
    fn timed(name: &'static str, numbers: impl IntoIterator<Item = (impl Into<At>, f64)>) -> Self {
        let numbers = numbers.into_iter().map(|(at, value)| Number { at: at.into(), value }).collect();
        Self { name, counted: false, numbers }
    }

    fn counted(name: &'static str, numbers: impl IntoIterator<Item = (impl Into<At>, f64)>) -> Self {
        Self { counted: true, ..Self::timed(name, numbers) }
    }
}

/// What came out.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The numbers.
    pub series: Vec<Series>,
    /// What they say.
    pub verdict: Verdict,
}

/// What an axis counts in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Steps {
    /// Each step adds as much.
    Sums,
    /// Each step is as many times as much.
    Factors,
}

use Steps::{Factors, Sums};

/// A claim and its experiment.
#[derive(Clone, Copy, Debug)]
pub struct Claim {
    /// `bench-claim-NAME` is its sentence, `bench-claim-NAME-here` what was found about it.
    pub name: &'static str,
    /// What is varied, `bench-x-NAME`, and what is found, `bench-y-NAME`.
    pub(crate) axes: [&'static str; 2],
    /// How they are drawn; names have bars all the same.
    pub(crate) steps: [Steps; 2],
    /// What the numbers are held against, `bench-guide-` and the claim's name.
    pub(crate) guide: Option<f64>,
    /// How many series are drawn: the others have another unit.
    pub(crate) drawn: usize,
    run: fn(&Stopwatch<'_>) -> Finding,
}

/// Every claim, in the order of the pipeline.
pub static CLAIMS: [Claim; 11] = [
    Claim {
        axes: ["model", "share"],
        guide: Some(0.5),
        ..claim("culling-removes-half", [Sums, Sums], culling::removes_half)
    },
    Claim {
        axes: ["model", "late-by-early"],
        guide: Some(1.0),
        ..claim("cull-before-clipping", [Sums, Sums], culling::before_clipping)
    },
    Claim {
        axes: ["outside", "line"],
        ..claim("outcodes-when-outside", [Sums, Sums], clipping::outcodes_when_outside)
    },
    Claim {
        axes: ["cuts", "divisions"],
        ..claim("no-division-to-decide", [Sums, Sums], clipping::no_division_to_decide)
    },
    Claim {
        axes: ["triangles", "frame-log"],
        drawn: 3,
        ..claim("object-space-quadratic", [Factors, Factors], visibility::object_space_quadratic)
    },
    Claim {
        axes: ["triangles", "frame"],
        ..claim("z-buffer-constant", [Factors, Sums], pixels::z_buffer_constant)
    },
    Claim {
        axes: ["leg", "tests"],
        ..claim("regions-save-tests", [Factors, Factors], pixels::regions_save_tests)
    },
    Claim {
        axes: ["leg", "changed"],
        guide: Some(1e3),
        ..claim("fixed-point-is-enough", [Factors, Factors], pixels::fixed_point_is_enough)
    },
    Claim {
        axes: ["leg", "pixel"],
        ..claim("additions-are-cheap", [Factors, Factors], pixels::additions_are_cheap)
    },
    Claim {
        axes: ["mode", "divisions-pixel"],
        drawn: 1,
        ..claim("perspective-one-division", [Sums, Sums], attributes::one_division)
    },
    Claim { axes: ["leg", "depth"], ..claim("row-coherence", [Factors, Factors], pixels::row_coherence) },
];

/// A claim whose axes are still to be named.
const fn claim(name: &'static str, steps: [Steps; 2], run: fn(&Stopwatch<'_>) -> Finding) -> Claim {
    Claim { name, axes: [""; 2], steps, guide: None, drawn: usize::MAX, run }
}

impl Claim {
    /// Makes the experiment; `None` if it was stopped.
    pub fn examine(&self, stopwatch: &Stopwatch<'_>) -> Option<Finding> {
        let finding = (self.run)(stopwatch);
        (stopwatch.wanted)().then_some(finding)
    }

    /// The claim called `name`.
    pub fn from_name(name: &str) -> Option<&'static Self> {
        CLAIMS.iter().find(|claim| claim.name == name)
    }
}
