//! Brings the image and the run up to date with the document: at once, or beside the window where
//! that would take longer than a frame. Until then the old ones stay on the screen.

use crate::{
    app::App,
    overview::{Laid, Overview},
    platform::Platform,
    run::Run,
    task::{Busy, News, Progress, Task},
};
use egui::Context;
use rasterscope_core::{
    compare::{self, Side},
    labs as core_labs,
    message::Message,
    pipeline::{Overlay, Pipeline, Skips, out_of_range},
    replay::{Budget, Playback},
    scene::Scene,
};
use std::time::Duration;

/// Most triangles, and pixels divided by [`PIXELS`], that are worked on between two frames: some
/// 20 milliseconds.
const AT_ONCE: usize = 20_000;
/// So many pixels take as long as a triangle.
const PIXELS: usize = 64;

/// How far the screen is behind the document.
#[derive(Debug, Default)]
pub(crate) struct Evaluation {
    /// The scene that the run is of, and why either side does not run.
    ran: Option<(Scene, [Option<Message>; 2])>,
    /// What of that scene cannot be drawn as it is.
    beyond: Option<Message>,
    /// The step to go to once there is a run.
    step: Option<usize>,
    pending: Option<Pending>,
}

/// What is computed beside the window.
#[derive(Debug)]
struct Pending {
    scene: Scene,
    skips: Skips,
    /// Whether the image is computed, and not only the run or what lies on it.
    image: bool,
    /// What is laid on the image.
    overlay: Overlay,
    /// `None` if another document was opened meanwhile.
    wanted: Option<()>,
    task: Task<Evaluated>,
}

/// What came of it.
struct Evaluated {
    pipeline: Option<Pipeline>,
    laid: Option<Laid>,
    run: Option<Played>,
}

/// The runs of a scene: side B only where it compares, and side A runs.
struct Played {
    a: Result<Box<dyn Playback>, Message>,
    b: Option<Result<Box<dyn Playback>, Message>>,
    /// How many were started for this.
    fresh: usize,
}

impl Played {
    /// Starts what there is to run of a scene, or goes on with `a`.
    fn start(scene: &Scene, a: Option<Box<dyn Playback>>) -> Self {
        let kept = usize::from(a.is_some());
        let a = a.map_or_else(|| core_labs::play(scene, Budget::default()), Ok);
        let other = compare::side_b(scene).filter(|_| a.is_ok());
        let b = other.map(|other| core_labs::play(&other, Budget::default()));
        Self { fresh: 1 - kept + usize::from(b.is_some()), a, b }
    }
}

impl App {
    /// Brings everything up to date, or has it brought; asks for the frame that shows how far it is.
    pub(crate) fn update(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        let now = ctx.input(|input| input.time);
        self.arrived();
        if self.overview.edit_goes_on() && self.history.before().is_none() && !self.behind().image {
            self.overview.edit_is_over();
        }
        if !self.update_at_once() {
            self.evaluate(now, platform);
        }
        if let Some(pending) = &self.evaluation.pending {
            ctx.request_repaint_after(Duration::from_secs_f64(pending.task.wait(now)));
        }
    }

    /// Brings everything up to date; `false` if that would take too long for a frame.
    fn update_at_once(&mut self) -> bool {
        let behind = self.behind();
        if self.evaluation.pending.is_some() || behind.work(&self.document.scene) > AT_ONCE {
            return false;
        }
        let scene = &self.document.scene;
        if behind.image {
            self.overview.edited(self.history.before().is_some());
            self.overview.update(scene, self.view.skips);
        }
        if behind.laid {
            self.overview.lay(scene, self.view.overlay);
        }
        if behind.run {
            // What side A is compared with changes nothing of it.
            let same = self.evaluation.ran.as_ref().is_some_and(|(old, _)| old.same_side_a(scene));
            let kept = same.then(|| self.run.take_a()).flatten();
            let played = Played::start(scene, kept);
            self.evaluation.take_run(scene.clone(), played, &mut self.run);
        }
        true
    }

    fn behind(&self) -> Behind {
        let scene = &self.document.scene;
        let image = !self.overview.is_of(scene, self.view.skips);
        Behind {
            image,
            laid: self.overlay_wanted() && (image || !self.overview.has_laid(self.view.overlay)),
            run: self.evaluation.ran.as_ref().is_none_or(|(old, _)| old != scene),
        }
    }

    /// Whether something lies on the image that is on the screen.
    fn overlay_wanted(&self) -> bool {
        self.view.overlay != Overlay::None && self.document.input().name() == "pipeline"
    }

