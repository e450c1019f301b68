//! Where light is computed: once for each face, at its vertices, or at each of its pixels. The vertex
//! and the fragment stage with what goes into each and what comes out.
//!
//! *Source:* Gouraud, Continuous Shading of Curved Surfaces, 1971; Phong, Illumination for Computer
//! Generated Pictures, 1975; Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section
//! 16.2. Deviation: what is interpolated is the exact value in perspective, rounded once, as everywhere
//! in the pipeline.

mod explain;
mod picture;
mod snapshot;
mod tables;

pub use snapshot::Snapshot;

use super::{Illumination, Surface, lighting};
use crate::{
    depth::{DepthBuffer, DepthFormat, DepthPlane, DepthState},
    math::{Arithmetic, Tally},
    pipeline::{self, DrawOutputs, Outputs, Piece, Shader},
    raster::{self, Algorithm, edge::centre},
    replay::{Budget, Player},
    scene::{Scene, Shade, Texture},
    trace::{Lift, NoTrace, Tracer},
};
use serde::Serialize;
use std::sync::Arc;

/// A scene, its vertices on the screen already.
#[derive(Debug)]
pub struct Subject {
    pub(super) outputs: Outputs,
    pub(super) objects: Vec<Object>,
    pub(super) raster: raster::Settings,
    format: DepthFormat,
    clear_depth: f32,
}

/// What is drawn, and how.
#[derive(Debug)]
pub(super) struct Object {
    pub(super) name: String,
    pub(super) shade: Shade,
    pub(super) illumination: Illumination,
    texture: Option<Texture>,
    depth: DepthState,
}

/// A subject is built once for a run: another one is another run's.
impl PartialEq for Subject {
    fn eq(&self, other: &Self) -> bool {
        std::ptr::eq(self, other)
    }
}

impl Subject {
    /// From a resolved scene. Depth is tested; stencil, blending and samples are other labs'.
    pub fn new(scene: &Scene) -> Self {
        let object = |(index, draw): (usize, &crate::scene::Draw)| Object {
            name: pipeline::draw_name((index, draw)),
            shade: draw.shade,
            illumination: Illumination::new(&scene.camera, &scene.lights, draw.material),
            texture: draw.texture,
            depth: draw.depth,
        };
        Self {
            outputs: pipeline::geometry(scene),
            objects: scene.draws.iter().enumerate().map(object).collect(),
            raster: raster::Settings {
                fill_rule: scene.fill_rule,
                y_axis: scene.y_axis,
                ..raster::Settings::new(scene.size)
            },
            format: scene.depth_format,
            clear_depth: scene.clear.depth,
        }
    }

    fn empty(&self) -> Image {
        let [width, height] = self.raster.size;
        Image { size: [width, height], pixels: vec![None; width as usize * height as usize] }
    }
}

/// What a pixel shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shown {
    /// Its colour, floor(255 c + 1/2) of each channel.
    pub code: [u8; 4],
    /// The largest of red, green and blue before that, rounded to binary32.
    pub value: f32,
    /// Which object it belongs to, and which piece of that.
    pub(super) owner: (u16, u32),
}

/// What has been drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Row by row; `None` where nothing is drawn.
    pub pixels: Vec<Option<Shown>>,
}

impl Image {
    fn index(&self, [x, y]: [u32; 2]) -> usize {
        y as usize * self.size[0] as usize + x as usize
    }

    /// What a pixel of the image shows.
    pub fn at(&self, pixel: [u32; 2]) -> Option<Shown> {
        self.pixels[self.index(pixel)]
    }

    fn show(&mut self, pixel: [u32; 2], shown: Shown) {
        let index = self.index(pixel);
        self.pixels[index] = Some(shown);
    }
}

/// An interpolated input of the fragment stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Input {
    /// The place in world space.
    Place,
    /// The normal in world space.
    Normal,
    /// Red, green and blue.
    Color,
    /// Texture coordinates, and 0.
    Uv,
}

