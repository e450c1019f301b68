//! The command palette: every command with its key, filtered as one types.

use super::{Frame, keys, menu};
use crate::{
    commands::TEXT_SIZES,
    document::Palette,
    face::{Command, Face},
    measure::Page,
    theme::Text,
    widgets::{row, text_in},
};
use egui::{Align2, Key, Modifiers, Rect, ScrollArea, TextEdit, Ui, Window, vec2};
use rasterscope_core::{
    explain::Level,
    labs,
    message::{Message, Value},
};
use rasterscope_figure::theme::ThemeName;

/// Width of the palette.
const WIDTH: f32 = 440.0;
/// Rows that show without scrolling.
const ROWS: f32 = 10.0;

/// A command of the palette.
struct Entry {
    name: String,
    key: String,
    command: Command,
}

/// Everything that can be asked for, in the order of the menus.
fn all(ui: &Ui, face: &Face<'_>, frame: &Frame<'_>) -> Vec<Entry> {
    let mut out: Vec<Entry> = Vec::new();
    for (shortcut, command, name) in keys::all() {
        // Escape closes the palette itself; a command with two keys stands here once.
        let twice = out.iter().any(|entry| entry.command == command);
        if !twice && !matches!(command, Command::Escape | Command::Palette) {
            let name = match command {
                Command::Overlay(overlay) => {
                    face.say_with("ui-palette-overlay", "name", Value::Word(overlay.word()))
                }
                _ => face.say(name),
            };
            out.push(Entry { name, key: keys::text(ui.ctx(), &shortcut), command });
        }
    }
    let mut add = |name: String, command| out.push(Entry { name, key: String::new(), command });
    let of = |id, name: String| face.words.message(&Message::new(id).with("name", Value::text(name)));
    for (name, command) in menu::WITHOUT_KEY {
        add(face.say(name), command);
    }
    for page in Page::ALL {
        add(of("measure-palette", face.say(page.word())), Command::Measure(page));
    }
    for theme in ThemeName::ALL {
        add(of("ui-palette-theme", face.say(menu::theme_message(theme))), Command::Theme(theme));
    }
    for size in TEXT_SIZES {
        add(of("ui-palette-text-size", format!("{} %", size * 100.0)), Command::TextSize(size));
    }
    for level in Level::ALL {
        add(of("ui-palette-level", face.say(keys::level(level))), Command::Level(level));
    }
    for lab in labs::ALL {
        add(of("ui-palette-lab", face.words.word(lab.name)), Command::Lab(lab.name));
    }
    for entry in comparable(face, frame) {
        if matches!(entry.command, Command::Compare(Some(_))) {
            add(of("ui-palette-compare", entry.name), entry.command);
        }
    }
    for preset in frame.presets {
        add(of("ui-palette-preset", preset.title.clone()), Command::Preset(preset.name));
    }
    out
}

/// What the open lab can be compared with; first how to leave the comparison, if there is one.
fn comparable(face: &Face<'_>, frame: &Frame<'_>) -> Vec<Entry> {
    let entry = |name, key: &str, command| Entry { name, key: key.to_owned(), command };
    let leave =
        frame.compare.is_some().then(|| entry(face.say("ui-split-leave"), "Esc", Command::Compare(None)));
    let settings = frame.settings.iter().map(|setting| {
        let message = Message::new("ui-compare-setting")
            .with("setting", Value::Word(setting.word()))
            .with("value", setting.value());
        entry(face.words.message(&message), "", Command::Compare(Some(*setting)))
    });
    leave.into_iter().chain(settings).collect()
}

/// Whether every word typed is in the name.
fn fits(name: &str, typed: &str) -> bool {
    let name = name.to_lowercase();
    typed.to_lowercase().split_whitespace().all(|word| name.contains(word))
}

