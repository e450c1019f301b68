//! Two drawings side by side, and the outlines of what differs between them.

use glam::DVec2;
use rasterscope_core::{
    compare::{Difference, Fact, Pair, Setting, Side, Subject},
    explain::{Operations, Role, View},
    message::Message,
};

use crate::{
    figure::{Align, Figure, Font, Shape, Stroke},
    geometry::Rect,
    layout, markers,
    placement::Placement,
    space, text,
    theme::Theme,
    words::Words,
};

/// Height of the line above each drawing, in points.
pub const HEADER: f32 = 44.0;
/// Height of the sentence below each drawing, in points.
pub const FOOT: f32 = 52.0;
/// Dashes of what only one side has, in points.
pub const ONE_SIDE: &[f32] = &[5.0, 4.0];
/// Cells smaller than this are filled: an outline would be all of them.
const OUTLINED: f64 = 6.0;
/// Cells smaller than this are not outlined where only a number differs: it would hide the rest.
const NUMBERED: f64 = 24.0;
/// Radius of the ring round a point that differs.
const RING: f64 = 13.0;

/// In what a part differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Both sides have it, and say something else of it.
    Changed,
    /// Only one side has it.
    OneSide,
    /// Both have it; a coordinate or depth differs.
    Number,
}

/// How what differs is outlined: dashed if only one side has it, thin if only a number differs.
pub fn stroke(theme: &Theme, kind: Kind) -> Stroke {
    let color = theme.style(Role::Changed).color;
    let (width, dash) = match kind {
        Kind::Changed => (2.5 + theme.extra_stroke, &[][..]),
        Kind::OneSide => (2.5 + theme.extra_stroke, ONE_SIDE),
        Kind::Number => (1.25, &[][..]),
    };
    Stroke { color, width, dash, phase: 0.0 }
}

/// Outlines on the drawing of `side` what differs.
///
/// A pixel is outlined on both sides, also where it is missing; a point only where it is. Small
/// cells get thin outlines, and none where only a number differs.
pub fn outline(
    figure: &mut Figure,
    difference: &Difference,
    side: Side,
    placement: &Placement,
    theme: &Theme,
) {
    let Difference { only_a, only_b, changed, .. } = difference;
    let changed = changed.iter().map(|both| {
        let kind = if both.in_numbers_only() { Kind::Number } else { Kind::Changed };
        (if side == Side::A { &both.a } else { &both.b }, true, kind)
    });
    let only_a = only_a.iter().map(|fact| (fact, side == Side::A, Kind::OneSide));
    let only_b = only_b.iter().map(|fact| (fact, side == Side::B, Kind::OneSide));
    for (fact, here, kind) in changed.chain(only_a).chain(only_b) {
        let stroke = stroke(theme, kind);
        match (&fact.subject, fact.at) {
            (Subject::Pixel(pixel), _) => outline_pixel(figure, *pixel, placement, stroke, kind),
            (_, Some(at)) if here => ring(figure, placement.wide(at.map(f64::from)), stroke, theme),
            _ => {}
        }
    }
}

fn outline_pixel(figure: &mut Figure, pixel: [u32; 2], placement: &Placement, stroke: Stroke, kind: Kind) {
    let Some(cell) = cell(figure, pixel, placement) else { return };
    let width = stroke.width.min(placement.scale as f32 / 8.0);
    figure.shapes.push(match kind {
        Kind::Number if placement.scale < NUMBERED => return,
        _ if placement.scale < OUTLINED => rect(cell, Some(stroke.color.alpha(0.6)), None),
        _ => rect(cell.grown(-f64::from(width) / 2.0), None, Some(Stroke { width, ..stroke })),
    });
}

/// A pixel of the drawing, as far as it is on the canvas.
fn cell(figure: &Figure, pixel: [u32; 2], placement: &Placement) -> Option<Rect> {
    let [x, y] = pixel.map(f64::from);
    let [a, b] = [placement.wide([x, y]), placement.wide([x + 1.0, y + 1.0])];
    let [min, max] =
        [f64::min, f64::max].map(|pick| [0, 1].map(|axis| pick(a[axis].round(), b[axis].round())));
    let cell = Rect { min, max };
    cell.overlaps(Rect { min: [0.0; 2], max: figure.size.map(f64::from) }).then_some(cell)
}

fn rect(of: Rect, fill: Option<crate::theme::Color>, stroke: Option<Stroke>) -> Shape {
    let [min, max] = [of.min, of.max].map(|p| p.map(|c| c as f32));
    Shape::Rect { min, max, radius: 0.0, fill, stroke }
}

