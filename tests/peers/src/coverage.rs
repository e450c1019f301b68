//! Which pixels triangles cover, in integers: it shares no arithmetic with any painter.

use std::ops::Range;

/// Units a pixel; centres are whole.
pub const PIXEL: f64 = (1_u64 << 34) as f64;

/// A triangle on the screen, y down.
#[derive(Clone, Copy, Debug)]
pub struct Facet {
    /// In units of `1 / PIXEL`.
    pub corners: [[i128; 2]; 3],
    /// So far, in units, each coordinate may be from the true one; 0: these are the true ones.
    pub slack: i128,
    /// Whether it is only seen if it turns counter-clockwise to the eye.
    pub culled: bool,
}

impl Facet {
    /// Whether it covers the centre of a pixel: it lies inside, or on a left or a horizontal top edge. `None` if
    /// that is too near to call.
    pub fn covers(&self, [x, y]: [usize; 2]) -> Option<bool> {
        let [a, b, c] = self.corners;
        let turn = self.side(a, b, c)?.signum();
        if turn == 0 || self.culled && turn > 0 {
            return Some(false);
        }
        let p = [x, y].map(|n| (2 * n as i128 + 1) * (PIXEL as i128 / 2));
        let mut inside = true;
        for [a, b] in [[a, b], [b, c], [c, a]] {
            let (dx, dy) = ((b[0] - a[0]) * turn, (b[1] - a[1]) * turn);
            let value = self.side(a, b, p)? * turn;
            inside &= value > 0 || value == 0 && (dy < 0 || dy == 0 && dx > 0);
        }
        Some(inside)
    }

    /// Twice the area of three points; `None` if its sign is not certain.
    fn side(&self, a: [i128; 2], b: [i128; 2], p: [i128; 2]) -> Option<i128> {
        let [u, v] = [b, p].map(|end| [end[0] - a[0], end[1] - a[1]]);
        let area = u[0] * v[1] - u[1] * v[0];
        // A difference is off by twice the slack, and so is the other factor of its product.
        let sizes: i128 = u.iter().chain(&v).map(|n| n.abs() + 2 * self.slack).sum();
        (self.slack == 0 || area.abs() > 2 * self.slack * sizes).then_some(area)
    }

    /// The box of pixels around it with a margin of 2, inside the image.
    pub fn around(&self, size: [usize; 2]) -> [Range<usize>; 2] {
        [0, 1].map(|axis| {
            let values = self.corners.map(|corner| corner[axis].div_euclid(PIXEL as i128));
            let [least, greatest] = [values.iter().min(), values.iter().max()].map(|at| *at.expect("three"));
            let inside = |at: i128| at.clamp(0, size[axis] as i128) as usize;
            inside(least - 2)..inside(greatest + 3)
        })
    }
}

/// Triangles in groups of which no two share a pixel nor meet each other's margins, as indices; at most so many
/// groups, so that some may be left out.
pub fn apart(facets: &[Facet], size: [usize; 2], most: usize) -> Vec<Vec<usize>> {
    let mut left: Vec<_> = (0..facets.len()).collect();
    let mut groups = Vec::new();
    while !left.is_empty() && groups.len() < most {
        let mut taken = vec![false; size[0] * size[1]];
        let (mut group, mut rest) = (Vec::new(), Vec::new());
        for index in left {
            let [columns, rows] = facets[index].around(size);
            let mut pixels = rows.flat_map(|y| columns.clone().map(move |x| y * size[0] + x));
            if pixels.clone().any(|at| taken[at]) {
                rest.push(index);
            } else {
                pixels.by_ref().for_each(|at| taken[at] = true);
                group.push(index);
            }
        }
        groups.push(group);
        left = rest;
    }
    groups
}

/// Pixels that are not the exact ones.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrong {
    /// Beside the edges of single triangles, with another neighbour to a side inside or outside.
    boundary: usize,
    wrong: usize,
    /// Pixels of a mesh that are drawn less often than by exact triangles, and more often.
    pub holes: usize,
    pub doubles: usize,
}

impl Wrong {
    /// In a million boundary pixels.
    pub fn ppm(&self) -> f64 {
        self.wrong as f64 * 1e6 / self.boundary as f64
    }

    /// Looks at one triangle that was drawn with room around it. `each` is told every pixel of its box: where, whether
    /// it is covered, and whether it was drawn; not those too near to call.
    pub fn compare(
        &mut self,
        facet: &Facet,
        size: [usize; 2],
        drawn: &[u32],
        mut each: impl FnMut(usize, bool, bool),
    ) {
        let [columns, rows] = facet.around(size);
        let width = columns.len();
        let exact: Vec<_> =
            rows.clone().flat_map(|y| columns.clone().map(move |x| facet.covers([x, y]))).collect();
        for (row, y) in rows.clone().enumerate() {
            for (column, x) in columns.clone().enumerate() {
                let at = row * width + column;
                let Some(covered) = exact[at] else { continue };
                let beside = [(column > 0, at.wrapping_sub(1)), (column + 1 < width, at + 1)];
                let above = [(row > 0, at.wrapping_sub(width)), (row + 1 < rows.len(), at + width)];
                let differs = |&(there, other): &(bool, usize)| there && exact[other] != exact[at];
                self.boundary += usize::from(beside.iter().chain(&above).any(differs));
                let is_drawn = drawn[y * size[0] + x] != 0;
                self.wrong += usize::from(is_drawn != covered);
                each(y * size[0] + x, covered, is_drawn);
            }
        }
    }
}
