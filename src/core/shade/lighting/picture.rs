//! The drawing: a slice through the surface, the unit vectors, and what goes out in each direction.

use super::{Event, Snapshot, Surface, Vector, brightness, explain::UNITS};
use crate::{
    explain::{Grid, Label, Mark, Role, Sign, View},
    message::Message,
    shade::{Model, NormalMatrix, Place},
};

/// The surface is drawn so far to both sides, in units.
const REACH: f64 = 1.75;
/// And so deep.
const DEPTH: f64 = 0.2;
/// Points of a circle.
const POINTS: u32 = 180;

impl Snapshot {
    /// Everything that can be dragged, and the unit circle around the point.
    pub(super) fn slice(&self) -> View {
        let [x, y, _] = self.subject.surface.position;
        let reach = REACH as f32;
        let around = [[x - reach, y - 1.25], [x + reach, y + 1.25]];
        let ends = [self.end(self.subject.light.place), self.end(self.subject.eye), self.tip()];
        let all = || around.iter().chain(&ends);
        let least = |axis: usize| all().map(|p| p[axis]).fold(f32::INFINITY, f32::min);
        let most = |axis: usize| all().map(|p| p[axis]).fold(f32::NEG_INFINITY, f32::max);
        let margin = 0.5;
        View {
            min: [least(0) - margin, least(1) - margin],
            max: [most(0) + margin, most(1) + margin],
            y_up: true,
            grid: Grid::Units,
        }
    }

    /// Where a place is drawn; a direction ends as far from the point as it is long.
    fn end(&self, place: Place) -> [f32; 2] {
        match place {
            Place::Position([x, y, _]) => [x, y],
            Place::Direction(d) => self.beside_point(d),
        }
    }

    /// Where the normal as given ends.
    fn tip(&self) -> [f32; 2] {
        self.beside_point(self.subject.surface.normal)
    }

    fn beside_point(&self, [x, y, _]: [f32; 3]) -> [f32; 2] {
        let at = self.subject.surface.position;
        [at[0] + x, at[1] + y]
    }

    /// Across the surface: the right normal, whatever is computed with.
    fn upright(&self) -> [f64; 2] {
        let [x, y, _] = NormalMatrix::new(&self.subject.model).apply(self.subject.surface.normal);
        let length = libm::hypot(f64::from(x), f64::from(y));
        if length > 0.0 { [f64::from(x) / length, f64::from(y) / length] } else { [0.0, 1.0] }
    }

    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let [x, y, _] = self.subject.surface.position;
        let at = [x, y];
        self.draw_surface(out);
        out.push(self.circle(|_| 1.0, Role::Skipped));
        if self.result.is_some() {
            out.push(self.outgoing());
            out.push(Mark::Key {
                role: Role::Accepted,
                sign: Sign::Line,
                meaning: Message::new("shade-key-outgoing"),
            });
        }
        let light = self.end(self.subject.light.place);
        let eye = self.end(self.subject.eye);
        for ends in [[light, at], [at, eye]] {
            out.push(Mark::Segment { ends, role: Role::Candidate, label: None });
        }
        let segment =
            |to, role, name: &str| Mark::Segment { ends: [at, to], role, label: Some(Label::name(name)) };
        let [normal, ..] = self.units;
        if normal.is_none() {
            let (to, name) = match self.turned {
                Some(turned) => (self.beside_point(turned), "N′"),
                None => (self.tip(), "N"),
            };
            let role = if self.turned.is_some() { Role::Active } else { Role::Neutral };
            out.push(segment(to, role, name));
        }
        for (i, unit) in self.units.into_iter().enumerate() {
            let Some(unit) = unit.filter(|unit| *unit != [0.0; 3]) else { continue };
            let role = if is_about(event, i) { Role::Active } else { Role::Neutral };
            out.push(segment(self.beside_point(unit), role, UNITS[i]));
        }
        if let Some(bisector) = self.bisector {
            let name = if self.subject.material.model == Model::Phong { "r" } else { "h" };
            let now = matches!(
                event,
                Some(Event::Mirrored { .. } | Event::Halfway { .. } | Event::Highlight { .. })
            );
            let role = if now { Role::Active } else { Role::Changed };
            out.push(segment(self.beside_point(bisector), role, name));
        }
        let behind = matches!(event, Some(Event::Behind));
        let role = if behind { Role::Rejected } else { Role::Neutral };
        for (place, name, role) in [(light, "L", role), (eye, "E", Role::Neutral)] {
            out.push(Mark::Point { at: place, role, label: Some(Label::name(name)) });
        }
        let label = self.result.map_or_else(|| Label::name("P"), |value| Label::new("P I", value));
        let role = if self.result.is_some() { Role::Accepted } else { Role::Neutral };
        out.push(Mark::Point { at, role, label: Some(label) });
    }

    /// A strip below the tangent.
    fn draw_surface(&self, out: &mut Vec<Mark>) {
        let [up_x, up_y] = self.upright();
        let corner = |along: f64, down: f64| {
            let [x, y, _] = self.subject.surface.position.map(f64::from);
            [(x + along * up_y - down * up_x) as f32, (y - along * up_x - down * up_y) as f32]
        };
        let points =
            vec![corner(-REACH, 0.0), corner(REACH, 0.0), corner(REACH, DEPTH), corner(-REACH, DEPTH)];
        out.push(Mark::Polygon { points, role: Role::Neutral, object: Some(0), label: None });
    }

    /// A closed line around the point, so far away in each direction.
    fn circle(&self, radius: impl Fn([f64; 2]) -> f64, role: Role) -> Mark {
        let [x, y, _] = self.subject.surface.position.map(f64::from);
        let point = |i: u32| {
            let angle = f64::from(i) / f64::from(POINTS) * std::f64::consts::TAU;
            let (sin, cos) = libm::sincos(angle);
            let radius = radius([cos, sin]);
            [(x + radius * cos) as f32, (y + radius * sin) as f32]
        };
        Mark::Curve { points: (0..=POINTS).map(point).collect(), role, label: None }
    }

    /// How bright the point is for an eye in each direction above the surface; 1 is the circle.
    fn outgoing(&self) -> Mark {
        let subject = &self.subject;
        let normal = self.turned.unwrap_or_default();
        let surface = Surface { normal, ..subject.surface };
        let up = self.upright();
        let radius = |to: [f64; 2]| {
            if up[0] * to[0] + up[1] * to[1] <= 0.0 {
                return 0.0;
            }
            let eye = Place::Direction([to[0] as f32, to[1] as f32, 0.0]);
            f64::from(brightness(surface, eye, &self.lights, &subject.material).of_white())
        };
        self.circle(radius, Role::Accepted)
    }
}

/// Whether a step is about a unit vector.
fn is_about(event: Option<&Event>, i: usize) -> bool {
    match event {
        Some(Event::Unit { vector, .. }) => *vector as usize == i,
        Some(Event::Flipped { .. }) => i == Vector::Normal as usize,
        Some(Event::Incidence { .. } | Event::Diffuse { .. }) => i != Vector::Eye as usize,
        _ => false,
    }
}
