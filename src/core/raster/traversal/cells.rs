//! What is known of each centre of a box.

use super::{Event, Verdict};

/// The centres of a box, a byte each: which edges keep it out, how often it was looked at, whether
/// a tile has settled it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Cells {
    columns: [u16; 2],
    rows: [u16; 2],
    bytes: Vec<u8>,
}

/// What is known of one centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Cell {
    byte: u8,
}

const EDGES: u8 = 0b0000_1111;
const TESTS: u8 = 0b0011_0000;
const ONE_TEST: u8 = 0b0001_0000;
const DRAWN: u8 = 0b0100_0000;

impl Cell {
    /// One bit for each edge that keeps it out.
    pub(super) fn keeps_out(self) -> u8 {
        self.byte & EDGES
    }

    /// How often it was tested; three stands for more.
    pub(super) fn tests(self) -> u32 {
        u32::from((self.byte & TESTS) / ONE_TEST)
    }

    /// Whether it is drawn.
    pub(super) fn is_drawn(self) -> bool {
        self.byte & DRAWN != 0
    }
}

impl Cells {
    /// Bytes of the centres of a box that large.
    pub(super) fn size_hint(columns: f64, rows: f64) -> usize {
        (columns.max(0.0) * rows.max(0.0)) as usize
    }

    /// Takes in what an event says of centres.
    pub(super) fn apply(&mut self, event: &Event) {
        match *event {
            Event::Box { columns, rows } => {
                let [width, height] = [columns, rows].map(|[begin, end]| usize::from(end - begin));
                *self = Self { columns, rows, bytes: vec![0; width * height] };
            }
            Event::Test { x, y, keeps_out } => {
                if let Some(byte) = self.byte_mut(x, y) {
                    let tests = (*byte & TESTS).saturating_add(ONE_TEST).min(TESTS);
                    *byte = *byte & DRAWN | tests | keeps_out | if keeps_out == 0 { DRAWN } else { 0 };
                }
            }
            Event::Tile { x, y, size, verdict: Verdict::Inside } => {
                for row in y..y + u16::from(size) {
                    for column in x..x + u16::from(size) {
                        if let Some(byte) = self.byte_mut(column, row) {
                            *byte |= DRAWN;
                        }
                    }
                }
            }
            _ => {}
        }
    }

    fn byte_mut(&mut self, x: u16, y: u16) -> Option<&mut u8> {
        let index = self.index(x, y)?;
        self.bytes.get_mut(index)
    }

    fn index(&self, x: u16, y: u16) -> Option<usize> {
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        let inside = (left..right).contains(&x) && (top..bottom).contains(&y);
        inside.then(|| usize::from(y - top) * usize::from(right - left) + usize::from(x - left))
    }

    /// A centre of the box.
    pub(super) fn at(&self, x: u16, y: u16) -> Option<Cell> {
        self.index(x, y).and_then(|index| self.bytes.get(index)).map(|&byte| Cell { byte })
    }

    /// How many centres the box has.
    pub(super) fn len(&self) -> usize {
        self.bytes.len()
    }

    /// Every centre of the box, row by row.
    pub(super) fn all(&self) -> impl Iterator<Item = ([u16; 2], Cell)> + '_ {
        let [left, right] = self.columns;
        let width = usize::from(right - left).max(1);
        let place = move |i: usize| [left + (i % width) as u16, self.rows[0] + (i / width) as u16];
        self.bytes.iter().enumerate().map(move |(i, &byte)| (place(i), Cell { byte }))
    }
}
