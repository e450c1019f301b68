//! A drawing in space through the camera outside: marks of the plane that it sees.
//!
//! Everything that shows a lab calls [`seen`] before it lays out a drawing: the window with the camera
//! that the user has turned, the command line with the first one. A drawing in the plane goes through
//! unchanged.

use std::borrow::Cow;

use glam::{DVec2, DVec3};
use rasterscope_core::explain::{Label, Mark, Role, Solid, Vantage};

use crate::orbit::{FRUSTUM_EDGES, Orbit, wide};

/// Corners of a circle.
const CIRCLE: usize = 48;
/// Where the axes stand in the picture, and how long they are.
const AXES: ([f32; 2], f32) = ([-0.96, -0.8], 0.13);

/// The marks of the plane that the camera sees: those in space through `orbit`, or from the vantage if
/// there is no camera yet. Without a vantage the marks as they are.
pub fn seen<'m>(marks: &'m [Mark], vantage: Option<&Vantage>, orbit: Option<&Orbit>) -> Cow<'m, [Mark]> {
    let Some(vantage) = vantage else { return Cow::Borrowed(marks) };
    let first;
    let orbit = match orbit {
        Some(orbit) => orbit,
        None => {
            first = Orbit::first(vantage);
            &first
        }
    };
    let mut out = Vec::with_capacity(marks.len() + 16);
    let mut polygons: Vec<(f32, Mark)> = Vec::new();
    for mark in marks {
        match mark {
            Mark::Space(solid) => see(solid, orbit, &mut out, &mut polygons),
            other => out.push(other.clone()),
        }
    }
    axes(orbit, vantage.axes, &mut out);
    // The fills of what is nearer lie over the others.
    polygons.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let mut all: Vec<Mark> = polygons.into_iter().map(|(_, mark)| mark).collect();
    all.append(&mut out);
    Cow::Owned(all)
}

fn see(solid: &Solid, orbit: &Orbit, out: &mut Vec<Mark>, polygons: &mut Vec<(f32, Mark)>) {
    match solid {
        Solid::Point { at, role, label } => {
            let point = orbit.project(*at);
            out.extend(point.map(|at| Mark::Point { at, role: *role, label: label.clone() }));
        }
        Solid::Segment { ends: [a, b], role, label } => {
            let ends = orbit.segment(*a, *b);
            out.extend(ends.map(|ends| Mark::Segment { ends, role: *role, label: label.clone() }));
        }
        Solid::Polygon { points, role, object, label } => {
            let flat = orbit.polygon(points);
            if flat.len() > 1 {
                let depth = points.iter().map(|&p| orbit.depth(p)).sum::<f32>() / points.len() as f32;
                let mark = Mark::Polygon { points: flat, role: *role, object: *object, label: label.clone() };
                polygons.push((depth, mark));
            }
        }
        Solid::Body { corners, role, label } => {
            for [a, b] in FRUSTUM_EDGES {
                let ends = orbit.segment(corners[a], corners[b]);
                out.extend(ends.map(|ends| Mark::Segment { ends, role: *role, label: None }));
            }
            name_highest(corners.iter().filter_map(|&corner| orbit.project(corner)), *role, label, out);
        }
        Solid::Sphere { center, radius, role, label } => {
            sphere(*center, *radius, *role, label, orbit, (out, polygons));
        }
        Solid::Text { at, label, role } => {
            let label = label.clone();
            out.extend(orbit.project(*at).map(|at| Mark::Text { at, label, role: *role, big: false }));
        }
    }
}

/// The outline of a sphere, which the camera sees as a circle somewhat nearer than its middle, and its
/// equator.
fn sphere(
    center: [f32; 3],
    radius: f32,
    role: Role,
    label: &Option<Label>,
    orbit: &Orbit,
    (out, polygons): (&mut Vec<Mark>, &mut Vec<(f32, Mark)>),
) {
    let (middle, eye) = (wide(center), wide(orbit.eye()));
    let to_eye = eye - middle;
    let (distance, radius) = (to_eye.length(), f64::from(radius));
    if distance <= radius {
        return; // the camera is inside
    }
    let towards = to_eye / distance;
    let share = radius / distance;
    let u = towards.any_orthonormal_vector();
    let ring = |middle: DVec3, u: DVec3, v: DVec3, radius: f64| {
        let points = (0..CIRCLE).map(|i| {
            let turn = DVec2::from_angle(std::f64::consts::TAU * i as f64 / CIRCLE as f64);
            (middle + (u * turn.x + v * turn.y) * radius).as_vec3().to_array()
        });
        orbit.polygon(&points.collect::<Vec<_>>())
    };
    let nearer = middle + towards * (radius * share);
    let outline = ring(nearer, u, towards.cross(u), radius * (1.0 - share * share).sqrt());
    let equator = ring(middle, DVec3::X, DVec3::Z, radius);
    name_highest(outline.iter().copied(), role, label, out);
    for (points, role) in [(equator, Role::Skipped), (outline, role)] {
        if points.len() > 2 {
            // Under all that is in it.
            let behind = (distance + radius) as f32;
            polygons.push((behind, Mark::Polygon { points, role, object: None, label: None }));
        }
    }
}

