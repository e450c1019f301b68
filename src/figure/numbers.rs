//! How numbers are written, the same on the screen, in figures and in the tour.
//!
//! Minus is U+2212 and never stands before zero; no plus sign; thousands are grouped by a thin
//! space; at most four decimals, and beyond 999 999 or below 1e-4 a power of ten. In sentences a
//! number has its shortest form, in a column all have one count of decimals.

use rasterscope_core::message::Value;

/// The minus sign, as wide as a digit.
pub const MINUS: char = '\u{2212}';
/// Between groups of three digits.
pub const THIN_SPACE: char = '\u{2009}';
/// What is not defined.
pub const UNDEFINED: &str = "–";
/// Decimals in sentences and tables.
pub const DECIMALS: usize = 4;
/// Decimals in the cells of a pixel grid.
pub const CELL_DECIMALS: usize = 3;

/// The shortest form, for sentences and labels: `0.25`, `2`, `(2.375, 2)`.
///
/// A [`Value::Word`] gives its id; [`Words::value`](crate::words::Words::value) gives the word.
pub fn short(value: &Value) -> String {
    written(value, Decimals::UpTo(DECIMALS))
}

/// Like [`short`], but with at most `decimals` decimals.
pub(crate) fn fine(value: &Value, decimals: usize) -> String {
    written(value, Decimals::UpTo(decimals))
}

/// How many decimals a number gets.
#[derive(Clone, Copy)]
enum Decimals {
    /// As few as possible.
    UpTo(usize),
    /// In a column.
    All(usize),
}

/// The exact value: every decimal of the binary number and, for binary32, its bits.
///
/// A decimal expansion of more than 40 digits is written as an integer times a power of two.
pub fn exact(value: &Value) -> String {
    match value {
        Value::F32(x) if x.is_finite() => {
            format!("{} ({})", every_digit(f64::from(*x)), hex(x.to_bits(), 8))
        }
        Value::F32(x) => format!("{} ({})", short(value), hex(x.to_bits(), 8)),
        Value::F64(x) if x.is_finite() => every_digit(*x),
        Value::Vector(components) => {
            let lines: Vec<_> = components.iter().map(|&x| exact(&Value::F32(x))).collect();
            lines.join("\n")
        }
        other => short(other),
    }
}

/// A measured number: two significant digits in full up to 999 999 (`260 000`), a power of ten
/// beyond that and below 1e-4.
pub fn measured(x: f64) -> String {
    if !x.is_finite() || x == 0.0 {
        return real(x, Decimals::UpTo(DECIMALS));
    }
    let (mantissa, exponent) = scientific_parts(x, 1);
    if !(-4..6).contains(&exponent) {
        return power(&mantissa, exponent);
    }
    let rounded: f64 = format!("{x:.1e}").parse().unwrap_or(x);
    let decimals = usize::try_from(1 - exponent).unwrap_or(0);
    pretty(&format!("{rounded:.decimals$}"))
}

/// One count of decimals for all numbers of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ColumnFormat {
    /// How many decimals each number gets.
    pub decimals: usize,
}

impl ColumnFormat {
    /// As many decimals as the most demanding of `values` needs, at most `limit`.
    pub fn of<'a>(values: impl IntoIterator<Item = &'a Value>, limit: usize) -> Self {
        let need = |value: &Value| match value {
            Value::F32(x) => decimals_of(f64::from(*x), limit),
            Value::F64(x) => decimals_of(*x, limit),
            Value::Vector(list) => list.iter().map(|&x| decimals_of(f64::from(x), limit)).max().unwrap_or(0),
            _ => 0,
        };
        Self { decimals: values.into_iter().map(need).max().unwrap_or(0) }
    }

    /// `value` with this column's count of decimals.
    pub fn format(self, value: &Value) -> String {
        written(value, Decimals::All(self.decimals))
    }
}

/// A column of a table: one count of decimals, at most [`DECIMALS`].
pub fn column(values: &[Value]) -> Vec<String> {
    let format = ColumnFormat::of(values, DECIMALS);
    values.iter().map(|value| format.format(value)).collect()
}

/// A count, grouped from 1 000 on.
pub fn integer(n: i64) -> String {
    pretty(&n.to_string())
}

/// Upper case, padded to the whole format: `0xDF60`.
pub fn hex(code: u32, digits: usize) -> String {
    format!("0x{code:0digits$X}")
}

