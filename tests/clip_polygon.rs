//! `clip_polygon` by `compute`, to the letter of the interface.

use crate::compute::{ask, check, check_codes};
use serde_json::json;

const UNIT: &str = r#""op":"clip_polygon","window":[0,0,4,4]"#;

#[track_caller]
fn gives(fields: &str, polygon: &str) {
    let request = format!("{{{UNIT},{fields}}}");
    check(&[(&request, &format!(r#"{{"polygon":{polygon}}}"#))]);
}

#[test]
fn a_triangle_loses_the_corner_that_is_outside() {
    let left = "[[1.0,1.0],[4.0,2.0],[4.0,2.5],[3.0,3.0]]";
    gives(r#""polygon":[[1,1],[7,3],[5,2],[3,3]]"#, "[[1.0,1.0],[4.0,2.0],[4.0,2.5],[3.0,3.0]]");
    gives(r#""algorithm":"sutherland-hodgman","polygon":[[1,1],[7,3],[5,2],[3,3]]"#, left);
}

#[test]
fn what_is_inside_comes_back_and_what_is_outside_does_not() {
    gives(r#""polygon":[[0,0],[4,0.1],[2,4]]"#, "[[0.0,0.0],[4.0,0.10000000149011612],[2.0,4.0]]");
    gives(r#""polygon":[[5,0],[9,0],[7,4]]"#, "[]");
    gives(r#""polygon":[[-9,3],[3,-9],[-9,-9]]"#, "[]");
}

#[test]
fn a_polygon_around_the_window_leaves_the_window_in_its_own_direction() {
    gives(r#""polygon":[[-9,-9],[9,-9],[9,9],[-9,9]]"#, "[[4.0,0.0],[4.0,4.0],[0.0,4.0],[0.0,0.0]]");
    gives(r#""polygon":[[-9,9],[9,9],[9,-9],[-9,-9]]"#, "[[4.0,4.0],[4.0,0.0],[0.0,0.0],[0.0,4.0]]");
}

#[test]
fn touching_has_no_area() {
    // A corner in a corner, an edge along a border, a line.
    gives(r#""polygon":[[4,4],[6,4],[6,6]]"#, "[]");
    gives(r#""polygon":[[4,1],[8,2],[4,3]]"#, "[]");
    gives(r#""polygon":[[1,1],[2,2],[3,3]]"#, "[]");
    gives(r#""polygon":[[1,1],[1,1],[1,1]]"#, "[]");
}

#[test]
fn a_convex_polygon_keeps_corners_only() {
    gives(r#""polygon":[[1,1],[2,1],[3,1],[3,1],[3,3],[1,3]]"#, "[[1.0,1.0],[3.0,1.0],[3.0,3.0],[1.0,3.0]]");
    gives(r#""polygon":[[0,1],[0,-1],[2,-1],[2,1]]"#, "[[0.0,1.0],[0.0,0.0],[2.0,0.0],[2.0,1.0]]");
    // Any number of them on one side, wherever the list starts.
    let three = "[[0.0,0.0],[3.0,0.0],[0.0,3.0]]";
    gives(r#""polygon":[[0,0],[0.5,0],[1,0],[2,0],[3,0],[0,3]]"#, three);
    gives(r#""polygon":[[2,0],[3,0],[0,3],[0,2],[0,1],[0,0],[1,0]]"#, "[[3.0,0.0],[0.0,3.0],[0.0,0.0]]");
}

#[test]
fn a_spike_along_a_border_is_the_same_from_either_direction() {
    gives(
        r#""polygon":[[0,0],[1.7e38,0],[3.5,0],[1,0],[0,0],[0,1]]"#,
        "[[0.0,0.0],[4.0,0.0],[0.0,0.0],[0.0,1.0]]",
    );
    gives(
        r#""polygon":[[0,1],[0,0],[1,0],[3.5,0],[1.7e38,0],[0,0]]"#,
        "[[0.0,1.0],[0.0,0.0],[4.0,0.0],[0.0,0.0]]",
    );
}

#[test]
fn pieces_of_a_concave_polygon_stay_joined_along_the_border() {
    gives(
        r#""polygon":[[-2,0],[2,1],[-1,2],[2,3],[-2,4]]"#,
        "[[0.0,0.5],[2.0,1.0],[0.0,1.6666666269302368],[0.0,2.3333332538604736],[2.0,3.0],[0.0,3.5]]",
    );
}

#[test]
fn a_window_without_area_leaves_nothing() {
    check(&[(
        r#"{"op":"clip_polygon","window":[1,0,1,4],"polygon":[[0,0],[4,0],[4,4]]}"#,
        r#"{"polygon":[]}"#,
    )]);
}

#[test]
fn rounded_arithmetic_answers_as_taught() {
    let ask_in = |arithmetic: &str| {
        ask(format!(r#"{{{UNIT},"arithmetic":"{arithmetic}","polygon":[[4,1],[0.1,3],[-0.3,0.7]]}}"#)
            .as_bytes())
    };
    let [exact, f32, f64] = ["exact", "f32", "f64"].map(ask_in);
    assert_eq!(exact["polygon"].as_array().map(Vec::len), Some(4));
    assert_eq!(exact, f64);
    assert_ne!(exact["polygon"], json!([]));
    assert_eq!(f32["polygon"].as_array().map(Vec::len), Some(4));
    // A corner on the border is its own cut, and as taught is emitted twice.
    gives(r#""arithmetic":"f32","polygon":[[4,1],[6,2],[2,3]]"#, "[[4.0,1.0],[4.0,1.0],[4.0,2.5],[2.0,3.0]]");
}

#[test]
fn every_wrong_request_has_its_code() {
    check_codes(&[
        (r#"{"op":"clip_polygon","polygon":[[0,0],[1,0],[0,1]]}"#, "missing-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4]}"#, "missing-field"),
        (r#"{"op":"clip_polygon","window":[4,0,0,4],"polygon":[[0,0],[1,0],[0,1]]}"#, "bad-window"),
        (r#"{"op":"clip_polygon","window":[0,0,4],"polygon":[[0,0],[1,0],[0,1]]}"#, "bad-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":[[0,0],[1,0]]}"#, "bad-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":[]}"#, "bad-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":7}"#, "bad-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0]]}"#, "bad-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0,"1"]]}"#, "bad-field"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0,1e39]]}"#, "not-finite"),
        (r#"{"op":"clip_polygon","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0,1e999]]}"#, "not-finite"),
        (
            r#"{"op":"clip_polygon","algorithm":"cohen-sutherland","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0,1]]}"#,
            "unknown-algorithm",
        ),
        (
            r#"{"op":"clip_polygon","arithmetic":"fixed-8","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0,1]]}"#,
            "unsupported",
        ),
        (
            r#"{"op":"clip_polygon","arithmetic":"f16","window":[0,0,4,4],"polygon":[[0,0],[1,0],[0,1]]}"#,
            "unknown-arithmetic",
        ),
        (
            r#"{"op":"clip_polygon","arithmetic":"f32","window":[0,0,4,4],"polygon":[[-3e38,-3e38],[3e38,3e38],[3e38,2]]}"#,
            "overflow",
        ),
    ]);
}

/// Every end of the range of binary32, in exact arithmetic.
#[test]
fn huge_polygons_have_an_answer() {
    gives(
        r#""polygon":[[-3.4e38,-3.4e38],[3.4e38,-3.4e38],[3.4e38,3.4e38],[-3.4e38,3.4e38]]"#,
        "[[4.0,0.0],[4.0,4.0],[0.0,4.0],[0.0,0.0]]",
    );
}
