//! Meshes through the whole pipeline, from vertices in object space to colours and depths: back faces culled, a colour
//! a vertex interpolated, nearer ones win.

mod model;
mod oracle;

use crate::{
    painter::{Row, contest, print},
    peers,
};
pub use model::{Sight, VIEWS};

/// Width and height in pixels.
pub const SIZE: [usize; 2] = [1280, 720];

/// The models in these OBJ files, or a torus if there are none; all painters draw each; then one table.
pub fn run(rounds: usize, files: &[String]) -> Result<(), String> {
    let makers = peers::mesh_painters();
    let models = if files.is_empty() { vec![model::torus()] } else { model::read(files)? };
    let mut times = vec![Vec::new(); makers.len()];
    for (_, sight) in &models {
        let measured = contest(&makers, sight, VIEWS, rounds);
        times.iter_mut().zip(measured).for_each(|(times, time)| times.push(time));
    }
    let mut rows = Vec::new();
    for (make, times) in makers.iter().zip(times) {
        let mut found = oracle::Found::default();
        models.iter().for_each(|(_, sight)| found.examine(&mut *make(), sight));
        rows.push(Row::new(&*make(), times, found.counts()));
    }
    let [width, height] = SIZE;
    let title = format!(
        "meshes at {width} x {height}: frames a second (ms a frame), median of {rounds} rounds of {VIEWS} views"
    );
    let names: Vec<_> = models.iter().map(|(name, _)| name.as_str()).collect();
    let show = |time: &crate::measure::Time| format!("{:.1} ({:.2})", 1e3 / time.median, time.median);
    print(&title, &names, &oracle::Found::HEADINGS, show, &rows);
    Ok(())
}
