//! The stencil test, draw by draw: what a draw leaves in the stencil decides where the next one goes.
//!
//! *Source:* WebGPU, "Depth/Stencil State", and "Rendering" for the order of the tests; for
//! outlines McReynolds and Blythe, Advanced Graphics Programming Using OpenGL, 2005, section 16.7.

mod explain;
mod picture;
mod snapshot;

pub use snapshot::Snapshot;

use super::{Enlarge, StencilOutcome, StencilState};
use crate::{
    depth::{DepthBuffer, DepthFormat, DepthPlane, DepthState, Early, Rules, z_buffer::Triangle},
    math::Tally,
    raster::{self, Algorithm},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;
use std::sync::Arc;

/// Triangles on the screen that are drawn with one state.
#[derive(Clone, Debug, PartialEq)]
pub struct Draw {
    /// As on the canvas.
    pub name: String,
    /// In pixels with depth, in drawing order.
    pub triangles: Vec<Triangle>,
    /// What the fragments of its triangles meet before the tests; those beyond the last meet nothing.
    pub rules: Vec<Rules>,
    /// How it was enlarged, and the triangles before that; nothing for what is drawn where it stands.
    pub enlarged: Option<(Enlarge, Vec<Triangle>)>,
    /// The depth test.
    pub depth: DepthState,
    /// The stencil test; without one all fragments pass and leave the stencil alone.
    pub stencil: Option<StencilState>,
    /// Whether its colour is seen: a draw that only counts leaves every pixel as it looks.
    pub visible: bool,
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
    pub clear_depth: f32,
    /// The stencil value of an empty pixel.
    pub clear: u8,
}

impl Settings {
    /// Cleared to stencil 0 and depth 1 in f32.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            algorithm: Algorithm::default(),
            raster: raster::Settings::new(size),
            format: DepthFormat::default(),
            clear_depth: 1.0,
            clear: 0,
        }
    }

    /// An image with nothing drawn.
    pub fn empty(&self) -> Image {
        let depth = DepthBuffer::new(self.raster.size, self.format, self.clear_depth);
        let pixels = depth.codes().len();
        Image { owners: vec![0; pixels], stencil: vec![self.clear; pixels], depth }
    }
}

/// What has been drawn.
#[derive(Debug, PartialEq)]
pub struct Image {
    /// The depth of each pixel.
    pub depth: DepthBuffer,
    /// The stencil value of each pixel, row by row.
    pub stencil: Vec<u8>,
    /// The draw that each pixel shows, plus 1; 0 is none.
    owners: Vec<u32>,
}

impl Clone for Image {
    fn clone(&self) -> Self {
        Self { depth: self.depth.clone(), stencil: self.stencil.clone(), owners: self.owners.clone() }
    }

    fn clone_from(&mut self, from: &Self) {
        self.depth.clone_from(&from.depth);
        self.stencil.clone_from(&from.stencil);
        self.owners.clone_from(&from.owners);
    }
}

impl Image {
    /// The draw that a pixel of the image shows.
    #[inline]
    pub fn owner(&self, pixel: [u32; 2]) -> Option<u32> {
        self.owners[self.depth.index(pixel)].checked_sub(1)
    }

    /// The stencil value of a pixel of the image.
    #[inline]
    pub fn value(&self, pixel: [u32; 2]) -> u8 {
        self.stencil[self.depth.index(pixel)]
    }

    fn show(&mut self, pixel: [u32; 2], draw: u32) {
        let index = self.depth.index(pixel);
        self.owners[index] = draw + 1;
    }
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// A draw begins.
    Draw {
        /// Which one.
        index: u32,
    },
    /// Its vertices were moved outwards.
    Enlarge {
        /// How many corners its triangles have now.
        corners: u32,
    },
    /// Whether its fragments may be tested before their alpha is known; only of draws with an alpha test.
    Early {
        /// What may happen before.
        when: Early,
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
        /// The stencil value that its pixel holds.
        stored: u8,
        /// Its depth's code in the buffer's format.
        code: u32,
        /// The depth code that its pixel holds.
        depth: u32,
    },
    /// The alpha test discarded it: nothing is stored.
    Discard {
        /// Its alpha, rounded.
        alpha: f32,
    },
    /// It failed the stencil test.
    Fail {
        /// The stencil value then.
        after: u8,
    },
    /// It passed the stencil test and failed the depth test.
    DepthFail {
        /// The stencil value then.
        after: u8,
    },
    /// It passed both: the draw shows.
    Pass {
        /// The stencil value then.
        after: u8,
    },
    /// A draw is done.
    Done {
        /// Fragments that failed the stencil test.
        failed: u32,
        /// Fragments that failed the depth test.
        depth_failed: u32,
        /// Fragments that passed both.
        passed: u32,
    },
}
const _: () = assert!(size_of::<Event>() <= 16);

