//! Where the vertex is: the space it has come to, from the front and from the side, under a strip of
//! all spaces.

use super::{
    Chain, Path, Snapshot, Space,
    explain::{NAMES, word},
};
use crate::{
    clip::line::{Window, cohen_sutherland},
    explain::{Grid, Label, Mark, Role, View},
    message::Value,
    raster::YAxis,
    transform::{
        DepthRange, Matrix,
        frustum::{FRUSTUM_EDGES, frustum_corners},
    },
};
use glam::DMat4;

/// All of the picture: the strip above, two squares below.
pub(super) const VIEW: View = View { min: [-6.2, -3.8], max: [6.2, 5.6], y_up: true, grid: Grid::None };

/// Half the side of a square, and the height of its middle.
const HALF: f32 = 2.9;
const MIDDLE: [[f32; 2]; 2] = [[-3.15, -0.75], [3.15, -0.75]];
/// Half the side of a picture of the strip, the height of their middles, and their distance.
const SMALL: f32 = 0.92;
const STRIP: f32 = 4.55;
const APART: f32 = 2.06;

/// The part of a space that a square shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    middle: [f64; 2],
    half: [f64; 2],
}

impl Frame {
    /// What each space is shown of, from the front and from the side: the visible box, the vertices
    /// and the origin.
    pub(super) fn all(chain: &Chain, paths: &[Path]) -> [[Self; 2]; 6] {
        Space::ALL.map(|space| {
            let mut points: Vec<[f32; 4]> = paths.iter().map(|path| path[space as usize]).collect();
            points.extend(landmarks(chain, space, &points));
            [0, 1].map(|side| {
                let flat = points.iter().map(|&p| flat(space, side, p).map(f64::from));
                let pick = |pick: fn(f64, f64) -> f64| {
                    flat.clone().reduce(|a, b| [pick(a[0], b[0]), pick(a[1], b[1])]).unwrap_or_default()
                };
                let (low, high) = (pick(f64::min), pick(f64::max));
                let half = [0, 1].map(|axis| ((high[axis] - low[axis]) * 0.5 * 1.16).max(1e-6));
                let widest = half[0].max(half[1]);
                // Depth and pixels have no common unit.
                let own = space == Space::Screen && side == 1;
                Self {
                    middle: [0, 1].map(|axis| (high[axis] + low[axis]) / 2.0),
                    half: if own { half } else { [widest; 2] },
                }
            })
        })
    }
}

/// What a picture of a space shows besides the vertices, so that it keeps its place.
fn landmarks(chain: &Chain, space: Space, vertices: &[[f32; 4]]) -> Vec<[f32; 4]> {
    let origin = [0.0, 0.0, 0.0, 1.0];
    let low = lowest(chain);
    let corners =
        |low: [f32; 3], high: [f32; 3]| [[low[0], low[1], low[2], 1.0], [high[0], high[1], high[2], 1.0]];
    match space {
        Space::Object => vec![origin, [1.0, 1.0, 1.0, 1.0], [-1.0, -1.0, -1.0, 1.0]],
        Space::World | Space::View => {
            let [x, y, z] = eye(chain, space);
            let mut points = vec![origin, [x, y, z, 1.0]];
            let reach = vertices.iter().map(|v| distance([v[0], v[1], v[2]], [x, y, z])).fold(0.0, f32::max);
            for [near, far] in sides(chain, space) {
                // A far plane that is very far would make all else small.
                let share = (1.4 * reach / distance(near, far).max(1e-6)).clamp(0.0, 1.0);
                let on = [0, 1, 2].map(|axis| near[axis] + share * (far[axis] - near[axis]));
                points.extend([[near[0], near[1], near[2], 1.0], [on[0], on[1], on[2], 1.0]]);
            }
            points
        }
        Space::Clip => {
            let reach = |v: &[f32; 4]| v[0].abs().max(v[1].abs()).max(0.8 * v[3].abs()).max(1.2);
            let reach = vertices.iter().map(reach).fold(1.2, f32::max);
            vec![[-reach, -reach, 0.0, -0.15 * reach], [reach, reach, 0.0, 1.2]]
        }
        Space::Ndc => corners([-1.0, -1.0, low], [1.0; 3]).to_vec(),
        Space::Screen => {
            let [width, height] = chain.viewport.size.map(|n| n as f32);
            corners([0.0; 3], [width, height, 1.0]).to_vec()
        }
    }
}

