//! The z-buffer: a fragment is drawn if its depth passes against what the pixel holds.
//!
//! *Source:* Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces, 1974; Foley et
//! al., Computer Graphics: Principles and Practice, 2nd ed., section 15.4. Deviation: each depth is
//! the exact plane value, not a sum of increments.

mod explain;
mod rules;
mod snapshot;

pub use snapshot::Snapshot;

use super::{DepthBuffer, DepthFormat, DepthPlane, DepthState, Early, Rules};
use crate::{
    math::Tally,
    raster::{self, Algorithm},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// A triangle with a depth: x and y in pixels, z in the depth range; finite.
pub type Triangle = [[f32; 3]; 3];

/// What a triangle is called, and which object's fill it wears.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// As on the canvas.
    pub text: String,
    /// Index of the object, from 0.
    pub object: usize,
}

/// The conventions of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Which rasterizer finds the fragments.
    pub algorithm: Algorithm,
    /// Its conventions, and the image's size.
    pub raster: raster::Settings,
    /// How a depth is stored.
    pub format: DepthFormat,
    /// The depth of an empty pixel.
    pub clear: f32,
    /// What passes, and what is written then.
    pub state: DepthState,
    /// Whether the test comes before the alpha test where it may. The image does not depend on it.
    pub early_z: bool,
}

impl Settings {
    /// Smaller depths win over a clear depth of 1, in f32.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            algorithm: Algorithm::default(),
            raster: raster::Settings::new(size),
            format: DepthFormat::default(),
            clear: 1.0,
            state: DepthState::default(),
            early_z: true,
        }
    }

    /// An image with nothing drawn.
    pub fn empty(&self) -> Image {
        let depth = DepthBuffer::new(self.raster.size, self.format, self.clear);
        Image { owners: vec![0; depth.codes().len()], depth }
    }
}

/// What has been drawn.
#[derive(Debug, PartialEq)]
pub struct Image {
    /// The depth of each pixel.
    pub depth: DepthBuffer,
    /// The triangle that each pixel shows, plus 1; 0 is none.
    owners: Vec<u32>,
}

impl Clone for Image {
    fn clone(&self) -> Self {
        Self { depth: self.depth.clone(), owners: self.owners.clone() }
    }

    fn clone_from(&mut self, from: &Self) {
        self.depth.clone_from(&from.depth);
        self.owners.clone_from(&from.owners);
    }
}

impl Image {
    /// The triangle that a pixel of the image shows.
    #[inline]
    pub fn owner(&self, pixel: [u32; 2]) -> Option<u32> {
        self.owners[self.depth.index(pixel)].checked_sub(1)
    }