/// A ring with the marker of what changed, so that it is not told by its colour alone.
fn ring(figure: &mut Figure, at: [f64; 2], stroke: Stroke, theme: &Theme) {
    const CORNERS: u32 = 48;
    if !at.iter().all(|c| c.is_finite()) {
        return;
    }
    let corner = |i: u32| {
        let angle = f64::from(i) / f64::from(CORNERS) * std::f64::consts::TAU;
        (DVec2::from(at) + RING * DVec2::from_angle(angle)).as_vec2().to_array()
    };
    figure.shapes.push(Shape::Line { points: (0..CORNERS).map(corner).collect(), closed: true, stroke });
    let style = theme.style(Role::Changed);
    let beside = [at[0] + 0.75 * RING, at[1] - 0.75 * RING].map(|c| c as f32);
    figure.shapes.extend(markers::marker(style.marker, beside, 6.0, style.color, theme.canvas));
}

/// Marks the part that is explained beside the drawings.
pub fn choose(figure: &mut Figure, fact: &Fact, placement: &Placement, theme: &Theme) {
    let width = 3.0 + theme.extra_stroke;
    let line = Stroke::solid(theme.style(Role::Active).color, width);
    let gap = Stroke::solid(theme.canvas, width + 3.0);
    let outline = match (&fact.subject, fact.at) {
        (Subject::Pixel(pixel), _) => {
            cell(figure, *pixel, placement).map(|cell| cell.grown(f64::from(width) / 2.0))
        }
        (_, Some(at)) => Some(Rect::around(placement.wide(at.map(f64::from)), [2.0 * RING + 8.0; 2])),
        _ => None,
    };
    if let Some(outline) = outline {
        figure.shapes.extend([gap, line].map(|stroke| rect(outline, None, Some(stroke))));
    }
}

/// Both views so that one camera shows all of either; those of different kinds stay as they are.
pub fn joined([a, b]: [View; 2]) -> [View; 2] {
    if a.grid != b.grid || a.y_up != b.y_up {
        return [a, b];
    }
    let pick = |pick: fn(f32, f32) -> f32, p: [f32; 2], q: [f32; 2]| [pick(p[0], q[0]), pick(p[1], q[1])];
    let both = View { min: pick(f32::min, a.min, b.min), max: pick(f32::max, a.max, b.max), ..a };
    [both, both]
}

/// Where a view lies whose middle is where that of another one `of` is, which lies `at`; at the same scale.
pub fn stand_beside(at: Placement, of: View, view: View) -> Placement {
    let middle = |view: &View| {
        [0, 1].map(|axis| {
            let middle = (f64::from(view.min[axis]) + f64::from(view.max[axis])) / 2.0;
            if middle.is_finite() { middle } else { 0.0 }
        })
    };
    if of == view {
        return at;
    }
    let here = Placement { y_up: view.y_up, offset: [0.0; 2], ..at }.wide(middle(&view));
    let there = at.wide(middle(&of));
    Placement { y_up: view.y_up, offset: [0, 1].map(|axis| there[axis] - here[axis]), ..at }
}

/// What a run costs, in short.
pub fn counts(words: &Words, operations: Operations) -> String {
    let Operations { comparisons, multiplications, divisions } = operations;
    let count = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
    let message = Message::new("compare-counts")
        .with("comparisons", count(comparisons))
        .with("multiplications", count(multiplications))
        .with("divisions", count(divisions));
    words.message(&message)
}

/// Both runs of a pair at its cursor, as one figure of `size`, `inset` points round the drawings.
///
/// The difference is outlined at the end, when both results are there.
pub fn draw(
    pair: &Pair,
    own: [Setting; 2],
    size: [f32; 2],
    inset: f32,
    theme: &Theme,
    words: &Words,
) -> Figure {
    let views = joined(Side::ALL.map(|side| pair.run(side).view()));
    let room = drawing_size(size);
    let placement = Placement::fit(&views[0], room, inset);
    let pane = |side: Side| {
        let (run, setting, view) = (pair.run(side), own[side as usize], views[side as usize]);
        let placement = stand_beside(placement, views[0], view);
        let marks = run.marks();
        let marks = space::seen(&marks, run.vantage().as_ref(), None);
        let mut drawing = layout::draw(&marks, &view, &placement, room, theme, words);
        if pair.cursor() == pair.len() {
            outline(&mut drawing, pair.difference(), side, &placement, theme);
        }
        Pane {
            side,
            setting: [words.word(setting.word()), words.value(&setting.value())],
            counts: counts(words, run.operations()[0]),
            sentence: words.message(&run.sentence()),
            drawing,
        }
    };
    beside(Side::ALL.map(pane), theme)
}

