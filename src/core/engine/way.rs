//! The two ways in which the triangles of a tile become colours.

use super::{
    Arbiter, Clear, Mesh, PaintOrder, Painter, Stats,
    canvas::Strip,
    fill::Job,
    foremost::Foremost,
    group::Entry,
    ink::{Flat, Ink, Numbers, Wet},
    paint::Brushes,
    smooth::Smooth,
    tile::Tile,
};

/// How the triangles of a tile become colours: first they are drawn, then the tile is given back.
pub(super) trait Way: Sync {
    /// Whether fragments are counted.
    const COUNTS: bool;
    /// What is kept from tile to tile.
    type Kit<'k>
    where
        Self: 'k;

    fn kit(&self) -> Self::Kit<'_>;
    /// `clear`: what the pixels' colours are to be at first, else those that the tile holds.
    fn draw(
        kit: &mut Self::Kit<'_>,
        tile: &mut Tile,
        clear: Option<[u8; 4]>,
        job: Job<'_>,
        list: &[Entry],
        stats: &mut Stats,
    );
    /// `at`: the number of the tile in its strip, and its first column.
    fn store(
        kit: &mut Self::Kit<'_>,
        tile: &mut Tile,
        strip: &mut Strip<'_>,
        at: (usize, u32),
        clear: Option<&Clear>,
        stats: &mut Stats,
    );
}

/// One colour a triangle.
pub(super) struct Plain;

/// By the colours at the vertices of a mesh.
pub(super) struct Meshed<'p, A: Arbiter>(pub(super) &'p Mesh<'p, A>);

/// By a painter.
pub(super) struct Painted<'p, P: Painter>(pub(super) &'p P);

impl Way for Plain {
    const COUNTS: bool = Flat::COUNTS;
    /// If the triangles of the tile are sorted.
    type Kit<'k> = (Foremost, bool);

    fn kit(&self) -> (Foremost, bool) {
        Default::default()
    }

    fn draw(
        (foremost, sorted): &mut (Foremost, bool),
        tile: &mut Tile,
        clear: Option<[u8; 4]>,
        job: Job<'_>,
        list: &[Entry],
        stats: &mut Stats,
    ) {
        *sorted = job.rules.sorts && foremost.sort(list);
        if *sorted {
            stats.sorted += 1;
            tile.number();
            tile.draw_foremost(job, (list, foremost), stats);
        } else {
            clear.into_iter().for_each(|color| tile.fill_colors(color));
            tile.draw(&mut Flat, job, list, stats);
        }
    }

    fn store(
        (foremost, sorted): &mut (Foremost, bool),
        tile: &mut Tile,
        strip: &mut Strip<'_>,
        (_, left): (usize, u32),
        clear: Option<&Clear>,
        _: &mut Stats,
    ) {
        if *sorted {
            tile.store_numbered(strip, left, clear, &mut foremost.colors);
        } else {
            tile.store(strip, left);
        }
    }
}

impl<A: Arbiter> Way for Meshed<'_, A> {
    const COUNTS: bool = false;
    type Kit<'k>
        = Smooth<'k, A>
    where
        Self: 'k;

    fn kit(&self) -> Smooth<'_, A> {
        Smooth::new(self.0)
    }

    fn draw(
        smooth: &mut Smooth<'_, A>,
        tile: &mut Tile,
        clear: Option<[u8; 4]>,
        job: Job<'_>,
        list: &[Entry],
        stats: &mut Stats,
    ) {
        clear.into_iter().for_each(|color| tile.fill_colors(color));
        tile.draw_mesh(smooth, job, list, stats);
    }

    fn store(
        _: &mut Smooth<'_, A>,
        tile: &mut Tile,
        strip: &mut Strip<'_>,
        (_, left): (usize, u32),
        _: Option<&Clear>,
        _: &mut Stats,
    ) {
        tile.store(strip, left);
    }
}

impl<P: Painter> Way for Painted<'_, P> {
    const COUNTS: bool = Numbers::COUNTS;
    type Kit<'k>
        = Brushes<'k, P>
    where
        Self: 'k;

    fn kit(&self) -> Brushes<'_, P> {
        Brushes::new(self.0)
    }

    fn draw(
        brushes: &mut Brushes<'_, P>,
        tile: &mut Tile,
        clear: Option<[u8; 4]>,
        job: Job<'_>,
        list: &[Entry],
        stats: &mut Stats,
    ) {
        if brushes.painter().order() == PaintOrder::Last {
            tile.number();
            tile.draw(&mut Numbers, job, list, stats);
        } else {
            clear.into_iter().for_each(|color| tile.fill_colors(color));
            tile.draw(&mut Wet(brushes), job, list, stats);
        }
    }

    fn store(
        brushes: &mut Brushes<'_, P>,
        tile: &mut Tile,
        strip: &mut Strip<'_>,
        (index, left): (usize, u32),
        clear: Option<&Clear>,
        stats: &mut Stats,
    ) {
        if brushes.painter().order() == PaintOrder::Last {
            tile.store_painted(strip, left, clear, brushes, stats);
        } else {
            tile.store(strip, left);
        }
        tile.mark(&mut strip.painted[index], stats);
    }
}
