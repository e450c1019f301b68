//! Polygon clipping: Sutherland-Hodgman in three arithmetics, Weiler-Atherton.

use rasterscope_core::{
    clip::{
        line::{Point, Window},
        polygon::{
            sutherland_hodgman::{self, Settings},
            weiler_atherton,
        },
    },
    math::Arithmetic,
    trace::NoTrace,
};

use super::{
    family::Family,
    race::{Answer, Contender, Errors, Heat, Row},
    random::Random,
};

pub(super) const STAGE: &str = "polygon-clipping";
pub(super) const FAMILIES: &[Family] = &[
    Family::Ordinary,
    Family::Beside,
    Family::NearlyParallel,
    Family::Sliver,
    Family::Huge,
    Family::Denormal,
];

const COUNT: usize = 256;
const CORNERS: usize = 12;
const SIDES: [f32; 4] = [-3.1, -2.2, 4.7, 3.3];
const SMALL: [f32; 4] = [-3.1e-39, -2.2e-39, 4.7e-39, 3.3e-39];

/// What is left.
pub(super) struct Pieces {
    contours: Vec<Vec<Point>>,
    /// Whether the corners come in the order of Sutherland and Hodgman: only these are compared.
    is_one: bool,
}

impl Pieces {
    fn one(contour: Vec<Point>) -> Self {
        Self { contours: vec![contour], is_one: true }
    }

    /// In binary64.
    fn area(&self) -> f64 {
        let doubled = |piece: &Vec<Point>| -> f64 {
            let next = piece.iter().cycle().skip(1);
            piece
                .iter()
                .zip(next)
                .map(|(p, q)| {
                    let [[px, py], [qx, qy]] = [p, q].map(|p| p.map(f64::from));
                    px * qy - py * qx
                })
                .sum()
        };
        self.contours.iter().map(doubled).sum::<f64>().abs() / 2.0
    }

    /// How far rounding all corners can move the area.
    fn slack(&self) -> f64 {
        let corners = self.contours.iter().flatten();
        let reach = corners.clone().flatten().fold(0.0_f64, |reach, x| reach.max(f64::from(x.abs())));
        corners.count() as f64
            * 4.0
            * reach
            * (reach * f64::from(f32::EPSILON) + f64::from(f32::MIN_POSITIVE))
    }
}

impl Answer for Pieces {
    /// The area is what must be right; where corners correspond, they are compared.
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.decision((self.area() - exact.area()).abs() <= exact.slack());
        let corners =
            |pieces: &Self| pieces.contours.iter().flatten().flatten().copied().collect::<Vec<f32>>();
        let (found, exact) = (corners(self), corners(exact));
        if self.is_one && found.len() == exact.len() {
            errors.values(found.iter().zip(&exact));
        }
    }
}

fn polygons(family: Family, sides: [f32; 4]) -> Vec<Vec<Point>> {
    let mut random = Random::new(100 + family as u64);
    (0..COUNT).map(|_| polygon(family, sides, &mut random)).collect()
}

/// Star-shaped around a centre in the window, and about as large as it.
fn polygon(family: Family, sides: [f32; 4], random: &mut Random) -> Vec<Point> {
    let [xmin, ymin, xmax, ymax] = sides.map(f64::from);
    let centre = [random.uniform(xmin, xmax), random.uniform(ymin, ymax)].map(f64::from);
    let radius = (ymax - ymin) * f64::from(random.uniform(0.2, 0.9));
    (0..CORNERS)
        .map(|i| {
            let turn = (i as f64 + f64::from(random.uniform(0.0, 0.9))) / CORNERS as f64;
            let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
            let r = radius * f64::from(random.uniform(0.5, 1.0));
            let mut point = [centre[0] + r * cos, centre[1] + r * sin].map(|x| x as f32);
            match family {
                // Out or in along the ray, so that it still goes once around the centre.
                Family::Beside => {
                    let axis = random.below(2);
                    let border = random.pick(&[sides[axis], sides[axis + 2]]);
                    let [free, fixed] = [1 - axis, axis].map(|axis| f64::from(point[axis]) - centre[axis]);
                    let part = (f64::from(border) - centre[axis]) / fixed;
                    if (0.5..1.5).contains(&part) {
                        point[axis] = random.beside(border);
                        point[1 - axis] = (centre[1 - axis] + part * free) as f32;
                    }
                }
                Family::NearlyParallel => {
                    let top = f64::from(sides[3]);
                    point[1] = (top + (f64::from(point[1]) - top) * 1e-6) as f32;
                }
                Family::Sliver => point[1] = centre[1] as f32 + (r * sin * 1e-6) as f32,
                Family::Huge => {
                    let size = random.magnitude(20.0, 38.0).abs();
                    point = [(cos * f64::from(size)) as f32, (sin * f64::from(size)) as f32];
                }
                _ => {}
            }
            point
        })
        .collect()
}

pub(super) fn run(family: Family, rounds: u32) -> Vec<Row> {
    let sides = if family == Family::Denormal { SMALL } else { SIDES };
    let Some(window) = Window::new(sides) else { return Vec::new() };
    // The text takes many polygons at once.
    let polygons: Vec<[Vec<Point>; 1]> =
        polygons(family, sides).into_iter().map(|polygon| [polygon]).collect();
    let (window, polygons) = (&window, &polygons);
    let mut contenders = vec![Contender::fast("sutherland-hodgman", polygons, move |[polygon]| {
        Pieces::one(sutherland_hodgman::clip(polygon, window))
    })];
    for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
        let settings = Settings { arithmetic, ..Settings::default() };
        contenders.push(Contender::text(
            "sutherland-hodgman",
            arithmetic,
            polygons,
            move |polygon, tally| {
                let left = sutherland_hodgman::clip_traced(polygon, window, settings, tally, &mut NoTrace);
                Pieces::one(left.iter().flatten().map(|corner| corner.at).collect())
            },
        ));
    }
    contenders.push(Contender::text(
        "weiler-atherton",
        Arithmetic::Exact,
        polygons,
        move |polygon, tally| {
            let pieces = weiler_atherton::clip_traced(polygon, window, tally, &mut NoTrace);
            let contours = pieces.iter().flat_map(|piece| piece.holes.iter().chain([&piece.outer]));
            let contours = contours.map(|corners| corners.iter().map(|corner| corner.at).collect()).collect();
            Pieces { contours, is_one: false }
        },
    ));
    let exact = |[polygon]: &[Vec<Point>; 1]| Pieces::one(sutherland_hodgman::clip(polygon, window));
    let exact = polygons.iter().map(exact).collect();
    Heat { stage: STAGE, family, items: COUNT * CORNERS, item: "corner", contenders, exact }.run(rounds)
}
