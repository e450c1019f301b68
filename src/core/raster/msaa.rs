//! Multisampling: several samples a pixel decide what is covered, one or all of them are shaded, and the
//! pixel shows their mean.
//!
//! *Source:* Direct3D 11.3 functional specification, sections 3.5.4 (coverage), 3.5.5 (centroid) and 19.2
//! (positions); Akeley, RealityEngine Graphics, SIGGRAPH 1993. Deviation: each sample is decided exactly,
//! for unsnapped vertices.

mod explain;
mod picture;

pub use explain::Snapshot;

use super::{
    Edges, Settings,
    edge::centre,
    samples::{Samples, pixel_box},
};
use crate::{
    interpolate::barycentric::determinant,
    math::{Approx, Dyadic, Sign, Tally, edge_value, rounded_code},
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::{Deserialize, Serialize};

/// A triangle with a shade: x and y in pixels, the shade from 0, black, to 1, white.
pub type Triangle = [[f32; 3]; 3];

/// Where the shade of a pixel is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Shading {
    /// Once, at the pixel's centre, which may lie outside the triangle.
    #[default]
    Centre,
    /// Once, at the centre if all samples are inside, else at the first sample that is.
    Centroid,
    /// At each sample that is inside.
    PerSample,
}

impl Shading {
    /// All of them, the default first.
    pub const ALL: [Self; 3] = [Self::Centre, Self::Centroid, Self::PerSample];

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Centre => "word-shading-centre",
            Self::Centroid => "word-shading-centroid",
            Self::PerSample => "word-shading-per-sample",
        }
    }
}

/// What is drawn, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Conventions {
    /// The pattern.
    pub samples: Samples,
    /// Where shades are computed.
    pub shading: Shading,
    /// Size, tie rule and y axis.
    pub raster: Settings,
}

/// What the algorithm did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// A triangle begins.
    Triangle {
        /// Which one.
        index: u32,
    },
    /// It has no area.
    ZeroArea,
    /// The next pixel of its box.
    Pixel {
        /// Column; images have at most 16384.
        x: u16,
        /// Row.
        y: u16,
    },
    /// A sample was held against the three edges.
    Sample {
        /// Which sample.
        index: u8,
        /// Whether it is inside.
        covered: bool,
        /// Whether it lies exactly on an edge, so that the tie rule decided.
        tie: bool,
    },
    /// The samples inside; 0 draws nothing.
    Mask {
        /// The first sample in the lowest bit.
        mask: u8,
    },
    /// A shade was computed and stored.
    Shade {
        /// Where.
        shading: Shading,
        /// At this sample; `None`: at the pixel's centre.
        at: Option<u8>,
        /// Which samples got it.
        mask: u8,
        /// The shade's code.
        code: u8,
    },
    /// The pixel shows the mean of its samples.
    Resolve {
        /// Column.
        x: u16,
        /// Row.
        y: u16,
        /// The mean's code.
        code: u8,
    },
    /// All is done.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// The samples of an image, and what it shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Image {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The code of each sample; 0 where nothing was drawn.
    pub samples: Vec<[u8; Samples::MOST]>,
    /// Which samples were drawn.
    pub masks: Vec<u8>,
    /// What each pixel shows, once resolved.
    pub codes: Vec<u8>,
}

impl Image {
    /// Nothing drawn, black.
    pub fn new(size: [u32; 2]) -> Self {
        let pixels = size[0] as usize * size[1] as usize;
        Self {
            size,
            samples: vec![[0; Samples::MOST]; pixels],
            masks: vec![0; pixels],
            codes: vec![0; pixels],
        }
    }

    /// Where a pixel of the image stands.
    pub fn index(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.size[0] as usize + x as usize
    }

    fn store(&mut self, pixel: [u32; 2], mask: u8, code: u8) {
        let index = self.index(pixel);
        self.masks[index] |= mask;
        for (sample, stored) in self.samples[index].iter_mut().enumerate() {
            if mask & 1 << sample != 0 {
                *stored = code;
            }
        }
    }
}

/// Draws triangles in order, the last one on top, and resolves every pixel.
///
/// Finite vertices; zero area and what is off the image draw nothing. A shade at a point outside the
/// triangle is extrapolated, then kept within 0..=1. Cost: up to 3 signs a sample of each bounding box.
pub fn draw(triangles: &[Triangle], conventions: &Conventions) -> Image {
    draw_traced(triangles, conventions, &mut Tally::default(), &mut NoTrace)
}