/// A point of a space as seen from the front (0) or from the side (1); in clip space x and y over w.
fn flat(space: Space, side: usize, [x, y, z, w]: [f32; 4]) -> [f32; 2] {
    match (space, side) {
        (Space::Clip, 0) => [x, w],
        (Space::Clip, _) => [y, w],
        (_, 0) => [x, y],
        (Space::Ndc | Space::Screen, _) => [z, y],
        // The camera looks along -z: to the right.
        _ => [-z, y],
    }
}

fn distance(a: [f32; 3], b: [f32; 3]) -> f32 {
    [0, 1, 2].map(|axis| (a[axis] - b[axis]).abs()).into_iter().fold(0.0, f32::max)
}

/// The smallest visible depth in NDC.
fn lowest(chain: &Chain) -> f32 {
    if chain.viewport.depth_range == DepthRange::ZeroToOne { 0.0 } else { -1.0 }
}

fn wide(matrix: &Matrix) -> DMat4 {
    DMat4::from_cols_array(&matrix.map(f64::from))
}

/// The eye in world or camera space.
fn eye(chain: &Chain, space: Space) -> [f32; 3] {
    let at = wide(&chain.view).inverse().w_axis.truncate();
    if space == Space::World && at.is_finite() { at.as_vec3().to_array() } else { [0.0; 3] }
}

/// The corners of what is visible, in world or camera space.
fn corners(chain: &Chain, space: Space) -> Option<[[f32; 3]; 8]> {
    let projection = wide(&chain.projection);
    let product = if space == Space::World { projection * wide(&chain.view) } else { projection };
    frustum_corners(&product.to_cols_array().map(|c| c as f32), lowest(chain))
}

/// The four edges from the near to the far plane.
fn sides(chain: &Chain, space: Space) -> impl Iterator<Item = [[f32; 3]; 2]> {
    let corners = corners(chain, space);
    (0..4).filter_map(move |i| corners.map(|corners| [corners[i], corners[i + 4]]))
}

/// A square of the picture, and what it shows.
struct Square {
    space: Space,
    side: usize,
    frame: Frame,
    middle: [f32; 2],
    half: f32,
    down: bool,
}

impl Square {
    /// Where a point of its space lies in the picture.
    fn place(&self, p: [f32; 4]) -> [f32; 2] {
        let p = flat(self.space, self.side, p);
        [0, 1].map(|axis| {
            let away = (f64::from(p[axis]) - self.frame.middle[axis]) / self.frame.half[axis];
            let away = if axis == 1 && self.down { -away } else { away };
            self.middle[axis] + (away * f64::from(self.half)) as f32
        })
    }

    fn corners(&self) -> [[f32; 2]; 4] {
        let ([x, y], h) = (self.middle, self.half);
        [[x - h, y - h], [x + h, y - h], [x + h, y + h], [x - h, y + h]]
    }

    fn contains(&self, at: [f32; 2]) -> bool {
        (0..2).all(|axis| (at[axis] - self.middle[axis]).abs() <= self.half)
    }

    /// The part of a segment in the square.
    fn segment(&self, ends: [[f32; 4]; 2], role: Role, label: Option<Label>, out: &mut Vec<Mark>) {
        let [[xmin, ymin], _, [xmax, ymax], _] = self.corners();
        let window = Window { xmin, ymin, xmax, ymax };
        if let Some(ends) = cohen_sutherland::clip(ends.map(|end| self.place(end)), &window) {
            out.push(Mark::Segment { ends, role, label });
        }
    }

