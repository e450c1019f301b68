//! The drawing of clipping a triangle: the frustum from outside, in camera space; after a division, the
//! box of NDC.

use super::{Event, Origin, Snapshot, Space, TaughtCorner, snapshot::Named};
use crate::{
    clip::polygon::{Plane, PlaneSet, clip_space::Event as Step},
    explain::{Label, Mark, Role, Solid, Vantage, box_corners},
    math::Sign,
    message::Value,
    transform::{
        DepthRange, Projection,
        frustum::{FRUSTUM_EDGES, FRUSTUM_FACES},
    },
};

impl Snapshot {
    /// Where a point of the space of clipping is drawn.
    fn place(&self, at: [f64; 4]) -> [f32; 3] {
        let [x, y, z, w] = at;
        let matrix = self.subject.projection.map(f64::from);
        let place = if self.subject.divides_first() {
            [x, y, -z]
        } else if self.subject.space() == Space::Camera {
            [x, y, z]
        } else if self.is_perspective() {
            // For what a camera has made, w is the distance in front of the eye.
            [x / matrix[0], y / matrix[5], -w]
        } else {
            [x / matrix[0], y / matrix[5], (z - matrix[14]) / matrix[10]]
        };
        place.map(|c| c as f32)
    }

    fn is_perspective(&self) -> bool {
        matches!(self.subject.camera.projection, Projection::Perspective { .. })
    }

    /// The visible body, its sides `guard` times as far apart.
    fn body(&self, guard: f32) -> [[f32; 3]; 8] {
        let camera = &self.subject.camera;
        if self.subject.divides_first() {
            let low = if self.subject.range == DepthRange::ZeroToOne { 0.0 } else { 1.0 };
            return box_corners([-guard, -guard, -1.0], [guard, guard, low]);
        }
        let [sx, sy] = self.subject.camera_space().scale;
        let at = |distance: f32| {
            let w = if self.is_perspective() { distance } else { 1.0 };
            let [x, y] = [guard * w / sx, guard * w / sy];
            [[-x, -y], [x, -y], [x, y], [-x, y]].map(|[x, y]| [x, y, -distance])
        };
        let ([a, b, c, d], [e, f, g, h]) = (at(camera.near), at(camera.far));
        [a, b, c, d, e, f, g, h]
    }

