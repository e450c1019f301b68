//! Depth bias: what is added to a triangle's depths, so that it does not fight with another in its plane.
//!
//! *Source:* WebGPU, section 23.2.6 (biased fragment depth); Direct3D 11.3 functional specification, section
//! 15.10. Deviations: the step of a unorm format is exactly one code, `1 / (2^n - 1)`; slope and sum are exact,
//! and what is rounded, once, is the biased depth. It is kept in 0..=1, the viewport's range of depths.

use super::DepthFormat;
use crate::math::{Approx, Dyadic, Real};
use serde::{Deserialize, Serialize};

/// Depth bias of a draw (WebGPU's `depthBias`, `depthBiasSlopeScale`, `depthBiasClamp`).
///
/// `constant * r + slope * max(|dz/dx|, |dz/dy|)` is added to the depth at every pixel of a triangle, at most
/// `clamp` if that is positive, at least `clamp` if it is negative. `r` is [`step`](Self::step).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct DepthBias {
    /// Steps of the format.
    pub constant: i32,
    /// Multiplies the steepest slope of the triangle, in depth per pixel; finite.
    pub slope: f32,
    /// The greatest bias if positive, the least if negative; finite.
    pub clamp: f32,
}

impl DepthBias {
    /// Whether nothing is added.
    pub fn is_none(&self) -> bool {
        self.constant == 0 && self.slope == 0.0
    }

    /// Whether a scene file need not mention it.
    pub(crate) fn is_default(&self) -> bool {
        *self == Self::default()
    }

    /// What `constant` counts, to be shown: one code of a unorm format, or of f32 the distance of neighbours in
    /// the binade of the triangle's greatest depth, `2^(exponent - 23)`.
    pub fn step(format: DepthFormat, greatest: f32) -> f64 {
        match Step::new(format, greatest) {
            Step::Code(max) => 1.0 / f64::from(max),
            Step::Power(power) => power.into(),
        }
    }
}

/// What happens to a draw's depths between the triangle's plane and the test.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DepthPlacement {
    /// What is added.
    pub bias: DepthBias,
    /// Whether the near and far plane do not clip: depths beyond them are those of the planes, 0 and 1
    /// (WebGPU's `unclippedDepth`, elsewhere depth clamp).
    pub unclipped: bool,
}

impl DepthPlacement {
    /// Whether depths are those of the plane.
    pub fn is_plain(&self) -> bool {
        self.bias.is_none() && !self.unclipped
    }
}

/// What the constant of a bias counts.
#[derive(Clone, Copy, Debug)]
enum Step {
    /// One code of so many: `1 / max`.
    Code(u32),
    /// A power of two.
    Power(f32),
}

impl Step {
    /// `greatest`: the triangle's greatest depth in magnitude.
    fn new(format: DepthFormat, greatest: f32) -> Self {
        match format.max_code() {
            Some(max) => Self::Code(max),
            // The exponent is that of the bits; 2^(e - 23) by dividing the power 2^e, exact down to 2^-149.
            None => {
                let power = f32::from_bits(greatest.abs().to_bits() & 0x7F80_0000).max(f32::MIN_POSITIVE);
                Self::Power(power / (1 << 23) as f32)
            }
        }
    }
}

/// The bias of one triangle in one format.
#[derive(Clone, Copy, Debug)]
pub(super) struct Offset {
    bias: DepthBias,
    step: Step,
    /// What is added, nearly; its error is infinite if that is not known.
    nearly: Approx,
}

impl Offset {
    /// `greatest`: the greatest magnitude of the vertices' depths; `steepest`: the greater one of both slopes.
    pub(super) fn new(bias: DepthBias, format: DepthFormat, greatest: f32, steepest: Approx) -> Self {
        let step = Step::new(format, greatest);
        let constant = f64::from(bias.constant);
        let mut nearly = match step {
            Step::Code(max) => Approx::exact(constant) / Approx::exact(max.into()),
            // A product of 32 and 1 bits.
            Step::Power(power) => Approx::exact(constant * f64::from(power)),
        };
        if bias.slope != 0.0 {
            nearly = nearly + Approx::from(bias.slope) * steepest;
        }
        // Neither limit moves two numbers farther apart.
        let limit = f64::from(bias.clamp);
        if limit > 0.0 {
            nearly.value = nearly.value.min(limit);
        } else if limit < 0.0 {
            nearly.value = nearly.value.max(limit);
        }
        Self { bias, step, nearly }
    }

    /// What is added, to be shown.
    pub(super) fn shown(&self) -> f64 {
        self.nearly.value
    }

    /// A depth with its bias, kept in 0..=1; nearly.
    #[inline]
    pub(super) fn at(&self, depth: Approx) -> Approx {
        let Approx { value, error } = depth + self.nearly;
        // Limits leave no more of an error than there was.
        Approx { value: value.clamp(0.0, 1.0), error }
    }

    /// The same as a quotient without a rounding, of a depth `num / den` with a positive `den`; `steepest` is the
    /// greater magnitude of both slopes over the same denominator.
    #[cold]
    pub(super) fn exact(&self, (num, den): (Dyadic, Dyadic), steepest: Dyadic) -> (Dyadic, Dyadic) {
        let DepthBias { constant, slope, clamp } = self.bias;
        let constant = Dyadic::from(constant) * &den;
        let (scale, constant) = match self.step {
            Step::Code(max) => (Dyadic::from(max), constant),
            Step::Power(power) => (Dyadic::one(), constant * Dyadic::from(power)),
        };
        let below = &scale * &den;
        let mut bias = Dyadic::from(slope) * steepest * &scale + constant;
        let limit = Dyadic::from(clamp) * &below;
        if clamp > 0.0 {
            bias = bias.min(limit);
        } else if clamp < 0.0 {
            bias = bias.max(limit);
        }
        let sum = num * &scale + bias;
        (sum.max(Dyadic::zero()).min(below.clone()), below)
    }

    /// The same in the arithmetic `R`, operation by operation as WebGPU writes it.
    pub(super) fn taught<R: Real>(&self, depth: R, steepest: R) -> R {
        let DepthBias { constant, slope, clamp } = self.bias;
        let step = match self.step {
            Step::Code(max) => R::ONE / R::from_f32(max as f32),
            Step::Power(power) => R::from_f32(power),
        };
        let mut bias = R::from_f32(constant as f32) * step + R::from_f32(slope) * steepest;
        let limit = R::from_f32(clamp);
        if clamp > 0.0 && bias > limit || clamp < 0.0 && bias < limit {
            bias = limit;
        }
        let sum = depth + bias;
        if sum < R::ZERO {
            R::ZERO
        } else if sum > R::ONE {
            R::ONE
        } else {
            sum
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_is_a_code_or_the_last_bit_of_the_greatest_depth() {
        assert_eq!(DepthBias::step(DepthFormat::Unorm16, 0.5), 1.0 / 65535.0);
        let float = |greatest| DepthBias::step(DepthFormat::F32, greatest);
        assert_eq!(float(1.0), 2f64.powi(-23));
        assert_eq!([0.5, 0.75, 0.999].map(float), [2f64.powi(-24); 3]);
        assert_eq!(float(-3.0), 2f64.powi(-22));
        assert_eq!([0.0, 1e-45].map(float), [2f64.powi(-149); 2], "subnormals stand evenly");
    }
}
