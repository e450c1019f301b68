//! How cost grows: the same frame with ever more triangles, and with ever more pixels.
//!
//! Right-angled triangles lie anywhere in a square image, at any depth, and nearer ones win. With more
//! triangles, each keeps its size; with more pixels, the whole picture is enlarged.

use rasterscope_core::{
    cull::CullMode,
    depth::z_buffer::{self, Triangle},
    engine::{Canvas, Clear, Colors, Engine, State, Stencil, Triangles},
    pipeline::{Pipeline, Skips},
    raster::Algorithm,
    scene::{Draw, Geometry, Mesh, Scene},
    stress::Random,
    transform::{Camera, Projection},
};
use serde::Serialize;
use std::{hint::black_box, sync::Arc};

use crate::{Stopwatch, stopwatch::quartiles};

/// What there is more and more of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Growing {
    /// Triangles of one size.
    Triangles,
    /// Pixels of one picture.
    Pixels,
}

impl Growing {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Triangles, Self::Pixels];

    /// `bench-growing-NAME` is what people call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Triangles => "triangles",
            Self::Pixels => "pixels",
        }
    }

    /// How many times as many as in the first frame.
    pub fn factors(self) -> [u32; 4] {
        match self {
            Self::Triangles => [1, 10, 100, 1_000],
            Self::Pixels => [1, 4, 16, 64],
        }
    }

    /// How many triangles there are, and the side of the image.
    fn frame(self, factor: u32) -> (u32, u32) {
        match self {
            Self::Triangles => (FEW * factor, SIDE),
            Self::Pixels => (MANY, SMALL * factor.isqrt()),
        }
    }
}

const FEW: u32 = 10;
const SIDE: u32 = 512;
/// Legs of the triangles of which there are more and more, in pixels.
const LEG: f64 = 32.0;
const MANY: u32 = 100;
const SMALL: u32 = 128;
/// Legs of the triangles of the enlarged picture, as a part of its side.
const PART: f64 = 0.25;

/// The methods: `bench-method-NAME` is what people call one.
pub const METHODS: [&str; 3] = ["pipeline", "z-buffer", "engine"];

/// The time of one frame by one method.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Frame {
    /// What grows.
    pub growing: Growing,
    /// How many times as many there are as in the first frame.
    pub factor: u32,
    /// The method.
    pub method: &'static str,
    /// Triangles of the frame.
    pub triangles: u32,
    /// Pixels of the image.
    pub pixels: u32,
    /// The median time, in ms.
    pub ms: f64,
    /// The lower and the upper quartile.
    pub quartiles: [f64; 2],
}

/// Every frame that is measured: what grows, and how many times.
pub fn frames() -> impl Iterator<Item = (Growing, u32)> {
    Growing::ALL.into_iter().flat_map(|growing| growing.factors().map(|factor| (growing, factor)))
}

/// Measures one frame by each method, in turns; `None` if it was stopped.
pub fn measure(growing: Growing, factor: u32, stopwatch: &Stopwatch<'_>) -> Option<Vec<Frame>> {
    let (triangles, side) = growing.frame(factor);
    let leg = if growing == Growing::Triangles { LEG } else { PART * f64::from(side) };
    let soup = soup(triangles, f64::from(side), leg);
    let scene = scene(&soup, side);
    let settings = z_buffer::Settings::new([side; 2]);
    let positions = soup.as_flattened();
    let mut engine = Engine::default();
    let mut canvas = Canvas::new([side; 2], Clear::default(), Stencil::Without);
    let mut times: [Vec<f64>; 3] = Default::default();
    stopwatch.take_turns(METHODS.len(), |round, i| {
        let time = stopwatch.time(|| match i {
            0 => {
                let mut pipeline = Pipeline::new(Algorithm::Scanline);
                pipeline.update(&scene, &Skips::ALL);
                black_box(pipeline.into_frame());
            }
            1 => {
                black_box(z_buffer::draw(&soup, &settings));
            }
            _ => {
                let drawn = Triangles { positions, indices: None, colors: Colors::One([255; 4]) };
                black_box(engine.draw(&mut canvas, Some(Clear::default()), &drawn, &State::default()));
            }
        });
        if round > 0 {
            times[i].push(time * 1e-6);
        }
    });
    let frame = |(method, times): (&&'static str, Vec<f64>)| {
        let [low, ms, high] = quartiles(times);
        let pixels = side * side;
        Frame { growing, factor, method, triangles, pixels, ms, quartiles: [low, high] }
    };
    (stopwatch.wanted)().then(|| METHODS.iter().zip(times).map(frame).collect())
}

/// Triangles with legs of this length, anywhere in the image.
fn soup(count: u32, side: f64, leg: f64) -> Vec<Triangle> {
    let mut random = Random::new(600);
    let room = side - leg;
    (0..count)
        .map(|_| {
            // As parts, so that the enlarged picture is the same one.
            let [x, y] = [0, 1].map(|_| (f64::from(random.uniform(0.0, 1.0)) * room) as f32);
            let z = random.uniform(0.1, 0.9);
            [[x, y, z], [x + leg as f32, y, z], [x, y + leg as f32, z]]
        })
        .collect()
}

/// A scene that shows these triangles.
fn scene(soup: &[Triangle], side: u32) -> Scene {
    let camera = Camera { projection: Projection::Orthographic { height: 2.0 }, ..Camera::default() };
    let half = side as f32 / 2.0;
    let Camera { eye, near, far, .. } = camera;
    let place = |[x, y, z]: &[f32; 3]| [x / half - 1.0, 1.0 - y / half, eye[2] - near - z * (far - near)];
    let mesh = Mesh::soup(soup.as_flattened().iter().map(place).collect(), [1.0; 4]);
    let draw = Draw { cull: CullMode::None, ..Draw::new("", Geometry::Mesh(Arc::new(mesh))) };
    Scene { camera, draws: vec![draw], ..Scene::empty([side; 2]) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_methods_draw_the_same_pixels() {
        let soup = soup(40, 64.0, 16.0);
        let mut pipeline = Pipeline::new(Algorithm::Scanline);
        let frame = pipeline.update(&scene(&soup, 64), &Skips::ALL).frame.clone();
        let image = z_buffer::draw(&soup, &z_buffer::Settings::new([64; 2]));
        let mut canvas = Canvas::new([64; 2], Clear::default(), Stencil::Without);
        let positions = soup.as_flattened();
        let drawn = Triangles { positions, indices: None, colors: Colors::One([255; 4]) };
        Engine::default().draw(&mut canvas, None, &drawn, &State::default());
        let color = canvas.color();
        let (mut covered, mut differ) = (0, 0);
        for y in 0..64 {
            for x in 0..64 {
                let here = image.owner([x, y]).is_some();
                covered += usize::from(here);
                differ += usize::from(here != (frame.pixel([x, y])[3] > 0));
                assert_eq!(here, color[(y * 64 + x) as usize][3] > 0, "({x}, {y})");
            }
        }
        // The pipeline's vertices went through a camera, which rounds.
        assert!(covered > 1_000 && differ < covered / 50, "{differ} of {covered}");
    }
}
