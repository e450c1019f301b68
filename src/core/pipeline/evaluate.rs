//! The whole pipeline, recomputed only where something changed.

use super::{
    Bounding, Frame, Rasterizer, Skip, Skips, Stats,
    draw::{DrawOutputs, DrawRuns, Shared},
    fragments::{FragmentState, ImageState, Target},
    screen_triangle::ScreenTriangle,
    whole::Whole,
};
use crate::{
    memo::Memo,
    scene::Scene,
    transform::{Matrix, Viewport, matrices},
};

/// What every stage made of a scene.
#[derive(Debug, Default)]
pub struct Outputs {
    /// World to camera space.
    pub view: Matrix,
    /// Camera to clip space.
    pub projection: Matrix,
    /// NDC to the screen.
    pub viewport: Viewport,
    /// What the stages up to the screen made of each draw.
    pub draws: Vec<DrawOutputs>,
    /// The image.
    pub frame: Frame,
}

impl Outputs {
    /// The triangles that are scan converted and drawn, in order.
    pub fn triangles(&self) -> impl Iterator<Item = ScreenTriangle> {
        (0..).zip(&self.draws).flat_map(|(index, draw)| {
            let drawn = draw.clipped().pieces.iter().filter(|piece| !piece.carried);
            drawn.map(move |piece| ScreenTriangle::new(index, draw.screen(), &draw.clipped().colors, piece))
        })
    }
}

/// The image depends on nothing else.
type ImageKey = (ImageState, Vec<([u64; 3], FragmentState)>);

/// The pipeline with the outputs of its last run.
///
/// Each stage of each draw runs only if its own input differs from last time, by value; so does the
/// image. Scenes are compared by the order of their draws.
#[derive(Debug, Default)]
pub struct Pipeline {
    /// What turns triangles into pixels; all give the same image.
    pub rasterizer: Rasterizer,
    /// What stands for an object in the skip `object-frustum`; all give the same image.
    pub bounding: Bounding,
    outputs: Outputs,
    image: Memo<ImageKey, ()>,
    drawn: Option<Drawn>,
}

/// The image with what it keeps for the next one.
#[derive(Debug)]
enum Drawn {
    /// By the engine.
    Whole(Whole),
    /// One triangle after another.
    Each(Target),
}

impl Drawn {
    fn stats(&self) -> &Stats {
        match self {
            Self::Whole(whole) => whole.stats(),
            Self::Each(target) => target.stats(),
        }
    }
}

impl Pipeline {
    /// An empty pipeline with a rasterizer of choice.
    pub fn new(rasterizer: impl Into<Rasterizer>) -> Self {
        Self { rasterizer: rasterizer.into(), ..Self::default() }
    }

    /// The outputs of the last run.
    pub fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// The outputs of the last run, to be kept.
    pub(super) fn into_outputs(self) -> Outputs {
        self.outputs
    }

    /// The image of the last run.
    pub fn into_frame(self) -> Frame {
        self.outputs.frame
    }

    /// How often the stages of a draw have run.
    pub fn runs(&self, draw: usize) -> DrawRuns {
        self.outputs.draws.get(draw).map(DrawOutputs::runs).unwrap_or_default()
    }

    /// How often the image was drawn.
    pub fn image_runs(&self) -> usize {
        self.image.runs()
    }

    /// Brings all outputs up to date with a resolved scene.
    ///
    /// Without the skip `memo` everything is computed anew and the counts of runs start again.
    pub fn update(&mut self, scene: &Scene, skips: &Skips) -> &Outputs {
        self.update_in_parts(scene, skips, &mut || {})
    }

