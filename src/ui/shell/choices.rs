//! The choices: what is open and why it matters, presets, conventions, numbers.

use crate::{
    document::{Snap, ViewState},
    face::{Command, Face},
    labs::Open,
    presets::PresetInfo,
    shell::{Frame, algorithm, lectures},
    theme::{Text, small_mono},
    widgets::{down, follow_focus, heading, row, text_in},
};
use egui::{Align2, ComboBox, DragValue, Rect, ScrollArea, Ui, pos2, vec2};
use rasterscope_core::{explain::Role, message::Value};
use rasterscope_figure::numbers;

/// The presets get at most this part of the height, and scroll by themselves.
const PRESETS: f32 = 0.42;

/// Shows the choices of a lab and edits the document.
///
/// Presets and conventions scroll one below the other, never one in the other.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, open: &mut Open<'_>) {
    let whole = ui.available_height();
    algorithm::show(ui, face, frame);
    ui.label(face.dim(&frame.about, Text::Label));
    lectures::show(ui, face, frame.lab);
    presets(ui, face, frame, whole * PRESETS);
    ScrollArea::vertical().id_salt("conventions").auto_shrink(false).show(ui, |ui| {
        ui.set_width(ui.available_width());
        open.lab.controls(ui, face, open.document, open.view);
        follow_focus(ui);
    });
}

fn presets(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, most: f32) {
    let mine: Vec<_> = frame.presets.iter().filter(|preset| preset.lab == frame.lab).collect();
    if mine.is_empty() {
        return;
    }
    heading(ui, face, &face.say("ui-presets"));
    let height = face.look.row_height();
    // Half a row at the foot says that there are more.
    let rows = if height * mine.len() as f32 <= most {
        mine.len() as f32
    } else {
        ((most / height) - 0.5).floor().max(2.0) + 0.5
    };
    let list = ScrollArea::vertical().id_salt("presets").max_height(height * rows);
    list.auto_shrink([false, true]).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        for one in mine {
            preset(ui, face, one, frame.preset == Some(one.name));
        }
        follow_focus(ui);
    });
}

fn preset(ui: &mut Ui, face: &Face<'_>, preset: &PresetInfo, chosen: bool) {
    let response = row(ui, face, face.look.row_height(), &preset.title, chosen, |ui, rect| {
        if chosen {
            ui.painter().rect_filled(rect, 0, face.look.raised);
            ui.painter().rect_filled(
                Rect::from_min_size(rect.min, vec2(4.0, rect.height())),
                0,
                face.look.text,
            );
        }
        let font = face.look.font(if chosen { Text::LabelStrong } else { Text::Label });
        let color = if chosen { face.look.text } else { face.look.dim };
        let room = rect.with_min_x(rect.left() + 9.0);
        text_in(ui.painter(), room, Align2::LEFT_CENTER, &preset.title, font, color);
    });
    if response.on_hover_text(&preset.note).clicked() {
        face.ask(Command::Preset(preset.name));
    }
}

/// A label and a combo: one convention.
pub(crate) fn choose<T: Copy + PartialEq>(
    ui: &mut Ui,
    face: &Face<'_>,
    label: &'static str,
    value: &mut T,
    all: &[(T, String)],
) {
    let before = *value;
    let selected = all.iter().find(|(each, _)| *each == before).map_or("", |(_, name)| name);
    let term = label;
    let label = face.say(term);
    let row = labelled(ui, face, &label, |ui, width| {
        let measure = |text| {
            let font = face.look.font(text);
            ui.painter().layout_no_wrap(selected.to_owned(), font, face.look.text).size().x
        };
        // Beside the words: the padding and the sign.
        let room = width - 2.0 * ui.spacing().button_padding.x - ui.spacing().icon_width - 4.0;
        let style = if measure(Text::Label) <= room { Text::Label } else { Text::Small };
        let cut = measure(style) > room;
        let combo = ComboBox::from_id_salt(&label)
            .width(width)
            .truncate()
            .icon(down)
            .selected_text(face.rich(selected, style))
            .show_ui(ui, |ui| {
                for (each, name) in all {
                    ui.selectable_value(value, *each, name);
                }
            });
        combo.response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, &label));
        if cut {
            combo.response.on_hover_text(selected);
        }
    });
    face.explain(row, term);
}

