//! Small triangles: the half-planes of the edges of a few at once, in binary32; then piece by piece, eight pixels of a
//! row at once.
//!
//! *Source:* Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988; Higham, Accuracy and Stability of
//! Numerical Algorithms, 2nd ed. 2002, section 3.1 (the error). Deviation: what the error leaves open is decided
//! exactly.

use super::{
    Stats,
    canvas::TILE,
    depths::{Across, Starts},
    fill::Subject,
    group::Group,
    ink::Ink,
    lanes::{LANES, Wide, larger, lesser, mask},
    pixels::{Covered, Pixels, Place},
    rows::Exact,
    setup::Setup,
    test::Test,
    tile::{BLOCK, Tile},
};

/// Most rows and columns of a small triangle.
const SIDE: usize = BLOCK;

/// Pixels of a piece of a row; a row has at most two.
const PIECE: usize = 8;
const PIECES: usize = SIDE / PIECE;

/// Of so many rows and more it is asked whether they are hidden.
const TALL: usize = 6;

/// The unit roundoff of binary32.
const U: f32 = f32::EPSILON / 2.0;

/// Half-planes whose error is at least this are not looked at in binary32.
const BLURRED: f32 = 1e20;

/// One binary32 number a lane.
pub(super) type Narrow = [f32; LANES];

/// A few triangles of which some are small.
pub(super) struct Small {
    /// Which are.
    pub(super) fits: [bool; LANES],
    /// The first of the columns that are looked at, and into how many pieces they are cut.
    first: [u32; LANES],
    pieces: [u32; LANES],
    /// The half-planes of the edges, positive inside, in square pixels: at the centre of the first pixel, and what they
    /// grow by from column to column and from row to row; how far any of them is off at most.
    at: [Narrow; 3],
    right: [Narrow; 3],
    down: [Narrow; 3],
    error: Narrow,
    /// What they are where each row of each piece begins.
    begin: [[[Narrow; 3]; SIDE]; PIECES],
    /// Whether something of the second piece may be covered: 1, else 0.
    some: [[u32; LANES]; SIDE],
    /// The depths there.
    starts: [[Starts; SIDE]; PIECES],
    /// What is to be drawn.
    todo: [Todo; LANES * PIECES * SIDE + SIDE],
    count: usize,
    pens: [Pen; LANES],
}

/// What all pieces of a triangle share.
#[derive(Clone, Copy)]
struct Pen {
    /// What each column adds to the half-planes and to the depth.
    right: [[f32; PIECE]; 3],
    across: Across<PIECE>,
    /// Whether it is only counted.
    hidden: bool,
}

/// A piece that is to be drawn, packed: its first pixel in the tile from bits 0 and 8 on, its lane from 16, row of the
/// triangle from 20 and piece of that row from 24.
#[derive(Clone, Copy)]
struct Todo(u32);

impl Todo {
    /// What the next row adds, and the next piece of a row.
    const ROW: u32 = 1 << 8 | 1 << 20;
    const NEXT: u32 = PIECE as u32 | 1 << 24;

    #[inline(always)]
    fn new([x, y]: [u32; 2], lane: usize) -> Self {
        Self(x | y << 8 | (lane as u32) << 16)
    }

    /// Column and row in the tile.
    #[inline(always)]
    fn pixel(self) -> [usize; 2] {
        [self.0 as usize % TILE, (self.0 >> 8) as usize % TILE]
    }

    /// Piece of a row, row of a triangle, lane.
    #[inline(always)]
    fn piece(self) -> [usize; 3] {
        [(self.0 >> 24) as usize % PIECES, (self.0 >> 20) as usize % SIDE, (self.0 >> 16) as usize % LANES]
    }
}

impl Small {
    /// None.
    pub(super) fn none() -> Self {
        let pen = Pen { right: [[0.0; PIECE]; 3], across: Across::NOTHING, hidden: false };
        Self {
            fits: [false; LANES],
            first: [0; LANES],
            pieces: [0; LANES],
            at: [[0.0; LANES]; 3],
            right: [[0.0; LANES]; 3],
            down: [[0.0; LANES]; 3],
            begin: [[[[0.0; LANES]; 3]; SIDE]; PIECES],
            error: [0.0; LANES],
            some: [[0; LANES]; SIDE],
            starts: [[Starts::NOTHING; SIDE]; PIECES],
            todo: [Todo(0); LANES * PIECES * SIDE + SIDE],
            count: 0,
            pens: [pen; LANES],
        }
    }

