//! What two results have in common and what not.

use super::fact::Fact;
use crate::{math::ulps_between, message::Value};
use std::{cmp::Ordering, iter::Peekable, vec::IntoIter};

/// What both results say of one subject, and say differently.
#[derive(Clone, Debug, PartialEq)]
pub struct Changed {
    /// What A says.
    pub a: Fact,
    /// What B says.
    pub b: Fact,
}

impl Changed {
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

impl Difference {
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

/// Holds two results against each other.
///
/// Equal facts cancel. What is left of one subject is paired in order if as much is left on both
/// sides; else it stands alone. So corners need no names and may come in any order. Cost: that of
/// sorting both.
pub fn difference(mut a: Vec<Fact>, mut b: Vec<Fact>) -> Difference {
    a.sort_by(|p, q| p.subject.cmp(&q.subject));
    b.sort_by(|p, q| p.subject.cmp(&q.subject));
    let mut out = Difference::default();
    let (mut a, mut b) = (a.into_iter().peekable(), b.into_iter().peekable());
    loop {
        let order = match (a.peek(), b.peek()) {
            (None, None) => return out,
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (Some(p), Some(q)) => p.subject.cmp(&q.subject),
        };
        match order {
            Ordering::Less => out.only_a.extend(a.next()),
            Ordering::Greater => out.only_b.extend(b.next()),
            Ordering::Equal => {
                let subject = a.peek().map(|fact| fact.subject.clone());
                let of_one = |facts: &mut Peekable<IntoIter<Fact>>| {
                    let same = |fact: &Fact| Some(&fact.subject) == subject.as_ref();
                    std::iter::from_fn(|| facts.next_if(same)).collect::<Vec<_>>()
                };
                group(of_one(&mut a), of_one(&mut b), &mut out);
            }
        }
    }
}

/// All facts about one subject.
fn group(mut a: Vec<Fact>, mut b: Vec<Fact>, out: &mut Difference) {
    let before = a.len();
    a.retain(|fact| {
        let twin = b.iter().position(|other| agree(fact, other));
        twin.map(|twin| b.remove(twin)).is_none()
    });
    out.same += before - a.len();
    if a.len() == b.len() {
        out.changed.extend(a.into_iter().zip(b).map(|(a, b)| Changed { a, b }));
    } else {
        out.only_a.append(&mut a);
        out.only_b.append(&mut b);
    }
}

/// Whether two facts say the same of their subject.
fn agree(a: &Fact, b: &Fact) -> bool {
    let same = |((name, a), (other, b)): (&(&str, Value), &(&str, Value))| name == other && equal(a, b);
    a.values.len() == b.values.len() && a.values.iter().zip(&b.values).all(same)
}

/// Whether two values are the same; unlike `==`, a NaN is the same as a NaN.
fn equal(a: &Value, b: &Value) -> bool {
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
