//! The crate agg-rust: a port of Anti-Grain Geometry, binary64.

use super::{Lines, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
};
use agg_rust::{basics::Rect, clip_liang_barsky::clip_line_segment_f64};

/// From here on its answer says that nothing is visible.
const CLIPPED: u32 = 4;

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let window = Rect::new(xmin, ymin, xmax, ymax);
    list.push(Box::new(Each::new(
        "agg-rust 1.2.1, clip_line_segment",
        segments.iter().map(|&[p, q]| [wide(p), wide(q)]).collect(),
        move |segment| {
            let [[mut x1, mut y1], [mut x2, mut y2]] = *segment;
            let done = clip_line_segment_f64(&mut x1, &mut y1, &mut x2, &mut y2, &window);
            (done < CLIPPED).then_some([[x1, y1], [x2, y2]])
        },
        |part| *part,
    )));
}
