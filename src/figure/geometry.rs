//! Small plane geometry of drawings: clipping to the canvas, hatching, triangulating.
//!
//! Coordinates are points, y down, in binary64, so that scene coordinates of any size can be mapped
//! before they are clipped. These are drawing aids: what a lab *says* about geometry comes from the
//! core's exact algorithms.

/// A rectangle with sides along the axes; `min <= max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Upper left corner.
    pub min: [f64; 2],
    /// Lower right corner.
    pub max: [f64; 2],
}

impl Rect {
    /// The rectangle of that size around a point.
    pub fn around(center: [f64; 2], size: [f64; 2]) -> Self {
        let half = size.map(|extent| extent / 2.0);
        Self {
            min: [center[0] - half[0], center[1] - half[1]],
            max: [center[0] + half[0], center[1] + half[1]],
        }
    }

    /// Larger by `by` on every side.
    #[must_use]
    pub fn grown(self, by: f64) -> Self {
        Self { min: self.min.map(|c| c - by), max: self.max.map(|c| c + by) }
    }

    /// Moved.
    #[must_use]
    pub fn shifted(self, by: [f64; 2]) -> Self {
        Self {
            min: [self.min[0] + by[0], self.min[1] + by[1]],
            max: [self.max[0] + by[0], self.max[1] + by[1]],
        }
    }

    /// The point in the middle.
    pub fn center(self) -> [f64; 2] {
        [(self.min[0] + self.max[0]) / 2.0, (self.min[1] + self.max[1]) / 2.0]
    }

    /// Whether the closed rectangle contains `p`.
    pub fn contains(self, p: [f64; 2]) -> bool {
        (0..2).all(|axis| self.min[axis] <= p[axis] && p[axis] <= self.max[axis])
    }

    /// Whether it lies in `outer`.
    pub fn inside(self, outer: Self) -> bool {
        outer.contains(self.min) && outer.contains(self.max)
    }

    /// Whether the insides overlap.
    pub fn overlaps(self, other: Self) -> bool {
        (0..2).all(|axis| self.min[axis] < other.max[axis] && other.min[axis] < self.max[axis])
    }

    /// The part of the segment `ends` inside; well-conditioned however far the ends are off.
    pub fn clip(self, mut ends: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
        for (axis, border, sign) in self.borders() {
            let outside = ends.map(|p| sign * (p[axis] - border) < 0.0);
            match outside {
                [true, true] => return None,
                [false, false] => {}
                _ => ends[usize::from(outside[1])] = crossing(ends, axis, border),
            }
        }
        Some(ends)
    }

    /// The part of a polygon inside; bridging edges of a concave one run along the border.
    ///
    /// *Source:* Sutherland and Hodgman 1974.
    pub fn clip_polygon(self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut points = points.to_vec();
        for (axis, border, sign) in self.borders() {
            let inside = |p: [f64; 2]| sign * (p[axis] - border) >= 0.0;
            let mut kept = Vec::with_capacity(points.len() + 4);
            for (i, &to) in points.iter().enumerate() {
                let from = points[(i + points.len() - 1) % points.len()];
                if inside(from) != inside(to) {
                    kept.push(crossing([from, to], axis, border));
                }
                if inside(to) {
                    kept.push(to);
                }
            }
            points = kept;
        }
        points
    }

    /// Axis, coordinate, and the sign of the inward direction.
    fn borders(self) -> [(usize, f64, f64); 4] {
        [(0, self.min[0], 1.0), (0, self.max[0], -1.0), (1, self.min[1], 1.0), (1, self.max[1], -1.0)]
    }
}

/// Where a segment whose ends lie on both sides of a border crosses it.
fn crossing([a, b]: [[f64; 2]; 2], axis: usize, border: f64) -> [f64; 2] {
    // Both weights have one sign, so the sum cannot cancel more than the ends themselves.
    let (to_a, to_b) = (border - a[axis], b[axis] - border);
    let other = 1 - axis;
    let mut point = [border; 2];
    point[other] = (a[other] * to_b + b[other] * to_a) / (to_a + to_b);
    point
}

