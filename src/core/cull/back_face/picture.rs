//! The triangle and its object as the eye sees them, from outside: its normal, and the line of sight.

use super::{Snapshot, Test};
use crate::{
    cull::Facing,
    explain::{Label, Mark, Role, Solid, Vantage},
    message::Value,
};

/// The middle of a triangle.
fn middle([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    [0, 1, 2].map(|i| (f64::from(a[i]) + f64::from(b[i]) + f64::from(c[i])) as f32 / 3.0)
}

fn plus(a: [f32; 3], b: [f32; 3], share: f32) -> [f32; 3] {
    [0, 1, 2].map(|i| a[i] + share * b[i])
}

/// The unit normal in world space, times a length; zero for a triangle without area.
fn normal([a, b, c]: [[f32; 3]; 3], length: f32) -> [f32; 3] {
    let wide = |p: [f32; 3]| glam::DVec3::from_array(p.map(f64::from));
    let n = (wide(b) - wide(a)).cross(wide(c) - wide(a));
    (n.normalize_or_zero() * f64::from(length)).as_vec3().to_array()
}

/// The longest side of a triangle.
fn size(triangle: [[f32; 3]; 3]) -> f32 {
    let side =
        |i: usize, j: usize| (0..3).map(|k| (triangle[i][k] - triangle[j][k]).powi(2)).sum::<f32>().sqrt();
    side(0, 1).max(side(1, 2)).max(side(2, 0))
}

impl Snapshot {
    /// The triangle where it is drawn, and the eye: a point, or a point far away in its direction.
    fn seen(&self) -> ([[f32; 3]; 3], [f32; 3]) {
        let spaces = &self.input.spaces;
        let (_, [x, y, z, w], _) = spaces.eyes;
        let eye = if w == 0.0 {
            plus(middle(spaces.world), [x, y, z], 2.0 * size(spaces.world))
        } else {
            [x, y, z]
        };
        (spaces.world, eye)
    }
}

/// Sees the object and the eye.
pub(super) fn vantage(of: &Snapshot) -> Vantage {
    let (triangle, eye) = of.seen();
    let mut points = triangle.to_vec();
    points.extend(of.input.object.iter().flat_map(|(triangle, _)| *triangle));
    points.push(eye);
    let aside = [eye[0] - middle(triangle)[0], eye[2] - middle(triangle)[2]];
    // From the side of the line of sight, so that the angle between it and the normal is seen.
    let yaw = libm::atan2f(aside[0], aside[1]) + 1.0;
    Vantage { points, yaw, pitch: 0.35, axes: ["x", "y", "z"] }
}

pub(super) fn marks(of: &Snapshot, out: &mut Vec<Mark>) {
    let mut push = |solid| out.push(Mark::Space(solid));
    let (triangle, eye) = of.seen();
    // The others of the object: those that show their back lie open.
    for (points, facing) in of.input.object.iter() {
        let front = *facing == Facing::Front;
        let role = if front { Role::Candidate } else { Role::Skipped };
        let object = front.then_some(of.input.draw);
        push(Solid::Polygon { points: points.to_vec(), role, object, label: None });
    }
    let role = match of.fate {
        None => Role::Active,
        Some((_, true)) => Role::Rejected,
        Some((_, false)) => Role::Accepted,
    };
    let object = (role != Role::Rejected).then_some(of.input.draw);
    push(Solid::Polygon { points: triangle.to_vec(), role, object, label: None });
    for (at, name) in triangle.into_iter().zip(["p0", "p1", "p2"]) {
        push(Solid::Point { at, role: Role::Neutral, label: Some(Label::name(name)) });
    }
    let label = Label::new("", Value::Word("back-face-eye"));
    push(Solid::Point { at: eye, role: Role::Neutral, label: Some(label) });

    // What the test of this step looks at: a normal and the line of sight, or the image alone.
    let looks = !matches!(of.now, Some(Test::Ndc | Test::Screen));
    let from =
        if of.now == Some(Test::Determinant) || of.now.is_none() { middle(triangle) } else { triangle[0] };
    let role = if looks { Role::Exact } else { Role::Skipped };
    push(Solid::Segment { ends: [from, eye], role: Role::Candidate, label: None });
    let tip = plus(from, normal(triangle, size(triangle) * 0.4), 1.0);
    if tip != from {
        push(Solid::Segment { ends: [from, tip], role, label: Some(Label::name("n")) });
        push(Solid::Point { at: tip, role, label: None });
    }
}
