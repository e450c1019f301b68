//! The lines under a drawing: unit lines of the plane, or pixel cells with rulers.

use std::collections::BTreeSet;

use rasterscope_core::explain::{Grid, Role, View};

use crate::{
    canvas::{Canvas, Layer, TextStyle, narrow},
    cells::Cells,
    figure::{Font, Shape, Stroke},
    geometry::Rect,
    markers::disc,
    numbers,
    placement::RULER,
    theme::Color,
};

/// From this size of a cell on, every cell has a number on the ruler.
const EVERY_CELL: f64 = 40.0;
/// From this size of a cell on, pixel centres are shown.
const CENTRES: f64 = 28.0;
/// From this size of a cell on, each cell has its own lines.
const LINES: f64 = 5.0;

/// From this size of a cell on, lines may run over a picture.
const FINE: f64 = 4.0;

/// Rows and columns whose number on the ruler is lit.
#[derive(Debug, Default)]
pub(crate) struct Lit {
    pub(crate) columns: BTreeSet<i64>,
    pub(crate) rows: BTreeSet<i64>,
}

/// Draws the grid of `view`.
pub(crate) fn draw(canvas: &mut Canvas<'_>, view: &View, cells: &Cells) {
    match view.grid {
        Grid::None => {}
        Grid::Units => units(canvas),
        Grid::Pixels => pixels(canvas, view, cells),
    }
}

/// Lines at whole numbers; where those are too close, at every 2nd, 5th, 10th, ...
fn units(canvas: &mut Canvas<'_>) {
    let scale = canvas.placement.scale;
    let mut step = 1.0;
    for factor in [2.0, 2.5, 2.0].into_iter().cycle().take(150) {
        if step * scale >= 24.0 {
            break;
        }
        step *= factor;
    }
    let size = canvas.rect.max;
    for axis in 0..2 {
        let first = (-canvas.placement.offset[axis] / (step * scale)).ceil();
        let count = (size[axis] / (step * scale)) as usize + 1;
        for i in 0..count {
            let at = (first + i as f64) * step * scale + canvas.placement.offset[axis];
            grid_line(canvas, axis, at, [0.0, size[1 - axis]], canvas.theme.grid);
        }
    }
}

fn pixels(canvas: &mut Canvas<'_>, view: &View, cells: &Cells) {
    let cell = canvas.placement.scale;
    let Some(frame) = frame(canvas, view) else { return };
    let shown = Rect {
        min: [0, 1].map(|axis| frame.min[axis].max(0.0)),
        max: [0, 1].map(|axis| frame.max[axis].min(canvas.rect.max[axis])),
    };
    if shown.min[0] > shown.max[0] || shown.min[1] > shown.max[1] {
        return;
    }
    canvas.frame = shown;
    // From one cell to the next number on the ruler, and to the next emphasised line.
    let ruler = if cell >= EVERY_CELL { 1 } else { ruler_step(cell) };
    let major = if cell >= EVERY_CELL { i64::MAX } else { ruler };
    let visible = [0, 1].map(|axis| visible_cells(canvas, view, axis));
    for axis in 0..2 {
        let [first, end] = visible[axis];
        let across = [shown.min[1 - axis], shown.max[1 - axis]];
        for i in first..=end {
            let emphasised = i.rem_euclid(major) == 0;
            if cell >= LINES || emphasised && !(cells.pictured && cell < FINE) {
                let at = cell_edge(canvas, axis, i);
                let color = if emphasised { canvas.theme.grid_major } else { canvas.theme.grid };
                grid_line(canvas, axis, at, across, color);
            }
        }
    }
    frame_lines(canvas, frame);
    if cell >= CENTRES && !cells.pictured {
        let radius = (1.6 + canvas.theme.extra_stroke * 0.4) * (cell as f32 / 40.0).min(1.0);
        for y in visible[1][0]..visible[1][1] {
            for x in visible[0][0]..visible[0][1] {
                if !cells.taken.contains(&[x as i32, y as i32]) {
                    let at = canvas.placement.wide([x as f64 + 0.5, y as f64 + 0.5]);
                    canvas.push(Layer::Grid, disc(narrow(at), radius, canvas.theme.faint));
                }
            }
        }
    }
    for axis in 0..2 {
        let lit = if axis == 0 { &cells.lit.columns } else { &cells.lit.rows };
        ruler_numbers(canvas, axis, shown, visible[axis], ruler, lit);
    }
}

