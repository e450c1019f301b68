//! A run as an animated picture: the figures of its steps as one APNG file.
//!
//! APNG is a PNG with more frames; what knows only PNG shows the first. Of a frame only the rectangle
//! that differs from the one before is stored.
//!
//! *Source:* Portable Network Graphics (PNG) Specification, Third Edition, W3C 2025, section 11.3.6.

use rasterscope_core::{explain::Level, message::Message, replay::Playback};

use crate::{figure::Figure, png::pixmap};

/// Most frames of an animated picture.
pub const MOST_FRAMES: usize = 600;

/// Time that a frame stays, in milliseconds, unless something else is asked for.
pub const DELAY: u16 = 500;

/// The last frame stays this many milliseconds longer, before the run begins anew.
const REST: u16 = 2000;

/// Which steps of a run an animated picture shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Film {
    /// How big a step is.
    pub level: Level,
    /// The steps in order, the start and the end among them; at most [`MOST_FRAMES`].
    pub steps: Vec<usize>,
}

impl Film {
    /// The steps of `level`, or, if nothing is asked for, of the finest level with few enough.
    ///
    /// # Errors
    /// A message if there are too many steps.
    pub fn new(run: &dyn Playback, level: Option<Level>) -> Result<Self, Message> {
        let film = |level| {
            let mut steps = vec![0];
            steps.extend(run.ends(level));
            if steps.last() != Some(&run.len()) {
                steps.push(run.len());
            }
            Self { level, steps }
        };
        let mut finest_first = level.map_or_else(|| Level::ALL.to_vec(), |level| vec![level]);
        finest_first.reverse();
        let mut frames = 0;
        for level in finest_first {
            let film = film(level);
            if film.steps.len() <= MOST_FRAMES {
                return Ok(film);
            }
            frames = film.steps.len();
        }
        let id = match level {
            Some(Level::Row | Level::Detail) => "figure-film-too-fine",
            Some(Level::Primitive) | None => "figure-film-too-long",
        };
        Err(Message::new(id).with("frames", frames).with("most", MOST_FRAMES))
    }

    /// The animated picture, `delay` milliseconds a frame, over and over.
    ///
    /// `draw` makes the figure of the step at which the run stands; all have one size. `watch` is told
    /// how many frames are done, and stops the work by `false`: then there is no picture.
    pub fn record(
        &self,
        run: &mut dyn Playback,
        delay: u16,
        pixels_per_point: f32,
        mut draw: impl FnMut(&dyn Playback) -> Figure,
        mut watch: impl FnMut(usize) -> bool,
    ) -> Option<Vec<u8>> {
        let frames = (0..).zip(&self.steps).map_while(|(done, step)| {
            run.seek(*step);
            watch(done).then(|| draw(run))
        });
        apng(self.steps.len(), delay, pixels_per_point, frames)
    }
}

/// Figures of one size as an animated PNG; `None` if there are fewer than `count`, or of several sizes.
fn apng(
    count: usize,
    delay: u16,
    pixels_per_point: f32,
    mut figures: impl Iterator<Item = Figure>,
) -> Option<Vec<u8>> {
    let first = Frame::new(&figures.next()?, pixels_per_point);
    let mut out = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut out, first.width, first.height);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_animated(u32::try_from(count).ok()?, 0).ok()?;
    let mut writer = encoder.write_header().ok()?;
    let mut old: Option<Frame> = None;
    for number in 1..=count {
        let new = match &old {
            None => first.clone(),
            Some(old) => {
                let new = Frame::new(&figures.next()?, pixels_per_point);
                (new.width == old.width && new.height == old.height).then_some(new)?
            }
        };
        let changed = old.as_ref().map_or(new.whole(), |old| new.changed(old));
        let [left, top, width, height] = changed;
        let stays = if number == count { delay.saturating_add(REST) } else { delay };
        writer.set_frame_delay(stays, 1000).ok()?;
        // A rectangle is set with its corner at the origin first, so that it never leaves the picture.
        writer.reset_frame_position().ok()?;
        writer.set_frame_dimension(width, height).ok()?;
        writer.set_frame_position(left, top).ok()?;
        writer.write_image_data(&new.part(changed)).ok()?;
        old = Some(new);
    }
    writer.finish().ok()?;
    Some(out)
}

/// The pixels of a figure as RGB: every figure is opaque.
#[derive(Clone)]
struct Frame {
    width: u32,
    height: u32,
    rgb: Vec<u8>,
}

/// Left, top, width and height in pixels.
type Part = [u32; 4];

