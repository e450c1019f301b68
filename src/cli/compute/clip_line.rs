//! `clip_line`: a segment against a window.

use rasterscope_core::{
    clip::line::{
        Algorithm, ConvexWindow, Flaw, Mistakes, Outcode, Point, Segment, Window, cohen_sutherland,
        cyrus_beck, liang_barsky, midpoint, nicholl_lee_nicholl,
    },
    labs::{self, LabInput},
    math::{Arithmetic, Tally},
    message::Message,
    scene::Scene,
    trace::NoTrace,
};
use serde::Serialize;

use super::{Refusal, Request, lab_scene, wide};

/// What a `clip_line` request asks for.
struct Input {
    algorithm: Algorithm,
    against: Against,
    segment: [f32; 4],
    arithmetic: Arithmetic,
}

/// What the segment is clipped against.
enum Against {
    Window(Window),
    /// Cyrus-Beck only.
    Polygon(ConvexWindow),
}

impl Input {
    fn read(request: &Request) -> Result<Self, Refusal> {
        let names = ("algorithm", "unknown-algorithm");
        let algorithm = request.choice(names, &Algorithm::ALL, Algorithm::name, &[])?.unwrap_or_default();
        let against = match request.optional("polygon") {
            Some(polygon) if algorithm == Algorithm::CyrusBeck => {
                let window = ConvexWindow::new(&polygon.polygon()?);
                let bad = |flaw: Flaw| Refusal::new("bad-window", Message::new(flaw.message()));
                Against::Polygon(window.map_err(bad)?)
            }
            _ => Against::Window(request.window()?),
        };
        Ok(Self {
            algorithm,
            against,
            segment: request.required("segment")?.numbers()?,
            arithmetic: request.arithmetic_of(&[Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64])?,
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
    let [x0, y0, x1, y1] = input.segment;
    let ends: Segment = [[x0, y0], [x1, y1]];
    let (arithmetic, tally, t) = (input.arithmetic, &mut Tally::default(), &mut NoTrace);
    let (mut outcodes, mut parameters) = (None, None);
    let clipped = match (&input.against, input.algorithm) {
        (Against::Polygon(window), _) => {
            cyrus_beck::clip_traced(ends, window, arithmetic, tally, t).map(|visible| visible.segment)
        }
        (Against::Window(window), Algorithm::CohenSutherland) => {
            outcodes = Some(ends.map(|end| Outcode::of(end, window.array())));
            cohen_sutherland::clip_traced(ends, window, arithmetic, tally, t)
        }
        (Against::Window(window), Algorithm::LiangBarsky) => {
            let visible = liang_barsky::clip_traced(ends, window, arithmetic, tally, t);
            parameters = visible.map(|visible| visible.t);
            visible.map(|visible| visible.segment)
        }
        (Against::Window(window), Algorithm::CyrusBeck) => {
            let window = (*window).into();
            cyrus_beck::clip_traced(ends, &window, arithmetic, tally, t).map(|visible| visible.segment)
        }
        (Against::Window(window), Algorithm::Midpoint) => {
            midpoint::clip_traced(ends, window, arithmetic, tally, t)
        }
        (Against::Window(window), Algorithm::NichollLeeNicholl) => {
            nicholl_lee_nicholl::clip_traced(ends, window, arithmetic, tally, t)
        }
    };
    let mut numbers = clipped.iter().flatten().chain(&parameters).flatten();
    if numbers.any(|v| !v.is_finite()) {
        return Err(Refusal::overflow(input.arithmetic));
    }
    Ok(Answer {
        visible: clipped.is_some(),
        segment: clipped.map(|[p, q]| wide([p[0], p[1], q[0], q[1]])),
        outcodes,
        t: parameters.map(wide),
    })
}

/// The same request as a scene that opens a lab.
pub(super) fn lab(request: &Request) -> Result<Scene, Refusal> {
    let input = Input::read(request)?;
    let Input { algorithm, against, segment, arithmetic } = input;
    let polygon = |corners: &[Point]| labs::ClipConvex { polygon: corners.to_vec(), segment, arithmetic };
    let lab: LabInput = match against {
        Against::Polygon(window) => polygon(window.corners()).into(),
        Against::Window(window) if algorithm == Algorithm::CyrusBeck => polygon(&window.corners()).into(),
        Against::Window(window) => {
            let (window, mistakes) = (window.array(), Mistakes::NONE);
            labs::ClipLine { algorithm, window, segment, arithmetic, mistakes }.into()
        }
    };
    Ok(lab_scene([64, 64], lab))
}
