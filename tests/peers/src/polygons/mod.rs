//! Closed polygons against a rectangle: three sizes.

mod oracle;
mod workload;

use crate::{
    lines::Sides,
    measure::{Contender, print, race},
    peers,
};

/// Binary32 corners.
pub type Polygon = Vec<[f32; 2]>;

/// The pieces that are left, each a closed list of corners; binary32 is exact in it.
pub type Answer = Vec<Vec<[f64; 2]>>;

const WINDOW: Sides = [-3.1, -2.2, 4.7, 3.3];

/// One size after the other, all contenders in each.
pub fn run(rounds: usize) {
    for size in workload::SIZES {
        let polygons = workload::polygons(size, WINDOW);
        let expected: Vec<_> = polygons.iter().map(|polygon| oracle::clip(polygon, WINDOW)).collect();
        let mut contenders: Vec<Box<dyn Contender<Answer>>> = Vec::new();
        peers::polygons(&polygons, WINDOW, &mut contenders);
        let times = race(&mut contenders, size.corners * size.count, rounds);
        let rows: Vec<_> = contenders
            .iter()
            .zip(times)
            .map(|(contender, time)| {
                let answers = contender.answers();
                assert_eq!(answers.len(), size.count, "{}", contender.name());
                (contender.name().to_string(), time, oracle::count(&answers, &expected, WINDOW))
            })
            .collect();
        let left = expected.iter().filter(|left| !left.corners.is_empty()).count();
        let title =
            format!("polygons, {}: {} of them, {left} visible; ns a given corner", size.name, size.count);
        print(&title, "line-clipping", &oracle::COLUMNS, &rows);
    }
}
