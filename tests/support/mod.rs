//! Shared by all test modules: random inputs, the laws of a traced algorithm, golden files.

mod clippers;
mod convex;
mod corners;
mod counted;
mod golden;
mod laws;
mod lines;
mod polygons;
mod random;
mod triangles;

pub(crate) use clippers::{
    ARITHMETICS, Clipper, CohenSutherland, CyrusBeck, LiangBarsky, Midpoint, NichollLeeNicholl, bits,
    check_log, costs_what_it_says, keeps_the_laws, rounding_fails,
};
pub(crate) use convex::{convex, visible_part_of};
pub(crate) use corners::{Triangle, clipped_corners, cross, dot, unit};
pub(crate) use counted::{Counted, counted};
pub(crate) use golden::{check_golden, log_text};
pub(crate) use laws::{Coverage, check_laws};
pub(crate) use lines::{LINE_WINDOW, any_line, line, visible_part, window};
pub(crate) use polygons::{
    Exact, Ratio, check_corners, convex_part, exact, hull, place, polygon, turn, winding,
};
pub(crate) use random::Random;
pub(crate) use triangles::{Oracle, areas, covered, plane_code, plane_value, triangle};
