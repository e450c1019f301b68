//! The menu bar: menus, undo and redo, what is open, theme.

use crate::{
    face::{Command, Face},
    measure::Page,
    shell::Frame,
    theme::Text,
    widgets::{Icon, State, icon_button, text_in},
};
use egui::{
    Align2, Button, MenuBar, Rect, RichText, Sense, Style, Ui, WidgetInfo, containers::menu::menu_style,
    pos2, vec2,
};
use rasterscope_core::message::Value;
use rasterscope_figure::theme::ThemeName;

/// What the palette has beside the keys.
pub(crate) const WITHOUT_KEY: [(&str, Command); 5] = [
    ("measure-skips-ask", Command::MeasureSkips),
    ("ui-file-reset", Command::Reset),
    ("ui-copy-values", Command::CopyValues),
    ("ui-help-hints", Command::Hints),
    ("ui-view-still", Command::Still),
];

/// Shows the menu bar.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>) {
    let bar = ui.max_rect();
    let ring = face.look.focus_stroke();
    let style = move |style: &mut Style| {
        menu_style(style);
        style.visuals.widgets.active.bg_stroke = ring;
    };
    let left = MenuBar::new()
        .style(style)
        .ui(ui, |ui| {
            ui.set_height(bar.height() - 2.0);
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.spacing_mut().button_padding = vec2(5.0, 2.0);
            ui.label(face.rich("Rasterscope", Text::Strong));
            ui.add_space(4.0);
            file(ui, face, frame);
            menu(ui, face, "ui-menu-edit", |ui| {
                item(ui, face, "ui-edit-undo", "Ctrl+Z", frame.can_undo, Command::Undo);
                item(ui, face, "ui-edit-redo", "Ctrl+Y", frame.can_redo, Command::Redo);
            });
            view(ui, face, frame);
            menu(ui, face, "measure-title", |ui| {
                for page in Page::ALL {
                    item(ui, face, page.word(), "", true, Command::Measure(page));
                }
            });
            menu(ui, face, "ui-menu-help", |ui| {
                item(ui, face, "ui-help-hints", "", true, Command::Hints);
                item(ui, face, "ui-palette", "Ctrl+K", true, Command::Palette);
                item(ui, face, "ui-help-keys", "F1", true, Command::Keys);
            });
            ui.add_space(4.0);
            for (icon, name, can, command) in [
                (Icon::Undo, "ui-edit-undo", frame.can_undo, Command::Undo),
                (Icon::Redo, "ui-edit-redo", frame.can_redo, Command::Redo),
            ] {
                let state = if can { State::Off } else { State::Disabled };
                if icon_button(ui, face, icon, vec2(26.0, 26.0), &face.say(name), state).clicked() {
                    face.ask(command);
                }
            }
            ui.cursor().left()
        })
        .inner;
    let right = buttons(ui, face, frame, bar);
    title(ui, face, frame, bar.with_min_x(left + 16.0).with_max_x(right - 16.0), bar);
}

fn menu(ui: &mut Ui, face: &Face<'_>, name: &'static str, content: impl FnOnce(&mut Ui)) {
    let text = face.dim(face.say(name), Text::Body);
    ui.menu_button(text, |ui| {
        ui.set_min_width(220.0);
        content(ui);
    });
}

fn item(ui: &mut Ui, face: &Face<'_>, name: &'static str, key: &str, enabled: bool, command: Command) {
    let button =
        Button::new(face.say(name)).shortcut_text(RichText::new(key).font(face.look.font(Text::Small)));
    if ui.add_enabled(enabled, button).clicked() {
        face.ask(command);
        ui.close();
    }
}

/// An entry that is on or off.
fn switch(ui: &mut Ui, face: &Face<'_>, name: &'static str, key: &str, on: bool, command: Command) {
    let mut now = on;
    let text = if key.is_empty() { face.say(name) } else { format!("{} ({key})", face.say(name)) };
    if ui.checkbox(&mut now, face.rich(text, Text::Label)).clicked() {
        face.ask(command);
        ui.close();
    }
}

fn file(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>) {
    menu(ui, face, "ui-menu-file", |ui| {
        item(ui, face, "ui-file-open", "Ctrl+O", true, Command::AskOpen);
        ui.menu_button(face.say("ui-file-presets"), |ui| {
            egui::ScrollArea::vertical().max_height(420.0).show(ui, |ui| {
                ui.set_min_width(240.0);
                for preset in frame.presets {
                    if ui.add(Button::new(&preset.title)).clicked() {
                        face.ask(Command::Preset(preset.name));
                        ui.close();
                    }
                }
            });
        });
        ui.separator();
        item(ui, face, "ui-file-save", "Ctrl+S", true, Command::Save);
        item(ui, face, "ui-file-save-as", "Ctrl+Shift+S", true, Command::AskSave);
        item(ui, face, "ui-file-reset", "", frame.modified, Command::Reset);
        ui.separator();
        item(ui, face, "ui-file-picture", "Ctrl+E", true, Command::AskPicture);
        item(ui, face, "ui-file-film", "Ctrl+Shift+E", true, Command::AskFilm);
        item(ui, face, "ui-copy-picture", "Ctrl+Shift+C", true, Command::CopyPicture);
        item(ui, face, "ui-copy-values", "", true, Command::CopyValues);
        ui.separator();
        item(ui, face, "ui-file-quit", "Ctrl+Q", true, Command::Quit);
    });
}

