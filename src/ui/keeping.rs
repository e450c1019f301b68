//! Unsaved work: asked for before it is taken away, and kept while the program may end.

use crate::{
    app::App,
    document::Document,
    face::Command,
    files,
    opening::When,
    platform::Platform,
    session::{Session, Settings},
    shell::{WIDEST, notice::Notice},
};
use egui::{Context, ViewportCommand};
use rasterscope_core::{message::Message, scene};
use rasterscope_figure::words::reason;
use std::time::Duration;

/// The work and the settings, as they are.
const SESSION: &str = "session.json";
/// Work that was unsaved when a file was opened at the start.
const ASIDE: &str = "unsaved.json";
/// How long an edit may wait until it is kept, in seconds.
const DELAY: f64 = 2.0;

/// What was kept last, and when the next time is due.
#[derive(Debug, Default)]
pub(crate) struct Kept {
    last: Option<(Document, Settings, bool)>,
    due: Option<f64>,
    /// Whether it was said that nothing can be kept here.
    failed: bool,
    /// The window's title, as last set.
    title: String,
}

impl App {
    /// Brings back what was kept at the last start, and opens a file if there is one.
    pub fn start(&mut self, ctx: &Context, file: Option<&str>, platform: &mut dyn Platform) {
        let session = platform.kept(SESSION).and_then(|bytes| Session::from_bytes(&bytes));
        // Who has been here knows where to drag, and how large things are wanted.
        self.first = session.is_none();
        self.view.aids.hints = self.first;
        if let Some(session) = session {
            session.settings.apply(&mut self.view);
            self.wear(ctx, self.view.theme);
            ctx.set_zoom_factor(session.settings.text_size());
            if file.is_none() {
                return self.take_up(ctx, (session, None), When::First, platform);
            }
            if session.modified && platform.keep(ASIDE, &session.to_bytes()).is_err() {
                // What cannot be set aside stays on the screen.
                return self.take_up(ctx, (session, file), When::First, platform);
            }
        }
        match file {
            Some(file) => self.open(ctx, file, When::First, platform),
            None => self.offer_aside(platform),
        }
    }

    /// Says that there is work set aside.
    pub(crate) fn offer_aside(&mut self, platform: &mut dyn Platform) {
        if self.notice.is_none() && self.aside(platform).is_some() {
            self.notice = Some(Notice::Aside);
        }
    }

    /// Offers bigger text once in a first start, when the window is large: it may be made so later.
    pub(crate) fn offer(&mut self, ctx: &Context) {
        let large = ctx.content_rect().width() >= WIDEST && ctx.zoom_factor() == 1.0;
        if self.first && large && self.notice.is_none() {
            self.first = false;
            self.notice = Some(Notice::Large);
        }
    }

    /// Sets the work of a session aside that cannot be opened now: a model may be missing.
    pub(crate) fn set_aside(&mut self, session: &Session, platform: &mut dyn Platform) {
        if session.modified {
            // Where nothing can be kept nothing is overwritten either.
            let _ = platform.keep(ASIDE, &session.to_bytes());
        }
    }

    fn aside(&self, platform: &mut dyn Platform) -> Option<Session> {
        platform.kept(ASIDE).and_then(|bytes| Session::from_bytes(&bytes))
    }

    /// Goes on where a session ended.
    pub(crate) fn take_session(&mut self, session: Session, document: Document, step: Option<usize>) {
        self.preset = None;
        self.path = session.path.clone();
        if let Some(name) = &session.preset
            && let Some(preset) = scene::preset(name)
            && let Ok(scene) = files::scene(preset.json.as_bytes(), "", &mut |_| None)
        {
            self.preset = Some((preset.name, Document::new(scene).scene));
        }
        self.take(document, step);
        self.history = Default::default();
        self.clean = (!session.modified).then(|| self.document.clone());
        if session.modified {
            // The preset is what a reset goes back to.
            self.clean = self.preset.as_ref().map(|(_, scene)| Document::new(scene.clone()));
            self.notice = Some(Notice::Back);
        }
    }

