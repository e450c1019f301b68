//! Work beside the window: the platform does it, the window asks once a frame how far it is.

use crate::platform::Platform;
use std::sync::{
    Arc,
    atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed},
    mpsc::{self, Receiver, TryRecvError},
};

/// What shorter work does not show, in seconds.
const PATIENCE: f64 = 0.2;
/// How often progress is shown, in seconds.
const LOOK: f64 = 0.1;

/// What the work and the window tell each other.
#[derive(Debug, Default)]
pub(crate) struct Progress {
    done: AtomicUsize,
    all: AtomicUsize,
    stopped: AtomicBool,
}

impl Progress {
    /// Says how far the work is; `false` if it is no longer wanted.
    pub(crate) fn tell(&self, done: usize, all: usize) -> bool {
        self.done.store(done, Relaxed);
        self.all.store(all, Relaxed);
        !self.stopped.load(Relaxed)
    }
}

/// Work that was started and has not been heard of since.
pub(crate) struct Task<T> {
    progress: Arc<Progress>,
    answer: Receiver<T>,
    /// When it was started, in egui's seconds.
    since: f64,
}

impl<T> std::fmt::Debug for Task<T> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Task").field("progress", &self.progress).finish_non_exhaustive()
    }
}

/// What is heard of a task.
pub(crate) enum News<T> {
    /// It goes on.
    None,
    /// It is done.
    Done(T),
    /// It ended without an answer: it has a fault.
    Lost,
}

/// What the timeline shows of a task.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Busy {
    /// What goes on.
    pub(crate) text: String,
    /// How much of it is done, from 0 to 1.
    pub(crate) part: f32,
    /// Whether it can be stopped.
    pub(crate) stoppable: bool,
}

impl<T: Send + 'static> Task<T> {
    /// Starts work at a time.
    pub(crate) fn start(
        platform: &mut dyn Platform,
        now: f64,
        work: impl FnOnce(&Progress) -> T + Send + 'static,
    ) -> Self {
        let (send, answer) = mpsc::channel();
        let progress = Arc::new(Progress::default());
        let shared = Arc::clone(&progress);
        platform.spawn(Box::new(move || {
            // Fails only if nobody waits for it any more.
            let _ = send.send(work(&shared));
        }));
        Self { progress, answer, since: now }
    }

    /// Asks for the answer.
    pub(crate) fn news(&self) -> News<T> {
        match self.answer.try_recv() {
            Ok(answer) => News::Done(answer),
            Err(TryRecvError::Empty) => News::None,
            Err(TryRecvError::Disconnected) => News::Lost,
        }
    }

    /// Says that the answer is not wanted.
    pub(crate) fn stop(&self) {
        self.progress.stopped.store(true, Relaxed);
    }

    /// Steps done, and all there are; `None` while it is too young to be shown.
    pub(crate) fn progress(&self, now: f64) -> Option<[usize; 2]> {
        let all = self.progress.all.load(Relaxed);
        (now - self.since >= PATIENCE).then(|| [self.progress.done.load(Relaxed).min(all), all])
    }

    /// In how many seconds there is something new to show.
    pub(crate) fn wait(&self, now: f64) -> f64 {
        (self.since + PATIENCE - now).max(LOOK)
    }
}
