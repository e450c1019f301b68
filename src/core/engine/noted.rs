//! The stamps of small triangles: noted for a few triangles, then drawn one after another.
//!
//! *Source:* as of [`small`](super::small).

use super::{
    Stats,
    depths::Across,
    fill::Subject,
    ink::Ink,
    lanes::{LANES, lesser, mask},
    pixels::{Covered, Pixels},
    rows::Exact,
    setup::Setup,
    small::{GRID, PIECES, Small, TINY},
    stamp::{ACROSS, Each, Place, SIDE, STAMP},
    test::Test,
    tile::Tile,
};

/// Of so many rows and more it is asked whether they are hidden.
const TALL: usize = 6;

/// What is to be drawn of a few triangles.
pub(super) struct Noted {
    todo: [Todo; LANES * PIECES + TINY * TINY],
    count: usize,
    pens: [Pen; LANES],
}

/// What all stamps of a triangle share. No array of it lies in two cache lines more than it must.
#[derive(Clone, Copy)]
#[repr(align(64))]
struct Pen {
    /// What the pixels add to the half-planes and to the depth.
    offsets: [Each<f32>; 3],
    across: Across,
    /// Whether it is only counted.
    hidden: bool,
}

/// A stamp that is to be drawn, packed: its number in the tile from bit 0 on, that in its triangle from 16, its lane
/// from 24.
#[derive(Clone, Copy)]
struct Todo(u32);

impl Todo {
    /// What the next stamp beside and below adds.
    const BESIDE: u32 = 1 | 1 << 16;
    const BELOW: u32 = ACROSS as u32 | (GRID as u32) << 16;

    #[inline(always)]
    fn new(first: Place, lane: usize) -> Self {
        Self(first.0 | (lane as u32) << 24)
    }

    #[inline(always)]
    fn then(self, [column, row]: [usize; 2]) -> Self {
        Self(self.0 + column as u32 * Self::BESIDE + row as u32 * Self::BELOW)
    }

    #[inline(always)]
    fn place(self) -> Place {
        Place(self.0 & 0xffff)
    }

    /// Number in the triangle, lane.
    #[inline(always)]
    fn piece(self) -> [usize; 2] {
        [(self.0 >> 16) as usize % PIECES, (self.0 >> 24) as usize % LANES]
    }
}

impl Noted {
    /// Nothing.
    pub(super) fn nothing() -> Self {
        let pen = Pen { offsets: [[0.0; STAMP]; 3], across: Across::NOTHING, hidden: false };
        Self { todo: [Todo(0); LANES * PIECES + TINY * TINY], count: 0, pens: [pen; LANES] }
    }

    /// Notes all stamps of a triangle.
    #[inline(always)]
    fn note(&mut self, small: &Small, setup: &Setup, lane: usize, hidden: bool) {
        let lane = lane % LANES;
        let (offsets, across) = (small.offsets(lane), setup.across(lane, &small.steps));
        self.pens[lane] = Pen { offsets, across, hidden };
        let first = Place::of([small.first[0][lane] as usize, small.first[1][lane] as usize]);
        let first = Todo::new(first, lane);
        // All that there could be, and as many counted as there are: no branch has to be guessed.
        if small.tiny {
            if let Some(todo) = self.todo[self.count..].first_chunk_mut::<{ TINY * TINY }>() {
                let mut count = 0;
                for [row, column] in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                    todo[count % (TINY * TINY)] = first.then([column, row]);
                    count += small.some[row * GRID + column][lane] as usize;
                }
                self.count += count;
            }
            return;
        }
        for row in 0..GRID.min(small.stamps[1][lane] as usize) {
            for column in 0..GRID.min(small.stamps[0][lane] as usize) {
                self.todo[self.count] = first.then([column, row]);
                self.count += small.some[row * GRID + column][lane] as usize;
            }
        }
    }

    /// What is covered of a stamp, as far as the error leaves one answer; the other pixels, which are open, are not.
    #[inline(always)]
    fn covered(&self, small: &Small, [piece, lane]: [usize; 2]) -> (Covered, Each<u32>) {
        let (begin, offsets) = (&small.begin[piece], &self.pens[lane].offsets);
        let error = small.error[lane];
        let mut planes = [[0.0; STAMP]; 3];
        let (mut pixels, mut open) = ([0; STAMP], [0; STAMP]);
        for i in 0..STAMP {
            let a = begin[0][lane] + offsets[0][i];
            let b = begin[1][lane] + offsets[1][i];
            let c = begin[2][lane] + offsets[2][i];
            (planes[0][i], planes[1][i], planes[2][i]) = (a, b, c);
            let inside = lesser(lesser(a, b), c);
            pixels[i] = mask(inside > error);
            open[i] = mask(inside >= -error) & !pixels[i];
        }
        (Covered { pixels, planes }, open)
    }
}

