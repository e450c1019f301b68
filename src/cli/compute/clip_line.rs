//! `clip_line`: a segment against a window.

use rasterscope_core::{
    clip::line::{Algorithm, Outcode, Segment, Window, cohen_sutherland},
    math::{Arithmetic, Tally},
    message::Message,
    scene::{LabInput, Scene},
    trace::NoTrace,
};
use serde::Serialize;

use super::{
    Request, lab_scene,
    refusal::{Refusal, text},
    wide,
};

/// What a `clip_line` request asks for.
struct Input {
    window: [f32; 4],
    segment: [f32; 4],
    arithmetic: Arithmetic,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let names = ("algorithm", "unknown-algorithm");
        request.choice(names, &Algorithm::ALL, Algorithm::name, &["liang-barsky"])?;
        Ok(Self {
            window: request.required("window")?.numbers()?,
            segment: request.required("segment")?.numbers()?,
            arithmetic: request.arithmetic_of(&[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64])?,
        })
    }

    fn window(&self) -> Result<Window, Refusal> {
        Window::new(self.window).ok_or_else(|| {
            let message = Message::new("error-empty-window").with("field", text("window"));
            Refusal::new("bad-window", message)
        })
    }
}

/// The visible part of the segment; `null` if there is none. The outcodes are those of the ends
/// as they were given.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    visible: bool,
    segment: Option<[f64; 4]>,
    outcodes: [Outcode; 2],
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let input = Input::read(request)?;
    let window = input.window()?;
    let [x0, y0, x1, y1] = input.segment;
    let ends: Segment = [[x0, y0], [x1, y1]];
    let clipped =
        cohen_sutherland::clip_traced(ends, &window, input.arithmetic, &mut Tally::default(), &mut NoTrace);
    if clipped.is_some_and(|ends| ends.as_flattened().iter().any(|v| !v.is_finite())) {
        return Err(Refusal::overflow(input.arithmetic));
    }
    Ok(Answer {
        visible: clipped.is_some(),
        segment: clipped.map(|[p, q]| wide([p[0], p[1], q[0], q[1]])),
        outcodes: ends.map(|end| Outcode::of(end, input.window)),
    })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let input = Input::read(request)?;
    input.window()?;
    let Input { window, segment, arithmetic } = input;
    Ok(lab_scene([64, 64], LabInput::CohenSutherland { window, segment, arithmetic }))
}
