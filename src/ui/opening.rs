//! Files are read and parsed beside the window: a large model takes seconds.

use crate::{
    app::App,
    commands::unreadable,
    document::Document,
    face::Command,
    files,
    platform::{Platform, Reader},
    session::Session,
    shell::notice::Notice,
    task::{Busy, News, Task},
};
use egui::{Context, ViewportCommand};
use rasterscope_core::{
    message::{Message, Value},
    scene::{self, Scene},
};
use std::time::Duration;

/// A file or a session that is being opened.
#[derive(Debug)]
pub(crate) struct Opening {
    what: What,
    when: When,
    /// The document that was open: what is edited meanwhile is not taken away.
    before: Document,
    task: Task<Result<Opened, Message>>,
}

/// What is opened.
#[derive(Debug)]
enum What {
    File(String),
    /// With the file that was asked for and could not be opened before it.
    Session(Box<Session>, Option<String>),
}

/// When it was asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum When {
    /// By the program's start: it is no edit, and nothing is shown before it for a while.
    First,
    /// By the user.
    Later,
}

/// What came of it.
enum Opened {
    Scene(Scene),
    Preset(&'static str),
    Session(Document, Option<usize>),
}

impl App {
    /// Opens a scene or a model, or the preset of that name where there is no such file. If that
    /// fails the document stays as it is.
    pub(crate) fn open(&mut self, ctx: &Context, path: &str, when: When, platform: &mut dyn Platform) {
        let (reader, given) = (platform.reader(), path.to_owned());
        self.begin(ctx, What::File(path.to_owned()), when, platform, move || read(&given, reader));
    }

    /// Opens what a session was about; `asked` is a file that has to wait for the user's word on it.
    pub(crate) fn take_up(
        &mut self,
        ctx: &Context,
        (session, asked): (Session, Option<&str>),
        when: When,
        platform: &mut dyn Platform,
    ) {
        let (mut reader, given) = (platform.reader(), session.clone());
        let what = What::Session(Box::new(session), asked.map(str::to_owned));
        self.begin(ctx, what, when, platform, move || {
            let opened = given.document(&mut |file| reader(file).ok())?;
            Ok(Opened::Session(opened.0, opened.1))
        });
    }

    fn begin(
        &mut self,
        ctx: &Context,
        what: What,
        when: When,
        platform: &mut dyn Platform,
        work: impl FnOnce() -> Result<Opened, Message> + Send + 'static,
    ) {
        let task = Task::start(platform, ctx.input(|input| input.time), move |_| work());
        self.opening = Some(Opening { what, when, before: self.document.clone(), task });
        self.end_opening(ctx, platform);
    }

    /// Takes what was opened; else asks for the frame that shows how far it is.
    pub(crate) fn end_opening(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        let Some(opening) = self.opening.take() else { return };
        let opened = match opening.task.news() {
            News::None => {
                let wait = opening.task.wait(ctx.input(|input| input.time));
                ctx.request_repaint_after(Duration::from_secs_f64(wait));
                self.opening = Some(opening);
                return;
            }
            News::Done(opened) => opened,
            News::Lost => Err(Message::new("ui-lost")),
        };
        match (opened, opening.what) {
            (Err(problem), what) => {
                if let (What::Session(session, _), When::First) = (what, opening.when) {
                    self.set_aside(&session, platform);
                }
                self.notice = Some(Notice::Failed(self.words.message(&problem)));
            }
            (Ok(_), What::File(path)) if self.document != opening.before && self.modified() => {
                self.notice = Some(Notice::Unsaved(Box::new(Command::Open(path))));
            }
            (Ok(Opened::Preset(name)), _) => self.open_preset(name),
            (Ok(Opened::Scene(scene)), What::File(path)) => {
                self.replace(scene);
                self.preset = None;
                self.path = Some(path);
            }
            (Ok(Opened::Session(document, step)), What::Session(session, asked)) => {
                self.take_session(*session, document, step);
                if let Some(file) = asked {
                    self.notice = Some(Notice::Unsaved(Box::new(Command::Open(file))));
                }
                if opening.when == When::Later {
                    // It was set aside, and is on the screen now.
                    self.forget(platform);
                }
            }
            // Files give scenes and presets, sessions give sessions.
            (Ok(Opened::Scene(_)), What::Session(..)) | (Ok(Opened::Session(..)), What::File(_)) => {}
        }
        if opening.when == When::First {
            self.history = Default::default();
            self.offer_aside(platform);
        }
        if self.quitting {
            ctx.send_viewport_cmd(ViewportCommand::Close);
        }
    }

    /// Whether the program has just been started to open something that is not there yet.
    pub(crate) fn only_opening(&self, ctx: &Context) -> bool {
        let now = ctx.input(|input| input.time);
        self.opening
            .as_ref()
            .is_some_and(|opening| opening.when == When::First && opening.task.progress(now).is_none())
    }

    /// What the timeline shows of it.
    pub(crate) fn busy_opening(&self, now: f64) -> Option<Busy> {
        let opening = self.opening.as_ref()?;
        opening.task.progress(now)?;
        let path = match &opening.what {
            What::File(path) => path,
            What::Session(session, _) => session.path.as_deref().unwrap_or_default(),
        };
        let message = Message::new("ui-busy-open").with("name", Value::text(files::split(path)[1]));
        Some(Busy { text: self.words.message(&message), part: 0.5, stoppable: true })
    }
}

/// The scene of a file, or the preset of its name.
fn read(path: &str, mut reader: Reader) -> Result<Opened, Message> {
    let read = reader(path);
    if let (Err(_), Some(preset)) = (&read, scene::preset(path)) {
        return Ok(Opened::Preset(preset.name));
    }
    let bytes = read.map_err(|error| unreadable("ui-error-read", path, &error))?;
    files::open(path, &bytes, &mut |file| reader(file).ok()).map(Opened::Scene)
}
