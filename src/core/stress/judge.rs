//! How an answer differs from the exact one: part by part, and by how much.
//!
//! *Source:* of the judgement, Direct3D 11.3 functional specification, section 3.1, on what an implementation may
//! differ in; of the measure, Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., sections 1.2 and 3.1:
//! an error is held against the largest number of its part, so that a coordinate that is 0 by chance counts for what
//! it means on the screen.

use crate::{
    compare::{Fact, Subject, difference, equal},
    math::next_up,
    message::Value,
};
use serde::Serialize;
use std::cmp::Reverse;

/// Bits of a binary32 number: from 2^24 units of the last place on no digit is right, and nothing is counted.
pub const BITS: u32 = 24;

/// A number that is farther off than so many units of the last place has lost ten of its [`BITS`]: it breaks the
/// case, as a wrong decision does.
pub const TOLERATED: u32 = 1 << 10;

/// One part of an answer that is not as the exact answer has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Deviation {
    /// What the rounded arithmetic says; `None`: it has lost the part.
    pub rounded: Option<Fact>,
    /// What is right; `None`: the part is one too many.
    pub exact: Option<Fact>,
    /// How far the worst number is off, in units of the last place of the part's largest number, at most 2^24;
    /// `None`: the part is decided otherwise.
    pub ulps: Option<u32>,
}

impl Deviation {
    /// Whether this alone breaks a case.
    pub fn breaks(&self) -> bool {
        self.ulps.is_none_or(|ulps| ulps > TOLERATED)
    }

    /// What either side says of the part, the exact one first.
    pub fn either(&self) -> Option<&Fact> {
        self.exact.as_ref().or(self.rounded.as_ref())
    }
}

/// How an answer differs from the exact one, in two numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Verdict {
    /// Parts that are decided otherwise: a pixel, a corner, the answer as a whole.
    pub wrong: u32,
    /// How far the worst number is off, in units of the last place, at most 2^24.
    pub ulps: u32,
}

impl Verdict {
    /// What all deviations come to.
    pub fn of(deviations: &[Deviation]) -> Self {
        Self {
            wrong: deviations.iter().filter(|each| each.ulps.is_none()).count() as u32,
            ulps: deviations.iter().filter_map(|each| each.ulps).max().unwrap_or(0),
        }
    }

    /// Whether the arithmetic breaks there.
    pub fn breaks(self) -> bool {
        self.wrong > 0 || self.ulps > TOLERATED
    }
}

/// How many of [`BITS`] are right in a number that is so far off.
pub fn right_bits(ulps: u32) -> u32 {
    BITS.saturating_sub(u32::BITS - ulps.leading_zeros())
}

/// Every part that is not as the exact answer has it, the worst first; both answers sorted as
/// [`sorted`](crate::compare::sorted) does.
///
/// Corners have no names: the nearest ones are taken for each other. A corner more or less on a side of the other
/// outline makes no other answer: it is as far off as it lies beside that side. Cost: linear, but for corners cubic.
pub fn deviations(rounded: &[Fact], exact: &[Fact]) -> Vec<Deviation> {
    let found = difference(rounded, exact);
    let changed = found.changed.into_iter().map(|changed| [Some(changed.a), Some(changed.b)]);
    let mine = found.only_a.into_iter().map(|fact| [Some(fact), None]);
    let theirs = found.only_b.into_iter().map(|fact| [None, Some(fact)]);
    let is_corner =
        |pair: &[Option<Fact>; 2]| pair.iter().flatten().any(|fact| fact.subject == Subject::Corner);
    let (corners, named): (Vec<_>, Vec<_>) = changed.chain(mine).chain(theirs).partition(is_corner);
    let [mine, theirs] = [0, 1].map(|side| corners.iter().filter_map(|pair| pair[side].clone()).collect());
    let all = named.into_iter().chain(paired(mine, theirs));
    let mut out: Vec<_> = all.map(|pair| deviation(pair, [rounded, exact])).collect();
    out.sort_by_key(|each| Reverse(each.ulps.unwrap_or(u32::MAX)));
    out
}

fn deviation([rounded, exact]: [Option<Fact>; 2], all: [&[Fact]; 2]) -> Deviation {
    let ulps = match (&rounded, &exact) {
        (Some(rounded), Some(exact)) => ulps(rounded, exact),
        (Some(alone), None) => beside(alone, all[1]),
        (None, Some(alone)) => beside(alone, all[0]),
        (None, None) => None,
    };
    Deviation { rounded, exact, ulps }
}

/// Corners of two outlines, the nearest ones together.
fn paired(mut rounded: Vec<Fact>, mut exact: Vec<Fact>) -> Vec<[Option<Fact>; 2]> {
    let far = |a: &Fact, b: &Fact| match (place(a), place(b)) {
        (Some(a), Some(b)) => distance(&a, &b),
        _ => f64::INFINITY,
    };
    let mut out = Vec::new();
    loop {
        let pairs = (0..rounded.len()).flat_map(|i| (0..exact.len()).map(move |j| (i, j)));
        let apart = |(i, j): (usize, usize)| far(&rounded[i], &exact[j]);
        let Some((i, j)) = pairs.min_by(|p, q| apart(*p).total_cmp(&apart(*q))) else { break };
        out.push([Some(rounded.remove(i)), Some(exact.remove(j))]);
    }
    out.extend(rounded.into_iter().map(|fact| [Some(fact), None]));
    out.extend(exact.into_iter().map(|fact| [None, Some(fact)]));
    out
}

