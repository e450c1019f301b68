//! `clip_line`: a segment against a window.

use rasterscope_core::{
    clip::line::{
        Algorithm, Mistakes, Outcode, Segment, Window, cohen_sutherland, liang_barsky, midpoint,
        nicholl_lee_nicholl,
    },
    labs,
    math::{Arithmetic, Tally},
    message::Message,
    scene::Scene,
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
    algorithm: Algorithm,
    window: [f32; 4],
    segment: [f32; 4],
    arithmetic: Arithmetic,
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let names = ("algorithm", "unknown-algorithm");
        let algorithm = request.choice(names, &Algorithm::ALL, Algorithm::name, &[])?;
        Ok(Self {
            algorithm: algorithm.unwrap_or_default(),
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

/// The visible part of the segment; `null` if there is none. Cohen-Sutherland adds the outcodes of
/// the ends as they were given, Liang-Barsky the parameters of what is visible.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    visible: bool,
    segment: Option<[f64; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    outcodes: Option<[Outcode; 2]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    t: Option<[f64; 2]>,
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let input = Input::read(request)?;
    let window = input.window()?;
    let [x0, y0, x1, y1] = input.segment;
    let ends: Segment = [[x0, y0], [x1, y1]];
    let (arithmetic, mut tally) = (input.arithmetic, Tally::default());
    let (clipped, outcodes, t) = match input.algorithm {
        Algorithm::CohenSutherland => {
            let clipped = cohen_sutherland::clip_traced(ends, &window, arithmetic, &mut tally, &mut NoTrace);
            (clipped, Some(ends.map(|end| Outcode::of(end, input.window))), None)
        }
        Algorithm::LiangBarsky => {
            let visible = liang_barsky::clip_traced(ends, &window, arithmetic, &mut tally, &mut NoTrace);
            (visible.map(|visible| visible.segment), None, visible.map(|visible| visible.t))
        }
        Algorithm::NichollLeeNicholl => {
            let clipped =
                nicholl_lee_nicholl::clip_traced(ends, &window, arithmetic, &mut tally, &mut NoTrace);
            (clipped, None, None)
        }
        Algorithm::Midpoint => {
            (midpoint::clip_traced(ends, &window, arithmetic, &mut tally, &mut NoTrace), None, None)
        }
    };
    let mut numbers = clipped.iter().flatten().chain(&t).flatten();
    if numbers.any(|v| !v.is_finite()) {
        return Err(Refusal::overflow(input.arithmetic));
    }
    Ok(Answer {
        visible: clipped.is_some(),
        segment: clipped.map(|[p, q]| wide([p[0], p[1], q[0], q[1]])),
        outcodes,
        t: t.map(wide),
    })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let input = Input::read(request)?;
    input.window()?;
    let Input { algorithm, window, segment, arithmetic } = input;
    let mistakes = Mistakes::NONE;
    Ok(lab_scene([64, 64], labs::ClipLine { algorithm, window, segment, arithmetic, mistakes }))
}
