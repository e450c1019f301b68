//! Headless tests over core, figure and cli: laws that hold for every algorithm, golden logs,
//! conformance. No display, no network, no clock.

mod back_face;
mod bvh;
mod cli;
mod clip_plane;
mod clip_polygon;
mod clip_triangle;
mod clip_triangle_steps;
mod cohen_sutherland;
mod compare;
mod compute;
mod coverage;
mod frustum_culling;
mod house;
mod interpolate;
mod liang_barsky;
mod obj;
mod pipeline;
mod polygon_presets;
mod presets;
mod render;
mod replay;
mod scanline;
mod scene;
mod scene_errors;
mod support;
mod sutherland_hodgman;
mod tour;
mod transform;
mod weiler_atherton;
mod z_buffer;
