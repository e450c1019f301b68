//! What the divide makes of distance: device depth and 1/w against the distance from the camera.
//!
//! *Source:* Akenine-Moller et al., Real-Time Rendering, 4th ed. 2018, section 4.7.2, where the curve
//! of the perspective depth is drawn; 1/w beside it is ours, scaled to its value at the near plane.

use super::{Chain, Snapshot, Space};
use crate::{
    explain::{Label, Mark, Role},
    transform::DepthRange,
};

/// Pieces of a curve.
const PIECES: usize = 64;
/// A vertex farther away than so many times the far plane does not stretch the picture.
const FARTHEST: f64 = 2.0;

/// Device depth as a function of the distance from the camera, along its line of sight.
#[derive(Clone, Copy, Debug)]
struct Depth {
    /// z and w of clip space at distance d are `z[0] d + z[1]` and `w[0] d + w[1]`.
    z: [f64; 2],
    w: [f64; 2],
    /// From NDC to what is drawn.
    viewport: fn(f64) -> f64,
    /// The visible depths as drawn.
    range: [f64; 2],
}

impl Depth {
    fn new(chain: &Chain, space: Space) -> Self {
        let p = chain.projection.map(f64::from);
        let (viewport, range): (fn(f64) -> f64, _) = match (chain.viewport.depth_range, space) {
            (DepthRange::ZeroToOne, _) => (|z| z, [0.0, 1.0]),
            (DepthRange::MinusOneToOne, Space::Screen) => (|z| (z + 1.0) / 2.0, [0.0, 1.0]),
            (DepthRange::MinusOneToOne, _) => (|z| z, [-1.0, 1.0]),
        };
        Self { z: [-p[10], p[14]], w: [-p[11], p[15]], viewport, range }
    }

    fn w(&self, d: f64) -> f64 {
        self.w[0] * d + self.w[1]
    }

    fn at(&self, d: f64) -> f64 {
        (self.viewport)((self.z[0] * d + self.z[1]) / self.w(d))
    }

    /// The distances at which the visible depths begin and end: those of the near and far plane.
    fn planes(&self, lowest: f64) -> Option<[f64; 2]> {
        let distance = |z: f64| (self.z[1] - z * self.w[1]) / (z * self.w[0] - self.z[0]);
        let (a, b) = (distance(lowest), distance(1.0));
        let [near, far] = [a.min(b), a.max(b)];
        (near > 0.0 && far.is_finite() && near < far).then_some([near, far])
    }
}

/// Where a plot lies in the picture.
struct Plot {
    min: [f64; 2],
    max: [f64; 2],
    /// The distance at the right border; 0 is at the left one.
    far: f64,
    range: [f64; 2],
}

impl Plot {
    /// `share` is 0 at the foot of the plot and 1 at its head.
    fn point(&self, d: f64, share: f64) -> [f32; 2] {
        let at = |low: f64, high: f64, t: f64| (low + t * (high - low)) as f32;
        [at(self.min[0], self.max[0], d / self.far), at(self.min[1], self.max[1], share)]
    }

    fn share(&self, z: f64) -> f64 {
        (z - self.range[0]) / (self.range[1] - self.range[0])
    }

    /// A curve over distances, as far as it stays in the plot.
    fn curve(&self, ends: [f64; 2], f: impl Fn(f64) -> f64, role: Role, label: Option<&str>) -> Option<Mark> {
        let at = |i: usize| {
            let t = i as f64 / PIECES as f64;
            // Both curves bend where it is near.
            ends[0] + (ends[1] - ends[0]) * t * t
        };
        let points =
            (0..=PIECES).map(at).map(|d| (d, f(d))).filter(|(_, share)| (-0.05..=1.1).contains(share));
        let points: Vec<_> = points.map(|(d, share)| self.point(d, share)).collect();
        (points.len() > 1).then(|| Mark::Curve { points, role, label: label.map(Label::name) })
    }
}

