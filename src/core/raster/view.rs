//! What part of the image a lab shows.

use super::{Settings, YAxis};
use crate::explain::{Grid, View};

/// Images up to this many pixels a side are shown whole.
const WHOLE: u32 = 24;

/// The whole image if it is small, else the pixels around the triangles, with a margin of one.
pub(crate) fn view_of(triangles: &[[[f32; 2]; 3]], settings: &Settings) -> View {
    let mut view =
        View { min: [0.0; 2], max: [0.0; 2], y_up: settings.y_axis == YAxis::Up, grid: Grid::Pixels };
    for axis in 0..2 {
        let size = settings.size[axis] as f32;
        let values = triangles.iter().flatten().map(|vertex| vertex[axis]);
        let least = values.clone().fold(f32::INFINITY, f32::min).floor() - 1.0;
        let greatest = values.fold(f32::NEG_INFINITY, f32::max).ceil() + 1.0;
        let (low, high) = (least.max(0.0), greatest.min(size));
        let whole = settings.size[axis] <= WHOLE || low >= high;
        (view.min[axis], view.max[axis]) = if whole { (0.0, size) } else { (low, high) };
    }
    view
}
