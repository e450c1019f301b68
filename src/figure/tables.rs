//! A lab's tables and formulas as formatted text, with what changed since the step before.

use rasterscope_core::{
    explain::{Formula, Piece, Role, Row, Table},
    message::Value,
};

use crate::{
    numbers::{self, ColumnFormat},
    precision,
    words::Words,
};

pub use crate::words::Run;

/// A table ready to be painted.
#[derive(Clone, Debug, PartialEq)]
pub struct TextTable {
    /// Its title.
    pub title: String,
    /// Headings of the columns.
    pub columns: Vec<String>,
    /// What its title means, then what each heading means, where the glossary has it.
    pub meanings: Vec<Option<String>>,
    /// Rows in order.
    pub rows: Vec<TextRow>,
}

/// One row of a [`TextTable`].
#[derive(Clone, Debug, PartialEq)]
pub struct TextRow {
    /// Its heading.
    pub name: String,
    /// One for each column.
    pub cells: Vec<TextCell>,
    /// Whether the step is about this row.
    pub active: bool,
    /// A marker before it.
    pub role: Option<Role>,
}

impl TextRow {
    /// Whether any of its cells changed.
    pub fn changed(&self) -> bool {
        self.cells.iter().any(|cell| cell.changed)
    }
}

/// One cell of a [`TextRow`].
#[derive(Clone, Debug, PartialEq)]
pub struct TextCell {
    /// With the column's count of decimals.
    pub text: String,
    /// Every digit, for a tooltip; for what is no number, the reason.
    pub exact: String,
    /// Whether it differs from the step before.
    pub changed: bool,
}

/// Formats `tables`; `before` are those of the step before (empty: nothing counts as changed).
pub fn format(tables: &[Table], before: &[Table], words: &Words) -> Vec<TextTable> {
    tables.iter().map(|table| one(table, before, words)).collect()
}

fn one(table: &Table, before: &[Table], words: &Words) -> TextTable {
    let old = before.iter().find(|old| old.title == table.title);
    let formats: Vec<_> = (0..table.columns.len())
        .map(|column| {
            ColumnFormat::of(table.rows.iter().filter_map(|row| row.cells.get(column)), numbers::DECIMALS)
        })
        .collect();
    let mut rows = Vec::with_capacity(table.rows.len());
    for (index, row) in table.rows.iter().enumerate() {
        let old_row = old.and_then(|old| namesake(&old.rows, &table.rows[..index], row));
        let cells = row.cells.iter().zip(&table.columns).zip(&formats).enumerate();
        let cells = cells.map(|(column, ((value, heading), format))| TextCell {
            text: cell(value, heading, *format, words),
            exact: exact(value, words),
            changed: !before.is_empty()
                && !old_row.and_then(|old| old.cells.get(column)).is_some_and(|old| same(old, value)),
        });
        rows.push(TextRow {
            name: row_name(&row.name, words),
            cells: cells.collect(),
            active: row.active,
            role: row.role,
        });
    }
    TextTable {
        title: words.word(table.title),
        columns: table.columns.iter().map(|&heading| self::heading(heading, words)).collect(),
        meanings: meanings(table.title, &table.columns, words),
        rows,
    }
}

/// What a title means, then what each heading means.
pub fn meanings(title: &str, columns: &[&str], words: &Words) -> Vec<Option<String>> {
    std::iter::once(&title).chain(columns).map(|term| words.meaning(term)).collect()
}

/// The row of `old` with the name of `row`: the n-th if `row` is the n-th of that name.
fn namesake<'a>(old: &'a [Row], earlier: &[Row], row: &Row) -> Option<&'a Row> {
    let nth = earlier.iter().filter(|each| each.name == row.name).count();
    old.iter().filter(|each| each.name == row.name).nth(nth)
}

/// A row's heading: the words of a message id that starts with `row-`, else as it stands.
pub fn row_name(name: &str, words: &Words) -> String {
    if name.starts_with("row-") && words.has(name) { words.word(name) } else { name.to_owned() }
}

fn heading(heading: &'static str, words: &Words) -> String {
    if heading.starts_with("column-") { words.word(heading) } else { heading.to_owned() }
}

fn cell(value: &Value, heading: &str, format: ColumnFormat, words: &Words) -> String {
    match value {
        Value::Word(id) => words.word(id),
        // One column a bit under a heading such as `T B R L`.
        Value::Bits { bits, width } if heading.split(' ').count() == usize::from(*width) => {
            let digits: Vec<_> =
                (0..*width).rev().map(|i| if bits >> i & 1 == 1 { "1" } else { "0" }).collect();
            digits.join(" ")
        }
        Value::Code { .. } if heading == "column-hex" => {
            numbers::short(value).trim_start_matches("0x").to_owned()
        }
        other => format.format(other),
    }
}

fn exact(value: &Value, words: &Words) -> String {
    let x = match value {
        Value::None => return words.word("figure-undefined"),
        Value::Word(id) => return words.meaning(id).unwrap_or_else(|| words.word(id)),
        Value::F32(x) => f64::from(*x),
        Value::F64(x) => *x,
        _ => 0.0,
    };
    let digits = numbers::exact(value);
    if x.is_nan() {
        format!("{digits}: {}", words.word("figure-nan"))
    } else if x.is_infinite() {
        format!("{digits}: {}", words.word("figure-infinity"))
    } else {
        digits
    }
}

