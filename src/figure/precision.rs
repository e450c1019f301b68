//! How many decimals the numbers of a formula need, so that what is printed gives the printed result.
//!
//! Four are enough for most. A whole result, such as a code, changes with digits that four decimals
//! do not show; a difference much smaller than its terms has lost the digits in which they differ;
//! and a comparison must not show two numbers as one.

use crate::numbers::DECIMALS;
use rasterscope_core::{
    explain::{Formula, Piece},
    message::Value,
};

/// More would fill the line; doubles near 1 have about 16.
const MOST: usize = 12;
/// Digits of an operand beyond those of a whole result: one printed operand in a thousand may still
/// round to another whole number.
const SPARE: usize = 3;
/// A result so many times smaller than an operand has lost digits.
const LOSS: f64 = 10.0;

/// The decimals of the numbers put into `formula`; a result has [`DECIMALS`], unless it is compared.
pub(crate) fn operands(formula: &Formula) -> usize {
    let (mut put_in, mut results) = (Vec::new(), Vec::new());
    for piece in &formula.numbers {
        match piece {
            Piece::Number(value) => reals(value, &mut put_in),
            Piece::Result(value) => results.push(value),
            Piece::Text(_) => {}
        }
    }
    let greatest = put_in.iter().fold(0.0_f64, |greatest, x| greatest.max(x.abs()));
    let mut decimals = DECIMALS;
    for result in results {
        if let Some(digits) = whole_digits(result) {
            decimals = decimals.max(digits + SPARE);
            // Where it is rounded, what is no half must not look like one.
            while decimals < MOST && put_in.iter().any(|x| looks_like_half(*x, decimals)) {
                decimals += 1;
            }
        } else if let Some(x) = real(result)
            && x != 0.0
            && greatest >= LOSS * x.abs()
        {
            decimals = decimals.max(places(x) + 1);
        }
    }
    decimals.min(MOST)
}

/// The decimals of all numbers of a comparison: as many as tell those apart that are compared.
pub(crate) fn compared(formula: &Formula) -> Option<usize> {
    let is_sign = |piece: &Piece| matches!(piece, Piece::Text(text) if ["<", ">", "≤", "≥", "≠"].contains(&text.trim()));
    if !formula.numbers.iter().any(is_sign) {
        return None;
    }
    let mut all = Vec::new();
    for piece in &formula.numbers {
        if let Piece::Number(value) | Piece::Result(value) = piece {
            reals(value, &mut all);
        }
    }
    let alike = |decimals: &usize| {
        let pairs = all.iter().enumerate().flat_map(|(i, a)| all[..i].iter().map(move |b| (*a, *b)));
        pairs.into_iter().any(|(a, b)| a != b && printed(a, *decimals) == printed(b, *decimals))
    };
    (DECIMALS..=MOST).find(|decimals| !alike(decimals)).or(Some(MOST))
}

fn real(value: &Value) -> Option<f64> {
    match value {
        Value::F32(x) => Some(f64::from(*x)),
        Value::F64(x) => Some(*x),
        _ => None,
    }
    .filter(|x| x.is_finite())
}

fn reals(value: &Value, out: &mut Vec<f64>) {
    match value {
        Value::Vector(list) => out.extend(list.iter().map(|x| f64::from(*x)).filter(|x| x.is_finite())),
        other => out.extend(real(other)),
    }
}

/// How many digits a whole result has.
fn whole_digits(value: &Value) -> Option<usize> {
    let digits = match value {
        Value::Int(n) => n.unsigned_abs().to_string().len(),
        Value::Code { code, .. } => code.to_string().len(),
        // A code in one group of digits.
        Value::Text(text) if !text.is_empty() && text.bytes().all(|c| c.is_ascii_digit()) => text.len(),
        _ => return None,
    };
    Some(digits)
}

fn looks_like_half(x: f64, decimals: usize) -> bool {
    // Below that a power of ten shows that it is none.
    x.abs() >= 1e-4 && (2.0 * x).fract() != 0.0 && (2.0 * printed(x, decimals)).fract() == 0.0
}

/// `x` as it is read from the screen.
fn printed(x: f64, decimals: usize) -> f64 {
    format!("{x:.decimals$}").parse().unwrap_or(x)
}

/// The decimal place of the last digit with which a result is printed.
fn places(x: f64) -> usize {
    let exponent = x.abs().log10().floor();
    if exponent < -4.0 { DECIMALS + (-exponent).min(300.0) as usize } else { DECIMALS }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn formula(numbers: Vec<Piece>) -> Formula {
        Formula { general: "", numbers }
    }

    fn line(shown: &Formula) -> String {
        let [_, numbers] = crate::tables::formula(shown, &crate::words::Words::default());
        numbers.iter().map(|run| run.text.as_str()).collect()
    }

    #[test]
    fn what_is_printed_gives_the_code() {
        for (z, scale, max, code) in [
            (0.887_487_4_f32, " · 65535 + ½⌋ = ", 65_535.0, 58_161_u32),
            (0.332_131_65_f32, " · 16777215 + ½⌋ = ", 16_777_215.0, 5_572_244),
        ] {
            let numbers = vec![
                Piece::Text("= ⌊"),
                Piece::Number(z.into()),
                Piece::Text(scale),
                Piece::Result(Value::text(code)),
            ];
            let text = line(&formula(numbers));
            let shown: f64 = text.split(['⌊', ' ']).find_map(|part| part.parse().ok()).expect(&text);
            assert_eq!((shown * max + 0.5).floor(), f64::from(code), "{text}");
            assert!(text.ends_with(&code.to_string()), "{text}");
        }
    }

    #[test]
    fn a_small_difference_is_that_of_the_printed_terms() {
        let (a, b) = (3.190_819_2_f64, 3.189_258_1);
        let numbers = vec![
            Piece::Number(a.into()),
            Piece::Text(" − "),
            Piece::Number(b.into()),
            Piece::Text(" = "),
            Piece::Result((a - b).into()),
        ];
        assert_eq!(line(&formula(numbers)), "3.19082 − 3.18926 = 0.0016");
    }

    #[test]
    fn numbers_that_are_compared_look_different() {
        let compare = |a: f32, b: f32| {
            let numbers = vec![Piece::Result(a.into()), Piece::Text(" < "), Piece::Number(b.into())];
            line(&formula(numbers))
        };
        assert_eq!(compare(0.25, 0.5), "0.25 < 0.5");
        assert_eq!(compare(0.500_01, 0.500_02), "0.50001 < 0.50002");
    }

    #[test]
    fn other_formulas_keep_four_decimals() {
        let numbers = vec![
            Piece::Number((1.0_f64 / 3.0).into()),
            Piece::Text(" + "),
            Piece::Number((2.0_f64 / 3.0).into()),
            Piece::Text(" = "),
            Piece::Result(1.0_f64.into()),
        ];
        assert_eq!(line(&formula(numbers)), "0.3333 + 0.6667 = 1");
    }

    #[test]
    fn what_is_rounded_does_not_look_like_a_half() {
        let numbers = vec![
            Piece::Text("⌊"),
            Piece::Number(3.499_998_f64.into()),
            Piece::Text(" + 0.5⌋ = "),
            Piece::Result(3.into()),
        ];
        assert_eq!(line(&formula(numbers)), "⌊3.499998 + 0.5⌋ = 3");
    }
}
