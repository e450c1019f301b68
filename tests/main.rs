//! Headless tests over core, figure and cli: laws that hold for every algorithm, golden logs,
//! conformance. No display, no network, no clock.

mod clip_triangle;
mod cohen_sutherland;
mod compute;
mod coverage;
mod house;
mod interpolate;
mod coverage;
mod house;
mod pipeline;
mod replay;
mod scanline;
mod support;
mod transform;
//! Headless tests.

mod obj;
mod scene;
mod scene_errors;
mod z_buffer;
