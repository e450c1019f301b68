//! Pixels and spans: fills, values, marks in cells.

use std::collections::{BTreeMap, BTreeSet};

use rasterscope_core::{
    explain::{Mark, Role},
    message::{Message, Value},
};

use crate::{
    canvas::{Canvas, Layer, TextStyle, narrow},
    figure::{Font, Shape, Stroke},
    geometry::Rect,
    markers::{disc, marker, ring},
    numbers::{CELL_DECIMALS, ColumnFormat},
    placement::Placement,
    theme::{Color, Marker, ThemeName},
};

/// From this size of a cell on, values are shown.
pub(crate) const VALUES: f64 = 18.0;
/// From this size of a cell on, a value may have two lines.
const TWO_LINES: f64 = 56.0;
/// Between the values of neighbours, in digits: nearer together they would be read as one.
const BETWEEN: f32 = 0.8;
/// From this size of a cell on, verdicts stand in its corner.
const CORNER: f64 = 40.0;

/// What is known of all pixels before the first is drawn.
pub(crate) struct Cells {
    format: ColumnFormat,
    /// Spans of the current step by row.
    spans: BTreeMap<i32, [f32; 2]>,
    /// The mark whose value a pixel shows, and the one whose object it wears: the last.
    values: BTreeMap<[i32; 2], usize>,
    objects: BTreeMap<[i32; 2], usize>,
    /// Pixels that have a mark.
    pub(crate) taken: BTreeSet<[i32; 2]>,
    /// Whether a picture lies under the grid: its pixels say what is drawn.
    pub(crate) pictured: bool,
    /// Rows and columns of the current step.
    pub(crate) lit: crate::grid::Lit,
}

impl Cells {
    pub(crate) fn of(marks: &[Mark]) -> Self {
        let values = marks.iter().filter_map(|mark| match mark {
            Mark::Pixel { value, .. } => Some(value),
            _ => None,
        });
        let mut cells = Self {
            format: ColumnFormat::of(values, CELL_DECIMALS),
            spans: BTreeMap::new(),
            values: BTreeMap::new(),
            objects: BTreeMap::new(),
            taken: BTreeSet::new(),
            pictured: false,
            lit: crate::grid::Lit::default(),
        };
        for (index, mark) in marks.iter().enumerate() {
            match mark {
                Mark::Pixel { at, role, object, value } => {
                    cells.taken.insert(*at);
                    if object.is_some() {
                        cells.objects.insert(*at, index);
                    }
                    if *value != Value::None {
                        cells.values.insert(*at, index);
                    }
                    if *role == Role::Active {
                        cells.lit.columns.insert(at[0].into());
                        cells.lit.rows.insert(at[1].into());
                    }
                }
                Mark::Span { y, ends, role: Role::Active } => {
                    cells.spans.insert(*y, *ends);
                    cells.lit.rows.insert((*y).into());
                }
                Mark::Image { .. } | Mark::Run { .. } => cells.pictured = true,
                Mark::Guide { axis, at, role: Role::Active, .. } => {
                    let lit = if *axis == 0 { &mut cells.lit.columns } else { &mut cells.lit.rows };
                    lit.insert(at.floor() as i64);
                }
                _ => {}
            }
        }
        cells
    }

    /// Whether a span of the current step ends at `p`, so that its end is marked already.
    pub(crate) fn ends_span(&self, p: [f32; 2]) -> bool {
        let row = p[1].floor();
        p[1] - row == 0.5 && self.spans.get(&(row as i32)).is_some_and(|ends| ends.contains(&p[0]))
    }

    /// Draws the pixel that is mark number `index`.
    pub(crate) fn pixel(&self, canvas: &mut Canvas<'_>, index: usize, mark: &Mark) {
        let Mark::Pixel { at, role, object, value } = mark else { return };
        let Some(rect) = cell_rect(&canvas.placement, canvas.rect, *at, [1, 1]) else { return };
        let covered = self.objects.get(at).is_some_and(|&last| last != index);
        let ground = fill(canvas, rect, *role, *object, covered);
        let shown = match self.values.get(at) {
            Some(&last) if last == index => self.value(canvas, rect, *role, *object, value, ground),
            Some(_) => canvas.placement.scale >= VALUES,
            None => false,
        };
        self.marks(canvas, rect, *at, *role, shown);
    }

