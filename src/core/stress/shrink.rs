//! Makes a failing case small: simpler numbers that fail as well, one after another.
//!
//! *Source:* Claessen and Hughes, QuickCheck, 2000; MacIver and Donaldson, Test-Case Reduction via Test-Case
//! Generation, 2020, whose order is the one here: of two inputs the simpler one is better, and only better ones
//! are taken. Deviation: an input stays of its kind, and only its numbers change.

use serde_json::Value;

use crate::labs::{self, LabInput};

/// The fields of inputs whose numbers are the case; the others say how it is worked on.
const FIELDS: [&str; 6] = ["window", "segment", "polygon", "vertices", "attribute", "at"];

/// How simple a number is: 0 is the simplest, then few significant bits and a size near 1, then no minus.
///
/// Any finite number.
pub fn complexity(x: f32) -> u32 {
    if x == 0.0 {
        return 0;
    }
    // Every binary32 number is a normal one of binary64.
    let bits = f64::from(x).to_bits();
    let mantissa = bits & ((1 << 52) - 1) | 1 << 52;
    let significant = 53 - mantissa.trailing_zeros();
    let exponent = (bits >> 52 & 0x7FF) as i32 - 1023;
    2 * (significant + exponent.unsigned_abs()) + u32::from(x < 0.0)
}

/// Numbers that may stand for a number, simplest first.
fn simpler(x: f32) -> impl Iterator<Item = f32> {
    let wide = f64::from(if x == 0.0 { 1.0 } else { x });
    let power = |by: i32| libm::ldexp(wide, by);
    let rounded = [1, 2, 3, 4, 6, 8, 12, 16, 20].map(|bits| significant(wide, bits));
    let scaled = if wide.abs() >= 1.0 { [-64, -16, -4, -1] } else { [64, 16, 4, 1] }.map(power);
    let whole = [0.0, 1.0, wide.abs(), wide.round(), wide.trunc(), (2.0 * wide).round() / 2.0];
    let all = whole.into_iter().chain(rounded).chain(scaled);
    let mut all: Vec<f32> = all.map(|y| y as f32).filter(|y| y.is_finite()).collect();
    all.retain(|y| complexity(*y) < complexity(x));
    all.sort_by_key(|y| (complexity(*y), y.to_bits()));
    all.dedup();
    all.into_iter()
}

/// The number rounded to some significant bits.
fn significant(x: f64, bits: i32) -> f64 {
    let exponent = libm::ilogb(x);
    libm::ldexp(libm::ldexp(x, bits - 1 - exponent).round(), exponent - bits + 1)
}

/// The numbers of a case, in order, with their names such as `vertices[0][1]`.
pub fn numbers(input: &LabInput) -> Vec<(String, f32)> {
    let mut out = Vec::new();
    let Ok(value) = serde_json::to_value(input) else { return out };
    for field in FIELDS {
        if let Some(value) = value.get(field) {
            leaves(value, field.to_owned(), &mut out);
        }
    }
    out
}

fn leaves(value: &Value, name: String, out: &mut Vec<(String, f32)>) {
    match value {
        Value::Array(all) => {
            all.iter().enumerate().for_each(|(i, value)| leaves(value, format!("{name}[{i}]"), out));
        }
        value => out.extend(value.as_f64().map(|number| (name, number as f32))),
    }
}

/// The same case with one number replaced, counted as [`numbers`] does; `None` if there is no such number, or
/// if it makes no case, or a window without area.
pub fn with_number(input: &LabInput, index: usize, number: f32) -> Option<LabInput> {
    let mut value = serde_json::to_value(input).ok()?;
    let mut left = index;
    let leaf = FIELDS.iter().find_map(|field| {
        // A path by itself, so that the borrow of each field ends where the next one begins.
        let path = value.get(field).and_then(|value| path_of(value, &mut left))?;
        Some(format!("/{field}{path}"))
    })?;
    *value.pointer_mut(&leaf)? = Value::from(f64::from(number));
    // What is cut to nothing shows nothing: a window stays one.
    let input = labs::find(input.name())?.read(&value).ok()?;
    let window =
        value.get("window").and_then(|window| serde_json::from_value::<[f32; 4]>(window.clone()).ok());
    let shut = window.is_some_and(|[xmin, ymin, xmax, ymax]| xmin >= xmax || ymin >= ymax);
    (!shut).then_some(input)
}

/// The JSON pointer of the number that is `left` numbers on.
fn path_of(value: &Value, left: &mut usize) -> Option<String> {
    match value {
        Value::Array(all) => {
            all.iter().enumerate().find_map(|(i, value)| Some(format!("/{i}{}", path_of(value, left)?)))
        }
        value if value.is_number() && *left == 0 => Some(String::new()),
        value => {
            *left -= usize::from(value.is_number());
            None
        }
    }
}

/// A number that was made simpler.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduction {
    /// Which, counted as [`numbers`] does.
    pub number: usize,
    /// What it is now.
    pub to: f32,
}

/// Replaces numbers by simpler ones as long as the case fails; tells of each.
///
/// The result fails if `input` does, and shrinking it again changes nothing: no single number can be made
/// simpler. Deterministic; ends, for each replacement is simpler. Cost: at most some 20 runs for each number and
/// round, and a round more than numbers change.
pub fn shrink(
    input: &LabInput,
    fails: &mut dyn FnMut(&LabInput) -> bool,
    tell: &mut dyn FnMut(Reduction),
) -> LabInput {
    let mut best = input.clone();
    loop {
        let mut better = false;
        for (number, (_, value)) in numbers(&best).into_iter().enumerate() {
            let found = simpler(value).find_map(|to| {
                let candidate = with_number(&best, number, to)?;
                fails(&candidate).then_some((to, candidate))
            });
            if let Some((to, candidate)) = found {
                tell(Reduction { number, to });
                (best, better) = (candidate, true);
            }
        }
        if !better {
            return best;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn simpler_numbers_have_fewer_bits_and_a_size_near_one() {
        let order = [0.0, 1.0, -1.0, 2.0, 0.5, 3.0, 0.75, 10.0, 0.1, 1e30, 1e-40];
        for pair in order.windows(2) {
            assert!(complexity(pair[0]) <= complexity(pair[1]), "{pair:?}");
        }
        for x in [0.1_f32, -3.7, 1e38, -1e-45, 7.0, f32::MAX] {
            let all: Vec<_> = simpler(x).collect();
            assert_eq!(all.first(), Some(&0.0), "{x}");
            assert!(all.iter().all(|y| complexity(*y) < complexity(x) && y.is_finite()), "{x}: {all:?}");
        }
        assert_eq!(simpler(0.0).next(), None);
    }

    #[test]
    fn numbers_are_found_and_replaced_in_order() {
        let line = labs::default_input("cohen-sutherland").expect("a lab");
        let all = numbers(&line);
        assert_eq!(all.len(), 8);
        assert_eq!(all[4], ("segment[0]".to_owned(), 0.5));
        let replaced = with_number(&line, 4, 0.25).expect("it is a line");
        assert_eq!(numbers(&replaced)[4].1, 0.25);
        assert_eq!(with_number(&line, 8, 0.0), None);
        assert_eq!(with_number(&line, 0, 1e9), None, "the window would be shut");
        let triangle = labs::default_input("area-ratios").expect("a lab");
        assert_eq!(numbers(&triangle).len(), 9 + 3 + 2);
    }
}
