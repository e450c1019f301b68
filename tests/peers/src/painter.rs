//! Who draws whole images, in turns; and the table of what came out.

use crate::measure::{Contender, Time, race};

/// Clears an image, then draws on it what it took.
pub trait Painter<Task> {
    /// Crate and version.
    fn name(&self) -> &'static str;
    /// Whether it keeps a depth; else the last triangle wins.
    fn has_depth(&self) -> bool {
        true
    }
    /// Takes a task in the form it likes.
    fn take(&mut self, task: &Task);
    /// Does it.
    fn draw(&mut self);
    /// The colour of each pixel of the last image, row by row; 0 where nothing was drawn.
    fn colors(&self) -> Vec<u32>;
}

/// Makes one painter anew.
pub type Maker<Task> = Box<dyn Fn() -> Box<dyn Painter<Task>>>;

struct Turn<Task>(Box<dyn Painter<Task>>);

impl<Task> Contender<()> for Turn<Task> {
    fn name(&self) -> &str {
        self.0.name()
    }

    fn run(&mut self) {
        self.0.draw();
    }

    fn answers(&self) -> Vec<()> {
        Vec::new()
    }
}

/// Milliseconds an image: all painters do the same task, which draws so many, in turns.
pub fn contest<Task: 'static>(
    makers: &[Maker<Task>],
    task: &Task,
    images: usize,
    rounds: usize,
) -> Vec<Time> {
    let mut turns: Vec<Box<dyn Contender<()>>> = Vec::new();
    for make in makers {
        let mut painter = make();
        painter.take(task);
        turns.push(Box::new(Turn(painter)));
    }
    race(&mut turns, 1_000_000 * images, rounds)
}

/// What came out for one painter.
pub struct Row {
    name: &'static str,
    has_depth: bool,
    /// One for each task.
    times: Vec<Time>,
    /// Counts of what is wrong.
    counts: Vec<String>,
}

impl Row {
    pub fn new<Task>(painter: &dyn Painter<Task>, times: Vec<Time>, counts: Vec<String>) -> Self {
        Self { name: painter.name(), has_depth: painter.has_depth(), times, counts }
    }

    fn is_ours(&self) -> bool {
        self.name.starts_with("rasterscope")
    }
}

/// Prints a row for each painter, then how many times faster ours are than the best other that keeps a depth.
pub fn print(title: &str, tasks: &[&str], counts: &[&str], show: fn(&Time) -> String, rows: &[Row]) {
    println!("\n{title}");
    print!("{:<44}", "");
    tasks.iter().for_each(|task| print!(" {task:>15}"));
    counts.iter().for_each(|count| print!(" {count:>9}"));
    println!();
    for Row { name, times, counts, .. } in rows {
        print!("{name:<44}");
        times.iter().for_each(|time| print!(" {:>15}", show(time)));
        counts.iter().for_each(|count| print!(" {count:>9}"));
        println!();
    }
    for row in rows.iter().filter(|row| row.is_ours()) {
        print!("{:<44}", format!("times faster: {}", row.name));
        for (task, time) in row.times.iter().enumerate() {
            let others = rows.iter().filter(|other| other.has_depth && !other.is_ours());
            let best = others.map(|other| other.times[task].median).fold(f64::INFINITY, f64::min);
            print!(" {:>15.2}", best / time.median);
        }
        println!();
    }
}
