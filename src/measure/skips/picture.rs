//! What each skip leaves out, as stacked bars.

use rasterscope_core::{
    explain::Role,
    pipeline::{Skip, Stats, Work},
    scene::Scene,
};
use rasterscope_figure::{
    figure::{Align, Figure, Font, Shape, Stroke},
    markers, numbers,
    theme::{Color, Theme},
    words::Words,
};

use super::{Saving, Savings};

/// One bar.
#[derive(Clone, Copy, Debug)]
pub struct Bar {
    /// Whose.
    pub skip: Skip,
    /// What is done and left out.
    pub work: Work,
    /// How many times longer a frame takes without it, and whether its bytes stay; `None`: not measured.
    pub measured: Option<(f64, bool)>,
}

impl From<Saving> for Bar {
    fn from(saving: Saving) -> Self {
        Self { skip: saving.skip, work: saving.work, measured: Some((saving.ratio, saving.same)) }
    }
}

/// The bars of a measurement, or of what one image of a scene counted.
pub fn bars(savings: Option<&Savings>, stats: &Stats, scene: &Scene) -> Vec<Bar> {
    if let Some(savings) = savings {
        return savings.savings().map(Bar::from).collect();
    }
    let pixels = scene.size.iter().map(|side| u64::from(*side)).product();
    let bar = |skip| Bar { skip, work: stats.work(skip, pixels, scene.draws.len() as u64), measured: None };
    Skip::ALL.into_iter().map(bar).collect()
}

/// Message id of a skip's name for people.
pub fn word(skip: Skip) -> &'static str {
    match skip {
        Skip::ObjectFrustum => "measure-skip-object-frustum",
        Skip::Frustum => "measure-skip-frustum",
        Skip::BackFace => "measure-skip-back-face",
        Skip::Degenerate => "measure-skip-degenerate",
        Skip::Tile => "measure-skip-tile",
        Skip::Row => "measure-skip-row",
        Skip::EarlyZ => "measure-skip-early-z",
        Skip::HierarchicalZ => "measure-skip-hierarchical-z",
        Skip::Deferred => "measure-skip-deferred",
        Skip::Clear => "measure-skip-clear",
        Skip::Memo => "measure-skip-memo",
    }
}

/// Room for the names, the times and the marks, in ems of a label.
const NAMES: f32 = 11.0;
const TIMES: f32 = 6.5;
const SAME: f32 = 6.5;
/// Distance from the sides, in points.
const INSET: f32 = 14.0;

/// Draws the bars below each other, as wide as there is room and as high as they need.
pub fn draw(bars: &[Bar], width: f32, theme: &Theme, words: &Words) -> Figure {
    let em = theme.sizes.label;
    let line = em * 1.45;
    let (head, row) = (line + 8.0, 2.0 * line + 4.0);
    let mut sketch = Sketch { theme, em, shapes: Vec::new() };
    let same = width - INSET;
    let times = same - SAME * em;
    let [from, to] = [INSET + NAMES * em, times - TIMES * em];
    let head_y = head / 2.0;
    sketch.text([INSET, head_y], Align::Min, words.word("measure-skips-skip"), Font::Sans, theme.dim);
    sketch.text([from, head_y], Align::Min, words.word("measure-skips-work"), Font::Sans, theme.dim);
    sketch.text([times, head_y], Align::Max, words.word("measure-skips-time"), Font::Sans, theme.dim);
    sketch.text([same, head_y], Align::Max, words.word("measure-skips-same"), Font::Sans, theme.dim);
    for (i, bar) in bars.iter().enumerate() {
        let y = head + row * i as f32 + line / 2.0;
        let Work { done, left_out, unit } = bar.work;
        let number = |n: u64| numbers::integer(i64::try_from(n).unwrap_or(i64::MAX));
        let counts = match done {
            Some(done) => format!("{} / {} {}", number(left_out), number(done + left_out), words.word(unit)),
            None => format!("{} {}", number(left_out), words.word(unit)),
        };
        sketch.text([INSET, y], Align::Min, words.word(word(bar.skip)), Font::SansBold, theme.text);
        sketch.text([from, y], Align::Min, counts, Font::Sans, theme.text);
        if let Some(done) = done {
            sketch.bar([from, to], y + line * 0.85, done, left_out);
        }
        let Some((ratio, is_same)) = bar.measured else { continue };
        sketch.text([times, y], Align::Max, format!("× {ratio:.2}"), Font::Mono, theme.text);
        sketch.sign([same - em / 2.0, y], if is_same { Role::Accepted } else { Role::Rejected });
    }
    let height = head + row * bars.len() as f32 + 8.0;
    Figure { size: [width, height], background: theme.canvas, shapes: sketch.shapes }
}

struct Sketch<'t> {
    theme: &'t Theme,
    em: f32,
    shapes: Vec<Shape>,
}

impl Sketch<'_> {
    fn text(&mut self, at: [f32; 2], align: Align, text: String, font: Font, color: Color) {
        let align = [align, Align::Center];
        self.shapes.push(Shape::Text { at, align, text, font, size: self.em, color });
    }

    /// What is done is filled, what is left out only outlined.
    fn bar(&mut self, [from, to]: [f32; 2], y: f32, done: u64, left_out: u64) {
        let share = if done + left_out == 0 { 0.0 } else { done as f32 / (done + left_out) as f32 };
        let [top, foot] = [y - self.em * 0.28, y + self.em * 0.28].map(f32::round);
        let rect = |min: f32, max: f32, fill, stroke| Shape::Rect {
            min: [min.round(), top],
            max: [max.round(), foot],
            radius: 0.0,
            fill,
            stroke,
        };
        let theme = self.theme;
        let outline = Stroke::solid(theme.edge, 1.0 + theme.extra_stroke * 0.5);
        self.shapes.push(rect(from, to, Some(theme.raised.alpha(0.5)), Some(outline)));
        if share > 0.0 {
            let end = from + (to - from) * share;
            self.shapes.push(rect(from, end, Some(theme.dim), Some(outline)));
        }
    }

    fn sign(&mut self, at: [f32; 2], role: Role) {
        let style = self.theme.style(role);
        let ground = self.theme.canvas;
        self.shapes.extend(markers::marker(style.marker, at, self.em / 2.0, style.color, ground));
    }
}
