//! A plot laid out: title, axes, points, key and foot, from top to bottom.

use super::{
    Plot, Point, Scale, bars,
    labels::Labels,
    points,
    ruler::{Ruler, Tick},
};
use crate::{
    figure::{Align, Figure, Font, Shape, Stroke},
    geometry::Rect,
    markers, text,
    theme::{Color, Marker, Theme, ThemeName},
};
use rasterscope_core::explain::Role;

/// Room round everything.
const INSET: f32 = 16.0;
/// Room between a tick's text and the axis.
const GAP: f32 = 7.0;

/// A plot laid out.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The drawing.
    pub figure: Figure,
    /// Where its points are.
    pub spots: Vec<Spot>,
}

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// In points of the figure.
    pub at: [f32; 2],
    /// Index of its series, and its own in there.
    pub point: [usize; 2],
}

/// Lays a plot out; the point `lit` stands out.
pub fn draw(plot: &Plot, size: [f32; 2], theme: &Theme, lit: Option<[usize; 2]>) -> Drawn {
    let mut sheet =
        Sheet { shapes: Vec::new(), theme, top: INSET, bottom: size[1] - 10.0, right: size[0] - INSET };
    let sizes = &theme.sizes;
    sheet.head(&plot.title, Font::SansBold, sizes.title, theme.text);
    sheet.head(&plot.subtitle, Font::Sans, sizes.label, theme.dim);
    sheet.foot(&plot.foot, sizes.smallest, theme.dim);
    sheet.key(plot);
    sheet.top += 4.0;
    sheet.head(&plot.axes[1].title, Font::Sans, sizes.label, theme.text);
    let line = text::measure(Font::Sans, sizes.label, "0")[1];
    sheet.bottom -= line;
    let across = sheet.bottom;
    sheet.bottom -= line + 2.0 * GAP;
    let values = |axis: usize| {
        plot.series.iter().flat_map(move |series| series.points.iter().map(move |p| p.at[axis]))
    };
    let guides = plot.guides.iter().map(|guide| guide.at);
    let up_values: Vec<f64> = values(1).chain(guides).collect();
    let [top, bottom] = [sheet.top + 10.0, sheet.bottom.max(sheet.top + 60.0)];
    let up = Ruler::new(&plot.axes[1], &up_values, bottom, top);
    let up_ticks = up.ticks(2.0 * line);
    let widest = |texts: &mut dyn Iterator<Item = &str>| {
        texts.map(|it| text::measure(Font::Sans, sizes.label, it)[0]).fold(0.0_f32, f32::max)
    };
    let names = up_ticks.iter().map(|tick| tick.text.as_str());
    let lanes = [(up.zero, &plot.axes[1].zero), (up.infinite, &plot.axes[1].infinite)];
    let lanes = lanes.iter().filter(|lane| lane.0.is_some()).map(|lane| lane.1.as_str());
    let left = INSET + widest(&mut names.chain(lanes)) + GAP;
    let x_values: Vec<f64> = values(0).collect();
    let right = sheet.right.max(left + 80.0);
    let x = Ruler::new(&plot.axes[0], &x_values, left, right);
    let x_ticks = x.ticks(sizes.label * 4.8);
    let area = Rect { min: [left, top].map(f64::from), max: [right, bottom].map(f64::from) };
    sheet.grid(plot, [&x, &up], [&x_ticks, &up_ticks], area);
    let middle = (left + right) / 2.0;
    sheet.text(
        [middle, across],
        [Align::Center, Align::Min],
        &plot.axes[0].title,
        Font::Sans,
        sizes.label,
        theme.text,
    );

    let mut labels = Labels::new(area);
    for guide in &plot.guides {
        if let Some(y) = up.at(guide.at) {
            sheet.line(
                vec![[left, y], [right, y]],
                Stroke { dash: &[12.0, 4.0], ..Stroke::solid(theme.text, 1.5) },
            );
        }
    }
    let mut spots = Vec::new();
    let named = matches!(plot.axes[0].scale, Scale::Names(_));
    if named {
        let bars = bars::draw(plot, [&x, &up], theme, &mut sheet.shapes, &mut spots);
        bars.into_iter().for_each(|[min, max]| labels.keep_clear(min, max));
    }
    for guide in &plot.guides {
        if let Some(y) = up.at(guide.at) {
            let size = text::measure(Font::SansBold, sizes.label, &guide.label);
            // At the right end, or where no bar stands.
            let corner = labels.above([left, right], y - 2.0, size);
            sheet.plate(corner, size);
            sheet.text(corner, [Align::Min; 2], &guide.label, Font::SansBold, sizes.label, theme.text);
        }
    }
    if !named {
        points::draw(plot, [&x, &up], &mut sheet, &mut spots);
        if let Some(lit) = lit.and_then(|lit| spots.iter().find(|spot| spot.point == lit)) {
            sheet.halo(lit.at);
        }
        for spot in &spots {
            let role = plot.series[spot.point[0]].role;
            sheet.shapes.extend(mark(role, spot.at, theme));
        }
    }
    labels.avoid(&spots, 7.0 + theme.extra_stroke);
    let mut order: Vec<&Spot> = spots.iter().collect();
    order.sort_by_key(|spot| Some(spot.point) != lit);
    for spot in order {
        let name = &label(plot, spot).label;
        let font = if Some(spot.point) == lit { Font::SansBold } else { Font::Sans };
        let size = text::measure(font, sizes.label, name);
        if let Some(corner) = (!name.is_empty()).then(|| labels.place(spot.at, size)).flatten() {
            sheet.plate(corner, size);
            sheet.text(corner, [Align::Min; 2], name, font, sizes.label, theme.text);
        }
    }
    Drawn { figure: Figure { size, background: theme.canvas, shapes: sheet.shapes }, spots }
}

