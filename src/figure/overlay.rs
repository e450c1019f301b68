//! What lies on an image: the shades of a field, its numbers in the cells, wires, what changed.

use rasterscope_core::{
    explain::{Field, Mark, Role, Sign, Tone},
    message::{Message, Value},
    pipeline::{Changed, Layer, Overlay, Wires},
};
use std::sync::Arc;

use crate::{
    canvas::{Canvas, Layer as Paint, TextStyle},
    cells::{VALUES, cell_rect},
    figure::{Font, Stroke},
    numbers::{self, CELL_DECIMALS, ColumnFormat},
    theme::{Color, Theme},
};

/// How much of the image stays under wires, and of the pixels that did not change.
const FADED: f32 = 0.35;

impl Theme {
    /// The colour of a shade of that strength, 0 to 1.
    pub fn tone(&self, tone: Tone, share: f32) -> Color {
        let share = share.clamp(0.0, 1.0);
        match tone {
            Tone::Grey => self.text.alpha(share * 0.75).over(self.canvas),
            Tone::Heat => {
                let steps = (self.heat.len() - 1) as f32;
                let at = ((share * steps) as usize).min(self.heat.len() - 2);
                self.heat[at + 1].alpha(share * steps - at as f32).over(self.heat[at])
            }
        }
    }

    /// Text or canvas: what is read better on an opaque colour.
    pub fn ink(&self, ground: Color) -> Color {
        // Luma is enough to choose between the two ends of a scale.
        let luma =
            |Color([red, green, blue, _]): Color| 2 * i32::from(red) + 5 * i32::from(green) + i32::from(blue);
        let far = |ink: Color| (luma(ink) - luma(ground)).abs();
        if far(self.text) >= far(self.canvas) { self.text } else { self.canvas }
    }
}

/// The shades of a field as RGBA8, row by row; a pixel without a shade shows the canvas.
pub fn picture(field: &Field, theme: &Theme) -> Vec<u8> {
    let pixels = field.size[0] as usize * field.size[1] as usize;
    let color = |at| field.share(at).map_or(theme.canvas, |share| theme.tone(field.tone, share));
    (0..pixels).flat_map(|at| color(at).0).collect()
}

/// A field with its numbers and its legend.
pub fn field(of: &Arc<Field>, meaning: Message, theme: &Theme) -> Vec<Mark> {
    let image = Mark::Image { size: of.size.map(|side| side as usize), rgba: Arc::new(picture(of, theme)) };
    let legend = if of.is_quiet() {
        Mark::Key { role: Role::Candidate, sign: Sign::Marker, meaning: meaning.clone() }
    } else {
        Mark::Ramp { tone: of.tone, ends: of.ends(), meaning }
    };
    vec![image, Mark::Numbers(Arc::clone(of)), legend]
}

/// What an overlay lays on an image of that size, with the image below it.
pub fn marks(layer: &Layer, size: [usize; 2], rgba: &Arc<Vec<u8>>, theme: &Theme) -> Vec<Mark> {
    let image = |rgba| Mark::Image { size, rgba };
    match layer {
        Layer::Nothing => vec![image(Arc::clone(rgba))],
        Layer::Field(overlay, of) => field(of, Message::new(meaning(*overlay, of)), theme),
        Layer::Wires(wires) => match &**wires {
            Wires::Lines(lines) => {
                let meaning = Message::new("figure-overlay-wires").with("edges", lines.len());
                let lines = Mark::Wires(Arc::new(lines.clone()));
                vec![image(faded(rgba, theme, |_| true)), lines, key(Role::Neutral, Sign::Line, meaning)]
            }
            Wires::Pixels(pixels) => {
                let mut rgba = faded(rgba, theme, |_| true).to_vec();
                for (color, _) in rgba.as_chunks_mut().0.iter_mut().zip(pixels).filter(|(_, wire)| **wire) {
                    *color = theme.text.0;
                }
                vec![
                    image(Arc::new(rgba)),
                    key(Role::Neutral, Sign::Line, Message::new("figure-overlay-wired")),
                ]
            }
        },
        Layer::Changed(None) => vec![
            image(Arc::clone(rgba)),
            key(Role::Candidate, Sign::Marker, Message::new("figure-overlay-no-edit")),
        ],
        Layer::Changed(Some(changed)) => changes(changed, size, rgba, theme),
    }
}

fn key(role: Role, sign: Sign, meaning: Message) -> Mark {
    Mark::Key { role, sign, meaning }
}

/// What the shades mean, or why there are none.
fn meaning(overlay: Overlay, field: &Field) -> &'static str {
    match (overlay, field.is_quiet()) {
        (Overlay::Depth, false) => "figure-overlay-depth",
        (Overlay::Depth, true) => "figure-overlay-no-depth",
        (Overlay::Stencil, false) => "figure-overlay-stencil",
        (Overlay::Stencil, true) => "figure-overlay-no-stencil",
        (Overlay::Written, false) => "figure-overlay-written",
        (Overlay::Equal, false) => "figure-overlay-equal",
        (Overlay::Equal, true) => "figure-overlay-no-equal",
        (_, false) => "figure-overlay-generated",
        (_, true) => "figure-overlay-no-fragment",
    }
}