/// The cells of the view, in points; `None` if the view is not finite.
fn frame(canvas: &Canvas<'_>, view: &View) -> Option<Rect> {
    let corners = [view.min.map(f32::floor), view.max.map(f32::ceil)];
    let [a, b] = [canvas.points(corners[0])?, canvas.points(corners[1])?];
    Some(Rect { min: [0, 1].map(|axis| a[axis].min(b[axis])), max: [0, 1].map(|axis| a[axis].max(b[axis])) })
}

/// First cell and end of those of the view that are on the canvas.
fn visible_cells(canvas: &Canvas<'_>, view: &View, axis: usize) -> [i64; 2] {
    let placement = canvas.placement;
    let flip = axis == 1 && placement.y_up;
    let scene = |at: f64| {
        let c = (at - placement.offset[axis]) / placement.scale;
        if flip { -c } else { c }
    };
    let (a, b) = (scene(0.0), scene(canvas.rect.max[axis]));
    let first = a.min(b).floor().max(f64::from(view.min[axis]).floor());
    let end = a.max(b).ceil().min(f64::from(view.max[axis]).ceil());
    [first as i64, (end as i64).max(first as i64)]
}

/// Where cell `i` begins along `axis`, in points.
fn cell_edge(canvas: &Canvas<'_>, axis: usize, i: i64) -> f64 {
    let mut p = [0.0; 2];
    p[axis] = i as f64;
    canvas.placement.wide(p)[axis]
}

/// Every 6th cell, or as many times 6 as keep the numbers apart.
fn ruler_step(cell: f64) -> i64 {
    let mut step = 6;
    while (step as f64) * cell < EVERY_CELL && step < 1 << 40 {
        step *= 2;
    }
    step
}

/// One line of the grid, in the middle of a row of pixels.
fn grid_line(canvas: &mut Canvas<'_>, axis: usize, at: f64, across: [f64; 2], color: Color) {
    let at = at.round() + 0.5;
    let point = |along: f64| narrow(if axis == 0 { [at, along] } else { [along, at] });
    let points = across.map(point).to_vec();
    canvas.push(Layer::Grid, Shape::Line { points, closed: false, stroke: Stroke::solid(color, 1.0) });
}

fn frame_lines(canvas: &mut Canvas<'_>, frame: Rect) {
    let color = canvas.theme.grid_major;
    for axis in 0..2 {
        let across = [frame.min[1 - axis], frame.max[1 - axis]];
        let across = across.map(|along| along.clamp(0.0, canvas.rect.max[1 - axis]));
        for at in [frame.min[axis], frame.max[axis]] {
            if (0.0..=canvas.rect.max[axis]).contains(&at) {
                grid_line(canvas, axis, at, across, color);
            }
        }
    }
}

/// The ruler of one axis: outside the grid, or at the canvas's side if the grid goes beyond it.
fn ruler_numbers(
    canvas: &mut Canvas<'_>,
    axis: usize,
    shown: Rect,
    [first, end]: [i64; 2],
    step: i64,
    lit: &BTreeSet<i64>,
) {
    let theme = canvas.theme;
    let size = theme.sizes.canvas;
    let inside = shown.min[1 - axis] < RULER;
    let at = if inside { RULER / 2.0 } else { shown.min[1 - axis] - RULER / 2.0 + 4.0 };
    if inside {
        let mut strip = canvas.rect;
        strip.max[1 - axis] = RULER - 2.0;
        canvas.push(Layer::Plate, Canvas::rect_shape(strip, 0.0, Some(theme.canvas), None));
        canvas.kept_clear.push(strip);
    }
    for i in first..end {
        let now = lit.contains(&i);
        if i.rem_euclid(step) != 0 && !now {
            continue;
        }
        // A lit number hides regular ones that it would touch.
        if !now && step > 1 && lit.iter().any(|lit| (lit - i).abs() as f64 * canvas.placement.scale < 24.0) {
            continue;
        }
        let along = (cell_edge(canvas, axis, i) + cell_edge(canvas, axis, i + 1)) / 2.0;
        let center = if axis == 0 { [along, at] } else { [at, along] };
        let color = if now { theme.style(Role::Active).color } else { theme.dim };
        let font = if now { Font::MonoBold } else { Font::Mono };
        let text = numbers::integer(i);
        let style = TextStyle { text: &text, font, size, color };
        let rect = Rect::around(center, style.measure());
        if rect.inside(canvas.rect) {
            canvas.kept_clear.push(rect);
            canvas.text(Layer::Text, center, style);
        }
    }
}
