//! Front to back: the triangles of a tile in the order of their nearest vertices, so that the first ones hide most of
//! the others.
//!
//! Where the lesser depth wins and of equal ones the first, the result is the least pair of depth and place in the
//! order of drawing: it does not depend on the order in which triangles are looked at. Pixels hold places until the
//! tile is finished.
//!
//! *Source:* Greene, Kass, Miller, Hierarchical Z-Buffer Visibility, SIGGRAPH 1993 (what is near first); Knuth, The Art
//! of Computer Programming, vol. 3, section 5.2, Algorithm D (distribution counting). Deviation: only nearly sorted.

use super::group::Entry;

/// Into so many parts the range of depths is divided.
const PARTS: usize = 64;

/// The triangles of a tile, sorted.
pub(super) struct Foremost {
    /// Which comes first, and so on.
    pub(super) order: Vec<u32>,
    /// Colour codes for each number that a pixel may hold: of none, then of each triangle.
    pub(super) colors: Vec<u32>,
    /// To which part of the range each belongs.
    parts: Vec<u8>,
    /// No triangle of a part or of those behind it has a nearer vertex.
    nearest: [f32; PARTS],
}

impl Default for Foremost {
    fn default() -> Self {
        Self { order: Vec::new(), colors: Vec::new(), parts: Vec::new(), nearest: [f32::INFINITY; PARTS] }
    }
}

impl Foremost {
    /// Sorts the triangles of a list. Whether there is anything to sort: not if most of them are already nearly as they
    /// should be. Cost: linear in their number.
    pub(super) fn sort(&mut self, list: &[Entry]) -> bool {
        let (mut least, mut most) = (f32::INFINITY, f32::NEG_INFINITY);
        for entry in list {
            let depth = entry.nearest();
            (least, most) = (least.min(depth), most.max(depth));
        }
        if least >= most {
            return false;
        }
        let scale = (PARTS - 1) as f64 / (f64::from(most) - f64::from(least));
        let mut ends = [0; PARTS];
        self.parts.clear();
        self.nearest = [f32::INFINITY; PARTS];
        let (mut last, mut back) = (0, 0);
        for entry in list {
            let depth = entry.nearest();
            let part = ((f64::from(depth) - f64::from(least)) * scale) as usize % PARTS;
            ends[part] += 1;
            self.nearest[part] = self.nearest[part].min(depth);
            self.parts.push(part as u8);
            back += usize::from(part < last);
            last = part;
        }
        if back < list.len() / 3 {
            return false;
        }
        for part in 1..PARTS {
            ends[part] += ends[part - 1];
        }
        for part in (1..PARTS).rev() {
            self.nearest[part - 1] = self.nearest[part - 1].min(self.nearest[part]);
        }
        self.order.clear();
        self.order.resize(list.len(), 0);
        for (place, part) in self.parts.iter().enumerate().rev() {
            let end = &mut ends[usize::from(*part)];
            *end -= 1;
            self.order[*end] = place as u32;
        }
        self.colors.clear();
        self.colors.push(0);
        self.colors.extend(list.iter().map(Entry::color));
        true
    }

    /// No vertex is nearer than this of the triangles from one on, counted in their order.
    #[inline(always)]
    pub(super) fn nearest_from(&self, index: usize) -> f32 {
        let part = self.parts[self.order[index] as usize];
        self.nearest[usize::from(part) % PARTS]
    }
}
