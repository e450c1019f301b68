//! The sentences of clipping a triangle.

use super::{Event, Mistake, Origin, Snapshot, Space};
use crate::{
    clip::polygon::{Plane, clip_space::Event as Step},
    math::Sign,
    message::{Message, Value},
};

impl Snapshot {
    pub(super) fn say_opening(&self) -> Message {
        Message::new(match (self.subject.settings.mistake, self.subject.space()) {
            (Mistake::DivideFirst, _) => "clip-triangle-opening-divide",
            (Mistake::NoNearPlane, _) => "clip-triangle-opening-no-near",
            (Mistake::NoAttributes, _) => "clip-triangle-opening-no-attributes",
            (Mistake::WalkOrder, _) => "clip-triangle-opening-walk",
            (Mistake::None, Space::Clip) => "clip-triangle-opening",
            (Mistake::None, Space::Camera) => "clip-triangle-opening-camera",
        })
    }

    pub(super) fn say(&self, event: &Event) -> Message {
        match *event {
            Event::Divide { vertex, at: [x, y, z, _] } => {
                let w = self.subject.in_clip_space()[usize::from(vertex)][3];
                let id = if w > 0.0 {
                    "clip-triangle-divide"
                } else if w < 0.0 {
                    "clip-triangle-divide-behind"
                } else {
                    "clip-triangle-divide-zero"
                };
                self.about_vertex(id, vertex).with("w", w).with("at", [x, y, z])
            }
            Event::Lost { vertex } => self.about_vertex("clip-triangle-lost", vertex),
            Event::Clip(_, step) => self.say_step(&step),
            Event::Attribute { corner, value } => self.say_attribute(usize::from(corner), value),
            Event::Triangle { corners } => {
                let names = corners.map(|i| self.corner_name(usize::from(i)));
                Message::new("clip-triangle-triangle").with("corners", Value::text(names.join(", ")))
            }
            Event::Done { corners } => {
                let id = match (corners, self.subject.settings.mistake) {
                    (0, _) => "clip-triangle-done-nothing",
                    (_, Mistake::DivideFirst) => "clip-triangle-done-divide",
                    (_, Mistake::NoNearPlane) => "clip-triangle-done-no-near",
                    _ => "clip-triangle-done",
                };
                Message::new(id)
                    .with("corners", u32::from(corners))
                    .with("right", self.correct.corners.len())
                    .with("triangles", u32::from(corners.saturating_sub(2)))
            }
        }
    }

    fn about_vertex(&self, id: &'static str, vertex: u8) -> Message {
        Message::new(id).with("vertex", Value::text(format!("v{vertex}")))
    }

    fn corner_name(&self, index: usize) -> String {
        self.corners.get(index).map_or_else(String::new, |corner| corner.name.clone())
    }

    fn say_step(&self, step: &Step) -> Message {
        let plane = self.plane.unwrap_or(Plane::Near);
        let at_plane = |id| Message::new(id).with("plane", Value::Word(plane.word()));
        match *step {
            Step::Plane { outside, of, .. } => {
                let names = (0..of).filter(|i| outside >> i & 1 == 1);
                let exact = self.subject.settings.arithmetic.is_exact();
                let name = |i: u8| if exact { format!("v{i}") } else { self.corner_name(usize::from(i)) };
                let names: Vec<_> = names.map(name).collect();
                at_plane("clip-triangle-plane")
                    .with("inside", Value::text(self.inequality(plane)))
                    .with("count", names.len())
                    .with("names", Value::text(names.join(", ")))
            }
            Step::Keep => at_plane("clip-triangle-keep"),
            Step::Reject => at_plane("clip-triangle-reject"),
            Step::Side { corner, side, distance } => at_plane(match side {
                Sign::Positive => "clip-triangle-side-in",
                Sign::Zero => "clip-triangle-side-on",
                Sign::Negative => "clip-triangle-side-out",
            })
            .with("corner", Value::text(self.corner_name(usize::from(corner))))
            .with("d", distance),
            Step::Edge { from, kept, crossing } => {
                let from = usize::from(from);
                let to = (from + 1) % self.corners.len().max(1);
                let emitted = self.walked.last().and_then(|walked| walked.emitted.clone());
                at_plane(match (kept, crossing.is_some()) {
                    (true, true) => "clip-triangle-leaves",
                    (false, true) => "clip-triangle-enters",
                    (true, false) => "clip-triangle-stays-in",
                    (false, false) => "clip-triangle-stays-out",
                })
                .with("from", Value::text(self.corner_name(from)))
                .with("to", Value::text(self.corner_name(to)))
                .with("new", Value::text(emitted.unwrap_or_default()))
            }
            Step::Next { corners: 0 } => at_plane("clip-triangle-next-nothing"),
            Step::Next { corners } => at_plane("clip-triangle-next").with("corners", u32::from(corners)),
            Step::Round { at, .. } => {
                let index = self.rounded.len().saturating_sub(1);
                let id = match self.corners.get(index).map(|corner| corner.origin) {
                    Some(Origin::Vertex(_)) => "clip-triangle-round-vertex",
                    Some(Origin::Interior { .. }) => "clip-triangle-round-interior",
                    _ => "clip-triangle-round",
                };
                Message::new(id).with("corner", Value::text(self.corner_name(index))).with("at", at)
            }
            Step::Merge { .. } => Message::new("clip-triangle-merge"),
        }
    }

    fn say_attribute(&self, corner: usize, value: f32) -> Message {
        let origin = self.corners.get(corner).map_or(Origin::Vertex(0), |corner| corner.origin);
        let right = self.correct_at(origin).map(|there| there.attribute);
        let id = match (origin, self.subject.settings.mistake) {
            (Origin::Vertex(_), _) => "clip-triangle-attribute-vertex",
            (_, Mistake::NoAttributes) => "clip-triangle-attribute-missing",
            _ => "clip-triangle-attribute",
        };
        Message::new(id)
            .with("corner", Value::text(self.corner_name(corner)))
            .with("value", value)
            .with("right", right)
    }
}