    /// [`update`](Self::update); calls `between` when the stages before the screen are done.
    pub fn update_in_parts(&mut self, scene: &Scene, skips: &Skips, between: &mut dyn FnMut()) -> &Outputs {
        if !skips.has(Skip::Memo) {
            *self = Self { bounding: self.bounding, ..Self::new(self.rasterizer) };
        }
        let runs = |outputs: &Outputs| outputs.draws.iter().map(|draw| draw.runs().total()).sum::<usize>();
        let before = runs(&self.outputs) + self.image.runs();
        self.update_geometry(scene, *skips);
        between();
        self.draw_image(scene, skips);
        let stages = DrawRuns::STAGES * scene.draws.len() + 1;
        let ran = (runs(&self.outputs) + self.image.runs()).saturating_sub(before);
        let mut stats = Stats::default();
        self.outputs.draws.iter().for_each(|draw| draw.count(&mut stats));
        self.drawn.iter().for_each(|drawn| stats.add(drawn.stats()));
        stats.skip(Skip::Memo, stages.saturating_sub(ran) as u64);
        self.outputs.frame.stats = stats;
        &self.outputs
    }

    /// Brings the stages before the image up to date.
    pub(super) fn update_geometry(&mut self, scene: &Scene, skips: Skips) {
        let outputs = &mut self.outputs;
        outputs.viewport =
            Viewport { size: scene.size, depth_range: scene.depth_range, y_axis: scene.y_axis };
        outputs.view = matrices::view(&scene.camera);
        let aspect = outputs.viewport.aspect();
        outputs.projection = matrices::projection(&scene.camera, aspect, scene.depth_range, scene.reversed);
        outputs.draws.resize_with(scene.draws.len(), DrawOutputs::default);
        let shared = Shared {
            scene,
            view: outputs.view,
            projection: outputs.projection,
            viewport: outputs.viewport,
            skips,
        };
        let draws = &mut outputs.draws;
        for (stages, draw) in draws.iter_mut().zip(&scene.draws) {
            stages.place(draw, self.bounding);
        }
        let looked_for = skips.has(Skip::ObjectFrustum);
        let outside = if looked_for { self.bounding.outside(draws, &shared) } else { Vec::new() };
        let outside = outside.into_iter().chain(std::iter::repeat(None));
        for ((stages, draw), outside) in draws.iter_mut().zip(&scene.draws).zip(outside) {
            stages.update(draw, &shared, outside);
        }
    }

    /// Draws the image if anything it depends on changed.
    fn draw_image(&mut self, scene: &Scene, skips: &Skips) {
        let Self { rasterizer, outputs: Outputs { draws, frame, .. }, image, drawn, .. } = self;
        let state = ImageState::new(scene, *rasterizer, *skips);
        let states = draws.iter().zip(&scene.draws);
        let states = states.map(|(outputs, draw)| (outputs.revisions(), FragmentState::new(draw)));
        image.get((state, states.collect()), |(_, states)| {
            let states: Vec<_> = states.iter().map(|(_, state)| *state).collect();
            if state.rasterizer == Rasterizer::Engine && Whole::can_draw(&state, &states) {
                draw_whole(drawn, &state, (draws, &states), frame);
            } else {
                draw_each(drawn, state, (draws, &states), frame);
            }
        });
    }
}

fn draw_whole(
    drawn: &mut Option<Drawn>,
    state: &ImageState,
    (draws, states): (&[DrawOutputs], &[FragmentState]),
    frame: &mut Frame,
) {
    if !matches!(drawn, Some(Drawn::Whole(whole)) if whole.fits(state, frame)) {
        *drawn = Whole::new(state, frame).map(Drawn::Whole);
    }
    if let Some(Drawn::Whole(whole)) = drawn {
        whole.draw(state, draws, states, frame);
    }
}

fn draw_each(
    drawn: &mut Option<Drawn>,
    state: ImageState,
    (draws, states): (&[DrawOutputs], &[FragmentState]),
    frame: &mut Frame,
) {
    let mut target = match drawn.take() {
        Some(Drawn::Each(mut target)) => {
            target.clear(state, frame);
            target
        }
        _ => Target::new(state, frame),
    };
    for (draw, state) in draws.iter().zip(states) {
        target.draw(draw, state, frame);
    }
    target.finish(frame, states.iter());
    *drawn = Some(Drawn::Each(target));
}
