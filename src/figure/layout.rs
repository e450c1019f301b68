//! From the marks of a lab to a figure: the one painter of all drawings.
//!
//! Painting order: fills, grid, outlines, what was removed, what was kept, the current step,
//! handles, plates, text, selection. Everything is clipped to the canvas; marks that are not finite
//! are left out.

use rasterscope_core::{
    explain::{Grid, Label, Mark, Role, View},
    message::{Message, Value},
};

use crate::{
    canvas::{Canvas, Layer, TextStyle, narrow},
    cells::{self, Cells},
    figure::{Figure, Font, Shape, Stroke},
    geometry::{Rect, centroid, distance, mix},
    grid,
    labels::{self, Anchor, Wish},
    legend, markers, overlay,
    theme::Theme,
    words::Words,
};
pub use crate::{
    labels::Places,
    placement::{Placement, RULER},
};

/// Draws `marks` of a plane that `view` describes, as `placement` lays it on a canvas of `size`.
pub fn draw(
    marks: &[Mark],
    view: &View,
    placement: &Placement,
    size: [f32; 2],
    theme: &Theme,
    words: &Words,
) -> Figure {
    draw_held(marks, view, placement, size, (theme, words), None).0
}

/// [`draw`], with the labels where they stood in an earlier drawing of as many labels.
///
/// While a point is dragged its label must not jump: pass the places of the drawing at which the
/// drag began.
pub fn draw_held(
    marks: &[Mark],
    view: &View,
    placement: &Placement,
    size: [f32; 2],
    (theme, words): (&Theme, &Words),
    held: Option<&Places>,
) -> (Figure, Places) {
    let mut canvas = Canvas::new(placement, size, theme, words);
    canvas.pictured = marks.iter().any(|mark| matches!(mark, Mark::Image { .. }));
    let cells = Cells::of(marks);
    grid::draw(&mut canvas, view, &cells);
    let mut wishes = Vec::new();
    for (index, mark) in marks.iter().enumerate() {
        match mark {
            Mark::Point { at, role, label } => {
                let marked = *role == Role::Active && cells.ends_span(*at);
                wish(&mut wishes, point(&mut canvas, *at, *role, marked), label.clone(), *role);
            }
            Mark::Segment { ends, role, label } => {
                wish(&mut wishes, segment(&mut canvas, *ends, *role), label.clone(), *role);
            }
            Mark::Curve { points, role, label } => {
                wish(&mut wishes, curve(&mut canvas, points, *role), label.clone(), *role);
            }
            Mark::Guide { axis, at, role, label, note } => {
                let axis = usize::from(*axis != 0);
                if guide(&mut canvas, view, axis, *at, *role, label).is_some()
                    && let Some(note) = note
                {
                    let text = words.message(note);
                    wish(&mut wishes, canvas.far_end(axis, *at, &text), Some(Label::name(text)), *role);
                }
            }
            Mark::Polygon { points, role, object, label } => {
                let visible = polygon(&mut canvas, view, points, *role, *object);
                if let (Some(label), false) = (label, visible.is_empty()) {
                    let anchor = Anchor::Area(canvas.areas.len(), centroid(&visible));
                    canvas.areas.push(visible);
                    let object = label.object.or(*object);
                    wish(&mut wishes, Some(anchor), Some(Label { object, ..label.clone() }), *role);
                }
            }
            Mark::Pixel { .. } => cells.pixel(&mut canvas, index, mark),
            Mark::Shade { at, share } => cells::shade(&mut canvas, *at, *share),
            Mark::Run { y, columns, role, object } => {
                cells::cells_of_row(&mut canvas, *y, *columns, *role, *object);
            }
            Mark::Span { y, ends, role } => cells.span(&mut canvas, *y, *ends, *role),
            Mark::Text { at, label, role, big } => text(&mut canvas, *at, label, *role, *big),
            Mark::Numbers(field) => overlay::numbers(&mut canvas, field),
            Mark::Wires(lines) => overlay::wires(&mut canvas, lines),
            Mark::Key { .. } | Mark::Ramp { .. } => {} // at the foot, when the rest has its place
            Mark::Hint { .. } => {}                    // for a pointer
            Mark::Image { size, rgba } => image(&mut canvas, *size, rgba),
            // Of no plane: `space::seen` turns it into marks that are.
            Mark::Space(_) => {}
        }
    }
    legend::reserve(&mut canvas, marks);
    let places = labels::draw(&mut canvas, &wishes, held);
    legend::draw(&mut canvas, marks);
    (canvas.finish(), places)
}

/// Notes a label, attached to the first of some anchors or to another one.
fn wish(wishes: &mut Vec<Wish>, anchors: impl IntoIterator<Item = Anchor>, label: Option<Label>, role: Role) {
    let mut anchors = anchors.into_iter();
    if let (Some(anchor), Some(label)) = (anchors.next(), label) {
        wishes.push(Wish { anchor, others: anchors.collect(), label, role });
    }
}

