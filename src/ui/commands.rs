//! What happens when a panel or a key asks for something.

use crate::{
    app::App,
    document::{Document, Palette, Tab},
    face::Command,
    files,
    opening::When,
    overview::Entry,
    platform::{Platform, Purpose},
    recent,
    shell::notice::Notice,
    theme::Look,
};
use egui::Context;
use rasterscope_core::{
    compare::Setting,
    labs::{self, LabInput},
    math::Arithmetic,
    message::{Message, Value},
    scene,
};
use rasterscope_figure::{theme::ThemeName, words::reason};
use std::rc::Rc;

impl App {
    /// Does what was asked for, in order.
    pub(crate) fn execute(&mut self, ctx: &Context, commands: Vec<Command>, platform: &mut dyn Platform) {
        for command in commands {
            if command.replaces() && self.modified() {
                self.then = None;
                self.notice = Some(Notice::Unsaved(Box::new(command)));
            } else {
                self.one(ctx, command, platform);
            }
        }
    }

    /// Does one thing, without asking for unsaved edits.
    fn one(&mut self, ctx: &Context, command: Command, platform: &mut dyn Platform) {
        self.measure.open &= !command.shows_lab();
        match command {
            Command::Seek(step) => self.seek(|app| app.run.seek(step)),
            Command::Next => self.seek(|app| app.run.next(app.view.level)),
            Command::Back => self.seek(|app| app.run.back(app.view.level)),
            Command::Begin => self.seek(|app| app.run.seek(0)),
            Command::End => self.seek(|app| app.run.seek(usize::MAX)),
            Command::ToLine(line) => self.seek(|app| app.run.seek_line(line)),
            Command::ToEntry(index) => self.go_to_entry(index),
            Command::Pixel(pixel) => self.choose_pixel(pixel),
            Command::MovePixel(by) => {
                let [width, height] = self.document.scene.size;
                let from = self.view.pixel.unwrap_or([width / 2, height / 2]);
                self.choose_pixel([0, 1].map(|axis| from[axis].saturating_add_signed(by[axis].into())));
            }
            Command::Play => self.toggle_play(ctx),
            Command::Level(level) => self.view.level = level,
            Command::Speed(speed) => self.view.speed = speed,
            Command::Overlay(overlay) => self.view.overlay = overlay,
            Command::Undo => self.history.undo(&mut self.document),
            Command::Redo => self.history.redo(&mut self.document),
            Command::NextTheme => {
                let at = ThemeName::ALL.iter().position(|theme| *theme == self.view.theme).unwrap_or(0);
                self.wear(ctx, ThemeName::ALL[(at + 1) % ThemeName::ALL.len()]);
            }
            Command::Theme(theme) => self.wear(ctx, theme),
            Command::TextSize(size) => {
                ctx.set_zoom_factor(size);
                self.notice.take_if(|notice| *notice == Notice::Large);
            }
            Command::Bigger => resize(ctx, 1),
            Command::Smaller => resize(ctx, -1),
            Command::Palette => self.view.palette = self.view.palette.is_none().then(Palette::default),
            Command::AskCompare => {
                self.view.palette = Some(Palette { compare: true, ..Palette::default() });
            }
            Command::Split if self.split() => self.compare(None),
            Command::Split => self.one(ctx, Command::AskCompare, platform),
            Command::Compare(setting) => self.compare(setting),
            Command::OfSide(side, setting) => self.edit(|document| document.choose(side, setting)),
            Command::CaseInLab => self.open_case(),
            Command::MeasureSkips => self.measure_skips(ctx, platform),
            Command::Explain(side) => self.run.explain(side),
            Command::Keys => self.view.keys = !self.view.keys,
            Command::Choices => self.view.choices = !self.view.choices,
            Command::Hints => self.view.aids.hints = !self.view.aids.hints,
            Command::Exact => self.view.aids.exact = !self.view.aids.exact,
            Command::Still => self.view.aids.still = !self.view.aids.still,
            Command::Fit => {
                self.canvas.fit();
                self.view.orbit = None;
                self.view.outside = None;
            }
            Command::Escape => self.escape(ctx),
            Command::Stage(stage) => self.open_lab(self.view.recent.at(stage).unwrap_or("pipeline")),
            Command::Lab(name) => self.open_lab(name),
            Command::Beside(by) => {
                let next = recent::beside(self.labs[self.lab()].name(), by);
                next.into_iter().for_each(|name| self.open_lab(name));
            }
            Command::Preset(name) => self.open_preset(name),
            Command::Open(path) => self.open(ctx, &path, When::Later, platform),
            Command::Choose(purpose) => {
                let proposed = self.proposed(purpose);
                if !platform.choose_file(purpose, files::split(&proposed)[1]) {
                    self.notice = Some(Notice::Failed(self.words.word("ui-no-dialog")));
                }
            }
            Command::AskOpen => self.ask_path(Purpose::Open),
            Command::AskSave => self.ask_path(Purpose::Save),
            Command::AskPicture => self.ask_path(Purpose::Picture),
            Command::AskFilm => self.ask_path(Purpose::Film),
            Command::SaveAs(path) => self.save(ctx, &path, platform),
            Command::Save => match self.path.clone().filter(|path| path.ends_with(".json")) {
                Some(path) => self.save(ctx, &path, platform),
                None => self.ask_path(Purpose::Save),
            },
            Command::Picture(path) => self.write_picture(&path, platform),
            Command::Film(path) => self.start_film(ctx, &path, platform),
            Command::Stop => self.stop(),
            Command::Measure(page) => self.measure.open(page),
            Command::LeaveMeasure => {}
            Command::StartMeasuring(scope) => {
                self.measure.start(scope, ctx.input(|input| input.time), platform);
            }
            Command::CopyPicture => self.copy_picture(ctx),
            Command::CopyValues => self.copy_values(ctx, platform),
            Command::Dismiss => {
                self.notice = None;
                self.then = None;
            }
            Command::Reset => {
                self.reset(ctx, platform);
                self.notice = None;
            }
            Command::SaveFirst => {
                if let Some(Notice::Unsaved(then)) = self.notice.take() {
                    self.then = Some(then);
                    self.one(ctx, Command::Save, platform);
                }
            }
            Command::Discard => {
                if let Some(Notice::Unsaved(then)) = self.notice.take() {
                    self.one(ctx, *then, platform);
                }
            }
            Command::BringBack => self.bring_back(ctx, platform),
            Command::Forget => {
                self.forget(platform);
                self.notice = None;
            }
            Command::Quit => self.quit(ctx, platform),
        }
    }

