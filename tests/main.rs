//! Headless tests over core, figure and cli: laws that hold for every algorithm, golden logs,
//! conformance. No display, no network, no clock.

mod cohen_sutherland;
mod coverage;
mod house;
mod replay;
mod scanline;
mod support;
