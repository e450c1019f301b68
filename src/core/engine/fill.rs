//! Triangles into a tile: band by band of rows, block by block of columns, and the pixels of a stamp at once.
//!
//! *Source:* Greene, Kass, Miller, Hierarchical Z-Buffer Visibility, SIGGRAPH 1993; Giesen, Optimizing Software
//! Occlusion Culling, 2013. Deviation: a depth is tested as an interval around the exact one.

use super::{
    State, Stats,
    canvas::TILE,
    depths::Across,
    foremost::Foremost,
    group::{Entry, Group},
    ink::{Flat, Ink},
    lanes::{LANES, Wide, greatest, least},
    noted::Noted,
    pixels::{Covered, Pixels},
    rows::{Band, Exact, Left, Rows},
    setup::Setup,
    sides::Sides,
    small::Small,
    stamp::{Each, Place, SIDE, STAMP},
    state::Rules,
    test::{Any, Codes, First, Masked, Nearer, Test},
    tile::{BLOCK, Tile},
};

/// Triangles of fewer rows than this are drawn without asking what is known of the blocks they lie in.
const SMALL: u32 = 6;

/// The bits of a block.
const FULL: u64 = (1 << BLOCK) - 1;

/// What all triangles of a tile share.
#[derive(Clone, Copy)]
pub(super) struct Job<'a> {
    /// The first pixel of the tile.
    pub(super) origin: [u32; 2],
    pub(super) state: &'a State,
    pub(super) rules: &'a Rules,
}

/// A triangle in a tile.
#[derive(Clone, Copy)]
pub(super) struct Subject<'a> {
    pub(super) job: Job<'a>,
    pub(super) group: &'a Group,
    pub(super) setup: &'a Setup,
    /// Of triangles that are not small.
    pub(super) sides: &'a Sides,
    /// Its lane in all of them.
    pub(super) lane: usize,
}

/// The same, as its pixels need it.
struct Pen<'a> {
    subject: &'a Subject<'a>,
    small: &'a Small,
    /// What the pixels of a stamp add to the depth, and to the half-planes if they are asked for.
    across: Across,
    offsets: [Each<f32>; 3],
}

impl Tile {
    /// Draws triangles in order.
    pub(super) fn draw(&mut self, ink: &mut impl Ink, job: Job<'_>, list: &[Entry], stats: &mut Stats) {
        let state = job.state;
        let any = Any::new(state.depth);
        match (Codes::new(state.depth, state.store), state.stencil) {
            _ if state.lowers_depths() => self.draw_in_lanes(Nearer, ink, job, (list, None), stats),
            (None, None) => self.draw_in_lanes(any, ink, job, (list, None), stats),
            (None, Some(_)) => self.draw_in_lanes(Masked(any), ink, job, (list, None), stats),
            (Some(codes), None) => self.draw_in_lanes(codes, ink, job, (list, None), stats),
            (Some(codes), Some(_)) => self.draw_in_lanes(Masked(codes), ink, job, (list, None), stats),
        }
    }

    /// Draws triangles of a mesh in order.
    pub(super) fn draw_mesh(&mut self, ink: &mut impl Ink, job: Job<'_>, list: &[Entry], stats: &mut Stats) {
        if job.state.lowers_depths() {
            self.draw_in_lanes(Nearer, ink, job, (list, None), stats);
        }
    }

    /// Draws the triangles of a list in a given order, but so that of equal depths the first in the list wins. Colours
    /// are their places in the list, from 1.
    pub(super) fn draw_foremost(
        &mut self,
        job: Job<'_>,
        (list, order): (&[Entry], &Foremost),
        stats: &mut Stats,
    ) {
        self.draw_in_lanes(First, &mut Flat, job, (list, Some(order)), stats);
    }

    fn draw_in_lanes<T: Test, I: Ink>(
        &mut self,
        test: T,
        ink: &mut I,
        job: Job<'_>,
        (list, order): (&[Entry], Option<&Foremost>),
        stats: &mut Stats,
    ) {
        let (small, sides, noted) = (&mut Small::none(), &mut Sides::none(), &mut Noted::nothing());
        job.state.lanes.run(
            #[inline(always)]
            || {
                for start in (0..list.len()).step_by(LANES) {
                    let farthest = self.farthest_of_all();
                    if order.is_some_and(|order| order.nearest_from(start) > farthest) {
                        stats.behind += (list.len() - start) as u64;
                        break;
                    }
                    let group = &match order {
                        None => Group::new(&list[start..]),
                        Some(order) => Group::at(&order.order[start..], list),
                    };
                    let farthest = if T::TIES { farthest.next_up() } else { farthest };
                    let setup = &Setup::new(group, (small, sides), (job.origin, farthest), job.rules, stats);
                    ink.fetch(list.get(start + LANES..).unwrap_or_default());
                    ink.set_up(group, setup, small);
                    let (small, sides) = (&*small, &*sides);
                    let mut lane = 0;
                    while lane < LANES {
                        let subject = |lane| Subject { job, group, setup, sides, lane };
                        while lane < LANES && (small.fits[lane] || setup.is_empty(lane)) {
                            if !setup.is_empty(lane) {
                                self.small_triangle::<T, I>((noted, small), &subject(lane), stats);
                            }
                            lane += 1;
                        }
                        self.small_stamps((test, &mut *ink), (noted, small), subject(0), stats);
                        if lane < LANES {
                            self.triangle((test, &mut *ink), (&subject(lane), small), stats);
                            lane += 1;
                        }
                    }
                }
            },
        );
    }

