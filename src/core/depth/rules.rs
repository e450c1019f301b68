//! What the fragments of one triangle meet before the depth test, as the labs step it.

use super::{DepthPlacement, z_buffer::Triangle};
use crate::{
    blend::AlphaTest,
    interpolate::Interpolator,
    math::{Approx, Tally},
    message::Message,
    raster::{Scissor, Span},
};

/// The state of one triangle's fragments; the default leaves them as they are.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rules {
    /// What is added to its depths, and whether they are kept between the planes.
    pub placement: DepthPlacement,
    /// The pixels that it may draw to.
    pub scissor: Option<Scissor>,
    /// Which of its fragments are discarded.
    pub cutout: Option<Cutout>,
}

/// An alpha test, with the alpha that it looks at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutout {
    /// What is kept.
    pub test: AlphaTest,
    /// Alpha at each vertex, in 0..=1.
    pub alpha: [f32; 3],
    /// 1/w at each vertex, more than 0: alpha is interpolated in perspective.
    pub r: [f32; 3],
}

impl Rules {
    /// The pixels of a span that the scissor lets pass.
    #[inline]
    pub fn scissored(&self, span: Span) -> Span {
        self.scissor.map_or(span, |scissor| scissor.clip(span))
    }

    /// The alpha test of a triangle, set up for all its pixels; `None` if there is none, or no area.
    pub fn cut(&self, triangle: Triangle, tally: &mut Tally) -> Option<Cut> {
        let Cutout { test, alpha, r } = self.cutout?;
        let vertices = [0, 1, 2].map(|i| [triangle[i][0], triangle[i][1], r[i]]);
        Some(Cut { interpolator: Interpolator::new(vertices, tally)?, test, alpha })
    }
}

/// [`Rules::cut`].
#[derive(Clone, Copy, Debug)]
pub struct Cut {
    interpolator: Interpolator,
    test: AlphaTest,
    alpha: [f32; 3],
}

impl Cut {
    /// The alpha at a pixel's centre, correctly rounded.
    pub fn alpha(&self, pixel: [u32; 2], tally: &mut Tally) -> f32 {
        self.interpolator.value(self.alpha, pixel, tally)
    }

    /// Whether the fragment of a pixel is kept: by the exact alpha, not the rounded one.
    pub fn keeps(&self, pixel: [u32; 2], tally: &mut Tally) -> bool {
        let weights = self.interpolator.at(pixel, tally);
        let [a, b, c] = self.alpha;
        let nearly = if a == b && b == c { Approx::from(a) } else { weights.approx(self.alpha) };
        self.test.keeps(nearly, || weights.exact(self.alpha), tally)
    }
}

/// What the scissor left of a row.
pub(crate) fn scissor_sentence(message: Message, y: u16, [whole, kept]: [[u16; 2]; 2]) -> Message {
    let [[first, end], [kept_first, kept_end]] = [whole, kept].map(|ends| ends.map(u32::from));
    message
        .with("y", u32::from(y))
        .with("first", first)
        .with("end", end)
        .with("kept-first", kept_first)
        .with("kept-end", kept_end)
}