    /// Outline and marker of a pixel's role.
    fn marks(&self, canvas: &mut Canvas<'_>, rect: Rect, at: [i32; 2], role: Role, shown: bool) {
        let theme = canvas.theme;
        let style = theme.style(role);
        let cell = canvas.placement.scale;
        let center = narrow(rect.center());
        let scale = (cell as f32 / 40.0).min(1.0);
        let grown = theme.extra_stroke;
        match role {
            Role::Active => selection(canvas, rect),
            Role::Tie | Role::Changed => {
                let inside = rect.grown(-1.25);
                let stroke = Stroke::solid(style.color, 2.5 + grown);
                canvas.push(Layer::Active, Canvas::rect_shape(inside, 0.0, None, Some(stroke)));
            }
            _ => {}
        }
        if cell < 10.0 {
            return;
        }
        let in_active_span = self.spans.get(&at[1]).is_some_and(|&ends| {
            let [first, end] = covered(ends);
            (first..end).contains(&at[0])
        });
        let loud = matches!(role, Role::Tie | Role::Changed);
        canvas.small.push(if loud { rect } else { Rect::around(rect.center(), [10.0; 2]) });
        match role {
            Role::Active | Role::Neutral | Role::Changed => {}
            Role::Accepted | Role::Rejected if shown && cell < CORNER => {}
            Role::Accepted | Role::Rejected if shown => {
                let radius = 6.5 + grown;
                let inset = f64::from(radius) + 4.0 + f64::from(grown);
                let corner = narrow([rect.max[0] - inset, rect.min[1] + inset]);
                let shapes = marker(style.marker, corner, radius, style.color, theme.canvas);
                // Over the plate of the value, which may reach into the corner; its digits do not.
                canvas.extend(Layer::Text, shapes);
                canvas.small.push(Rect::around(corner.map(f64::from), [f64::from(radius) * 2.0; 2]));
            }
            Role::Accepted => {
                let color = if in_active_span { style.color } else { theme.text };
                canvas.push(Layer::Grid, disc(center, (3.2 + 0.5 * grown) * scale, color));
            }
            Role::Candidate if !shown => {
                let color = if in_active_span { theme.style(Role::Active).color } else { style.color };
                let radius = (3.6 + 0.5 * grown) * scale;
                canvas.push(Layer::Handle, disc(center, radius, theme.canvas));
                canvas.push(Layer::Handle, ring(center, radius, color, 1.6 + 0.6 * grown));
            }
            Role::Tie if !shown => {
                let shapes = marker(Marker::Diamond, center, 9.0 * scale, style.color, theme.canvas);
                canvas.extend(Layer::ActiveHandle, shapes);
            }
            _ if !shown => {
                let shapes = marker(style.marker, center, 6.0 * scale, style.color, theme.canvas);
                canvas.extend(Layer::Handle, shapes);
            }
            _ => {}
        }
    }

    /// Writes the value if there is room for it, and says whether there was.
    fn value(
        &self,
        canvas: &mut Canvas<'_>,
        rect: Rect,
        role: Role,
        object: Option<usize>,
        value: &Value,
        ground: Color,
    ) -> bool {
        let theme = canvas.theme;
        let cell = canvas.placement.scale;
        if cell < VALUES {
            return false;
        }
        let lines = self.lines(canvas, value, cell);
        let font = if role == Role::Active { Font::MonoBold } else { Font::Mono };
        let widest = lines.iter().map(|line| line.chars().count()).max().unwrap_or(0).max(1);
        let [em, high] = crate::text::measure(font, 1.0, "0");
        let wide = cell as f32 / ((widest as f32 + BETWEEN) * em);
        let tall = cell as f32 / (lines.len().max(1) as f32 * high.max(1.25));
        let size = wide.min(tall).min(theme.sizes.canvas);
        if size < theme.sizes.smallest {
            return false;
        }
        let faint = object.is_none() && matches!(role, Role::Neutral | Role::Candidate | Role::Skipped);
        let color = match role {
            Role::Changed => theme.style(role).color,
            _ if faint => theme.faint,
            _ => theme.text,
        };
        let plate = if theme.name == ThemeName::Dark { theme.canvas } else { ground };
        let line_height = f64::from(size) * 1.25;
        let center = rect.center();
        for (i, line) in lines.iter().enumerate() {
            let style = TextStyle { text: line, font, size, color };
            let down = (i as f64 - (lines.len() as f64 - 1.0) / 2.0) * line_height;
            let center = [center[0], center[1] + down];
            if cell >= 28.0 {
                let height = if lines.len() > 1 { line_height } else { f64::from(size) * 1.4 };
                let plate_rect = Rect::around(center, [(style.measure()[0] + 6.0).min(cell - 2.0), height]);
                let shape = Canvas::rect_shape(plate_rect, 3.0, Some(plate.alpha(0.9)), None);
                canvas.push(Layer::Plate, shape);
            }
            canvas.kept_clear.push(Rect::around(center, style.measure()));
            canvas.text(Layer::Text, center, style);
        }
        true
    }

