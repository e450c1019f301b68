//! Triangles that break rasterizers, and what they must cover.

use super::Random;
use rasterscope_core::{
    depth::DepthFormat,
    math::{Dyadic, Sign},
    raster::{FillRule, Settings, Span, YAxis},
};

pub(crate) type Triangle = [[f32; 2]; 3];

/// A random triangle of one of several nasty families, for an image of about 9 x 7 pixels.
pub(crate) fn triangle(random: &mut Random) -> Triangle {
    let family = random.below(9);
    let mut coordinate = || match family {
        // On centres and corners of pixels: ties everywhere.
        0 | 1 => random.below(22) as f32 / 2.0 - 1.0,
        2 => random.grid(-2, 11),
        // One or two ULP beside a centre.
        3 | 4 => {
            let centre = random.below(9) as f32 + 0.5;
            random.near(centre)
        }
        5 => random.any(),
        6 => {
            let huge = [f32::MAX, f32::MIN, 1e30, -1e30, 0.5, 3.5, 6.5];
            random.pick(&huge)
        }
        7 => {
            let tiny = [0.0, -0.0, 1e-45, -1e-45, f32::MIN_POSITIVE, 4.5, 9.0];
            random.pick(&tiny)
        }
        _ => random.uniform(-3.0, 12.0),
    };
    let mut vertices = [0; 3].map(|_| [coordinate(), coordinate()]);
    if random.below(6) == 0 {
        // A sliver: the third vertex on the line through the others, give or take an ULP.
        let [a, b, _] = vertices;
        let middle = [0, 1].map(|axis| a[axis] / 2.0 + b[axis] / 2.0);
        vertices[2] = middle.map(|value| random.near(value).clamp(f32::MIN, f32::MAX));
    }
    vertices
}

/// The oracle: edge functions in integers of any size. The top-left rule is that of a point moved right by
/// an infinitesimal step and down by its square.
pub(crate) struct Oracle {
    /// What each edge function grows by along x and y, and its value at the origin.
    lines: [[Dyadic; 3]; 3],
    turned: Sign,
    settings: Settings,
}

impl Oracle {
    /// `None` if there is no area.
    pub(crate) fn new(vertices: Triangle, settings: &Settings) -> Option<Self> {
        let [a, b, c] = vertices.map(|vertex| vertex.map(Dyadic::from));
        let lines = [[&a, &b], [&b, &c], [&c, &a]].map(|[[ax, ay], [bx, by]]| {
            let (dx, dy) = (ay - by, bx - ax);
            let at_origin = -(&dx * ax + &dy * ay);
            [dx, dy, at_origin]
        });
        let area = &lines[0][0] * &c[0] + &lines[0][1] * &c[1] + &lines[0][2];
        let turned = area.sign();
        (!turned.is_zero()).then_some(Self { lines, turned, settings: *settings })
    }

    /// Whether a point is covered.
    pub(crate) fn covers(&self, at: [f32; 2]) -> bool {
        let down = if self.settings.y_axis == YAxis::Down { 1 } else { -1 };
        let [x, y] = at.map(Dyadic::from);
        self.lines.iter().all(|[dx, dy, at_origin]| {
            let value = (dx * &x + dy * &y + at_origin).sign() * self.turned;
            let right = dx.sign() * self.turned;
            let below = dy.sign() * self.turned * Sign::of(down.into());
            match self.settings.fill_rule {
                FillRule::TopLeft => {
                    [value, right, below].into_iter().find(|sign| !sign.is_zero()) == Some(Sign::Positive)
                }
                FillRule::RightOfPoint => value.is_positive() || value.is_zero() && !right.is_negative(),
                FillRule::Inclusive => !value.is_negative(),
                FillRule::Strict => value.is_positive(),
            }
        })
    }
}

/// The pixels that the oracle covers at their centres.
pub(crate) fn covered(vertices: Triangle, settings: &Settings) -> Vec<Span> {
    let Some(oracle) = Oracle::new(vertices, settings) else { return Vec::new() };
    let drawn = |x: u32, y: u32| oracle.covers([x, y].map(|n| n as f32 + 0.5));
    let [width, height] = settings.size;
    let rows = (0..height).filter_map(|y| {
        let xs: Vec<u32> = (0..width).filter(|&x| drawn(x, y)).collect();
        let (&begin, &last) = (xs.first()?, xs.last()?);
        assert_eq!(xs.len() as u32, last + 1 - begin, "a triangle is convex");
        Some(Span { y, begin, end: last + 1 })
    });
    rows.collect()
}

/// The area opposite to each vertex at a point, without a rounding; negative on the wrong side.
pub(crate) fn areas(triangle: Triangle, at: [f32; 2]) -> [Dyadic; 3] {
    let [a, b, c] = triangle.map(|point| point.map(Dyadic::from));
    let p = at.map(Dyadic::from);
    let area = |a: &[Dyadic; 2], b: &[Dyadic; 2]| {
        (&b[0] - &a[0]) * (&p[1] - &a[1]) - (&b[1] - &a[1]) * (&p[0] - &a[0])
    };
    [area(&b, &c), area(&c, &a), area(&a, &b)]
}

/// Numerator and denominator of the exact plane value at a pixel's centre.
pub(crate) fn plane_value(triangle: &[[f32; 3]; 3], pixel: [u32; 2]) -> (Dyadic, Dyadic) {
    let [a, b, c] = areas(triangle.map(|[x, y, _]| [x, y]), pixel.map(|n| n as f32 + 0.5));
    let [z0, z1, z2] = triangle.map(|[_, _, z]| Dyadic::from(z));
    (&a * &z0 + &b * &z1 + &c * &z2, a + b + c)
}

/// The code of the exact plane value at a pixel's centre.
pub(crate) fn plane_code(triangle: &[[f32; 3]; 3], pixel: [u32; 2], format: DepthFormat) -> u32 {
    let (num, den) = plane_value(triangle, pixel);
    match format.max_code() {
        None => Dyadic::ratio_to_f32(&num, &den).to_bits(),
        Some(max) => Dyadic::ratio_to_code(&num, &den, max),
    }
}
