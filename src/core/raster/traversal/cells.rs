//! What is known of each centre of a box.

use super::{Event, Verdict};
use crate::{explain::MOST_PIXELS, raster::Span};

/// The centres of a box, a byte each: how often it was looked at, whether it is drawn.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(in crate::raster) struct Cells {
    columns: [u16; 2],
    rows: [u16; 2],
    bytes: Vec<u8>,
    /// The number of each centre's first test, from 1 on; 0 before it. Empty of a large box.
    order: Vec<u32>,
    /// Tests so far.
    tests: u32,
}

/// What is known of one centre.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::raster) struct Cell {
    byte: u8,
}

const TESTS: u8 = 0b0000_0011;
const DRAWN: u8 = 0b0000_0100;

impl Cell {
    /// How often it was tested; three stands for more.
    pub(in crate::raster) fn tests(self) -> u32 {
        u32::from(self.byte & TESTS)
    }

    /// Whether it is drawn.
    pub(in crate::raster) fn is_drawn(self) -> bool {
        self.byte & DRAWN != 0
    }
}

impl Cells {
    /// Bytes of the centres of a box that large.
    pub(in crate::raster) fn size_hint(columns: f64, rows: f64) -> usize {
        let count = (columns.max(0.0) * rows.max(0.0)) as usize;
        if count <= MOST_PIXELS { count * (1 + size_of::<u32>()) } else { count }
    }

    /// Takes in what an event says of centres.
    pub(in crate::raster) fn apply(&mut self, event: &Event) {
        match *event {
            Event::Box { columns, rows } => {
                let [width, height] = [columns, rows].map(|[begin, end]| usize::from(end - begin));
                let count = width * height;
                let order = if count <= MOST_PIXELS { vec![0; count] } else { Vec::new() };
                *self = Self { columns, rows, bytes: vec![0; count], order, tests: 0 };
            }
            Event::Test { x, y, keeps_out } => {
                let Some(index) = self.index(x, y) else { return };
                self.tests += 1;
                if let Some(first) = self.order.get_mut(index).filter(|first| **first == 0) {
                    *first = self.tests;
                }
                let tests = (self.bytes[index] & TESTS) + 1;
                let drawn = if keeps_out == 0 { DRAWN } else { self.bytes[index] & DRAWN };
                self.bytes[index] = tests.min(TESTS) | drawn;
            }
            Event::Tile { x, y, size, verdict: Verdict::Inside } => {
                for row in y..y + u16::from(size) {
                    for column in x..x + u16::from(size) {
                        if let Some(index) = self.index(column, row) {
                            self.bytes[index] |= DRAWN;
                        }
                    }
                }
            }
            _ => {}
        }
    }

    fn index(&self, x: u16, y: u16) -> Option<usize> {
        let ([left, right], [top, bottom]) = (self.columns, self.rows);
        let inside = (left..right).contains(&x) && (top..bottom).contains(&y);
        inside.then(|| usize::from(y - top) * usize::from(right - left) + usize::from(x - left))
    }

    /// A centre of the box.
    pub(in crate::raster) fn at(&self, x: u16, y: u16) -> Option<Cell> {
        self.index(x, y).and_then(|index| self.bytes.get(index)).map(|&byte| Cell { byte })
    }

    /// The number of a centre's first test, from 1 on; 0: none.
    pub(in crate::raster) fn first(&self, x: u16, y: u16) -> u32 {
        self.index(x, y).and_then(|index| self.order.get(index)).copied().unwrap_or_default()
    }

    /// When a centre was tested first, as a share of all tests so far: from more than 0 to 1. `None`: it
    /// was not, or the box is large.
    pub(in crate::raster) fn when(&self, x: u16, y: u16) -> Option<f32> {
        let first = self.first(x, y);
        (first > 0).then(|| first as f32 / self.tests as f32)
    }

    /// How many centres the box has.
    pub(in crate::raster) fn len(&self) -> usize {
        self.bytes.len()
    }

    /// The centres that are drawn, as spans sorted by row.
    pub(in crate::raster) fn spans(&self) -> Vec<Span> {
        let mut spans: Vec<Span> = Vec::new();
        for ([x, y], _) in self.all().filter(|(_, cell)| cell.is_drawn()) {
            let [x, y] = [x, y].map(u32::from);
            match spans.last_mut() {
                Some(span) if span.y == y => span.end = x + 1,
                _ => spans.push(Span { y, begin: x, end: x + 1 }),
            }
        }
        spans
    }

    /// Every centre of the box, row by row.
    pub(in crate::raster) fn all(&self) -> impl Iterator<Item = ([u16; 2], Cell)> + '_ {
        let [left, right] = self.columns;
        let width = usize::from(right - left).max(1);
        let place = move |i: usize| [left + (i % width) as u16, self.rows[0] + (i / width) as u16];
        self.bytes.iter().enumerate().map(move |(i, &byte)| (place(i), Cell { byte }))
    }
}