impl Event {
    /// What became of a fragment, with the stencil value after it.
    fn of(outcome: StencilOutcome, after: u8) -> Self {
        match outcome {
            StencilOutcome::Fail => Self::Fail { after },
            StencilOutcome::DepthFail => Self::DepthFail { after },
            StencilOutcome::Pass => Self::Pass { after },
        }
    }
}

/// Draws in order; each pixel keeps its stencil value, its depth and the last draw that passed.
///
/// Triangles of no area and pixels off the image draw nothing. Cost: about 20 ns a fragment.
pub fn draw(draws: &[Draw], settings: &Settings) -> Image {
    draw_traced(draws, settings, &mut Tally::default(), &mut NoTrace)
}

/// [`draw`] as a run that can be scrubbed.
pub fn play(draws: Vec<Draw>, settings: Settings, budget: Budget) -> Player<Snapshot> {
    let draws: Arc<[Draw]> = draws.into();
    Player::new(Snapshot::new(Arc::clone(&draws), settings), budget, move |t| {
        draw_traced(&draws, &settings, &mut Tally::default(), t);
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
pub fn draw_traced<T: Tracer<Event>>(
    draws: &[Draw],
    settings: &Settings,
    tally: &mut Tally,
    t: &mut T,
) -> Image {
    let mut image = settings.empty();
    for (draw, index) in draws.iter().zip(0..) {
        t.emit(|| Event::Draw { index });
        if draw.enlarged.is_some() {
            t.emit(|| Event::Enlarge { corners: 3 * draw.triangles.len() as u32 });
        }
        let cuts = draw.rules.iter().any(|rules| rules.cutout.is_some());
        let when = Early::of(cuts, draw.depth.test, draw.stencil.as_ref());
        if cuts {
            t.emit(|| Event::Early { when });
        }
        let mut counts = [0; 3];
        for (i, triangle) in draw.triangles.iter().enumerate() {
            let rules = draw.rules.get(i).copied().unwrap_or_default();
            let triangle = (*triangle, rules, when);
            draw_triangle_traced(triangle, (draw, index), settings, (&mut image, &mut counts), tally, t);
        }
        let [failed, depth_failed, passed] = counts;
        t.emit(|| Event::Done { failed, depth_failed, passed });
    }
    image
}

/// One triangle of [`draw_traced`]; counts its fragments by their outcomes.
fn draw_triangle_traced<T: Tracer<Event>>(
    (triangle, rules, when): (Triangle, Rules, Early),
    (draw, index): (&Draw, u32),
    settings: &Settings,
    (image, counts): (&mut Image, &mut [u32; 3]),
    tally: &mut Tally,
    t: &mut T,
) {
    let plane = DepthPlane::new(triangle, settings.raster.arithmetic, tally);
    let plane = plane.placed(&rules.placement, settings.format);
    let cut = rules.cut(triangle, tally);
    let mut signs = Tally::default();
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
            let pixel = [x, y];
            // Where no test looks at it, only a trace does.
            let code =
                if draw.depth.test || T::ENABLED { plane.code(pixel, settings.format, tally) } else { 0 };
            let (stored, depth) = (image.value(pixel), image.depth.code(pixel));
            t.emit(|| Event::Fragment { x: x as u16, stored, code, depth });
            let at = image.depth.index(pixel);
            let Image { depth, stencil, .. } = image;
            let stored = (&mut stencil[at], &mut depth.codes_mut(at..at + 1)[0]);
            let passes = |stored: &mut u32, _: &mut Tally| settings.format.test(draw.depth, code, stored);
            let keeps = |tally: &mut Tally| cut.as_ref().is_none_or(|cut| cut.keeps(pixel, tally));
            let Some(outcome) = when.test(draw.stencil.as_ref(), stored, (passes, keeps), tally) else {
                let alpha = cut.as_ref().map_or(1.0, |cut| cut.alpha(pixel, tally));
                t.emit(|| Event::Discard { alpha });
                continue;
            };
            counts[outcome as usize] += 1;
            if outcome == StencilOutcome::Pass && draw.visible {
                image.show(pixel, index);
            }
            t.emit(|| Event::of(outcome, image.stencil[at]));
        }
    });
    *tally += signs;
}
