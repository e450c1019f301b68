//! The keys: one table that handles them and that the overlay shows.

use crate::{
    face::{Command, Face},
    theme::Text,
};
use egui::{
    Align2, Context, EventFilter, Grid, Id, Key, KeyboardShortcut, Modifiers, Popup, ScrollArea, Ui, Window,
};
use rasterscope_core::{explain::Level, pipeline::Overlay};

/// One key, what it does, and the message that says so.
type Shortcut = (KeyboardShortcut, Command, &'static str);

/// All keys.
pub(crate) fn all() -> Vec<Shortcut> {
    let key = |key| KeyboardShortcut::new(Modifiers::NONE, key);
    let ctrl = |key| KeyboardShortcut::new(Modifiers::COMMAND, key);
    let ctrl_shift = |key| KeyboardShortcut::new(Modifiers::COMMAND | Modifiers::SHIFT, key);
    let shift = |key| KeyboardShortcut::new(Modifiers::SHIFT, key);
    vec![
        // Before the same keys without Shift, which they would be taken for.
        (shift(Key::ArrowLeft), Command::MovePixel([-1, 0]), "ui-key-pixel"),
        (shift(Key::ArrowRight), Command::MovePixel([1, 0]), "ui-key-pixel"),
        (shift(Key::ArrowUp), Command::MovePixel([0, -1]), "ui-key-pixel"),
        (shift(Key::ArrowDown), Command::MovePixel([0, 1]), "ui-key-pixel"),
        (key(Key::Home), Command::Begin, "ui-timeline-begin"),
        (key(Key::ArrowLeft), Command::Back, "ui-timeline-back"),
        (key(Key::Space), Command::Play, "ui-key-play"),
        (key(Key::ArrowRight), Command::Next, "ui-timeline-forward"),
        (key(Key::End), Command::End, "ui-timeline-end"),
        (ctrl_shift(Key::Z), Command::Redo, "ui-edit-redo"),
        (ctrl(Key::Z), Command::Undo, "ui-edit-undo"),
        (ctrl(Key::Y), Command::Redo, "ui-edit-redo"),
        (ctrl(Key::O), Command::AskOpen, "ui-file-open"),
        (ctrl_shift(Key::S), Command::AskSave, "ui-file-save-as"),
        (ctrl(Key::S), Command::Save, "ui-file-save"),
        (ctrl_shift(Key::E), Command::AskFilm, "ui-file-film"),
        (ctrl(Key::E), Command::AskPicture, "ui-file-picture"),
        (ctrl_shift(Key::C), Command::CopyPicture, "ui-copy-picture"),
        (ctrl(Key::Q), Command::Quit, "ui-file-quit"),
        (ctrl(Key::K), Command::Palette, "ui-palette"),
        (ctrl_shift(Key::P), Command::Palette, "ui-palette"),
        (ctrl(Key::Plus), Command::Bigger, "ui-key-bigger"),
        (ctrl(Key::Equals), Command::Bigger, "ui-key-bigger"),
        (ctrl(Key::Minus), Command::Smaller, "ui-key-smaller"),
        (ctrl(Key::Num0), Command::TextSize(1.0), "ui-key-normal"),
        (key(Key::C), Command::AskCompare, "ui-compare"),
        (ctrl(Key::PageDown), Command::Beside(1), "ui-key-next-algorithm"),
        (ctrl(Key::PageUp), Command::Beside(-1), "ui-key-last-algorithm"),
        (key(Key::Num0), Command::Overlay(Overlay::None), "ui-key-overlay"),
        (key(Key::Num1), Command::Overlay(Overlay::Depth), "ui-key-overlay"),
        (key(Key::Num2), Command::Overlay(Overlay::Stencil), "ui-key-overlay"),
        (key(Key::Num3), Command::Overlay(Overlay::Generated), "ui-key-overlay"),
        (key(Key::Num4), Command::Overlay(Overlay::Written), "ui-key-overlay"),
        (key(Key::Num5), Command::Overlay(Overlay::Wireframe), "ui-key-overlay"),
        (key(Key::Num6), Command::Overlay(Overlay::Triangle), "ui-key-overlay"),
        (key(Key::Num7), Command::Overlay(Overlay::Changed), "ui-key-overlay"),
        (key(Key::Num8), Command::Overlay(Overlay::Equal), "ui-key-overlay"),
        (key(Key::F), Command::Fit, "ui-key-fit"),
        (key(Key::F2), Command::Exact, "ui-key-exact"),
        (key(Key::F8), Command::NextTheme, "ui-key-theme"),
        (key(Key::F1), Command::Keys, "ui-help-keys"),
        (key(Key::Escape), Command::Escape, "ui-key-escape"),
    ]
}

/// The commands of the keys pressed since the last frame, taken from egui before it paints, so
/// that the frame already shows what they did. A text field with focus keeps its keys, and a
/// focused widget those that operate it.
pub(crate) fn pressed(ctx: &Context, handles: &[Id]) -> Vec<Command> {
    if ctx.text_edit_focused() || Popup::is_any_open(ctx) {
        return Vec::new();
    }
    let focused = ctx.memory(egui::Memory::focused);
    let handle = focused.is_some_and(|id| handles.contains(&id));
    ctx.input_mut(|input| {
        let mut commands = Vec::new();
        for (shortcut, command, _) in all() {
            let taken = match shortcut.logical_key {
                Key::Space => focused.is_some(),
                Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown => handle,
                _ => false,
            };
            if !taken && input.consume_shortcut(&shortcut) {
                commands.push(command);
            }
        }
        commands
    })
}

/// A key as it is shown.
pub(crate) fn text(ctx: &Context, shortcut: &KeyboardShortcut) -> String {
    match shortcut.logical_key {
        Key::ArrowLeft if shortcut.modifiers.shift => "Shift ← → ↑ ↓".to_owned(),
        Key::ArrowLeft => "←".to_owned(),
        Key::ArrowRight => "→".to_owned(),
        _ => ctx.format_shortcut(shortcut),
    }
}

/// The message that names the size of a step.
pub(crate) fn level(level: Level) -> &'static str {
    match level {
        Level::Primitive => "ui-level-primitive",
        Level::Row => "ui-level-row",
        Level::Detail => "ui-level-detail",
    }
}

