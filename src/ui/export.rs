//! What leaves the window: the picture of the step as on the canvas, and its values.

use crate::{
    app::App,
    files,
    measure::Format,
    platform::{Platform, Purpose},
    shell::{
        inspector::{Digest, csv},
        notice::Notice,
    },
};
use egui::{ColorImage, Context};
use rasterscope_core::message::{Message, Value};
use rasterscope_figure::{figure::Figure, png, svg};
use std::borrow::Cow;

/// Pixels of a picture for each point of the canvas.
pub(crate) const PIXELS_PER_POINT: f32 = 2.0;

impl App {
    /// The path that is offered for a picture: lab, what is open, and the step.
    pub(crate) fn picture_path(&self, purpose: Purpose) -> String {
        if self.measure.open && purpose == Purpose::Picture {
            return format!("{}.svg", self.measure.file_name());
        }
        let lab = self.labs[self.lab()].name();
        let open = match (&self.path, &self.preset) {
            (Some(path), _) => {
                let [_, file] = files::split(path);
                file.rsplit_once('.').map_or(file, |(stem, _)| stem)
            }
            (None, Some((preset, _))) => preset,
            (None, None) => "",
        };
        let step = match (purpose, self.run.shown()) {
            (Purpose::Picture, _) if self.shows_skips() => "skips".to_owned(),
            (Purpose::Picture, Some(shown)) => format!("step{}", shown.cursor),
            (Purpose::Film, _) => "run".to_owned(),
            _ => String::new(),
        };
        let ending = if purpose == Purpose::Film { "png" } else { "svg" };
        let parts = [lab, open, &step].into_iter().filter(|part| !part.is_empty());
        format!("{}.{ending}", parts.collect::<Vec<_>>().join("-"))
    }

    /// The drawing on the canvas or in its place, or why there is none.
    fn picture(&mut self) -> Option<Cow<'_, Figure>> {
        if self.measure.open {
            if self.measure.picture().is_none() {
                self.notice = Some(Notice::Failed(self.words.word("measure-nothing")));
            }
            return self.measure.picture().map(Cow::Borrowed);
        }
        if let Some(figure) = self.shows_skips().then(|| self.skips_picture()).flatten() {
            return Some(Cow::Owned(figure));
        }
        if self.canvas.last_figure().is_none() {
            self.notice = Some(Notice::Failed(self.words.word("ui-no-picture")));
        }
        self.split_figure().map(Cow::Owned).or_else(|| self.canvas.last_figure().map(Cow::Borrowed))
    }

    /// Writes the picture as SVG or PNG, or the values of the step as CSV, as the path ends.
    pub(crate) fn write_picture(&mut self, path: &str, platform: &mut dyn Platform) {
        let ending = path.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        let table = match ending.as_deref() {
            Some("json") if self.measure.open => Some(self.measure.table(Format::Json)),
            Some("json") if self.shows_skips() => Some(self.skips_table(Format::Json, &platform.machine())),
            Some("csv") => Some(self.values(platform)),
            _ => None,
        };
        if let Some(text) = table {
            return self.saved(path, platform.write(path, text.as_bytes()));
        }
        let Some(figure) = self.picture() else { return };
        let bytes = match ending.as_deref() {
            Some("svg") => svg::svg(&figure).into_bytes(),
            Some("png") => png::png(&figure, PIXELS_PER_POINT),
            _ => {
                self.notice = Some(Notice::Failed(self.words.word("ui-picture-ending")));
                return;
            }
        };
        self.saved(path, platform.write(path, &bytes));
    }

    /// Says how saving a file went.
    pub(crate) fn saved(&mut self, path: &str, done: std::io::Result<()>) {
        self.written(path, &Message::new("ui-saved").with("path", Value::text(path)), done);
    }

    /// Says how writing a file went, in the words of `good` if it went well.
    pub(crate) fn written(&mut self, path: &str, good: &Message, done: std::io::Result<()>) {
        self.notice = Some(match done {
            Ok(()) => Notice::Done(self.words.message(good)),
            Err(error) => {
                let message = super::commands::unreadable("ui-error-write", path, &error);
                Notice::Failed(self.words.message(&message))
            }
        });
    }

    /// Puts the picture on the clipboard.
    pub(crate) fn copy_picture(&mut self, ctx: &Context) {
        let Some(figure) = self.picture() else { return };
        let pixels = png::pixmap(&figure, PIXELS_PER_POINT);
        let size = [pixels.width() as usize, pixels.height() as usize];
        // The canvas is opaque: its colours are not multiplied by anything.
        ctx.copy_image(ColorImage::from_rgba_premultiplied(size, pixels.data()));
        self.notice = Some(Notice::Done(self.words.word("ui-copied-picture")));
    }

    /// Puts the values of the step on the clipboard, as comma-separated lines.
    pub(crate) fn copy_values(&mut self, ctx: &Context, platform: &mut dyn Platform) {
        ctx.copy_text(self.values(platform));
        self.notice = Some(Notice::Done(self.words.word("ui-copied-values")));
    }

    /// The values of the step or of what stands in its place, as comma-separated lines.
    fn values(&mut self, platform: &mut dyn Platform) -> String {
        if self.measure.open {
            return self.measure.table(Format::Csv);
        }
        if self.shows_skips() {
            return self.skips_table(Format::Csv, &platform.machine());
        }
        let mut tables = self.digest.iter().flat_map(Digest::tables).cloned().collect::<Vec<_>>();
        if self.labs[self.lab()].name() == "pipeline" {
            tables.push((*self.overview.table(&self.words)).clone());
        }
        csv(&tables)
    }
}