    #[inline(always)]
    fn triangle<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        (subject, small): (&Subject<'_>, &Small),
        stats: &mut Stats,
    ) {
        let Subject { job, setup, lane, .. } = *subject;
        let offsets = if I::SHADES { small.offsets(lane) } else { [[0.0; STAMP]; 3] };
        let pen = Pen { subject, small, across: setup.across(lane, &small.steps), offsets };
        let [left, right] = [0, 1].map(|end| setup.columns[end][lane] as usize);
        let start = (left & !(SIDE - 1)).min(TILE - BLOCK);
        let narrow = right - start <= BLOCK;
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane]);
        // Of very small triangles nothing is worth asking.
        let hides = job.rules.hierarchical_z && last - first >= SMALL;
        let behind = I::COUNTS && setup.behind[lane];
        let left_tile = if I::COUNTS && job.origin[0] > 0 { Left::Asked } else { Left::Unasked };
        for top in (first & !(LANES as u32 - 1)..last).step_by(LANES) {
            let mut hidden = behind;
            if hides && !behind {
                let [near, _] = pen.extent([left, right], top as usize);
                let (mut x, mut blocks) = (left & !(BLOCK - 1), 0);
                while x < right && self.hides::<T>(x, top as usize, near) {
                    (x, blocks) = (x + BLOCK, blocks + 1);
                }
                hidden = x >= right;
                stats.hidden += if hidden { blocks } else { 0 };
            }
            if hidden && !I::COUNTS {
                continue;
            }
            let band = Band { top, first, last };
            let rows = Rows::new(subject.sides, lane, (band, left_tile), || pen.edges(), stats);
            if rows.any == 0 {
                continue;
            }
            if I::COUNTS {
                rows.count(stats);
            }
            if hidden {
                continue;
            }
            let top = top as usize;
            if narrow {
                stats.blocks += 1;
                self.age(start, top, BLOCK);
                self.fill((test, &mut *ink), [start, top], &rows, &pen, stats);
                continue;
            }
            let [begin, end] =
                [rows.any.trailing_zeros(), u64::BITS - rows.any.leading_zeros()].map(|x| x as usize);
            for x in (begin & !(BLOCK - 1)..end).step_by(BLOCK) {
                if hides {
                    let [near, far] = pen.extent([x, x + BLOCK], top);
                    if self.hides::<T>(x, top, near) {
                        stats.hidden += 1;
                        continue;
                    }
                    if !rows.all >> x & FULL == 0 {
                        self.bring(x, top, far as f32);
                    }
                }
                stats.blocks += 1;
                self.age(x, top, BLOCK);
                self.fill((test, &mut *ink), [x, top], &rows, &pen, stats);
            }
        }
    }

    /// The pixels of a block, given its first column and row.
    #[inline(always)]
    fn fill<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        [left, top]: [usize; 2],
        rows: &Rows,
        pen: &Pen<'_>,
        stats: &mut Stats,
    ) {
        let Pen { subject, small, across, offsets } = pen;
        let (mut x, mut y): (Wide, Wide) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            x[i] = (left + i % (BLOCK / SIDE) * SIDE) as f64;
            y[i] = (top + i / (BLOCK / SIDE) * SIDE) as f64;
        }
        let starts = subject.setup.starts(subject.lane, [&x, &y]);
        let begins = if I::SHADES { small.begins(subject.lane, [&x, &y]) } else { [[0.0; LANES]; 3] };
        let mut some = rows.stamps(left);
        while some != 0 {
            let i = some.trailing_zeros() as usize / SIDE % LANES;
            some &= some - 1;
            let [column, row] = [left + i % (BLOCK / SIDE) * SIDE, i / (BLOCK / SIDE) * SIDE];
            let pixels = Pixels { place: Place::of([column, top + row]), start: starts.at(i), across };
            let mut planes = [[0.0; STAMP]; 3];
            if I::SHADES {
                for edge in 0..3 {
                    for pixel in 0..STAMP {
                        planes[edge][pixel] = begins[edge][i] + offsets[edge][pixel];
                    }
                }
            }
            let covered = Covered { pixels: rows.covered([column, row]), planes };
            self.stamped((test, &mut *ink), (&pixels, covered), subject, stats);
        }
    }
}

impl Pen<'_> {
    /// Bounds of the depths in the columns from `left` to before `right` of the band at `top`, within those of the
    /// vertices.
    #[inline(always)]
    fn extent(&self, [left, right]: [usize; 2], top: usize) -> [f64; 2] {
        let Subject { setup, lane, .. } = *self.subject;
        let across = [left, right - 1].map(|x| setup.dz_dx[lane] * x as f64);
        let down = [top, top + LANES - 1].map(|y| setup.dz_dy[lane] * y as f64);
        let near = setup.depth[lane] + least(down[0], down[1]) + least(across[0], across[1]);
        let far = setup.depth[lane] + greatest(down[0], down[1]) + greatest(across[0], across[1]);
        let error = setup.error[lane];
        [greatest(near - error, setup.range[0][lane]), least(far + error, setup.range[1][lane])]
    }

    #[cold]
    #[inline(never)]
    fn edges(&self) -> Exact {
        Exact::new((self.subject.group, self.subject.lane), &self.subject.job)
    }
}
