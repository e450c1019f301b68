//! Pictures of the stages before the screen: the scene seen from outside, and planes of its spaces.

use glam::{DMat4, DVec4};
use rasterscope_core::{
    explain::{Grid, Label, Mark, Role, View},
    pipeline::{DrawOutputs, Fate, Point},
    scene::Shade,
};
use rasterscope_figure::orbit::Orbit;

use super::{
    paint::{PAINTED, Paint, Plane, orbit_camera, to_picture},
    picture::Drawing,
    subject::Subject,
};

/// What the pictures take of coordinates: far away ones would make all others a dot.
const REACH: f32 = 4.0;

/// The plane of a painted picture.
fn painted() -> View {
    View { min: [0.0, 0.0], max: PAINTED.map(|side| side as f32), y_up: false, grid: Grid::None }
}

fn drawing(marks: Vec<Mark>, caption: &'static str) -> Drawing {
    Drawing { marks, view: painted(), caption, painted: true }
}

fn line(ends: [[f32; 2]; 2], role: Role) -> Mark {
    Mark::Segment { ends, role, label: None }
}

fn named(at: [f32; 2], name: impl Into<String>) -> Mark {
    Mark::Point { at, role: Role::Neutral, label: Some(Label::name(name)) }
}

/// A camera outside that sees the objects, and the eye with its frustum if `with_eye`.
fn orbit(subject: &Subject<'_>, with_eye: bool) -> Orbit {
    let eye = subject.scene.camera.eye;
    let limit = REACH * subject.scene.camera.far.min(1e18);
    let near = |p: &[f32; 3]| (0..3).all(|c| (p[c] - eye[c]).abs() <= limit);
    let mut points: Vec<_> = subject.world().flat_map(|(.., corners)| corners).filter(near).collect();
    if with_eye || points.is_empty() {
        points.push(eye);
        points.extend(subject.window(subject.depth_shown()));
    }
    let [_, _, back] = subject.axes();
    let yaw = libm::atan2f(back[0], back[2]) + if with_eye { 1.0 } else { 0.5 };
    Orbit::framing(&points, yaw, 0.4)
}

/// The edges of the frustum, and the eye.
fn frustum(subject: &Subject<'_>, orbit: &Orbit, marks: &mut Vec<Mark>) {
    let (near, far) = (subject.window(subject.scene.camera.near), subject.window(subject.depth_shown()));
    let mut edge = |a: [f32; 3], b: [f32; 3], role: Role| {
        marks.extend(orbit.segment(a, b).map(|ends| line(ends.map(to_picture), role)));
    };
    for i in 0..4 {
        let next = (i + 1) % 4;
        edge(near[i], far[i], Role::Neutral);
        edge(near[i], near[next], Role::Neutral);
        edge(far[i], far[next], Role::Neutral);
    }
    let eye = subject.scene.camera.eye;
    marks.extend(orbit.project(eye).map(|at| named(to_picture(at), "eye")));
}

/// The scene and its camera.
pub(super) fn scene(subject: &Subject<'_>) -> Drawing {
    let orbit = orbit(subject, true);
    let mut paint = Paint::default();
    subject.world().for_each(|(draw, _, corners)| paint.triangle(corners, subject.color(draw)));
    let mut marks = vec![paint.seen(orbit_camera(&orbit), Shade::Flat, subject.theme)];
    frustum(subject, &orbit, &mut marks);
    drawing(marks, "tour-picture-scene")
}

/// The objects in world space, with its axes.
pub(super) fn model(subject: &Subject<'_>) -> Drawing {
    let orbit = orbit(subject, false);
    let mut paint = Paint::default();
    subject.world().for_each(|(draw, _, corners)| paint.triangle(corners, subject.color(draw)));
    let mut marks = vec![paint.seen(orbit_camera(&orbit), Shade::Flat, subject.theme)];
    let length = orbit.distance * 0.2;
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        let mut end = [0.0; 3];
        end[axis] = length;
        if let Some(ends) = orbit.segment([0.0; 3], end) {
            marks.push(Mark::Segment {
                ends: ends.map(to_picture),
                role: Role::Exact,
                label: Some(Label::name(name)),
            });
        }
    }
    if subject.is_named() {
        for (index, draw) in subject.outputs.draws.iter().enumerate() {
            for (i, &[x, y, z, _]) in draw.world().iter().enumerate() {
                let name = format!("{}{i}", subject.name(index));
                marks.extend(orbit.project([x, y, z]).map(|at| named(to_picture(at), name)));
            }
        }
    }
    drawing(marks, "tour-picture-model")
}

