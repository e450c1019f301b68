//! On which side? Orientation signs that are never wrong.
//!
//! *Source:* Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
//! 1997; Ozaki, Bünger, Ogita, Oishi, Rump, Simple floating-point filters for the two-dimensional
//! orientation problem, BIT 56, 2016; Olano and Greer, Triangle Scan Conversion using 2D Homogeneous
//! Coordinates, 1997.

use super::approx::{Approx, UNIT_ROUNDOFF};
use super::expansion::{Expansion, two_diff, two_product};
use super::sign::Sign;
use super::tally::Tally;

/// Filter constant of [`orient2d`]: 3u - (phi - 22) u^2 with phi = 2 floor((sqrt(4/u + 45) - 1) / 4) and
/// u = 2^-53.
///
/// *Source:* Ozaki et al. 2016 (doi 10.1007/s10543-015-0574-9). Their term for underflow is left out:
/// differences of f32 are multiples of 2^-149, so no product other than zero lies below 2^-298.
pub(crate) const ORIENT2D_FILTER: f64 = 3.330_669_062_177_372_2e-16;

/// Absolute error of a determinant relative to the sum of its terms' magnitudes, if no term goes through
/// more than four roundings: (1 + u)^4 - 1 <= 4u + 7u^2.
///
/// That sum and its product with this constant go through at most five more roundings, and
/// (4u + 32u^2) (1 - u)^5 > 4u + 7u^2: the computed bound holds as it is.
pub(crate) const FOUR_ROUNDINGS: f64 = 4.0 * UNIT_ROUNDOFF * (1.0 + 8.0 * UNIT_ROUNDOFF);

/// Decides on which side of the directed line from `a` to `b` the point `c` lies: the exact sign of
/// `(b - a) x (c - a) = (bx - ax) (cy - ay) - (by - ay) (cx - ax)`.
///
/// Positive: `c` lies to the left where the y axis points up, to the right where it points down; that is,
/// `a`, `b`, `c` turn from the x axis towards the y axis. Zero: the three points are collinear, or two are
/// the same. Swapping two points flips the sign, rotating the three keeps it.
///
/// Valid for all finite coordinates: neither overflow nor underflow, no tolerance. Infinity and NaN are
/// refused where bytes enter; here they would give some sign.
///
/// Cost: about 2 ns if the filter decides (nearly always on random input), 7 ns for a tie of points on a
/// grid, 20 ns at worst. The tail is counted in `tally`.
///
/// *Source:* Ozaki et al. 2016 (filter); Shewchuk 1997 (tail).
#[inline]
#[must_use]
pub fn orient2d(a: [f32; 2], b: [f32; 2], c: [f32; 2], tally: &mut Tally) -> Sign {
    tally.calls += 1;
    let ([ax, ay], [bx, by], [cx, cy]) = (a.map(f64::from), b.map(f64::from), c.map(f64::from));
    let left = (bx - ax) * (cy - ay);
    let right = (by - ay) * (cx - ax);
    let determinant = left - right;
    if determinant.abs() > ORIENT2D_FILTER * (left.abs() + right.abs()) {
        return Sign::of(determinant);
    }
    tally.exact += 1;
    orient2d_exact(a, b, c)
}

