//! Depth bias: every code is the nearest to the exact biased depth, by rational numbers of any size.

use crate::support::{Random, triangle};
use num_bigint::BigInt;
use rasterscope_core::{
    depth::{DepthBias, DepthFormat, DepthPlacement, DepthPlane, DepthRows},
    math::{Arithmetic, Tally},
    raster::{Algorithm, Settings, cover},
};
use std::cmp::Ordering;

/// A quotient with a positive denominator.
#[derive(Clone, Debug)]
struct Q(BigInt, BigInt);

impl Q {
    fn new(num: BigInt, den: BigInt) -> Self {
        if den < BigInt::ZERO { Self(-num, -den) } else { Self(num, den) }
    }

    fn of(value: f32) -> Self {
        let (bits, field) = (value.to_bits(), value.to_bits() >> 23 & 0xFF);
        let mantissa = BigInt::from(bits & 0x7F_FFFF | if field == 0 { 0 } else { 0x80_0000 });
        let mantissa = if value.is_sign_negative() { -mantissa } else { mantissa };
        let power = field.max(1) as i32 - 150;
        if power < 0 { Self(mantissa, BigInt::from(1) << -power) } else { Self(mantissa << power, 1.into()) }
    }

    fn add(&self, other: &Self) -> Self {
        Self(&self.0 * &other.1 + &other.0 * &self.1, &self.1 * &other.1)
    }

    fn sub(&self, other: &Self) -> Self {
        self.add(&Self(-&other.0, other.1.clone()))
    }

    fn mul(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0, &self.1 * &other.1)
    }

    fn div(&self, other: &Self) -> Self {
        Self::new(&self.0 * &other.1, &self.1 * &other.0)
    }

    fn abs(&self) -> Self {
        Self(BigInt::from(self.0.magnitude().clone()), self.1.clone())
    }

    fn cmp(&self, other: &Self) -> Ordering {
        (&self.0 * &other.1).cmp(&(&other.0 * &self.1))
    }

    fn max(self, other: Self) -> Self {
        if self.cmp(&other).is_lt() { other } else { self }
    }

    fn min(self, other: Self) -> Self {
        if self.cmp(&other).is_gt() { other } else { self }
    }
}

/// The biased depth at a pixel's centre as the specification writes it, without a rounding.
fn biased(vertices: &[[f32; 3]; 3], [x, y]: [u32; 2], bias: DepthBias, format: DepthFormat) -> Q {
    let [a, b, c] = vertices.map(|vertex| vertex.map(Q::of));
    let [p, q] = [&b, &c].map(|v| [0, 1, 2].map(|axis| v[axis].sub(&a[axis])));
    let cross = |i: usize, j: usize| p[i].mul(&q[j]).sub(&p[j].mul(&q[i]));
    // z = z0 - (nx (x - x0) + ny (y - y0)) / nz with the normal n.
    let dx = cross(1, 2).div(&cross(0, 1));
    let dy = cross(2, 0).div(&cross(0, 1));
    let along = |slope: &Q, at: u32, from: &Q| slope.mul(&Q::of(at as f32 + 0.5).sub(from));
    let plane = a[2].sub(&along(&dx, x, &a[0])).sub(&along(&dy, y, &a[1]));
    let step = match format {
        DepthFormat::F32 => {
            let greatest = vertices.iter().map(|v| v[2].abs()).fold(0.0, f32::max);
            // The greatest power of two that is not above it, by 2^23.
            let exponent = (-126..=127).rev().find(|e| 2f64.powi(*e) <= greatest.into()).unwrap_or(-126);
            Q::of(2f64.powi(exponent - 23) as f32)
        }
        _ => Q(1.into(), format.max_code().expect("unorm").into()),
    };
    let steepest = dx.abs().max(dy.abs());
    let mut sum = Q(bias.constant.into(), 1.into()).mul(&step).add(&Q::of(bias.slope).mul(&steepest));
    if bias.clamp > 0.0 {
        sum = sum.min(Q::of(bias.clamp));
    } else if bias.clamp < 0.0 {
        sum = sum.max(Q::of(bias.clamp));
    }
    plane.add(&sum).max(Q::of(0.0)).min(Q::of(1.0))
}

/// No other code is nearer; a tie goes up, or in f32 to the even one.
#[track_caller]
fn check_nearest(code: u32, exact: &Q, format: DepthFormat, what: &str) {
    let nearest = match format.max_code() {
        Some(max) => {
            // floor(max v + 1/2)
            let twice = Q(&exact.0 * 2 * BigInt::from(max), exact.1.clone()).add(&Q::of(1.0));
            BigInt::from(code) == twice.0 / (twice.1 * 2)
        }
        None => {
            let off = |value: f32| exact.sub(&Q::of(value)).abs();
            let value = f32::from_bits(code);
            [value.next_up(), value.next_down()].into_iter().all(|other| match off(value).cmp(&off(other)) {
                Ordering::Equal => code.is_multiple_of(2),
                order => order.is_lt(),
            })
        }
    };
    assert!(nearest, "{code:#x} {format:?} {what}");
}

