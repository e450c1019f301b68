//! The drawing under construction: layers of shapes, and what labels must keep clear of.

use rasterscope_core::explain::Role;

use crate::{
    figure::{Figure, Font, Shape, Stroke},
    geometry::{Rect, distance, edges, hatch},
    labels::Anchor,
    placement::Placement,
    text,
    theme::{Color, Theme, ThemeName},
    words::Words,
};

/// Everything is clipped to the canvas and this much around it, so that ends stay out of sight.
const MARGIN: f64 = 24.0;
/// More lines than this are not avoided by labels: in a mesh there is no free place anyway.
const LINES: usize = 2000;
/// Distance of hatch lines.
const HATCH: f64 = 8.0;

/// The order of painting.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Layer {
    Fill,
    Grid,
    Outline,
    Removed,
    Kept,
    Underlay,
    Active,
    Handle,
    ActiveHandle,
    Plate,
    Text,
    Selection,
}

impl Layer {
    const COUNT: usize = Self::Selection as usize + 1;

    /// Where the lines of a role lie.
    pub(crate) fn of(role: Role) -> Self {
        match role {
            Role::Active => Self::Active,
            Role::Rejected => Self::Removed,
            Role::Accepted | Role::Tie | Role::Changed => Self::Kept,
            _ => Self::Outline,
        }
    }
}

pub(crate) struct Canvas<'a> {
    pub(crate) theme: &'a Theme,
    pub(crate) words: &'a Words,
    pub(crate) placement: Placement,
    /// The visible part of the plane, in points.
    pub(crate) rect: Rect,
    layers: [Vec<Shape>; Layer::COUNT],
    /// The cells of a pixel grid, as far as they are on the canvas; else all of the canvas.
    pub(crate) frame: Rect,
    /// Whether a picture lies under the drawing.
    pub(crate) pictured: bool,
    /// What no label may cover: handles, fixed plates, region codes, values.
    pub(crate) kept_clear: Vec<Rect>,
    /// What labels avoid if they can: marks in cells.
    pub(crate) small: Vec<Rect>,
    /// Areas that have a name, as far as they are on the canvas.
    pub(crate) areas: Vec<Vec<[f64; 2]>>,
    /// Lines of the current step; no label may cover them.
    pub(crate) active_lines: Vec<[[f64; 2]; 2]>,
    /// All other lines of roles; labels avoid them if they can.
    pub(crate) lines: Vec<[[f64; 2]; 2]>,
}

impl<'a> Canvas<'a> {
    pub(crate) fn new(placement: &Placement, size: [f32; 2], theme: &'a Theme, words: &'a Words) -> Self {
        let rect = Rect { min: [0.0; 2], max: size.map(f64::from) };
        Self {
            theme,
            words,
            placement: *placement,
            rect,
            frame: rect,
            pictured: false,
            layers: Default::default(),
            kept_clear: Vec::new(),
            small: Vec::new(),
            areas: Vec::new(),
            active_lines: Vec::new(),
            lines: Vec::new(),
        }
    }

    pub(crate) fn finish(self) -> Figure {
        Figure {
            size: narrow(self.rect.max),
            background: self.theme.canvas,
            shapes: self.layers.into_iter().flatten().collect(),
        }
    }

    pub(crate) fn push(&mut self, layer: Layer, shape: Shape) {
        self.layers[layer as usize].push(shape);
    }

    pub(crate) fn last_mut(&mut self, layer: Layer) -> Option<&mut Shape> {
        self.layers[layer as usize].last_mut()
    }

    pub(crate) fn extend(&mut self, layer: Layer, shapes: impl IntoIterator<Item = Shape>) {
        self.layers[layer as usize].extend(shapes);
    }

    /// A scene point in points; `None` if it is not finite.
    pub(crate) fn points(&self, p: [f32; 2]) -> Option<[f64; 2]> {
        let p = self.placement.wide(p.map(f64::from));
        p.iter().all(|c| c.is_finite()).then_some(p)
    }

    /// Whether a marker at `p` would be seen.
    pub(crate) fn sees(&self, p: [f64; 2]) -> bool {
        self.rect.grown(12.0).contains(p)
    }

    /// A line in the style of `role`, with the underlay that belongs to it.
    pub(crate) fn role_line(&mut self, points: &[[f64; 2]], closed: bool, role: Role) {
        let style = self.theme.style(role);
        if let Some((color, width)) = style.underlay {
            self.line(Layer::Underlay, points, closed, Stroke::solid(color, width));
        }
        let stroke = Stroke { color: style.color, width: style.width, dash: style.dash, phase: 0.0 };
        if self.pictured {
            // Black is a value of the picture, and ink: the line lies on a strip of canvas.
            let strip = Stroke::solid(self.theme.canvas.alpha(0.75), style.width + 2.0);
            self.line(Layer::Grid, points, closed, strip);
        }
        self.line(Layer::of(role), points, closed, stroke);
        let visible = self.rect;
        let lines = if role == Role::Active { &mut self.active_lines } else { &mut self.lines };
        for ends in segments(points, closed) {
            if lines.len() < LINES {
                lines.extend(visible.clip(ends));
            }
        }
    }