    /// Chooses a pixel of the image and shows its history.
    fn choose_pixel(&mut self, pixel: [u32; 2]) {
        let size = self.document.scene.size;
        self.view.pixel = Some([0, 1].map(|axis| pixel[axis].min(size[axis] - 1)));
        self.view.tab = Tab::Pixel;
    }

    /// Goes to the step that decided about an entry of the chosen pixel's history; if the open lab has no
    /// such step, opens the one that has, about that triangle.
    fn go_to_entry(&mut self, index: usize) {
        let Some(pixel) = self.view.pixel else { return };
        let words = Rc::clone(&self.words);
        let Some(history) = self.overview.history(pixel, &words) else { return };
        let Some(entry) = history.entries.get(index) else { return };
        // Of a lab that runs something else than the scene the number of fragments differs.
        let before = |all: &[Entry]| all.iter().filter(|entry| entry.fragment).count();
        let (nth, all) = (before(&history.entries[..index]), before(&history.entries));
        let step = |app: &Self| {
            let steps = app.run.fragments_at(pixel);
            steps.get(nth).copied().filter(|_| entry.fragment && steps.len() == all)
        };
        if step(self).is_none() {
            let input = labs::lab_of(&entry.of, &self.document.scene);
            self.edit(|document| document.show_lab(input));
            self.view.due = None;
            self.canvas.fit();
            self.view.outside = None;
            self.start_anew(None);
        }
        match step(self) {
            Some(step) => self.seek(|app| app.run.seek(step)),
            None => self.view.tab = Tab::Step,
        }
    }

    /// Moves the cursor by hand, which ends playing.
    fn seek(&mut self, go: impl FnOnce(&mut Self)) {
        self.view.due = None;
        go(self);
    }

    fn toggle_play(&mut self, ctx: &Context) {
        let Some(shown) = self.run.shown().filter(|_| self.view.due.is_none()) else {
            self.view.due = None;
            return;
        };
        if shown.cursor == shown.len {
            self.run.seek(0);
        }
        let now = ctx.input(|input| input.time);
        self.view.due = Some(now + 1.0 / f64::from(self.view.speed));
        ctx.request_repaint();
    }

    pub(crate) fn wear(&mut self, ctx: &Context, theme: ThemeName) {
        self.view.theme = theme;
        self.look = Rc::new(Look::new(theme));
        self.look.apply(ctx);
    }

