//! Whole frames of triangles with depth: time, and pixels that are not the exact ones.

mod oracle;
mod workload;

use crate::{
    painter::{Row, contest, print},
    peers,
};
pub use workload::Soup;

/// Pixels a side.
pub const SIZE: usize = 1024;

/// All workloads, all painters in each; then one table.
pub fn run(rounds: usize) {
    let makers = peers::painters();
    let mut times = vec![Vec::new(); makers.len()];
    for workload in workload::ALL {
        let measured = contest(&makers, &workload.soup(), 1, rounds);
        times.iter_mut().zip(measured).for_each(|(times, time)| times.push(time));
    }
    let mut rows = Vec::new();
    for (make, times) in makers.iter().zip(times) {
        let wrong = oracle::examine(&mut *make());
        let counts = vec![format!("{:.0}", wrong.ppm()), wrong.holes.to_string(), wrong.doubles.to_string()];
        rows.push(Row::new(&*make(), times, counts));
    }
    let title =
        format!("frames of {SIZE} x {SIZE}: ms a frame, median (and first quartile) of {rounds} rounds");
    let tasks = workload::ALL.map(|workload| workload.name);
    let show = |time: &crate::measure::Time| format!("{:.1} ({:.1})", time.median, time.quartiles[0]);
    print(&title, &tasks, &["wrong ppm", "holes", "doubles"], show, &rows);
}
