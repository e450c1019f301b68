//! Results as facts.

use crate::message::Value;
use std::borrow::Cow;

/// What a fact is about: facts of two runs about the same subject are held against each other.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Subject {
    /// The answer as a whole: accepted or rejected, culled or kept.
    Answer,
    /// Something with a name that both runs know: a point, a vertex in a space, an object.
    Named(Cow<'static, str>),
    /// A corner of a resulting polygon. Corners have no names: those at the same place are the
    /// same.
    Corner,
    /// A pixel, as column and row.
    Pixel([u32; 2]),
}

/// One part of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Fact {
    /// What it is about.
    pub subject: Subject,
    /// Where that is in the drawing, if it is a point of it.
    pub at: Option<[f32; 2]>,
    /// What holds of it: names of the listing, or message ids that start with `column-`, with
    /// their values. The same names in the same order in every run that can be compared.
    pub values: Vec<(&'static str, Value)>,
}

impl Fact {
    /// The answer as a whole, as the id of a word.
    pub fn answer(word: &'static str) -> Self {
        let values = vec![("column-answer", Value::Word(word))];
        Self { subject: Subject::Answer, at: None, values }
    }

    /// A point of the drawing with a name.
    pub fn point(name: impl Into<Cow<'static, str>>, at: [f32; 2]) -> Self {
        Self { subject: Subject::Named(name.into()), ..Self::corner(at) }
    }

    /// A corner of a resulting polygon.
    pub fn corner(at: [f32; 2]) -> Self {
        let values = vec![("x", at[0].into()), ("y", at[1].into())];
        Self { subject: Subject::Corner, at: Some(at), values }
    }

    /// Something with a name, and what holds of it.
    pub fn named(name: impl Into<Cow<'static, str>>, values: Vec<(&'static str, Value)>) -> Self {
        Self { subject: Subject::Named(name.into()), at: None, values }
    }

    /// A pixel, and what holds of it.
    pub fn pixel(at: [u32; 2], values: Vec<(&'static str, Value)>) -> Self {
        Self { subject: Subject::Pixel(at), at: None, values }
    }
}

/// How many parts of each kind there are, and the sums of what is counted in them: message ids
/// with numbers.
pub fn totals(facts: &[Fact]) -> Vec<(&'static str, i64)> {
    let mut totals: Vec<(&'static str, i64)> = Vec::new();
    let mut add = |name: &'static str, n: i64| match totals.iter_mut().find(|(known, _)| *known == name) {
        Some((_, total)) => *total += n,
        None => totals.push((name, n)),
    };
    for fact in facts {
        match fact.subject {
            Subject::Answer => {}
            Subject::Named(_) => add("compare-named", 1),
            Subject::Corner => add("compare-corners", 1),
            Subject::Pixel(_) => add("compare-pixels", 1),
        }
        for (name, value) in &fact.values {
            if let Value::Int(n) = value {
                add(name, *n);
            }
        }
    }
    totals
}
