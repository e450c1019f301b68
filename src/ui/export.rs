//! What leaves the window: the picture of the step as on the canvas, and its values.

use crate::{
    app::App,
    platform::Platform,
    shell::{
        inspector::{Digest, csv},
        notice::Notice,
    },
};
use egui::{ColorImage, Context};
use rasterscope_core::message::{Message, Value};
use rasterscope_figure::{figure::Figure, png, svg};

/// Pixels of a picture for each point of the canvas.
const PIXELS_PER_POINT: f32 = 2.0;

impl App {
    /// The drawing on the canvas, or why there is none.
    fn picture(&mut self) -> Option<&Figure> {
        if self.canvas.last_figure().is_none() {
            self.notice = Some(Notice::Failed(self.words.word("ui-no-picture")));
        }
        self.canvas.last_figure()
    }

    /// Writes the picture as SVG or PNG, as its path ends.
    pub(crate) fn write_picture(&mut self, path: &str, platform: &mut dyn Platform) {
        let ending = path.rsplit_once('.').map(|(_, ending)| ending.to_ascii_lowercase());
        let Some(figure) = self.picture() else { return };
        let bytes = match ending.as_deref() {
            Some("svg") => svg::svg(figure).into_bytes(),
            Some("png") => png::png(figure, PIXELS_PER_POINT),
            _ => {
                self.notice = Some(Notice::Failed(self.words.word("ui-picture-ending")));
                return;
            }
        };
        self.written(path, platform.write(path, &bytes));
    }

    /// Says how writing a file went.
    pub(crate) fn written(&mut self, path: &str, done: std::io::Result<()>) {
        self.notice = Some(match done {
            Ok(()) => {
                Notice::Done(self.words.message(&Message::new("ui-saved").with("path", Value::text(path))))
            }
            Err(error) => {
                let message = super::commands::unreadable("ui-error-write", path, &error);
                Notice::Failed(self.words.message(&message))
            }
        });
    }

    /// Puts the picture on the clipboard.
    pub(crate) fn copy_picture(&mut self, ctx: &Context) {
        let Some(figure) = self.picture() else { return };
        let pixels = png::pixmap(figure, PIXELS_PER_POINT);
        let size = [pixels.width() as usize, pixels.height() as usize];
        // The canvas is opaque: its colours are not multiplied by anything.
        ctx.copy_image(ColorImage::from_rgba_premultiplied(size, pixels.data()));
        self.notice = Some(Notice::Done(self.words.word("ui-copied-picture")));
    }

    /// Puts the values of the step on the clipboard, as comma-separated lines.
    pub(crate) fn copy_values(&mut self, ctx: &Context) {
        let mut tables = self.digest.iter().flat_map(Digest::tables).cloned().collect::<Vec<_>>();
        if self.labs[self.lab()].name() == "pipeline" {
            tables.push((*self.overview.table(&self.words)).clone());
        }
        ctx.copy_text(csv(&tables));
        self.notice = Some(Notice::Done(self.words.word("ui-copied-values")));
    }
}