/// Says that cells are too small for their values, and how far to zoom in; `None` if they are not.
pub fn hidden_values(marks: &[Mark], placement: &Placement) -> Option<Message> {
    cells::too_small(marks, placement.scale)
}

fn point(canvas: &mut Canvas<'_>, at: [f32; 2], role: Role, marked: bool) -> Option<Anchor> {
    let at = canvas.points(at)?;
    if canvas.sees(at) && !marked {
        let style = canvas.theme.style(role);
        let layer = if role == Role::Active { Layer::ActiveHandle } else { Layer::Handle };
        canvas.extend(layer, markers::point(style.marker, narrow(at), style.color, canvas.theme));
        let reach = if role == Role::Active { 24.0 } else { 18.0 };
        canvas.kept_clear.push(Rect::around(at, [reach; 2]));
    }
    Some(Anchor::Point(at))
}

fn segment(canvas: &mut Canvas<'_>, ends: [[f32; 2]; 2], role: Role) -> Option<Anchor> {
    let ends = [canvas.points(ends[0])?, canvas.points(ends[1])?];
    canvas.role_line(&ends, false, role);
    let visible = canvas.rect.clip(ends)?;
    if role == Role::Rejected && distance(visible[0], visible[1]) > 48.0 {
        let middle = mix(visible[0], visible[1], 0.5);
        let style = canvas.theme.style(role);
        let radius = 7.0 + canvas.theme.extra_stroke;
        let cross = markers::marker(style.marker, narrow(middle), radius, style.color, canvas.theme.canvas);
        canvas.extend(Layer::Handle, cross);
        canvas.kept_clear.push(Rect::around(middle, [14.0; 2]));
    }
    Some(Anchor::Segment(visible))
}

/// Where its name may stand: at its middle, or, where that is near other lines, at another part.
fn curve(canvas: &mut Canvas<'_>, points: &[[f32; 2]], role: Role) -> Vec<Anchor> {
    let points: Option<Vec<_>> = points.iter().map(|p| canvas.points(*p)).collect();
    let Some(points) = points else { return Vec::new() };
    canvas.role_line(&points, false, role);
    let part = |share: f64| {
        let at = (points.len() as f64 * share) as usize;
        Some([*points.get(at.checked_sub(1)?)?, *points.get(at)?])
    };
    let middle = part(0.5).and_then(|ends| canvas.rect.clip(ends));
    let others = [0.62, 0.38, 0.75, 0.25, 0.88, 0.12].into_iter().filter_map(part);
    let others = others.filter_map(|ends| canvas.rect.clip(ends));
    middle.into_iter().chain(others).map(Anchor::Segment).collect()
}

/// `None` if the line is off the canvas.
fn guide(
    canvas: &mut Canvas<'_>,
    view: &View,
    axis: usize,
    at: f32,
    role: Role,
    label: &Option<Label>,
) -> Option<()> {
    let at = canvas.points([at; 2]).map(|p| p[axis])?;
    if !(0.0..=canvas.rect.max[axis]).contains(&at) {
        return None;
    }
    let across = [canvas.frame.min[1 - axis], canvas.frame.max[1 - axis]];
    let line = across.map(|along| if axis == 0 { [at, along] } else { [along, at] });
    if matches!(role, Role::Neutral | Role::Candidate) {
        // Construction lies under all outlines.
        let width = 1.5 + canvas.theme.extra_stroke;
        let stroke = Stroke { color: canvas.theme.edge, width, dash: &[6.0, 4.0], phase: 0.0 };
        canvas.line(Layer::Grid, &line, false, stroke);
    } else if view.grid == Grid::Pixels {
        // The row or column in hand: the span on it is what is lit.
        let color = canvas.theme.style(role).color;
        let stroke = Stroke { color, width: 1.0, dash: &[3.0, 3.0], phase: 0.0 };
        canvas.line(Layer::Outline, &line, false, stroke);
    } else {
        canvas.role_line(&line, false, role);
    }
    if let Some(label) = label {
        labels::guide(canvas, axis, at, label, role);
    }
    Some(())
}

/// Draws a polygon; answers the part of it on the canvas.
fn polygon(
    canvas: &mut Canvas<'_>,
    view: &View,
    points: &[[f32; 2]],
    role: Role,
    object: Option<usize>,
) -> Vec<[f64; 2]> {
    let points: Option<Vec<_>> = points.iter().map(|&p| canvas.points(p)).collect();
    let Some(points) = points else { return Vec::new() };
    let theme = canvas.theme;
    let style = theme.style(role);
    if let Some(index) = object {
        let (color, repeated) = theme.object(index);
        canvas.fill(&points, color.alpha(theme.object_alpha));
        if repeated {
            canvas.hatch(&points, theme.canvas.alpha(0.7));
        }
    }
    match role {
        Role::Active => {
            let color = canvas.active_fill();
            canvas.fill(&points, color);
        }
        Role::Accepted if object.is_none() => canvas.fill(&points, style.color.alpha(style.fill_alpha)),
        // A window or a visible box: what lies inside is what is kept.
        Role::Neutral if object.is_none() && view.grid != Grid::Pixels => {
            let color = theme.style(Role::Accepted).color.alpha(0.05);
            canvas.fill(&points, color);
        }
        _ => {}
    }
    if style.hatch {
        canvas.hatch(&points, style.color.alpha(0.55));
    }
    canvas.role_line(&points, true, role);
    canvas.rect.clip_polygon(&points)
}

