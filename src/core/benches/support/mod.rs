//! What the benches share: rows that take turns, so that a busy moment of the machine hits them all, and
//! numbers that are the same on every machine.

use rasterscope_core::math::{Arithmetic, Tally};
use std::time::Instant;

/// How often each row is timed.
const ROUNDS: usize = 21;

/// The arithmetics that are compared.
pub(crate) const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F64, Arithmetic::F32];

/// Marsaglia's xorshift.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    /// Uniform in `low..high`.
    pub(crate) fn uniform(&mut self, low: f32, high: f32) -> f32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        low + (high - low) * (self.0 >> 40) as f32 / (1 << 24) as f32
    }
}

/// One line of a table.
pub(crate) struct Row<'a> {
    pub(crate) name: String,
    pub(crate) arithmetic: Arithmetic,
    /// What is timed.
    pub(crate) run: Box<dyn Fn(&mut Tally) + 'a>,
    /// For how many items it stands.
    pub(crate) items: usize,
    /// What is known of its errors, in the table's own unit.
    pub(crate) wrong: Option<f64>,
}

/// Times the rows by turns and prints them: the median, how many times that of the row of the same name
/// in binary64, the errors, and how often binary64 did not decide.
#[expect(clippy::print_stdout, reason = "it prints a table")]
pub(crate) fn race(item: &str, wrong: &str, rows: &[Row<'_>]) {
    let mut times = vec![Vec::with_capacity(ROUNDS); rows.len()];
    for _ in 0..ROUNDS {
        for (row, times) in rows.iter().zip(&mut times) {
            let start = Instant::now();
            (row.run)(&mut Tally::default());
            times.push(start.elapsed().as_secs_f64() * 1e9 / row.items as f64);
        }
    }
    let medians: Vec<f64> = times
        .iter_mut()
        .map(|times| {
            times.sort_unstable_by(f64::total_cmp);
            times[times.len() / 2]
        })
        .collect();
    let head = format!("ns {item}");
    println!("{head:<36} {:<6} {:>9} {:>7} {wrong:>12} {:>12}", "", "median", "x f64", "not decided");
    for (row, median) in rows.iter().zip(&medians) {
        let plain = rows.iter().position(|r| r.name == row.name && r.arithmetic == Arithmetic::F64);
        let ratio = plain.map_or(String::new(), |plain| format!("{:.2}", median / medians[plain]));
        let mut tally = Tally::default();
        (row.run)(&mut tally);
        let (share, wrong) =
            (tally.share() * 100.0, row.wrong.map_or(String::new(), |wrong| wrong.to_string()));
        let (name, arithmetic) = (&row.name, row.arithmetic.name());
        println!("{name:<36} {arithmetic:<6} {median:>9.1} {ratio:>7} {wrong:>12} {share:>10.4} %");
    }
}