    /// Takes back what is in progress: a drag first, then what lies over the canvas.
    fn escape(&mut self, ctx: &Context) {
        if self.canvas.dragging() || self.beside.dragging() {
            if let Some(before) = self.history.before() {
                self.document = before.clone();
            }
            ctx.stop_dragging();
        } else if self.view.palette.is_some() {
            self.view.palette = None;
        } else if self.view.keys {
            self.view.keys = false;
        } else if self.notice.is_some() {
            self.notice = None;
            self.then = None;
        } else if self.view.choices {
            self.view.choices = false;
        } else if self.view.playing() {
            self.view.due = None;
        } else if self.measure.open {
            if self.measure.is_busy() {
                self.measure.stop();
            } else {
                self.measure.open = false;
            }
        } else if self.busy(ctx).is_some() || !self.split() {
            self.stop();
        } else {
            self.compare(None);
        }
    }

    /// Opens the first broken case of the stress lab in the lab of its operation, with exact beside it.
    fn open_case(&mut self) {
        let LabInput::Stress(stress) = *self.document.input() else { return };
        let Some(case) = stress.shrunk(&self.document.scene) else {
            self.notice = Some(Notice::Failed(self.words.word("stress-nothing-to-open")));
            return;
        };
        self.edit(|document| {
            document.open_lab(case.name(), || case.clone());
            *document.input_mut() = case;
            document.compare(Some(Setting::Arithmetic(Arithmetic::Exact)));
        });
        self.view.due = None;
        self.canvas.fit();
        self.view.outside = None;
    }

    /// Shows two sides that differ in a setting, or one side only; can be undone.
    fn compare(&mut self, setting: Option<Setting>) {
        self.edit(|document| document.compare(setting));
    }

    /// Edits the document as one gesture.
    fn edit(&mut self, change: impl FnOnce(&mut Document)) {
        self.history.begin(&self.document);
        change(&mut self.document);
        self.history.end(&self.document, false);
    }

    fn ask_path(&mut self, purpose: Purpose) {
        self.notice = Some(Notice::Path { purpose, path: self.proposed(purpose), fresh: true });
    }

    /// The path that is offered.
    fn proposed(&self, purpose: Purpose) -> String {
        match (purpose, &self.path) {
            (Purpose::Picture | Purpose::Film, _) => self.picture_path(purpose),
            (_, Some(path)) if purpose == Purpose::Open || path.ends_with(".json") => path.clone(),
            (Purpose::Open, _) => String::new(),
            (Purpose::Save, _) => "scene.json".to_owned(),
        }
    }

    /// Opens a preset of the program.
    pub(crate) fn open_preset(&mut self, name: &'static str) {
        let Some(preset) = scene::preset(name) else { return };
        match files::scene(preset.json.as_bytes(), "", &mut |_| None) {
            Ok(scene) => {
                self.replace(scene);
                self.path = None;
                self.preset = Some((name, self.document.scene.clone()));
            }
            Err(problem) => self.notice = Some(Notice::Failed(self.words.message(&problem))),
        }
    }

    fn save(&mut self, ctx: &Context, path: &str, platform: &mut dyn Platform) {
        let mut scene = self.document.scene.clone();
        if let (Some(lab), Some(shown)) = (&mut scene.lab, self.run.shown()) {
            lab.step = (shown.cursor < shown.len).then_some(shown.cursor);
        }
        let done = platform.write(path, scene.to_json().as_bytes());
        let then = self.then.take().filter(|_| done.is_ok());
        if done.is_ok() {
            self.path = Some(path.to_owned());
            self.clean = Some(self.document.clone());
        }
        self.saved(path, done);
        if let Some(then) = then {
            self.one(ctx, *then, platform);
        }
    }
}

/// Factors of the text size.
pub(crate) const TEXT_SIZES: [f32; 6] = [0.75, 1.0, 1.25, 1.5, 1.75, 2.0];

/// The next text size, bigger or smaller.
fn resize(ctx: &Context, by: isize) {
    let now = ctx.zoom_factor();
    let near = |size: f32| (size - now).abs();
    let at = (0..TEXT_SIZES.len()).min_by(|a, b| near(TEXT_SIZES[*a]).total_cmp(&near(TEXT_SIZES[*b])));
    let next = at.unwrap_or(1).saturating_add_signed(by).min(TEXT_SIZES.len() - 1);
    ctx.set_zoom_factor(TEXT_SIZES[next]);
}

/// What went wrong with a file.
pub(crate) fn unreadable(id: &'static str, path: &str, error: &std::io::Error) -> Message {
    Message::new(id).with("path", Value::text(path)).with("reason", reason(error))
}
