//! Untraced runs under fixed names: only disassembled, by `tests/check-trace-cost`.
#![expect(unsafe_code, missing_docs, reason = "exported names, never called")]

use rasterscope_core::{
    clip::line::{Segment, Window, cohen_sutherland},
    math::{Arithmetic, Tally},
    trace::NoTrace,
};

#[unsafe(no_mangle)]
pub fn probe_cohen_sutherland(segment: Segment, window: &Window, tally: &mut Tally) -> Option<Segment> {
    cohen_sutherland::clip_traced(segment, window, Arithmetic::Exact, tally, &mut NoTrace)
}
