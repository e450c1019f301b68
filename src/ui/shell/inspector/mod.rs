//! The inspector: what just happened, the pseudocode, every value, the chosen pixel.

mod difference;
mod exact;
mod listing;
mod pixel;
mod report;
mod step;
mod table;

use crate::{
    document::{Tab, ViewState},
    face::{Command, Face},
    overview::History,
    run::Shown,
    shell::{Frame, split::chooser},
    theme::Text,
    widgets::{focus_ring, follow_focus, rule},
};
use egui::{Align2, Rect, Role as Part, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2};
use rasterscope_core::{
    compare::{Pair, Side},
    explain::{Operations, PixelReport},
};
use rasterscope_figure::{
    numbers,
    tables::{self, Run as Piece, TextTable},
    words::Words,
};

/// Most rows of a table; of longer ones those round the current one are shown.
const MOST_ROWS: usize = 200;

/// A step in words and numbers; made anew only when the step changes.
#[derive(Clone, Debug)]
pub(crate) struct Digest {
    rev: u64,
    sentence: Vec<Piece>,
    formulas: Vec<[Vec<Piece>; 2]>,
    tables: Vec<TextTable>,
}

impl Digest {
    /// Brings `kept` up to date with what is shown.
    pub(crate) fn update<'a>(
        kept: &'a mut Option<Self>,
        shown: Option<&Shown>,
        words: &Words,
    ) -> Option<&'a Self> {
        let Some(shown) = shown else {
            *kept = None;
            return None;
        };
        if kept.as_ref().is_none_or(|old| old.rev != shown.rev) {
            *kept = Some(Self {
                rev: shown.rev,
                sentence: words.runs(&shown.sentence),
                formulas: shown.formulas.iter().map(|formula| tables::formula(formula, words)).collect(),
                tables: tables::format(&shown.tables, &shown.before, words),
            });
        }
        kept.as_ref()
    }

    /// The values of the step.
    pub(crate) fn tables(&self) -> &[TextTable] {
        &self.tables
    }
}

/// Tables as comma-separated lines, every digit of every number.
pub(crate) fn csv(tables: &[TextTable]) -> String {
    let field = |text: &str| {
        let plain = text.replace(numbers::MINUS, "-");
        if plain.contains([',', '"', '\n']) { format!("\"{}\"", plain.replace('"', "\"\"")) } else { plain }
    };
    let mut out = String::new();
    let mut line = |cells: &mut dyn Iterator<Item = &str>| {
        out.push_str(&cells.map(field).collect::<Vec<_>>().join(","));
        out.push('\n');
    };
    for table in tables.iter().filter(|table| !table.rows.is_empty()) {
        line(&mut std::iter::once(&table.title).chain(&table.columns).map(String::as_str));
        for row in &table.rows {
            let cells = row.cells.iter().map(|cell| &cell.text);
            line(&mut std::iter::once(&row.name).chain(cells).map(String::as_str));
        }
    }
    out
}

/// What the inspector says of the whole scene, where the whole scene is open.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Whole<'a> {
    pub(crate) history: Option<&'a History>,
    pub(crate) stages: Option<&'a TextTable>,
    /// Whether the lab decides about pixels, and what it says of the chosen one.
    pub(crate) decides: bool,
    pub(crate) report: Option<&'a ([u32; 2], PixelReport)>,
    /// Both runs, where there are two, what each costs, and the side that is explained.
    pub(crate) pair: Option<&'a Pair>,
    pub(crate) costs: [Operations; 2],
    pub(crate) side: Side,
}

