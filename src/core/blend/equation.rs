//! The blend equation, rounded once.
//!
//! *Source:* WebGPU, "Blend State"; Porter and Duff, Compositing Digital Images, 1984.
//! Deviation: nothing is rounded before the write, so that the code is that of the exact result.

use std::ops::{Add, Mul, Sub};

use super::{BlendComponent, BlendFactor, BlendOperation, BlendState};
use crate::math::{Approx, Dyadic, Tally, rounded_code};

/// A colour without a rounding: four numerators, in the order red, green, blue, alpha, over one
/// denominator, not zero.
#[derive(Clone, Debug)]
pub struct ExactColor {
    /// Red, green, blue, alpha.
    pub channels: [Dyadic; 4],
    /// Divides all four.
    pub denominator: Dyadic,
}

/// Joins a fragment's colour with the stored one: codes of the exact result,
/// `floor(255 c + 1/2)`, clamped to 0..=255.
///
/// `source` is the fragment's colour nearly and `exact` the same colour, straight alpha, each channel in
/// 0..=1; a stored code `n` means n/255. Costs some 20 ns a channel, about 2 us if the exact tail is
/// needed (at every exact tie), which `tally` counts.
pub fn blend(
    state: &BlendState,
    source: [Approx; 4],
    exact: impl Fn() -> ExactColor,
    stored: [u8; 4],
    tally: &mut Tally,
) -> [u8; 4] {
    let mut codes = [0; 4];
    for channel in 0..4 {
        codes[channel] = blend_channel(state, channel, source, &exact, stored, tally);
    }
    codes
}

/// What stored codes mean: n/255, off by at most one rounding.
static MEANT: [Approx; 256] = {
    let mut meant = [Approx::exact(0.0); 256];
    let mut code = 0;
    while code < 256 {
        let value = code as f64 / 255.0;
        // Half an ULP is at most this; 0 and 1 are exact.
        let error = if code % 255 == 0 { 0.0 } else { f64::EPSILON / 2.0 * value };
        meant[code] = Approx { value, error };
        code += 1;
    }
    meant
};

/// One channel of [`blend`]: 0 red, 1 green, 2 blue, 3 alpha.
#[inline]
pub fn blend_channel(
    state: &BlendState,
    channel: usize,
    source: [Approx; 4],
    exact: impl Fn() -> ExactColor,
    stored: [u8; 4],
    tally: &mut Tally,
) -> u8 {
    let component = (state.component(channel), state.constant[channel]);
    let near = {
        let stored = stored.map(|code| MEANT[usize::from(code)]);
        equation(component, source, stored, channel)
    };
    let tail = || {
        let ExactColor { channels, denominator } = exact();
        let source = channels.map(|num| Ratio { num, den: denominator.clone() });
        let stored = stored.map(|code| Ratio { num: Dyadic::from(u32::from(code)), den: Dyadic::from(255) });
        let Ratio { num, den } = equation(component, source, stored, channel);
        (num, den)
    };
    // All values are in 0..=1, so a code never needs more than eight bits.
    rounded_code(near, 255, tail, tally) as u8
}

/// What one channel of a result is made of, in binary64, to be shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Terms {
    /// The fragment's value.
    pub source: f64,
    /// What multiplies it.
    pub source_factor: f64,
    /// The stored value.
    pub stored: f64,
    /// What multiplies that.
    pub stored_factor: f64,
    /// The result before rounding and clamping.
    pub result: f64,
}

impl Terms {
    /// Those of one channel.
    pub fn new(state: &BlendState, channel: usize, source: [f32; 4], stored: [u8; 4]) -> Self {
        let (source, stored) = (source.map(f64::from), stored.map(|code| f64::from(code) / 255.0));
        let (component, constant) = (state.component(channel), state.constant[channel]);
        let factor = |which| factor((which, constant), source, stored, channel);
        Self {
            source: source[channel],
            source_factor: factor(component.src_factor),
            stored: stored[channel],
            stored_factor: factor(component.dst_factor),
            result: equation((component, constant), source, stored, channel),
        }
    }
}

/// One channel of the result, before rounding and clamping.
#[inline]
fn equation<N: Number>(
    (component, constant): (&BlendComponent, f32),
    source: [N; 4],
    stored: [N; 4],
    channel: usize,
) -> N {
    let (new, old) = (source[channel].clone(), stored[channel].clone());
    match component.operation {
        BlendOperation::Min => return new.min(old),
        BlendOperation::Max => return new.max(old),
        _ => {}
    }
    let of = |which| factor((which, constant), source.clone(), stored.clone(), channel);
    let new = new * of(component.src_factor);
    let old = old * of(component.dst_factor);
    match component.operation {
        BlendOperation::Subtract => new - old,
        BlendOperation::ReverseSubtract => old - new,
        _ => new + old,
    }
}

/// The value of a factor for one channel.
#[inline]
fn factor<N: Number>(
    (factor, constant): (BlendFactor, f32),
    source: [N; 4],
    stored: [N; 4],
    channel: usize,
) -> N {
    let one = || N::from(1.0);
    let [src, dst] = [&source, &stored].map(|color| color[channel].clone());
    let [[.., src_alpha], [.., dst_alpha]] = [source, stored];
    match factor {
        BlendFactor::Zero => N::from(0.0),
        BlendFactor::One => one(),
        BlendFactor::Src => src,
        BlendFactor::OneMinusSrc => one() - src,
        BlendFactor::SrcAlpha => src_alpha,
        BlendFactor::OneMinusSrcAlpha => one() - src_alpha,
        BlendFactor::Dst => dst,
        BlendFactor::OneMinusDst => one() - dst,
        BlendFactor::DstAlpha => dst_alpha,
        BlendFactor::OneMinusDstAlpha => one() - dst_alpha,
        BlendFactor::SrcAlphaSaturated if channel == 3 => one(),
        BlendFactor::SrcAlphaSaturated => src_alpha.min(one() - dst_alpha),
        BlendFactor::Constant => N::from(constant),
        BlendFactor::OneMinusConstant => one() - N::from(constant),
    }
}