    fn lines(&self, canvas: &Canvas<'_>, value: &Value, cell: f64) -> Vec<String> {
        let number = |x: f32| {
            let whole = x == x.trunc() && x.abs() < 1e6;
            let value = Value::F32(x);
            if whole { crate::numbers::short(&value) } else { self.format.format(&value) }
        };
        let mut lines = match value {
            Value::F32(x) => vec![number(*x)],
            Value::Vector(components) => components.iter().map(|&x| number(x)).collect(),
            Value::Word(id) => vec![canvas.words.word(id)],
            Value::Text(text) => text.lines().map(str::to_owned).collect(),
            other => vec![self.format.format(other)],
        };
        lines.truncate(if cell >= TWO_LINES { 2 } else { 1 });
        lines
    }
}

/// The fill of a pixel, unless a later mark's object covers it; answers what its value stands on.
fn fill(canvas: &mut Canvas<'_>, rect: Rect, role: Role, object: Option<usize>, covered: bool) -> Color {
    let theme = canvas.theme;
    let mut ground = theme.canvas;
    let mut paint = |canvas: &mut Canvas<'_>, color: Color| {
        ground = color.over(ground);
        run(canvas, rect, color);
    };
    if let Some(index) = object
        && !covered
    {
        let (color, repeated) = theme.object(index);
        paint(canvas, color.alpha(theme.object_alpha));
        if repeated {
            let [min, max] = [rect.min, rect.max];
            canvas.hatch(&[min, [max[0], min[1]], max, [min[0], max[1]]], theme.canvas.alpha(0.7));
        }
    }
    let style = theme.style(role);
    match role {
        Role::Active if theme.name == ThemeName::Dark => paint(canvas, style.color.alpha(style.fill_alpha)),
        Role::Active => paint(canvas, theme.lit),
        Role::Accepted if object.is_none() => paint(canvas, style.color.alpha(style.fill_alpha)),
        Role::Changed if object.is_none() => paint(canvas, theme.changed_bg),
        _ => {}
    }
    ground
}

/// Shades a pixel over its fill: the later in the run, the stronger.
pub(crate) fn shade(canvas: &mut Canvas<'_>, at: [i32; 2], share: f32) {
    let color = canvas.theme.text.alpha(0.05 + 0.4 * share.clamp(0.0, 1.0));
    if let Some(rect) = cell_rect(&canvas.placement, canvas.rect, at, [1, 1]) {
        run(canvas, rect, color);
    }
}

/// Draws equal pixels of a row, from the first to the one before the last.
pub(crate) fn cells_of_row(
    canvas: &mut Canvas<'_>,
    y: i32,
    [begin, end]: [i32; 2],
    role: Role,
    object: Option<usize>,
) {
    if begin < end
        && let Some(rect) =
            cell_rect(&canvas.placement, canvas.rect, [begin, y], [end.saturating_sub(begin), 1])
    {
        fill(canvas, rect, role, object, false);
    }
}