/// Shows the inspector.
pub(crate) fn show(
    ui: &mut Ui,
    face: &Face<'_>,
    frame: &Frame<'_>,
    shown: Option<&Shown>,
    digest: Option<&Digest>,
    whole: Whole<'_>,
    view: &mut ViewState,
) {
    let rect = ui.max_rect();
    let height = if face.look.projector() { 44.0 } else { 36.0 };
    let pixels = whole.stages.is_some() || whole.decides;
    if view.tab == Tab::Pixel && !pixels {
        view.tab = Tab::Step;
    }
    let head = rect.with_max_y(rect.top() + height);
    let split = frame.compare.as_ref();
    if split.is_some() && !SPLIT_TABS.iter().any(|(tab, _)| *tab == view.tab) {
        view.tab = Tab::Difference;
    }
    tabs(
        ui,
        face,
        head,
        view,
        if split.is_some() { &SPLIT_TABS } else { &TABS[..if pixels { 4 } else { 3 }] },
    );
    rule(ui, head, face.look);
    let body = UiBuilder::new().max_rect(rect.with_min_y(head.bottom() + 1.0));
    ui.scope_builder(body, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.style_mut().interaction.selectable_labels = true;
        if let (Tab::Step, Some(shown), Some(digest)) = (view.tab, shown, digest) {
            if let Some(sides) = split.filter(|_| whole.pair.is_some()) {
                chooser(ui, face, sides, whole.side);
            }
            return step::show(ui, face, shown, digest);
        }
        ScrollArea::vertical().id_salt(view.tab as usize).auto_shrink(false).show(ui, |ui| {
            ui.set_width(ui.available_width());
            if let Some(sides) = split.filter(|_| view.tab != Tab::Difference && whole.pair.is_some()) {
                chooser(ui, face, sides, whole.side);
            }
            match (view.tab, shown, digest) {
                (Tab::Difference, ..) => match (split, whole.pair) {
                    (Some(sides), Some(pair)) => difference::show(ui, face, sides, (pair, whole.costs), view),
                    _ => empty(ui, face, frame, None),
                },
                (Tab::Pixel, ..) if whole.decides => report::show(ui, face, whole.report),
                (Tab::Pixel, ..) => pixel::show(ui, face, whole.history),
                (_, None, _) | (_, _, None) | (Tab::Step, ..) => empty(ui, face, frame, whole.stages),
                (Tab::Listing, Some(shown), _) => listing::show(ui, face, shown),
                (Tab::Values, _, Some(digest)) => {
                    inset(ui, |ui| {
                        ui.add_space(8.0);
                        if ui.button(face.say("ui-copy-values")).clicked() {
                            face.ask(Command::CopyValues);
                        }
                    });
                    for (i, one) in digest.tables.iter().enumerate() {
                        table::show(ui, face, one, Some(MOST_ROWS), i == 0);
                    }
                    if let Some(stages) = whole.stages {
                        table::show(ui, face, stages, None, false);
                    }
                }
            }
            follow_focus(ui);
        });
    });
}

/// The tabs; only what decides about pixels has the last.
const TABS: [(Tab, &str); 4] = [
    (Tab::Step, "ui-tab-step"),
    (Tab::Listing, "ui-tab-listing"),
    (Tab::Values, "ui-tab-values"),
    (Tab::Pixel, "ui-tab-pixel"),
];

/// The tabs where two sides are shown: the step has the listing too.
const SPLIT_TABS: [(Tab, &str); 3] =
    [(Tab::Difference, "ui-tab-difference"), (Tab::Step, "ui-tab-step"), (Tab::Values, "ui-tab-values")];

fn tabs(ui: &mut Ui, face: &Face<'_>, rect: Rect, view: &mut ViewState, all: &[(Tab, &'static str)]) {
    let width = rect.width() / all.len() as f32;
    for (i, &(tab, id)) in all.iter().enumerate() {
        let at = Rect::from_min_size(rect.min + vec2(i as f32 * width, 0.0), vec2(width, rect.height()));
        let response = ui.interact(at, ui.scope_id().with(id), Sense::click());
        let (chosen, name) = (view.tab == tab, face.say(id));
        response.widget_info(|| WidgetInfo::selected(Part::Tab, true, chosen, &name));
        if response.hovered() && !chosen {
            ui.painter().rect_filled(at, 0, face.look.field);
        }
        let (style, color) =
            if chosen { (Text::Strong, face.look.text) } else { (Text::Body, face.look.dim) };
        ui.painter().text(at.center(), Align2::CENTER_CENTER, name, face.look.font(style), color);
        if chosen {
            let foot = Rect::from_min_max(pos2(at.left(), at.bottom() - 3.0), at.max);
            ui.painter().rect_filled(foot, 0, face.look.text);
        }
        focus_ring(ui, &response, at.shrink(1.0), face.look);
        if face.explain(response, id).clicked() {
            view.tab = tab;
        }
    }
}

/// What would stand here, and why it does not.
fn empty(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, stages: Option<&TextTable>) {
    inset(ui, |ui| {
        ui.add_space(14.0);
        // The whole scene says more than that there is nothing to step.
        let note = if frame.note.is_empty() { &frame.about } else { &frame.note };
        let note = Some(note).filter(|_| stages.is_some());
        match (note, &frame.problem) {
            (Some(text), _) => ui.label(face.rich(text, Text::Sentence)),
            (None, Some(text)) => ui.label(face.dim(text, Text::Sentence)),
            (None, None) => ui.label(face.dim(face.say("ui-inspector-empty"), Text::Sentence)),
        };
        ui.add_space(12.0);
    });
    if let Some(stages) = stages {
        part_line(ui, face);
        table::show(ui, face, stages, None, false);
    }
}

/// Content 16 points from both edges; rows that are lit reach the edges and inset themselves.
fn inset(ui: &mut Ui, content: impl FnOnce(&mut Ui)) {
    egui::Frame::NONE.inner_margin(egui::Margin::symmetric(16, 0)).show(ui, |ui| {
        ui.set_width(ui.available_width());
        content(ui);
    });
}

/// A line between two parts.
fn part_line(ui: &mut Ui, face: &Face<'_>) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 1.0), Sense::hover());
    rule(ui, rect, face.look);
}
