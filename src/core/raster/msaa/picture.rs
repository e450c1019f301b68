//! The drawing: every sample a dot, in or out by colour and shape, and the pixels as they are shown.

use super::{Event, Snapshot, Triangle, pixel_box};
use crate::{
    explain::{Label, Mark, Role, Sign, letter},
    message::{Message, Value},
};
use std::{ops::Range, sync::Arc};

/// Images of more samples show those of the pixel in hand alone.
const MOST_DOTS: usize = 1024;

impl Snapshot {
    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.shown(out);
        for (i, triangle) in self.triangles.iter().enumerate() {
            let points = triangle.map(|[x, y, _]| [x, y]).to_vec();
            let now = self.triangle == Some(i as u32);
            let role = if now { Role::Neutral } else { Role::Candidate };
            let label = Some(Label::name(letter(i)).of(i));
            out.push(Mark::Polygon { points, role, object: None, label });
        }
        self.dots(event, out);
        if let Some(pixel) = self.pixel {
            let value = self.value(pixel);
            let at = pixel.map(|n| n as i32);
            out.push(Mark::Pixel { at, role: Role::Active, object: None, value });
        }
        let key = |role, meaning| Mark::Key { role, sign: Sign::Marker, meaning: Message::new(meaning) };
        let found = out.iter().any(|mark| matches!(mark, Mark::Point { role: Role::Rejected, .. }));
        out.push(key(Role::Accepted, "msaa-key-inside"));
        out.push(key(Role::Candidate, "msaa-key-outside"));
        out.extend(found.then(|| key(Role::Rejected, "msaa-key-found")));
    }

    /// The code of a pixel that is resolved.
    fn value(&self, pixel: [u32; 2]) -> Value {
        let index = self.image.index(pixel);
        let shown = index < self.resolved && self.image.masks[index] != 0;
        if shown { u32::from(self.image.codes[index]).into() } else { Value::None }
    }

    /// Grey as resolved; before that the mean of what is stored. What nothing covers is black, or
    /// white could not be told from nothing on a white canvas.
    fn shown(&self, out: &mut Vec<Mark>) {
        let mut rgba = Vec::with_capacity(4 * self.image.masks.len());
        for samples in &self.image.samples {
            let code = self.conventions.samples.resolve(samples);
            rgba.extend([code, code, code, 255]);
        }
        let size = self.image.size.map(|side| side as usize);
        out.push(Mark::Image { size, rgba: Arc::new(rgba) });
        if self.resolved > 0 {
            let [width, height] = self.image.size;
            for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
                let value = self.value(pixel);
                if value != Value::None {
                    let at = pixel.map(|n| n as i32);
                    out.push(Mark::Pixel { at, role: Role::Neutral, object: None, value });
                }
            }
        }
    }

    /// The pixels that a triangle is tested at.
    fn box_of(&self, triangle: &Triangle) -> [Range<u32>; 2] {
        let raster = &self.conventions.raster;
        pixel_box(raster.vertices(triangle.map(|[x, y, _]| [x, y])), raster.size)
    }

    /// The edge values of a sample: of the triangle being drawn, else of the one that it shows or the first.
    fn hint(&self, at: [f32; 2], sample: usize, owner: u8) -> Option<Mark> {
        let shown = usize::from(owner.saturating_sub(1));
        let index = self.triangle.map_or(shown, |index| index as usize);
        let values = self.edge_values(index, at)?;
        let id = if values.iter().all(|value| *value >= 0.0) { "msaa-hint-in" } else { "msaa-hint-out" };
        let [e0, e1, e2] = values;
        let text = Message::new(id)
            .with("sample", Value::text(sample))
            .with("object", Value::text(letter(index)))
            .with("e0", e0)
            .with("e1", e1)
            .with("e2", e2);
        Some(Mark::Hint { at, text })
    }

    /// Every sample, as far as it is known.
    fn dots(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let [width, height] = self.image.size;
        let count = self.conventions.samples.count() as usize;
        let boxes: Vec<_> = self.triangles.iter().map(|triangle| self.box_of(triangle)).collect();
        let near =
            |[x, y]: [u32; 2]| boxes.iter().any(|[columns, rows]| columns.contains(&x) && rows.contains(&y));
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y])).filter(|pixel| near(*pixel));
        let few = pixels.clone().count() * count <= MOST_DOTS;
        for pixel in pixels.filter(|pixel| few || self.pixel == Some(*pixel)) {
            let index = self.image.index(pixel);
            for sample in 0..count {
                let here = self.pixel == Some(pixel);
                let drawn = self.image.masks[index] & 1 << sample != 0;
                let known = self.verdicts[sample].filter(|_| here);
                let role = match (known, event) {
                    (Some(_), Some(Event::Sample { index, .. })) if usize::from(*index) == sample => {
                        Role::Active
                    }
                    (Some((_, true)), _) => Role::Tie,
                    (Some((true, false)), _) => Role::Accepted,
                    (Some((false, false)), _) => Role::Rejected,
                    (None, _) if drawn => Role::Accepted,
                    (None, _) => Role::Candidate,
                };
                let owner = self.owners[index][sample];
                let label = known.map(|_| {
                    let label = Label::name(sample.to_string());
                    if owner > 0 { label.of(usize::from(owner) - 1) } else { label }
                });
                let at = self.sample_point(pixel, sample);
                out.push(Mark::Point { at, role, label });
                out.extend(self.hint(at, sample, owner));
            }
        }
        if let (Some(Event::Shade { at: None, .. }), Some([x, y])) = (event, self.pixel) {
            let at = [x as f32 + 0.5, y as f32 + 0.5];
            out.push(Mark::Point { at, role: Role::Active, label: None });
        }
        if let (Some(Event::Shade { at: Some(sample), .. }), Some(pixel)) = (event, self.pixel) {
            let at = self.sample_point(pixel, usize::from(*sample));
            out.push(Mark::Point { at, role: Role::Active, label: None });
        }
    }
}