    /// Takes triangles whose planes, rows and columns are known.
    ///
    /// With d a difference of two vertices and p one of a vertex and the first centre, each rounded once, a half-plane is
    /// `dx (py + row) - dy (px + column)`. No term of it goes through more than nine roundings, so it is off by at
    /// most `9u T`, T being the sum of the terms' magnitudes at the last pixel; what is left of 10 covers the
    /// roundings of the bound itself. Products that underflow are off by less than the least normal number, too.
    #[inline(always)]
    pub(super) fn set_up(&mut self, setup: &Setup, group: &Group, origin: [u32; 2]) {
        let Setup { columns, rows, turns, .. } = setup;
        let (mut x, mut y): (Narrow, Narrow) = ([0.0; LANES], [0.0; LANES]);
        let (mut heights, mut far) = ([0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            heights[i] = rows[1][i].wrapping_sub(rows[0][i]) as i32;
            let width = columns[1][i].wrapping_sub(columns[0][i]) as i32;
            self.fits[i] = (heights[i] <= SIDE as i32) & (width <= SIDE as i32);
            far[i] = if self.fits[i] { SIDE as f32 } else { TILE as f32 };
            self.pieces[i] = if width <= PIECE as i32 { 1 } else { 2 };
            let last = TILE as u32 - self.pieces[i] * PIECE as u32;
            self.first[i] = if columns[0][i] < last { columns[0][i] } else { last };
            x[i] = (origin[0] + self.first[i]) as i32 as f32 + 0.5;
            y[i] = (origin[1] + rows[0][i]) as i32 as f32 + 0.5;
        }
        let mut terms = [0.0; LANES];
        for edge in 0..3 {
            let [p, q] = [&group.corners[edge], &group.corners[(edge + 1) % 3]];
            for i in 0..LANES {
                let (px, py) = (x[i] - p[0][i], y[i] - p[1][i]);
                let turn = turns[i] as f32;
                let (dx, dy) = ((q[0][i] - p[0][i]) * turn, (q[1][i] - p[1][i]) * turn);
                self.at[edge][i] = dx * py - dy * px;
                self.right[edge][i] = -dy;
                self.down[edge][i] = dx;
                let sum = dx.abs() * (py.abs() + far[i]) + dy.abs() * (px.abs() + far[i]);
                terms[i] = if sum > terms[i] { sum } else { terms[i] };
            }
        }
        let (mut highest, mut pieces) = (0, 1);
        for i in 0..LANES {
            self.error[i] = 10.0 * U * terms[i] + f32::MIN_POSITIVE;
            // What is not a number is less than nothing.
            self.fits[i] &= self.error[i] < BLURRED;
            highest = highest.max(if self.fits[i] { heights[i] } else { 0 });
            pieces = pieces.max(self.pieces[i]);
        }
        for piece in 0..PIECES.min(pieces as usize) {
            let (mut x, mut y): ([u32; LANES], Wide) = ([0; LANES], [0.0; LANES]);
            for i in 0..LANES {
                x[i] = self.first[i] + (piece * PIECE) as u32;
                y[i] = f64::from(rows[0][i] as i32);
            }
            let depths = &setup.at_columns(&x);
            for row in 0..SIDE.min(highest as usize) {
                for edge in 0..3 {
                    for i in 0..LANES {
                        let begin = self.at[edge][i] + self.down[edge][i] * row as f32;
                        self.begin[piece][row][edge][i] =
                            begin + self.right[edge][i] * (piece * PIECE) as f32;
                    }
                }
                if piece > 0 {
                    self.find_some(row);
                }
                self.starts[piece][row] = setup.starts_of_all(depths, &y);
                for i in 0..LANES {
                    y[i] += 1.0;
                }
            }
        }
    }

    /// Finds which triangles may cover something of the second piece of a row.
    #[inline(always)]
    fn find_some(&mut self, row: usize) {
        const LAST: f32 = (PIECE - 1) as f32;
        self.some[row] = [1; LANES];
        for edge in 0..3 {
            for i in 0..LANES {
                let nearest = self.begin[1][row][edge][i] + larger(self.right[edge][i] * LAST, 0.0);
                self.some[row][i] &= u32::from(nearest >= -self.error[i]);
            }
        }
    }

    /// Notes all pieces of a triangle.
    #[inline(always)]
    fn note(&mut self, setup: &Setup, lane: usize, hidden: bool) {
        let lane = lane % LANES;
        let pen = &mut self.pens[lane];
        for edge in 0..3 {
            for i in 0..PIECE {
                pen.right[edge][i] = self.right[edge][lane] * i as f32;
            }
        }
        pen.across = setup.across(lane);
        pen.hidden = hidden;
        let height = (setup.rows[1][lane] - setup.rows[0][lane]) as usize;
        // All that there could be, and as many counted as there are: no branch has to be guessed.
        let first = Todo::new([self.first[lane], setup.rows[0][lane]], lane);
        if let Some(todo) = self.todo[self.count..].first_chunk_mut::<SIDE>() {
            for row in 0..SIDE {
                todo[row] = Todo(first.0 + row as u32 * Todo::ROW);
            }
        }
        self.count += height;
        if self.pieces[lane] > 1 {
            for row in 0..height.min(SIDE) {
                self.todo[self.count] = Todo(first.0 + Todo::NEXT + row as u32 * Todo::ROW);
                self.count += self.some[row][lane] as usize;
            }
        }
    }

    /// What is covered of a piece.
    #[inline(always)]
    fn covered(&self, [piece, row, lane]: [usize; 3]) -> Covered<PIECE> {
        let (begin, right) = (&self.begin[piece][row], &self.pens[lane].right);
        let error = self.error[lane];
        let mut planes = [[0.0; PIECE]; 3];
        let (mut sure, mut maybe) = ([0; PIECE], [0; PIECE]);
        for i in 0..PIECE {
            let a = begin[0][lane] + right[0][i];
            let b = begin[1][lane] + right[1][i];
            let c = begin[2][lane] + right[2][i];
            (planes[0][i], planes[1][i], planes[2][i]) = (a, b, c);
            let inside = lesser(lesser(a, b), c);
            sure[i] = mask(inside > error);
            maybe[i] = mask(inside >= -error);
        }
        Covered { sure, maybe, planes }
    }

    /// The half-planes of any triangle at pixels of a row of the tile.
    #[inline(always)]
    pub(super) fn planes<const N: usize>(&self, subject: &Subject<'_>, [x, y]: [usize; 2]) -> [[f32; N]; 3] {
        let lane = subject.lane;
        let row = (y as i32 - subject.setup.rows[0][lane] as i32) as f32;
        let first = x as i32 - self.first[lane] as i32;
        let mut planes = [[0.0; N]; 3];
        for edge in 0..3 {
            let begin = self.at[edge][lane] + self.down[edge][lane] * row;
            for i in 0..N {
                planes[edge][i] = begin + self.right[edge][lane] * (first + i as i32) as f32;
            }
        }
        planes
    }

    /// How far the half-planes of a few triangles are off at most inside them, in square pixels; not finite if that is
    /// not known.
    #[inline(always)]
    pub(super) fn error(&self) -> &Narrow {
        &self.error
    }

    /// Whether the pixel before the first one of a row is covered, if that is known.
    #[inline(always)]
    fn covers_before(&self, row: usize, lane: usize) -> Option<bool> {
        let begin = &self.begin[0][row];
        let [a, b, c] = [0, 1, 2].map(|edge| begin[edge][lane] - self.right[edge][lane]);
        let inside = lesser(lesser(a, b), c);
        (inside.abs() > self.error[lane]).then_some(inside > 0.0)
    }
}

impl Tile {
    /// Notes what is to be drawn of one of the small triangles.
    #[inline(always)]
    pub(super) fn small_triangle<T: Test, I: Ink>(
        &mut self,
        small: &mut Small,
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
        small.note(setup, lane, hidden);
    }

