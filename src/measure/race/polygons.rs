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
    stress::{Family, polygons},
    trace::NoTrace,
};

use super::{
    Row,
    heat::{Answer, Contender, Errors, Heat},
};
use crate::Stopwatch;

pub(super) const STAGE: &str = "polygon-clipping";
pub(super) use rasterscope_core::stress::polygons::FAMILIES;

const COUNT: usize = 256;

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

/// The exact answer by way of the polygon that turns the other way: the same corners, and so a check.
fn turned(polygon: &[Point], window: &Window) -> Pieces {
    let reversed: Vec<Point> = polygon.iter().rev().copied().collect();
    let mut corners = sutherland_hodgman::clip(&reversed, window);
    corners.reverse();
    // It starts elsewhere.
    let first = sutherland_hodgman::clip(polygon, window).first().copied();
    let start = corners.iter().position(|corner| Some(*corner) == first);
    corners.rotate_left(start.unwrap_or(0));
    Pieces::one(corners)
}

pub(super) fn run(family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let Some(window) = Window::new(polygons::sides(family)) else { return Vec::new() };
    // The text takes many polygons at once.
    let subjects: Vec<[Vec<Point>; 1]> =
        polygons::polygons(family, COUNT).into_iter().map(|polygon| [polygon]).collect();
    let (window, subjects) = (&window, &subjects);
    let mut contenders = vec![Contender::fast("sutherland-hodgman", subjects, move |[polygon]| {
        Pieces::one(sutherland_hodgman::clip(polygon, window))
    })];
    for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
        let settings = Settings { arithmetic, ..Settings::default() };
        contenders.push(Contender::text(
            "sutherland-hodgman",
            arithmetic,
            subjects,
            move |polygon, tally| {
                let left = sutherland_hodgman::clip_traced(polygon, window, settings, tally, &mut NoTrace);
                Pieces::one(left.iter().flatten().map(|corner| corner.at).collect())
            },
        ));
    }
    contenders.push(Contender::text(
        "weiler-atherton",
        Arithmetic::Exact,
        subjects,
        move |polygon, tally| {
            let pieces = weiler_atherton::clip_traced(polygon, window, tally, &mut NoTrace);
            let contours = pieces.iter().flat_map(|piece| piece.holes.iter().chain([&piece.outer]));
            let contours = contours.map(|corners| corners.iter().map(|corner| corner.at).collect()).collect();
            Pieces { contours, is_one: false }
        },
    ));
    let exact = subjects.iter().map(|[polygon]| turned(polygon, window)).collect();
    let items = COUNT * polygons::CORNERS;
    Heat { stage: STAGE, family, items, item: "corner", contenders, exact }.run(stopwatch)
}
