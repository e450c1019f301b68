//! The pixels of an image as marks: what each holds, and the verdicts of what is being drawn.

use super::{Mark, Role, View};

/// More pixels than these stand in [`Mark::Run`]s: a mark each would take longer than a frame, and
/// they are too small to show a value.
pub const MOST_PIXELS: usize = 1 << 15;

/// Images up to this many pixels show empty pixels with their clear value.
const SHOWS_CLEAR: usize = 1024;

/// An image whose pixels belong to objects and hold a value each.
pub(crate) trait Cells {
    /// Width and height in pixels.
    fn size(&self) -> [u32; 2];

    /// The object that a pixel shows.
    fn object(&self, pixel: [u32; 2]) -> Option<usize>;

    /// What a pixel holds.
    fn cell(&self, pixel: [u32; 2], role: Role) -> Mark;

    /// Whether a pixel holds anything but what it was cleared to.
    fn is_used(&self, pixel: [u32; 2]) -> bool {
        self.object(pixel).is_some()
    }

    /// Pixels that the object being drawn was tested at, and what the verdict means.
    fn verdicts(&self) -> &[([u16; 2], Role)];

    /// The row in hand.
    fn row(&self) -> u32;

    /// What every pixel of the view holds; a tick or a cross where the object was tested.
    fn mark_cells(&self, view: View, out: &mut Vec<Mark>) {
        let [width, height] = self.size();
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        if pixels.filter(|pixel| self.is_used(*pixel)).count() > MOST_PIXELS {
            for y in 0..height {
                self.mark_runs(y, out);
            }
            // Of the object's verdicts only those of the row in hand.
            let here = self.verdicts().iter().filter(|([_, y], _)| u32::from(*y) == self.row());
            out.extend(here.map(|([x, y], role)| self.cell([*x, *y].map(u32::from), *role)));
            return;
        }
        let shows_clear = width as usize * height as usize <= SHOWS_CLEAR;
        let seen = |x: u32, axis: usize| (view.min[axis]..view.max[axis]).contains(&(x as f32));
        for y in (0..height).filter(|y| seen(*y, 1)) {
            for x in (0..width).filter(|x| seen(*x, 0)) {
                if shows_clear || self.is_used([x, y]) {
                    out.push(self.cell([x, y], Role::Neutral));
                }
            }
        }
        out.extend(self.verdicts().iter().map(|(pixel, role)| self.cell(pixel.map(u32::from), *role)));
    }

    /// The objects that a row shows.
    fn mark_runs(&self, y: u32, out: &mut Vec<Mark>) {
        let [width, _] = self.size();
        let mut begin = 0;
        while begin < width {
            let object = self.object([begin, y]);
            let end = (begin + 1..width).find(|x| self.object([*x, y]) != object).unwrap_or(width);
            if object.is_some() {
                let (y, columns) = (y as i32, [begin, end].map(|x| x as i32));
                out.push(Mark::Run { y, columns, role: Role::Neutral, object });
            }
            begin = end;
        }
    }
}
