//! `rasterscope figure`: the picture of a lab after some steps, as on the screen.

use rasterscope_core::{
    explain::{Mark, View},
    labs,
    message::{Message, Value},
    pipeline::{self, Skips},
    replay::{Budget, Playback},
};
use rasterscope_figure::{
    figure::Figure,
    layout::{self, Placement},
    png, space, svg,
    theme::{Theme, ThemeName},
};
use std::{io::Write, path::PathBuf};

use crate::{
    Failure, files,
    tour::{image, image_view},
    trace::check_name,
    words::{WORDS, say},
};

/// Width and height in points, unless the options say otherwise: a canvas of 4 to 3.
pub const SIZE: [u32; 2] = [960, 720];

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
    /// In which colours.
    pub theme: ThemeName,
    /// Where it goes; `.svg` or `.png`.
    pub output: PathBuf,
}

/// Draws a step and writes it whole or not at all. `notes` gets a line if there is no such step.
pub fn figure(options: &FigureOptions, notes: &mut dyn Write) -> Result<(), Failure> {
    check_name(&options.lab)?;
    let ending = options.output.extension().map(std::ffi::OsStr::to_ascii_lowercase);
    let svg_wanted = match ending.as_deref().and_then(|ending| ending.to_str()) {
        Some("svg") => true,
        Some("png") => false,
        _ => {
            let message = Message::new("error-figure-ending");
            let file = Value::text(options.output.display());
            return Err(Failure::usage(&message.with("file", file)));
        }
    };
    if options.size.iter().any(|side| !(16..=8192).contains(side)) {
        return Err(Failure::usage(&Message::new("error-figure-size")));
    }
    let scene = files::open_lab(&options.lab, &options.file)?;
    let (size, theme) = (options.size.map(|side| side as f32), options.theme.theme());
    let figure = match options.step {
        // The end of the whole pipeline is the image itself, of any scene.
        None if options.lab == "pipeline" => {
            let frame = pipeline::render(&scene, &Skips::ALL);
            lay_out(&[image(&frame)], &image_view(&scene), size, theme)
        }
        step => {
            let mut run = labs::play(&scene, Budget::default()).map_err(|message| Failure::work(&message))?;
            if let Some(asked) = step.filter(|step| *step > run.len()) {
                let note = Message::new("cli-step-past-the-end").with("steps", run.len());
                // The picture is made, whether or not somebody reads this.
                let _ = writeln!(notes, "{}", say(&note.with("asked", asked)));
            }
            run.seek(step.unwrap_or(usize::MAX));
            draw(&*run, size, theme)
        }
    };
    let bytes = if svg_wanted { svg::svg(&figure).into_bytes() } else { png::png(&figure, PIXELS_PER_POINT) };
    files::write(&options.output, &bytes)
}

/// The drawing of a run at its cursor.
pub(crate) fn draw(run: &dyn Playback, size: [f32; 2], theme: &Theme) -> Figure {
    let marks = run.marks();
    lay_out(&space::seen(&marks, run.vantage().as_ref(), None), &run.view(), size, theme)
}

fn lay_out(marks: &[Mark], view: &View, size: [f32; 2], theme: &Theme) -> Figure {
    layout::draw(marks, view, &Placement::fit(view, size, INSET), size, theme, &WORDS)
}
