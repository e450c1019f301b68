//! Segments against a rectangle: four mixes, eight ways to clip them.

mod oracle;
mod workload;

use crate::{
    measure::{Contender, print, race},
    peers,
};
use workload::Mix;

/// Binary32 ends.
pub type Segment = [[f32; 2]; 2];

/// `[xmin, ymin, xmax, ymax]`.
pub type Sides = [f32; 4];

/// What is visible, in the order given; binary32 is exact in it.
pub type Answer = Option<[[f64; 2]; 2]>;

const WINDOW: Sides = [-3.1, -2.2, 4.7, 3.3];
const COUNT: usize = 16_384;

/// One mix after the other, all contenders in each.
pub fn run(rounds: usize) {
    for mix in Mix::ALL {
        let segments = workload::segments(mix, WINDOW, COUNT);
        let expected: Vec<_> = segments.iter().map(|&segment| oracle::visible(segment, WINDOW)).collect();
        let mut contenders: Vec<Box<dyn Contender<Answer>>> = Vec::new();
        peers::lines(&segments, WINDOW, &mut contenders);
        let times = race(&mut contenders, COUNT, rounds);
        let rows: Vec<_> = contenders
            .iter()
            .zip(times)
            .map(|(contender, time)| {
                let answers = contender.answers();
                assert_eq!(answers.len(), COUNT, "{}", contender.name());
                (contender.name().to_string(), time, oracle::count(&answers, &expected, WINDOW))
            })
            .collect();
        let visible = expected.iter().flatten().count();
        let title = format!("lines, {}: {COUNT} segments, {visible} visible; ns a segment", mix.name());
        print(&title, "line-clipping", &oracle::COLUMNS, &rows);
    }
}