impl Snapshot {
    /// The curves in a square with this middle and half side; `false` if the camera has none.
    pub(super) fn curves(&self, space: Space, middle: [f32; 2], half: f32, out: &mut Vec<Mark>) -> bool {
        let depth = Depth::new(&self.chain, space);
        let lowest = if self.chain.viewport.depth_range == DepthRange::ZeroToOne { 0.0 } else { -1.0 };
        let Some([near, far]) = depth.planes(lowest) else { return false };
        let vertex = self.at(Space::View)[2].map(|z| -f64::from(z)).filter(|d| *d > 0.0);
        let reach = vertex.map_or(far, |d| d.clamp(far, FARTHEST * far));
        let [x, y, half] = [middle[0], middle[1], half].map(f64::from);
        let plot = Plot {
            min: [x - half + 0.6, y - half + 0.75],
            max: [x + half - 0.25, y + half - 0.45],
            far: reach * 1.04,
            range: depth.range,
        };
        self.frame(&plot, [near, far], out);
        let z = |d: f64| plot.share(depth.at(d));
        let reciprocal = |d: f64| depth.w(near) / depth.w(d);
        out.extend(plot.curve([near, far], reciprocal, Role::Exact, Some("1/w")));
        let name = if space == Space::Screen { "z‴" } else { "z″" };
        out.extend(plot.curve([near, far], z, Role::Neutral, Some(name)));
        // Beside the visible part the curve goes on, but nothing there is drawn.
        if let Some(d) = vertex {
            let beyond = if d < near { [d, near] } else { [far, d.min(reach)] };
            out.extend(plot.curve(beyond, z, Role::Candidate, None));
        }
        if let (Some(d), [_, _, Some(z), _]) = (vertex, self.at(space))
            && d <= reach
        {
            let at = plot.point(d, plot.share(f64::from(z)));
            let foot = plot.point(d, 0.0);
            if (plot.min[1]..=plot.max[1] + 0.4).contains(&f64::from(at[1])) {
                out.push(Mark::Segment { ends: [foot, at], role: Role::Candidate, label: None });
                let label = Some(Label::new(format!("P{} {name}", self.vertex + 1), z));
                out.push(Mark::Point { at, role: Role::Active, label });
            }
        }
        true
    }

    /// What is visible, the axes and their ends.
    fn frame(&self, plot: &Plot, [near, far]: [f64; 2], out: &mut Vec<Mark>) {
        let visible =
            [[near, 0.0], [far, 0.0], [far, 1.0], [near, 1.0]].map(|[d, share]| plot.point(d, share));
        let points = visible.to_vec();
        out.push(Mark::Polygon { points, role: Role::Skipped, object: None, label: None });
        let origin = plot.point(0.0, 0.0);
        for end in [plot.point(plot.far, 0.0), plot.point(0.0, 1.08)] {
            out.push(Mark::Segment { ends: [origin, end], role: Role::Neutral, label: None });
        }
        let mut write = |at: [f32; 2], label: Label| {
            out.push(Mark::Text { at, label, role: Role::Candidate, big: false });
        };
        for (share, value) in [(0.0, plot.range[0]), (1.0, plot.range[1])] {
            let [_, y] = plot.point(0.0, share);
            write([plot.min[0] as f32 - 0.5, y + 0.18], Label::new("", value));
        }
        let [x, y] = plot.point(near, 0.0);
        write([x - 0.1, y - 0.15], Label::new("near", near as f32));
        let [x, y] = plot.point(far, 0.0);
        write([x - 1.1, y - 0.15], Label::new("far", far as f32));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Draw, Geometry, Mesh, Scene};
    use std::sync::Arc;

    fn depth(range: DepthRange, reversed: bool) -> Depth {
        let mut scene = Scene::empty([8, 8]);
        (scene.depth_range, scene.reversed) = (range, reversed);
        (scene.camera.near, scene.camera.far) = (1.0, 10.0);
        let mesh = Mesh::soup(vec![[0.0; 3]; 3], [1.0; 4]);
        let draw = Draw::new("A", Geometry::Mesh(Arc::new(mesh)));
        Depth::new(&Chain::of(&scene, &draw), Space::Ndc)
    }

    #[test]
    fn the_planes_have_the_ends_of_the_range() {
        for (range, reversed, ends) in [
            (DepthRange::ZeroToOne, false, [0.0, 1.0]),
            (DepthRange::ZeroToOne, true, [1.0, 0.0]),
            (DepthRange::MinusOneToOne, false, [-1.0, 1.0]),
        ] {
            let depth = depth(range, reversed);
            let planes = depth.planes(f64::min(ends[0], ends[1])).expect("a camera");
            for (plane, expected) in planes.into_iter().zip([1.0, 10.0]) {
                assert!((plane - expected).abs() < 1e-5, "{range:?} {reversed}: {planes:?}");
            }
            for (d, expected) in planes.into_iter().zip(ends) {
                assert!((depth.at(d) - expected).abs() < 1e-6, "{range:?} {reversed}");
            }
            assert!((depth.w(4.0) - 4.0).abs() < 1e-9);
        }
    }
}
