//! Stamps: 4 x 4 pixels that go through the lanes together and lie together in a tile's memory.
//!
//! *Source:* McCormack and McNamara, Tiled Polygon Traversal Using Half-Plane Edge Functions, Graphics Hardware 2000.

use super::canvas::TILE;

/// Columns and rows of a stamp.
pub(super) const SIDE: usize = 4;

/// Its pixels, row by row.
pub(super) const STAMP: usize = SIDE * SIDE;

/// Stamps beside each other in a tile, and all of a tile.
pub(super) const ACROSS: usize = TILE / SIDE;
pub(super) const STAMPS: usize = ACROSS * ACROSS;

/// What each pixel of a stamp has.
pub(super) type Each<T> = [T; STAMP];

/// How far each pixel lies to the right of the first one and below it. In memory: of constants the compiler would take
/// apart what goes through the lanes together.
#[repr(align(64))]
pub(super) struct Steps {
    pub(super) x: Each<f32>,
    pub(super) y: Each<f32>,
}

impl Steps {
    #[inline(never)]
    pub(super) fn new() -> Self {
        let mut steps = Self { x: [0.0; STAMP], y: [0.0; STAMP] };
        for i in 0..STAMP {
            (steps.x[i], steps.y[i]) = ((i % SIDE) as f32, (i / SIDE) as f32);
        }
        steps
    }
}

/// Which stamp of a tile, counted row by row.
#[derive(Clone, Copy)]
pub(super) struct Place(pub(super) u32);

impl Place {
    /// That with a pixel of the tile.
    #[inline(always)]
    pub(super) fn of([x, y]: [usize; 2]) -> Self {
        Self((y / SIDE * ACROSS + x / SIDE) as u32)
    }

    /// Its number.
    #[inline(always)]
    pub(super) fn number(self) -> usize {
        self.0 as usize % STAMPS
    }

    /// Column and row of its first pixel in the tile.
    #[inline(always)]
    pub(super) fn first(self) -> [usize; 2] {
        [self.number() % ACROSS * SIDE, self.number() / ACROSS * SIDE]
    }

    /// Column and row of one of its pixels.
    #[inline(always)]
    pub(super) fn pixel(self, i: usize) -> [usize; 2] {
        let [x, y] = self.first();
        [x + i % SIDE, y + i / SIDE]
    }
}

/// The stamps with the pixels of a row of a tile.
#[inline(always)]
pub(super) fn band<T>(stamps: &[Each<T>; STAMPS], y: usize) -> &[Each<T>; ACROSS] {
    &stamps.as_chunks().0[y / SIDE]
}

/// The same, to be changed.
#[inline(always)]
pub(super) fn band_mut<T>(stamps: &mut [Each<T>; STAMPS], y: usize) -> &mut [Each<T>; ACROSS] {
    &mut stamps.as_chunks_mut().0[y / SIDE]
}

/// Gives the first pixels of row `y` what those of the stamps there have.
#[inline(always)]
pub(super) fn copy_row<T: Copy>(band: &[Each<T>; ACROSS], y: usize, row: &mut [T]) {
    // By parts of a known length, which are copied at once.
    let (parts, rest) = row.as_chunks_mut::<SIDE>();
    for (to, from) in parts.iter_mut().zip(band) {
        *to = from.as_chunks().0[y % SIDE];
    }
    if let Some(from) = band.get(parts.len()) {
        rest.copy_from_slice(&from.as_chunks::<SIDE>().0[y % SIDE][..rest.len()]);
    }
}

/// The other way round.
#[inline(always)]
pub(super) fn set_row<T: Copy>(band: &mut [Each<T>; ACROSS], y: usize, row: &[T]) {
    let (parts, rest) = row.as_chunks::<SIDE>();
    for (from, to) in parts.iter().zip(&mut *band) {
        to.as_chunks_mut().0[y % SIDE] = *from;
    }
    if let Some(to) = band.get_mut(parts.len()) {
        to.as_chunks_mut::<SIDE>().0[y % SIDE][..rest.len()].copy_from_slice(rest);
    }
}
