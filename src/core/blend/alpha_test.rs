//! The alpha test: a fragment whose alpha does not compare is discarded, as if it had never come.
//!
//! *Source:* OpenGL 2.1, section 4.1.4; in WebGPU it is `if (alpha < reference) { discard; }` in the fragment
//! shader. Deviation: the alpha compared is the exact one, not rounded.

use crate::{
    depth::CompareFunction,
    math::{Approx, Dyadic, Sign, Tally},
};
use serde::{Deserialize, Serialize};

/// Which fragments of a draw are kept: those whose alpha stands so to the reference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct AlphaTest {
    /// How alpha must stand to the reference.
    pub compare: CompareFunction,
    /// In 0..=1.
    pub reference: f32,
}

impl Default for AlphaTest {
    /// At least one half.
    fn default() -> Self {
        Self { compare: CompareFunction::GreaterEqual, reference: 0.5 }
    }
}

impl AlphaTest {
    /// Whether a fragment is kept: `alpha` nearly, and `exact` the same as a quotient, whose denominator is not
    /// zero. The answer is that of the exact number; a few ns, about 1 us where the error leaves two answers,
    /// which `tally` counts.
    #[inline]
    pub fn keeps(&self, alpha: Approx, exact: impl FnOnce() -> (Dyadic, Dyadic), tally: &mut Tally) -> bool {
        tally.calls += 1;
        let above = (alpha - Approx::from(self.reference)).sign().unwrap_or_else(|| {
            tally.exact += 1;
            let (num, den) = exact();
            (num - Dyadic::from(self.reference) * &den).sign() * den.sign()
        });
        self.compare.passes(above, Sign::Zero)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_rounding_would_make_equal_is_told_apart() {
        let reference = 0.5_f32;
        let mut tally = Tally::default();
        for (above, expected) in
            [(-1, [true, false, false]), (0, [false, true, false]), (1, [false, false, true])]
        {
            // One half and 2^-200 more or less.
            let exact = || (Dyadic::from(0.5_f64) + Dyadic::from(above).mul_pow2(-200), Dyadic::one());
            let alpha = Approx { value: 0.5, error: 1e-16 };
            let compares = [CompareFunction::Less, CompareFunction::Equal, CompareFunction::Greater];
            let kept =
                compares.map(|compare| AlphaTest { compare, reference }.keeps(alpha, exact, &mut tally));
            assert_eq!(kept, expected);
        }
        assert_eq!(tally.exact, 9);
    }
}
