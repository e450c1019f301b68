//! The arithmetics in which the text of the algorithm runs.

use super::super::{Border, End, Mistake, Mistakes, Outcode, Point, Segment, Window, crossings::Crossings};
use crate::math::{Real, Tally};

/// The two ends while they are being cut.
pub(super) trait Form {
    /// Whether rounding can bring back the bit of a border that was cut before.
    const ROUNDS: bool;
    /// The code of an end that has not moved yet.
    fn code(&self, end: End) -> Outcode;
    /// Prepares to cut.
    fn begin(&mut self) {}
    /// Moves the ends that lie beyond `border` to the border; returns the codes, new where an end moved.
    fn cut(&mut self, border: Border, codes: [Outcode; 2]) -> [Outcode; 2];
    /// The ends as they stand.
    fn segment(&self) -> Segment;
}

/// Decisions and coordinates of the exact line through the original ends.
pub(super) struct Exact<'a> {
    original: &'a Segment,
    /// Both coordinates of an end in one word, so that moving it is one conditional move.
    ends: [u64; 2],
    window: &'a Window,
    crossings: Option<Crossings<'a>>,
    tally: &'a mut Tally,
}

impl<'a> Exact<'a> {
    #[inline(always)]
    pub(super) fn new(original: &'a Segment, window: &'a Window, tally: &'a mut Tally) -> Self {
        Self { original, ends: original.map(to_word), window, crossings: None, tally }
    }
}

#[inline(always)]
fn to_word([x, y]: Point) -> u64 {
    u64::from(x.to_bits()) | u64::from(y.to_bits()) << 32
}

impl Form for Exact<'_> {
    const ROUNDS: bool = false;

    #[inline(always)]
    fn code(&self, end: End) -> Outcode {
        let Window { xmin, ymin, xmax, ymax } = *self.window;
        Outcode::of(self.original[end as usize], [xmin, ymin, xmax, ymax])
    }

    #[inline(always)]
    fn begin(&mut self) {
        self.crossings = Some(Crossings::new(self.original, self.window, self.tally));
    }

    #[inline(always)]
    fn cut(&mut self, border: Border, codes: [Outcode; 2]) -> [Outcode; 2] {
        let Some(crossings) = &self.crossings else { return codes };
        let (place, code) = (to_word(crossings.place(border)), crossings.code(border));
        let [p1, p2] = self.ends;
        let [c1, c2] = codes;
        let [beyond1, beyond2] = codes.map(|code| code.has(border));
        self.ends = [if beyond1 { place } else { p1 }, if beyond2 { place } else { p2 }];
        [if beyond1 { code } else { c1 }, if beyond2 { code } else { c2 }]
    }

    #[inline(always)]
    fn segment(&self) -> Segment {
        self.ends.map(|word| [word as u32, (word >> 32) as u32].map(f32::from_bits))
    }
}

/// As taught: from the ends as they stand, in the rounded arithmetic `R`.
pub(super) struct Taught<R> {
    ends: [[R; 2]; 2],
    window: [R; 4],
    /// The same borders, by name.
    at: Window,
    /// From which end a cut is computed.
    from: End,
}

impl<R: Real> Taught<R> {
    pub(super) fn new(segment: Segment, window: &Window, mistakes: Mistakes) -> Self {
        let Window { xmin, ymin, xmax, ymax } = *window;
        Self {
            ends: segment.map(|p| p.map(R::from_f32)),
            window: [xmin, ymin, xmax, ymax].map(R::from_f32),
            at: *window,
            from: if mistakes.has(Mistake::OtherOrder) { End::P2 } else { End::P1 },
        }
    }
}

impl<R: Real> Form for Taught<R> {
    const ROUNDS: bool = true;

    fn code(&self, end: End) -> Outcode {
        Outcode::of(self.ends[end as usize], self.window)
    }

    fn cut(&mut self, border: Border, codes: [Outcode; 2]) -> [Outcode; 2] {
        let end = End::beyond(border, codes);
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let c = R::from_f32(self.at.at(border));
        let [p1, p2] = [self.from, self.from.other()].map(|end| self.ends[end as usize]);
        let t = (c - p1[fixed]) / (p2[fixed] - p1[fixed]);
        let moved = &mut self.ends[end as usize];
        moved[fixed] = c;
        moved[free] = p1[free] + t * (p2[free] - p1[free]);
        End::ALL.map(|e| if e == end { self.code(end) } else { codes[e as usize] })
    }

    fn segment(&self) -> Segment {
        self.ends.map(|p| p.map(R::to_f32))
    }
}
