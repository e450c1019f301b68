//! What the stencil test compares and what it stores.
//!
//! *Source:* WebGPU, "Depth/Stencil State"; OpenGL 4.6 core, section 17.3.3.

use super::{StencilOperation, StencilState};
use crate::depth::CompareFunction;

/// How far a fragment came.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum StencilOutcome {
    /// The stencil test failed.
    Fail,
    /// The stencil test passed, the depth test failed.
    DepthFail,
    /// Both passed.
    Pass,
}

impl StencilOperation {
    /// WebGPU's eight operations, in its order.
    pub const ALL: [Self; 8] = [
        Self::Keep,
        Self::Zero,
        Self::Replace,
        Self::Invert,
        Self::IncrementClamp,
        Self::DecrementClamp,
        Self::IncrementWrap,
        Self::DecrementWrap,
    ];

    /// WebGPU's name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Keep => "keep",
            Self::Zero => "zero",
            Self::Replace => "replace",
            Self::Invert => "invert",
            Self::IncrementClamp => "increment-clamp",
            Self::DecrementClamp => "decrement-clamp",
            Self::IncrementWrap => "increment-wrap",
            Self::DecrementWrap => "decrement-wrap",
        }
    }

    /// The new value, before the write mask.
    #[inline]
    pub fn apply(self, stored: u8, reference: u8) -> u8 {
        match self {
            Self::Keep => stored,
            Self::Zero => 0,
            Self::Replace => reference,
            Self::Invert => !stored,
            Self::IncrementClamp => stored.saturating_add(1),
            Self::DecrementClamp => stored.saturating_sub(1),
            Self::IncrementWrap => stored.wrapping_add(1),
            Self::DecrementWrap => stored.wrapping_sub(1),
        }
    }
}

impl StencilState {
    /// The stencil test of a draw, if it has one, then its depth test `depth`; the stored value
    /// follows from how far the fragment came.
    #[inline]
    pub fn test(state: Option<&Self>, stored: &mut u8, depth: impl FnOnce() -> bool) -> StencilOutcome {
        let outcome = match state {
            Some(state) if !state.passes(*stored) => StencilOutcome::Fail,
            _ if depth() => StencilOutcome::Pass,
            _ => StencilOutcome::DepthFail,
        };
        if let Some(state) = state {
            *stored = state.after(outcome, *stored);
        }
        outcome
    }

    /// Whether a fragment passes against the stored value: only the bits of the read mask count.
    #[inline]
    pub fn passes(&self, stored: u8) -> bool {
        self.compare.passes(self.reference & self.read_mask, stored & self.read_mask)
    }

    /// Which of the three operations runs.
    #[inline]
    pub fn operation(&self, outcome: StencilOutcome) -> StencilOperation {
        match outcome {
            StencilOutcome::Fail => self.fail_op,
            StencilOutcome::DepthFail => self.depth_fail_op,
            StencilOutcome::Pass => self.pass_op,
        }
    }

    /// Whether a fragment that fails can change the stored value; `depth`: there is a depth test to fail.
    pub fn changes_on_failure(&self, depth: bool) -> bool {
        let changes = |operation| operation != StencilOperation::Keep;
        let can_fail = self.compare != CompareFunction::Always;
        self.write_mask != 0 && (can_fail && changes(self.fail_op) || depth && changes(self.depth_fail_op))
    }

    /// The value stored after a fragment: only the bits of the write mask change.
    #[inline]
    pub fn after(&self, outcome: StencilOutcome, stored: u8) -> u8 {
        let new = self.operation(outcome).apply(stored, self.reference);
        (stored & !self.write_mask) | (new & self.write_mask)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn operations_wrap_or_clamp_at_the_ends() {
        let results = |stored| StencilOperation::ALL.map(|operation| operation.apply(stored, 7));
        assert_eq!(results(0), [0, 0, 7, 255, 1, 0, 1, 255]);
        assert_eq!(results(255), [255, 0, 7, 0, 255, 254, 0, 254]);
    }

    #[test]
    fn masks_limit_what_is_compared_and_changed() {
        let state = StencilState {
            compare: CompareFunction::Equal,
            pass_op: StencilOperation::Replace,
            read_mask: 0x0F,
            write_mask: 0xF0,
            reference: 0xA3,
            ..StencilState::default()
        };
        assert!(state.passes(0x73) && !state.passes(0x72));
        assert_eq!(state.after(StencilOutcome::Pass, 0x73), 0xA3);
        assert_eq!(state.after(StencilOutcome::Fail, 0x73), 0x73);
    }

    #[test]
    fn the_reference_is_the_left_operand() {
        let state = StencilState { compare: CompareFunction::Less, reference: 1, ..StencilState::default() };
        assert!(state.passes(2) && !state.passes(1) && !state.passes(0));
    }
}
