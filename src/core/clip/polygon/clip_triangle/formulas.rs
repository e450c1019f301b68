//! The formulas of clipping a triangle, with the numbers of a step.

use super::{Event, Mistake, Snapshot, Space};
use crate::{
    clip::polygon::{
        Plane, PlaneSet,
        clip_space::{Crossing, Event as Step, Region},
    },
    explain::{Formula, Piece},
    message::Value,
    transform::DepthRange,
};

/// The first three or all four coordinates, for a formula.
pub(super) fn vector(at: [f64; 4], count: usize) -> Value {
    Value::Vector(at[..count].iter().map(|&c| c as f32).collect())
}

impl Snapshot {
    /// How many coordinates a point has where the triangle is clipped.
    pub(super) fn dimensions(&self) -> usize {
        if self.subject.space() == Space::Camera || self.subject.divides_first() { 3 } else { 4 }
    }

    /// What holds inside a plane.
    pub(super) fn inequality(&self, plane: Plane) -> String {
        let guard = match self.subject.settings.planes {
            PlaneSet::Guard(_) => format!("{}", self.subject.settings.planes.guard()),
            _ => String::new(),
        };
        let w = match (self.subject.divides_first(), guard.is_empty()) {
            (true, true) => "1".to_owned(),
            (true, false) => guard,
            (false, _) => format!("{guard}w"),
        };
        let depth = if self.subject.divides_first() { "1" } else { "w" };
        if self.subject.space() == Space::Camera {
            return match plane {
                Plane::Near => "z ≤ −n".to_owned(),
                Plane::Far => "−f ≤ z".to_owned(),
                _ => "0 ≤ (v − p) · n".to_owned(),
            };
        }
        match plane {
            Plane::Left => format!("−{w} ≤ x"),
            Plane::Right => format!("x ≤ {w}"),
            Plane::Bottom => format!("−{w} ≤ y"),
            Plane::Top => format!("y ≤ {w}"),
            Plane::Near if self.subject.range == DepthRange::MinusOneToOne => format!("−{depth} ≤ z"),
            Plane::Near => "0 ≤ z".to_owned(),
            Plane::Far => format!("z ≤ {depth}"),
        }
    }

    /// The distance of a point from a plane where the triangle is clipped: two terms, and their sum.
    pub(super) fn distance(&self, plane: Plane, at: [f64; 4]) -> ([f64; 2], f64) {
        let [a, b] = match self.subject.space() {
            Space::Camera => self.subject.camera_space().terms(plane, at),
            Space::Clip => self.subject.clip_space().terms(plane, at),
        };
        ([a, b], a + b)
    }

