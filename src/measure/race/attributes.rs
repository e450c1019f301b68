//! Attributes at a point of a triangle, and along a row: two modes, every arithmetic.

use rasterscope_core::{
    interpolate::{Mode, Subject, interpolate, plane_equation},
    math::{Arithmetic, Tally},
    raster::Settings,
    stress::{
        Family,
        points::{Point, points, size},
    },
    trace::NoTrace,
};

use super::{
    Row,
    heat::{Answer, Contender, Errors, Heat},
};
use crate::Stopwatch;

pub(super) const STAGE: &str = "attributes";
pub(super) use rasterscope_core::stress::points::FAMILIES;

const COUNT: usize = 1_024;
const ROWS: usize = 8;

/// A value, if the point lies in the triangle.
struct Value(Option<f32>);

impl Answer for Value {
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.decision(self.0.is_some() == exact.0.is_some());
        if let (Some(found), Some(exact)) = (self.0, exact.0) {
            errors.value(found, exact);
        }
    }
}

/// The values of a row of pixels.
struct Values(plane_equation::Pixels);

impl Answer for Values {
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.decision(self.0.len() == exact.0.len());
        let values = |values: &Self| values.0.iter().map(|(_, value)| *value).collect::<Vec<_>>();
        errors.values(values(self).iter().zip(&values(exact)));
    }
}

/// The same triangle, turned the other way: an exact answer does not depend on it.
fn turned(point: &Point) -> Point {
    let ([a, b, c], [u, v, w]) = (point.vertices, point.attribute);
    Point { vertices: [c, b, a], attribute: [w, v, u], ..*point }
}

fn value(mode: Mode, point: &Point, arithmetic: Arithmetic, tally: &mut Tally) -> Value {
    Value(interpolate(mode, point.vertices, point.attribute, point.at, arithmetic, tally).ok())
}

pub(super) fn run(family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let race = if family == Family::Long { along_rows } else { at_points };
    Mode::ALL.into_iter().flat_map(|mode| race(mode, family, stopwatch)).collect()
}

fn at_points(mode: Mode, family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let points = &points(family, COUNT);
    let contenders = Arithmetic::ALL.map(|arithmetic| {
        Contender::text(mode.name(), arithmetic, points, move |point: &Point, tally| {
            value(mode, point, arithmetic, tally)
        })
    });
    let exact = |point| value(mode, &turned(point), Arithmetic::Exact, &mut Tally::default());
    let exact = points.iter().map(exact).collect();
    let heat =
        Heat { stage: STAGE, family, items: COUNT, item: "point", contenders: contenders.into(), exact };
    heat.run(stopwatch)
}

/// The plane equation, one addition a pixel, against a quotient for each pixel.
fn along_rows(mode: Mode, family: Family, stopwatch: &Stopwatch<'_>) -> Vec<Row> {
    let points = points(family, ROWS);
    let settings = &Settings::new(size(family));
    let by_plane = move |point: &Point, arithmetic, tally: &mut Tally| {
        let Point { vertices, attribute, at } = *point;
        let subject = Subject { vertices, attribute, at };
        Values(plane_equation::fill_row_traced(mode, &subject, arithmetic, settings, tally, &mut NoTrace))
    };
    let by_pixel = move |point: &Point, columns: &[u32], arithmetic, tally: &mut Tally| {
        let y = point.at[1] as u32;
        let value = |x: &u32| {
            let point = Point { at: [*x as f32 + 0.5, y as f32 + 0.5], ..*point };
            value(mode, &point, arithmetic, tally).0.map(|value| (*x, value))
        };
        Values(columns.iter().filter_map(value).collect())
    };
    let with_columns = |point: &Point| {
        let row = by_plane(point, Arithmetic::Exact, &mut Tally::default());
        (*point, row.0.iter().map(|(x, _)| *x).collect::<Vec<_>>())
    };
    let inputs: &Vec<_> = &points.iter().map(with_columns).collect();
    let names = if mode == Mode::Perspective {
        ["plane-equation", "perspective"]
    } else {
        ["affine-plane", "affine"]
    };
    let contenders =
        [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64].into_iter().flat_map(|arithmetic| {
            [
                Contender::text(names[0], arithmetic, inputs, move |(point, _), tally| {
                    by_plane(point, arithmetic, tally)
                }),
                Contender::text(
                    names[1],
                    arithmetic,
                    inputs,
                    move |(point, columns): &(Point, Vec<u32>), tally| {
                        by_pixel(point, columns, arithmetic, tally)
                    },
                ),
            ]
        });
    let contenders = contenders.collect();
    let exact = |(point, columns): &(Point, Vec<u32>)| {
        by_pixel(&turned(point), columns, Arithmetic::Exact, &mut Tally::default())
    };
    let exact = inputs.iter().map(exact).collect();
    let items = inputs.iter().map(|(_, columns)| columns.len()).sum();
    Heat { stage: STAGE, family, items, item: "pixel", contenders, exact }.run(stopwatch)
}
