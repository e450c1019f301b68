//! `tests/mutate/operations/clip_polygon.rs` under libFuzzer.
#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| rasterscope_fuzz::check("clip-polygon", data));