    /// A line clipped to the canvas; dashes keep their phase from the line's start.
    pub(crate) fn line(&mut self, layer: Layer, points: &[[f64; 2]], closed: bool, stroke: Stroke) {
        let bounds = self.rect.grown(MARGIN);
        if points.iter().all(|&p| bounds.contains(p)) {
            let points: Vec<_> = points.iter().copied().map(narrow).collect();
            if points.len() > 1 {
                self.push(layer, Shape::Line { points, closed, stroke });
            }
            return;
        }
        let period: f64 = stroke.dash.iter().copied().map(f64::from).sum();
        let mut walked = 0.0;
        for ends in segments(points, closed) {
            if let Some(visible) = bounds.clip(ends) {
                let from_start = walked + distance(ends[0], visible[0]);
                let phase = if period > 0.0 { from_start.rem_euclid(period) as f32 } else { 0.0 };
                let stroke = Stroke { phase: if phase.is_finite() { phase } else { 0.0 }, ..stroke };
                let points = visible.map(narrow).to_vec();
                self.push(layer, Shape::Line { points, closed: false, stroke });
            }
            walked += distance(ends[0], ends[1]);
        }
    }

    /// The inside of a polygon, clipped to the canvas.
    pub(crate) fn fill(&mut self, points: &[[f64; 2]], color: Color) {
        let clipped = self.rect.grown(MARGIN).clip_polygon(points);
        if clipped.len() > 2 {
            let points = clipped.into_iter().map(narrow).collect();
            self.push(Layer::Fill, Shape::Fill { points, color });
        }
    }

    /// Hatch inside a polygon, clipped to the canvas.
    pub(crate) fn hatch(&mut self, points: &[[f64; 2]], color: Color) {
        let clipped = self.rect.grown(MARGIN).clip_polygon(points);
        for ends in hatch(&clipped, HATCH) {
            let points = ends.map(narrow).to_vec();
            self.push(Layer::Fill, Shape::Line { points, closed: false, stroke: Stroke::solid(color, 1.0) });
        }
    }

    /// A filled rectangle; with whole coordinates its sides are sharp.
    pub(crate) fn rect_shape(rect: Rect, radius: f32, fill: Option<Color>, stroke: Option<Stroke>) -> Shape {
        Shape::Rect { min: narrow(rect.min), max: narrow(rect.max), radius, fill, stroke }
    }

    /// A plate with one line of text in its middle.
    pub(crate) fn plate(&mut self, rect: Rect, fill: Color, border: Option<Color>, text: TextStyle<'_>) {
        let stroke = border.map(|color| Stroke::solid(color, 1.0));
        self.push(Layer::Plate, Self::rect_shape(rect, 3.0, Some(fill), stroke));
        self.text(Layer::Text, rect.center(), text);
    }

    /// Bare canvas under what stands over the drawing.
    pub(crate) fn ground(&mut self, rect: Rect) {
        let fill = self.theme.canvas.alpha(0.9);
        self.push(Layer::Plate, Self::rect_shape(rect, 3.0, Some(fill), None));
    }

    /// A plate in the colour of an object, with its name.
    pub(crate) fn object_plate(&mut self, rect: Rect, object: usize, text: TextStyle<'_>) {
        let stroke = Stroke::solid(self.theme.text, 1.5 + self.theme.extra_stroke * 0.5);
        let fill = self.theme.object(object).0;
        self.push(Layer::Plate, Self::rect_shape(rect, 3.0, Some(fill), Some(stroke)));
        self.text(Layer::Text, rect.center(), TextStyle { color: self.theme.object_ink(), ..text });
    }

    /// The last part of a line right through the canvas, as long as a few words beside it.
    pub(crate) fn far_end(&self, axis: usize, at: f32, words: &str) -> Option<Anchor> {
        let size = self.theme.sizes.canvas;
        let length =
            TextStyle { text: words, font: Font::SansBold, size, color: self.theme.text }.measure()[0] + 24.0;
        let at = self.points([at; 2])?[axis];
        let far = self.frame.max[0];
        Some(Anchor::Segment(if axis == 0 {
            [[at, self.frame.min[1]], [at, self.frame.min[1] + 64.0]]
        } else {
            [[far, at], [far - length, at]]
        }))
    }

    /// A line of text with its middle at `center`.
    pub(crate) fn text(&mut self, layer: Layer, center: [f64; 2], text: TextStyle<'_>) {
        use crate::figure::Align::Center;
        self.push(
            layer,
            Shape::Text {
                at: narrow(center),
                align: [Center, Center],
                text: text.text.to_owned(),
                font: text.font,
                size: text.size,
                color: text.color,
            },
        );
    }

    /// What marks an area as the current step.
    pub(crate) fn active_fill(&self) -> Color {
        match self.theme.name {
            ThemeName::Dark => self.theme.style(Role::Active).color.alpha(0.16),
            ThemeName::Light | ThemeName::Projector => self.theme.lit.alpha(0.5),
        }
    }
}

/// What is written and how.
#[derive(Clone, Copy)]
pub(crate) struct TextStyle<'a> {
    pub(crate) text: &'a str,
    pub(crate) font: Font,
    pub(crate) size: f32,
    pub(crate) color: Color,
}

impl TextStyle<'_> {
    pub(crate) fn measure(&self) -> [f64; 2] {
        text::measure(self.font, self.size, self.text).map(f64::from)
    }
}

pub(crate) fn narrow(p: [f64; 2]) -> [f32; 2] {
    p.map(|c| c as f32)
}

/// The segments of a line through `points`.
fn segments(points: &[[f64; 2]], closed: bool) -> impl Iterator<Item = [[f64; 2]; 2]> {
    let count = if closed { points.len() } else { points.len().saturating_sub(1) };
    edges(points).take(count)
}