/// `width` bits, most significant first, in groups of four from the right.
pub fn bits(bits: u32, width: u8) -> String {
    let mut text = String::new();
    for i in (0..u32::from(width)).rev() {
        text.push(if bits.checked_shr(i).unwrap_or(0) & 1 == 1 { '1' } else { '0' });
        if i > 0 && i % 4 == 0 {
            text.push(' ');
        }
    }
    text
}

/// Digits of a power: `⁻⁷`.
pub fn superscript(n: i32) -> String {
    let raise = |c: char| match c {
        '-' => '⁻',
        digit => ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'][digit.to_digit(10).unwrap_or(0) as usize],
    };
    n.to_string().chars().map(raise).collect()
}

fn written(value: &Value, decimals: Decimals) -> String {
    match value {
        Value::None => UNDEFINED.to_owned(),
        Value::Int(n) => integer(*n),
        Value::F32(x) => real(f64::from(*x), decimals),
        Value::F64(x) => real(*x, decimals),
        Value::Vector(list) => {
            let list: Vec<_> = list.iter().map(|&x| real(f64::from(x), decimals)).collect();
            format!("({})", list.join(", "))
        }
        Value::Bits { bits: value, width } => bits(*value, *width),
        Value::Code { code, width } => hex(*code, usize::from(width.div_ceil(4))),
        Value::Word(id) => (*id).to_owned(),
        Value::Text(text) => text.clone(),
    }
}

fn real(x: f64, decimals: Decimals) -> String {
    if x.is_nan() {
        return "NaN".to_owned();
    }
    if x.is_infinite() {
        return if x > 0.0 { "∞".to_owned() } else { format!("{MINUS}∞") };
    }
    let (Decimals::UpTo(limit) | Decimals::All(limit)) = decimals;
    if needs_power(x) && (limit >= DECIMALS || x.abs() >= 1.0) {
        let (_, exponent) = scientific_parts(x, DECIMALS);
        // Where more decimals are asked for, down to the same place.
        let fine = if limit > DECIMALS { limit as i32 + exponent } else { 0 };
        let (mantissa, exponent) = scientific_parts(x, (fine.max(0) as usize).clamp(DECIMALS, 15));
        return power(&mantissa, exponent);
    }
    let digits = format!("{x:.limit$}");
    pretty(if matches!(decimals, Decimals::UpTo(_)) { trimmed(&digits) } else { &digits })
}

fn needs_power(x: f64) -> bool {
    x != 0.0 && !(1e-4..1e6).contains(&x.abs())
}

/// Mantissa with at most `decimals` decimals, and the power of ten.
fn scientific_parts(x: f64, decimals: usize) -> (String, i32) {
    let text = format!("{x:.decimals$e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    (trimmed(mantissa).to_owned(), exponent.parse().unwrap_or(0))
}

fn power(mantissa: &str, exponent: i32) -> String {
    format!("{} × 10{}", pretty(mantissa), superscript(exponent))
}

fn decimals_of(x: f64, limit: usize) -> usize {
    if !x.is_finite() {
        return 0;
    }
    if needs_power(x) {
        // Below 1e-4 the column must be wide enough to switch to a power of ten.
        return if x.abs() < 1.0 { limit } else { 0 };
    }
    let text = format!("{x:.limit$}");
    trimmed(&text).split_once('.').map_or(0, |(_, fraction)| fraction.len())
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// Plain digits with our minus sign and grouped thousands; no minus before a zero.
fn pretty(plain: &str) -> String {
    let (negative, digits) = plain.strip_prefix('-').map_or((false, plain), |digits| (true, digits));
    let (whole, fraction) = digits.split_once('.').map_or((digits, None), |(w, f)| (w, Some(f)));
    let mut text = String::new();
    if negative && digits.bytes().any(|digit| digit != b'0' && digit != b'.') {
        text.push(MINUS);
    }
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i).is_multiple_of(3) {
            text.push(THIN_SPACE);
        }
        text.push(digit);
    }
    if let Some(fraction) = fraction {
        text.push('.');
        text.push_str(fraction);
    }
    text
}

