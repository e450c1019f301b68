//! Line clipping: five algorithms, three arithmetics.

use rasterscope_core::{
    clip::line::{
        self, ConvexWindow, Segment, Window, cohen_sutherland, cyrus_beck, liang_barsky, midpoint,
        nicholl_lee_nicholl,
    },
    math::{Arithmetic, Tally},
    trace::NoTrace,
};

use super::{
    family::Family,
    race::{Answer, Contender, Errors, Heat, Row},
    random::Random,
};

pub(super) const STAGE: &str = "line-clipping";
pub(super) const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::PastACorner,
    Family::Beside,
    Family::NearlyParallel,
    Family::Huge,
    Family::Denormal,
];

const COUNT: usize = 2_048;
const SIDES: [f32; 4] = [-3.1, -2.2, 4.7, 3.3];
const SMALL: [f32; 4] = [-3.1e-39, -2.2e-39, 4.7e-39, 3.3e-39];

impl Answer for Option<Segment> {
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.decision(self.is_some() == exact.is_some());
        if let (Some(found), Some(exact)) = (self, exact) {
            errors.values(found.as_flattened().iter().zip(exact.as_flattened()));
        }
    }
}

fn segments(family: Family, sides: [f32; 4]) -> Vec<Segment> {
    let mut random = Random::new(family as u64);
    (0..COUNT).map(|_| segment(family, sides, &mut random)).collect()
}

fn segment(family: Family, sides: [f32; 4], random: &mut Random) -> Segment {
    let [xmin, ymin, xmax, ymax] = sides;
    let around = |random: &mut Random| {
        [[xmin, xmax], [ymin, ymax]].map(|[low, high]| {
            let (low, high) = (f64::from(low), f64::from(high));
            random.uniform(2.0 * low - high, 2.0 * high - low)
        })
    };
    let mut ends = [around(random), around(random)];
    match family {
        Family::PastACorner => {
            let corner = [random.pick(&[xmin, xmax]), random.pick(&[ymin, ymax])];
            let back = f64::from(random.uniform(0.3, 3.0));
            ends[1] = [0, 1].map(|axis| {
                let [c, p] = [corner[axis], ends[0][axis]].map(f64::from);
                (c + back * (c - p)) as f32
            });
        }
        Family::Beside => {
            for end in &mut ends {
                for (axis, coordinate) in end.iter_mut().enumerate() {
                    if random.below(2) == 0 {
                        let border = random.pick(&[sides[axis], sides[axis + 2]]);
                        *coordinate = random.beside(border);
                    }
                }
            }
        }
        Family::NearlyParallel => {
            let axis = random.below(2);
            let border = random.pick(&[sides[axis], sides[axis + 2]]);
            for end in &mut ends {
                end[axis] = random.beside(border) + random.uniform(-1e-6, 1e-6);
            }
        }
        Family::Huge => {
            ends[1] = [0, 1].map(|_| random.magnitude(20.0, 38.5));
            if random.below(2) == 0 {
                ends[0] = [0, 1].map(|axis| -ends[1][axis] * random.uniform(0.1, 0.9));
            }
        }
        _ => {}
    }
    ends
}

pub(super) fn run(family: Family, rounds: u32) -> Vec<Row> {
    let sides = if family == Family::Denormal { SMALL } else { SIDES };
    let Some(window) = Window::new(sides) else { return Vec::new() };
    let (segments, convex) = (&segments(family, sides), ConvexWindow::from(window));
    let (window, convex) = (&window, &convex);
    let mut contenders = vec![Contender::fast("at-once", segments, move |s| line::clip(*s, window))];
    for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
        let text = |name, clip: fn(Segment, &Window, Arithmetic, &mut Tally) -> Option<Segment>| {
            Contender::text(name, arithmetic, segments, move |s, tally| clip(*s, window, arithmetic, tally))
        };
        contenders.extend([
            text("cohen-sutherland", |s, w, a, tally| {
                cohen_sutherland::clip_traced(s, w, a, tally, &mut NoTrace)
            }),
            text("liang-barsky", with_parameters),
            text("midpoint", |s, w, a, tally| midpoint::clip_traced(s, w, a, tally, &mut NoTrace)),
            text("nicholl-lee-nicholl", |s, w, a, tally| {
                nicholl_lee_nicholl::clip_traced(s, w, a, tally, &mut NoTrace)
            }),
            Contender::text("cyrus-beck", arithmetic, segments, move |s, tally| {
                cyrus_beck::clip_traced(*s, convex, arithmetic, tally, &mut NoTrace).map(|part| part.segment)
            }),
        ]);
    }
    // The fast call decides in another way, so that it and this check each other.
    let exact = |s: &Segment| with_parameters(*s, window, Arithmetic::Exact, &mut Tally::default());
    let exact = segments.iter().map(exact).collect();
    Heat { stage: STAGE, family, items: COUNT, item: "segment", contenders, exact }.run(rounds)
}

fn with_parameters(
    s: Segment,
    window: &Window,
    arithmetic: Arithmetic,
    tally: &mut Tally,
) -> Option<Segment> {
    liang_barsky::clip_traced(s, window, arithmetic, tally, &mut NoTrace).map(|part| part.segment)
}
