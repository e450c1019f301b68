//! This project: the public fast calls, one segment at a time and a slice at once.

use super::{Lines, wide};
use crate::{
    lines::{Segment, Sides},
    measure::Each,
};
use rasterscope_core::clip::line::{Window, cohen_sutherland, liang_barsky};

pub fn lines(segments: &[Segment], sides: Sides, list: &mut Lines) {
    let window = Window::new(sides).expect("the window is right");
    let read = |part: &Option<Segment>| part.map(|ends| ends.map(wide));
    list.push(Box::new(Each::new(
        "rasterscope, Cohen-Sutherland",
        segments.to_vec(),
        move |segment| cohen_sutherland::clip(*segment, &window),
        read,
    )));
    list.push(Box::new(Each::new(
        "rasterscope, Liang-Barsky",
        segments.to_vec(),
        move |segment| liang_barsky::clip(*segment, &window),
        read,
    )));
}
