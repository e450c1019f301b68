//! Bars under the ribbon, never modal: what went wrong with a file, and where a path is typed.

use crate::{
    face::{Command, Face},
    paint,
    platform::Purpose,
    theme::Text,
    widgets::text_in,
};
use egui::{Align2, Key, Rect, Role as Part, Sense, TextEdit, Ui, WidgetInfo, vec2};
use rasterscope_core::{explain::Role, message::Message};
use rasterscope_figure::words::Words;

/// How much bigger everything may be in a large window.
const LARGE: f32 = 1.5;

/// What lies under the ribbon.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Notice {
    /// Something failed; the document stays as it was.
    Failed(String),
    /// What is drawn is not the scene: a product leaves the range of binary32.
    Beyond(String),
    /// Something worked that leaves no trace on the screen.
    Done(String),
    /// There are unsaved edits, and something would take them away.
    Unsaved(Box<Command>),
    /// The unsaved work of the last time is open again.
    Back,
    /// There is unsaved work of another time.
    Aside,
    /// The window is so large that everything could be bigger.
    Large,
    /// A path is asked for.
    Path {
        /// What for.
        purpose: Purpose,
        /// As typed so far.
        path: String,
        /// Whether the field still has to get the keyboard.
        fresh: bool,
    },
}

impl Notice {
    /// Its sentence and the buttons that answer it, but for a path.
    fn says(&self, face: &Face<'_>) -> (String, Vec<(&'static str, Command)>) {
        match self {
            Self::Failed(text) | Self::Beyond(text) | Self::Done(text) => {
                (text.clone(), vec![("ui-dismiss", Command::Dismiss)])
            }
            Self::Unsaved(_) => (
                face.say("ui-unsaved"),
                vec![
                    ("ui-save", Command::SaveFirst),
                    ("ui-discard", Command::Discard),
                    ("ui-cancel", Command::Dismiss),
                ],
            ),
            Self::Back => (
                face.say("ui-work-back"),
                vec![("ui-discard", Command::Reset), ("ui-dismiss", Command::Dismiss)],
            ),
            Self::Aside => (
                face.say("ui-work-aside"),
                vec![
                    ("ui-bring-back", Command::BringBack),
                    ("ui-discard", Command::Forget),
                    ("ui-later", Command::Dismiss),
                ],
            ),
            Self::Large => (
                face.say("ui-large"),
                vec![("ui-large-yes", Command::TextSize(LARGE)), ("ui-large-no", Command::Dismiss)],
            ),
            Self::Path { .. } => (String::new(), Vec::new()),
        }
    }
}

/// What was said of what cannot be drawn as it is.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Beyond {
    told: Option<Message>,
}

impl Beyond {
    /// Says it once, when nothing else is being said, and takes it back when it is over.
    pub(crate) fn tell(&mut self, now: Option<&Message>, notice: &mut Option<Notice>, words: &Words) {
        if self.told.as_ref() != now && matches!(notice, None | Some(Notice::Beyond(_))) {
            *notice = now.map(|message| Notice::Beyond(words.message(message)));
            self.told = now.cloned();
        }
    }
}

/// The height of the bar.
pub(crate) fn height(face: &Face<'_>) -> f32 {
    face.look.button_height() + 12.0
}

/// Shows the bar.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, notice: &mut Notice) {
    let rect = ui.max_rect();
    let bar = match notice {
        Notice::Failed(_) | Notice::Beyond(_) => Some(Role::Rejected),
        Notice::Done(_) => Some(Role::Accepted),
        Notice::Unsaved(_) | Notice::Back | Notice::Aside => Some(Role::Changed),
        Notice::Large | Notice::Path { .. } => None,
    };
    let color = bar.map_or(face.look.text, |role| face.look.role(role));
    ui.painter().rect_filled(Rect::from_min_size(rect.min, vec2(4.0, rect.height())), 0, color);
    ui.horizontal_centered(|ui| {
        ui.add_space(14.0);
        if let Some(role) = bar {
            let (at, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
            paint::marker(ui.painter(), at.center(), role, 11.0, face.look);
        }
        if let Notice::Path { purpose, path, fresh } = notice {
            return ask(ui, face, *purpose, path, fresh);
        }
        let (text, answers) = notice.says(face);
        let font = face.look.font(Text::Label);
        let wide =
            |name: &str| ui.painter().layout_no_wrap(name.to_owned(), font.clone(), color).size().x + 24.0;
        let names: Vec<String> = answers.iter().map(|(name, _)| face.say(name)).collect();
        let buttons: f32 = names.iter().map(|name| wide(name)).sum();
        let room = vec2(ui.available_width() - buttons - 20.0, face.look.button_height());
        let (rect, response) = ui.allocate_exact_size(room, Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Part::Label, true, text.as_str()));
        text_in(ui.painter(), rect, Align2::LEFT_CENTER, &text, face.look.font(Text::Body), face.look.text);
        response.on_hover_text(text.as_str());
        for (name, (_, command)) in names.into_iter().zip(answers) {
            if ui.button(name).clicked() {
                face.ask(command);
            }
        }
    });
}

fn ask(ui: &mut Ui, face: &Face<'_>, purpose: Purpose, path: &mut String, fresh: &mut bool) {
    let save = purpose != Purpose::Open;
    let label = ui.label(face.rich(
        face.say(match purpose {
            Purpose::Open => "ui-path-open",
            Purpose::Save => "ui-path-save",
            Purpose::Picture => "ui-path-picture",
            Purpose::Film => "ui-path-film",
        }),
        Text::Body,
    ));
    let width = (ui.available_width() - 330.0).max(160.0);
    let field = ui.add(TextEdit::singleline(path).desired_width(width).font(face.look.font(Text::Mono)));
    let field = field.labelled_by(label.id);
    if std::mem::take(fresh) {
        field.request_focus();
    }
    let enter = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
    let done = ui.button(face.say(if save { "ui-save" } else { "ui-open" })).clicked();
    if (enter || done) && !path.trim().is_empty() {
        let path = path.trim().to_owned();
        face.ask(match purpose {
            Purpose::Open => Command::Open(path),
            Purpose::Save => Command::SaveAs(path),
            Purpose::Picture => Command::Picture(path),
            Purpose::Film => Command::Film(path),
        });
    }
    if ui.button(face.say("ui-choose-file")).clicked() {
        face.ask(Command::Choose(purpose));
    }
    if ui.button(face.say("ui-cancel")).clicked() {
        face.ask(Command::Dismiss);
    }
}