impl Small {
    /// Counts the pixels of a stamp that is decided, and the spans that begin there.
    #[inline(always)]
    fn count_covered(&self, place: Place, covered: &Covered, subject: &Subject<'_>, stats: &mut Stats) {
        let Subject { job, group, lane, .. } = *subject;
        let error = self.error[lane];
        let Covered { pixels: covered, planes: [a, b, c] } = covered;
        let right = [self.right[0][lane], self.right[1][lane], self.right[2][lane]];
        let (mut pixels, mut spans) = (0, 0);
        let mut open = [0; STAMP];
        let begins_image = job.origin[0] as usize + place.first()[0] == 0;
        for i in 0..STAMP {
            // Whether the pixel to the left is covered.
            let left = lesser(lesser(a[i] - right[0], b[i] - right[1]), c[i] - right[2]);
            let is_first = mask(begins_image & (i % SIDE == 0));
            let out = mask(left < -error) | is_first;
            open[i] = covered[i] & !out & !mask(left > error);
            pixels += covered[i] & 1;
            spans += covered[i] & out & 1;
        }
        stats.fragments += u64::from(pixels);
        stats.spans += u64::from(spans);
        if open.iter().fold(0, |any, open| any | open) != 0 {
            let exact = Exact::new((group, lane), &job);
            for i in (0..STAMP).filter(|&i| open[i] != 0) {
                stats.spans += u64::from(!exact.covers_before(place.pixel(i), stats));
            }
        }
    }
}

impl Subject<'_> {
    /// Of a stamp what is covered, given what surely is; what is open is decided exactly.
    #[cold]
    #[inline(never)]
    fn decide(
        &self,
        place: Place,
        (mut covered, open): (Each<u32>, Each<u32>),
        stats: &mut Stats,
    ) -> Each<u32> {
        let exact = Exact::new((self.group, self.lane), &self.job);
        for i in (0..STAMP).filter(|&i| open[i] != 0) {
            covered[i] = mask(exact.covers(place.pixel(i), stats));
        }
        covered
    }
}

impl Tile {
    /// Notes what is to be drawn of one of the small triangles.
    #[inline(always)]
    pub(super) fn small_triangle<T: Test, I: Ink>(
        &mut self,
        (noted, small): (&mut Noted, &Small),
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let Subject { job, setup, lane, .. } = *subject;
        let [left, right] = [0, 1].map(|end| setup.columns[end][lane] as usize);
        let [first, last] = [0, 1].map(|end| setup.rows[end][lane] as usize);
        let mut hidden = I::COUNTS && setup.behind[lane];
        if job.rules.hierarchical_z && last - first >= TALL && !hidden {
            let mut tops = (first & !(LANES - 1)..last).step_by(LANES);
            let near = setup.nearest(lane);
            if tops.all(|y| self.hides::<T>(left, y, near) && self.hides::<T>(right - 1, y, near)) {
                stats.hidden += 1;
                hidden = true;
            }
        }
        if hidden && !I::COUNTS {
            return;
        }
        if !hidden {
            stats.blocks += 1;
            self.age(left, first, right - left);
        }
        noted.note(small, setup, lane, hidden);
    }

    /// Draws what was noted. The subject is one of the triangles.
    #[inline(always)]
    pub(super) fn small_stamps<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        (noted, small): (&mut Noted, &Small),
        mut subject: Subject<'_>,
        stats: &mut Stats,
    ) {
        let count = noted.count;
        noted.count = 0;
        for at in 0..count {
            let todo = noted.todo[at];
            let [piece, lane] = todo.piece();
            let place = todo.place();
            subject.lane = lane;
            let (mut covered, open) = noted.covered(small, [piece, lane]);
            if open.iter().fold(0, |any, open| any | open) != 0 {
                covered.pixels = subject.decide(place, (covered.pixels, open), stats);
            }
            if I::COUNTS {
                small.count_covered(place, &covered, &subject, stats);
                if noted.pens[lane].hidden {
                    continue;
                }
            }
            let start = small.starts[piece].at(lane);
            let pixels = Pixels { place, start, across: &noted.pens[lane].across };
            self.stamped((test, &mut *ink), (&pixels, covered), &subject, stats);
        }
    }
}