impl Frame {
    fn new(figure: &Figure, pixels_per_point: f32) -> Self {
        let pixmap = pixmap(figure, pixels_per_point);
        let rgb = pixmap.data().chunks_exact(4).flat_map(|pixel| &pixel[..3]).copied().collect();
        Self { width: pixmap.width(), height: pixmap.height(), rgb }
    }

    fn whole(&self) -> Part {
        [0, 0, self.width, self.height]
    }

    fn rows(&self) -> impl DoubleEndedIterator<Item = &[u8]> + ExactSizeIterator {
        self.rgb.chunks_exact(3 * self.width as usize)
    }

    /// The smallest rectangle outside of which the two agree; one pixel if they agree everywhere.
    fn changed(&self, old: &Self) -> Part {
        let (mut x, mut y) = ([u32::MAX, 0], [u32::MAX, 0]);
        for (row, (new, old)) in (0..).zip(self.rows().zip(old.rows())) {
            let differs = |(new, old): (&[u8], &[u8])| new != old;
            let mut pixels = new.chunks_exact(3).zip(old.chunks_exact(3));
            if new == old {
                continue;
            }
            let first = pixels.clone().position(differs).unwrap_or(0) as u32;
            let last = pixels.rposition(differs).unwrap_or(0) as u32;
            x = [x[0].min(first), x[1].max(last)];
            y = [y[0].min(row), row];
        }
        if x[0] > x[1] { [0, 0, 1, 1] } else { [x[0], y[0], x[1] - x[0] + 1, y[1] - y[0] + 1] }
    }

    fn part(&self, [left, top, width, height]: Part) -> Vec<u8> {
        let columns = 3 * left as usize..3 * (left + width) as usize;
        let rows = self.rows().skip(top as usize).take(height as usize);
        rows.flat_map(|row| &row[columns.clone()]).copied().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{figure::Shape, theme::Color};

    /// White, with a red square of 2 x 2 points.
    fn square(at: Option<[f32; 2]>) -> Figure {
        let red = |[x, y]: [f32; 2]| Shape::Rect {
            min: [x, y],
            max: [x + 2.0, y + 2.0],
            radius: 0.0,
            fill: Some(Color::hex(0xFF0000)),
            stroke: None,
        };
        Figure {
            size: [20.0, 10.0],
            background: Color::hex(0xFFFFFF),
            shapes: at.map(red).into_iter().collect(),
        }
    }

    /// The frames as a viewer composes them: delay in milliseconds, rectangle, and all pixels.
    fn played(bytes: &[u8]) -> Vec<(u16, Part, Vec<u8>)> {
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
        let count = reader.info().animation_control().map_or(1, |control| control.num_frames);
        let (width, height) = reader.info().size();
        let mut canvas = vec![0; (3 * width * height) as usize];
        let mut frames = Vec::new();
        for _ in 0..count {
            let mut part = vec![0; reader.output_buffer_size().expect("small")];
            reader.next_frame(&mut part).expect("each frame is there");
            let control = *reader.info().frame_control().expect("it is animated");
            let bytes = 3 * control.width as usize;
            for (row, pixels) in part.chunks_exact(bytes).take(control.height as usize).enumerate() {
                let y = control.y_offset as usize + row;
                let at = 3 * (y * width as usize + control.x_offset as usize);
                canvas[at..at + bytes].copy_from_slice(pixels);
            }
            let rectangle = [control.x_offset, control.y_offset, control.width, control.height];
            frames.push((control.delay_num, rectangle, canvas.clone()));
        }
        frames
    }

    #[test]
    fn frames_are_composed_to_the_figures_and_only_changes_are_stored() {
        let places = [None, Some([4.0, 3.0]), Some([4.0, 3.0]), Some([17.0, 8.0]), None];
        let bytes = apng(5, 100, 1.0, places.into_iter().map(square)).expect("it can be written");
        let frames = played(&bytes);
        let expected = [
            (100, [0, 0, 20, 10]),
            (100, [4, 3, 2, 2]),
            (100, [0, 0, 1, 1]),
            (100, [4, 3, 15, 7]),
            (100 + REST, [17, 8, 2, 2]),
        ];
        assert_eq!(frames.len(), expected.len());
        for (place, ((delay, part, pixels), expected)) in places.into_iter().zip(frames.iter().zip(expected))
        {
            assert_eq!((*delay, *part), expected);
            assert_eq!(*pixels, Frame::new(&square(place), 1.0).rgb, "{place:?}");
        }
    }

    #[test]
    fn what_ends_early_or_changes_its_size_is_no_picture() {
        assert_eq!(apng(3, 100, 1.0, [None, None].into_iter().map(square)), None);
        let wide = Figure { size: [30.0, 10.0], ..square(None) };
        assert_eq!(apng(2, 100, 1.0, [square(None), wide].into_iter()), None);
    }
}
