//! The drawing of a triangle against one plane.

use glam::DVec3;

use super::{
    Corner, Event, Snapshot,
    explain::{New, name},
};
use crate::explain::{Label, Mark, Role, Solid, Vantage};

impl Snapshot {
    /// From where the drawing is seen first.
    pub(super) fn first_camera(&self) -> Vantage {
        let mut points = self.vertices.to_vec();
        points.extend(self.patch().unwrap_or_default());
        Vantage { points, yaw: 0.7, pitch: 0.35, axes: ["x", "y", "z"] }
    }

    /// A square piece of the plane, large enough for the triangle; none without a normal.
    fn patch(&self) -> Option<[[f32; 3]; 4]> {
        let wide = |p: [f32; 3]| DVec3::from_array(p.map(f64::from));
        let normal = wide(self.plane.normal).try_normalize()?;
        let point = wide(self.plane.point);
        let feet = self.vertices.map(|v| {
            let v = wide(v);
            v - normal * (v - point).dot(normal)
        });
        let middle = (feet[0] + feet[1] + feet[2] + point) / 4.0;
        let all = [feet[0], feet[1], feet[2], point];
        let reach = all.iter().map(|p| p.distance(middle)).fold(0.5, f64::max) * 1.15;
        // One side runs level where it can.
        let across = DVec3::Y.cross(normal).try_normalize().unwrap_or(DVec3::X);
        let along = normal.cross(across);
        let corner = |u: f64, v: f64| (middle + (across * u + along * v) * reach).as_vec3().to_array();
        Some([corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)])
    }

    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let mut solids = Vec::new();
        self.draw_plane(&mut solids);
        self.draw_triangles(&mut solids);
        for (i, &at) in self.vertices.iter().enumerate() {
            let role = match self.distances[i] {
                None => Role::Neutral,
                Some(_) if self.is_inside(i) => Role::Accepted,
                Some(_) => Role::Rejected,
            };
            let label = Label::new(format!("v{i}"), self.distances[i].map(|(_, d)| d));
            solids.push(Solid::Point { at, role, label: Some(label) });
            self.draw_distance(i, &mut solids);
        }
        for (i, new) in self.new.iter().enumerate() {
            let Some(New { at: Some(at), .. }) = new else { continue };
            let now = matches!(event, Some(Event::Cross { new, .. }) if usize::from(*new) == i);
            let role = if now { Role::Active } else { Role::Accepted };
            let label = Some(Label::name(name(Corner::New(i as u8))));
            solids.push(Solid::Point { at: at.map(|c| c as f32), role, label });
        }
        match event {
            Some(Event::Distance { vertex, .. } | Event::Alone { vertex, .. }) => {
                let at = self.vertices[usize::from(*vertex)];
                solids.push(Solid::Point { at, role: Role::Active, label: None });
            }
            Some(Event::Share { a, b, .. }) => {
                let ends = [*a, *b].map(|i| self.vertices[usize::from(i)]);
                solids.push(Solid::Segment { ends, role: Role::Active, label: None });
            }
            Some(Event::Cross { new, .. }) => {
                if let Some(New { ends, .. }) = self.new[usize::from(*new)] {
                    let ends = ends.map(|i| self.vertices[i]);
                    solids.push(Solid::Segment { ends, role: Role::Active, label: None });
                }
            }
            _ => {}
        }
        out.extend(solids.into_iter().map(Mark::Space));
    }

    /// The plane, its point and its normal.
    fn draw_plane(&self, out: &mut Vec<Solid>) {
        if let Some(points) = self.patch() {
            let points = points.to_vec();
            out.push(Solid::Polygon { points, role: Role::Neutral, object: None, label: None });
        }
        let p = self.plane.point;
        let tip = [0, 1, 2].map(|axis| p[axis] + self.plane.normal[axis]);
        out.push(Solid::Segment { ends: [p, tip], role: Role::Neutral, label: None });
        out.push(Solid::Point { at: p, role: Role::Neutral, label: Some(Label::name("p")) });
        out.push(Solid::Text { at: tip, label: Label::name("n"), role: Role::Neutral });
    }

    /// From a vertex straight to the plane: what its distance measures.
    fn draw_distance(&self, vertex: usize, out: &mut Vec<Solid>) {
        let Some((_, distance)) = self.distances[vertex] else { return };
        let normal = self.plane.normal.map(f64::from);
        let length: f64 = normal.iter().map(|n| n * n).sum();
        if length > 0.0 && distance != 0.0 {
            let v = self.vertices[vertex];
            let foot = [0, 1, 2].map(|axis| (f64::from(v[axis]) - distance / length * normal[axis]) as f32);
            out.push(Solid::Segment { ends: [v, foot], role: Role::Skipped, label: None });
        }
    }

    /// The triangle as given until it is decided, then what is left and what is removed.
    fn draw_triangles(&self, out: &mut Vec<Solid>) {
        let polygon =
            |points: Vec<[f32; 3]>, role, object| Solid::Polygon { points, role, object, label: None };
        if let Some(kept) = self.decided {
            let (role, object) = if kept { (Role::Accepted, Some(0)) } else { (Role::Rejected, None) };
            out.push(polygon(self.vertices.to_vec(), role, object));
            return;
        }
        let [Some(x0), Some(x1)] = self.new.map(|new| new.and_then(|new| new.at)) else {
            out.push(polygon(self.vertices.to_vec(), Role::Neutral, Some(0)));
            return;
        };
        for (i, corners) in self.triangles.iter().enumerate() {
            out.push(polygon(corners.map(|corner| self.at(corner)).to_vec(), Role::Accepted, Some(i)));
        }
        let Some((alone, inside)) = self.alone else { return };
        let [x0, x1] = [x0, x1].map(|at| at.map(|c| c as f32));
        let [first, next, last] = [0, 1, 2].map(|i| self.vertices[(alone + i) % 3]);
        let (tip, rest) = (vec![first, x1, x0], vec![x1, next, last, x0]);
        let (kept, removed) = if inside { (tip, rest) } else { (rest, tip) };
        out.push(polygon(removed, Role::Rejected, None));
        if self.triangles.is_empty() {
            out.push(polygon(kept, Role::Neutral, Some(0)));
        }
    }
}
