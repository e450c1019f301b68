//! The state of a draw beyond its tests: what may keep a fragment from being tested at all.

use super::{fragments::FragmentState, shader::Color};
use crate::{
    blend::AlphaTest,
    depth::Early,
    math::{Approx, Dyadic, Tally},
    raster::Span,
};

impl FragmentState {
    /// Whether every fragment goes to the tests with the depth of its plane: no scissor, alpha test, bias or
    /// depth clamp.
    pub(super) fn is_plain(&self) -> bool {
        self.scissor.is_none() && self.alpha_test.is_none() && self.placement.is_plain()
    }

    /// The pixels of a span that the scissor lets pass, and how many it does not.
    #[inline]
    pub(super) fn scissored(&self, span: Span) -> (Span, u64) {
        match self.scissor {
            None => (span, 0),
            Some(scissor) => {
                let kept = scissor.clip(span);
                (kept, u64::from(span.len() - kept.len()))
            }
        }
    }

    /// When its fragments are tested; `early`: before they are coloured where that may be.
    pub(super) fn early(&self, early: bool) -> Early {
        match (self.alpha_test.is_some(), early) {
            (true, false) => Early::Never,
            (discards, _) => Early::of(discards, self.depth.test, self.stencil.as_ref()),
        }
    }
}

impl Color<'_> {
    /// Whether the alpha test, if there is one, keeps a fragment of this colour.
    pub(super) fn is_kept(&self, test: Option<AlphaTest>, tally: &mut Tally) -> bool {
        let Some(test) = test else { return true };
        match self.uniform_alpha() {
            Some(alpha) => test.keeps(Approx::from(alpha), || (Dyadic::from(alpha), Dyadic::one()), tally),
            None => test.keeps(self.approx(3), || self.exact(3), tally),
        }
    }
}