    /// Starts what takes longer, one at a time: the newest document follows.
    fn evaluate(&mut self, now: f64, platform: &mut dyn Platform) {
        if self.evaluation.pending.is_some() {
            return;
        }
        let behind = self.behind();
        let (scene, skips) = (self.document.scene.clone(), self.view.skips);
        if behind.image {
            self.overview.edited(self.history.before().is_some());
        }
        let lent = if behind.image || behind.laid { self.overview.lend() } else { None };
        let (given, image) = (scene.clone(), behind.image);
        let overlay = self.view.overlay;
        let wanted = behind.laid.then(|| self.overview.before().cloned());
        let task = Task::start(platform, now, move |progress: &Progress| {
            let all = usize::from(lent.is_some()) + usize::from(behind.run);
            progress.tell(0, all);
            let pipeline = lent.map(|mut pipeline| {
                if image {
                    pipeline.update(&given, &skips);
                }
                pipeline
            });
            let laid = pipeline
                .as_ref()
                .zip(wanted)
                .map(|(pipeline, before)| Laid::new(overlay, &given, pipeline.outputs(), before.as_ref()));
            progress.tell(usize::from(pipeline.is_some()), all);
            let run = behind.run.then(|| Played::start(&given, None));
            Evaluated { pipeline, laid, run }
        });
        self.evaluation.pending = Some(Pending { scene, skips, image, overlay, wanted: Some(()), task });
    }

    /// Takes what was computed beside the window.
    fn arrived(&mut self) {
        let Some(pending) = self.evaluation.pending.take() else { return };
        let Evaluated { pipeline, laid, run } = match pending.task.news() {
            News::None => {
                self.evaluation.pending = Some(pending);
                return;
            }
            News::Done(done) => done,
            News::Lost => {
                self.overview.forget();
                let run = Some(Played { a: Err(Message::new("ui-lost")), b: None, fresh: 0 });
                Evaluated { pipeline: Some(Overview::pipeline()), laid: None, run }
            }
        };
        if let Some(pipeline) = pipeline {
            self.overview.give_back(pipeline, &pending.scene, pending.skips);
            laid.into_iter().for_each(|laid| self.overview.take_laid(pending.overlay, laid));
        }
        // Of another document than the one that is open only the pipeline is of use.
        if let (Some(played), Some(())) = (run, pending.wanted) {
            self.evaluation.take_run(pending.scene, played, &mut self.run);
        }
    }

    /// Forgets the run: another document is open. Once it runs, the cursor goes to `step`.
    pub(crate) fn start_anew(&mut self, step: Option<usize>) {
        self.run.clear();
        self.evaluation.ran = None;
        self.evaluation.step = step;
        self.overview.forget_edits();
        if let Some(pending) = &mut self.evaluation.pending {
            pending.wanted = None;
        }
        self.update_at_once();
    }

    /// Why nothing runs, if so.
    pub(crate) fn problem(&self) -> Option<String> {
        self.problem_of(Side::A)
    }

    /// Why a side does not run, if so.
    pub(crate) fn problem_of(&self, side: Side) -> Option<String> {
        let (_, problems) = self.evaluation.ran.as_ref()?;
        problems[side as usize].as_ref().map(|problem| self.words.message(problem))
    }

    /// What the timeline shows of work that goes on.
    pub(crate) fn busy(&self, ctx: &Context) -> Option<Busy> {
        let now = ctx.input(|input| input.time);
        let opening = self.busy_opening(now);
        if opening.is_some() {
            return opening;
        }
        let pending = self.evaluation.pending.as_ref();
        let Some((pending, [done, all])) = pending.and_then(|each| Some((each, each.task.progress(now)?)))
        else {
            return self.measuring_skips(now).or_else(|| self.filming(now));
        };
        let text = self.words.word(match (done, pending.image) {
            (0, true) => "ui-busy-image",
            (0, false) if pending.overlay != Overlay::None => "ui-busy-overlay",
            _ => "ui-busy-run",
        });
        Some(Busy { text, part: (done as f32 + 0.5) / all.max(1) as f32, stoppable: false })
    }
}

impl Evaluation {
    fn take_run(&mut self, scene: Scene, played: Played, run: &mut Run) {
        let Played { a, b, fresh } = played;
        let (b, problem_b) = match b {
            Some(Ok(b)) => (Some(b), None),
            Some(Err(problem)) => (None, Some(problem)),
            None => (None, None),
        };
        let problem = match a {
            Ok(a) => {
                run.set(a, b, fresh);
                if let Some(step) = self.step.take() {
                    run.seek(step);
                }
                None
            }
            Err(problem) => {
                run.clear();
                Some(problem)
            }
        };
        self.beyond = out_of_range(&scene);
        self.ran = Some((scene, [problem, problem_b]));
    }

    /// What of the scene cannot be drawn as it is: a product leaves the range of binary32.
    pub(crate) fn beyond(&self) -> Option<&Message> {
        self.beyond.as_ref()
    }
}

/// What has to be computed.
#[derive(Clone, Copy, Debug)]
struct Behind {
    image: bool,
    laid: bool,
    run: bool,
}

impl Behind {
    /// How much work that is, in triangles.
    fn work(self, scene: &Scene) -> usize {
        let meshes = scene.draws.iter().filter_map(|draw| draw.geometry.mesh());
        let triangles: usize = meshes.map(|mesh| mesh.triangles.len()).sum();
        let pixels = if triangles == 0 { 0 } else { scene.size.iter().product::<u32>() as usize };
        let once = triangles + pixels / PIXELS;
        let run = self.run && scene.lab.as_ref().is_none_or(|lab| lab.input.is_of_scene());
        let sides = 1 + usize::from(scene.compared().is_some());
        once * (usize::from(self.image) + usize::from(self.laid) + sides * usize::from(run))
    }
}
