//! Barycentric coordinates as area ratios, with the error that rounding leaves in them.
//!
//! *Source:* Möbius, Der barycentrische Calcul, 1827; Shirley and Marschner, Fundamentals of Computer
//! Graphics, 3rd ed. 2009, section 2.7.

use super::unorm;
use crate::math::{Approx, Dyadic, Sign, Tally, edge_value, orient2d, rounded_code, rounded_ratio};

/// The unit roundoff of f64.
const U: f64 = f64::EPSILON / 2.0;

/// A triangle, ready to weigh its vertices at any point.
#[derive(Clone, Copy, Debug)]
pub struct Barycentric {
    /// The edge opposite to each vertex, its inside positive.
    edges: [[[f32; 2]; 2]; 3],
    /// Multiplies the area opposite to each vertex; exact. All 1 unless in perspective.
    factors: [f64; 3],
}

impl Barycentric {
    /// From points in pixels, any finite numbers, either winding; `None` if the area is zero.
    pub fn new([a, b, c]: [[f32; 2]; 3], tally: &mut Tally) -> Option<Self> {
        let edges = match orient2d(a, b, c, tally) {
            Sign::Positive => [[b, c], [c, a], [a, b]],
            Sign::Negative => [[c, b], [a, c], [b, a]],
            Sign::Zero => return None,
        };
        Some(Self { edges, factors: [1.0; 3] })
    }

    /// Weighs by `1 / w`: all weights times `w0 w1 w2`, so that nothing is divided and the
    /// factors are exact.
    pub fn perspective(self, [w0, w1, w2]: [f32; 3]) -> Self {
        let [w0, w1, w2] = [w0, w1, w2].map(f64::from);
        self.with_factors([w1 * w2, w2 * w0, w0 * w1])
    }

    /// Weighs by factors that are f32 or products of two f32, as f64 holds exactly.
    pub(super) fn with_factors(self, factors: [f64; 3]) -> Self {
        let [f0, f1, f2] = factors;
        // Equal factors cancel in the quotient.
        let factors = if f0 == f1 && f1 == f2 && f0 != 0.0 { [1.0; 3] } else { factors };
        Self { factors, ..self }
    }

    /// Whether a point lies in the closed triangle; exact.
    pub fn contains(&self, point: [f32; 2], tally: &mut Tally) -> bool {
        self.edges.iter().all(|&[a, b]| !orient2d(a, b, point, tally).is_negative())
    }

    /// The weights of the vertices at a point, in pixels.
    ///
    /// Of a point outside, negative areas count as zero, so that it takes a value on the border.
    /// About 10 ns.
    #[inline]
    pub fn at(&self, point: [f32; 2], tally: &mut Tally) -> Weights<'_> {
        let mut weights = Weights { triangle: self, point, weights: [0.0; 3], inverse: 0.0, reach: 0.0 };
        let (mut sum, mut size, mut error) = (0.0, 0.0, 0.0);
        for ((&[a, b], factor), weight) in self.edges.iter().zip(self.factors).zip(&mut weights.weights) {
            let mut area = edge_value(a, b, point);
            if area.value <= area.error && !orient2d(a, b, point, tally).is_positive() {
                area = Approx::exact(0.0);
            }
            *weight = area.value * factor;
            sum += *weight;
            size += weight.abs();
            error += area.error * factor.abs();
        }
        // Each weight is off by its area's error times its factor and one rounding; the sums of
        // weights and of weighted values go through three more. Twice that covers the roundings
        // of the bound itself.
        let bound = 2.0 * (error + 4.0 * U * size);
        weights.inverse = 1.0 / sum;
        // With |S' - S| <= bound <= |S'| / 2 and |N' - N| <= M bound, the quotient N' / S' is off
        // by at most (M + |N' / S'|) bound / (|S'| - bound), and 1 / (|S'| - bound) <= 2 / |S'|.
        // Inverting and multiplying add two roundings.
        weights.reach = if 2.0 * bound < sum.abs() {
            2.5 * bound * weights.inverse.abs() + 4.0 * U
        } else {
            f64::INFINITY
        };
        weights
    }
}

/// What each vertex weighs at a point: a value there is `sum(weight value) / sum(weight)`.
#[derive(Clone, Copy, Debug)]
pub struct Weights<'t> {
    triangle: &'t Barycentric,
    point: [f32; 2],
    weights: [f64; 3],
    /// `1 / sum(weight)`.
    inverse: f64,
    /// A value is off by at most `reach` times its own magnitude and the greatest vertex value's.
    reach: f64,
}

impl Weights<'_> {
    /// The attribute with these values at the vertices: the exact value rounded once to f32.
    #[inline]
    pub fn value(&self, attribute: [f32; 3], tally: &mut Tally) -> f32 {
        if is_constant(attribute) {
            return attribute[0];
        }
        rounded_ratio(self.approx(attribute), || self.exact(attribute), tally)
    }

    /// The code `floor(max value + 1/2)` of the exact value, within `0..=max`.
    #[inline]
    pub fn code(&self, attribute: [f32; 3], max: u32, tally: &mut Tally) -> u32 {
        if is_constant(attribute) {
            return unorm(attribute[0], max);
        }
        rounded_code(self.approx(attribute), max, || self.exact(attribute), tally)
    }

    /// The 8-bit code of the exact value.
    #[inline]
    pub fn code8(&self, attribute: [f32; 3], tally: &mut Tally) -> u8 {
        self.code(attribute, 0xFF, tally) as u8
    }

    /// The sign of the sum of the weights; exact. Positive unless factors have both signs.
    pub fn sum_sign(&self, tally: &mut Tally) -> Sign {
        tally.calls += 1;
        if self.reach < f64::INFINITY {
            return Sign::of(self.inverse);
        }
        tally.exact += 1;
        let (_, sum) = self.exact([0.0; 3]);
        sum.sign()
    }

    /// The value nearly.
    #[inline]
    pub(crate) fn approx(&self, [a0, a1, a2]: [f32; 3]) -> Approx {
        let greatest = f64::from(a0.abs().max(a1.abs()).max(a2.abs()));
        let [w0, w1, w2] = self.weights;
        let value = (w0 * f64::from(a0) + w1 * f64::from(a1) + w2 * f64::from(a2)) * self.inverse;
        Approx { value, error: (greatest + value.abs()) * self.reach + f64::MIN_POSITIVE }
    }

    /// Weighted sum and sum of weights, without a rounding.
    #[cold]
    pub(crate) fn exact(&self, attribute: [f32; 3]) -> (Dyadic, Dyadic) {
        let (mut weighted, mut sum) = (Dyadic::zero(), Dyadic::zero());
        for ((&[a, b], factor), value) in self.triangle.edges.iter().zip(self.triangle.factors).zip(attribute)
        {
            let area = determinant(a, b, self.point);
            if area.sign().is_positive() {
                let weight = area * Dyadic::from(factor);
                weighted = weighted + &weight * &Dyadic::from(value);
                sum = sum + weight;
            }
        }
        (weighted, sum)
    }
}

/// Whether all vertices have the same value, bit for bit.
#[inline]
fn is_constant([a0, a1, a2]: [f32; 3]) -> bool {
    a0.to_bits() == a1.to_bits() && a1.to_bits() == a2.to_bits()
}

/// The determinant of [`orient2d`] without a rounding.
pub(crate) fn determinant(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> Dyadic {
    let ([ax, ay], [bx, by], [cx, cy]) = (a.map(Dyadic::from), b.map(Dyadic::from), c.map(Dyadic::from));
    (bx - &ax) * (cy - &ay) - (by - ay) * (cx - ax)
}