/// Shows the palette.
pub(crate) fn show(ui: &Ui, face: &Face<'_>, frame: &Frame<'_>, palette: &mut Palette) {
    let entries = if palette.compare { comparable(face, frame) } else { all(ui, face, frame) };
    let nothing = palette.compare && entries.is_empty();
    let entries: Vec<Entry> = entries.into_iter().filter(|entry| fits(&entry.name, &palette.typed)).collect();
    let (down, up, enter, escape) = ui.input_mut(|input| {
        let mut pressed = |key| input.count_and_consume_key(Modifiers::NONE, key);
        (pressed(Key::ArrowDown), pressed(Key::ArrowUp), pressed(Key::Enter), pressed(Key::Escape))
    });
    let last = entries.len().saturating_sub(1);
    palette.chosen = (palette.chosen.min(last) + down).saturating_sub(up).min(last);
    let mut close = escape > 0;
    if let Some(entry) = entries.get(palette.chosen).filter(|_| enter > 0) {
        face.ask(entry.command.clone());
        close = true;
    }
    let content = ui.ctx().content_rect();
    let title = face.say(if palette.compare { "ui-compare" } else { "ui-palette" });
    let area = Window::new(&title)
        .title_bar(false)
        .resizable(false)
        .pivot(Align2::CENTER_TOP)
        .fixed_pos(content.center_top() + vec2(0.0, 90.0));
    area.show(ui.ctx(), |ui| {
        ui.set_width(WIDTH);
        let typed = palette.typed.clone();
        let field = TextEdit::singleline(&mut palette.typed)
            .hint_text(face.say(if palette.compare { "ui-compare-hint" } else { "ui-palette-hint" }))
            .desired_width(f32::INFINITY);
        let field = ui.add(field);
        field.clone().accessible_name(&title);
        if !std::mem::replace(&mut palette.shown, true) || !field.has_focus() {
            field.request_focus();
        }
        if palette.typed != typed {
            palette.chosen = 0;
        }
        ui.add_space(4.0);
        let height = face.look.row_height();
        let scrolled = down + up > 0;
        ScrollArea::vertical().max_height(height * ROWS).auto_shrink([false, true]).show(ui, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            for (i, entry) in entries.iter().enumerate() {
                let response = entry_row(ui, face, entry, i == palette.chosen);
                if i == palette.chosen && scrolled {
                    response.scroll_to_me(None);
                }
                if response.clicked() {
                    face.ask(entry.command.clone());
                    close = true;
                }
            }
            if entries.is_empty() {
                let why = if nothing { "ui-compare-nothing" } else { "ui-palette-none" };
                ui.label(face.dim(face.say(why), Text::Label));
            }
        });
    });
    if close {
        // Before what was chosen, which may open it again.
        face.commands.borrow_mut().insert(0, Command::Palette);
    }
}

fn entry_row(ui: &mut Ui, face: &Face<'_>, entry: &Entry, chosen: bool) -> egui::Response {
    row(ui, face, face.look.row_height(), &entry.name, chosen, |ui, rect| {
        if chosen {
            ui.painter().rect_filled(rect, 0, face.look.raised);
            let bar = Rect::from_min_size(rect.min, vec2(4.0, rect.height()));
            ui.painter().rect_filled(bar, 0, face.look.text);
        }
        let font = face.look.font(if chosen { Text::LabelStrong } else { Text::Label });
        let room = rect.shrink2(vec2(9.0, 0.0));
        let name = room.with_max_x(room.right() - 120.0);
        text_in(ui.painter(), name, Align2::LEFT_CENTER, &entry.name, font, face.look.text);
        let key = room.with_min_x(room.right() - 120.0);
        let font = face.look.font(Text::Small);
        text_in(ui.painter(), key, Align2::RIGHT_CENTER, &entry.key, font, face.look.dim);
    })
}

#[cfg(test)]
mod tests {
    use super::fits;

    #[test]
    fn every_word_typed_has_to_be_there() {
        for (name, typed, expected) in [
            ("Theme: Light", "", true),
            ("Theme: Light", "li the", true),
            ("Theme: Light", "dark", false),
            ("Save as…", "SAVE", true),
        ] {
            assert_eq!(fits(name, typed), expected, "{name:?} {typed:?}");
        }
    }
}