/// Several plots side by side, in rows of `columns`.
pub fn panels(plots: &[Plot], columns: usize, size: [f32; 2], theme: &Theme) -> Drawn {
    let columns = columns.max(1);
    let rows = plots.len().div_ceil(columns).max(1);
    let each = [size[0] / columns as f32, size[1] / rows as f32].map(f32::floor);
    let mut whole =
        Drawn { figure: Figure { size, background: theme.canvas, shapes: Vec::new() }, spots: Vec::new() };
    let mut before = 0;
    for (i, plot) in plots.iter().enumerate() {
        let at = [(i % columns) as f32 * each[0], (i / columns) as f32 * each[1]];
        let Drawn { figure, spots } = draw(plot, each, theme, None);
        whole.figure.shapes.push(Shape::Inset { at, figure });
        let moved = spots.into_iter().map(|spot| Spot {
            at: [spot.at[0] + at[0], spot.at[1] + at[1]],
            point: [spot.point[0] + before, spot.point[1]],
        });
        whole.spots.extend(moved);
        before += plot.series.len();
    }
    whole
}

fn label<'a>(plot: &'a Plot, spot: &Spot) -> &'a Point {
    &plot.series[spot.point[0]].points[spot.point[1]]
}

/// The marker of a role in a plot: the taught one is filled, the accepted one has no tick.
pub fn mark(role: Role, at: [f32; 2], theme: &Theme) -> Vec<Shape> {
    let style = theme.style(role);
    let r = 6.0 + theme.extra_stroke;
    let [x, y] = at;
    match style.marker {
        Marker::DiscTick => vec![markers::disc(at, r, style.color)],
        Marker::TriangleDown => vec![Shape::Fill {
            points: vec![[x, y + 0.9 * r], [x + r, y - 0.8 * r], [x - r, y - 0.8 * r]],
            color: style.color,
        }],
        other => markers::marker(other, at, r, style.color, theme.canvas),
    }
}

/// The figure under construction: what stands above and below is taken off its height.
pub(super) struct Sheet<'a> {
    shapes: Vec<Shape>,
    pub(super) theme: &'a Theme,
    top: f32,
    bottom: f32,
    right: f32,
}

