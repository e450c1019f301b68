//! Where the names of points stand: beside them, and on nothing else.

use super::Spot;
use crate::geometry::Rect;

/// Between a marker and its name.
const GAP: f64 = 10.0;

/// What is taken.
pub(super) struct Labels {
    area: Rect,
    taken: Vec<Rect>,
}

impl Labels {
    pub(super) fn new(area: Rect) -> Self {
        Self { area, taken: Vec::new() }
    }

    /// Nothing is written there.
    pub(super) fn keep_clear(&mut self, min: [f32; 2], max: [f32; 2]) {
        self.taken.push(Rect { min: min.map(f64::from), max: max.map(f64::from) });
    }

    /// Nothing is written on the markers.
    pub(super) fn avoid(&mut self, spots: &[Spot], radius: f32) {
        for Spot { at: [x, y], .. } in spots {
            self.keep_clear([x - radius, y - radius], [x + radius, y + radius]);
        }
    }

    /// The place for a text of that size on a line at that height: as far to the right as it is free,
    /// or at the end over what is there; its upper left corner.
    pub(super) fn above(&mut self, [left, right]: [f32; 2], y: f32, [width, height]: [f32; 2]) -> [f32; 2] {
        let end = right - 4.0 - width;
        let rect = |x: f32| {
            let (min, max) = ([x - 3.0, y - height], [x + width + 3.0, y]);
            Rect { min: min.map(f64::from), max: max.map(f64::from) }
        };
        let places = (0..).map(|step| end - 4.0 * step as f32).take_while(|x| *x > left + 3.0);
        let free = |x: &f32| !self.taken.iter().any(|taken| taken.overlaps(rect(*x)));
        let x = places.into_iter().find(free).unwrap_or(end);
        self.taken.push(rect(x));
        [x, y - height]
    }

    /// A place for a text of that size beside a point, if there is one; its upper left corner.
    pub(super) fn place(&mut self, at: [f32; 2], size: [f32; 2]) -> Option<[f32; 2]> {
        let [x, y] = at.map(f64::from);
        let [width, height] = size.map(f64::from);
        let reach = [GAP + width / 2.0, GAP + height / 2.0];
        // Right, left, above, below, then the corners.
        let sides = [
            [1.0, 0.0],
            [-1.0, 0.0],
            [0.0, -1.0],
            [0.0, 1.0],
            [0.9, -0.7],
            [0.9, 0.7],
            [-0.9, -0.7],
            [-0.9, 0.7],
        ];
        let rects =
            sides.map(|[dx, dy]| Rect::around([x + dx * reach[0], y + dy * reach[1]], [width, height]));
        let free =
            |rect: &Rect| rect.inside(self.area) && !self.taken.iter().any(|taken| taken.overlaps(*rect));
        let rect = rects.into_iter().find(free)?;
        self.taken.push(rect.grown(2.0));
        Some(rect.min.map(|c| c as f32))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_keep_clear_of_points_and_of_each_other() {
        let mut labels = Labels::new(Rect { min: [0.0; 2], max: [200.0, 100.0] });
        let spots = [[50.0, 50.0], [70.0, 50.0]].map(|at| Spot { at, point: [0, 0] });
        labels.avoid(&spots, 6.0);
        let size = [40.0, 12.0];
        let [first, second] = spots.map(|spot| labels.place(spot.at, size).expect("there is room"));
        assert!(first[0] + size[0] < 50.0, "to the left, for the right is taken: {first:?}");
        assert!(second[0] > 70.0, "to the right: {second:?}");
        assert_eq!(labels.place([50.0, 50.0], [400.0, 12.0]), None);
    }
}