/// The point at `t` between `a` (0) and `b` (1).
pub fn mix(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]
}

/// Distance between two points.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    (dx * dx + dy * dy).sqrt()
}

/// Segments at 45 degrees, rising to the right, `step` apart, inside a polygon by the even-odd rule.
///
/// The lines are those of one grid over the whole plane, so the hatches of neighbours join.
pub fn hatch(points: &[[f64; 2]], step: f64) -> Vec<[[f64; 2]; 2]> {
    // Along a hatch line x + y is constant.
    let level = |p: [f64; 2]| p[0] + p[1];
    let gap = step * std::f64::consts::SQRT_2;
    let lowest = points.iter().copied().map(level).fold(f64::INFINITY, f64::min);
    let highest = points.iter().copied().map(level).fold(f64::NEG_INFINITY, f64::max);
    let mut segments = Vec::new();
    let mut line = (lowest / gap).ceil();
    while line * gap < highest {
        let at = line * gap;
        let mut crossings: Vec<f64> = edges(points)
            .filter(|&[a, b]| (level(a) <= at) != (level(b) <= at))
            .map(|[a, b]| mix(a, b, (at - level(a)) / (level(b) - level(a)))[0])
            .collect();
        crossings.sort_by(f64::total_cmp);
        segments.extend(crossings.chunks_exact(2).map(|x| [[x[0], at - x[0]], [x[1], at - x[1]]]));
        line += 1.0;
    }
    segments
}

/// The sides of a polygon.
pub fn edges(points: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}

/// Centre of mass of a polygon; the mean of its corners if it has no area.
pub fn centroid(points: &[[f64; 2]]) -> [f64; 2] {
    let count = points.len().max(1) as f64;
    let mean = points.iter().fold([0.0, 0.0], |sum, p| [sum[0] + p[0] / count, sum[1] + p[1] / count]);
    let (mut area, mut sum) = (0.0, [0.0, 0.0]);
    for [a, b] in edges(points) {
        let (a, b) = ([a[0] - mean[0], a[1] - mean[1]], [b[0] - mean[0], b[1] - mean[1]]);
        let cross = a[0] * b[1] - a[1] * b[0];
        area += cross;
        sum = [sum[0] + cross * (a[0] + b[0]), sum[1] + cross * (a[1] + b[1])];
    }
    if area.abs() < 1e-9 {
        return mean;
    }
    [mean[0] + sum[0] / (3.0 * area), mean[1] + sum[1] / (3.0 * area)]
}

