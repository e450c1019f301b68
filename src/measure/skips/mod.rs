//! What each skip saves: a scene with all of them, without one after another, and with none.
//!
//! Every setting has a pipeline of its own, and they take turns. Before each measured frame the pipeline draws
//! the scene from a hair's breadth beside it, so that the frame is one of an orbit: what the skips `clear` and
//! `memo` may keep is what such a frame has in common with the one before. Each frame is held against the first
//! one with all skips, byte for byte of colour, depth and stencil.

pub mod picture;

use rasterscope_core::{
    pipeline::{Frame, Pipeline, Skip, Skips, Stats, Work},
    scene::Scene,
    stage::Stage,
};
use serde::Serialize;

use crate::{Stopwatch, stopwatch::quartiles};

/// Which skips are on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Setting {
    /// All of them.
    All,
    /// All but one.
    Without(Skip),
    /// None.
    None,
}

impl Setting {
    /// All settings, in the order in which they take turns.
    pub fn all() -> Vec<Self> {
        let without = Skip::ALL.into_iter().map(Self::Without);
        [Self::All].into_iter().chain(without).chain([Self::None]).collect()
    }

    /// The skips that are on.
    pub fn skips(self) -> Skips {
        match self {
            Self::All => Skips::ALL,
            Self::Without(skip) => Skips::ALL.with(skip, false),
            Self::None => Skips::NONE,
        }
    }
}

/// What a scene costs in one setting.
#[derive(Clone, Debug)]
pub struct Cost {
    /// Which skips are on.
    pub setting: Setting,
    /// Median time of a frame in ns: of the stages before the screen, and of those on it.
    pub ns: [f64; 2],
    /// The lower and the upper quartile of their sum.
    pub quartiles: [f64; 2],
    /// Whether every frame was the same as with all skips: colour, depth and stencil, byte for byte.
    pub same: bool,
    /// What the stages counted.
    pub stats: Stats,
}

impl Cost {
    /// Median time of a frame in ns.
    pub fn total(&self) -> f64 {
        self.ns[0] + self.ns[1]
    }
}

/// What the skips save in a scene.
#[derive(Clone, Debug)]
pub struct Savings {
    /// One for each setting, in the order of [`Setting::all`].
    pub costs: Vec<Cost>,
    pixels: u64,
    draws: u64,
}

/// What one skip saves.
#[derive(Clone, Copy, Debug)]
pub struct Saving {
    /// Which.
    pub skip: Skip,
    /// What is done and left out with all skips on.
    pub work: Work,
    /// How many times longer a frame takes without it.
    pub ratio: f64,
    /// Whether the image is the same without it.
    pub same: bool,
}

/// What came into a stage with all skips, and with none.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct StageLoad {
    /// Which; its name on the wire is that of `render`'s statistics.
    #[serde(serialize_with = "name_of")]
    pub stage: Stage,
    /// With all skips.
    pub with: u64,
    /// With none.
    pub without: u64,
}

fn name_of<S: serde::Serializer>(stage: &Stage, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(stage.word().trim_start_matches("stage-"))
}

impl Savings {
    /// How many runs a measurement makes: what its progress counts.
    pub fn runs(rounds: u32) -> usize {
        (rounds as usize + 1) * Setting::all().len()
    }

    /// Measures a resolved scene; `None` if it was stopped. `make` makes the pipeline that draws it.
    pub fn measure(scene: &Scene, make: &dyn Fn() -> Pipeline, stopwatch: &Stopwatch<'_>) -> Option<Self> {
        let settings = Setting::all();
        let mut pipelines: Vec<Pipeline> = settings.iter().map(|_| make()).collect();
        let mut times: Vec<Vec<[f64; 2]>> = vec![Vec::new(); settings.len()];
        let mut same = vec![true; settings.len()];
        let mut first: Option<Frame> = None;
        let beside = beside(scene);
        stopwatch.take_turns(settings.len(), |round, i| {
            let (pipeline, skips) = (&mut pipelines[i], settings[i].skips());
            pipeline.update(&beside, &skips);
            let begin = (stopwatch.now)();
            let mut between = begin;
            pipeline.update_in_parts(scene, &skips, &mut || between = (stopwatch.now)());
            let end = (stopwatch.now)();
            if round > 0 {
                times[i].push([between - begin, end - between].map(|seconds| seconds * 1e9));
            }
            let frame = &pipeline.outputs().frame;
            same[i] &= first.get_or_insert_with(|| frame.clone()).same_image(frame);
        });
        if !(stopwatch.wanted)() {
            return None;
        }
        let costs = settings.into_iter().zip(pipelines).zip(times.into_iter().zip(same));
        let costs = costs.map(|((setting, pipeline), (times, same))| {
            let part = |part: usize| quartiles(times.iter().map(|time| time[part]).collect())[1];
            let [low, _, high] = quartiles(times.iter().map(|[a, b]| a + b).collect());
            let stats = pipeline.outputs().frame.stats;
            Cost { setting, ns: [part(0), part(1)], quartiles: [low, high], same, stats }
        });
        let pixels = scene.size.iter().map(|side| u64::from(*side)).product();
        Some(Self { costs: costs.collect(), pixels, draws: scene.draws.len() as u64 })
    }

    fn of(&self, setting: Setting) -> Option<&Cost> {
        self.costs.iter().find(|cost| cost.setting == setting)
    }

    /// What each skip saves.
    pub fn savings(&self) -> impl Iterator<Item = Saving> {
        Skip::ALL.into_iter().filter_map(|skip| {
            let (with, without) = (self.of(Setting::All)?, self.of(Setting::Without(skip))?);
            let work = with.stats.work(skip, self.pixels, self.draws);
            Some(Saving { skip, work, ratio: without.total() / with.total(), same: without.same })
        })
    }

    /// How many times longer a frame takes with no skip.
    pub fn ratio(&self) -> f64 {
        match (self.of(Setting::All), self.of(Setting::None)) {
            (Some(with), Some(without)) => without.total() / with.total(),
            _ => f64::NAN,
        }
    }

    /// Whether no skip changed a byte.
    pub fn is_proved(&self) -> bool {
        self.costs.iter().all(|cost| cost.same)
    }

    /// What came into each stage that is on.
    pub fn loads(&self) -> Vec<StageLoad> {
        let (Some(with), Some(without)) = (self.of(Setting::All), self.of(Setting::None)) else {
            return Vec::new();
        };
        let load = |stage: Stage| {
            let [with, without] = [with, without].map(|cost| cost.stats.stage(stage));
            without.on.then_some(StageLoad { stage, with: with.came, without: without.came })
        };
        Stage::ALL.into_iter().filter_map(load).collect()
    }
}

/// The scene from a hair's breadth to the side: a 1024th of the distance to what is looked at.
fn beside(scene: &Scene) -> Scene {
    let mut beside = scene.clone();
    let camera = &mut beside.camera;
    let far = [0, 1, 2].map(|axis| camera.target[axis] - camera.eye[axis]).into_iter().map(f32::abs);
    let step = far.fold(0.0, f32::max) / 1024.0;
    camera.eye[0] += step;
    camera.target[0] += step;
    beside
}
