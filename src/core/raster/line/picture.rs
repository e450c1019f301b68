//! What the drawings of all line algorithms share.

use super::{Pixel, Segment, on_image};
use crate::{
    compare::Fact,
    explain::{Label, MOST_PIXELS, Mark, Role, View},
    message::Value,
    raster::{YAxis, view::view_around},
};

/// The centre of a pixel, on or off the image.
pub(super) fn centre(pixel: Pixel) -> [f32; 2] {
    pixel.map(|n| n as f32 + 0.5)
}

/// The pixels drawn so far, the last one as active.
pub(super) fn pixels(drawn: &[Pixel], size: [u32; 2], out: &mut Vec<Mark>) {
    let seen = || drawn.iter().filter(|pixel| on_image(**pixel, size).is_some());
    if drawn.len() > MOST_PIXELS {
        out.extend(seen().map(|&[x, y]| Mark::Run {
            y,
            columns: [x, x + 1],
            role: Role::Accepted,
            object: Some(0),
        }));
        return;
    }
    out.extend(seen().map(|&at| pixel(at, Role::Accepted, Some(0))));
    out.extend(drawn.last().map(|&at| pixel(at, Role::Active, Some(0))));
}

/// One pixel.
pub(super) fn pixel(at: Pixel, role: Role, object: Option<usize>) -> Mark {
    Mark::Pixel { at, role, object, value: Value::None }
}

/// The line that is drawn, the one that was given if that is another, and the given ends.
pub(super) fn line(given: Segment, drawn: Segment, out: &mut Vec<Mark>) {
    if given != drawn {
        out.push(Mark::Segment { ends: given, role: Role::Exact, label: None });
    }
    out.push(Mark::Segment { ends: drawn, role: Role::Neutral, label: None });
    for (name, at) in ["P1", "P2"].into_iter().zip(given) {
        out.push(Mark::Point { at, role: Role::Neutral, label: Some(Label::new(name, at)) });
    }
}

/// The part of the image around the line.
pub(super) fn view(ends: Segment, size: [u32; 2]) -> View {
    view_around(ends.into_iter(), size, YAxis::Down)
}

/// The pixels as facts.
pub(super) fn facts(drawn: &[Pixel], size: [u32; 2], out: &mut Vec<Fact>) {
    let seen = drawn.iter().filter_map(|&pixel| on_image(pixel, size));
    out.extend(seen.map(|pixel| Fact::pixel(pixel, Vec::new())));
}
