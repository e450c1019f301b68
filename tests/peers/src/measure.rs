//! Contenders take turns; medians, spreads and ratios are of one run.

use cpu_time::ThreadTime;

/// One crate (or one way to call it) at one task: inputs in its own form, outputs that are read after the clock has stopped.
pub trait Contender<Answer> {
    /// Crate, version and call.
    fn name(&self) -> &str;
    /// Does the whole workload once.
    fn run(&mut self);
    /// What the last run answered, one for each item, in order.
    fn answers(&self) -> Vec<Answer>;
}

/// Calls a function for each item of a workload and keeps what it returns.
pub struct Each<Input, Output, Call, Read> {
    name: &'static str,
    inputs: Vec<Input>,
    outputs: Vec<Output>,
    call: Call,
    read: Read,
}

impl<Input, Output, Call, Read> Each<Input, Output, Call, Read> {
    /// `call` is timed; `read` translates what it returned.
    pub fn new<Answer>(name: &'static str, inputs: Vec<Input>, call: Call, read: Read) -> Self
    where
        Call: Fn(&Input) -> Output,
        Read: Fn(&Output) -> Answer,
    {
        let outputs = Vec::with_capacity(inputs.len());
        Self { name, inputs, outputs, call, read }
    }
}

impl<Input, Output, Call, Read, Answer> Contender<Answer> for Each<Input, Output, Call, Read>
where
    Call: Fn(&Input) -> Output,
    Read: Fn(&Output) -> Answer,
{
    fn name(&self) -> &str {
        self.name
    }

    fn run(&mut self) {
        self.outputs.clear();
        self.outputs.extend(self.inputs.iter().map(&self.call));
    }

    fn answers(&self) -> Vec<Answer> {
        self.outputs.iter().map(&self.read).collect()
    }
}

/// Nanoseconds an item: the median over the rounds, and the quartiles around it.
#[derive(Clone, Copy)]
pub struct Time {
    pub median: f64,
    pub quartiles: [f64; 2],
}

/// Runs all contenders round by round; `items` is what a time is divided by.
pub fn race<A>(contenders: &mut [Box<dyn Contender<A>>], items: usize, rounds: usize) -> Vec<Time> {
    let mut times = vec![Vec::with_capacity(rounds); contenders.len()];
    // The first round warms up: it is not counted.
    for round in 0..=rounds {
        for (contender, times) in contenders.iter_mut().zip(&mut times) {
            let start = ThreadTime::now();
            contender.run();
            let elapsed = start.elapsed();
            if round > 0 {
                times.push(elapsed.as_secs_f64() * 1e9 / items as f64);
            }
        }
    }
    times.into_iter().map(summary).collect()
}

fn summary(mut times: Vec<f64>) -> Time {
    times.sort_unstable_by(f64::total_cmp);
    let at = |part: f64| times[((times.len() - 1) as f64 * part).round() as usize];
    Time { median: at(0.5), quartiles: [at(0.25), at(0.75)] }
}

/// Prints a table: name, time, how many times faster than `reference`, and the counts of wrong answers.
pub fn print(title: &str, reference: &str, columns: &[&str], rows: &[(String, Time, Vec<usize>)]) {
    let yardstick =
        rows.iter().find(|(name, ..)| name.starts_with(reference)).map(|(_, time, _)| time.median);
    println!("\n{title}");
    print!("{:<40} {:>9} {:>17} {:>9}", "", "ns", "quartiles", "times");
    columns.iter().for_each(|column| print!(" {column:>9}"));
    println!();
    for (name, Time { median, quartiles: [low, high] }, counts) in rows {
        let ratio = yardstick.map_or(f64::NAN, |yardstick| yardstick / median);
        print!("{name:<40} {median:>9.2} {:>17} {ratio:>9.2}", format!("{low:.2} - {high:.2}"));
        counts.iter().for_each(|count| print!(" {count:>9}"));
        println!();
    }
}
