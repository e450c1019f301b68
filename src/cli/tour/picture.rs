//! A drawing on the page: marks to a figure to an embedded picture.

use rasterscope_core::explain::{Mark, View};
use rasterscope_figure::{
    layout::{self, Placement, RULER},
    png, svg,
    theme::Theme,
};

use crate::words::WORDS;

use super::page::{embed, escape};

/// Width of a picture on the page in points.
const WIDTH: f32 = 720.0;
/// Heights that a picture may have.
const HEIGHTS: [f32; 2] = [160.0, 720.0];

/// What one picture shows.
#[derive(Debug)]
pub(super) struct Drawing {
    pub(super) marks: Vec<Mark>,
    pub(super) view: View,
    /// Message id of the sentence below it, which is its text for those who listen, too.
    pub(super) caption: &'static str,
    /// Whether its image was painted for this picture, two pixels a point, edge to edge.
    pub(super) painted: bool,
}

impl Drawing {
    /// The picture with its caption.
    pub(super) fn html(&self, theme: &Theme) -> String {
        let span = [0, 1].map(|axis| (self.view.max[axis] - self.view.min[axis]).max(1e-9));
        let (inset, ruler) = if self.painted { (0.0, 0.0) } else { (16.0, RULER as f32) };
        let inner = (WIDTH - 2.0 * inset - ruler) * span[1] / span[0];
        let size = [WIDTH, (inner + 2.0 * inset + ruler).clamp(HEIGHTS[0], HEIGHTS[1])];
        let placement = Placement::fit(&self.view, size, inset);
        let figure = layout::draw(&self.marks, &self.view, &placement, size, theme, &WORDS);
        let caption = WORDS.word(self.caption);
        let picture = if placement.scale < 1.0 {
            // One pixel for each pixel of the image: smaller than SVG, and smooth when it shrinks.
            embed("image/png", &png::png(&figure, (1.0 / placement.scale).min(4.0) as f32), size, &caption)
        } else {
            embed("image/svg+xml", svg::svg(&figure).as_bytes(), size, &caption)
        };
        format!("<figure>{picture}<figcaption>{}</figcaption></figure>", escape(&caption))
    }
}
