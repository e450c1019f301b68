//! Cases on the screen: pixels, depths along a row, attributes at a point.

use super::{Drive, narrow};
use crate::{
    interpolate::Mode,
    labs::{AreaRatios, FillTriangle, Interpolation, PlaneEquation},
    raster::Algorithm,
    scene::Scene,
    stress::Family,
};

type Point = [f64; 2];

impl Drive {
    pub(super) fn pixels(&mut self, scene: &Scene) -> FillTriangle {
        let vertices = self.on_screen(scene, 24.0).map(|point| point.map(narrow));
        FillTriangle::of(Algorithm::Scanline, vertices)
    }

    /// A triangle in the scene's image; slivers get thinner by so many bits.
    fn on_screen(&mut self, scene: &Scene, thin: f64) -> [Point; 3] {
        let [width, height] = scene.size.map(f64::from);
        let mut points: [Point; 3] =
            std::array::from_fn(|_| [self.uniform(0.0, width), self.uniform(0.0, height)]);
        match self.family {
            Family::Beside => points = points.map(|point| point.map(|c| self.beside(c.floor() + 0.5))),
            // Along a diagonal through centres: elsewhere hardly one covers a pixel.
            Family::Sliver => {
                let by = self.shrunk(thin);
                let start = points[0].map(|c| (c / 2.0).floor() + 0.5);
                let length = (width.min(height) / 2.0).floor();
                let on = start.map(|c| c + 0.4 * length);
                let apex = [0, 1].map(|i| on[i] + (points[2][i] - on[i]) * by);
                points = [start, start.map(|c| c + length), apex];
            }
            // Two vertices far away, on a line through the image's corner; one stays.
            Family::Huge => {
                let by = self.grown(118.0);
                let back = self.uniform(0.5, 2.0);
                let away = [points[1][0] - width / 2.0, points[1][1] - height / 2.0].map(|c| c * by);
                points = [points[0], away, away.map(|c| -c * back)];
            }
            // A side through the image's corner and through centres, but for next to nothing.
            Family::Denormal => {
                let by = 1.0 / self.grown(140.0);
                let far = self.uniform(0.5, 1.0) * width.min(height);
                points[0] = [self.uniform(-1.0, 1.0) * by, self.uniform(-1.0, 1.0) * by];
                points[1] = [far, far];
            }
            // A side that passes by a centre every few rows; the longer it is, the oftener the slope is added.
            Family::Long => {
                let start = points[0].map(|c| (c / 4.0).floor() + 0.5);
                let rows = self.random.pick(&[3.0, 5.0, 6.0, 7.0]);
                let columns = (self.uniform(0.2, 0.9) * rows).ceil();
                let room = ((width - start[0]) / columns).min((height - start[1]) / rows);
                let times = (room * (0.2 + 0.8 * self.far)).floor().max(1.0);
                let by = self.uniform(-0.4, 0.4) * self.shrunk(22.0);
                let left = start[0] + by;
                points[..2]
                    .copy_from_slice(&[[left, start[1]], [left + times * columns, start[1] + times * rows]]);
            }
            _ => {}
        }
        points
    }

    /// A triangle with w and an attribute, and a point of it.
    pub(super) fn at_point(&mut self, scene: &Scene) -> AreaRatios {
        AreaRatios(self.weighed(scene))
    }

    fn weighed(&mut self, scene: &Scene) -> Interpolation {
        let corners = self.on_screen(scene, 17.0);
        let [a, b, c] = corners;
        let mut w = [0, 1, 2].map(|_| self.uniform(0.5, 9.0));
        let (k, mut l) = (self.uniform(0.1, 0.5), self.uniform(0.1, 0.5));
        match self.family {
            // One vertex before the eye and one behind it: what they say of 1/w nearly cancels.
            Family::NearWZero => {
                let by = self.shrunk(26.0);
                w[0] *= by;
                w[1] = -w[0] * k / (1.0 - k - l) * (1.0 + 0.8 * by);
            }
            Family::Beside => l *= self.shrunk(30.0),
            _ => {}
        }
        let mut at = [0, 1].map(|i| match self.family {
            // All between the near vertex and the image's corner is inside.
            Family::Huge => k * a[i],
            _ => (1.0 - k - l) * a[i] + k * b[i] + l * c[i],
        });
        if self.family == Family::Beside {
            at = at.map(|c| self.beside(c));
        }
        let attribute = std::array::from_fn(|_| self.uniform(0.0, 1.0));
        interpolation(corners, w, attribute, at)
    }

    /// A triangle with depths, and the row of pixels that they are wanted for.
    pub(super) fn row(&mut self, scene: &Scene) -> PlaneEquation {
        let [width, height] = scene.size.map(f64::from);
        let row = self.uniform(1.0, height - 1.0).floor() + 0.5;
        let [left, mut right] = [self.uniform(0.1, 0.4), width - self.uniform(0.1, 0.4)];
        let mut depths = [0, 1, 2].map(|_| self.uniform(0.5, 1.0));
        let [up, down] = [0, 1].map(|_| self.uniform(0.5, 3.0));
        let corners = match self.family {
            // The plane is seen edge-on, along the row.
            Family::Sliver => {
                let by = self.shrunk(17.0);
                let turn = self.uniform(-1.0, 1.0);
                [[left, row - by * up], [right, row + by * turn], [right / 2.0, row + by * down]]
            }
            // Depths fall to next to nothing along the row, and the roundings of the large sums stay.
            Family::Long => {
                right = (width * (0.2 + 0.8 * self.far)).floor().max(3.0) - 0.49;
                depths[1] *= self.shrunk(16.0);
                [[left, row - up], [right, row], [left, row + down]]
            }
            _ => return PlaneEquation(Interpolation { mode: Mode::Affine, ..self.weighed(scene) }),
        };
        let at = [right / 2.0, row];
        PlaneEquation(Interpolation { mode: Mode::Affine, ..interpolation(corners, [1.0; 3], depths, at) })
    }
}

fn interpolation(corners: [Point; 3], w: [f64; 3], attribute: [f64; 3], at: Point) -> Interpolation {
    let vertex = |i: usize| [corners[i][0], corners[i][1], w[i]].map(narrow);
    Interpolation {
        vertices: [vertex(0), vertex(1), vertex(2)],
        attribute: attribute.map(narrow),
        at: at.map(narrow),
        mode: Mode::Perspective,
        arithmetic: Default::default(),
    }
}
