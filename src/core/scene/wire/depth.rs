//! The depth state of a draw, as the scene file joins it: the test, and what is added before it.

use crate::depth::{CompareFunction, DepthBias, DepthPlacement, DepthState};
use serde::{Deserialize, Serialize};

#[derive(PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct DepthWire {
    test: bool,
    compare: CompareFunction,
    write: bool,
    #[serde(skip_serializing_if = "DepthBias::is_default")]
    bias: DepthBias,
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    unclipped: bool,
}

impl Default for DepthWire {
    fn default() -> Self {
        Self::new(DepthState::default(), DepthPlacement::default())
    }
}

impl DepthWire {
    pub(super) fn new(state: DepthState, placement: DepthPlacement) -> Self {
        let DepthState { test, compare, write } = state;
        let DepthPlacement { bias, unclipped } = placement;
        Self { test, compare, write, bias, unclipped }
    }

    pub(super) fn state(&self) -> DepthState {
        let Self { test, compare, write, .. } = *self;
        DepthState { test, compare, write }
    }

    pub(super) fn placement(&self) -> DepthPlacement {
        let Self { bias, unclipped, .. } = *self;
        DepthPlacement { bias, unclipped }
    }
}
