//! `rasterscope figure`: the picture of a lab after some steps, as on the screen.

use rasterscope_core::{
    compare::Pair,
    explain::{Level, Mark, View},
    labs,
    message::{Message, Value},
    pipeline::{Layer, Overlay, Pipeline, PixelCounts, Skips},
    raster::Algorithm,
    replay::{Budget, Playback},
    scene::Scene,
};
use rasterscope_figure::{
    animation::Film,
    figure::Figure,
    layout::{self, Placement},
    overlay, png, space, split, svg,
    theme::{Theme, ThemeName},
};
use std::{io::Write, path::PathBuf};

use crate::{
    Failure, files,
    progress::Progress,
    tour::{image_view, opaque},
    trace::check_name,
    words::{WORDS, say},
};

/// Width and height in points, unless the options say otherwise: a canvas of 4 to 3.
pub const SIZE: [u32; 2] = [960, 720];

/// What a picture without a pointer and without an edit can show on the image.
pub const OVERLAYS: [Overlay; 6] = [
    Overlay::Depth,
    Overlay::Stencil,
    Overlay::Generated,
    Overlay::Written,
    Overlay::Wireframe,
    Overlay::Equal,
];

/// Pixels of a PNG for each point.
pub(crate) const PIXELS_PER_POINT: f32 = 2.0;

/// Distance of the drawing from the border of the figure, in points.
const INSET: f32 = 24.0;

/// What to draw, and where it goes.
#[derive(Clone, Debug)]
pub struct FigureOptions {
    /// The lab's name.
    pub lab: String,
    /// A scene or a `compute` request.
    pub file: PathBuf,
    /// After how many steps of the finest level; 0 is the start, `None` the end.
    pub step: Option<usize>,
    /// Width and height in points, each in 16..=8192.
    pub size: [u32; 2],
    /// What lies on the image of the pipeline at its end.
    pub overlay: Overlay,
    /// In which colours.
    pub theme: ThemeName,
    /// Where it goes; `.svg` or `.png`.
    pub output: PathBuf,
}

/// How a run becomes an animated picture.
#[derive(Clone, Copy, Debug)]
pub struct AnimateOptions {
    /// How big a step is; `None`: the finest with few enough of them.
    pub level: Option<Level>,
    /// How long a frame stays, in milliseconds.
    pub delay: u16,
}

/// Draws a step and writes it whole or not at all. `notes` gets a line if there is no such step.
pub fn figure(options: &FigureOptions, notes: &mut dyn Write) -> Result<(), Failure> {
    let svg_wanted = options.check(&["svg", "png"], "error-figure-ending")? == "svg";
    let scene = files::open_lab(&options.lab, &options.file)?;
    let figure = match options.step {
        _ if scene.compared().is_some() => split(&scene, options, notes)?,
        None if options.lab == "pipeline" => end_of_pipeline(&scene, options),
        step => {
            let mut run = labs::play(&scene, Budget::default()).map_err(|message| Failure::work(&message))?;
            note_past_the_end(step, run.len(), notes);
            run.seek(step.unwrap_or(usize::MAX));
            draw(&*run, options.points(), options.theme.theme())
        }
    };
    let bytes = if svg_wanted { svg::svg(&figure).into_bytes() } else { png::png(&figure, PIXELS_PER_POINT) };
    files::write(&options.output, &bytes)
}

/// Says that there is no such step.
fn note_past_the_end(step: Option<usize>, len: usize, notes: &mut dyn Write) {
    if let Some(asked) = step.filter(|step| *step > len) {
        let note = Message::new("cli-step-past-the-end").with("steps", len);
        // The picture is made, whether or not somebody reads this.
        let _ = writeln!(notes, "{}", say(&note.with("asked", asked)));
    }
}

