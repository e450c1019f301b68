//! What of clip space a draw is seen in: between all six planes, or beyond near and far, too.

use super::stages::Point;
use crate::{
    clip::polygon::{
        Plane, PlaneSet, Polygon,
        clip_space::{ClipSpace, Event, clip_exact},
        clip_triangle, distance_is_negative,
    },
    cull::frustum::{outcode, triangle_outside},
    math::Tally,
    trace::NoTrace,
    transform::DepthRange,
};

/// The planes that clip a draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Visible {
    pub(super) range: DepthRange,
    /// Near and far do not clip. The other four leave nothing behind the eye by themselves: `|x| <= w`.
    pub(super) unclipped: bool,
}

/// The planes beside the picture, the first ones of [`Plane::ALL`].
const SIDES: [Plane; 4] = [Plane::Left, Plane::Right, Plane::Bottom, Plane::Top];

impl Visible {
    /// Whether a plane clips.
    pub(super) fn clips_at(&self, plane: Plane) -> bool {
        !self.unclipped || SIDES.contains(&plane)
    }

    /// Which of the planes a point lies strictly outside of, one bit each, as in [`outcode`].
    #[inline]
    pub(super) fn outcode(&self, point: Point) -> u8 {
        let sides = if self.unclipped { (1 << SIDES.len()) - 1 } else { u8::MAX };
        outcode(point, self.range) & sides
    }

    /// The first of the planes that all three vertices lie strictly outside of.
    #[inline]
    pub(super) fn outside(&self, clip: [Point; 3]) -> Option<Plane> {
        if !self.unclipped {
            return triangle_outside(clip, self.range);
        }
        let all = |plane: &Plane| clip.iter().all(|&v| distance_is_negative(*plane, v, self.range));
        SIDES.into_iter().find(all)
    }

    /// What is left of a triangle.
    #[inline]
    pub(super) fn clip(&self, vertices: [Point; 3], tally: &mut Tally) -> Polygon {
        if !self.unclipped {
            return clip_triangle(vertices, self.range, PlaneSet::All, tally);
        }
        clip_exact(vertices, self.region(), &SIDES, tally, &mut NoTrace)
    }

    fn region(&self) -> ClipSpace {
        ClipSpace { range: self.range, guard: 1.0 }
    }

    /// Which planes left nothing of a triangle.
    pub(super) fn removed(&self, vertices: [Point; 3], tally: &mut Tally) -> Removed {
        let mut events: Vec<Event> = Vec::new();
        let planes = if self.unclipped { &SIDES[..] } else { &Plane::ALL };
        clip_exact(vertices, self.region(), planes, tally, &mut events);
        let mut removed = Removed { last: None, others: Planes::default() };
        let mut plane = None;
        for event in events {
            match event {
                Event::Plane { plane: next, .. } => plane = Some(next),
                Event::Reject | Event::Next { corners: 0 } => removed.last = plane,
                Event::Next { .. } => plane.into_iter().for_each(|plane| removed.others.insert(plane)),
                _ => {}
            }
        }
        removed
    }
}

/// The planes that left nothing of a triangle; decided by exact signs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Removed {
    /// The one that removed what was left; `None` if only rounding did, to no area or to the eye's own point.
    pub last: Option<Plane>,
    /// Those that had cut something off before.
    pub others: Planes,
}

/// A set of planes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Planes(u8);

impl Planes {
    fn insert(&mut self, plane: Plane) {
        self.0 |= 1 << plane as u8;
    }

    /// Whether there is none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The planes, in the order in which they cut.
    pub fn iter(self) -> impl Iterator<Item = Plane> {
        Plane::ALL.into_iter().filter(move |plane| self.0 & 1 << *plane as u8 != 0)
    }
}
