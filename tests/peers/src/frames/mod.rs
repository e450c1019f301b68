//! Whole frames of triangles with depth: time, and pixels that are not the exact ones.

mod oracle;
mod workload;

use crate::{
    measure::{Contender, race},
    peers,
};
use oracle::Wrong;
use std::rc::Rc;
pub use workload::Soup;

/// Pixels a side.
pub const SIZE: usize = 1024;

/// Clears, then draws a soup: nearer triangles win, each in its own colour, which is not 0.
pub trait Painter {
    /// Crate and version.
    fn name(&self) -> &'static str;
    /// Whether it keeps a depth; else the last triangle wins.
    fn has_depth(&self) -> bool {
        true
    }
    /// Takes a soup in the form it likes.
    fn take(&mut self, soup: &Soup);
    /// Draws it.
    fn draw(&mut self);
    /// The colour of each pixel, row by row; 0 where nothing was drawn.
    fn colors(&self) -> Vec<u32>;
}

struct Frame(Box<dyn Painter>);

impl Contender<()> for Frame {
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

/// All workloads, all painters in each; then one table.
pub fn run(rounds: usize) {
    let makers = peers::painters();
    let names: Vec<_> = makers.iter().map(|make| make().name()).collect();
    let mut times = vec![Vec::new(); makers.len()];
    for workload in workload::ALL {
        let soup = Rc::new(workload.soup());
        let mut contenders: Vec<Box<dyn Contender<()>>> = Vec::new();
        for make in &makers {
            let mut painter = make();
            painter.take(&soup);
            contenders.push(Box::new(Frame(painter)));
        }
        let measured = race(&mut contenders, 1_000_000, rounds);
        times.iter_mut().zip(measured).for_each(|(times, time)| times.push(time));
    }
    let wrong: Vec<Wrong> = makers.iter().map(|make| oracle::examine(&mut *make())).collect();
    println!("\nframes of {SIZE} x {SIZE}: ms a frame, median (and first quartile) of {rounds} rounds");
    print!("{:<44}", "");
    workload::ALL.iter().for_each(|workload| print!(" {:>15}", workload.name));
    println!(" {:>9} {:>7} {:>7}", "wrong ppm", "holes", "doubles");
    for ((name, times), wrong) in names.iter().zip(&times).zip(&wrong) {
        print!("{name:<44}");
        times
            .iter()
            .for_each(|time| print!(" {:>15}", format!("{:.1} ({:.1})", time.median, time.quartiles[0])));
        println!(" {:>9.0} {:>7} {:>7}", wrong.ppm(), wrong.holes, wrong.doubles);
    }
    // Against the best of the others that keep a depth.
    let ours = |name: &str| name.starts_with("rasterscope");
    let depth: Vec<_> = makers.iter().map(|make| make().has_depth()).collect();
    for (index, name) in names.iter().enumerate().filter(|(_, name)| ours(name)) {
        print!("{:<44}", format!("times faster: {name}"));
        for column in 0..workload::ALL.len() {
            let others = (0..names.len()).filter(|&other| depth[other] && !ours(names[other]));
            let best = others.map(|other| times[other][column].median).fold(f64::INFINITY, f64::min);
            print!(" {:>15.1}", best / times[index][column].median);
        }
        println!();
    }
}