/// [`draw`] as a run that can be scrubbed.
pub fn play(triangles: Vec<Triangle>, conventions: Conventions, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(&triangles, conventions), budget, move |t| {
        draw_traced(&triangles, &conventions, &mut Tally::default(), t);
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
pub fn draw_traced<T: Tracer<Event>>(
    triangles: &[Triangle],
    conventions: &Conventions,
    tally: &mut Tally,
    t: &mut T,
) -> Image {
    let Conventions { samples, raster, .. } = conventions;
    let mut image = Image::new(raster.size);
    for (triangle, index) in triangles.iter().zip(0..) {
        t.emit(|| Event::Triangle { index });
        let points = raster.vertices(triangle.map(|[x, y, _]| [x, y]));
        let triangle = [0, 1, 2].map(|i| [points[i][0], points[i][1], triangle[i][2]]);
        let Some(edges) = Edges::new(points, raster, tally) else {
            t.emit(|| Event::ZeroArea);
            continue;
        };
        let [columns, rows] = pixel_box(points, raster.size);
        for pixel in rows.flat_map(|y| columns.clone().map(move |x| [x, y])) {
            t.emit(|| Event::Pixel { x: pixel[0] as u16, y: pixel[1] as u16 });
            let mask = if T::ENABLED {
                trace_mask(&edges, pixel, conventions, tally, t)
            } else {
                samples.mask(&edges, pixel, raster.y_axis, tally)
            };
            t.emit(|| Event::Mask { mask });
            shade(&triangle, pixel, mask, conventions, &mut image, tally, t);
        }
    }
    for (index, mask) in image.masks.iter().enumerate().filter(|(_, mask)| **mask != 0) {
        debug_assert!(*mask <= samples.full());
        let code = samples.resolve(&image.samples[index]);
        image.codes[index] = code;
        let [x, y] = [index % raster.size[0] as usize, index / raster.size[0] as usize].map(|n| n as u16);
        t.emit(|| Event::Resolve { x, y, code });
    }
    t.emit(|| Event::Done);
    image
}

/// [`Samples::mask`], sample by sample.
fn trace_mask<T: Tracer<Event>>(
    edges: &Edges,
    pixel: [u32; 2],
    conventions: &Conventions,
    tally: &mut Tally,
    t: &mut T,
) -> u8 {
    let Conventions { samples, raster, .. } = conventions;
    let mut mask = 0;
    for index in 0..samples.count() as u8 {
        let point = samples.point(pixel, index.into(), raster.y_axis);
        let covered = edges.cover(point, tally);
        let sides = edges.0.map(|edge| edge.side(point, tally));
        let tie = sides.contains(&Sign::Zero) && !sides.contains(&Sign::Negative);
        t.emit(|| Event::Sample { index, covered, tie });
        mask |= u8::from(covered) << index;
    }
    mask
}

/// Computes and stores the shades of a pixel.
fn shade<T: Tracer<Event>>(
    triangle: &Triangle,
    pixel: [u32; 2],
    mask: u8,
    conventions: &Conventions,
    image: &mut Image,
    tally: &mut Tally,
    t: &mut T,
) {
    let Conventions { samples, shading, raster } = *conventions;
    let mut at = |sample: Option<u8>, mask: u8| {
        let point = match sample {
            Some(index) => samples.point(pixel, index.into(), raster.y_axis),
            None => centre(pixel[0], pixel[1]),
        };
        let code = code_at(triangle, point, tally);
        image.store(pixel, mask, code);
        t.emit(|| Event::Shade { shading, at: sample, mask, code });
    };
    if mask == 0 {
        return;
    }
    match shading {
        Shading::Centre => at(None, mask),
        Shading::Centroid if mask == samples.full() => at(None, mask),
        Shading::Centroid => at(Some(mask.trailing_zeros() as u8), mask),
        Shading::PerSample => {
            (0..samples.count() as u8).filter(|index| mask & 1 << index != 0).for_each(|index| {
                at(Some(index), 1 << index);
            });
        }
    }
}

/// The shade's plane at any point: the exact value's code, kept within 0..=255.
fn code_at(&[a, b, c]: &Triangle, point: [f32; 2], tally: &mut Tally) -> u8 {
    let [pa, pb, pc] = [a, b, c].map(|[x, y, _]| [x, y]);
    let edges = [[pb, pc], [pc, pa], [pa, pb]];
    let values = [a[2], b[2], c[2]];
    let [e0, e1, e2] = edges.map(|[from, to]| edge_value(from, to, point));
    let [z0, z1, z2] = values.map(Approx::from);
    let approx = (e0 * z0 + e1 * z1 + e2 * z2) / (e0 + e1 + e2);
    let exact = || {
        let [e0, e1, e2] = edges.map(|[from, to]| determinant(from, to, point));
        let [z0, z1, z2] = values.map(Dyadic::from);
        (&e0 * &z0 + &e1 * &z1 + &e2 * &z2, e0 + e1 + e2)
    };
    rounded_code(approx, 255, exact, tally) as u8
}