/// Keeps the arrow keys from moving the focus: left and right step, and on a handle all four move
/// it. Tab moves the focus.
pub(crate) fn keep_arrows(ctx: &Context) {
    let popup = Popup::is_any_open(ctx);
    ctx.memory_mut(|memory| {
        if !popup && let Some(id) = memory.focused() {
            let filter =
                EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
            memory.set_focus_lock_filter(id, filter);
        }
    });
}

/// What the overlay says: a key, and what it does.
fn rows(ctx: &Context, face: &Face<'_>) -> Vec<[String; 2]> {
    // One row says what all four do, and all eight.
    let alike = |command: &Command| match command {
        Command::MovePixel(by) => *by != [-1, 0],
        Command::Overlay(overlay) => *overlay != Overlay::None,
        _ => false,
    };
    let each = all().into_iter().filter(|(_, command, _)| !alike(command));
    let mut rows: Vec<_> = each
        .map(|(shortcut, command, name)| {
            let key = match command {
                Command::Overlay(_) => format!("0 … {}", Overlay::ALL.len() - 1),
                _ => text(ctx, &shortcut),
            };
            [key, face.say(name)]
        })
        .collect();
    let others = [("Tab", "ui-key-tab"), ("← → ↑ ↓", "ui-key-arrows"), ("Alt", "ui-key-alt")];
    rows.extend(others.map(|(key, name)| [key.to_owned(), face.say(name)]));
    rows
}

/// Room between a key and its meaning, between two columns, and round all of them.
const APART: [f32; 3] = [16.0, 36.0, 24.0];

/// Shows all keys over the canvas: in two columns if they fit side by side, and never higher than
/// the window, so that the button that closes it is always there.
pub(crate) fn overlay(ui: &Ui, face: &Face<'_>) {
    let whole = ui.ctx().content_rect();
    let area = Window::new(face.say("ui-help-keys"))
        .collapsible(false)
        .resizable(false)
        .pivot(Align2::CENTER_CENTER)
        .fixed_pos(whole.center());
    let rows = rows(ui.ctx(), face);
    let measure = |text: &str, style| {
        ui.painter().layout_no_wrap(text.to_owned(), face.look.font(style), face.look.text).size().x
    };
    let [keys, names] = [(0, Text::MonoStrong), (1, Text::Label)]
        .map(|(part, style)| rows.iter().map(|row| measure(&row[part], style)).fold(0.0, f32::max));
    let wide = keys + APART[0] + names;
    let columns = if 2.0 * wide + APART[1] + APART[2] <= whole.width() { 2 } else { 1 };
    let line = face.look.line_height(Text::Label).max(face.look.line_height(Text::Mono));
    // The title, the button and the borders keep their place.
    let room = whole.height() - 2.0 * face.look.button_height() - 56.0;
    let shown = area.show(ui.ctx(), |ui| {
        ui.spacing_mut().interact_size.y = line;
        ScrollArea::vertical().max_height(room).auto_shrink(true).show(ui, |ui| {
            let grid = Grid::new("keys").num_columns(2 * columns).min_row_height(line);
            grid.spacing([APART[0], 2.0]).show(ui, |ui| {
                let high = rows.len().div_ceil(columns);
                for i in 0..high {
                    for [key, name] in rows.iter().skip(i).step_by(high) {
                        ui.label(face.rich(key, Text::MonoStrong));
                        ui.horizontal(|ui| {
                            ui.label(face.rich(name, Text::Label));
                            ui.add_space(if columns > 1 { APART[1] - APART[0] } else { 0.0 });
                        });
                    }
                    ui.end_row();
                }
            });
        });
        ui.add_space(8.0);
        ui.spacing_mut().interact_size.y = face.look.button_height();
        if ui.button(face.say("ui-close")).clicked() {
            face.ask(Command::Keys);
        }
    });
    // A frame late a window knows its size: without the next frame it would stand there cut off.
    let size = shown.map(|shown| shown.response.rect.size());
    let known = ui.scope_id().with("keys");
    if ui.data(|data| data.get_temp(known)) != Some(size) {
        ui.data_mut(|data| data.insert_temp(known, size));
        ui.ctx().request_repaint();
    }
}