/// Smallest and largest of the points that are not too far away, `(0, 0)` included.
fn bounds(points: impl Iterator<Item = [f32; 2]>, limit: f32) -> [[f32; 2]; 2] {
    let mut bounds = [[0.0_f32; 2]; 2];
    for p in points.filter(|p| p.iter().all(|c| c.abs() <= limit)) {
        for axis in 0..2 {
            bounds[0][axis] = bounds[0][axis].min(p[axis]);
            bounds[1][axis] = bounds[1][axis].max(p[axis]);
        }
    }
    bounds
}

/// Paints all triangles of points that `flat` lays into a plane, its third number towards the
/// reader.
fn flat(
    subject: &Subject<'_>,
    points: fn(&DrawOutputs) -> &[Point],
    flat: impl Fn(Point) -> [f32; 3],
) -> Paint {
    let mut paint = Paint::default();
    for (index, draw) in subject.outputs.draws.iter().enumerate() {
        let points = points(draw);
        if points.is_empty() {
            continue;
        }
        for triangle in &draw.mesh().triangles {
            paint.triangle(triangle.map(|i| flat(points[i as usize])), subject.color(index));
        }
    }
    paint
}

/// Camera space from the side: the line of sight to the right, y up.
pub(super) fn view(subject: &Subject<'_>) -> Drawing {
    let camera = &subject.scene.camera;
    let (shown, limit) = (subject.depth_shown(), REACH * camera.far.min(1e18));
    let all = || subject.outputs.draws.iter().flat_map(DrawOutputs::view);
    let [min, max] = bounds(all().map(|p| [-p[2], p[1]]).chain([[shown, 0.0]]), limit);
    let half = subject.half_extent(shown)[1].min((max[1] - min[1]).max(shown * 0.2));
    let reach = all().map(|p| p[0].abs()).filter(|x| *x <= limit).fold(1.0, f32::max);
    let plane = Plane::around([min[0], min[1].min(-half)], [max[0], max[1].max(half)], reach);
    let paint = flat(subject, |draw| draw.view(), |[x, y, z, _]| [-z, y, x]);
    let mut marks = vec![paint.seen(plane.camera(), Shade::Flat, subject.theme)];
    let at = |p: [f32; 2]| plane.to_picture(p);
    let [near, far] = [camera.near, shown].map(|d| (d, subject.half_extent(d)[1]));
    for side in [1.0, -1.0] {
        marks.push(line([at([near.0, side * near.1]), at([far.0, side * far.1])], Role::Neutral));
        marks.push(line([at([0.0, 0.0]), at([near.0, side * near.1])], Role::Candidate));
    }
    for (name, (d, half), whole) in [("near", near, true), ("far", far, shown >= camera.far)] {
        if whole {
            let label = Some(Label::new(name, d));
            marks.push(Mark::Segment { ends: [at([d, -half]), at([d, half])], role: Role::Neutral, label });
        }
    }
    marks.push(named(at([0.0, 0.0]), "eye"));
    drawing(marks, "tour-picture-view")
}

