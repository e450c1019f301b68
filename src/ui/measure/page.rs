//! A page laid out: the strip with the pages, the diagram, and what stands beside it.

use super::{Measure, Page, Scope, side};
use crate::{
    face::{Command, Face},
    paint::{self, Textures},
    theme::Text,
    widgets::wear,
};
use egui::{
    Align2, CentralPanel, Color32, Frame, Margin, Panel, Rect, Role as Part, Sense, Ui, UiBuilder,
    WidgetInfo, pos2, vec2,
};
use rasterscope_core::message::{Message, Value};
use rasterscope_figure::numbers;
use rasterscope_measure::pictures;

/// A point nearer to the pointer than this is meant.
const NEAR: f32 = 14.0;

/// Shows the open page.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure, textures: &mut Textures, now: f64) {
    let look = face.look;
    let plain = |fill: Color32| Frame::NONE.fill(fill).inner_margin(Margin::ZERO);
    let narrow = ui.max_rect().width() < crate::shell::NARROW;
    Panel::top("pages")
        .exact_size(44.0)
        .resizable(false)
        .frame(plain(look.panel))
        .show(ui, |ui| pages(ui, face, measure.shown.page));
    let width = match (narrow, look.projector()) {
        (_, true) => 400.0,
        (true, false) => 370.0,
        (false, false) => 410.0,
    };
    let mut pointed = None;
    Panel::right("results")
        .exact_size(width)
        .resizable(false)
        .frame(Frame::NONE.fill(look.panel).inner_margin(Margin::symmetric(14, 12)))
        .show(ui, |ui| pointed = side::show(ui, face, measure, now));
    CentralPanel::default()
        .frame(plain(look.canvas))
        .show(ui, |ui| diagram(ui, face, measure, textures, pointed));
}

/// The names of the pages, and the way back.
fn pages(ui: &mut Ui, face: &Face<'_>, current: Page) {
    let rect = ui.max_rect();
    let mut x = rect.left() + 12.0;
    for page in Page::ALL {
        let text = face.say(page.word());
        let at = button(ui, face, &text, pos2(x, rect.center().y), Align2::LEFT_CENTER, page == current);
        if at.clicked() {
            face.ask(Command::Measure(page));
        }
        x = at.rect.right() + 8.0;
    }
    let text = face.say("measure-leave");
    let right = pos2(rect.right() - 12.0, rect.center().y);
    if button(ui, face, &text, right, Align2::RIGHT_CENTER, false).clicked() {
        face.ask(Command::LeaveMeasure);
    }
}

fn button(ui: &Ui, face: &Face<'_>, text: &str, at: egui::Pos2, align: Align2, on: bool) -> egui::Response {
    let font = face.look.font(if on { Text::Strong } else { Text::Body });
    let galley = ui.painter().layout_no_wrap(text.to_owned(), font, face.look.text);
    let size = vec2(galley.size().x + 24.0, face.look.button_height() + 2.0);
    let rect = align.anchor_size(at, size);
    let response = ui.interact(rect, ui.scope_id().with(text), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Part::Button, true, on, text));
    wear(ui, &response, rect, on, face.look);
    ui.painter().galley(rect.center() - galley.size() / 2.0, galley, face.look.text);
    response
}

/// The diagram, or that there is none yet; `pointed` is the point of the table's row under the pointer.
fn diagram(
    ui: &mut Ui,
    face: &Face<'_>,
    measure: &mut Measure,
    textures: &mut Textures,
    pointed: Option<[usize; 2]>,
) {
    let rect = ui.max_rect();
    let size = [rect.width(), rect.height()];
    let theme = face.look.theme.name;
    let Some(drawn) = measure.drawn(size, theme, face.words) else {
        return nothing(ui, face, measure, rect);
    };
    let response = ui.interact(rect, ui.scope_id().with("diagram"), Sense::click());
    let name = measure.chart(face.words).map_or(String::new(), |chart| chart.plot.title.clone());
    response.widget_info(|| WidgetInfo::labeled(Part::Image, true, &name));
    measure.hovered = pointed;
    if let Some(pointer) = response.hover_pos() {
        let distance = |at: [f32; 2]| (rect.min + vec2(at[0], at[1])).distance(pointer);
        let nearest = drawn.spots.iter().min_by(|a, b| distance(a.at).total_cmp(&distance(b.at)));
        let hovered = nearest.filter(|spot| distance(spot.at) < NEAR).map(|spot| spot.point);
        measure.hovered = hovered;
        if response.clicked() {
            measure.chosen = hovered;
        }
    }
    let Some(drawn) = measure.drawn(size, theme, face.words) else { return };
    paint::figure(ui.painter(), textures, rect.min, &drawn.figure);
    if let Some(text) =
        measure.hovered.filter(|_| response.hovered()).and_then(|point| about(measure, point, face))
    {
        response.on_hover_text_at_pointer(text);
    }
}

/// What a point says of itself.
fn about(measure: &mut Measure, point: [usize; 2], face: &Face<'_>) -> Option<String> {
    let words = face.words;
    let chart = measure.chart(words)?;
    let series = chart.plot.series.get(point[0])?;
    let at = series.points.get(point[1])?.at;
    if measure.shown.page != Page::Errors {
        let [x, y] = [0, 1].map(|axis| &chart.plot.axes[axis].title);
        let value = |value: f64| numbers::measured(value);
        return Some(format!("{}\n{x}: {}\n{y}: {}", series.name, value(at[0]), value(at[1])));
    }
    let error = &chart.plot.axes[0].title;
    let row = measure.row(point, words)?;
    let word = |kind: &str, name: &str| words.word(&format!("bench-{kind}-{name}"));
    let message = Message::new("measure-point")
        .with("algorithm", Value::text(pictures::algorithm(row.algorithm, words)))
        .with("arithmetic", Value::Word(row.arithmetic.word()))
        .with("family", Value::text(word("family", row.family.name())))
        .with("ns", Value::text(numbers::measured(row.ns)))
        .with("item", Value::text(word("item", row.item)))
        .with("error", Value::text(numbers::measured(at[0])))
        .with("what", Value::text(error));
    Some(words.message(&message))
}

/// Nothing was measured yet: what would be seen, and a button.
fn nothing(ui: &mut Ui, face: &Face<'_>, measure: &Measure, rect: Rect) {
    let room = Rect::from_center_size(rect.center(), vec2(rect.width().min(520.0) - 32.0, 160.0));
    ui.scope_builder(UiBuilder::new().max_rect(room), |ui| {
        ui.vertical_centered(|ui| {
            ui.label(face.dim(face.say("measure-nothing"), Text::Sentence));
            ui.add_space(10.0);
            let busy = measure.is_busy();
            let start = egui::Button::new(face.rich(face.say("measure-start"), Text::Body));
            if ui.add_enabled(!busy, start).clicked() {
                face.ask(Command::StartMeasuring(Scope::Shown));
            }
        });
    });
}
