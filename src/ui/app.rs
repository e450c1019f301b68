//! The window's contents as one value: document, view, run, and one frame of it.

use crate::{
    document::{Document, ViewState},
    evaluation::Evaluation,
    face::Command,
    film::Film,
    keeping::Kept,
    labs::{self, Lab},
    link::Links,
    measure::Measure,
    opening::Opening,
    overview::Overview,
    paint::Textures,
    platform::{Platform, Purpose},
    presets::{self, Names, PresetInfo},
    run::Run,
    shell::{
        canvas::Canvas,
        inspector::Digest,
        notice::{Beyond, Notice},
    },
    skips::Measured,
    theme::{self, Look},
};
use egui::{Context, Ui};
use rasterscope_core::{
    history::History,
    labs::{self as core_labs, LabInput},
    scene::Scene,
};
use rasterscope_figure::words::Words;
use std::{cell::RefCell, rc::Rc};

/// The window's contents.
#[derive(Debug)]
pub struct App {
    pub(crate) document: Document,
    pub(crate) history: History<Document>,
    pub(crate) view: ViewState,
    pub(crate) run: Run,
    pub(crate) evaluation: Evaluation,
    pub(crate) digest: Option<Digest>,
    pub(crate) overview: Overview,
    /// What the skips save, as measured.
    pub(crate) skips: Measured,
    pub(crate) canvas: Canvas,
    /// The canvas of side B.
    pub(crate) beside: Canvas,
    pub(crate) textures: Textures,
    pub(crate) labs: Vec<Box<dyn Lab>>,
    pub(crate) presets: Vec<PresetInfo>,
    pub(crate) names: Names,
    /// The preset that was opened, and what it was; no longer chosen once something is edited.
    pub(crate) preset: Option<(&'static str, Scene)>,
    pub(crate) notice: Option<Notice>,
    /// What the pointer is on.
    pub(crate) links: Links,
    /// What of the scene cannot be drawn as it is.
    beyond: Beyond,
    /// The file that is being opened.
    pub(crate) opening: Option<Opening>,
    /// The animated picture that is being made.
    pub(crate) film: Option<Film>,
    /// What is measured.
    pub(crate) measure: Measure,
    /// Where the document came from, and what was last written there.
    pub(crate) path: Option<String>,
    /// The document as it was opened or saved; `None`: its edits are in no file.
    pub(crate) clean: Option<Document>,
    /// Whether nothing was kept, so that this is the first start, and bigger text was not offered.
    pub(crate) first: bool,
    /// What was kept for the next start.
    pub(crate) kept: Kept,
    /// What to do once the document is saved.
    pub(crate) then: Option<Box<Command>>,
    /// Whether the window may close without asking.
    pub(crate) quitting: bool,
    pub(crate) words: Rc<Words>,
    pub(crate) look: Rc<Look>,
}

impl App {
    /// The window with the default scene.
    pub fn new(ctx: &Context) -> Self {
        ctx.set_fonts(theme::fonts());
        // The text size has keys of its own, which say so in the palette.
        ctx.options_mut(|options| options.zoom_with_keyboard = false);
        let words = Rc::new(Words::default());
        let names = Names::new(&words);
        let view = ViewState::default();
        let look = Rc::new(Look::new(view.theme));
        look.apply(ctx);
        let mut app = Self {
            document: Document::new(Scene::empty([36, 24])),
            history: History::default(),
            view,
            run: Run::default(),
            evaluation: Evaluation::default(),
            digest: None,
            overview: Overview::default(),
            skips: Measured::default(),
            canvas: Canvas::default(),
            beside: Canvas::default(),
            textures: Textures::default(),
            labs: labs::registry(),
            presets: presets::all(&names, &words),
            names,
            preset: None,
            notice: None,
            links: Links::default(),
            beyond: Beyond::default(),
            opening: None,
            film: None,
            measure: Measure::default(),
            path: None,
            clean: None,
            first: false,
            kept: Kept::default(),
            then: None,
            quitting: false,
            words,
            look,
        };
        if let Some(first) = app.presets.first() {
            app.open_preset(first.name);
            // What the window starts with is no edit.
            app.history = History::default();
        }
        app
    }