/// The sign of [`orient2d`] without a rounding.
#[cold]
#[inline(never)]
fn orient2d_exact(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> Sign {
    let ([ax, ay], [bx, by], [cx, cy]) = (a.map(f64::from), b.map(f64::from), c.map(f64::from));
    let (abx, abx_tail) = two_diff(bx, ax);
    let (aby, aby_tail) = two_diff(by, ay);
    let (acx, acx_tail) = two_diff(cx, ax);
    let (acy, acy_tail) = two_diff(cy, ay);
    if [abx_tail, aby_tail, acx_tail, acy_tail] == [0.0; 4] {
        // The usual tie: points on a common grid, whose differences are exact. Rounding is monotone, so
        // the rounded products compare like the products, except when equal; then their tails decide.
        let (left, left_tail) = two_product(abx, acy);
        let (right, right_tail) = two_product(aby, acx);
        let difference = if left == right { left_tail - right_tail } else { left - right };
        return Sign::of(difference);
    }
    // Multiplied out, ax ay cancels and six products of two f32 are left: exact in f64.
    Expansion::sum_of([bx * cy, -(by * cx), cx * ay, -(cy * ax), ax * by, -(ay * bx)]).sign()
}

/// The value of the determinant of [`orient2d`] in f64, with a proven bound of its error.
///
/// The bound: with u = 2^-53, each product is the rounded product of two rounded differences, hence off by
/// at most (1 + u)^3 - 1 times its own magnitude, and their difference by u of the sum of both; together
/// no more than 4u + 3u^2 + u^3 of `|left| + |right|`.
///
/// If both products vanish, the value is exactly zero and so is the error.
/// Valid for all finite coordinates; the value stays below 2^259 and nothing underflows.
///
/// *Source:* standard error analysis, as for ORIENT2D in Shewchuk 1997.
#[inline]
#[must_use]
pub fn edge_value(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> Approx {
    let ([ax, ay], [bx, by], [cx, cy]) = (a.map(f64::from), b.map(f64::from), c.map(f64::from));
    let left = (bx - ax) * (cy - ay);
    let right = (by - ay) * (cx - ax);
    Approx { value: left - right, error: FOUR_ROUNDINGS * (left.abs() + right.abs()) }
}

/// Decides the facing of a triangle in homogeneous screen space: the exact sign of the determinant with
/// the rows `a`, `b`, `c`, each (x, y, w).
///
/// With all w = 1 this is [`orient2d`]; with all w > 0 it is the sign of the projected triangle's area. It
/// needs no division, so that it holds for vertices behind the eye as well. Zero: the triangle is seen
/// edge-on (or is a line or a point) and covers nothing. Swapping two vertices flips the sign.
///
/// Valid for all finite coordinates: neither overflow nor underflow, no tolerance.
///
/// Filter: in f64, products of two f32 are exact, hence each of the six triple products goes through at
/// most four roundings: subtraction within the minor, product with the third factor, two sums.
///
/// Cost: about 4 ns if the filter decides, 50 ns at worst. The tail is counted in `tally`.
///
/// *Source:* Olano and Greer 1997; Shewchuk 1997 (tail).
#[inline]
#[must_use]
pub fn orient3d_homogeneous(a: [f32; 3], b: [f32; 3], c: [f32; 3], tally: &mut Tally) -> Sign {
    tally.calls += 1;
    let ([ax, ay, aw], [bx, by, bw], [cx, cy, cw]) = (a.map(f64::from), b.map(f64::from), c.map(f64::from));
    let (yw, wy) = (by * cw, bw * cy);
    let (wx, xw) = (bw * cx, bx * cw);
    let (xy, yx) = (bx * cy, by * cx);
    let determinant = ax * (yw - wy) + ay * (wx - xw) + aw * (xy - yx);
    let magnitude = ax.abs() * (yw.abs() + wy.abs())
        + ay.abs() * (wx.abs() + xw.abs())
        + aw.abs() * (xy.abs() + yx.abs());
    if determinant.abs() > FOUR_ROUNDINGS * magnitude {
        return Sign::of(determinant);
    }
    tally.exact += 1;
    // Arrays made here, not the arguments, so that these stay in registers when the filter decides.
    orient3d_exact([ax, ay, aw], [bx, by, bw], [cx, cy, cw])
}

/// The sign of [`orient3d_homogeneous`] without a rounding; the coordinates are f32 still.
#[cold]
#[inline(never)]
fn orient3d_exact([ax, ay, aw]: [f64; 3], [bx, by, bw]: [f64; 3], [cx, cy, cw]: [f64; 3]) -> Sign {
    // Each factor of two f32 is exact in f64, the triple product is a pair.
    let products = [
        two_product(by * cw, ax),
        two_product(bw * cy, -ax),
        two_product(bw * cx, ay),
        two_product(bx * cw, -ay),
        two_product(bx * cy, aw),
        two_product(by * cx, -aw),
    ];
    let mut sum = Expansion::<12>::ZERO;
    for (product, tail) in products {
        sum.grow(tail);
        sum.grow(product);
    }
    sum.sign()
}

#[cfg(test)]
mod tests {
    use super::super::dyadic::Dyadic;
    use super::super::testing::{KINDS, Xorshift, dependent, holds, independent};
    use super::*;

    const CASES: u32 = 35_000;

    fn orient2d_oracle(a: [f32; 2], b: [f32; 2], c: [f32; 2]) -> Dyadic {
        let ([ax, ay], [bx, by], [cx, cy]) = (a.map(Dyadic::from), b.map(Dyadic::from), c.map(Dyadic::from));
        (&bx - &ax) * (&cy - &ay) - (&by - &ay) * (&cx - &ax)
    }

    fn orient3d_oracle(a: [f32; 3], b: [f32; 3], c: [f32; 3]) -> Dyadic {
        let ([ax, ay, aw], [bx, by, bw], [cx, cy, cw]) =
            (a.map(Dyadic::from), b.map(Dyadic::from), c.map(Dyadic::from));
        ax * (&by * &cw - &bw * &cy) + ay * (&bw * &cx - &bx * &cw) + aw * (&bx * &cy - &by * &cx)
    }

    #[test]
    fn orient2d_and_edge_values_agree_with_real_arithmetic() {
        let rng = Xorshift::new(2016);
        for kind in KINDS {
            for nearly_collinear in [false, true] {
                let mut tally = Tally::default();
                for _ in 0..CASES {
                    let [a, b, c] =
                        if nearly_collinear { dependent(&rng, kind, true) } else { independent(&rng, kind) };
                    let exact = orient2d_oracle(a, b, c);
                    assert_eq!(orient2d(a, b, c, &mut tally), exact.sign(), "{}: {a:?} {b:?} {c:?}", kind.0);
                    assert_eq!(orient2d_exact(a, b, c), exact.sign(), "{}: {a:?} {b:?} {c:?}", kind.0);
                    let value = edge_value(a, b, c);
                    assert!(holds(value, &exact), "{}: {a:?} {b:?} {c:?} {value:?}", kind.0);
                }
                check_tally(tally, kind.0, nearly_collinear);
            }
        }
    }

    #[test]
    fn orient3d_agrees_with_real_arithmetic() {
        let rng = Xorshift::new(1997);
        for kind in KINDS {
            for nearly_edge_on in [false, true] {
                let mut tally = Tally::default();
                for _ in 0..CASES {
                    let [a, b, c] =
                        if nearly_edge_on { dependent(&rng, kind, false) } else { independent(&rng, kind) };
                    let sign = orient3d_oracle(a, b, c).sign();
                    assert_eq!(
                        orient3d_homogeneous(a, b, c, &mut tally),
                        sign,
                        "{}: {a:?} {b:?} {c:?}",
                        kind.0
                    );
                    let [x, y, z] = [a, b, c].map(|row| row.map(f64::from));
                    assert_eq!(orient3d_exact(x, y, z), sign, "{}: {a:?} {b:?} {c:?}", kind.0);
                }
                check_tally(tally, kind.0, nearly_edge_on);
            }
        }
    }

    /// Ties need the exact tail; numbers drawn independently nearly never do.
    fn check_tally(tally: Tally, kind: &str, dependent: bool) {
        assert_eq!(tally.calls, u64::from(CASES));
        let plausible = match (kind, dependent) {
            ("random", false) => tally.exact <= 3,
            // One huge coordinate makes all points look collinear to the differences, now and then.
            ("any bits", false) => true,
            _ => tally.exact > 100,
        };
        assert!(plausible, "{kind}: {tally:?}");
    }

    #[test]
    fn the_filter_abstains_where_rounded_differences_lie() {
        let rng = Xorshift::new(53);
        let (mut tally, mut lies) = (Tally::default(), 0);
        for _ in 0..CASES {
            // b and c are collinear with the origin; a is so close to it that its own rounding, 2^-24 of
            // its size, is about one ulp of the differences.
            let b = [(); 2].map(|()| (1.0 + 0.01 * rng.unit().abs()) as f32);
            let factor = rng.pick(&[-1.0, 0.5, 2.0]);
            let c = b.map(|x| x * factor);
            let scale = rng.unit() * rng.pick(&[1e-8, 1e-9, 1e-10, 1e-11]);
            let a = b.map(|x| (scale * f64::from(x)) as f32);
            let exact = orient2d_oracle(a, b, c).sign();
            assert_eq!(orient2d(a, b, c, &mut tally), exact, "{a:?} {b:?} {c:?}");
            lies += u32::from(Sign::of(edge_value(a, b, c).value) == -exact && !exact.is_zero());
        }
        assert!(lies > 100, "{lies}");
    }

    #[test]
    fn swapping_two_vertices_flips_the_sign_and_rotating_keeps_it() {
        let rng = Xorshift::new(3);
        let mut tally = Tally::default();
        for kind in KINDS {
            for _ in 0..1000 {
                let [a, b, c] = dependent(&rng, kind, true);
                let sign = orient2d(a, b, c, &mut tally);
                assert_eq!(orient2d(b, c, a, &mut tally), sign);
                assert_eq!(orient2d(b, a, c, &mut tally), -sign);
                // At w = 1 the homogeneous determinant is the affine one.
                let [a, b, c] = [a, b, c].map(|[x, y]| [x, y, 1.0]);
                assert_eq!(orient3d_homogeneous(a, b, c, &mut tally), sign);
                assert_eq!(orient3d_homogeneous(c, b, a, &mut tally), -sign);
            }
        }
    }

    #[test]
    fn a_turn_from_x_towards_y_is_positive() {
        let mut tally = Tally::default();
        let (o, x, y) = ([0.0, 0.0], [1.0, 0.0], [0.0, 1.0]);
        assert_eq!(orient2d(o, x, y, &mut tally), Sign::Positive);
        assert_eq!(edge_value(o, x, y).value, 1.0);
        assert_eq!(edge_value(o, x, [7.0, 0.0]), Approx::exact(0.0));
        assert_eq!(tally, Tally { calls: 1, exact: 0 });
    }

    #[test]
    fn the_exact_tail_sees_what_no_rounded_difference_can() {
        let mut tally = Tally::default();
        // The differences from the far point round the last bit of the near one away.
        let (a, b) = ([-1e30, -1e30], [1e30, 1e30]);
        for (c, sign) in
            [([0.0, 1e-45], Sign::Positive), ([1e-45, 1e-45], Sign::Zero), ([1e-45, 0.0], Sign::Negative)]
        {
            assert_eq!(orient2d(a, b, c, &mut tally), sign);
        }
        assert_eq!(tally, Tally { calls: 3, exact: 3 });
    }
}
