//! What part of the image a lab shows.

use super::{Settings, YAxis};
use crate::explain::{Grid, View};

/// Images up to this many pixels a side are shown whole.
const WHOLE: u32 = 24;

/// The whole image if it is small, else the pixels around the triangles, with a margin of one.
pub(crate) fn view_of(triangles: &[[[f32; 2]; 3]], settings: &Settings) -> View {
    view_around(triangles.iter().flatten().copied(), settings.size, settings.y_axis)
}

/// The whole image if it is small, else the pixels around some points, with a margin of one.
pub(crate) fn view_around(
    points: impl Iterator<Item = [f32; 2]> + Clone,
    size: [u32; 2],
    y_axis: YAxis,
) -> View {
    let mut view = View { min: [0.0; 2], max: [0.0; 2], y_up: y_axis == YAxis::Up, grid: Grid::Pixels };
    for (axis, pixels) in size.into_iter().enumerate() {
        let size = pixels as f32;
        let values = points.clone().map(|point| point[axis]);
        let least = values.clone().fold(f32::INFINITY, f32::min).floor() - 1.0;
        let greatest = values.fold(f32::NEG_INFINITY, f32::max).ceil() + 1.0;
        let (low, high) = (least.max(0.0), greatest.min(size));
        let whole = pixels <= WHOLE || low >= high;
        (view.min[axis], view.max[axis]) = if whole { (0.0, size) } else { (low, high) };
    }
    view
}
