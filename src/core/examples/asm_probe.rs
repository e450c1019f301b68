//! Untraced runs under fixed names, `probe_STAGE_ALGORITHM`: only disassembled, by
//! `tests/check-trace-cost`.
#![expect(unsafe_code, missing_docs, reason = "exported names, never called")]

use rasterscope_core::{
    clip::{
        line::{
            Segment, Window, cohen_sutherland,
            liang_barsky::{self, Visible},
        },
        polygon::{PlaneSet, Polygon, clip_triangle},
    },
    depth::z_buffer::{self, Image, Triangle},
    math::{Arithmetic, Tally},
    raster::{Counts, Settings, Span, scanline},
    trace::NoTrace,
    transform::{
        DepthRange,
        chain::{self, Chain, Path},
    },
};

#[unsafe(no_mangle)]
pub fn probe_clip_cohen_sutherland(segment: Segment, window: &Window, tally: &mut Tally) -> Option<Segment> {
    cohen_sutherland::clip_traced(segment, window, Arithmetic::Exact, tally, &mut NoTrace)
}

#[unsafe(no_mangle)]
pub fn probe_clip_liang_barsky(segment: Segment, window: &Window, tally: &mut Tally) -> Option<Visible> {
    liang_barsky::clip_traced(segment, window, Arithmetic::Exact, tally, &mut NoTrace)
}

#[unsafe(no_mangle)]
pub fn probe_clip_triangle(vertices: [[f32; 4]; 3], range: DepthRange, tally: &mut Tally) -> Polygon {
    clip_triangle(vertices, range, PlaneSet::All, tally)
}

#[unsafe(no_mangle)]
pub fn probe_raster_scanline(
    triangle: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    spans: &mut Vec<Span>,
) -> Counts {
    scanline::fill_traced(triangle, settings, tally, &mut NoTrace, &mut |span| spans.push(span))
}

#[unsafe(no_mangle)]
pub fn probe_depth_z_buffer(
    triangle: Triangle,
    settings: &z_buffer::Settings,
    image: &mut Image,
    tally: &mut Tally,
) {
    z_buffer::draw_triangle_traced(triangle, 0, settings, image, tally, &mut NoTrace);
}

#[unsafe(no_mangle)]
pub fn probe_transform_chain(vertices: &[[f32; 3]], chain: &Chain) -> Vec<Path> {
    chain::run_traced(vertices, chain, &mut NoTrace)
}
