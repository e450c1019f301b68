//! The run as an animated picture, made beside the window and written when it is whole.

use crate::{
    app::App,
    export::PIXELS_PER_POINT,
    platform::Platform,
    shell::{canvas::INSET, notice::Notice},
    task::{Busy, News, Task},
};
use egui::Context;
use rasterscope_core::{
    explain::{Mark, View},
    labs as core_labs,
    message::{Message, Value},
    replay::{Budget, Playback},
};
use rasterscope_figure::{
    animation,
    layout::{self, Placement},
    space,
    words::Words,
};
use std::time::Duration;

/// The message of an animated picture that was stopped.
const STOPPED: &str = "ui-film-stopped";

/// An animated picture that is being made.
#[derive(Debug)]
pub(crate) struct Film {
    path: String,
    task: Task<Result<Done, Message>>,
}

/// The file's bytes, and how many frames they hold.
type Done = (Vec<u8>, usize);

impl App {
    /// Starts to make the animated picture of the run as it stands on the canvas, in steps of the
    /// chosen size, or in the finest that are few enough.
    pub(crate) fn start_film(&mut self, ctx: &Context, path: &str, platform: &mut dyn Platform) {
        let ending = path.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        let wrong = match (ending.as_deref(), &self.film) {
            (_, Some(_)) => Some("ui-film-busy"),
            (Some("png" | "apng"), None) => None,
            _ => Some("ui-film-ending"),
        };
        if let Some(wrong) = wrong {
            self.notice = Some(Notice::Failed(self.words.word(wrong)));
            return;
        }
        let Some(canvas) = self.canvas.size() else {
            self.notice = Some(Notice::Failed(self.words.word("ui-no-picture")));
            return;
        };
        let (scene, level) = (self.document.scene.clone(), self.view.level);
        let (theme, language) = (self.look.theme, self.words.language());
        let delay = (1000.0 / self.view.speed).clamp(20.0, 60_000.0) as u16;
        // Where the run stands on the canvas the user may have zoomed in; elsewhere each drawing fits.
        let placed = self.run.shown().map(|shown| shown.view).zip(self.canvas.placement_of_run());
        let camera = self.canvas.camera();
        let last = self.last_picture();
        let work = move |progress: &crate::task::Progress| {
            let mut run = core_labs::play(&scene, Budget::default())?;
            let film =
                animation::Film::new(&*run, Some(level)).or_else(|_| animation::Film::new(&*run, None))?;
            let words = Words::new(language);
            let size = [canvas.x, canvas.y];
            let lay_out = |marks: &[Mark], view: &View| {
                let placement = match placed {
                    Some((same, placement)) if same == *view => placement,
                    _ => Placement::fit(view, size, INSET),
                };
                layout::draw(marks, view, &placement, size, theme, &words)
            };
            let draw = |run: &dyn Playback| match &last {
                Some((marks, view)) if run.cursor() == run.len() => lay_out(marks, view),
                _ => {
                    let marks = run.marks();
                    lay_out(&space::seen(&marks, run.vantage().as_ref(), camera.as_ref()), &run.view())
                }
            };
            let frames = film.steps.len();
            let watch = |done| progress.tell(done, frames);
            film.record(&mut *run, delay, PIXELS_PER_POINT, draw, watch)
                .map(|bytes| (bytes, frames))
                .ok_or_else(|| Message::new(STOPPED))
        };
        let task = Task::start(platform, ctx.input(|input| input.time), work);
        self.film = Some(Film { path: path.to_owned(), task });
        self.notice = None;
    }

    /// What the overview shows at the end, in place of the run.
    fn last_picture(&mut self) -> Option<(Vec<Mark>, View)> {
        if self.labs[self.lab()].name() != "pipeline" {
            return None;
        }
        let picture = self.overview.picture(&mut self.view)?;
        (picture.maker == crate::shell::canvas::Maker::Image).then(|| (picture.marks.clone(), picture.view))
    }

    /// Stops what the timeline shows the progress of.
    pub(crate) fn stop(&mut self) {
        self.skips.stop();
        if self.measure.open {
            self.measure.stop();
        } else if self.opening.take().is_none()
            && let Some(film) = &self.film
        {
            film.task.stop();
        }
    }

    /// Writes the animated picture if it is made; else asks for the frame that shows how far it is.
    pub(crate) fn end_film(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        let Some(film) = self.film.take() else { return };
        let done = match film.task.news() {
            News::None => {
                let wait = film.task.wait(ctx.input(|input| input.time));
                ctx.request_repaint_after(Duration::from_secs_f64(wait));
                self.film = Some(film);
                return;
            }
            News::Done(done) => done,
            News::Lost => Err(Message::new("ui-lost")),
        };
        let path = film.path;
        match done {
            Ok((bytes, frames)) => {
                let written = platform.write(&path, &bytes);
                let message = Message::new("ui-film-saved").with("path", Value::text(&path));
                self.written(&path, &message.with("frames", frames), written);
            }
            // Who stopped it knows.
            Err(problem) if problem.id == STOPPED => {
                self.notice = Some(Notice::Done(self.words.message(&problem)));
            }
            Err(problem) => self.notice = Some(Notice::Failed(self.words.message(&problem))),
        }
    }

    /// What the timeline shows of it.
    pub(crate) fn filming(&self, now: f64) -> Option<Busy> {
        let [done, all] = self.film.as_ref()?.task.progress(now)?;
        let message = Message::new("ui-film-frame").with("number", done + 1).with("all", all);
        Some(Busy {
            text: self.words.message(&message),
            part: done as f32 / all.max(1) as f32,
            stoppable: true,
        })
    }
}
