//! A drawing as flat shapes: what the screen paints and what the files hold.
//!
//! Coordinates are points, x to the right, y down, the origin in the upper left corner. The window
//! paints exactly these shapes in exactly this order, and [`svg`](crate::svg::svg) and
//! [`png`](crate::png::png) write them; so the screen and the exported picture are the same.

use std::sync::Arc;

use crate::theme::Color;

/// A drawing: later shapes cover earlier ones, and nothing is visible outside `size`.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Width and height in points, positive.
    pub size: [f32; 2],
    /// What lies under all shapes.
    pub background: Color,
    /// In the order of painting.
    pub shapes: Vec<Shape>,
}

/// One thing to paint. All coordinates are finite.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The inside of a polygon, by the even-odd rule; it may be concave.
    Fill {
        /// Corners in either order.
        points: Vec<[f32; 2]>,
        /// Colour of the inside.
        color: Color,
    },
    /// A line through points.
    Line {
        /// Two or more.
        points: Vec<[f32; 2]>,
        /// Whether the last point is joined to the first.
        closed: bool,
        /// How it is drawn.
        stroke: Stroke,
    },
    /// A circle.
    Circle {
        /// Its centre.
        center: [f32; 2],
        /// Its radius, positive.
        radius: f32,
        /// Colour of the inside.
        fill: Option<Color>,
        /// The outline, on both sides of the radius.
        stroke: Option<Stroke>,
    },
    /// A rectangle with sides along the axes.
    Rect {
        /// Upper left corner.
        min: [f32; 2],
        /// Lower right corner.
        max: [f32; 2],
        /// Radius of its corners; 0: sharp.
        radius: f32,
        /// Colour of the inside.
        fill: Option<Color>,
        /// The outline, on both sides of the border.
        stroke: Option<Stroke>,
    },
    /// One line of text.
    Text {
        /// The point that `align` refers to.
        at: [f32; 2],
        /// Which point of the text's box lies at `at`: across and down.
        align: [Align; 2],
        /// What is written, without line breaks.
        text: String,
        /// In which font.
        font: Font,
        /// Size of the em in points.
        size: f32,
        /// In which colour.
        color: Color,
    },
    /// A picture, each of its pixels a sharp rectangle.
    Image {
        /// Upper left corner.
        min: [f32; 2],
        /// Lower right corner.
        max: [f32; 2],
        /// Columns and rows.
        size: [usize; 2],
        /// RGBA8, straight alpha, row by row from the top; `4 * columns * rows` bytes.
        rgba: Arc<Vec<u8>>,
    },
    /// Another drawing with its background; nothing of it is visible outside its size.
    Inset {
        /// Upper left corner.
        at: [f32; 2],
        /// The drawing.
        figure: Figure,
    },
}

/// How a line is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its colour.
    pub color: Color,
    /// Its width in points.
    pub width: f32,
    /// Lengths of dashes and gaps in turn, in points; empty: solid.
    pub dash: &'static [f32],
    /// How far into the dash pattern the line starts, in points.
    pub phase: f32,
}

impl Stroke {
    /// A solid line.
    pub const fn solid(color: Color, width: f32) -> Self {
        Self { color, width, dash: &[], phase: 0.0 }
    }
}

/// Which side of a text's box lies at its anchor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// The left or upper side.
    Min,
    /// The middle.
    Center,
    /// The right or lower side.
    Max,
}

impl Align {
    /// How much of the box lies before the anchor: 0, one half or 1.
    pub const fn fraction(self) -> f32 {
        match self {
            Self::Min => 0.0,
            Self::Center => 0.5,
            Self::Max => 1.0,
        }
    }
}

/// The four fonts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Font {
    /// Noto Sans Regular: prose.
    Sans,
    /// Noto Sans Bold: titles.
    SansBold,
    /// DejaVu Sans Mono: numbers, listings.
    Mono,
    /// DejaVu Sans Mono Bold: labels on the canvas.
    MonoBold,
}

impl Font {
    /// All fonts.
    pub const ALL: [Self; 4] = [Self::Sans, Self::SansBold, Self::Mono, Self::MonoBold];
}

impl Figure {
    /// The texts in the order of painting.
    pub fn texts(&self) -> Box<dyn Iterator<Item = &str> + '_> {
        Box::new(self.shapes.iter().flat_map(|shape| match shape {
            Shape::Text { text, .. } => Box::new(std::iter::once(text.as_str())),
            Shape::Inset { figure, .. } => figure.texts(),
            _ => Box::new(std::iter::empty()),
        }))
    }
}
