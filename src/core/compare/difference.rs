//! What two results have in common and what not.

use super::fact::Fact;
use crate::{math::ulps_between, message::Value};

/// What both results say of one subject, and say differently.
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// What A says.
    pub a: Fact,
    /// What B says.
    pub b: Fact,
}

impl Changed {
    /// Whether the two differ by rounding alone: in coordinates and depths, not in what is said.
    pub fn in_numbers_only(&self) -> bool {
        let mut pairs = self.a.values.iter().zip(&self.b.values);
        pairs.all(|((_, a), (_, b))| equal(a, b) || ulps(a, b).is_some())
    }

    /// How far the numbers are apart that are farthest apart; `None` if no number differs.
    pub fn ulps(&self) -> Option<u64> {
        let pairs = self.a.values.iter().zip(&self.b.values);
        pairs.filter_map(|((_, a), (_, b))| ulps(a, b)).max().filter(|&most| most > 0)
    }
}

/// Where two results differ; the parts in the order of their subjects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Difference {
    /// Parts of A's result alone.
    pub only_a: Vec<Fact>,
    /// Parts of B's result alone.
    pub only_b: Vec<Fact>,
    /// Parts of both that are not the same.
    pub changed: Vec<Changed>,
    /// How many parts are the same in both.
    pub same: usize,
}

/// One part of either result, on both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part<'a> {
    /// What A says of it, if anything.
    pub a: Option<&'a Fact>,
    /// What B says of it, if anything.
    pub b: Option<&'a Fact>,
}

impl<'a> Part<'a> {
    /// What A says, or B where A says nothing.
    pub fn either(&self) -> Option<&'a Fact> {
        self.a.or(self.b)
    }

    /// Whether both say the same.
    pub fn agrees(&self) -> bool {
        match (self.a, self.b) {
            (Some(a), Some(b)) => agree(a, b),
            (a, b) => a.is_none() && b.is_none(),
        }
    }

    /// Each value by its name, on A and on B.
    pub fn values(&self) -> Vec<(&'static str, [Option<&'a Value>; 2])> {
        let names = self.either().map_or(&[][..], |fact| &fact.values).iter().map(|(name, _)| *name);
        let at = |fact: Option<&'a Fact>, i: usize| fact.and_then(|fact| fact.values.get(i)).map(|(_, v)| v);
        names.enumerate().map(|(i, name)| (name, [at(self.a, i), at(self.b, i)])).collect()
    }
}

impl Difference {
    /// Every part that differs: what both have first, then A's own, then B's own; what differs in
    /// numbers only comes last.
    pub fn parts(&self) -> impl Iterator<Item = Part<'_>> {
        let changed = |in_numbers: bool| {
            let of_kind = move |changed: &&Changed| changed.in_numbers_only() == in_numbers;
            let both = self.changed.iter().filter(of_kind);
            both.map(|Changed { a, b }| Part { a: Some(a), b: Some(b) })
        };
        let only_a = self.only_a.iter().map(|a| Part { a: Some(a), b: None });
        let only_b = self.only_b.iter().map(|b| Part { a: None, b: Some(b) });
        changed(false).chain(only_a).chain(only_b).chain(changed(true))
    }

    /// How many parts of both differ in numbers only.
    pub fn in_numbers_only(&self) -> usize {
        self.changed.iter().filter(|changed| changed.in_numbers_only()).count()
    }

    /// How many parts differ.
    pub fn count(&self) -> usize {
        self.only_a.len() + self.only_b.len() + self.changed.len()
    }

    /// How far the numbers are apart that are farthest apart, in steps between neighbouring
    /// binary32 numbers; `None` if no number differs.
    pub fn ulps(&self) -> Option<u64> {
        self.changed.iter().filter_map(Changed::ulps).max()
    }
}

/// Holds two results against each other, each in the order of its subjects, as [`sorted`] has it.
///
/// Equal facts cancel. What is left of one subject is paired in order if as much is left on both
/// sides; else it stands alone. So corners need no names and may come in any order. Cost: linear,
/// but quadratic in the number of facts about one subject.
pub fn difference(a: &[Fact], b: &[Fact]) -> Difference {
    let mut out = Difference::default();
    let (mut a, mut b) = (a, b);
    while let Some(subject) = [a.first(), b.first()].into_iter().flatten().map(|fact| &fact.subject).min() {
        let [mine, theirs] =
            [a, b].map(|facts| facts.split_at(facts.partition_point(|fact| fact.subject <= *subject)));
        group(mine.0, theirs.0, &mut out);
        (a, b) = (mine.1, theirs.1);
    }
    out
}

/// Facts in the order of their subjects; those about one subject stay in their order.
pub fn sorted(mut facts: Vec<Fact>) -> Vec<Fact> {
    facts.sort_by(|p, q| p.subject.cmp(&q.subject));
    facts
}

/// All facts about one subject.
fn group(a: &[Fact], b: &[Fact], out: &mut Difference) {
    let mut rest: Vec<&Fact> = b.iter().collect();
    let mut mine = Vec::new();
    for fact in a {
        match rest.iter().position(|other| agree(fact, other)) {
            Some(twin) => drop(rest.remove(twin)),
            None => mine.push(fact.clone()),
        }
    }
    out.same += a.len() - mine.len();
    let rest = rest.into_iter().cloned();
    if mine.len() == rest.len() {
        out.changed.extend(mine.into_iter().zip(rest).map(|(a, b)| Changed { a, b }));
    } else {
        out.only_a.append(&mut mine);
        out.only_b.extend(rest);
    }
}

/// Whether two facts say the same of their subject.
fn agree(a: &Fact, b: &Fact) -> bool {
    let same = |((name, a), (other, b)): (&(&str, Value), &(&str, Value))| name == other && equal(a, b);
    a.values.len() == b.values.len() && a.values.iter().zip(&b.values).all(same)
}

/// Whether two values are the same; unlike `==`, a NaN is the same as a NaN.
pub fn equal(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::F32(a), Value::F32(b)) => a == b || a.is_nan() && b.is_nan(),
        (Value::F64(a), Value::F64(b)) => a == b || a.is_nan() && b.is_nan(),
        _ => a == b,
    }
}

/// How far two numbers are apart, in steps between neighbouring binary32 numbers; `None` for what
/// is no coordinate. Binary64 numbers are rounded first.
pub fn ulps(a: &Value, b: &Value) -> Option<u64> {
    let narrow = |value: &Value| match *value {
        Value::F32(x) => Some(x),
        Value::F64(x) => Some(x as f32),
        _ => None,
    };
    Some(ulps_between(narrow(a)?, narrow(b)?))
}