/// Both sides of a scene that compares.
fn split(scene: &Scene, options: &FigureOptions, notes: &mut dyn Write) -> Result<Figure, Failure> {
    let failure = |message: Message| Failure::work(&message);
    let own = scene.compared().and_then(|setting| Some([setting.of(scene)?, setting]));
    let (Some(pair), Some(own)) = (Pair::play(scene, Budget::default()), own) else {
        return Err(failure(Message::new("error-no-lab")));
    };
    let mut pair = pair.map_err(failure)?;
    note_past_the_end(options.step, pair.len(), notes);
    pair.seek(options.step.unwrap_or(usize::MAX));
    Ok(split::draw(&pair, own, options.points(), INSET, options.theme.theme(), &WORDS))
}

/// Draws every step and writes them whole or not at all as one animated PNG; `options.step` is not
/// looked at. `progress` gets a line that is written over and over, and is for terminals only.
pub fn animate(
    options: &FigureOptions,
    animate: AnimateOptions,
    progress: Option<&mut dyn Write>,
) -> Result<(), Failure> {
    options.check(&["png", "apng"], "error-animation-ending")?;
    let scene = files::open_lab(&options.lab, &options.file)?;
    let mut run = labs::play(&scene, Budget::default()).map_err(|message| Failure::work(&message))?;
    let film = Film::new(&*run, animate.level).map_err(|message| Failure::work(&message))?;
    let mut progress = Progress(progress);
    let message = Message::new("cli-frames").with("all", film.steps.len());
    let draw = |run: &dyn Playback| {
        if options.lab == "pipeline" && run.cursor() == run.len() {
            return end_of_pipeline(&scene, options);
        }
        draw(run, options.points(), options.theme.theme())
    };
    let watch = |done: usize| {
        progress.say(&message.clone().with("number", done + 1));
        true
    };
    let bytes = film.record(&mut *run, animate.delay, PIXELS_PER_POINT, draw, watch);
    progress.clear();
    // Nothing stops the work here, and all figures have one size.
    files::write(&options.output, &bytes.unwrap_or_default())
}

impl FigureOptions {
    /// Refuses what is no lab, ends in none of `endings`, or has no such size; returns the ending.
    fn check(&self, endings: &[&'static str], wrong: &'static str) -> Result<&'static str, Failure> {
        check_name(&self.lab)?;
        let ending = self.output.extension().map(std::ffi::OsStr::to_ascii_lowercase);
        let ending = ending.and_then(|ending| endings.iter().find(|each| ending == ***each));
        let Some(ending) = ending else {
            let file = Value::text(self.output.display());
            return Err(Failure::usage(&Message::new(wrong).with("file", file)));
        };
        let end_of_pipeline = self.lab == "pipeline" && self.step.is_none();
        if self.overlay != Overlay::None && !end_of_pipeline {
            return Err(Failure::usage(&Message::new("error-figure-overlay")));
        }
        if self.size.iter().any(|side| !(16..=8192).contains(side)) {
            return Err(Failure::usage(&Message::new("error-figure-size")));
        }
        Ok(ending)
    }

    fn points(&self) -> [f32; 2] {
        self.size.map(|side| side as f32)
    }
}

/// The end of the whole pipeline is the image itself, of any scene.
fn end_of_pipeline(scene: &Scene, options: &FigureOptions) -> Figure {
    let mut pipeline = Pipeline::new(Algorithm::Scanline);
    let outputs = pipeline.update(scene, &Skips::ALL);
    let counts = options.overlay.counts().then(|| PixelCounts::of(scene, outputs));
    let layer = Layer::of(options.overlay, scene, outputs, counts.as_ref(), None);
    let theme = options.theme.theme();
    let size = outputs.frame.size.map(|side| side as usize);
    let marks = overlay::marks(&layer, size, &opaque(&outputs.frame), theme);
    lay_out(&marks, &image_view(scene), options.points(), theme)
}

/// The drawing of a run at its cursor.
pub(crate) fn draw(run: &dyn Playback, size: [f32; 2], theme: &Theme) -> Figure {
    let marks = run.marks();
    lay_out(&space::seen(&marks, run.vantage().as_ref(), None), &run.view(), size, theme)
}

fn lay_out(marks: &[Mark], view: &View, size: [f32; 2], theme: &Theme) -> Figure {
    layout::draw(marks, view, &Placement::fit(view, size, INSET), size, theme, &WORDS)
}
