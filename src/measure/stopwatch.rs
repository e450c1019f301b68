//! What measuring needs from outside: a clock, and whether anybody still waits.

/// How often everything runs, unless somebody says otherwise: enough for a steady median.
pub const ROUNDS: u32 = 15;

/// A clock and its patience.
#[derive(Clone, Copy)]
pub struct Stopwatch<'a> {
    /// How often everything runs, at least once; a round before them warms up.
    pub rounds: u32,
    /// Seconds since any moment.
    pub now: &'a dyn Fn() -> f64,
    /// Asked between runs: where it is false, measuring ends soon, and what was measured is of no use.
    pub wanted: &'a dyn Fn() -> bool,
}

impl std::fmt::Debug for Stopwatch<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Stopwatch").field("rounds", &self.rounds).finish_non_exhaustive()
    }
}

impl Stopwatch<'_> {
    /// How long a run takes, in ns.
    pub(crate) fn time(&self, run: impl FnOnce()) -> f64 {
        let start = (self.now)();
        run();
        ((self.now)() - start) * 1e9
    }

    /// Has rounds of runs made: `run(round, i)` for each i below `count`, in turns; round 0 warms up.
    pub(crate) fn take_turns(&self, count: usize, mut run: impl FnMut(u32, usize)) {
        for round in 0..=self.rounds.max(1) {
            for i in 0..count {
                if !(self.wanted)() {
                    return;
                }
                run(round, i);
            }
        }
    }

    /// The median time of each of some runs, which take turns, in ns.
    pub(crate) fn times<const N: usize>(&self, mut runs: [&mut dyn FnMut(); N]) -> [f64; N] {
        let mut times: [Vec<f64>; N] = std::array::from_fn(|_| Vec::new());
        self.take_turns(N, |round, i| {
            let time = self.time(&mut runs[i]);
            if round > 0 {
                times[i].push(time);
            }
        });
        times.map(|times| quartiles(times)[1])
    }
}

/// The quartiles; 0 of nothing.
pub(crate) fn quartiles(mut times: Vec<f64>) -> [f64; 3] {
    times.sort_unstable_by(f64::total_cmp);
    [0.25, 0.5, 0.75].map(|share| {
        let last = times.len().saturating_sub(1) as f64;
        times.get((last * share).round() as usize).copied().unwrap_or(0.0)
    })
}
