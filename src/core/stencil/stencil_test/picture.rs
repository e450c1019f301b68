//! The drawing of a stencil run: the value of every pixel, the shapes, and where their corners went.

use std::collections::BTreeMap;

use super::{Draw, Snapshot};
use crate::{
    depth::z_buffer::Triangle,
    explain::{Cells, Label, Mark, Role, Sign},
    message::{Message, Value},
};

/// Of a draw with more triangles it is not shown where each corner went.
const MOST_TRIANGLES: usize = 64;

impl Cells for Snapshot {
    fn size(&self) -> [u32; 2] {
        self.settings.raster.size
    }

    fn object(&self, pixel: [u32; 2]) -> Option<usize> {
        self.image.owner(pixel).map(|owner| owner as usize)
    }

    fn cell(&self, pixel: [u32; 2], role: Role) -> Mark {
        let value = Value::Int(self.image.value(pixel).into());
        Mark::Pixel { at: pixel.map(|n| n as i32), role, object: self.object(pixel), value }
    }

    fn is_used(&self, pixel: [u32; 2]) -> bool {
        self.image.owner(pixel).is_some() || self.image.value(pixel) != self.settings.clear
    }

    fn verdicts(&self) -> &[([u16; 2], Role)] {
        &self.verdicts
    }

    fn row(&self) -> u32 {
        self.y
    }
}

impl Snapshot {
    /// The outlines of the draws, that in hand in the text colour; of an enlarged one also where it
    /// stood.
    pub(super) fn mark_shapes(&self, out: &mut Vec<Mark>) {
        let current = self.draw.map(|index| index as usize);
        for (index, draw) in self.draws.iter().enumerate() {
            if Some(index) == current {
                self.mark_current(draw, index, out);
            } else if draw.enlarged.is_none() {
                shape(&draw.triangles, Role::Candidate, Some((draw, index)), out);
            }
        }
    }

    fn mark_current(&self, draw: &Draw, index: usize, out: &mut Vec<Mark>) {
        let Some((_, before)) = draw.enlarged.as_ref() else {
            return shape(&draw.triangles, Role::Neutral, Some((draw, index)), out);
        };
        shape(before, Role::Candidate, None, out);
        if !self.enlarged {
            return;
        }
        shape(&draw.triangles, Role::Neutral, Some((draw, index)), out);
        // Where corners went; clipping may have made other corners.
        if before.len() == draw.triangles.len() && before.len() <= MOST_TRIANGLES {
            let mut ends: Vec<_> = before
                .iter()
                .flatten()
                .zip(draw.triangles.iter().flatten())
                .map(|(a, b)| [[a[0], a[1]], [b[0], b[1]]])
                .collect();
            ends.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
            ends.dedup();
            out.extend(ends.into_iter().map(|ends| Mark::Segment { ends, role: Role::Changed, label: None }));
        }
    }

    /// What ticks, crosses and outlines mean.
    pub(super) fn legend(&self, out: &mut Vec<Mark>) {
        let Some((draw, _)) = self.current() else { return };
        let mut key = |role, sign, id| {
            let meaning = Message::new(id).with("object", Value::text(&draw.name));
            out.push(Mark::Key { role, sign, meaning });
        };
        key(Role::Accepted, Sign::Marker, "stencil-key-passed");
        key(Role::Rejected, Sign::Marker, "stencil-key-failed");
        key(Role::Neutral, Sign::Line, "stencil-key-object");
    }
}

/// The border of a shape: loops, the first with the name, if every corner of it is left once; else edges.
fn shape(triangles: &[Triangle], role: Role, named: Option<(&Draw, usize)>, out: &mut Vec<Mark>) {
    let edges = border(triangles);
    let mut label = named.map(|(draw, index)| Label::name(&draw.name).of(index));
    match loops(&edges) {
        Some(loops) => out.extend(loops.into_iter().map(|points| Mark::Polygon {
            points,
            role,
            object: None,
            label: label.take(),
        })),
        None => {
            out.extend(edges.into_iter().map(|ends| Mark::Segment { ends, role, label: label.take() }));
        }
    }
}

/// Two points are the same if their bits are; zero has one sign.
fn key(point: [f32; 2]) -> [u32; 2] {
    point.map(|c| (c + 0.0).to_bits())
}

/// The edges that belong to one triangle only, each in the order of its triangle.
fn border(triangles: &[Triangle]) -> Vec<[[f32; 2]; 2]> {
    let corners =
        |[a, b]: [usize; 2], triangle: &Triangle| [triangle[a], triangle[b]].map(|[x, y, _]| [x, y]);
    let sides = |triangle| [[0, 1], [1, 2], [2, 0]].map(|ends| corners(ends, triangle));
    let edges: Vec<_> = triangles.iter().flat_map(sides).collect();
    let pair = |ends: &[[f32; 2]; 2]| {
        let mut pair = ends.map(key);
        pair.sort_unstable();
        pair
    };
    let mut times = BTreeMap::new();
    for ends in &edges {
        *times.entry(pair(ends)).or_insert(0) += 1;
    }
    edges.into_iter().filter(|ends| times[&pair(ends)] == 1).collect()
}

/// The edges one after the other, as closed polygons; `None` if two begin at one corner.
fn loops(edges: &[[[f32; 2]; 2]]) -> Option<Vec<Vec<[f32; 2]>>> {
    let mut next: BTreeMap<_, _> = edges.iter().map(|[from, to]| (key(*from), *to)).collect();
    if next.len() != edges.len() {
        return None;
    }
    let mut all = Vec::new();
    while let Some((&first, _)) = next.first_key_value() {
        let (mut points, mut at) = (Vec::new(), first);
        while let Some(to) = next.remove(&at) {
            points.push(to);
            at = key(to);
        }
        if at != first {
            return None;
        }
        all.push(points);
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_triangles_of_a_square_have_its_border() {
        let [a, b, c, d] = [[0.0, 0.0, 0.5], [2.0, 0.0, 0.5], [2.0, 2.0, 0.5], [0.0, 2.0, 0.5]];
        let edges = border(&[[a, b, c], [a, c, d]]);
        assert_eq!(edges.len(), 4);
        let loops = loops(&edges).expect("it is one loop");
        assert_eq!(loops, [[[2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]]]);
    }

    #[test]
    fn triangles_that_meet_in_a_corner_only_have_no_loop() {
        let [a, b, c] = [[0.0, 0.0, 0.5], [2.0, 0.0, 0.5], [0.0, 2.0, 0.5]];
        let [d, e] = [[-2.0, 0.0, 0.5], [0.0, -2.0, 0.5]];
        assert_eq!(loops(&border(&[[a, b, c], [a, d, e]])), None);
    }
}