fn view(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>) {
    menu(ui, face, "ui-menu-view", |ui| {
        item(ui, face, "ui-compare", "C", true, Command::AskCompare);
        item(ui, face, "ui-split-leave", "Esc", frame.compare.is_some(), Command::Compare(None));
        ui.separator();
        ui.label(face.dim(face.say("ui-view-theme"), Text::LabelStrong));
        for theme in ThemeName::ALL {
            let chosen = theme == frame.theme;
            if ui.selectable_label(chosen, face.say(theme_message(theme))).clicked() {
                face.ask(Command::Theme(theme));
                ui.close();
            }
        }
        ui.separator();
        ui.label(face.dim(face.say("ui-view-text-size"), Text::LabelStrong));
        let percent = (ui.ctx().zoom_factor() * 100.0).round() as usize;
        ui.label(face.say_with("ui-text-percent", "percent", percent));
        item(ui, face, "ui-key-bigger", "Ctrl++", true, Command::Bigger);
        item(ui, face, "ui-key-smaller", "Ctrl+-", true, Command::Smaller);
        item(ui, face, "ui-key-normal", "Ctrl+0", true, Command::TextSize(1.0));
        ui.separator();
        switch(ui, face, "ui-view-exact", "F2", frame.aids.exact, Command::Exact);
        switch(ui, face, "ui-view-still", "", frame.aids.still, Command::Still);
    });
}

/// The message that names a theme.
pub(crate) fn theme_message(theme: ThemeName) -> &'static str {
    match theme {
        ThemeName::Dark => "ui-theme-dark",
        ThemeName::Light => "ui-theme-light",
        ThemeName::Projector => "ui-theme-projector",
    }
}

/// The words at the right; returns where they begin.
fn buttons(ui: &mut Ui, face: &Face<'_>, frame: &Frame<'_>, bar: Rect) -> f32 {
    let mut x = bar.right();
    let split = if frame.compare.is_some() { "ui-split-leave" } else { "ui-split-view" };
    let mut all = vec![("ui-menu-theme", Command::NextTheme), (split, Command::Split)];
    if frame.folded {
        all.push(("ui-menu-choices", Command::Choices));
    }
    for (name, command) in all {
        let text = face.say(name);
        let galley = ui.painter().layout_no_wrap(text.clone(), face.look.font(Text::Body), face.look.dim);
        let size = galley.size() + vec2(12.0, 6.0);
        let rect = Rect::from_center_size(pos2(x - size.x / 2.0 + 6.0, bar.center().y), size);
        let response = ui.interact(rect, ui.scope_id().with(name), Sense::click());
        response.widget_info(|| WidgetInfo::labeled(egui::Role::Button, true, &text));
        if response.hovered() || response.has_focus() {
            crate::widgets::wear(ui, &response, rect, false, face.look);
        }
        ui.painter().galley(rect.center() - galley.size() / 2.0, galley, face.look.dim);
        if response.clicked() {
            face.ask(command);
        }
        x = rect.left() - 10.0;
    }
    x
}

/// What is open, in the middle of the window if there is room.
fn title(ui: &Ui, face: &Face<'_>, frame: &Frame<'_>, room: Rect, bar: Rect) {
    let painter = ui.painter();
    let strong = painter.layout_no_wrap(frame.title.clone(), face.look.font(Text::Strong), face.look.text);
    let subtitle = if frame.modified {
        face.say_with("ui-edited", "name", Value::text(&frame.subtitle))
    } else {
        frame.subtitle.clone()
    };
    let dim = painter.layout_no_wrap(subtitle.clone(), face.look.font(Text::Body), face.look.dim);
    let width = strong.size().x + 10.0 + dim.size().x;
    let middle = bar.center().x - width / 2.0;
    let x = middle.min(room.right() - width).max(room.left());
    if strong.size().x > room.right() - x {
        return;
    }
    let y = bar.center().y;
    let end = x + strong.size().x;
    painter.galley(pos2(x, y - strong.size().y / 2.0), strong, face.look.text);
    let rest = Rect::from_min_max(pos2(end + 10.0, bar.top()), pos2(room.right(), bar.bottom()));
    if rest.width() > 60.0 {
        text_in(painter, rest, Align2::LEFT_CENTER, &subtitle, face.look.font(Text::Body), face.look.dim);
    }
}
