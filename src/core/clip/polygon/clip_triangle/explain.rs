//! What the lab shows of clipping a triangle.

use super::{Event, Origin, Snapshot, Space, TaughtCorner, tables};
use crate::{
    clip::polygon::{Plane, clip_space::Event as Step},
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Table, Vantage, View},
    message::Message,
};

impl Explain for Snapshot {
    const NAME: &'static str = "clip-triangle";

    const LISTING: &'static [&'static str] = &[
        "mistake: v ← (x / w, y / w, z / w) first",
        "for each plane",
        "  no vertex outside: next plane",
        "  all outside: nothing is left; stop",
        "  d ← distance of each corner",
        "  for each edge a → b",
        "    d ≥ 0 at a: keep a",
        "    sides differ: emit t a + (1 − t) b",
        "  polygon ← what was kept and emitted",
        "round each corner once; equal ones are one",
        "u ← recomputed at each new corner",
        "triangles ← a fan from one corner",
        "stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Divide { .. } | Event::Lost { .. } => 0,
            Event::Clip(_, step) => match step {
                Step::Plane { .. } => 1,
                Step::Keep => 2,
                Step::Reject => 3,
                Step::Side { .. } => 4,
                Step::Edge { kept: false, crossing: None, .. } => 5,
                Step::Edge { crossing: None, .. } => 6,
                Step::Edge { .. } => 7,
                Step::Next { .. } => 8,
                Step::Round { .. } | Step::Merge { .. } => 9,
            },
            Event::Attribute { .. } => 10,
            Event::Triangle { .. } => 11,
            Event::Done { .. } => 12,
        }
    }

    fn operations(event: &Event) -> Operations {
        // A distance is a sum in clip space and a scalar product in camera space.
        match event {
            Event::Divide { .. } => Operations::new(0, 0, 3),
            Event::Clip(space, step) => match (step, space) {
                (Step::Plane { of, .. }, Space::Clip) => Operations::new(u64::from(*of), 0, 0),
                (Step::Plane { of, .. }, Space::Camera) => {
                    Operations::new(u64::from(*of), 3 * u64::from(*of), 0)
                }
                (Step::Side { .. }, Space::Clip) => Operations::new(1, 0, 0),
                (Step::Side { .. }, Space::Camera) => Operations::new(1, 3, 0),
                (Step::Edge { crossing: Some(_), .. }, Space::Clip) => Operations::new(1, 8, 1),
                (Step::Edge { crossing: Some(_), .. }, Space::Camera) => Operations::new(1, 6, 1),
                (Step::Edge { .. }, _) => Operations::new(1, 0, 0),
                _ => Operations::NONE,
            },
            Event::Attribute { .. } => Operations::new(0, 2, 0),
            Event::Lost { .. } | Event::Triangle { .. } | Event::Done { .. } => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done { .. } => Level::Primitive,
            Event::Clip(_, Step::Keep | Step::Reject | Step::Next { .. }) => Level::Row,
            Event::Lost { .. } | Event::Triangle { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let unnamed = |role| Some(Marker { role, label: None });
        match event {
            Event::Divide { .. } => unnamed(Role::Taught),
            Event::Lost { .. } | Event::Clip(_, Step::Reject) => {
                Some(Marker { role: Role::Rejected, label: Some("word-reject") })
            }
            Event::Clip(_, Step::Plane { plane, .. }) => {
                Some(Marker { role: Role::Neutral, label: Some(marker_word(*plane)) })
            }
            Event::Clip(_, Step::Edge { kept: true, .. }) => unnamed(Role::Accepted),
            Event::Clip(_, Step::Edge { crossing: Some(_), .. }) => unnamed(Role::Accepted),
            Event::Clip(_, Step::Edge { .. }) => unnamed(Role::Rejected),
            Event::Done { corners: 1.. } => Some(Marker { role: Role::Accepted, label: Some("word-accept") }),
            _ => None,
        }
    }

    fn opening(&self) -> Message {
        self.say_opening()
    }

    fn sentence(&self, event: &Event) -> Message {
        self.say(event)
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        self.formulas_of(event, out);
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.extend(tables::edges(self));
        out.extend(tables::polygon(self));
        out.push(tables::inequalities(self));
        out.extend(tables::neighbours(self));
        out.extend(tables::correct(self));
        out.push(tables::vertices(self));
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let result = self.result();
        if self.over {
            out.push(Fact::answer(if result.corners.is_empty() { "word-reject" } else { "word-accept" }));
        }
        for TaughtCorner { corner, attribute } in result.corners {
            let [x, y, z, w] = corner.position;
            let values = [("x", x), ("y", y), ("z", z), ("w", w), ("u", attribute)];
            let name = match corner.origin {
                Origin::Vertex(i) => format!("v{i}"),
                Origin::Edge { edge, plane } => {
                    format!("v{} v{}, {}", (edge + 1) % 3, (edge + 2) % 3, self.inequality(plane))
                }
                Origin::Interior { planes } => {
                    let mut planes = planes;
                    planes.sort();
                    planes.map(|plane| self.inequality(plane)).join(", ")
                }
            };
            out.push(Fact::named(name, values.map(|(name, value)| (name, value.into())).to_vec()));
        }
    }

    fn view(&self) -> View {
        View::SPACE
    }

    fn vantage(&self) -> Option<Vantage> {
        Some(self.first_camera())
    }
}

/// The name of a plane below the timeline.
fn marker_word(plane: Plane) -> &'static str {
    match plane {
        Plane::Left => "clip-triangle-marker-left",
        Plane::Right => "clip-triangle-marker-right",
        Plane::Bottom => "clip-triangle-marker-bottom",
        Plane::Top => "clip-triangle-marker-top",
        Plane::Near => "clip-triangle-marker-near",
        Plane::Far => "clip-triangle-marker-far",
    }
}