/// Equality of what is shown: NaN equals NaN.
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::F32(a), Value::F32(b)) => a == b || a.is_nan() && b.is_nan(),
        (Value::F64(a), Value::F64(b)) => a == b || a.is_nan() && b.is_nan(),
        (Value::Vector(a), Value::Vector(b)) => {
            a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b || a.is_nan() && b.is_nan())
        }
        _ => a == b,
    }
}

/// The formula in its names, and with this step's numbers: `=` under `=`, a negative number behind
/// another sign in parentheses. Numbers have the decimals that the result needs.
pub fn formula(formula: &Formula, words: &Words) -> [Vec<Run>; 2] {
    let plain = |text: String| Run { text, strong: false, highlighted: false };
    let compared = precision::compared(formula);
    let of_result = compared.unwrap_or(numbers::DECIMALS);
    let of_operand = compared.unwrap_or_else(|| precision::operands(formula));
    let mut numbers: Vec<Run> = Vec::with_capacity(formula.numbers.len());
    for piece in &formula.numbers {
        let (value, decimals, highlighted) = match piece {
            Piece::Text(text) => {
                numbers.push(plain((*text).to_owned()));
                continue;
            }
            Piece::Number(value) => (value, of_operand, false),
            Piece::Result(value) => (value, of_result, true),
        };
        let text = words.fine(value, decimals);
        let behind_sign =
            numbers.last().is_some_and(|run| run.text.trim_end().ends_with(['+', numbers::MINUS, '·', '/']));
        if behind_sign && text.starts_with(numbers::MINUS) {
            numbers.extend([plain("(".into()), Run { text, strong: true, highlighted }, plain(")".into())]);
        } else {
            numbers.push(Run { text, strong: true, highlighted });
        }
    }
    if let (Some(at), Some(first)) = (formula.general.find(['=', '←']), numbers.first_mut())
        && first.text.starts_with('=')
    {
        first.text.insert_str(0, &" ".repeat(formula.general[..at].chars().count()));
    }
    [vec![plain(formula.general.to_owned())], numbers]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(rows: Vec<Row>) -> Table {
        Table { title: "figure-dark", columns: vec!["x", "T B R L"], rows }
    }

    fn row(name: &str, x: f32, bits: u32) -> Row {
        Row::new(name, vec![Value::F32(x), Value::Bits { bits, width: 4 }])
    }

    #[test]
    fn columns_share_their_decimals_and_bits_stand_apart() {
        let words = Words::default();
        let text = format(&[table(vec![row("P1", 2.375, 0b0101), row("P2", 8.0, 0)])], &[], &words);
        let cells: Vec<_> =
            text[0].rows.iter().flat_map(|row| row.cells.iter()).map(|c| c.text.as_str()).collect();
        assert_eq!(cells, ["2.375", "0 1 0 1", "8.000", "0 0 0 0"]);
        assert_eq!(text[0].title, "Dark");
        assert!(!text[0].rows.iter().any(TextRow::changed));
    }

    #[test]
    fn what_changed_is_marked_cell_by_cell_and_new_rows_whole() {
        let words = Words::default();
        let before = [table(vec![row("P1", f32::NAN, 0), row("P2", 1.0, 0)])];
        let after = [table(vec![row("P1", f32::NAN, 1), row("P2", 1.0, 0), row("P2", 1.0, 0)])];
        let text = format(&after, &before, &words);
        let changed: Vec<_> =
            text[0].rows.iter().flat_map(|row| row.cells.iter()).map(|c| c.changed).collect();
        assert_eq!(changed, [false, true, false, false, true, true]);
    }

    #[test]
    fn a_value_that_is_no_number_says_why() {
        let words = Words::default();
        for value in [Value::None, Value::F32(f32::NAN), Value::F64(f64::INFINITY)] {
            let text = exact(&value, &words);
            assert!(text.contains(' ') && !text.contains('⟨'), "{text}");
        }
    }

    #[test]
    fn numbers_stand_under_their_names_and_negative_ones_behind_signs_in_parentheses() {
        let words = Words::default();
        let number = |x: f32| Piece::Number(Value::F32(x));
        let shown = Formula {
            general: "dx/dy = x1 − x0",
            numbers: vec![
                Piece::Text("= "),
                number(-2.0),
                Piece::Text(" − "),
                number(-0.5),
                Piece::Text(" = "),
                Piece::Result(Value::F32(-1.5)),
            ],
        };
        let [_, numbers] = formula(&shown, &words);
        let line: String = numbers.iter().map(|run| run.text.as_str()).collect();
        assert_eq!(line, "      = −2 − (−0.5) = −1.5");
    }

    #[test]
    fn rows_may_be_named_by_the_language() {
        let words = Words::default();
        assert_eq!(row_name("row-boat", &words), "row-boat");
        assert_eq!(row_name("P1", &words), "P1");
        assert!(!row_name("row-after", &words).starts_with("row-"));
    }

    #[test]
    fn results_wear_the_highlighter() {
        let words = Words::default();
        let shown = Formula {
            general: "t = a / b",
            numbers: vec![
                Piece::Text("t = "),
                Piece::Number(Value::F32(1.0)),
                Piece::Result(Value::F32(0.25)),
            ],
        };
        let [general, numbers] = formula(&shown, &words);
        assert_eq!(general[0].text, "t = a / b");
        let runs: Vec<_> =
            numbers.iter().map(|run| (run.text.as_str(), run.strong, run.highlighted)).collect();
        assert_eq!(runs, [("t = ", false, false), ("1", true, false), ("0.25", true, true)]);
    }
}