    /// Draws what was noted. The subject is one of the triangles.
    #[inline(always)]
    pub(super) fn small_pieces<T: Test, I: Ink>(
        &mut self,
        (test, ink): (T, &mut I),
        small: &mut Small,
        mut subject: Subject<'_>,
        stats: &mut Stats,
    ) {
        let count = small.count;
        small.count = 0;
        for at in 0..count {
            let todo = small.todo[at];
            let [piece, row, lane] = todo.piece();
            let place = Place { at: todo.pixel() };
            subject.lane = lane;
            let mut covered = small.covered([piece, row, lane]);
            if I::COUNTS {
                if covered.is_open() {
                    covered = covered.decided(place, &subject, stats);
                }
                small.count_piece([piece, row, lane], &covered, &subject, stats);
                if small.pens[lane].hidden {
                    continue;
                }
            }
            let start = small.starts[piece][row].at(lane);
            let pixels = Pixels { place, start, across: &small.pens[lane].across };
            self.row_of_pixels((test, &mut *ink), (&pixels, covered), &subject, stats);
        }
    }
}

impl Small {
    /// Counts the pixels of a piece, and the span that begins there.
    #[inline(always)]
    fn count_piece(
        &self,
        [piece, row, lane]: [usize; 3],
        covered: &Covered<PIECE>,
        subject: &Subject<'_>,
        stats: &mut Stats,
    ) {
        let Subject { job, group, setup, .. } = *subject;
        let mut pixels = 0;
        for i in 0..PIECE {
            pixels += covered.sure[i] & 1;
        }
        stats.fragments += u64::from(pixels);
        let exact = || Exact::new((group, lane), &job);
        let y = setup.rows[0][lane] as usize + row;
        let mut goes_on = false;
        if covered.sure[0] != 0 {
            let x = self.first[lane] as usize + piece * PIECE;
            goes_on = match (piece, x, job.origin[0]) {
                (0, 0, 0) => false,
                (0, 0, _) => {
                    self.covers_before(row, lane).unwrap_or_else(|| exact().covers_left(y as u32, stats))
                }
                (0, ..) => false,
                _ => self.covers_last(row, lane).unwrap_or_else(|| exact().covers([x - 1, y], stats)),
            };
        }
        stats.spans += u64::from(pixels > 0 && !goes_on);
    }

    /// Whether the last pixel of the first piece of a row is covered, if that is known.
    #[inline(always)]
    fn covers_last(&self, row: usize, lane: usize) -> Option<bool> {
        let covered = self.covered([0, row, lane]);
        let last = PIECE - 1;
        (covered.sure[last] == covered.maybe[last]).then_some(covered.sure[last] != 0)
    }
}
