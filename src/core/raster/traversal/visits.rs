//! What each way over the centres of one triangle looks at.

use super::{Event, Traversal, cells::Cells, fill_traced};
use crate::{
    explain::MOST_PIXELS,
    math::Tally,
    raster::{Algorithm, Settings, aabb::Aabb, backtracking::Backtracking, tiled::Tiled, zigzag::Zigzag},
    trace::Tracer,
};

/// Counts of a whole run, in centres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Visits {
    /// Looked at, each counted once.
    pub visited: u32,
    /// Compared with the edges, each as often as it was.
    pub tested: u32,
    /// Drawn, with those that a tile settled.
    pub drawn: u32,
    /// Tests that drew nothing new.
    pub wasted: u32,
    /// Tiles compared with the edges.
    pub tiles: u32,
}

/// Every way over one triangle; none if it is large, since all of them are run for it.
pub fn of_each_way(vertices: [[f32; 2]; 3], settings: &Settings) -> Vec<(Algorithm, Visits)> {
    let ways = [
        (Algorithm::Aabb, visits::<Aabb> as fn(_, &_) -> _),
        (Algorithm::Backtracking, visits::<Backtracking>),
        (Algorithm::Zigzag, visits::<Zigzag>),
        (Algorithm::Tiled, visits::<Tiled>),
    ];
    let count =
        |(way, visits): (Algorithm, fn(_, &_) -> Option<Visits>)| Some((way, visits(vertices, settings)?));
    ways.into_iter().map_while(count).collect()
}

/// One way over one triangle; `None` if its box has more than [`MOST_PIXELS`] centres.
pub fn visits<A: Traversal>(vertices: [[f32; 2]; 3], settings: &Settings) -> Option<Visits> {
    let area = super::Area::new(settings.vertices(vertices), settings);
    if area.columns.len().saturating_mul(area.rows.len()) > MOST_PIXELS {
        return None;
    }
    let mut count = Count::default();
    let counts = fill_traced::<A, _>(vertices, settings, &mut Tally::default(), &mut count, &mut |_| {});
    let tested = || count.cells.all().filter(|(_, cell)| cell.tests() > 0);
    let drawing = tested().filter(|(_, cell)| cell.is_drawn()).count();
    Some(Visits {
        visited: tested().count() as u32,
        tested: counts.tested as u32,
        drawn: counts.covered as u32,
        wasted: counts.tested as u32 - drawing as u32,
        tiles: count.tiles,
    })
}

/// Counts instead of keeping events.
#[derive(Debug, Default)]
struct Count {
    cells: Cells,
    tiles: u32,
}

impl Tracer<Event> for Count {
    fn emit(&mut self, make: impl FnOnce() -> Event) {
        let event = make();
        self.tiles += u32::from(matches!(event, Event::Tile { .. }));
        self.cells.apply(&event);
    }
}