fn number(value: &Value) -> Option<f32> {
    match *value {
        Value::F32(x) => Some(x),
        Value::F64(x) => Some(x as f32),
        _ => None,
    }
}

/// Where a corner is, with all its numbers; `None` for what is no corner.
fn place(fact: &Fact) -> Option<Vec<f64>> {
    let all: Option<Vec<_>> = fact.values.iter().map(|(_, value)| number(value).map(f64::from)).collect();
    all.filter(|all| all.len() > 1)
}

/// What is no number is infinitely far away.
fn distance(a: &[f64], b: &[f64]) -> f64 {
    let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs());
    apart.map(|each| if each.is_nan() { f64::INFINITY } else { each }).fold(0.0, f64::max)
}

/// How far a corner lies beside the nearest line between two corners; `None` if it is no corner, there are no others,
/// or it is so far beside them that the arithmetic has another outline.
fn beside(alone: &Fact, others: &[Fact]) -> Option<u32> {
    let at = place(alone)?;
    let others: Vec<_> = others.iter().filter_map(place).filter(|each| each.len() == at.len()).collect();
    let pairs = others.iter().flat_map(|a| others.iter().map(move |b| [a, b]));
    let nearest = pairs.map(|[a, b]| {
        let along =
            a.iter().zip(b).zip(&at).fold([0.0; 2], |[dot, long], ((a, b), p)| {
                [dot + (p - a) * (b - a), long + (b - a) * (b - a)]
            });
        let t = if along[1] > 0.0 { (along[0] / along[1]).clamp(0.0, 1.0) } else { 0.0 };
        let on: Vec<_> = a.iter().zip(b).map(|(a, b)| a + t * (b - a)).collect();
        distance(&at, &on)
    });
    let least = nearest.min_by(f64::total_cmp)?;
    Some(units(least, at.iter().fold(0.0, |most, c| f64::max(most, c.abs())) as f32))
        .filter(|n| *n <= TOLERATED)
}

/// How far the worst number is off; `None` if the two differ in more than numbers.
fn ulps(rounded: &Fact, exact: &Fact) -> Option<u32> {
    let (mut largest, mut farthest) = (0.0_f32, 0.0_f64);
    for ((_, a), (_, b)) in rounded.values.iter().zip(&exact.values) {
        if let (Some(a), Some(b)) = (number(a), number(b)) {
            largest = largest.max(b.abs());
            let apart = if equal(&a.into(), &b.into()) { 0.0 } else { (f64::from(a) - f64::from(b)).abs() };
            farthest = farthest.max(if apart.is_nan() { f64::INFINITY } else { apart });
        } else if !equal(a, b) {
            return None;
        }
    }
    Some(units(farthest, largest))
}

/// A distance in units of the last place of a number, at most 2^24; a part of a unit counts as one.
fn units(distance: f64, of: f32) -> u32 {
    let unit = f64::from(next_up(of)) - f64::from(of);
    let count = if distance == 0.0 { 0.0 } else { (distance / unit).ceil() };
    if count < f64::from(1_u32 << BITS) { count as u32 } else { 1 << BITS }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(at: &[[f32; 2]]) -> Vec<Fact> {
        at.iter().map(|at| Fact::corner(*at)).collect()
    }

    #[test]
    fn an_error_is_held_against_the_largest_number_of_its_part() {
        let off = |rounded, exact| deviations(&corners(&[rounded]), &corners(&[exact]))[0].ulps;
        assert_eq!(off([1.0 + f32::EPSILON, 0.0], [1.0, 0.0]), Some(1));
        assert_eq!(off([1.0, f32::EPSILON / 8.0], [1.0, 0.0]), Some(1), "a part of a unit is one");
        assert_eq!(off([0.0, 1e-45], [0.0, 0.0]), Some(1), "units end where numbers end");
        assert_eq!(off([f32::NAN, 0.0], [1.0, 0.0]), Some(1 << BITS));
        assert_eq!(off([1e30, 0.0], [1.0, 0.0]), Some(1 << BITS));
        assert!(deviations(&corners(&[[2.0, 3.0]]), &corners(&[[2.0, 3.0]])).is_empty());
    }

    #[test]
    fn the_nearest_corners_are_taken_for_each_other() {
        let up = 4.0_f32.next_up();
        let all =
            deviations(&corners(&[[4.0, up], [0.0, 0.0]]), &corners(&[[9.0, 9.0], [0.0, 0.0], [4.0, 4.0]]));
        assert_eq!(all.len(), 2);
        assert_eq!(all[0].ulps, None, "one is lost");
        assert_eq!(all[0].either().and_then(|fact| fact.at), Some([9.0, 9.0]));
        assert_eq!(all[1].ulps, Some(1));
        assert_eq!(Verdict::of(&all), Verdict { wrong: 1, ulps: 1 });
        let straight =
            deviations(&corners(&[[0.0, 0.0], [1.0, 1.0], [4.0, 4.0]]), &corners(&[[0.0, 0.0], [4.0, 4.0]]));
        assert_eq!(Verdict::of(&straight), Verdict::default(), "a corner on a side is none");
    }

    #[test]
    fn bits_are_lost_one_by_one() {
        assert_eq!([0, 1, 2, 3, 1 << 10, 1 << BITS].map(right_bits), [24, 23, 22, 22, 13, 0]);
    }
}