/// Free text; the codes of regions stand a little inside the corner at which they are put.
fn text(canvas: &mut Canvas<'_>, at: [f32; 2], label: &Label, role: Role, big: bool) {
    let Some(at) = canvas.points(at) else { return };
    let theme = canvas.theme;
    let noted = big && !label.name.is_empty() && label.value != Value::None;
    let (text, phrase) = labels::written(canvas, label, !noted);
    let quiet = matches!(role, Role::Candidate | Role::Skipped);
    let font = match (phrase, quiet) {
        (true, true) => Font::Sans,
        (true, false) => Font::SansBold,
        (false, true) => Font::Mono,
        (false, false) => Font::MonoBold,
    };
    let size = if big { theme.sizes.region } else { theme.sizes.canvas };
    let color = if quiet { theme.dim } else { labels::color(canvas, role) };
    let style = TextStyle { text: &text, font, size, color };
    // A big text stands clear of the plate of a guide through the corner.
    let down = f64::from(theme.sizes.canvas) * labels::PLATE / 2.0 + 3.0;
    let corner = if big { [at[0] + 12.0, at[1] + down] } else { [at[0] + 12.0, at[1] + 3.0] };
    let Some(rect) = free_below(canvas, corner, style.measure()) else { return };
    // A code that would stand far below its place would stand in another region.
    let astray = big && quiet && rect.min[1] - corner[1] > style.measure()[1];
    if text.is_empty() || astray {
        return;
    }
    canvas.kept_clear.push(rect);
    if !big {
        return canvas.plate(rect.grown(3.0), theme.canvas.alpha(0.9), None, style);
    }
    canvas.text(Layer::Text, rect.center(), style);
    if !quiet {
        let foot = rect.max[1] + 1.0;
        let stroke = Stroke::solid(color, 2.0 + theme.extra_stroke);
        canvas.line(Layer::Text, &[[rect.min[0], foot], [rect.max[0], foot]], false, stroke);
    }
    if noted {
        let note = canvas.words.value(&label.value);
        let style = TextStyle { text: &note, font: Font::Mono, size: theme.sizes.canvas, color: theme.dim };
        let extent = style.measure();
        let min = [rect.max[0] + 10.0, rect.center()[1] - extent[1] / 2.0 + 2.0];
        let rect = Rect { min, max: [min[0] + extent[0], min[1] + extent[1]] };
        if rect.inside(canvas.rect) && !canvas.kept_clear.iter().any(|other| other.overlaps(rect)) {
            canvas.kept_clear.push(rect);
            canvas.text(Layer::Text, rect.center(), style);
        }
    }
}

/// A place of that size at a corner, or at most two lines below it; `None` if those are taken.
fn free_below(canvas: &Canvas<'_>, corner: [f64; 2], [width, height]: [f64; 2]) -> Option<Rect> {
    let mut rect = Rect { min: corner, max: [corner[0] + width, corner[1] + height] };
    for _ in 0..3 {
        let taken = canvas.kept_clear.iter().find(|other| other.overlaps(rect));
        let Some(taken) = taken else { return Some(rect).filter(|rect| rect.inside(canvas.rect)) };
        rect = rect.shifted([0.0, taken.max[1] + 3.0 - rect.min[1]]);
    }
    None
}

fn image(canvas: &mut Canvas<'_>, size: [usize; 2], rgba: &std::sync::Arc<Vec<u8>>) {
    let [columns, rows] = size;
    if columns == 0 || rows == 0 || rgba.len() != 4 * columns * rows {
        return;
    }
    let corners =
        [[0.0, 0.0], [columns as f64, rows as f64]].map(|p| canvas.placement.wide(p).map(f64::round));
    let flipped = canvas.placement.y_up;
    let rgba = if flipped {
        std::sync::Arc::new(rgba.chunks_exact(4 * columns).rev().flatten().copied().collect())
    } else {
        rgba.clone()
    };
    let [a, b] = corners;
    let min = [a[0], a[1].min(b[1])];
    let max = [b[0], a[1].max(b[1])];
    canvas.push(Layer::Fill, Shape::Image { min: narrow(min), max: narrow(max), size, rgba });
}

#[cfg(test)]
mod tests;
