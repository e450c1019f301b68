//! Attributes at a point of a triangle: two modes, every arithmetic.

use rasterscope_core::{
    interpolate::{Mode, interpolate},
    math::{Arithmetic, Tally},
};

use super::{
    family::Family,
    race::{Answer, Contender, Errors, Heat, Row},
    random::Random,
};

pub(super) const STAGE: &str = "attributes";
pub(super) const FAMILIES: &[Family] =
    &[Family::Ordinary, Family::Sliver, Family::NearWZero, Family::Huge, Family::Denormal];

const COUNT: usize = 1_024;

/// A value, if the point lies in the triangle.
pub(super) struct Value(Option<f32>);

impl Answer for Value {
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        errors.decision(self.0.is_some() == exact.0.is_some());
        if let (Some(found), Some(exact)) = (self.0, exact.0) {
            errors.value(found, exact);
        }
    }
}

struct Input {
    vertices: [[f32; 3]; 3],
    attribute: [f32; 3],
    at: [f32; 2],
}

fn inputs(family: Family) -> Vec<Input> {
    let mut random = Random::new(500 + family as u64);
    std::iter::repeat_with(|| input(family, &mut random))
        .filter(|input| exact(input, Mode::Perspective).0.is_some())
        .take(COUNT)
        .collect()
}

fn input(family: Family, random: &mut Random) -> Input {
    let scale = match family {
        Family::Huge => random.magnitude(20.0, 35.0).abs(),
        Family::Denormal => 1e-40,
        _ => 1.0,
    };
    let mut vertices: [[f32; 3]; 3] = std::array::from_fn(|_| {
        let w = if family == Family::NearWZero {
            random.magnitude(-8.0, 0.0).abs()
        } else {
            random.uniform(0.5, 9.0)
        };
        [random.uniform(0.0, 640.0) * scale, random.uniform(0.0, 480.0) * scale, w]
    });
    if family == Family::Sliver {
        let [a, b, _] = vertices;
        let t = random.uniform(0.2, 0.8);
        for axis in 0..2 {
            vertices[2][axis] = random.beside(a[axis] + t * (b[axis] - a[axis]));
        }
    }
    let [k, l] = [random.uniform(0.0, 1.0), random.uniform(0.0, 1.0)];
    let [k, l] = if k + l > 1.0 { [1.0 - k, 1.0 - l] } else { [k, l] };
    let [a, b, c] = vertices;
    let at = [0, 1].map(|axis| a[axis] + k * (b[axis] - a[axis]) + l * (c[axis] - a[axis]));
    // The middle of an edge is a point of most slivers.
    let at = if family == Family::Sliver { [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0) } else { at };
    Input { vertices, attribute: std::array::from_fn(|_| random.uniform(0.0, 1.0)), at }
}

/// With the vertices in another order, on which an exact answer does not depend.
fn exact(input: &Input, mode: Mode) -> Value {
    let ([a, b, c], [u, v, w]) = (input.vertices, input.attribute);
    Value(interpolate(mode, [c, b, a], [w, v, u], input.at, Arithmetic::Exact, &mut Tally::default()).ok())
}

pub(super) fn run(family: Family, rounds: u32) -> Vec<Row> {
    let inputs = &inputs(family);
    let mut rows = Vec::new();
    for mode in Mode::ALL {
        let contenders = Arithmetic::ALL.map(|arithmetic| {
            Contender::text(mode.name(), arithmetic, inputs, move |input: &Input, tally| {
                Value(interpolate(mode, input.vertices, input.attribute, input.at, arithmetic, tally).ok())
            })
        });
        let exact = inputs.iter().map(|input| exact(input, mode)).collect();
        let heat =
            Heat { stage: STAGE, family, items: COUNT, item: "point", contenders: contenders.into(), exact };
        rows.extend(heat.run(rounds));
    }
    rows
}
