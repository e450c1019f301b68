//! Where a plane lies on the canvas: scale, offset and the direction of y.

use rasterscope_core::explain::{Grid, View};

/// Room for the rulers at the left and upper side of a pixel grid, in points.
pub const RULER: f64 = 34.0;

/// Room at the foot of a pixel grid, for its legend and for what is read there, in points.
pub const FOOT: f64 = 22.0;

/// A map between scene units and points (y down), without rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Points per scene unit, positive.
    pub scale: f64,
    /// Where the scene's origin lies, in points.
    pub offset: [f64; 2],
    /// Whether larger scene y is higher on the screen.
    pub y_up: bool,
}

impl Placement {
    /// Shows all of `view` in the middle of a canvas of `size`, `inset` points from its sides.
    ///
    /// Pixel grids get room for their rulers, for a line at their foot and, from four points a pixel on, a whole number of
    /// points for each. A view without extent, or not finite, is shown as one unit.
    pub fn fit(view: &View, size: [f32; 2], inset: f32) -> Self {
        let pixels = view.grid == Grid::Pixels;
        let first = f64::from(inset) + if pixels { RULER } else { 0.0 };
        let last = [0.0, if pixels { FOOT } else { 0.0 }];
        let room =
            [0, 1].map(|axis| (f64::from(size[axis]) - first - f64::from(inset) - last[axis]).max(1.0));
        let span = [0, 1].map(|axis| {
            let span = f64::from(view.max[axis]) - f64::from(view.min[axis]);
            if span.is_finite() && span > 0.0 { span } else { 1.0 }
        });
        let mut scale = (room[0] / span[0]).min(room[1] / span[1]);
        if pixels && scale >= 4.0 {
            scale = scale.floor();
        }
        let middle = [0, 1].map(|axis| {
            let middle = (f64::from(view.min[axis]) + f64::from(view.max[axis])) / 2.0;
            if middle.is_finite() { middle } else { 0.0 }
        });
        let flip = if view.y_up { -1.0 } else { 1.0 };
        let mut offset =
            [first + room[0] / 2.0 - middle[0] * scale, first + room[1] / 2.0 - flip * middle[1] * scale];
        if pixels {
            offset = offset.map(f64::round);
        }
        Self { scale, offset, y_up: view.y_up }
    }

    /// From scene units to points.
    pub fn to_points(&self, p: [f32; 2]) -> [f32; 2] {
        self.wide(p.map(f64::from)).map(|c| c as f32)
    }

    /// From points to scene units.
    pub fn to_scene(&self, p: [f32; 2]) -> [f32; 2] {
        let x = (f64::from(p[0]) - self.offset[0]) / self.scale;
        let y = (f64::from(p[1]) - self.offset[1]) / self.scale;
        [x as f32, if self.y_up { -y as f32 } else { y as f32 }]
    }

    /// [`to_points`](Self::to_points) without rounding; never overflows for binary32 coordinates.
    pub fn wide(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = if self.y_up { -y } else { y };
        [x * self.scale + self.offset[0], y * self.scale + self.offset[1]]
    }

    /// `factor` times larger, with the scene point under `about` (in points) held in place.
    ///
    /// The scale stays between 1e-40 and 1e9 points per unit.
    #[must_use]
    pub fn zoom(self, factor: f32, about: [f32; 2]) -> Self {
        let scale = (self.scale * f64::from(factor)).clamp(1e-40, 1e9);
        let factor = scale / self.scale;
        let offset = [0, 1].map(|axis| {
            let about = f64::from(about[axis]);
            about + (self.offset[axis] - about) * factor
        });
        Self { scale, offset, ..self }
    }

    /// Moved by `by` points.
    #[must_use]
    pub fn pan(self, by: [f32; 2]) -> Self {
        let offset = [self.offset[0] + f64::from(by[0]), self.offset[1] + f64::from(by[1])];
        Self { offset, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn view(grid: Grid, y_up: bool) -> View {
        View { min: [-1.0, -2.0], max: [11.0, 6.0], y_up, grid }
    }

    #[test]
    fn the_whole_view_is_on_the_canvas() {
        for grid in [Grid::None, Grid::Units, Grid::Pixels] {
            for y_up in [false, true] {
                let view = view(grid, y_up);
                let placement = Placement::fit(&view, [692.0, 576.0], 10.0);
                for corner in [view.min, view.max] {
                    let [x, y] = placement.to_points(corner);
                    let first = if grid == Grid::Pixels { 10.0 + RULER as f32 - 1.0 } else { 9.99 };
                    assert!((first..=682.01).contains(&x) && (first..=566.01).contains(&y), "{x} {y}");
                }
            }
        }
    }

    #[test]
    fn y_up_is_up() {
        let placement = Placement::fit(&view(Grid::Units, true), [100.0, 100.0], 0.0);
        assert!(placement.to_points([0.0, 1.0])[1] < placement.to_points([0.0, 0.0])[1]);
    }

    #[test]
    fn points_lead_back_to_the_scene() {
        let placement = Placement::fit(&view(Grid::Pixels, true), [300.0, 200.0], 8.0).pan([7.0, -3.0]);
        let [x, y] = placement.to_scene(placement.to_points([2.5, 0.25]));
        assert!((x - 2.5).abs() < 1e-5 && (y - 0.25).abs() < 1e-5);
    }

    #[test]
    fn zooming_holds_the_point_under_the_cursor() {
        let placement = Placement::fit(&view(Grid::Units, false), [300.0, 200.0], 8.0);
        let about = placement.to_points([3.0, 1.0]);
        let zoomed = placement.zoom(2.0, about);
        let [x, y] = zoomed.to_points([3.0, 1.0]);
        assert!((x - about[0]).abs() < 1e-3 && (y - about[1]).abs() < 1e-3);
        assert_eq!(zoomed.scale, 2.0 * placement.scale);
    }

    #[test]
    fn views_without_extent_and_views_of_everything_have_a_placement() {
        for (min, max) in [
            ([3.0, 3.0], [3.0, 3.0]),
            ([f32::MIN; 2], [f32::MAX; 2]),
            ([f32::NAN; 2], [f32::INFINITY; 2]),
            ([1e-40, 0.0], [2e-40, 1e-40]),
        ] {
            let placement =
                Placement::fit(&View { min, max, y_up: true, grid: Grid::Units }, [400.0, 300.0], 10.0);
            assert!(placement.scale > 0.0 && placement.scale.is_finite());
            assert!(placement.offset.iter().all(|c| c.is_finite()));
        }
    }
}