fn any_bias(random: &mut Random) -> DepthBias {
    DepthBias {
        constant: random.pick(&[0, 1, -1, 2, -37, 4096, -100_000, i32::MAX, i32::MIN]),
        slope: random.pick(&[0.0, 1.0, -1.0, 0.5, -2.75, 1e-3, -1e20]),
        clamp: random.pick(&[0.0, 0.0, 1e-3, -1e-3, 0.25, -1e-30]),
    }
}

#[test]
fn every_biased_code_is_the_nearest() {
    let mut random = Random::new(71);
    let settings = Settings::new([9, 7]);
    let (mut checked, mut exact_tails) = (0, 0);
    for round in 0..400 {
        let flat = random.below(6) == 0;
        let plain = round % 2 == 0;
        let points = triangle(&mut random);
        let level = random.uniform(0.0, 1.0);
        let z = [0; 3].map(|_| match random.below(3) {
            _ if flat => level,
            0 => random.grid(0, 1),
            1 => random.near(0.5),
            _ => random.uniform(-0.5, 1.5),
        });
        let vertices = [0, 1, 2].map(|i| [points[i][0], points[i][1], z[i]]);
        let bias =
            if plain { DepthBias { constant: 1, slope: 0.5, clamp: 0.0 } } else { any_bias(&mut random) };
        let placement = DepthPlacement { bias, unclipped: true };
        for format in DepthFormat::ALL {
            let mut tally = Tally::default();
            let plane = DepthPlane::new(vertices, Arithmetic::Exact, &mut tally).placed(&placement, format);
            let rows = DepthRows::new(vertices, format, &mut tally).placed(&placement, &mut tally);
            let mut spans = Vec::new();
            cover(Algorithm::Scanline, points, &settings, &mut Tally::default(), &mut |span| {
                spans.push(span);
            });
            for span in spans {
                for x in span.begin..span.end {
                    let code = rows.row(span.y).code(x, &mut tally);
                    assert_eq!(code, plane.code([x, span.y], format, &mut tally));
                    let exact = biased(&vertices, [x, span.y], bias, format);
                    check_nearest(code, &exact, format, &format!("{vertices:?} {bias:?} {x} {}", span.y));
                    checked += 1;
                }
            }
            exact_tails += tally.exact;
        }
    }
    assert!(checked > 8_000 && exact_tails > 50, "{checked} {exact_tails}");
}

#[test]
fn a_constant_moves_codes_by_that_many() {
    let vertices = [[0.0, 0.0, 0.25], [9.0, 0.0, 0.75], [0.0, 9.0, 0.5]];
    let mut tally = Tally::default();
    let plane = DepthPlane::new(vertices, Arithmetic::Exact, &mut tally);
    for format in DepthFormat::ALL {
        // In f32 a step is that of the greatest depth, 0.75: of depths below 0.5 that is two codes.
        for (pixel, codes) in [([3, 2], 1), ([0, 0], if format == DepthFormat::F32 { 2 } else { 1 })] {
            let mut code = |constant: i32| {
                let bias = DepthBias { constant, ..DepthBias::default() };
                let placement = DepthPlacement { bias, unclipped: false };
                i64::from(plane.placed(&placement, format).code(pixel, format, &mut tally))
            };
            let zero = code(0);
            for constant in [-1000, -1, 1, 7, 1000] {
                assert_eq!(code(constant) - zero, codes * i64::from(constant), "{format:?} {constant}");
            }
        }
    }
}

#[test]
fn taught_arithmetics_come_near() {
    let vertices = [[0.3, 0.7, 0.30], [7.8, 1.6, 0.78], [2.2, 6.8, 0.46]];
    let bias = DepthBias { constant: 3, slope: 1.5, clamp: 0.0 };
    let placement = DepthPlacement { bias, unclipped: false };
    let mut tally = Tally::default();
    for format in DepthFormat::ALL {
        let mut depth = |arithmetic| {
            DepthPlane::new(vertices, arithmetic, &mut tally)
                .placed(&placement, format)
                .depth([3, 3], &mut tally)
        };
        let exact = depth(Arithmetic::Exact);
        assert!((depth(Arithmetic::F64) - exact).abs() <= 1e-7, "{format:?}");
        assert!((depth(Arithmetic::F32) - exact).abs() <= 1e-6, "{format:?}");
    }
}