    pub(super) fn formulas_of(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Divide { vertex, at: [x, y, z, _] } => {
                let [a, b, c, w] = self.subject.in_clip_space()[usize::from(vertex)];
                out.push(Formula {
                    general: "v ← (x / w, y / w, z / w)",
                    numbers: vec![
                        Piece::Text("= "),
                        Piece::Number([a, b, c].into()),
                        Piece::Text(" / "),
                        Piece::Number(w.into()),
                        Piece::Text(" = "),
                        Piece::Result([x, y, z].into()),
                    ],
                });
            }
            Event::Clip(_, Step::Side { corner, distance, .. }) => {
                if let (Some(plane), Some(corner)) = (self.plane, self.corners.get(usize::from(corner))) {
                    out.push(self.distance_formula(plane, corner.at, distance));
                }
            }
            Event::Clip(_, Step::Edge { from, crossing: Some(crossing), .. }) => {
                self.crossing_formulas(usize::from(from), &crossing, out);
            }
            _ => {}
        }
    }

    fn distance_formula(&self, plane: Plane, at: [f64; 4], distance: f64) -> Formula {
        let text = Piece::Text;
        if self.subject.space() == Space::Camera {
            let camera = self.subject.camera_space();
            let [sx, sy] = camera.scale;
            let (p, n) = match plane {
                Plane::Left => ([0.0; 3], [sx, 0.0, -camera.guard]),
                Plane::Right => ([0.0; 3], [-sx, 0.0, -camera.guard]),
                Plane::Bottom => ([0.0; 3], [0.0, sy, -camera.guard]),
                Plane::Top => ([0.0; 3], [0.0, -sy, -camera.guard]),
                Plane::Near => ([0.0, 0.0, -camera.near], [0.0, 0.0, -1.0]),
                Plane::Far => ([0.0, 0.0, -camera.far], [0.0, 0.0, 1.0]),
            };
            let v = [0, 1, 2].map(|axis| at[axis] as f32);
            return Formula {
                general: "d = (v − p) · n",
                numbers: vec![
                    text("= ("),
                    Piece::Number(v.into()),
                    text(" − "),
                    Piece::Number(p.into()),
                    text(") · "),
                    Piece::Number(n.into()),
                    text(" = "),
                    Piece::Result(distance.into()),
                ],
            };
        }
        let ([a, b], _) = self.distance(plane, at);
        let mut numbers = vec![text("= "), Piece::Number(a.into())];
        let one = plane == Plane::Near && self.subject.range == DepthRange::ZeroToOne;
        if !one {
            numbers.push(text(if b < 0.0 { " − " } else { " + " }));
            numbers.push(Piece::Number(b.abs().into()));
            numbers.extend([text(" = "), Piece::Result(distance.into())]);
        } else {
            numbers = vec![text("= "), Piece::Result(distance.into())];
        }
        let guarded = matches!(self.subject.settings.planes, PlaneSet::Guard(_));
        let general = match (plane, self.subject.divides_first(), guarded) {
            (Plane::Near, ..) if one => "d = z",
            (Plane::Near, true, _) => "d = 1 + z",
            (Plane::Near, false, _) => "d = w + z",
            (Plane::Far, true, _) => "d = 1 − z",
            (Plane::Far, false, _) => "d = w − z",
            (Plane::Left, true, false) => "d = 1 + x",
            (Plane::Left, false, false) => "d = w + x",
            (Plane::Left, ..) => "d = g w + x",
            (Plane::Right, true, false) => "d = 1 − x",
            (Plane::Right, false, false) => "d = w − x",
            (Plane::Right, ..) => "d = g w − x",
            (Plane::Bottom, true, false) => "d = 1 + y",
            (Plane::Bottom, false, false) => "d = w + y",
            (Plane::Bottom, ..) => "d = g w + y",
            (Plane::Top, true, false) => "d = 1 − y",
            (Plane::Top, false, false) => "d = w − y",
            (Plane::Top, ..) => "d = g w − y",
        };
        Formula { general, numbers }
    }

    /// t, and the new corner. t weighs a, the end inside; some books weigh the other end by 1 − t.
    fn crossing_formulas(&self, from: usize, crossing: &Crossing, out: &mut Vec<Formula>) {
        let to = (from + 1) % self.corners.len().max(1);
        let (Some(&(_, mut da)), Some(&(_, mut db))) = (self.sides.get(from), self.sides.get(to)) else {
            return;
        };
        let (mut a, mut b) = (&self.corners[from], &self.corners[to]);
        if self.subject.settings.mistake != Mistake::WalkOrder && da < 0.0 {
            (a, b, da, db) = (b, a, db, da);
        }
        let text = Piece::Text;
        let number = |value: f64| Piece::Number(value.into());
        let t = crossing.t;
        out.push(Formula {
            general: "t = db / (db − da)",
            numbers: vec![
                text("= "),
                number(db),
                text(" / ("),
                number(db),
                text(if da < 0.0 { " + " } else { " − " }),
                number(da.abs()),
                text(") = "),
                Piece::Result(t.into()),
            ],
        });
        let size = self.dimensions();
        out.push(Formula {
            general: "x = t a + (1 − t) b",
            numbers: vec![
                text("a = "),
                Piece::Number(Value::text(&a.name)),
                text(", b = "),
                Piece::Number(Value::text(&b.name)),
                text(": x = "),
                Piece::Result(vector(crossing.at, size)),
            ],
        });
    }
}