    /// One frame, always in this order: keys, edits, run, panels, commands.
    pub fn ui(&mut self, ui: &mut Ui, platform: &mut dyn Platform) {
        let ctx = ui.ctx().clone();
        let mut commands: Vec<Command> = ctx
            .input(|input| input.raw.dropped_files.clone())
            .into_iter()
            .map(|file| Command::Open(file.path().to_string_lossy().into_owned()))
            .collect();
        commands.extend(platform.chosen().map(|(purpose, path)| match purpose {
            Purpose::Open => Command::Open(path),
            Purpose::Save => Command::SaveAs(path),
            Purpose::Picture => Command::Picture(path),
            Purpose::Film => Command::Film(path),
        }));
        let mut keys = crate::shell::keys::pressed(&ctx, &self.handles());
        // Where no lab is seen, no key steps it.
        keys.retain(|command| !self.measure.open || !command.is_of_lab());
        commands.extend(keys);
        self.execute(&ctx, commands, platform);
        self.end_opening(&ctx, platform);
        self.end_film(&ctx, platform);
        self.end_skips(&ctx);
        self.end_measuring(&ctx);
        self.play(&ctx);
        if self.only_opening(&ctx) {
            ui.painter().rect_filled(ui.max_rect(), 0, self.look.panel);
            return;
        }
        self.lay_out_sides();
        self.update(&ctx, platform);
        self.offer(&ctx);
        self.beyond.tell(self.evaluation.beyond(), &mut self.notice, &self.words);
        self.view.aids.apply(&ctx);
        self.view.recent.note(self.labs[self.lab()].name());

        self.history.begin(&self.document);
        let commands = RefCell::default();
        self.panels(ui, &commands);
        let gesture = ctx.dragged_id().is_some() || ctx.text_edit_focused();
        let edited = self.history.before().is_some_and(|before| *before != self.document);
        self.history.end(&self.document, gesture);
        crate::shell::keys::keep_arrows(&ctx);

        let commands = commands.into_inner();
        if self.links.end_frame() || edited || !commands.is_empty() {
            ctx.request_repaint();
        }
        self.execute(&ctx, commands, platform);
        self.textures.end_frame();
        self.closing(&ctx);
        self.autosave(&ctx, platform);
    }

    /// Takes the steps that are due, and asks for the frame in which the next one is.
    fn play(&mut self, ctx: &Context) {
        let Some(due) = self.view.due else { return };
        let now = ctx.input(|input| input.time);
        let pause = 1.0 / f64::from(self.view.speed);
        if now >= due {
            self.run.next(self.view.level);
            self.view.due = Some((due + pause).max(now));
        }
        match self.run.shown() {
            Some(shown) if shown.cursor < shown.len => {
                let wait = (self.view.due.unwrap_or(now) - now).max(0.001);
                ctx.request_repaint_after(std::time::Duration::from_secs_f64(wait));
            }
            _ => self.view.due = None,
        }
    }

    /// The open lab.
    pub(crate) fn lab(&self) -> usize {
        let name = self.document.input().name();
        self.labs.iter().position(|lab| lab.name() == name).unwrap_or(0)
    }

    /// Opens a lab of the registry; not an edit, so undo does not close it.
    pub(crate) fn open_lab(&mut self, name: &'static str) {
        self.document.open_lab(name, || core_labs::default_input(name).unwrap_or(LabInput::PIPELINE));
        self.view.due = None;
        self.canvas.fit();
        self.view.outside = None;
    }

    /// Replaces the document; can be undone.
    pub(crate) fn replace(&mut self, scene: Scene) {
        let step = scene.lab.as_ref().and_then(|lab| lab.step);
        self.take(Document::new(scene), step);
        self.clean = Some(self.document.clone());
    }

    /// Takes another document, at a step.
    pub(crate) fn take(&mut self, document: Document, step: Option<usize>) {
        self.history.begin(&self.document);
        self.document = document;
        self.history.end(&self.document, false);
        self.view.due = None;
        self.view.pixel = None;
        self.view.part = None;
        self.notice = None;
        self.start_anew(step);
        self.canvas.fit();
        self.view.outside = None;
    }
}
