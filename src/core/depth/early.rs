//! Early z: when the tests of a draw may run before its fragments are coloured.
//!
//! *Source:* Direct3D 11.3 functional specification, section 17.13 (early depth and stencil); Vulkan, chapter
//! Fragment Operations, early fragment test. Deviation: a test without a write, followed by the write, counts as
//! early, too.

use crate::{
    math::Tally,
    stencil::{StencilOutcome, StencilState},
};
use serde::Serialize;

/// What may happen before the alpha test of a fragment is known. The image does not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Early {
    /// Nothing discards a fragment: it is tested and written first, and coloured if it passes.
    Whole,
    /// It may be discarded, and then it must not be written: it is tested first, and written after the alpha
    /// test. One that fails changes nothing, so its colour is not asked for.
    TestOnly,
    /// It may be discarded, and one that fails changes the stencil: all waits for the alpha test.
    Never,
}

impl Early {
    /// That of a draw; `discards`: it has an alpha test, `depth`: it has a depth test.
    pub fn of(discards: bool, depth: bool, stencil: Option<&StencilState>) -> Self {
        match (discards, stencil.is_some_and(|state| state.changes_on_failure(depth))) {
            (false, _) => Self::Whole,
            (true, false) => Self::TestOnly,
            (true, true) => Self::Never,
        }
    }

    /// The tests of one fragment, and what they store; `None` if it is discarded, which stores nothing.
    ///
    /// `passes` is the depth test, which may store, `keeps` the alpha test. It is not asked for with
    /// [`Whole`](Self::Whole), and with [`TestOnly`](Self::TestOnly) only if the fragment passes.
    #[inline]
    pub fn test(
        self,
        state: Option<&StencilState>,
        (stencil, depth): (&mut u8, &mut u32),
        (passes, keeps): (impl FnOnce(&mut u32, &mut Tally) -> bool, impl Fn(&mut Tally) -> bool),
        tally: &mut Tally,
    ) -> Option<StencilOutcome> {
        if self == Self::Whole {
            return Some(StencilState::test(state, stencil, || passes(depth, tally)));
        }
        let late = self == Self::Never;
        if late && !keeps(tally) {
            return None;
        }
        let (mut new_stencil, mut new_depth) = (*stencil, *depth);
        let outcome = StencilState::test(state, &mut new_stencil, || passes(&mut new_depth, tally));
        if !late && outcome == StencilOutcome::Pass && !keeps(tally) {
            return None;
        }
        (*stencil, *depth) = (new_stencil, new_depth);
        Some(outcome)
    }
}