/// The pixels that changed in full colour and outlined, the others faded.
fn changes(changed: &Changed, size: [usize; 2], rgba: &Arc<Vec<u8>>, theme: &Theme) -> Vec<Mark> {
    let mut same = vec![true; size[0] * size[1]];
    for [x, y] in &changed.pixels {
        same[*y as usize * size[0] + *x as usize] = false;
    }
    let mut marks = vec![Mark::Image { size, rgba: faded(rgba, theme, |at| same[at]) }];
    let outlined = changed.pixels.len() <= rasterscope_core::explain::MOST_PIXELS;
    marks.extend(changed.pixels.iter().filter(|_| outlined).map(|pixel| Mark::Pixel {
        at: pixel.map(|c| c as i32),
        role: Role::Changed,
        // Of an object of its own colour: the picture below stays to be seen.
        object: None,
        value: Value::None,
    }));
    let meaning = match changed.pixels.len() {
        0 => Message::new("figure-overlay-unchanged"),
        count => Message::new("figure-overlay-changed")
            .with("count", count)
            .with("color", changed.color)
            .with("depth", changed.depth)
            .with("stencil", changed.stencil),
    };
    marks.push(key(Role::Changed, Sign::Marker, meaning));
    marks
}

/// The image with some pixels faded towards the canvas.
fn faded(rgba: &[u8], theme: &Theme, fades: impl Fn(usize) -> bool) -> Arc<Vec<u8>> {
    let pixels = rgba.as_chunks::<4>().0.iter().enumerate();
    let color = |(at, [red, green, blue, _]): (usize, &[u8; 4])| {
        let color = Color([*red, *green, *blue, 255]);
        if fades(at) { color.alpha(FADED).over(theme.canvas).0 } else { color.0 }
    };
    Arc::new(pixels.flat_map(color).collect())
}

/// Writes the numbers of the cells on the canvas if there is room for them.
pub(crate) fn numbers(canvas: &mut Canvas<'_>, field: &Field) {
    let cell = canvas.placement.scale;
    if cell < VALUES {
        return;
    }
    let seen: Vec<_> = visible(canvas, field).collect();
    let values: Vec<_> = seen.iter().map(|(_, at)| field.value(*at)).collect();
    let format = ColumnFormat::of(&values, CELL_DECIMALS);
    let theme = canvas.theme;
    let texts: Vec<_> = values
        .iter()
        .map(|value| match value {
            Value::F32(x) if *x == x.trunc() && x.abs() < 1e6 => numbers::short(value),
            _ => format.format(value),
        })
        .collect();
    // One size for all, so that the picture stays calm.
    let widest = texts.iter().map(|text| text.chars().count()).max().unwrap_or(0).max(1);
    let [em, high] = crate::text::measure(Font::Mono, 1.0, "0");
    let wide = (cell as f32 - 4.0) / (widest as f32 * em);
    let size = wide.min(cell as f32 / high.max(1.25)).min(theme.sizes.canvas);
    if size < theme.sizes.smallest {
        return;
    }
    for ((rect, at), text) in seen.into_iter().zip(&texts) {
        let color = match field.share(at) {
            Some(share) => theme.ink(theme.tone(field.tone, share)),
            None => theme.faint,
        };
        let style = TextStyle { text, font: Font::Mono, size, color };
        canvas.kept_clear.push(crate::geometry::Rect::around(rect.center(), style.measure()));
        canvas.text(Paint::Text, rect.center(), style);
    }
}

/// The cells of a field on the canvas, with their numbers in the field.
fn visible(
    canvas: &Canvas<'_>,
    field: &Field,
) -> impl Iterator<Item = (crate::geometry::Rect, usize)> + use<> {
    let [width, height] = field.size;
    let (placement, rect) = (canvas.placement, canvas.rect);
    let corners = [rect.min, rect.max].map(|p| placement.to_scene(p.map(|c| c as f32)));
    let range = |axis: usize, side: u32| {
        let [low, high] = [f32::min, f32::max].map(|pick| pick(corners[0][axis], corners[1][axis]));
        (low.floor().max(0.0) as u32)..(high.ceil().max(0.0) as u32).min(side)
    };
    let (columns, rows) = (range(0, width), range(1, height));
    let at = move |[x, y]: [u32; 2]| y as usize * width as usize + x as usize;
    let cells = rows.flat_map(move |y| columns.clone().map(move |x| [x, y]));
    cells.filter_map(move |pixel| {
        let cell = cell_rect(&placement, rect, pixel.map(|c| c as i32), [1, 1])?;
        Some((cell, at(pixel)))
    })
}

/// Thin lines in the text colour; where cells are large they lie over the grid.
pub(crate) fn wires(canvas: &mut Canvas<'_>, lines: &[[[f32; 2]; 2]]) {
    let stroke = Stroke::solid(canvas.theme.text, 1.0 + canvas.theme.extra_stroke * 0.5);
    for ends in lines {
        if let [Some(a), Some(b)] = ends.map(|end| canvas.points(end)) {
            canvas.line(Paint::Outline, &[a, b], false, stroke);
        }
    }
}
