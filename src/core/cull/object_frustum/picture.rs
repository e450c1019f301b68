//! The objects and their bodies in the frustum, from outside.

use super::{
    super::{planes::Volume, sphere::Sphere},
    Event, Object, Snapshot,
};
use crate::{
    explain::{Label, Mark, Role, Solid, Vantage, box_corners},
    transform::{apply, frustum::FRUSTUM_FACES},
};

/// Of objects with more triangles only the body is drawn.
const MOST_TRIANGLES: usize = 600;

/// From so many triangles on their edges are faint.
const MANY_TRIANGLES: usize = 60;

/// Corners of the circles of a sphere that is not round in the world.
const CIRCLE: usize = 32;

fn place(object: &Object, [x, y, z]: [f32; 3]) -> [f32; 3] {
    let [x, y, z, _] = apply(&object.model, [x, y, z, 1.0]);
    [x, y, z]
}

/// The body's corners in world space: of a sphere those of the box around it.
fn corners(object: &Object) -> [[f32; 3]; 8] {
    let [min, max] = match object.volume {
        Volume::Box(bounds) => bounds,
        Volume::Sphere(Sphere { center, radius }) => [center.map(|c| c - radius), center.map(|c| c + radius)],
    };
    box_corners(min, max).map(|corner| place(object, corner))
}

/// Sees the frustum and all bodies.
pub(super) fn vantage(of: &Snapshot) -> Vantage {
    let mut points: Vec<[f32; 3]> = of.input.corners.into_iter().flatten().collect();
    points.extend(of.input.objects.iter().flat_map(corners));
    Vantage { points, yaw: 0.75, pitch: 0.4, axes: ["x", "y", "z"] }
}

pub(super) fn marks(of: &Snapshot, event: Option<&Event>, out: &mut Vec<Mark>) {
    if let Some(corners) = of.input.corners {
        out.push(Mark::Space(Solid::Body { corners, role: Role::Neutral, label: None }));
        if let Some(Event::Plane { plane, .. } | Event::Reject { plane, .. }) = event {
            let points = FRUSTUM_FACES[*plane as usize].map(|i| corners[i]).to_vec();
            out.push(Mark::Space(Solid::Polygon { points, role: Role::Active, object: None, label: None }));
        }
    }
    for (index, object) in of.input.objects.iter().enumerate() {
        let now = of.now == Some(index);
        let role = of.role(index);
        if object.world.len() <= MOST_TRIANGLES {
            triangles(of, index, object, out);
        }
        let label = Some(Label::name(object.name.clone()).of(index));
        body(object, if now { Role::Active } else { role }, label, out);
    }
}

/// The object's triangles: those known to be outside lie open.
fn triangles(of: &Snapshot, index: usize, object: &Object, out: &mut Vec<Mark>) {
    for (i, points) in object.world.iter().enumerate() {
        let lost = of.lost(index, i);
        let role = if of.triangle == Some((index, i)) {
            Role::Active
        } else if lost || object.world.len() >= MANY_TRIANGLES {
            Role::Skipped
        } else {
            Role::Candidate
        };
        let object = (!lost).then_some(index);
        out.push(Mark::Space(Solid::Polygon { points: points.to_vec(), role, object, label: None }));
    }
}

/// The body: a box by its edges, a sphere by its outline, or by three circles if the model stretches it.
fn body(object: &Object, role: Role, label: Option<Label>, out: &mut Vec<Mark>) {
    let Volume::Sphere(Sphere { center, radius }) = object.volume else {
        out.push(Mark::Space(Solid::Body { corners: corners(object), role, label }));
        return;
    };
    let middle = place(object, center);
    let axes = [0, 1, 2].map(|axis| {
        let mut tip = center;
        tip[axis] += radius;
        let tip = place(object, tip);
        [0, 1, 2].map(|i| tip[i] - middle[i])
    });
    let length = |v: [f32; 3]| v.iter().map(|c| c * c).sum::<f32>().sqrt();
    let lengths = axes.map(length);
    let longest = lengths[0].max(lengths[1]).max(lengths[2]);
    // To be drawn: a thousandth is not seen.
    if lengths.iter().all(|length| *length > 0.999 * longest) {
        out.push(Mark::Space(Solid::Sphere { center: middle, radius: longest, role, label }));
        return;
    }
    for (turn, [i, j]) in [[0, 1], [1, 2], [2, 0]].into_iter().enumerate() {
        let points = (0..CIRCLE).map(|k| {
            let angle = std::f32::consts::TAU * k as f32 / CIRCLE as f32;
            let (sin, cos) = libm::sincosf(angle);
            [0, 1, 2].map(|c| middle[c] + cos * axes[i][c] + sin * axes[j][c])
        });
        let label = label.clone().filter(|_| turn == 0);
        let points = points.collect();
        out.push(Mark::Space(Solid::Polygon { points, role, object: None, label }));
    }
}