    /// What is visible of the space.
    fn visible(&self, chain: &Chain, out: &mut Vec<Mark>) {
        let polygon = |points: Vec<[f32; 4]>| Mark::Polygon {
            points: points.into_iter().map(|p| self.place(p)).collect(),
            role: Role::Neutral,
            object: None,
            label: None,
        };
        match self.space {
            Space::Object => {}
            Space::World | Space::View => {
                let Some(corners) = corners(chain, self.space) else { return };
                let corners = corners.map(|[x, y, z]| [x, y, z, 1.0]);
                for [a, b] in FRUSTUM_EDGES {
                    let role = if a < 4 && b < 4 { Role::Neutral } else { Role::Candidate };
                    self.segment([corners[a], corners[b]], role, None, out);
                }
            }
            Space::Clip => {
                // Visible is -w <= x <= w: a wedge that begins in the eye.
                let high = (self.frame.middle[1] + self.frame.half[1]) as f32;
                let wide = self.frame.half[0] as f32;
                let at = |x: f32, w: f32| [x, x, 0.0, w];
                let reach = wide.min(high);
                let mut wedge = vec![at(0.0, 0.0), at(reach, reach)];
                if high > wide {
                    wedge.extend([at(wide, high), at(-wide, high)]);
                }
                wedge.push(at(-reach, reach));
                out.push(polygon(wedge));
            }
            Space::Ndc => out.push(polygon(self.rectangle([-1.0, -1.0, lowest(chain)], [1.0; 3]))),
            Space::Screen => {
                let [width, height] = chain.viewport.size.map(|n| n as f32);
                out.push(polygon(self.rectangle([0.0; 3], [width, height, 1.0])));
            }
        }
    }

    fn rectangle(&self, low: [f32; 3], high: [f32; 3]) -> Vec<[f32; 4]> {
        let across = if self.side == 0 { 0 } else { 2 };
        [[low[across], low[1]], [high[across], low[1]], [high[across], high[1]], [low[across], high[1]]]
            .map(|[a, y]| [a, y, a, 1.0])
            .to_vec()
    }
}

impl Snapshot {
    /// The strip of all spaces, and the one that the vertex has come to.
    pub(super) fn picture(&self, out: &mut Vec<Mark>) {
        for space in Space::ALL {
            self.small(space, out);
        }
        let reached = |space: &Space| self.at(*space).iter().all(Option::is_some);
        let space = Space::ALL.into_iter().rfind(reached).unwrap_or(Space::Object);
        for side in [0, 1] {
            let plotted = side == 1 && matches!(space, Space::Ndc | Space::Screen);
            if plotted && self.curves(space, MIDDLE[side], HALF, out) {
                let at = [MIDDLE[side][0] - HALF - 0.2, MIDDLE[side][1] + HALF + 0.5];
                let label = Label::new("", Value::Word("transform-depth-against-distance"));
                out.push(Mark::Text { at, label, role: Role::Neutral, big: false });
                continue;
            }
            let square = self.square(space, side, MIDDLE[side], HALF);
            let corners = square.corners();
            let title = match (side, space) {
                (0, _) => word(space),
                (_, Space::Clip) => Value::Word("transform-other-axis"),
                _ => Value::Word("transform-from-the-side"),
            };
            let at = [corners[3][0] - 0.2, corners[3][1] + 0.5];
            out.push(Mark::Text { at, label: Label::new("", title), role: Role::Neutral, big: false });
            let points = corners.to_vec();
            out.push(Mark::Polygon { points, role: Role::Skipped, object: None, label: None });
            square.visible(&self.chain, out);
            self.axes(&square, out);
            self.sight(&square, out);
            self.point(&square, out);
        }
    }

    fn square(&self, space: Space, side: usize, middle: [f32; 2], half: f32) -> Square {
        let down = space == Space::Screen && self.chain.viewport.y_axis == YAxis::Down;
        Square { space, side, frame: self.frames[space as usize][side], middle, half, down }
    }

    /// One picture of the strip.
    fn small(&self, space: Space, out: &mut Vec<Mark>) {
        let middle = [(space as usize as f32 - 2.5) * APART, STRIP];
        let square = self.square(space, 0, middle, SMALL);
        let corners = square.corners();
        out.push(Mark::Polygon { points: corners.to_vec(), role: Role::Skipped, object: None, label: None });
        if !matches!(space, Space::World | Space::View) {
            square.visible(&self.chain, out);
        }
        let role = if space == self.to { Role::Active } else { Role::Neutral };
        let label = Label::new("", Value::text(NAMES[space as usize]));
        out.push(Mark::Text { at: [corners[0][0] - 0.2, corners[0][1]], label, role, big: false });
        if let [Some(x), Some(y), Some(z), Some(w)] = self.at(space) {
            let lost = space >= Space::Clip && !self.is_visible();
            let role = if lost { Role::Rejected } else { Role::Accepted };
            out.push(Mark::Point { at: square.place([x, y, z, w]), role, label: None });
        }
    }