impl Sheet<'_> {
    fn text(&mut self, at: [f32; 2], align: [Align; 2], text: &str, font: Font, size: f32, color: Color) {
        self.shapes.push(Shape::Text { at, align, text: text.to_owned(), font, size, color });
    }

    pub(super) fn line(&mut self, points: Vec<[f32; 2]>, stroke: Stroke) {
        self.shapes.push(Shape::Line { points, closed: false, stroke });
    }

    /// Bare canvas under a name.
    fn plate(&mut self, [x, y]: [f32; 2], [width, height]: [f32; 2]) {
        let (min, max) = ([x - 3.0, y], [x + width + 3.0, y + height]);
        let fill = Some(self.theme.canvas.alpha(0.85));
        self.shapes.push(Shape::Rect { min, max, radius: 2.0, fill, stroke: None });
    }

    /// Lines of text below what is there.
    fn head(&mut self, text: &str, font: Font, size: f32, color: Color) {
        for line in wrapped(text, font, size, self.right - INSET) {
            self.text([INSET, self.top], [Align::Min; 2], &line, font, size, color);
            self.top += text::measure(font, size, &line)[1] + 1.0;
        }
    }

    /// Lines of text above what is at the foot.
    fn foot(&mut self, text: &str, size: f32, color: Color) {
        for line in wrapped(text, Font::Sans, size, self.right - INSET).iter().rev() {
            self.text([INSET, self.bottom], [Align::Min, Align::Max], line, Font::Sans, size, color);
            self.bottom -= text::measure(Font::Sans, size, line)[1];
        }
    }

    /// What the markers mean, in as many lines as it takes.
    fn key(&mut self, plot: &Plot) {
        let (theme, size) = (self.theme, self.theme.sizes.label);
        let entries = plot.series.iter().map(|series| (Some(series), series.name.as_str()));
        let entries: Vec<_> = entries.chain(plot.frontier.iter().map(|name| (None, name.as_str()))).collect();
        if entries.len() < 2 {
            return;
        }
        let height = text::measure(Font::Sans, size, "0")[1] + 3.0;
        let mut lines: Vec<Vec<(f32, _, &str)>> = vec![Vec::new()];
        let mut left = INSET;
        for (series, name) in entries {
            let sign = if series.is_some_and(|series| !series.joined) { 20.0 } else { 40.0 };
            let width = sign + text::measure(Font::Sans, size, name)[0] + 22.0;
            if left > INSET && left + width > self.right {
                lines.push(Vec::new());
                left = INSET;
            }
            if let Some(line) = lines.last_mut() {
                line.push((left, series, name));
            }
            left += width;
        }
        self.bottom -= lines.len() as f32 * height + 4.0;
        for (i, line) in lines.into_iter().enumerate() {
            let y = self.bottom + (i as f32 + 0.5) * height;
            for (x, series, name) in line {
                let joined = series.is_none_or(|series| series.joined);
                if joined {
                    let stroke = series.map_or(points::frontier_stroke(theme), |series| {
                        let style = theme.style(series.role);
                        Stroke {
                            color: style.color,
                            width: style.width.min(2.5),
                            dash: style.dash,
                            phase: 0.0,
                        }
                    });
                    self.line(vec![[x, y], [x + 32.0, y]], stroke);
                }
                if let Some(series) = series {
                    self.shapes.extend(mark(series.role, [x + if joined { 16.0 } else { 7.0 }, y], theme));
                }
                let x = x + if joined { 39.0 } else { 19.0 };
                self.text([x, y], [Align::Min, Align::Center], name, Font::Sans, size, theme.text);
            }
        }
        self.bottom -= 8.0;
    }

    /// Lanes, lines and texts of both axes.
    fn grid(&mut self, plot: &Plot, [x, up]: [&Ruler; 2], [x_ticks, up_ticks]: [&[Tick]; 2], area: Rect) {
        let (theme, size) = (self.theme, self.theme.sizes.label);
        let [left, top] = area.min.map(|c| c as f32);
        let [right, bottom] = area.max.map(|c| c as f32);
        let band = |sheet: &mut Self, min: [f32; 2], max: [f32; 2]| {
            let fill = Some(theme.panel);
            sheet.shapes.push(Shape::Rect { min, max, radius: 0.0, fill, stroke: None });
        };
        let [x_begin, x_end] = x.ends();
        for (lane, ends) in [(x.zero, [left, x_begin]), (x.infinite, [x_end, right])] {
            if lane.is_some() {
                band(self, [ends[0], top], [ends[1], bottom]);
            }
        }
        let [up_begin, up_end] = up.ends();
        for (lane, ends) in [(up.zero, [up_begin, bottom]), (up.infinite, [top, up_end])] {
            if lane.is_some() {
                band(self, [left, ends[0]], [right, ends[1]]);
            }
        }
        let stroke = |named: bool| Stroke::solid(if named { theme.grid_major } else { theme.grid }, 1.0);
        let named = !matches!(plot.axes[0].scale, Scale::Names(_));
        for Tick { at, text } in x_ticks.iter().filter(|_| named) {
            self.line(vec![[*at, top], [*at, bottom]], stroke(!text.is_empty()));
        }
        for Tick { at, text } in up_ticks {
            self.line(vec![[left, *at], [right, *at]], stroke(!text.is_empty()));
        }
        for ends in [[[left, top], [left, bottom]], [[left, bottom], [right, bottom]]] {
            self.line(ends.to_vec(), Stroke::solid(theme.edge, 1.5));
        }
        let lane = |at: Option<f32>, text: &String| at.map(|at| Tick { at, text: text.clone() });
        let [across, along] = &plot.axes;
        let x_lanes = [lane(x.zero, &across.zero), lane(x.infinite, &across.infinite)];
        let mut taken: Vec<[f32; 2]> = Vec::new();
        // Lanes first: a number that has no room beside one is left out.
        for Tick { at, text } in x_lanes.into_iter().flatten().chain(x_ticks.iter().cloned()) {
            if text.is_empty() {
                continue;
            }
            let half = text::measure(Font::Sans, size, &text)[0] / 2.0;
            // A name at the edge stays on the sheet.
            let at = at.min(self.right + INSET - 4.0 - half).max(half + 4.0);
            let ends = [at - half - 4.0, at + half + 4.0];
            if taken.iter().all(|other| ends[1] <= other[0] || other[1] <= ends[0]) {
                taken.push(ends);
                self.text(
                    [at, bottom + GAP],
                    [Align::Center, Align::Min],
                    &text,
                    Font::Sans,
                    size,
                    theme.dim,
                );
            }
        }
        let up_lanes = [lane(up.zero, &along.zero), lane(up.infinite, &along.infinite)];
        for Tick { at, text } in up_ticks.iter().cloned().chain(up_lanes.into_iter().flatten()) {
            self.text([left - GAP, at], [Align::Max, Align::Center], &text, Font::Sans, size, theme.dim);
        }
    }

    /// What lies under the point that stands out.
    fn halo(&mut self, center: [f32; 2]) {
        let theme = self.theme;
        let (fill, ink, width) = if theme.name == ThemeName::Dark {
            (theme.canvas, theme.style(Role::Active).color, 3.0)
        } else {
            (theme.lit, theme.text, 2.0 + theme.extra_stroke)
        };
        let stroke = Some(Stroke::solid(ink, width));
        self.shapes.push(Shape::Circle {
            center,
            radius: 12.0 + theme.extra_stroke,
            fill: Some(fill),
            stroke,
        });
    }
}

/// Text in lines of at most that width, broken at spaces.
fn wrapped(text: &str, font: Font, size: f32, width: f32) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ').filter(|word| !word.is_empty()) {
        match lines.last_mut() {
            Some(line) if text::measure(font, size, &format!("{line} {word}"))[0] <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}
