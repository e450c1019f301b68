//! What each skip leaves out of the image, as bars; when asked, how long a frame takes without it, and whether
//! its bytes stay.

use crate::{
    app::App,
    document::Scenery,
    face::{Command, Face},
    measure::{Format, write},
    overview::Overview,
    paint,
    platform::Platform,
    shell::notice::Notice,
    task::{Busy, News, Task},
    theme::Text,
};
use egui::{Context, Role as Part, ScrollArea, Sense, Ui, UiBuilder, WidgetInfo, vec2};
use rasterscope_core::{
    explain::Role,
    message::{Message, Value},
    scene::Scene,
};
use rasterscope_figure::figure::Figure;
use rasterscope_measure::{
    Machine, Stopwatch,
    skips::{
        Savings,
        picture::{self, Bar},
    },
    tables::skip_rows,
};
use std::{cell::Cell, time::Duration};

/// How often each setting draws the image: enough for a median, in a second or two.
const ROUNDS: u32 = 9;

/// What was measured, and what is being measured.
#[derive(Debug, Default)]
pub(crate) struct Measured {
    task: Option<(Scene, Task<Option<Savings>>)>,
    /// Of which scene.
    done: Option<(Scene, Savings)>,
    /// How wide the bars were drawn last, in points.
    width: f32,
}

impl Measured {
    /// Ends what is being measured.
    pub(crate) fn stop(&self) {
        self.task.iter().for_each(|(_, task)| task.stop());
    }
}

impl App {
    /// Shows the skips and starts to measure what they save, beside the window; what goes on already goes on.
    pub(crate) fn measure_skips(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        self.open_lab("pipeline");
        self.view.scenery = Scenery::Skips;
        if self.skips.task.is_some() {
            return;
        }
        let (now, clock) = (ctx.input(|input| input.time), platform.clock());
        let scene = self.document.scene.clone();
        let given = scene.clone();
        let task = Task::start(platform, now, move |progress| {
            let done = Cell::new(0);
            let wanted = || progress.tell(done.replace(done.get() + 1), Savings::runs(ROUNDS));
            let stopwatch = Stopwatch { rounds: ROUNDS, now: &*clock, wanted: &wanted };
            Savings::measure(&given, &Overview::pipeline, &stopwatch)
        });
        self.skips.task = Some((scene, task));
    }

    /// Takes what was measured; else asks for the frame that shows how far it is.
    pub(crate) fn end_skips(&mut self, ctx: &Context) {
        let Some((scene, task)) = self.skips.task.take() else { return };
        match task.news() {
            News::None => {
                let wait = task.wait(ctx.input(|input| input.time));
                ctx.request_repaint_after(Duration::from_secs_f64(wait));
                self.skips.task = Some((scene, task));
            }
            // Who stopped it knows.
            News::Done(savings) => self.skips.done = savings.map(|savings| (scene, savings)),
            News::Lost => self.notice = Some(Notice::Failed(self.words.word("ui-lost"))),
        }
    }

    /// How far the measurement is.
    pub(crate) fn measuring_skips(&self, now: f64) -> Option<Busy> {
        let (_, task) = self.skips.task.as_ref()?;
        let [done, all] = task.progress(now)?;
        let text = self.words.word("measure-skips-busy");
        Some(Busy { text, part: done as f32 / all.max(1) as f32, stoppable: true })
    }

    /// What was measured of the scene as it is.
    fn savings(&self) -> Option<&Savings> {
        let (scene, savings) = self.skips.done.as_ref()?;
        scene.same_picture(&self.document.scene).then_some(savings)
    }

    /// Whether the bars stand where the image would.
    pub(crate) fn shows_skips(&self) -> bool {
        let at_the_end = self.run.shown().is_none_or(|shown| shown.cursor == shown.len);
        let open = self.view.scenery == Scenery::Skips && self.labs[self.lab()].name() == "pipeline";
        open && at_the_end && !self.split()
    }

    /// The bars, if there is an image.
    fn bars(&self) -> Option<Vec<Bar>> {
        let (stats, scene) = self.overview.counted()?;
        Some(picture::bars(self.savings(), stats, scene))
    }

    /// The bars as they are on the screen.
    pub(crate) fn skips_picture(&self) -> Option<Figure> {
        Some(picture::draw(&self.bars()?, self.skips.width, self.look.theme, &self.words))
    }

    /// What the bars show, for other programs; empty if there is no image.
    pub(crate) fn skips_table(&self, format: Format, machine: &Machine) -> String {
        let Some(bars) = self.bars() else { return String::new() };
        let rounds = if self.savings().is_some() { ROUNDS } else { 0 };
        write(format, machine, rounds, &skip_rows(&bars, &self.words))
    }

    /// Shows the bars.
    pub(crate) fn skips_panel(&mut self, ui: &mut Ui, face: &Face<'_>) {
        let Some(bars) = self.bars() else { return };
        let savings = self.savings();
        let (said, role) = match savings {
            None => (face.say("measure-skips-counts"), None),
            Some(savings) if savings.is_proved() => {
                let times = Value::text(format!("{:.2}", savings.ratio()));
                let message = Message::new("measure-skips-done").with("times", times);
                (face.words.message(&message), None)
            }
            Some(_) => (face.say("measure-skips-wrong"), Some(Role::Rejected)),
        };
        let (textures, width) = (&mut self.textures, &mut self.skips.width);
        let room = ui.max_rect().shrink2(vec2(14.0, 8.0));
        ui.scope_builder(UiBuilder::new().max_rect(room), |ui| {
            if ui.button(face.rich(face.say("measure-skips-ask"), Text::Label)).clicked() {
                face.ask(Command::MeasureSkips);
            }
            let said = face.rich(said, Text::Sentence);
            ui.label(match role {
                Some(role) => said.color(face.look.role(role)),
                None => said,
            });
            ScrollArea::vertical().id_salt("skips").auto_shrink(false).show(ui, |ui| {
                *width = ui.available_width();
                let figure = picture::draw(&bars, *width, face.look.theme, face.words);
                let (rect, response) = ui.allocate_exact_size(figure.size.into(), Sense::hover());
                let name = face.say("ui-scenery-skips");
                response.widget_info(|| WidgetInfo::labeled(Part::Image, true, &name));
                paint::figure(ui.painter(), textures, rect.min, &figure);
            });
        });
    }
}
