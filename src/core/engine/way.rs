//! The two ways in which the triangles of a tile become colours.

use super::{
    Canvas, Clear, PaintOrder, Painter, Stats,
    bins::Entry,
    fill::Job,
    ink::{Flat, Ink, Numbers, Wet},
    paint::Brushes,
    tile::Tile,
};

/// How the triangles of a tile become colours: first they are drawn, then the tile is given back.
pub(super) trait Way {
    fn counts(&self) -> bool;
    fn draw(&mut self, tile: &mut Tile, job: Job<'_>, list: &[Entry], stats: &mut Stats);
    fn store(
        &mut self,
        tile: &mut Tile,
        canvas: (&mut Canvas, usize),
        origin: [u32; 2],
        clear: Option<&Clear>,
        stats: &mut Stats,
    );
}

/// One colour a triangle.
pub(super) struct Plain;

/// By a painter.
pub(super) struct Painted<'p, P: Painter>(pub(super) Brushes<'p, P>);

impl Way for Plain {
    fn counts(&self) -> bool {
        Flat::COUNTS
    }

    fn draw(&mut self, tile: &mut Tile, job: Job<'_>, list: &[Entry], stats: &mut Stats) {
        tile.draw(&mut Flat, job, list, stats);
    }

    fn store(
        &mut self,
        tile: &mut Tile,
        (canvas, _): (&mut Canvas, usize),
        origin: [u32; 2],
        _: Option<&Clear>,
        _: &mut Stats,
    ) {
        tile.store(canvas, origin);
    }
}

impl<P: Painter> Way for Painted<'_, P> {
    fn counts(&self) -> bool {
        Numbers::COUNTS
    }

    fn draw(&mut self, tile: &mut Tile, job: Job<'_>, list: &[Entry], stats: &mut Stats) {
        if self.0.painter().order() == PaintOrder::Last {
            tile.number();
            tile.draw(&mut Numbers, job, list, stats);
        } else {
            tile.draw(&mut Wet(&mut self.0), job, list, stats);
        }
    }

    fn store(
        &mut self,
        tile: &mut Tile,
        (canvas, index): (&mut Canvas, usize),
        origin: [u32; 2],
        clear: Option<&Clear>,
        stats: &mut Stats,
    ) {
        if self.0.painter().order() == PaintOrder::Last {
            tile.store_painted(canvas, origin, clear, &mut self.0, stats);
        } else {
            tile.store(canvas, origin);
        }
        tile.mark(&mut canvas.painted[index], stats);
    }
}
