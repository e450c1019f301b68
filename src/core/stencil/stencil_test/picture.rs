//! The drawing of a stencil run: the value of every pixel, the shapes, and where their corners went.

use super::{Draw, Snapshot};
use crate::{
    depth::z_buffer::Triangle,
    explain::{Cells, Label, Mark, Role, Sign},
    message::{Message, Value},
};

/// Of a draw with more triangles only the edges on its border are drawn.
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

    fn verdicts(&self) -> &[([u16; 2], bool)] {
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

/// The edges of a shape that belong to one of its triangles only, or all of few triangles.
fn shape(triangles: &[Triangle], role: Role, named: Option<(&Draw, usize)>, out: &mut Vec<Mark>) {
    let edges = border(triangles);
    let mut label = named.map(|(draw, index)| Label::name(&draw.name).of(index));
    for (i, triangle) in triangles.iter().enumerate() {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let ends = [triangle[a], triangle[b]].map(|[x, y, _]| [x, y]);
            if edges[3 * i + a] {
                out.push(Mark::Segment { ends, role, label: label.take() });
            }
        }
    }
}

/// Whether each edge belongs to one triangle only.
fn border(triangles: &[Triangle]) -> Vec<bool> {
    let key = |[x, y, _]: [f32; 3]| [x, y].map(|c| (c + 0.0).to_bits());
    let mut ends: Vec<_> = Vec::with_capacity(3 * triangles.len());
    for triangle in triangles {
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            let mut pair = [key(triangle[a]), key(triangle[b])];
            pair.sort_unstable();
            ends.push(pair);
        }
    }
    let mut sorted = ends.clone();
    sorted.sort_unstable();
    let times = |pair| {
        let begin = sorted.partition_point(|other| other < pair);
        sorted[begin..].partition_point(|other| other <= pair)
    };
    ends.iter().map(|pair| times(pair) == 1).collect()
}