/// Clip space: x to the right, w up; visible is what lies between `x = -w` and `x = w`.
pub(super) fn clip_space(subject: &Subject<'_>) -> Drawing {
    let limit = REACH * subject.scene.camera.far.min(1e18);
    let all = || subject.outputs.draws.iter().flat_map(DrawOutputs::clip);
    let [min, max] = bounds(all().map(|p| [p[0], p[3]]).chain([[0.0, 1.0]]), limit);
    let top = max[1];
    let reach = all().map(|p| p[1].abs()).filter(|y| *y <= limit).fold(1.0, f32::max);
    let plane = Plane::around([min[0].min(-top), min[1]], [max[0].max(top), top], reach);
    let paint = flat(subject, |draw| draw.clip(), |[x, y, _, w]| [x, w, y]);
    let mut marks = vec![paint.seen(plane.camera(), Shade::None, subject.theme)];
    let at = |p: [f32; 2]| plane.to_picture(p);
    for (name, x) in [("x = −w", -top), ("x = w", top)] {
        let label = Some(Label::name(name));
        marks.push(Mark::Segment { ends: [at([0.0, 0.0]), at([x, top])], role: Role::Neutral, label });
    }
    let [left, right] = [min[0].min(-top), max[0].max(top)].map(|x| at([x, 0.0]));
    marks.push(Mark::Segment {
        ends: [left, right],
        role: Role::Candidate,
        label: Some(Label::name("w = 0")),
    });
    drawing(marks, "tour-picture-clip-space")
}

/// The scene from outside, each triangle in the colour of what became of it.
pub(super) fn cull(subject: &Subject<'_>) -> Drawing {
    let orbit = orbit(subject, true);
    let mut paint = Paint::default();
    let dropped = subject.theme.style(Role::Rejected).color;
    for (draw, i, corners) in subject.world() {
        let kept = subject.fate(draw, i) != Some(Fate::Dropped);
        paint.triangle(corners, if kept { subject.color(draw) } else { dropped });
    }
    let mut marks = vec![paint.seen(orbit_camera(&orbit), Shade::Flat, subject.theme)];
    frustum(subject, &orbit, &mut marks);
    drawing(marks, "tour-picture-cull")
}

/// What clipping left, before what went in.
pub(super) fn clip(subject: &Subject<'_>) -> Drawing {
    let orbit = orbit(subject, true);
    let wide = |matrix: &[f32; 16]| DMat4::from_cols_array(&matrix.map(f64::from));
    let world_from_clip = (wide(&subject.outputs.projection) * wide(&subject.outputs.view)).inverse();
    let world_of = |p: Point| {
        let p = world_from_clip * DVec4::from_array(p.map(f64::from));
        (p.truncate() / p.w).as_vec3().to_array()
    };
    // In front of what went in, so that it covers that.
    let eye = orbit.eye();
    let nearer = |p: [f32; 3]| [0, 1, 2].map(|c| p[c] + (eye[c] - p[c]) * 0.004);
    let mut paint = Paint::default();
    let removed = subject.theme.style(Role::Rejected).color;
    for (draw, i, corners) in subject.world() {
        if subject.fate(draw, i).is_some_and(|fate| fate != Fate::Dropped) {
            paint.triangle(corners, removed);
        }
    }
    for (index, draw) in subject.outputs.draws.iter().enumerate() {
        let clipped = draw.clipped();
        for piece in &clipped.pieces {
            let corners = piece.corners.map(|i| nearer(world_of(clipped.corners[i as usize])));
            paint.triangle(corners, subject.color(index));
        }
    }
    let mut marks = vec![paint.seen(orbit_camera(&orbit), Shade::Flat, subject.theme)];
    frustum(subject, &orbit, &mut marks);
    drawing(marks, "tour-picture-clip")
}

/// NDC from the front: the square from -1 to 1.
pub(super) fn divide(subject: &Subject<'_>) -> Drawing {
    let plane = Plane::around([-1.0, -1.0], [1.0, 1.0], 2.0);
    let mut paint = Paint::default();
    for (index, draw) in subject.outputs.draws.iter().enumerate() {
        for piece in &draw.clipped().pieces {
            let corners = piece.corners.map(|i| {
                let [x, y, z, _] = draw.ndc()[i as usize];
                [x, y, if subject.scene.reversed { z } else { -z }]
            });
            paint.triangle(corners, subject.color(index));
        }
    }
    let mut marks = vec![paint.seen(plane.camera(), Shade::Flat, subject.theme)];
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    marks.push(Mark::Polygon {
        points: corners.map(|p| plane.to_picture(p)).to_vec(),
        role: Role::Neutral,
        object: None,
        label: None,
    });
    for p in [corners[0], corners[2]] {
        let label = Some(Label::new("", p));
        marks.push(Mark::Point { at: plane.to_picture(p), role: Role::Candidate, label });
    }
    drawing(marks, "tour-picture-divide")
}