/// What the algorithm did. At most 16 bytes beyond the events of a light, which it lifts: 24.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub enum Event {
    /// An object begins.
    Object {
        /// Which.
        index: u16,
    },
    /// The vertex stage runs for a vertex: its clip position, place and normal.
    Vertex {
        /// Which.
        index: u32,
    },
    /// A step of a light.
    Light(lighting::Event),
    /// What the vertex stage gives for the colour: lit by Gouraud, else as it came.
    VertexColor {
        /// Which mode.
        shade: Shade,
        /// Red, green, blue.
        color: [f32; 3],
    },
    /// A triangle on the screen begins.
    Triangle {
        /// Which piece of the object.
        piece: u32,
    },
    /// The factor of a whole face.
    Face {
        /// Rounded once.
        factor: f32,
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
    /// The depth test fails: no fragment stage runs.
    Hidden {
        /// The column; images have at most 16384.
        x: u16,
    },
    /// The fragment stage runs for a pixel.
    Fragment {
        /// The column.
        x: u16,
    },
    /// What it is given.
    Varying {
        /// What it is.
        input: Input,
        /// The exact value, rounded once.
        value: [f32; 3],
    },
    /// What it gives.
    Output {
        /// Which mode.
        shade: Shade,
        /// The codes that are stored.
        code: [u8; 4],
        /// The largest of red, green and blue before rounding to a code.
        value: f32,
    },
    /// A triangle is done.
    Done {
        /// Pixels that it drew.
        drawn: u32,
        /// Pixels that were hidden.
        hidden: u32,
    },
}
const _: () = assert!(size_of::<Event>() <= 24);

/// The image of a scene.
pub fn draw(subject: &Subject) -> Image {
    draw_traced(subject, &mut Tally::default(), &mut NoTrace)
}

/// [`draw`] as a run that can be scrubbed.
pub fn play(subject: Arc<Subject>, budget: Budget) -> Player<Snapshot> {
    Player::new(Snapshot::new(Arc::clone(&subject)), budget, move |t| {
        draw_traced(&subject, &mut Tally::default(), t);
    })
}

/// The algorithm: [`draw`] and [`play`] are this with two tracers.
///
/// The vertex stage has run for all vertices when a triangle is assembled, so without a tracer its
/// results are those of the pipeline. `tally` counts exact decisions.
pub fn draw_traced<T: Tracer<Event>>(subject: &Subject, tally: &mut Tally, t: &mut T) -> Image {
    let mut image = subject.empty();
    let mut depth = DepthBuffer::new(subject.raster.size, subject.format, subject.clear_depth);
    for (index, (object, stages)) in (0..).zip(subject.objects.iter().zip(&subject.outputs.draws)) {
        t.emit(|| Event::Object { index });
        if T::ENABLED {
            (0..stages.clip().len()).for_each(|vertex| vertex_stage(object, stages, vertex, t));
        }
        for (number, piece) in (0..).zip(&stages.clipped().pieces) {
            t.emit(|| Event::Triangle { piece: number });
            let Some(shader) = Shader::new(stages, piece, object.texture, tally) else {
                t.emit(|| Event::Done { drawn: 0, hidden: 0 });
                continue;
            };
            if T::ENABLED && object.shade == Shade::Flat {
                face(object, stages, piece, t);
            }
            let mut target = Target { subject, object, owner: (index, number), image: &mut image };
            target.triangle(corners(stages, piece), &shader, (&mut depth, tally), t);
        }
    }
    image
}

/// The corners of a piece on the screen: x and y in pixels, depth.
fn corners(stages: &DrawOutputs, piece: &Piece) -> [[f32; 3]; 3] {
    piece.corners.map(|i| stages.screen()[i as usize]).map(|[x, y, z, _]| [x, y, z])
}

/// The vertex stage for one vertex: what the pipeline computed, and the light on it.
fn vertex_stage<T: Tracer<Event>>(object: &Object, stages: &DrawOutputs, vertex: usize, t: &mut T) {
    t.emit(|| Event::Vertex { index: vertex as u32 });
    let own = stages.mesh().colors[vertex];
    let color = match surface(stages, vertex) {
        Some(surface) if object.shade == Shade::Gouraud => {
            let brightness = object.illumination.at_traced(surface, &mut Lift(t, Event::Light));
            debug_assert_eq!(brightness.of(own), stages.lit().colors[vertex], "the same text");
            brightness.of(own)
        }
        _ => own,
    };
    let [r, g, b, _] = color;
    t.emit(|| Event::VertexColor { shade: object.shade, color: [r, g, b] });
}