/// Puts a text at the highest of some points of the picture.
fn name_highest(
    points: impl Iterator<Item = [f32; 2]>,
    role: Role,
    label: &Option<Label>,
    out: &mut Vec<Mark>,
) {
    let Some(label) = label else { return };
    let highest = points.max_by(|a, b| a[1].total_cmp(&b[1]));
    out.extend(highest.map(|at| Mark::Text { at, label: label.clone(), role, big: false }));
}

/// The directions of the axes, in a corner of the picture.
fn axes(orbit: &Orbit, names: [&'static str; 3], out: &mut Vec<Mark>) {
    let ([x, y], length) = AXES;
    let [right, up, _] = orbit.axes();
    for (axis, name) in names.into_iter().enumerate() {
        let tip = |length: f32| {
            let by = [right[axis], up[axis]].map(|c| c as f32 * length);
            [x + by[0], y + by[1]]
        };
        out.push(Mark::Segment { ends: [[x, y], tip(length)], role: Role::Neutral, label: None });
        let [x, y] = tip(length * 1.3);
        // A text hangs right below its place.
        let at = [x - 0.055, y + 0.05];
        out.push(Mark::Text { at, label: Label::name(name), role: Role::Candidate, big: false });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rasterscope_core::explain::box_corners;

    fn vantage() -> Vantage {
        let points = box_corners([-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]).to_vec();
        Vantage { points, yaw: 0.6, pitch: 0.3, axes: ["x", "y", "z"] }
    }

    fn square(z: f32) -> Mark {
        let points = vec![[-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z], [-1.0, 1.0, z]];
        Mark::Space(Solid::Polygon { points, role: Role::Neutral, object: None, label: None })
    }

    #[test]
    fn a_drawing_in_the_plane_stays_as_it_is() {
        let marks = [Mark::Point { at: [1.0, 2.0], role: Role::Active, label: None }];
        assert!(matches!(seen(&marks, None, None), Cow::Borrowed(same) if same == marks));
    }

    #[test]
    fn what_is_farther_is_painted_first_from_either_side() {
        let marks = [square(1.0), square(-1.0)];
        for (yaw, nearest_last) in [(0.3, true), (std::f32::consts::PI, false)] {
            let vantage = Vantage { yaw, ..vantage() };
            let all = seen(&marks, Some(&vantage), None).into_owned();
            let [first, second] = [0, 1].map(|i| match &all[i] {
                Mark::Polygon { points, .. } => {
                    points.iter().map(|p| p[0].abs().max(p[1].abs())).fold(0.0, f32::max)
                }
                other => panic!("{other:?}"),
            });
            assert!(second > first, "the nearer square is larger");
            let orbit = Orbit::first(&vantage);
            assert_eq!(orbit.depth([0.0, 0.0, 1.0]) < orbit.depth([0.0, 0.0, -1.0]), nearest_last);
        }
    }

    #[test]
    fn bodies_have_twelve_edges_and_spheres_a_round_outline() {
        let body = Solid::Body {
            corners: box_corners([-1.0; 3], [1.0; 3]),
            role: Role::Neutral,
            label: Some(Label::name("box")),
        };
        let sphere = Solid::Sphere { center: [0.0; 3], radius: 1.0, role: Role::Accepted, label: None };
        let marks = [Mark::Space(body), Mark::Space(sphere)];
        let all = seen(&marks, Some(&vantage()), None).into_owned();
        let count = |wanted: fn(&Mark) -> bool| all.iter().filter(|mark| wanted(mark)).count();
        assert_eq!(count(|mark| matches!(mark, Mark::Segment { .. })), 12 + 3);
        assert_eq!(count(|mark| matches!(mark, Mark::Text { .. })), 1 + 3);
        let Some(Mark::Polygon { points, .. }) =
            all.iter().find(|mark| matches!(mark, Mark::Polygon { role: Role::Accepted, .. }))
        else {
            panic!("no outline")
        };
        let orbit = Orbit::first(&vantage());
        let [x, y] = orbit.project([0.0; 3]).expect("it is in front");
        let radii: Vec<f32> = points.iter().map(|p| (p[0] - x).hypot(p[1] - y)).collect();
        let (low, high) = radii.iter().fold((f32::MAX, 0.0_f32), |(low, high), &r| (low.min(r), high.max(r)));
        assert!(high / low < 1.05 && low > 0.2, "{low} {high}");
    }

    #[test]
    fn what_is_not_finite_is_left_out() {
        let nan = [f32::NAN; 3];
        let marks = [
            Mark::Space(Solid::Point { at: nan, role: Role::Active, label: None }),
            Mark::Space(Solid::Segment { ends: [nan, [0.0; 3]], role: Role::Active, label: None }),
            Mark::Space(Solid::Polygon {
                points: vec![nan; 3],
                role: Role::Active,
                object: None,
                label: None,
            }),
            Mark::Space(Solid::Sphere { center: nan, radius: 1.0, role: Role::Active, label: None }),
        ];
        let active = |mark: &Mark| {
            matches!(
                mark,
                Mark::Point { role: Role::Active, .. }
                    | Mark::Segment { role: Role::Active, .. }
                    | Mark::Polygon { role: Role::Active, .. }
            )
        };
        assert!(!seen(&marks, Some(&vantage()), None).iter().any(active));
    }
}