    /// From where the drawing is seen first.
    pub(super) fn first_camera(&self) -> Vantage {
        let mut points = self.body(1.0).to_vec();
        if !self.subject.divides_first() {
            points.push([0.0; 3]);
            points.extend(self.subject.vertices);
        } else {
            points.extend(self.vertices.map(|v| self.place(v.map(f64::from))).iter().filter(|p| {
                // What is divided by nearly nothing is anywhere: it need not be in the picture.
                p.iter().all(|c| c.abs() < 4.0)
            }));
        }
        let axes = if self.subject.divides_first() { ["x", "y", "−z"] } else { ["x", "y", "z"] };
        Vantage { points, yaw: 0.62, pitch: 0.32, axes }
    }

    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let mut solids = Vec::new();
        self.draw_body(&mut solids);
        self.draw_plane(&mut solids);
        for points in self.removed.iter().filter(|points| points.len() > 2) {
            solids.push(self.polygon(points.iter().copied(), Role::Rejected, None));
        }
        if self.over {
            self.draw_result(&mut solids);
        } else if self.corners.len() > 2 {
            solids.push(self.polygon(self.corners.iter().map(|c| c.at), Role::Accepted, Some(0)));
        }
        self.draw_corners(&mut solids);
        self.draw_step(event, &mut solids);
        out.extend(solids.into_iter().map(Mark::Space));
    }

    fn polygon(&self, points: impl Iterator<Item = [f64; 4]>, role: Role, object: Option<usize>) -> Solid {
        Solid::Polygon { points: points.map(|at| self.place(at)).collect(), role, object, label: None }
    }

    /// The frustum, its eye, and the guard band if there is one.
    fn draw_body(&self, out: &mut Vec<Solid>) {
        let corners = self.body(1.0);
        for [a, b] in FRUSTUM_EDGES {
            let role = if a < 4 && b < 4 { Role::Neutral } else { Role::Candidate };
            out.push(Solid::Segment { ends: [corners[a], corners[b]], role, label: None });
        }
        if let PlaneSet::Guard(_) = self.subject.settings.planes {
            let corners = self.body(self.subject.settings.planes.guard());
            out.push(Solid::Body { corners, role: Role::Skipped, label: None });
        }
        for (corner, plane) in [(3, Plane::Near), (7, Plane::Far)] {
            if self.plane != Some(plane) || self.over {
                let label = Label::new("", Value::Word(plane.word()));
                out.push(Solid::Text { at: corners[corner], label, role: Role::Candidate });
            }
        }
        if self.is_perspective() && !self.subject.divides_first() {
            let label = Label::new("", Value::Word("clip-triangle-eye"));
            out.push(Solid::Point { at: [0.0; 3], role: Role::Neutral, label: Some(label) });
            for &near in &corners[..4] {
                out.push(Solid::Segment { ends: [[0.0; 3], near], role: Role::Skipped, label: None });
            }
        }
    }

    /// The plane in hand.
    fn draw_plane(&self, out: &mut Vec<Solid>) {
        let Some(plane) = self.plane.filter(|_| !self.over) else { return };
        let corners = self.body(self.subject.settings.planes.guard());
        let points = FRUSTUM_FACES[plane as usize].map(|i| corners[i]).to_vec();
        // The name stands at an upper corner that is far away.
        let at = points.iter().copied().reduce(|a, b| if b[1] - b[2] > a[1] - a[2] { b } else { a });
        let label = Label::name(self.inequality(plane));
        out.extend(at.map(|at| Solid::Text { at, label, role: Role::Active }));
        out.push(Solid::Polygon { points, role: Role::Active, object: None, label: None });
    }

    fn draw_result(&self, out: &mut Vec<Solid>) {
        let result = self.result();
        let at = |there: &TaughtCorner| there.corner.position.map(f64::from);
        let taught = self.is_taught() && result != self.correct;
        let role = if taught { Role::Taught } else { Role::Accepted };
        if result.triangles.is_empty() {
            if result.corners.len() > 2 {
                out.push(self.polygon(result.corners.iter().map(at), role, Some(0)));
            }
        } else {
            for (i, corners) in result.triangles.iter().enumerate() {
                let points = corners.iter().map(|&i| at(&result.corners[usize::from(i)]));
                out.push(self.polygon(points, role, Some(i)));
            }
        }
        if taught && self.correct.corners.len() > 2 {
            out.push(self.polygon(self.correct.corners.iter().map(at), Role::Exact, None));
        }
    }

    /// Every corner with its name: the vertices, and what the planes have made.
    fn draw_corners(&self, out: &mut Vec<Solid>) {
        let standing = |name: &str| self.corners.iter().position(|corner| corner.name == name);
        let vertices = (0..3).map(|i| Named {
            name: format!("v{i}"),
            origin: Origin::Vertex(i as u8),
            at: self.vertices[i].map(f64::from),
            t: None,
        });
        let gone = vertices.chain(self.made.iter().cloned());
        let gone = gone.filter(|corner| {
            standing(&corner.name).is_none() && !self.next.iter().any(|next| next.name == corner.name)
        });
        for corner in gone {
            out.push(self.point(&corner, Role::Rejected));
        }
        for (i, corner) in self.corners.iter().enumerate() {
            let role = match self.sides.get(i) {
                Some((Sign::Negative, _)) => Role::Rejected,
                Some((Sign::Zero, _)) => Role::Tie,
                Some((Sign::Positive, _)) => Role::Accepted,
                None if self.over => Role::Accepted,
                None => Role::Neutral,
            };
            out.push(self.point(corner, role));
        }
    }

    fn point(&self, corner: &Named, role: Role) -> Solid {
        Solid::Point { at: self.place(corner.at), role, label: Some(Label::name(&corner.name)) }
    }

    /// What the step is about.
    fn draw_step(&self, event: Option<&Event>, out: &mut Vec<Solid>) {
        match event {
            Some(Event::Clip(_, Step::Side { corner, .. })) => {
                if let Some(corner) = self.corners.get(usize::from(*corner)) {
                    out.push(Solid::Point { at: self.place(corner.at), role: Role::Active, label: None });
                }
            }
            Some(Event::Clip(_, Step::Edge { from, crossing, .. })) => {
                let from = usize::from(*from);
                let to = (from + 1) % self.corners.len().max(1);
                let Some((a, b)) = self.corners.get(from).zip(self.corners.get(to)) else { return };
                let ends = [self.place(a.at), self.place(b.at)];
                out.push(Solid::Segment { ends, role: Role::Active, label: None });
                // The corners of this plane that were made before, and then the new one.
                let made = self.next.iter().filter(|corner| {
                    corner.t.is_some() && !self.corners.iter().any(|old| old.name == corner.name)
                });
                let count = made.clone().count();
                for (i, corner) in made.enumerate() {
                    let now = crossing.is_some() && i + 1 == count;
                    out.push(self.point(corner, if now { Role::Active } else { Role::Neutral }));
                }
            }
            Some(Event::Clip(_, Step::Round { .. })) => {
                let index = self.rounded.len().saturating_sub(1);
                out.extend(self.corners.get(index).map(|corner| Solid::Point {
                    at: self.place(corner.at),
                    role: Role::Active,
                    label: None,
                }));
            }
            Some(Event::Attribute { corner, value }) => {
                if let Some(corner) = self.corners.get(usize::from(*corner)) {
                    let label = Some(Label::new("u", *value));
                    out.push(Solid::Point { at: self.place(corner.at), role: Role::Active, label });
                }
            }
            Some(Event::Triangle { corners }) => {
                let points = corners.iter().filter_map(|&i| self.corners.get(usize::from(i)));
                out.push(self.polygon(points.map(|corner| corner.at), Role::Active, None));
            }
            _ => {}
        }
    }
}