/// Place and normal of a vertex in world space; `None` if vertices need no normal.
pub(super) fn surface(stages: &DrawOutputs, vertex: usize) -> Option<Surface> {
    let normal = *stages.lit().normals.get(vertex)?;
    let [x, y, z, _] = stages.world()[vertex];
    Some(Surface { position: [x, y, z], normal })
}

/// The light on a whole face.
fn face<T: Tracer<Event>>(object: &Object, stages: &DrawOutputs, piece: &Piece, t: &mut T) {
    let factor = object.illumination.of_face_traced(world_corners(stages, piece), &mut Lift(t, Event::Light));
    t.emit(|| Event::Face { factor });
}

/// The corners of the triangle of a piece in world space, before clipping.
pub(super) fn world_corners(stages: &DrawOutputs, piece: &Piece) -> [[f32; 3]; 3] {
    stages.mesh().triangles[piece.triangle as usize].map(|i| {
        let [x, y, z, _] = stages.world()[i as usize];
        [x, y, z]
    })
}

/// What a triangle is drawn to.
struct Target<'a> {
    subject: &'a Subject,
    object: &'a Object,
    owner: (u16, u32),
    image: &'a mut Image,
}

impl Target<'_> {
    fn triangle<T: Tracer<Event>>(
        &mut self,
        corners: [[f32; 3]; 3],
        shader: &Shader,
        (depth, tally): (&mut DepthBuffer, &mut Tally),
        t: &mut T,
    ) {
        let plane = DepthPlane::new(corners, Arithmetic::Exact, tally);
        let points = corners.map(|[x, y, _]| [x, y]);
        let (mut drawn, mut hidden) = (0, 0);
        let mut signs = Tally::default();
        raster::cover(Algorithm::Scanline, points, &self.subject.raster, &mut signs, &mut |span| {
            let raster::Span { y, begin, end } = span;
            t.emit(|| Event::Row { y, begin, end });
            for x in begin..end {
                let code = plane.code([x, y], self.subject.format, tally);
                if !depth.test(self.object.depth, [x, y], code) {
                    hidden += 1;
                    t.emit(|| Event::Hidden { x: x as u16 });
                    continue;
                }
                drawn += 1;
                self.fragment_stage([x, y], shader, tally, t);
            }
        });
        *tally += signs;
        t.emit(|| Event::Done { drawn, hidden });
    }

    /// The fragment stage for one pixel.
    fn fragment_stage<T: Tracer<Event>>(
        &mut self,
        pixel: [u32; 2],
        shader: &Shader,
        tally: &mut Tally,
        t: &mut T,
    ) {
        t.emit(|| Event::Fragment { x: pixel[0] as u16 });
        let point = centre(pixel[0], pixel[1]);
        if T::ENABLED {
            let inputs = shader.inputs(point, tally);
            if let Some(Surface { position, normal }) = inputs.surface {
                t.emit(|| Event::Varying { input: Input::Place, value: position });
                t.emit(|| Event::Varying { input: Input::Normal, value: normal });
            }
            if let Some([u, v]) = inputs.uv {
                t.emit(|| Event::Varying { input: Input::Uv, value: [u, v, 0.0] });
            }
            let [r, g, b, _] = inputs.color;
            t.emit(|| Event::Varying { input: Input::Color, value: [r, g, b] });
        }
        let color = shader.at_traced(point, tally, &mut Lift(t, Event::Light));
        let code = color.codes(tally);
        let [r, g, b, _] = color.values(tally);
        let value = r.max(g).max(b);
        self.image.show(pixel, Shown { code, value, owner: self.owner });
        t.emit(|| Event::Output { shade: self.object.shade, code, value });
    }
}