    /// Brings back the work that was set aside.
    pub(crate) fn bring_back(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        if let Some(session) = self.aside(platform) {
            self.notice = None;
            self.take_up(ctx, (session, None), When::Later, platform);
        }
    }

    /// Forgets the work that was set aside.
    pub(crate) fn forget(&mut self, platform: &mut dyn Platform) {
        // Nothing is lost if that fails: it is offered again.
        let _ = platform.keep(ASIDE, b"");
    }

    /// Goes back to the document before the edits.
    pub(crate) fn reset(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        match (self.clean.clone(), self.path.clone()) {
            (Some(clean), _) => {
                self.history.begin(&self.document);
                self.document = clean;
                self.history.end(&self.document, false);
            }
            (None, Some(path)) => self.open(ctx, &path, When::Later, platform),
            (None, None) => {
                if let Some(first) = self.presets.first() {
                    self.open_preset(first.name);
                }
            }
        }
    }

    /// Whether there are edits that are in no file.
    pub(crate) fn modified(&self) -> bool {
        self.clean.as_ref().is_none_or(|clean| !self.document.same_work(clean))
    }

    /// Asks before the window is closed with unsaved edits.
    pub(crate) fn closing(&mut self, ctx: &Context) {
        if ctx.input(|input| input.viewport().close_requested()) && !self.quitting && self.modified() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.notice = Some(Notice::Unsaved(Box::new(Command::Quit)));
        }
    }

    /// Closes the window; what is not saved now is not wanted.
    pub(crate) fn quit(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        if self.modified() {
            self.reset(ctx, platform);
        }
        self.quitting = true;
        // What is being opened instead is waited for.
        if self.opening.is_none() {
            ctx.send_viewport_cmd(ViewportCommand::Close);
        }
    }

    /// Keeps the work if it has changed and was not kept lately; asks for the frame in which it is
    /// due.
    pub(crate) fn autosave(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        self.title(ctx);
        let settings = Settings::of(&self.view, ctx.zoom_factor());
        let modified = self.modified();
        let same = self.kept.last.as_ref().is_some_and(|(document, with, was)| {
            *was == modified && *with == settings && *document == self.document
        });
        if same || self.opening.is_some() {
            self.kept.due = None;
            return;
        }
        let now = ctx.input(|input| input.time);
        let due = *self.kept.due.get_or_insert(now + DELAY);
        if now < due {
            ctx.request_repaint_after(Duration::from_secs_f64((due - now).max(0.01)));
            return;
        }
        self.keep(ctx, platform);
    }

    /// Keeps the work at once: before the program ends.
    pub fn keep(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        if self.opening.is_some() {
            // What was kept before may be what is being opened.
            return;
        }
        let settings = Settings::of(&self.view, ctx.zoom_factor());
        let step = self.run.shown().and_then(|shown| (shown.cursor < shown.len).then_some(shown.cursor));
        let modified = self.modified();
        let session = Session {
            path: self.path.clone(),
            preset: self.preset.as_ref().map(|(name, _)| (*name).to_owned()),
            modified,
            ..Session::new(settings.clone(), &self.document, step)
        };
        if let Err(error) = platform.keep(SESSION, &session.to_bytes())
            && !std::mem::replace(&mut self.kept.failed, true)
        {
            let message = Message::new("ui-error-keep").with("reason", reason(&error));
            self.notice = Some(Notice::Failed(self.words.message(&message)));
        }
        self.kept.due = None;
        self.kept.last = Some((self.document.clone(), settings, modified));
    }

    /// What is open, in the title of the window; a dot in front of unsaved edits.
    fn title(&mut self, ctx: &Context) {
        let mark = if self.modified() { "• " } else { "" };
        let title = format!("{mark}{} - Rasterscope", self.subtitle());
        if title != self.kept.title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.kept.title = title;
        }
    }
}
