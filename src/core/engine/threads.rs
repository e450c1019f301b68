//! Rows of tiles shared out among threads; the same bytes for any number of them, since no two touch the same pixel.
//!
//! Without the feature `parallel` there is only the thread that calls.

use super::{Stats, canvas::Strip, tile::Tile};

/// How many threads draw, at most.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Threads(usize);

impl Default for Threads {
    /// One.
    fn default() -> Self {
        Self::ONE
    }
}

impl Threads {
    /// Only the one that calls.
    pub const ONE: Self = Self(1);

    /// So many; 0 counts as 1. Without the feature `parallel` always one.
    pub const fn new(threads: usize) -> Self {
        if cfg!(feature = "parallel") && threads > 1 { Self(threads) } else { Self::ONE }
    }

    /// As many as the machine runs at once.
    pub fn available() -> Self {
        #[cfg(feature = "parallel")]
        return Self::new(std::thread::available_parallelism().map_or(1, std::num::NonZero::get));
        #[cfg(not(feature = "parallel"))]
        Self::ONE
    }

    /// How many are worth starting: one costs as much as some hundred small triangles.
    pub(super) fn worth(self, strips: usize, triangles: usize) -> usize {
        const FEW: usize = 256;
        self.0.min(strips).min(1 + triangles / FEW).max(1)
    }
}

/// Has `draw` take strips until none is left, once for each tile, which is a thread of its own; adds up what they
/// count.
pub(super) fn share(
    strips: Vec<Strip<'_>>,
    tiles: &mut [Tile],
    draw: impl Fn(&mut dyn Iterator<Item = Strip<'_>>, &mut Tile) -> Stats + Sync,
) -> Stats {
    match tiles {
        [tile] => draw(&mut strips.into_iter(), tile),
        _ => share_among_threads(strips, tiles, draw),
    }
}

#[cfg(feature = "parallel")]
fn share_among_threads(
    strips: Vec<Strip<'_>>,
    tiles: &mut [Tile],
    draw: impl Fn(&mut dyn Iterator<Item = Strip<'_>>, &mut Tile) -> Stats + Sync,
) -> Stats {
    let strips = std::sync::Mutex::new(strips.into_iter());
    let take = || strips.lock().ok()?.next();
    let work = |tile: &mut Tile| draw(&mut std::iter::from_fn(take), tile);
    let mut sum = Stats::default();
    std::thread::scope(|scope| {
        let workers: Vec<_> = tiles.iter_mut().map(|tile| scope.spawn(|| work(tile))).collect();
        for worker in workers {
            match worker.join() {
                Ok(stats) => sum += stats,
                Err(panic) => std::panic::resume_unwind(panic),
            }
        }
    });
    sum
}

#[cfg(not(feature = "parallel"))]
fn share_among_threads(
    strips: Vec<Strip<'_>>,
    tiles: &mut [Tile],
    draw: impl Fn(&mut dyn Iterator<Item = Strip<'_>>, &mut Tile) -> Stats + Sync,
) -> Stats {
    let mut none = Tile::default();
    draw(&mut strips.into_iter(), tiles.first_mut().unwrap_or(&mut none))
}
