//! The work beside the window: what is measured, one part after the other.

use super::{Measure, Page, Shown};
use crate::{
    platform::Platform,
    task::{Busy, News, Task},
};
use egui::Context;
use rasterscope_core::{message::Message, message::Value, stress::Family};
use rasterscope_figure::words::Words;
use rasterscope_measure::{
    Stopwatch,
    claims::{CLAIMS, Finding},
    growth::{self, Frame, Growing},
    race::{Row, STAGES, Stage},
};
use std::{
    sync::mpsc::{self, Receiver},
    time::Duration,
};

/// How much is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scope {
    /// What the page shows.
    Shown,
    /// All that the page could show.
    All,
}

/// What is measured at a time.
#[derive(Clone, Copy, Debug)]
enum Job {
    Heat(&'static Stage, Family),
    Claim(usize),
    Frame(Growing, u32),
}

/// What came out.
enum Part {
    Rows(Vec<Row>),
    Finding(usize, Finding),
    Frames(Vec<Frame>),
}

/// Work that goes on.
#[derive(Debug)]
pub(super) struct Work {
    task: Task<()>,
    parts: Receiver<Part>,
    jobs: Vec<Job>,
}

impl Job {
    /// Those of a page; what is shown comes first.
    fn all(shown: &Shown, scope: Scope) -> Vec<Self> {
        match (shown.page, scope) {
            (Page::Errors, Scope::Shown) => {
                let wanted = |family: &&Family| shown.family.is_none_or(|only| only == **family);
                let families = shown.stage().families.iter().filter(wanted);
                families.map(|family| Self::Heat(shown.stage(), *family)).collect()
            }
            (Page::Errors, Scope::All) => {
                let after = STAGES.iter().cycle().skip(shown.stage).take(STAGES.len());
                after
                    .flat_map(|stage| stage.families.iter().map(|family| Self::Heat(stage, *family)))
                    .collect()
            }
            (Page::Claims, Scope::Shown) => vec![Self::Claim(shown.claim)],
            (Page::Claims, Scope::All) => (0..CLAIMS.len()).map(Self::Claim).collect(),
            (Page::Growth, _) => {
                let mut frames: Vec<_> = growth::frames().collect();
                frames.sort_by_key(|(growing, _)| *growing != shown.growing);
                frames.into_iter().map(|(growing, factor)| Self::Frame(growing, factor)).collect()
            }
        }
    }

    fn measure(self, stopwatch: &Stopwatch<'_>) -> Option<Part> {
        Some(match self {
            Self::Heat(stage, family) => Part::Rows(stage.measure(family, stopwatch)?),
            Self::Claim(index) => Part::Finding(index, CLAIMS[index].examine(stopwatch)?),
            Self::Frame(growing, factor) => Part::Frames(growth::measure(growing, factor, stopwatch)?),
        })
    }

    fn name(self, words: &Words) -> String {
        let word = |kind: &str, name: &str| words.word(&format!("bench-{kind}-{name}"));
        match self {
            Self::Heat(stage, family) => {
                format!("{}, {}", word("stage", stage.name), word("family", family.name()))
            }
            Self::Claim(index) => word("claim", CLAIMS[index].name),
            Self::Frame(growing, factor) => format!("{}, × {factor}", word("growing", growing.name())),
        }
    }
}

impl Measure {
    /// Starts to measure what is shown, or everything of the page; what goes on already goes on.
    pub(crate) fn start(&mut self, scope: Scope, now: f64, platform: &mut dyn Platform) {
        if self.work.is_some() {
            return;
        }
        self.machine = Some(platform.machine());
        let jobs = Job::all(&self.shown, scope);
        let (send, parts) = mpsc::channel();
        let (clock, rounds, list) = (platform.clock(), self.rounds, jobs.clone());
        let task = Task::start(platform, now, move |progress| {
            for (done, job) in list.iter().enumerate() {
                let wanted = || progress.tell(done, list.len());
                let stopwatch = Stopwatch { rounds, now: &*clock, wanted: &wanted };
                // It was stopped, or the window has gone.
                let Some(part) = job.measure(&stopwatch) else { return };
                if send.send(part).is_err() {
                    return;
                }
            }
        });
        self.work = Some(Work { task, parts, jobs });
    }

    /// Ends the work; what it has measured stays.
    pub(crate) fn stop(&self) {
        if let Some(work) = &self.work {
            work.task.stop();
        }
    }

    /// Takes what was measured since the last time; the message of what went wrong, if something did.
    pub(super) fn take(&mut self, ctx: &Context, now: f64) -> Option<&'static str> {
        let work = self.work.take()?;
        // Asked before the parts are: none can come after the end.
        let news = work.task.news();
        while let Ok(part) = work.parts.try_recv() {
            self.keep(part);
        }
        match news {
            News::None => {
                ctx.request_repaint_after(Duration::from_secs_f64(work.task.wait(now)));
                self.work = Some(work);
                None
            }
            News::Done(()) => None,
            News::Lost => Some("ui-lost"),
        }
    }

    /// New results take the place of those of the same inputs.
    fn keep(&mut self, part: Part) {
        self.rev += 1;
        match part {
            Part::Rows(rows) => {
                let Some(Row { stage, family, .. }) = rows.first().cloned() else { return };
                self.rows.retain(|row| row.stage != stage || row.family != family);
                self.rows.extend(rows);
            }
            Part::Finding(index, finding) => self.findings[index] = Some(finding),
            Part::Frames(frames) => {
                let Some(Frame { growing, factor, .. }) = frames.first().cloned() else { return };
                self.frames.retain(|frame| frame.growing != growing || frame.factor != factor);
                self.frames.extend(frames);
                self.frames.sort_by_key(|frame| frame.factor);
            }
        }
    }

    /// Whether something is being measured.
    pub(crate) fn is_busy(&self) -> bool {
        self.work.is_some()
    }

    /// What is being measured, and how far it is.
    pub(super) fn busy(&self, now: f64, words: &Words) -> Option<Busy> {
        let work = self.work.as_ref()?;
        let [done, all] = work.task.progress(now)?;
        let name = work.jobs.get(done).map_or(String::new(), |job| job.name(words));
        let message = Message::new("measure-busy")
            .with("number", Value::count(done + 1))
            .with("all", Value::count(all))
            .with("what", Value::text(name));
        Some(Busy { text: words.message(&message), part: done as f32 / all.max(1) as f32, stoppable: true })
    }
}
