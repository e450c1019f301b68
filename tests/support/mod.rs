//! Shared by all test modules: random inputs, the laws of a traced algorithm, golden files.

mod corners;
mod golden;
mod laws;
mod lines;
mod polygons;
mod random;
mod triangles;

pub(crate) use corners::{Triangle, clipped_corners, cross, dot, unit};
pub(crate) use golden::{check_golden, log_text};
pub(crate) use laws::{Coverage, check_laws};
pub(crate) use lines::{LINE_WINDOW, line, visible_part, window};
pub(crate) use polygons::{
    Exact, Ratio, check_corners, convex_part, exact, hull, place, polygon, turn, winding,
};
pub(crate) use random::Random;
pub(crate) use triangles::{areas, covered, plane_value, triangle};
