//! The four mixes.

use super::{Segment, Sides, oracle};
use crate::random::Random;

#[derive(Clone, Copy)]
pub enum Mix {
    /// Both ends inside.
    Inside,
    /// Nothing visible; ends anywhere in a box of three times the window's size.
    Outside,
    /// Cut once or twice; ends anywhere in that box.
    Crossing,
    /// Past a corner of the window from one side to the other, within the rounding of an end of it: on
    /// either side, and, of the one in sixteen that is as long before the corner as behind, through it.
    Grazing,
}

impl Mix {
    pub const ALL: [Self; 4] = [Self::Inside, Self::Outside, Self::Crossing, Self::Grazing];

    pub fn name(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Outside => "outside",
            Self::Crossing => "crossing",
            Self::Grazing => "grazing a corner",
        }
    }
}

pub fn segments(mix: Mix, window: Sides, count: usize) -> Vec<Segment> {
    let mut random = Random::new(mix as u64 + 1);
    let mut segments = Vec::with_capacity(count);
    while segments.len() < count {
        let segment = match mix {
            Mix::Inside => within(&mut random, window, 0.0),
            Mix::Outside | Mix::Crossing => within(&mut random, window, 1.0),
            Mix::Grazing => past_a_corner(&mut random, window),
        };
        let visible = oracle::visible(segment, window);
        let wanted = match mix {
            Mix::Inside => visible == Some(segment),
            Mix::Outside => visible.is_none(),
            Mix::Crossing => visible.is_some_and(|part| part != segment),
            Mix::Grazing => true,
        };
        if wanted {
            segments.push(segment);
        }
    }
    segments
}

/// Ends anywhere in the window, widened on each side by `margin` times its size.
fn within(random: &mut Random, [xmin, ymin, xmax, ymax]: Sides, margin: f64) -> Segment {
    let mut coordinate = |min: f32, max: f32| {
        let (min, max) = (f64::from(min), f64::from(max));
        let room = margin * (max - min);
        random.uniform(min - room, max + room) as f32
    };
    let mut point = || [coordinate(xmin, xmax), coordinate(ymin, ymax)];
    [point(), point()]
}

/// Diagonally across a corner, and through it but for the rounding of the second end.
fn past_a_corner(random: &mut Random, [xmin, ymin, xmax, ymax]: Sides) -> Segment {
    let (right, top) = (random.below(2) == 1, random.below(2) == 1);
    let corner = [if right { xmax } else { xmin }, if top { ymax } else { ymin }];
    let falling = if right == top { -1.0 } else { 1.0 };
    let size = f64::from(xmax - xmin);
    let (dx, slope) = (random.uniform(0.1, 0.9) * size, random.uniform(0.2, 5.0) * falling);
    let back = if random.below(16) == 0 { 1.0 } else { random.uniform(0.3, 3.0) };
    let p = [corner[0] + dx as f32, corner[1] + (dx * slope) as f32];
    let q = [0, 1].map(|axis| {
        let c = f64::from(corner[axis]);
        (c + back * (c - f64::from(p[axis]))) as f32
    });
    if random.below(2) == 0 { [p, q] } else { [q, p] }
}
