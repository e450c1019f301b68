//! `compute`'s `clip_line` with the algorithms beyond the two that the interface fixes.

use crate::compute::{check, check_codes};

#[test]
fn every_algorithm_clips_a_line() {
    let cases =
        ["cohen-sutherland", "liang-barsky", "cyrus-beck", "midpoint", "nicholl-lee-nicholl"].map(|name| {
            format!(r#"{{"op":"clip_line","algorithm":"{name}","window":[0,0,4,4],"segment":[-2,7,6,3]}}"#)
        });
    for request in &cases {
        let answer = crate::compute::ask(request.as_bytes());
        assert_eq!(answer["visible"], true, "{request}");
        assert_eq!(answer["segment"], serde_json::json!([4.0, 4.0, 4.0, 4.0]), "{request}");
    }
}

#[test]
fn a_convex_window_is_a_polygon() {
    check(&[
        (
            r#"{"op":"clip_line","algorithm":"cyrus-beck","polygon":[[3,4],[6,2],[9,4],[6,7]],"segment":[0,4,12,4]}"#,
            r#"{"visible":true,"segment":[3.0,4.0,9.0,4.0]}"#,
        ),
        // Clockwise.
        (
            r#"{"op":"clip_line","algorithm":"cyrus-beck","polygon":[[6,7],[9,4],[6,2],[3,4]],"segment":[0,4,12,4]}"#,
            r#"{"visible":true,"segment":[3.0,4.0,9.0,4.0]}"#,
        ),
        (
            r#"{"op":"clip_line","algorithm":"cyrus-beck","polygon":[[3,4],[6,2],[9,4],[6,7]],"segment":[0,1,12,1]}"#,
            r#"{"visible":false,"segment":null}"#,
        ),
    ]);
    check_codes(&[
        (
            r#"{"op":"clip_line","algorithm":"cyrus-beck","polygon":[[0,0],[4,0],[1,1],[0,4]],"segment":[0,0,1,1]}"#,
            "bad-window",
        ),
        (
            r#"{"op":"clip_line","algorithm":"cyrus-beck","polygon":[[0,0],[1,1],[3,3]],"segment":[0,0,1,1]}"#,
            "bad-window",
        ),
        (
            r#"{"op":"clip_line","algorithm":"cyrus-beck","polygon":[[0,0],[1,"x"]],"segment":[0,0,1,1]}"#,
            "bad-field",
        ),
        (r#"{"op":"clip_line","algorithm":"cyrus-beck","segment":[0,0,1,1]}"#, "missing-field"),
        (
            r#"{"op":"clip_line","algorithm":"midpoint","polygon":[[0,0],[1,0],[1,1]],"segment":[0,0,1,1]}"#,
            "missing-field",
        ),
    ]);
}
