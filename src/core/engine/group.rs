//! The triangles of a tile, and a few of them side by side, one a lane.
//!
//! *Source:* Intel 64 and IA-32 Architectures Optimization Reference Manual, 2016, section 6.5.1 (data arrangement) and
//! chapter 7 (prefetching).

use super::lanes::LANES;
use wide::f32x4;

/// Up to [`LANES`] triangles, one a lane; those that are missing have no area.
#[repr(align(64))]
pub(super) struct Group {
    /// Vertices: x and y in pixels, depth.
    pub(super) corners: [[[f32; LANES]; 3]; 3],
    /// Colour codes, or numbers from 1.
    pub(super) colors: [u32; LANES],
}

impl Group {
    /// None.
    pub(super) const NOTHING: Self = Self { corners: [[[0.0; LANES]; 3]; 3], colors: [0; LANES] };

    /// The first of some triangles.
    #[inline(always)]
    pub(super) fn new(entries: &[Entry]) -> Self {
        match entries.first_chunk() {
            Some(all) => Self::of(all),
            None => Self::of_last(entries),
        }
    }

    #[cold]
    #[inline(never)]
    fn of_last(entries: &[Entry]) -> Self {
        let mut few = [Entry::NOTHING; LANES];
        few.iter_mut().zip(entries).for_each(|(entry, other)| *entry = *other);
        Self::of(&few)
    }

    /// Of those of a list whose places are given. In place of a colour they have their place, from 1.
    #[inline(always)]
    pub(super) fn at(places: &[u32], entries: &[Entry]) -> Self {
        let mut few = [Entry::NOTHING; LANES];
        for (entry, place) in few.iter_mut().zip(places) {
            if let Some(other) = entries.get(*place as usize) {
                *entry = Entry { color: f32::from_bits(place + 1), ..*other };
            }
        }
        Self::of(&few)
    }

    #[inline(always)]
    fn of(all: &[Entry; LANES]) -> Self {
        let [a, b, c, d, e, f, g, h] = all;
        let mut group = Self::NOTHING;
        group.put(0, [a.vertices(), b.vertices(), c.vertices(), d.vertices()]);
        group.put(LANES / 2, [e.vertices(), f.vertices(), g.vertices(), h.vertices()]);
        group
    }

    /// Puts in four triangles. By shuffles of four numbers: what the compiler makes of nine loops over the lanes is
    /// slower.
    #[inline(always)]
    pub(super) fn put(&mut self, first: usize, [a, b, c, d]: [[f32x4; 3]; 4]) {
        for corner in 0..3 {
            let rows = f32x4::transpose([a[corner], b[corner], c[corner], d[corner]]);
            for axis in 0..3 {
                let row = rows[axis].to_array();
                self.corners[corner][axis][first..first + LANES / 2].copy_from_slice(&row);
            }
            if corner == 2 {
                let colors = rows[3].to_array().map(f32::to_bits);
                self.colors[first..first + LANES / 2].copy_from_slice(&colors);
            }
        }
    }

    /// The vertices of one.
    pub(super) fn triangle(&self, lane: usize) -> [[f32; 3]; 3] {
        self.corners.map(|corner| corner.map(|all| all[lane]))
    }
}

/// A triangle in a list. A copy, since the lists are read one after another, but the triangles in a list lie far
/// apart in memory.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// Vertices: x and y in pixels, depth.
    pub(super) corners: [[f32; 3]; 3],
    /// Its colour codes, or its number from 1 if they are painted; the bits of a number, so that it goes where the
    /// others go.
    color: f32,
}

impl Entry {
    const NOTHING: Self = Self { corners: [[0.0; 3]; 3], color: 0.0 };

    /// Of vertices and a colour or a number.
    #[inline(always)]
    pub(super) fn new(corners: [[f32; 3]; 3], color: u32) -> Self {
        Self { corners, color: f32::from_bits(color) }
    }

    /// Each vertex with a number more: what follows it, at last the colour.
    #[inline(always)]
    fn vertices(&self) -> [f32x4; 3] {
        let Self { corners: [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]], color } = *self;
        [f32x4::new([x0, y0, z0, x1]), f32x4::new([x1, y1, z1, x2]), f32x4::new([x2, y2, z2, color])]
    }

    /// The depth of its nearest vertex.
    #[inline(always)]
    pub(super) fn nearest(&self) -> f32 {
        let [[.., a], [.., b], [.., c]] = self.corners;
        a.min(b).min(c)
    }

    /// Its colour codes or its number.
    pub(super) fn color(&self) -> u32 {
        self.color.to_bits()
    }
}

/// The triangles of a tile, in the order of drawing.
#[derive(Clone, Debug, Default)]
pub(super) struct List {
    /// Those behind the first `len` are to be written.
    entries: Vec<Entry>,
    len: usize,
}

impl List {
    /// Empties it, keeping its room.
    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    /// Adds a triangle.
    #[inline(always)]
    pub(super) fn push(&mut self, entry: Entry) {
        if self.len == self.entries.len() {
            self.grow();
        }
        self.entries[self.len] = entry;
        self.len += 1;
        // The lists take turns: when this one is written to again, the place is there.
        #[cfg(target_arch = "x86_64")]
        self.entries.get(self.len + 1).into_iter().for_each(safe_arch::prefetch_t0);
    }

    /// All of them.
    pub(super) fn entries(&self) -> &[Entry] {
        &self.entries[..self.len]
    }

    #[cold]
    #[inline(never)]
    fn grow(&mut self) {
        self.entries.resize((2 * self.len).max(LANES), Entry::NOTHING);
    }
}