/// Fills a cell; equal neighbours in a row become one rectangle.
fn run(canvas: &mut Canvas<'_>, rect: Rect, color: Color) {
    let next = Canvas::rect_shape(rect, 0.0, Some(color), None);
    let Shape::Rect { min: next_min, max: next_max, .. } = next else { return };
    if let Some(Shape::Rect { min, max, fill: Some(fill), .. }) = canvas.last_mut(Layer::Fill)
        && *fill == color
        && min[1] == next_min[1]
        && max[1] == next_max[1]
        && max[0] == next_min[0]
    {
        max[0] = next_max[0];
        return;
    }
    canvas.push(Layer::Fill, next);
}

/// Outline of the pixel in hand: 3 points outside the cell, with a gap around it.
fn selection(canvas: &mut Canvas<'_>, rect: Rect) {
    let width = 3.0 + canvas.theme.extra_stroke;
    let gap = Stroke::solid(canvas.theme.canvas, width + 3.0);
    let line = Stroke::solid(canvas.theme.style(Role::Active).color, width);
    let outline = rect.grown(f64::from(width) / 2.0);
    for stroke in [gap, line] {
        canvas.push(Layer::Selection, Canvas::rect_shape(outline, 0.0, None, Some(stroke)));
    }
    canvas.kept_clear.push(rect.grown(f64::from(width) + 2.0));
}

impl Cells {
    /// A half-open span on the centre line of its row; what is drawn of it keeps its colour.
    pub(crate) fn span(&self, canvas: &mut Canvas<'_>, y: i32, ends: [f32; 2], role: Role) {
        let style = canvas.theme.style(role);
        let middle = f64::from(y) + 0.5;
        let [left, right] = ends.map(|x| canvas.placement.wide([f64::from(x), middle]));
        if !left.iter().chain(&right).all(|c| c.is_finite()) {
            return;
        }
        if role == Role::Active {
            let [first, end] = covered(ends);
            let first = (first..end)
                .take_while(|&x| self.objects.contains_key(&[x, y]))
                .last()
                .map_or(first, |x| x + 1);
            if first < end
                && let Some(rect) = cell_rect(&canvas.placement, canvas.rect, [first, y], [end - first, 1])
            {
                let color = canvas.active_fill();
                canvas.push(Layer::Fill, Canvas::rect_shape(rect, 0.0, Some(color), None));
            }
        }
        canvas.role_line(&[left, right], false, role);
        let layer = Layer::Handle;
        let grown = canvas.theme.extra_stroke;
        if canvas.sees(left) {
            canvas.push(layer, disc(narrow(left), 5.0 + grown, style.color));
            canvas.kept_clear.push(Rect::around(left, [12.0; 2]));
        }
        if canvas.sees(right) {
            canvas.push(layer, disc(narrow(right), 6.0 + grown, canvas.theme.canvas));
            canvas.push(layer, ring(narrow(right), 6.0 + grown, style.color, 2.5 + grown));
            canvas.kept_clear.push(Rect::around(right, [16.0; 2]));
        }
    }
}

/// First pixel and end of a span, closed on the left: centres with `ends[0] <= x < ends[1]`.
fn covered(ends: [f32; 2]) -> [i32; 2] {
    ends.map(|x| (f64::from(x) - 0.5).ceil() as i32)
}

/// The cells from `at` on, `size` of them across and down, on whole points; `None` if off the canvas.
pub(crate) fn cell_rect(placement: &Placement, canvas: Rect, at: [i32; 2], size: [i32; 2]) -> Option<Rect> {
    let far = [0, 1].map(|axis| f64::from(at[axis]) + f64::from(size[axis]));
    let [a, b] = [at.map(f64::from), far].map(|p| placement.wide(p).map(f64::round));
    let rect =
        Rect { min: [0, 1].map(|axis| a[axis].min(b[axis])), max: [0, 1].map(|axis| a[axis].max(b[axis])) };
    rect.overlaps(canvas).then_some(rect)
}

/// Says that cells are too small for their values, and how much to zoom in; `None` if they are not.
pub(crate) fn too_small(marks: &[Mark], scale: f64) -> Option<Message> {
    let values = marks
        .iter()
        .filter(|mark| matches!(mark, Mark::Pixel { value, .. } if *value != Value::None))
        .count();
    (values > 0 && scale < VALUES).then(|| {
        Message::new("figure-values-hidden")
            .with("cells", values)
            .with("size", VALUES as i64)
            .with("zoom", (VALUES / scale).ceil())
    })
}