/// Triangles, as indices into `points`, that together cover a simple polygon in either direction.
///
/// For windows that can only paint triangles; O(n²). A polygon that crosses itself gives some
/// covering without a panic.
///
/// *Source:* ear clipping, after Meisters 1975.
pub fn triangulate(points: &[[f32; 2]]) -> Vec<[u32; 3]> {
    let wide: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
    let cross =
        |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    let area: f64 = edges(&wide).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum();
    let turn = if area < 0.0 { -1.0 } else { 1.0 };
    let mut left: Vec<usize> = (0..points.len()).collect();
    let mut triangles = Vec::with_capacity(points.len().saturating_sub(2));
    while left.len() > 3 {
        let n = left.len();
        let corner = |i: usize| [left[(i + n - 1) % n], left[i], left[(i + 1) % n]];
        let is_ear = |i: usize| {
            let [a, b, c] = corner(i).map(|index| wide[index]);
            turn * cross(a, b, c) > 0.0
                && !left.iter().map(|&index| wide[index]).any(|p| {
                    p != a
                        && p != b
                        && p != c
                        && [[a, b], [b, c], [c, a]].iter().all(|&[from, to]| turn * cross(from, to, p) >= 0.0)
                })
        };
        // A corner without area is no ear, but it can go; so can any corner of a crossing polygon.
        let flat = |i: usize| {
            let [a, b, c] = corner(i).map(|index| wide[index]);
            cross(a, b, c) == 0.0
        };
        let ear = (0..n).find(|&i| is_ear(i)).or_else(|| (0..n).find(|&i| flat(i))).unwrap_or(0);
        if !flat(ear) {
            triangles.push(corner(ear).map(|index| index as u32));
        }
        left.remove(ear);
    }
    if let [a, b, c] = left[..] {
        triangles.push([a, b, c].map(|index| index as u32));
    }
    triangles
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNIT: Rect = Rect { min: [0.0, 0.0], max: [10.0, 10.0] };
    const ARROW: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 5.0], [0.0, 10.0], [4.0, 5.0]];

    fn area(points: &[[f64; 2]]) -> f64 {
        edges(points).map(|[a, b]| a[0] * b[1] - a[1] * b[0]).sum::<f64>() / 2.0
    }

    #[test]
    fn segments_are_clipped_however_far_they_reach() {
        assert_eq!(UNIT.clip([[-1e30, 5.0], [1e30, 5.0]]), Some([[0.0, 5.0], [10.0, 5.0]]));
        assert_eq!(UNIT.clip([[-5.0, 0.0], [15.0, 20.0]]), Some([[0.0, 5.0], [5.0, 10.0]]));
        assert_eq!(UNIT.clip([[-5.0, 20.0], [15.0, 20.0]]), None);
        assert_eq!(UNIT.clip([[-5.0, 6.0], [6.0, 17.0]]), None);
        assert_eq!(UNIT.clip([[5.0, 5.0], [5.0, 5.0]]), Some([[5.0, 5.0]; 2]));
    }

    #[test]
    fn clipped_polygons_stay_inside_and_keep_their_area() {
        let square = [[-5.0, -5.0], [5.0, -5.0], [5.0, 5.0], [-5.0, 5.0]];
        let clipped = UNIT.clip_polygon(&square);
        assert!(clipped.iter().all(|&p| UNIT.contains(p)));
        assert_eq!(area(&clipped), 25.0);
        assert!(UNIT.clip_polygon(&[[20.0, 0.0], [30.0, 0.0], [20.0, 9.0]]).is_empty());
    }

    #[test]
    fn hatch_stays_inside_a_concave_polygon() {
        let lines = hatch(&ARROW, 1.0);
        assert!(lines.len() > 8);
        for [a, b] in lines {
            assert!((a[0] + a[1] - b[0] - b[1]).abs() < 1e-9);
            let [x, y] = mix(a, b, 0.5);
            let notch = 4.0 - (y - 5.0).abs() * 0.8;
            assert!(x >= notch - 1e-9, "({x}, {y}) lies in the notch");
        }
    }

    #[test]
    fn triangles_cover_a_concave_polygon_exactly() {
        for reversed in [false, true] {
            let mut points = ARROW.map(|p| p.map(|c| c as f32)).to_vec();
            if reversed {
                points.reverse();
            }
            let triangles = triangulate(&points);
            assert_eq!(triangles.len(), 2);
            let sum: f64 = triangles
                .iter()
                .map(|t| area(&t.map(|index| points[index as usize].map(f64::from))).abs())
                .sum();
            assert_eq!(sum, area(&ARROW).abs());
        }
    }

    #[test]
    fn triangulating_anything_ends() {
        let bow_tie = [[0.0, 0.0], [4.0, 4.0], [4.0, 0.0], [0.0, 4.0]];
        assert!(!triangulate(&bow_tie).is_empty());
        assert!(triangulate(&[[1.0, 1.0]; 5]).len() <= 1);
        assert!(triangulate(&[]).is_empty());
        assert!(triangulate(&[[f32::NAN; 2]; 6]).len() <= 4);
    }

    #[test]
    fn centroid_of_a_triangle_is_its_mean_and_of_a_point_itself() {
        let [x, y] = centroid(&[[0.0, 0.0], [6.0, 0.0], [0.0, 3.0]]);
        assert!((x - 2.0).abs() < 1e-12 && (y - 1.0).abs() < 1e-12);
        assert_eq!(centroid(&[[3.0, 4.0]; 3]), [3.0, 4.0]);
    }
}
