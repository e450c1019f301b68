//! `rasterscope compute`: one JSON request in, one JSON answer out.
//!
//! Every line gets exactly one answer, a blank line too: whatever stands in it, the answer is the
//! result or an error object `{"error":{"code":"..","message":".."}}`, and the next line is
//! answered as usual. Numbers are read as binary64 and rounded to binary32; results are widened
//! to binary64 and printed so that reading them back gives the same value.
//!
//! | code | the request |
//! |---|---|
//! | `malformed` | is not one JSON object |
//! | `not-utf8` | is not UTF-8 |
//! | `too-long` | has more than [`MOST_BYTES`] |
//! | `too-deep` | nests more than 127 lists or objects |
//! | `not-finite` | holds NaN, an infinity or a number that rounds to an infinite binary32 |
//! | `missing-field`, `bad-field` | lacks a field; has one of the wrong type or length, such as a polygon of two corners |
//! | `bad-window` | has a window whose minimum is above its maximum |
//! | `bad-size` | asks for a side outside 1..=16384 or for more than 2^28 pixels |
//! | `unknown-op`, `unknown-algorithm`, `unknown-arithmetic`, ... | has a name that nobody knows |
//! | `unsupported` | has a name of the interface that this version does not know yet |
//! | `bad-scene`, `missing-model` | has a scene that is wrong, or that names a model that cannot be read |
//! | `zero-area`, `outside-triangle`, `zero-w`, `infinite` | asks for an attribute where there is none |
//! | `no-lab` | cannot be stepped (`trace` and `figure` only) |
//! | `overflow` | has no finite answer in the chosen arithmetic |

mod clip_line;
mod clip_polygon;
mod clip_triangle;
mod coverage;
mod depth;
mod fill_polygon;
mod interpolate;
mod line;
mod lines;
mod refusal;
mod render;
mod request;

pub use lines::MOST_BYTES;
pub(crate) use refusal::Refusal;
pub(crate) use request::Request;

use rasterscope_core::{
    labs::LabInput,
    scene::{Lab, Scene},
};
use serde::Serialize;
use std::{
    io::{self, BufRead, Cursor, Write},
    path::Path,
};

use crate::{Failure, failure::written, files};
use refusal::ErrorObject;

/// The operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Op {
    ClipLine,
    ClipPolygon,
    ClipTriangle,
    Coverage,
    Depth,
    FillPolygon,
    Interpolate,
    Line,
    Point,
    Render,
}

impl Op {
    const ALL: [Self; 10] = [
        Self::ClipLine,
        Self::ClipPolygon,
        Self::ClipTriangle,
        Self::Coverage,
        Self::Depth,
        Self::FillPolygon,
        Self::Interpolate,
        Self::Line,
        Self::Point,
        Self::Render,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::ClipLine => "clip_line",
            Self::ClipPolygon => "clip_polygon",
            Self::ClipTriangle => "clip_triangle",
            Self::Coverage => "coverage",
            Self::Depth => "depth",
            Self::FillPolygon => "fill_polygon",
            Self::Interpolate => "interpolate",
            Self::Line => "line",
            Self::Point => "point",
            Self::Render => "render",
        }
    }

    fn of(request: &Request) -> Result<Self, Refusal> {
        request.required("op")?;
        let op = request.choice(("op", "unknown-op"), &Self::ALL, Self::name, &[])?;
        Ok(op.unwrap_or(Self::ClipLine))
    }
}

/// Answers the request that is the whole input, or with `lines` one request a line; each answer is
/// one line, flushed at once.
pub fn compute(input: &mut dyn BufRead, lines: bool, output: &mut dyn Write) -> Result<(), Failure> {
    let mut line = Vec::new();
    let end = lines.then_some(b'\n');
    loop {
        let read = match lines::next(input, end, &mut line) {
            Ok(lines::Read::End) if lines => return Ok(()),
            Ok(read) => read,
            Err(error) => return Err(Failure::input(&error)),
        };
        let result = match read {
            lines::Read::TooLong => write_line(&ErrorObject::from(&lines::too_long()), output),
            _ => answer(&line, output),
        };
        match result {
            Ok(()) if lines => {}
            result => return written(result),
        }
    }
}

/// Answers the one request of a file.
pub fn compute_file(path: &Path, output: &mut dyn Write) -> Result<(), Failure> {
    compute(&mut Cursor::new(files::read(path)?), false, output)
}

/// Writes the answer to one request, as one line.
pub fn answer(request: &[u8], output: &mut dyn Write) -> io::Result<()> {
    let request = Request::parse(request);
    match request.and_then(|request| dispatch(&request)) {
        Ok(answer) => write_line(&answer, output),
        Err(refusal) => write_line(&ErrorObject::from(&refusal), output),
    }
}

/// The answer of each operation.
#[derive(Serialize)]
#[serde(untagged)]
enum Answer {
    ClipLine(clip_line::Answer),
    ClipPolygon(clip_polygon::Answer),
    ClipTriangle(clip_triangle::Answer),
    Coverage(coverage::Answer),
    Depth(depth::Answer),
    FillPolygon(fill_polygon::Answer),
    Interpolate(interpolate::Answer),
    Line(line::Answer),
    Render(render::Answer),
}

fn dispatch(request: &Request) -> Result<Answer, Refusal> {
    match Op::of(request)? {
        Op::ClipLine => clip_line::answer(request).map(Answer::ClipLine),
        Op::ClipPolygon => clip_polygon::answer(request).map(Answer::ClipPolygon),
        Op::ClipTriangle => clip_triangle::answer(request).map(Answer::ClipTriangle),
        Op::Coverage => coverage::answer(request).map(Answer::Coverage),
        Op::Depth => depth::answer(request).map(Answer::Depth),
        Op::FillPolygon => fill_polygon::answer(request).map(Answer::FillPolygon),
        Op::Line => line::answer(request).map(Answer::Line),
        Op::Point => line::answer_point(request).map(Answer::FillPolygon),
        Op::Interpolate => interpolate::answer(request).map(Answer::Interpolate),
        Op::Render => render::answer(request).map(Answer::Render),
    }
}

/// The scene that opens the lab for what a request describes.
pub(crate) fn lab(request: &Request) -> Result<Scene, Refusal> {
    match Op::of(request)? {
        Op::ClipLine => clip_line::lab(request),
        Op::ClipPolygon => clip_polygon::lab(request),
        Op::Coverage => coverage::lab(request),
        Op::Depth => depth::lab(request),
        Op::FillPolygon => fill_polygon::lab(request),
        Op::Line => line::lab(request),
        Op::Point => line::lab_point(request),
        Op::Render => render::scene(request),
        op @ (Op::ClipTriangle | Op::Interpolate) => Err(Refusal::no_lab(op.name())),
    }
}

/// A scene without triangles that opens a lab at its end.
fn lab_scene(size: [u32; 2], input: impl Into<LabInput>) -> Scene {
    Scene { lab: Some(Lab::new(input)), ..Scene::empty(size) }
}

fn write_line(answer: &impl Serialize, output: &mut dyn Write) -> io::Result<()> {
    serde_json::to_writer(&mut *output, answer)?;
    output.write_all(b"\n")?;
    output.flush()
}

/// Binary32 numbers as they go over the wire: the same values as binary64.
fn wide<const N: usize>(numbers: [f32; N]) -> [f64; N] {
    numbers.map(f64::from)
}