/// One of two drawings, with what stands above and below it.
#[derive(Clone, Debug, PartialEq)]
pub struct Pane {
    /// Which one.
    pub side: Side,
    /// What the setting is called, and its value here.
    pub setting: [String; 2],
    /// What the run costs.
    pub counts: String,
    /// What happened last.
    pub sentence: String,
    /// The drawing.
    pub drawing: Figure,
}

/// How large the drawings are in a figure of `size`.
pub fn drawing_size(size: [f32; 2]) -> [f32; 2] {
    [((size[0] - 1.0) / 2.0).floor().max(1.0), (size[1] - HEADER - FOOT).max(1.0)]
}

/// Both panes as one figure, A at the left.
pub fn beside(panes: [Pane; 2], theme: &Theme) -> Figure {
    let [width, height] =
        [0, 1].map(|axis| panes.iter().map(|pane| pane.drawing.size[axis]).fold(1.0, f32::max));
    let size = [2.0 * width + 1.0, HEADER + height + FOOT];
    let mut shapes = Vec::new();
    let bar = |min: [f32; 2], max: [f32; 2], color| Shape::Rect {
        min,
        max,
        radius: 0.0,
        fill: Some(color),
        stroke: None,
    };
    shapes.push(bar([0.0, 0.0], [size[0], HEADER], theme.panel));
    for (pane, left) in panes.into_iter().zip([0.0, width + 1.0]) {
        header(&mut shapes, &pane, [left, left + width], theme);
        foot(&mut shapes, &pane.sentence, [left, HEADER + height], width, theme);
        shapes.push(Shape::Inset { at: [left, HEADER], figure: pane.drawing });
    }
    shapes.push(bar([0.0, HEADER - 1.0], [size[0], HEADER], theme.line));
    shapes.push(bar([width, 0.0], [width + 1.0, size[1]], theme.line));
    Figure { size, background: theme.canvas, shapes }
}

/// Letter in a box, the setting that differs, and what the run costs.
fn header(shapes: &mut Vec<Shape>, pane: &Pane, [left, right]: [f32; 2], theme: &Theme) {
    let middle = HEADER / 2.0;
    let mut write = |text: &str, x: f32, across: Align, font: Font, size: f32, color| {
        let at = [x, middle];
        let text = text.to_owned();
        shapes.push(Shape::Text { at, align: [across, Align::Center], text, font, size, color });
    };
    let size = theme.sizes.canvas;
    let [name, value] = &pane.setting;
    let name_at = left + 48.0;
    let value_at = name_at + text::measure(Font::Sans, size, name)[0] + 10.0;
    write(name, name_at, Align::Min, Font::Sans, size, theme.dim);
    write(value, value_at, Align::Min, Font::SansBold, size, theme.text);
    let end = value_at + text::measure(Font::SansBold, size, value)[0];
    let counts = text::measure(Font::Mono, theme.sizes.smallest, &pane.counts)[0];
    if end + 16.0 + counts <= right - 14.0 {
        write(&pane.counts, right - 14.0, Align::Max, Font::Mono, theme.sizes.smallest, theme.dim);
    }
    let letter = [left + 14.0, middle - 12.0];
    shapes.push(Shape::Rect {
        min: letter,
        max: letter.map(|c| c + 24.0),
        radius: 3.0,
        fill: Some(theme.raised),
        stroke: None,
    });
    shapes.push(Shape::Text {
        at: [left + 26.0, middle],
        align: [Align::Center; 2],
        text: pane.side.name().to_owned(),
        font: Font::SansBold,
        size,
        color: theme.text,
    });
}

/// What happened last, in at most two lines.
fn foot(shapes: &mut Vec<Shape>, sentence: &str, [left, top]: [f32; 2], width: f32, theme: &Theme) {
    let size = theme.sizes.canvas;
    let room = width - 28.0;
    let mut lines: Vec<String> = Vec::new();
    for word in sentence.split_whitespace() {
        let longer = lines.last().map(|line| format!("{line} {word}"));
        match longer.filter(|line| text::measure(Font::Sans, size, line)[0] <= room) {
            Some(longer) => *lines.last_mut().expect("it was made longer") = longer,
            None => lines.push(word.to_owned()),
        }
    }
    if lines.len() > 2 {
        lines.truncate(2);
        lines[1].push('…');
    }
    for (line, y) in lines.into_iter().zip([16.0, 36.0]) {
        shapes.push(Shape::Text {
            at: [left + 14.0, top + y],
            align: [Align::Min, Align::Center],
            text: line,
            font: Font::Sans,
            size,
            color: theme.text,
        });
    }
}
