//! Which pixels a triangle covers, in integers: it shares no arithmetic with any painter.

use super::{
    Painter, SIZE, Soup,
    workload::{self, CELLS},
};

/// Pixels that are not the exact ones.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wrong {
    /// Beside the edges of single triangles, with another neighbour to a side inside or outside.
    boundary: usize,
    wrong: usize,
    /// Pixels of a mesh that no triangle draws, and that two draw.
    pub holes: usize,
    pub doubles: usize,
}

impl Wrong {
    /// In a million boundary pixels.
    pub fn ppm(&self) -> f64 {
        self.wrong as f64 * 1e6 / self.boundary as f64
    }
}

/// Twice 2^20 units a pixel, so that centres are whole.
fn units(coordinate: f32) -> i128 {
    (f64::from(coordinate) * f64::from(1 << 21)) as i128
}

/// Whether the centre of a pixel lies inside, or on a left or a horizontal top edge; y points down.
fn covers(triangle: &[[f32; 3]; 3], x: usize, y: usize) -> bool {
    let [a, b, c] = triangle.map(|[x, y, _]| [units(x), units(y)]);
    let p = [x, y].map(|n| (2 * n as i128 + 1) << 20);
    let side = |a: [i128; 2], b: [i128; 2], p: [i128; 2]| {
        (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    };
    let turn = side(a, b, c).signum();
    turn != 0
        && [[a, b], [b, c], [c, a]].into_iter().all(|[a, b]| {
            let (dx, dy) = ((b[0] - a[0]) * turn, (b[1] - a[1]) * turn);
            let value = side(a, b, p) * turn;
            value > 0 || value == 0 && (dy < 0 || dy == 0 && dx > 0)
        })
}

/// The box of pixels around a triangle with a margin of 2, inside the image.
fn around(triangle: &[[f32; 3]; 3]) -> [std::ops::Range<usize>; 2] {
    [0, 1].map(|axis| {
        let values = triangle.map(|vertex| vertex[axis]);
        let least = values.into_iter().fold(f32::INFINITY, f32::min) as usize;
        let greatest = values.into_iter().fold(0.0, f32::max) as usize;
        least.saturating_sub(2)..(greatest + 3).min(SIZE)
    })
}

/// Lets a painter draw many triangles that do not touch, then a mesh in parts that do not.
pub fn examine(painter: &mut dyn Painter) -> Wrong {
    let mut wrong = Wrong::default();
    for workload in workload::ALL {
        let soup = workload.soup();
        let mut triangles: Vec<_> = soup.triangles().map(|(triangle, _)| triangle).take(60_000).collect();
        // Frames of triangles with room of their own; what found none goes to the next.
        for _ in 0..4 {
            let mut taken = vec![false; SIZE * SIZE];
            let (mut frame, mut rest) = (Vec::new(), Vec::new());
            for triangle in triangles {
                let [columns, rows] = around(&triangle);
                let mut pixels = rows.flat_map(|y| columns.clone().map(move |x| y * SIZE + x));
                if pixels.clone().any(|at| taken[at]) {
                    rest.push(triangle);
                } else {
                    pixels.by_ref().for_each(|at| taken[at] = true);
                    frame.push(triangle);
                }
            }
            let drawn = draw(painter, &frame);
            frame.iter().for_each(|triangle| compare(triangle, &drawn, &mut wrong));
            triangles = rest;
        }
    }
    let mesh = workload::mesh(8.0, 1);
    let mut hits = vec![0_u8; SIZE * SIZE];
    for part in 0..8 {
        let of_part = |index: usize| {
            let (cell, half) = (index / 2, index % 2);
            half + 2 * (cell % CELLS % 2) + 4 * (cell / CELLS % 2) == part
        };
        let frame: Vec<_> = (0..mesh.len()).filter(|&i| of_part(i)).map(|i| mesh[i]).collect();
        let drawn = draw(painter, &frame);
        hits.iter_mut().zip(drawn).for_each(|(hits, color)| *hits += u8::from(color != 0));
    }
    // The border of the sheet runs through centres: its first row and column are drawn, its last not.
    let inside = 10..10 + CELLS * 8;
    for (at, hits) in hits.into_iter().enumerate() {
        let inside = inside.contains(&(at % SIZE)) && inside.contains(&(at / SIZE));
        wrong.holes += usize::from(inside && hits == 0);
        wrong.doubles += usize::from(hits > u8::from(inside));
    }
    wrong
}

fn draw(painter: &mut dyn Painter, triangles: &[[[f32; 3]; 3]]) -> Vec<u32> {
    let mut soup = Soup::default();
    triangles.iter().for_each(|&triangle| soup.push(triangle));
    painter.take(&soup);
    painter.draw();
    painter.colors()
}

fn compare(triangle: &[[f32; 3]; 3], drawn: &[u32], wrong: &mut Wrong) {
    let [columns, rows] = around(triangle);
    let width = columns.len();
    let exact: Vec<_> =
        rows.clone().flat_map(|y| columns.clone().map(move |x| covers(triangle, x, y))).collect();
    for (row, y) in rows.clone().enumerate() {
        for (column, x) in columns.clone().enumerate() {
            let at = row * width + column;
            let beside = [(column > 0, at.wrapping_sub(1)), (column + 1 < width, at + 1)];
            let above = [(row > 0, at.wrapping_sub(width)), (row + 1 < rows.len(), at + width)];
            let differs = |&(there, other): &(bool, usize)| there && exact[other] != exact[at];
            wrong.boundary += usize::from(beside.iter().chain(&above).any(differs));
            wrong.wrong += usize::from((drawn[y * SIZE + x] != 0) != exact[at]);
        }
    }
}