/// All decimals of a finite binary number, or an integer times a power of two if they are many.
fn every_digit(x: f64) -> String {
    let digits = format!("{x:.1074}");
    let digits = trimmed(&digits);
    if digits.len() <= 40 {
        return pretty(digits);
    }
    let bits = x.to_bits();
    let exponent = ((bits >> 52) & 0x7FF) as i32;
    let fraction = bits & ((1 << 52) - 1);
    let (mantissa, exponent) =
        if exponent == 0 { (fraction, -1074) } else { (fraction | 1 << 52, exponent - 1075) };
    let zeros = mantissa.trailing_zeros();
    let sign = if x < 0.0 { "-" } else { "" };
    let mantissa = pretty(&format!("{sign}{}", mantissa >> zeros));
    format!("{mantissa} × 2{}", superscript(exponent + zeros as i32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sentences_have_the_shortest_form() {
        for (value, text) in [
            (Value::F32(0.25), "0.25"),
            (Value::F32(2.0), "2"),
            (Value::F32(-1.5), "−1.5"),
            (Value::F32(-0.0), "0"),
            (Value::F64(1.0 / 3.0), "0.3333"),
            (Value::F64(0.999_99), "1"),
            (Value::F64(1204.5), "1\u{2009}204.5"),
            (Value::F64(-999_999.0), "−999\u{2009}999"),
            (Value::F64(2.6e-7), "2.6 × 10⁻⁷"),
            (Value::F64(-1e12), "−1 × 10¹²"),
            (Value::F32(f32::INFINITY), "∞"),
            (Value::F32(f32::NEG_INFINITY), "−∞"),
            (Value::F32(f32::NAN), "NaN"),
            (Value::None, "–"),
            (Value::Int(-187_000), "−187\u{2009}000"),
            (Value::Int(0), "0"),
            (Value::Int(i64::MIN), "−9\u{2009}223\u{2009}372\u{2009}036\u{2009}854\u{2009}775\u{2009}808"),
            (Value::from([2.375_f32, -2.0]), "(2.375, −2)"),
            (Value::Bits { bits: 0b0101, width: 4 }, "0101"),
            (Value::Bits { bits: 0xDF60, width: 16 }, "1101 1111 0110 0000"),
            (Value::Code { code: 0xDF60, width: 16 }, "0xDF60"),
            (Value::Code { code: 7, width: 24 }, "0x000007"),
            (Value::text("as it is"), "as it is"),
        ] {
            assert_eq!(short(&value), text);
        }
    }

    #[test]
    fn a_column_has_one_count_of_decimals() {
        let column = |values: &[f64]| column(&values.iter().map(|&x| Value::F64(x)).collect::<Vec<_>>());
        assert_eq!(column(&[4.25, 4.0, -10.375]), ["4.250", "4.000", "−10.375"]);
        assert_eq!(column(&[1.0, 2.0]), ["1", "2"]);
        assert_eq!(column(&[0.123_456, 2.0]), ["0.1235", "2.0000"]);
        assert_eq!(column(&[-0.0, 0.5]), ["0.0", "0.5"]);
        assert_eq!(column(&[2.6e-7, 0.5]), ["2.6 × 10⁻⁷", "0.5000"]);
        assert_eq!(column(&[1e9, 0.5]), ["1 × 10⁹", "0.5"]);
        assert_eq!(column(&[f64::INFINITY, 0.5]), ["∞", "0.5"]);
    }

    #[test]
    fn cells_have_at_most_three_decimals_and_no_powers_below_one() {
        let values = [Value::F32(0.317_2), Value::F32(0.35), Value::F32(-0.000_01)];
        let format = ColumnFormat::of(&values, CELL_DECIMALS);
        assert_eq!(values.map(|value| format.format(&value)), ["0.317", "0.350", "0.000"]);
    }

    #[test]
    fn measured_numbers_have_two_digits() {
        for (x, text) in [
            (263_417.0, "260\u{2009}000"),
            (14.3, "14"),
            (9.96, "10"),
            (1.04, "1.0"),
            (0.96, "0.96"),
            (0.997, "1.0"),
            (1.26, "1.3"),
            (0.001_26, "0.0013"),
            (2.64e-7, "2.6 × 10⁻⁷"),
            (1.23e6, "1.2 × 10⁶"),
            (0.0, "0"),
        ] {
            assert_eq!(measured(x), text);
        }
    }

    #[test]
    fn the_exact_value_has_every_digit_and_the_bits() {
        assert_eq!(exact(&Value::F32(0.5)), "0.5 (0x3F000000)");
        assert_eq!(exact(&Value::F32(0.1)), "0.100000001490116119384765625 (0x3DCCCCCD)");
        assert_eq!(exact(&Value::F32(f32::from_bits(1))), "1 × 2⁻¹⁴⁹ (0x00000001)");
        assert_eq!(exact(&Value::F32(-0.0)), "0 (0x80000000)");
        let long = exact(&Value::F64(-0.5 - f64::EPSILON));
        assert_eq!(long.replace(THIN_SPACE, ""), "−2251799813685249 × 2⁻⁵²");
        assert_eq!(exact(&Value::Int(1204)), "1\u{2009}204");
    }
}