    fn show(&mut self, pixel: [u32; 2], triangle: u32) {
        let index = self.depth.index(pixel);
        self.owners[index] = triangle + 1;
    }
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// A triangle begins.
    Triangle {
        /// Which one.
        index: u32,
    },
    /// Whether its fragments may be tested before their alpha is known; only in runs with an alpha test.
    Early {
        /// What may happen before.
        when: Early,
        /// Whether that is done.
        on: bool,
    },
    /// The scissor rectangle took pixels off a row.
    Scissor {
        /// The row.
        y: u16,
        /// First column, and one past the last.
        whole: [u16; 2],
        /// The same of what is left; equal if nothing is.
        kept: [u16; 2],
    },
    /// A row of its pixels begins.
    Row {
        /// The row.
        y: u32,
        /// First column.
        begin: u32,
        /// One past the last column.
        end: u32,
    },
    /// A fragment arrives.
    Fragment {
        /// Its column; images have at most 16384.
        x: u16,
        /// Its depth, rounded to f32.
        z: f32,
        /// Its depth's code in the buffer's format.
        code: u32,
        /// The code that its pixel holds.
        stored: u32,
    },
    /// Its alpha was tested. If that came before the depth test and it is kept, the depth test follows; one
    /// that is not kept ends here.
    Alpha {
        /// Rounded.
        alpha: f32,
        /// Whether it is kept.
        kept: bool,
    },
    /// It passed: the triangle shows, and its code is stored if the state writes.
    Pass,
    /// It failed: nothing changes.
    Fail,
    /// A triangle is done.
    Done {
        /// Fragments that passed.
        passed: u32,
        /// Fragments that failed.
        failed: u32,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

/// Draws triangles in order; each pixel shows the last one that passed there.
///
/// Triangles of no area and pixels off the image draw nothing. With `less` and distinct depths,
/// the order does not matter. Cost: about 20 ns a fragment.
pub fn draw(triangles: &[Triangle], settings: &Settings) -> Image {
    draw_traced(triangles, settings, &mut Tally::default(), &mut NoTrace)
}

/// [`draw`] as a run that can be scrubbed. Triangles without a name are called A, B, C, ...
pub fn play(
    triangles: Vec<Triangle>,
    names: Vec<Name>,
    settings: Settings,
    budget: Budget,
) -> Player<Snapshot> {
    play_ruled(triangles, Vec::new(), names, settings, budget)
}

/// [`play`] of triangles that have rules, one for each; those beyond the last have none.
pub fn play_ruled(
    triangles: Vec<Triangle>,
    rules: Vec<Rules>,
    names: Vec<Name>,
    settings: Settings,
    budget: Budget,
) -> Player<Snapshot> {
    let snapshot = Snapshot::new(&triangles, &rules, names, settings);
    Player::new(snapshot, budget, move |t| {
        draw_ruled_traced(&triangles, &rules, &settings, &mut Tally::default(), t);
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
pub fn draw_traced<T: Tracer<Event>>(
    triangles: &[Triangle],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
) -> Image {
    draw_ruled_traced(triangles, &[], settings, tally, t)
}

/// [`draw_traced`] of triangles that have rules, as in [`play_ruled`].
pub fn draw_ruled_traced<T: Tracer<Event>>(
    triangles: &[Triangle],
    rules: &[Rules],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
) -> Image {
    let mut image = settings.empty();
    let cuts = rules.iter().any(|rules| rules.cutout.is_some());
    for (i, &triangle) in triangles.iter().enumerate() {
        let (index, rules) = (i as u32, rules.get(i).copied().unwrap_or_default());
        t.emit(|| Event::Triangle { index });
        if cuts {
            let when = Early::of(rules.cutout.is_some(), settings.state.test, None);
            t.emit(|| Event::Early { when, on: settings.early_z });
        }
        fragments_traced((triangle, index), &rules, settings, &mut image, tally, t);
    }
    image
}

/// One triangle of [`draw_traced`], over what the image holds; `index` is what its pixels show.
pub fn draw_triangle_traced<T: Tracer<Event>>(
    triangle: Triangle,
    index: u32,
    settings: &Settings,
    image: &mut Image,
    tally: &mut Tally,
    t: &mut T,
) {
    fragments_traced((triangle, index), &Rules::default(), settings, image, tally, t);
}

fn fragments_traced<T: Tracer<Event>>(
    (triangle, index): (Triangle, u32),
    rules: &Rules,
    settings: &Settings,
    image: &mut Image,
    tally: &mut Tally,
    t: &mut T,
) {
    let plane = DepthPlane::new(triangle, settings.raster.arithmetic, tally);
    let plane = plane.placed(&rules.placement, settings.format);
    let cut = rules.cut(triangle, tally);
    let mut signs = Tally::default();
    let (mut passed, mut failed) = (0, 0);
    let points = triangle.map(|[x, y, _]| [x, y]);
    raster::cover(settings.algorithm, points, &settings.raster, &mut signs, &mut |span| {
        let raster::Span { y, begin, end } = rules.scissored(span);
        if end - begin < span.len() {
            let [whole, kept] = [[span.begin, span.end], [begin, end]].map(|ends| ends.map(|x| x as u16));
            t.emit(|| Event::Scissor { y: y as u16, whole, kept });
            if begin == end {
                return;
            }
        }
        t.emit(|| Event::Row { y, begin, end });
        for x in begin..end {
            let code = plane.code([x, y], settings.format, tally);
            if T::ENABLED {
                let z = plane.depth([x, y], tally);
                let stored = image.depth.code([x, y]);
                t.emit(|| Event::Fragment { x: x as u16, z, code, stored });
            }
            if let Some(cut) = &cut {
                // Early, a fragment that fails is never asked for its alpha; late, every one is.
                let fails = settings.early_z && !image.depth.would_pass(settings.state, [x, y], code);
                if !fails {
                    let kept = cut.keeps([x, y], tally);
                    if T::ENABLED {
                        let alpha = cut.alpha([x, y], tally);
                        t.emit(|| Event::Alpha { alpha, kept });
                    }
                    if !kept {
                        continue;
                    }
                }
            }
            if image.depth.test(settings.state, [x, y], code) {
                image.show([x, y], index);
                passed += 1;
                t.emit(|| Event::Pass);
            } else {
                failed += 1;
                t.emit(|| Event::Fail);
            }
        }
    });
    *tally += signs;
    t.emit(|| Event::Done { passed, failed });
}