/// A label in its column, and something beside it.
///
/// The response is the label's.
pub(crate) fn labelled(
    ui: &mut Ui,
    face: &Face<'_>,
    label: &str,
    content: impl FnOnce(&mut Ui, f32),
) -> egui::Response {
    let row = ui.horizontal(|ui| {
        let wide = if face.look.projector() { 100.0 } else { 76.0 };
        let (rect, response) =
            ui.allocate_exact_size(vec2(wide, face.look.button_height()), egui::Sense::hover());
        text_in(ui.painter(), rect, Align2::LEFT_CENTER, label, face.look.font(Text::Label), face.look.text);
        let room = ui.available_width();
        content(ui, room);
        response
    });
    row.inner
}

/// A check box.
pub(crate) fn check(ui: &mut Ui, face: &Face<'_>, label: &'static str, value: &mut bool) {
    ui.checkbox(value, face.rich(face.say(label), Text::Label));
}

/// A common mistake that can be switched on, with what it breaks below.
pub(crate) fn mistake(ui: &mut Ui, face: &Face<'_>, [label, effect]: [&'static str; 2], value: &mut bool) {
    check(ui, face, label, value);
    let effect = face.rich(face.say(effect), Text::Label).color(face.look.role(Role::Rejected));
    ui.indent(label, |ui| ui.label(effect));
}

/// An index that can be typed or dragged.
pub(crate) fn index(ui: &mut Ui, face: &Face<'_>, label: &'static str, value: &mut usize) {
    let label = face.say(label);
    labelled(ui, face, &label, |ui, width| {
        let drag = DragValue::new(value).speed(0.1).update_while_editing(false);
        ui.add_sized(vec2(width, face.look.button_height()), drag).accessible_name(&label);
    });
}

/// Where dragged points snap to.
pub(crate) fn snapping(ui: &mut Ui, face: &Face<'_>, view: &mut ViewState) {
    let all = Snap::ALL.map(|snap| {
        let name = match snap {
            Snap::Half => "ui-snap-half",
            Snap::Centre => "ui-snap-centre",
            Snap::Off => "ui-snap-off",
        };
        (snap, face.say(name))
    });
    choose(ui, face, "ui-snap", &mut view.snap, &all);
}

/// A row of numbers that can be typed or dragged; `names` are their accessible names.
pub(crate) fn fields<const N: usize>(ui: &mut Ui, face: &Face<'_>, label: &str, values: [&mut f32; N]) {
    ui.horizontal(|ui| {
        let many = N > 2;
        ui.spacing_mut().item_spacing.x = if many { 3.0 } else { 6.0 };
        if many {
            ui.spacing_mut().button_padding.x = 3.0;
            ui.style_mut().drag_value_text_style = small_mono();
        }
        let least = match (face.look.projector(), many) {
            (true, _) => 44.0,
            (false, true) => 24.0,
            (false, false) => 34.0,
        };
        let font = face.look.font(if many { Text::SmallMono } else { Text::Mono });
        let text = ui.painter().layout_no_wrap(label.to_owned(), font.clone(), face.look.text).size().x;
        // Words have one width, so that the numbers below each other line up.
        let words = if face.look.projector() { 48.0 } else { 38.0 };
        let wide = if text > least { text.max(words) } else { least };
        let (rect, _) = ui.allocate_exact_size(vec2(wide, face.look.button_height()), egui::Sense::hover());
        text_in(ui.painter(), rect, Align2::LEFT_CENTER, label, font, face.look.text);
        let gap = ui.spacing().item_spacing.x;
        let width = (ui.available_width() - gap * (N as f32 - 1.0)) / N as f32;
        for (value, axis) in values.into_iter().zip(["x", "y", "z", "w"]) {
            let name = format!("{label} {axis}");
            number(ui, face, width, &name, value);
        }
    });
}

/// One number that can be typed or dragged.
pub(crate) fn number(ui: &mut Ui, face: &Face<'_>, width: f32, name: &str, value: &mut f32) {
    let before = *value;
    let drag = DragValue::new(value)
        .speed(0.05)
        .update_while_editing(false)
        .range(f32::MIN..=f32::MAX)
        .custom_formatter(|x, _| numbers::short(&Value::F64(x)))
        .custom_parser(|text| text.trim().replace('−', "-").replace(',', ".").parse().ok());
    let (rect, _) = ui.allocate_exact_size(vec2(width, face.look.button_height()), egui::Sense::hover());
    let response = ui.place(Rect::from_min_size(pos2(rect.left(), rect.top()), rect.size()), drag);
    response.accessible_name(name);
    if !value.is_finite() {
        *value = before;
    }
    *value += 0.0; // no negative zero
}
