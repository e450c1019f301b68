//! Headless tests over core, figure and cli: laws that hold for every algorithm, golden logs,
//! conformance. No display, no network, no clock.

mod back_face;
mod bvh;
mod cli;
mod clip_line;
mod clip_polygon;
mod clip_triangle;
mod cohen_sutherland;
mod compare;
mod compute;
mod compute_lines;
mod coverage;
mod cyrus_beck;
mod frustum_culling;
mod house;
mod interpolate;
mod liang_barsky;
mod midpoint;
mod nicholl_lee_nicholl;
mod obj;
mod pipeline;
mod point_clipping;
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
mod z_buffer;