/// What the equation is computed in.
trait Number: Clone + From<f32> + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    fn min(self, other: Self) -> Self;
    fn max(self, other: Self) -> Self;
}

/// The smaller and the larger of two numbers differ from those of two others by no more than the larger
/// of the two differences.
impl Number for Approx {
    fn min(self, other: Self) -> Self {
        Self { value: self.value.min(other.value), error: self.error.max(other.error) }
    }

    fn max(self, other: Self) -> Self {
        Self { value: self.value.max(other.value), error: self.error.max(other.error) }
    }
}

impl Number for f64 {
    fn min(self, other: Self) -> Self {
        Self::min(self, other)
    }

    fn max(self, other: Self) -> Self {
        Self::max(self, other)
    }
}

/// A fraction without a rounding; `den` is not zero, of either sign.
#[derive(Clone)]
struct Ratio {
    num: Dyadic,
    den: Dyadic,
}

impl From<f32> for Ratio {
    fn from(value: f32) -> Self {
        Self { num: Dyadic::from(value), den: Dyadic::one() }
    }
}

impl Add for Ratio {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { num: &self.num * &other.den + &other.num * &self.den, den: self.den * other.den }
    }
}

impl Sub for Ratio {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { num: &self.num * &other.den - &other.num * &self.den, den: self.den * other.den }
    }
}

impl Mul for Ratio {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { num: self.num * other.num, den: self.den * other.den }
    }
}

impl Ratio {
    fn is_less(&self, other: &Self) -> bool {
        let Self { num, den } = self.clone() - other.clone();
        (num.sign() * den.sign()).is_negative()
    }
}

impl Number for Ratio {
    fn min(self, other: Self) -> Self {
        if other.is_less(&self) { other } else { self }
    }

    fn max(self, other: Self) -> Self {
        if self.is_less(&other) { other } else { self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn over(source: [f32; 4], stored: [u8; 4], color: BlendComponent, alpha: BlendComponent) -> [u8; 4] {
        let exact = || ExactColor { channels: source.map(Dyadic::from), denominator: Dyadic::one() };
        let state = BlendState { color, alpha, ..BlendState::default() };
        blend(&state, source.map(Approx::from), exact, stored, &mut Tally::default())
    }

    fn component(src: BlendFactor, dst: BlendFactor, operation: BlendOperation) -> BlendComponent {
        BlendComponent { src_factor: src, dst_factor: dst, operation }
    }

    const OVER: BlendComponent = BlendComponent {
        src_factor: BlendFactor::SrcAlpha,
        dst_factor: BlendFactor::OneMinusSrcAlpha,
        operation: BlendOperation::Add,
    };

    #[test]
    fn half_over_any_code_rounds_ties_up() {
        for code in 0..=255 {
            let half = u16::from(code).div_ceil(2) as u8;
            let got = over([0.0, 0.0, 0.0, 0.5], [code; 4], OVER, OVER);
            assert_eq!(got[..3], [half; 3], "black with alpha 1/2 over {code}");
        }
    }

    #[test]
    fn opaque_over_replaces_and_clear_over_keeps() {
        for code in 0..=255 {
            assert_eq!(over([0.2, 0.4, 0.6, 1.0], [code; 4], OVER, OVER), [51, 102, 153, 255]);
            let kept = component(BlendFactor::Zero, BlendFactor::One, BlendOperation::Add);
            assert_eq!(over([0.2, 0.4, 0.6, 0.0], [code; 4], OVER, kept), [code; 4]);
        }
    }

    #[test]
    fn sums_and_differences_are_clamped() {
        use BlendFactor::One;
        let add = component(One, One, BlendOperation::Add);
        let sub = component(One, One, BlendOperation::Subtract);
        let reverse = component(One, One, BlendOperation::ReverseSubtract);
        assert_eq!(over([1.0; 4], [200; 4], add, add), [255; 4]);
        assert_eq!(over([0.2; 4], [200; 4], sub, sub), [0; 4]);
        assert_eq!(over([0.2; 4], [200; 4], reverse, reverse), [149; 4]);
    }

    #[test]
    fn min_and_max_ignore_the_factors() {
        let zero = |operation| component(BlendFactor::Zero, BlendFactor::Zero, operation);
        let (min, max) = (zero(BlendOperation::Min), zero(BlendOperation::Max));
        assert_eq!(over([0.2, 0.9, 0.2, 0.9], [128; 4], min, min), [51, 128, 51, 128]);
        assert_eq!(over([0.2, 0.9, 0.2, 0.9], [128; 4], max, max), [128, 229, 128, 229]);
    }

    #[test]
    fn saturated_alpha_is_what_is_left_of_the_stored_alpha() {
        let saturated = component(BlendFactor::SrcAlphaSaturated, BlendFactor::One, BlendOperation::Add);
        let got = over([1.0, 1.0, 1.0, 0.8], [0, 0, 0, 155], saturated, saturated);
        assert_eq!(got, [100, 100, 100, 255], "min(0.8, 100/255) for colour, 1 for alpha");
    }
}
