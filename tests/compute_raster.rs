//! `compute`: polygons, lines and points.

use crate::compute::{check, check_codes};

#[test]
fn polygons_are_filled_by_either_rule() {
    let star = r#""size":[9,7],"contours":[[[4.5,0.25],[6.75,6.5],[1,2.5],[8,2.5],[2.25,6.5]]]"#;
    let odd = r#"{"rows":[[0,4,5],[1,4,5],[2,1,4],[2,5,8],[3,2,3],[3,6,7],[4,3,4],[4,5,6],[5,3,4],[5,5,6]]}"#;
    let any = r#"{"rows":[[0,4,5],[1,4,5],[2,1,8],[3,2,7],[4,3,6],[5,3,4],[5,5,6]]}"#;
    check(&[
        (&format!(r#"{{"op":"fill_polygon",{star}}}"#), odd),
        (&format!(r#"{{"op":"fill_polygon","winding":"non-zero",{star}}}"#), any),
        (
            r#"{"op":"fill_polygon","size":[3,3],"y_axis":"up","contours":[[[0.5,0.5],[2.5,0.5],[0.5,2.5]]]}"#,
            r#"{"rows":[[1,0,1]]}"#,
        ),
        (r#"{"op":"fill_polygon","size":[3,3],"contours":[]}"#, r#"{"rows":[]}"#),
    ]);
}

#[test]
fn lines_are_drawn_by_each_algorithm() {
    check(&[
        (
            r#"{"op":"line","size":[5,3],"segment":[0.5,0.5,4.5,2.5]}"#,
            r#"{"pixels":[[0,0],[1,1],[2,1],[3,2],[4,2]]}"#,
        ),
        (
            r#"{"op":"line","algorithm":"dda","arithmetic":"f64","size":[5,3],"segment":[4.9,2.1,0.1,0.9]}"#,
            r#"{"pixels":[[4,2],[3,2],[2,1],[1,1],[0,0]]}"#,
        ),
        (
            r#"{"op":"line","algorithm":"diamond-exit","size":[5,3],"segment":[0.5,0.5,4.5,2.5]}"#,
            r#"{"pixels":[[0,0],[1,0],[2,1],[3,1]]}"#,
        ),
        (r#"{"op":"line","algorithm":"diamond-exit","size":[5,3],"segment":[1,1,1,1]}"#, r#"{"pixels":[]}"#),
    ]);
}

#[test]
fn points_are_squares() {
    check(&[
        (r#"{"op":"point","size":[5,5],"point":[2,2]}"#, r#"{"rows":[[1,1,2]]}"#),
        (r#"{"op":"point","size":[5,5],"point":[2.5,2.5],"point_size":2}"#, r#"{"rows":[[1,1,3],[2,1,3]]}"#),
        (r#"{"op":"point","size":[5,5],"point":[2.5,2.5],"point_size":0}"#, r#"{"rows":[]}"#),
    ]);
}

#[test]
fn what_makes_no_sense_has_a_code() {
    check_codes(&[
        (r#"{"op":"fill_polygon","size":[3,3]}"#, "missing-field"),
        (r#"{"op":"fill_polygon","size":[3,3],"contours":[[[0,0],[1,1]]]}"#, "bad-field"),
        (r#"{"op":"fill_polygon","size":[3,3],"contours":[],"winding":"both"}"#, "unknown-winding"),
        (r#"{"op":"line","size":[3,3],"segment":[0,0,1e6,1]}"#, "bad-field"),
        (r#"{"op":"line","size":[3,3],"segment":[0,0,1,1],"arithmetic":"f32"}"#, "unsupported"),
        (r#"{"op":"line","size":[3,3],"segment":[0,0,1,1],"algorithm":"wu"}"#, "unknown-algorithm"),
        (r#"{"op":"point","size":[3,3],"point":[1,1],"point_size":"1"}"#, "bad-field"),
    ]);
}