    /// The origin of a space and its axes.
    fn axes(&self, square: &Square, out: &mut Vec<Mark>) {
        let names = match (square.space, square.side) {
            (Space::Clip, 0) => ["x", "w"],
            (Space::Clip, _) => ["y", "w"],
            (_, 0) => ["x", "y"],
            (Space::Ndc | Space::Screen, _) => ["z", "y"],
            _ => ["−z", "y"],
        };
        for (axis, name) in names.into_iter().enumerate() {
            let length = (square.frame.half[axis] * 0.22) as f32;
            let tip = match (square.space, axis) {
                (Space::Clip, 1) => [0.0, 0.0, 0.0, length],
                (Space::Clip, _) => [length, length, 0.0, 0.0],
                (_, 1) => [0.0, length, 0.0, 1.0],
                (Space::Ndc | Space::Screen, _) => [length, 0.0, length, 1.0],
                _ => [length, 0.0, -length, 1.0],
            };
            let origin = if square.space == Space::Clip { [0.0; 4] } else { [0.0, 0.0, 0.0, 1.0] };
            square.segment([origin, tip], Role::Neutral, None, out);
            let at = square.place(tip);
            if !square.contains(at) {
                continue;
            }
            let at = [at[0] - if axis == 1 { 0.08 } else { 0.2 }, at[1] + if axis == 1 { 0.3 } else { 0.0 }];
            out.push(Mark::Text { at, label: Label::name(name), role: Role::Candidate, big: false });
        }
        if matches!(square.space, Space::World | Space::View) {
            let [x, y, z] = eye(&self.chain, square.space);
            let label = Some(Label::new("", Value::Word("transform-eye")));
            out.push(Mark::Point { at: square.place([x, y, z, 1.0]), role: Role::Neutral, label });
        }
    }

    /// The line of sight; in clip space it meets w = 1 where the divide puts the vertex.
    fn sight(&self, square: &Square, out: &mut Vec<Mark>) {
        let [Some(x), Some(y), Some(z), Some(w)] = self.at(square.space) else { return };
        match square.space {
            Space::World | Space::View => {
                let [ex, ey, ez] = eye(&self.chain, square.space);
                square.segment([[ex, ey, ez, 1.0], [x, y, z, 1.0]], Role::Candidate, None, out);
            }
            Space::Clip => {
                let far = 4.0 * square.frame.half[0] as f32;
                let level = |w: f32| [[-far, -far, 0.0, w], [far, far, 0.0, w]];
                for (height, name) in [(0.0, "w = 0"), (1.0, "w = 1")] {
                    square.segment(level(height), Role::Candidate, Some(Label::name(name)), out);
                }
                if w == 0.0 {
                    return;
                }
                let divided = [x / w, y / w, 0.0, 1.0];
                let role = if w > 0.0 { Role::Candidate } else { Role::Rejected };
                // From the eye, or right through it, to the farther of both.
                let ends = match w {
                    ..0.0 => [[x, y, z, w], divided],
                    ..1.0 => [[0.0; 4], divided],
                    _ => [[0.0; 4], [x, y, z, w]],
                };
                square.segment(ends, role, None, out);
                let at = square.place(divided);
                if square.contains(at) {
                    let name = ["x / w", "y / w"][square.side];
                    out.push(Mark::Point { at, role, label: Some(Label::name(name)) });
                }
            }
            Space::Object | Space::Ndc | Space::Screen => {}
        }
    }

    fn point(&self, square: &Square, out: &mut Vec<Mark>) {
        let name = format!("P{}", self.vertex + 1);
        let (at, role) = match self.at(square.space) {
            [Some(x), Some(y), Some(z), Some(w)] => ([x, y, z, w], Role::Active),
            _ => {
                let Some(&[x, y, z]) = self.vertices.get(self.vertex) else { return };
                ([x, y, z, 1.0], Role::Candidate)
            }
        };
        // The numbers that the square shows; the table has all of them.
        let label = match (square.side, square.space) {
            (0, _) | (_, Space::Clip) => Label::new(name, flat(square.space, square.side, at)),
            _ => Label::new(format!("{name} z"), at[2]),
        };
        out.push(Mark::Point { at: square.place(at), role, label: Some(label) });
    }
}
