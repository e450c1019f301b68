//! The seven pictures by which the lectures' own project, lantern, tests its rasterizers, as data: on five
//! by five pixels, one triangle without a tie, four with corners on pixel centres, and two meshes whose
//! shared edges run through centres. Here every algorithm draws them.
//!
//! *Source:* github.com/loreglean/lantern (named by lecture 002), `tests/src/pipeline.cpp`; its vertices in
//! normalized device coordinates are given in pixels.

use rasterscope_core::{
    math::Tally,
    raster::{Algorithm, Settings, rows},
};

type Triangle = [[f32; 2]; 3];

// The corners of the square whose corners are pixel centres, and its middle.
const A: [f32; 2] = [0.5, 0.5];
const B: [f32; 2] = [4.5, 0.5];
const C: [f32; 2] = [4.5, 4.5];
const D: [f32; 2] = [0.5, 4.5];
const MIDDLE: [f32; 2] = [2.5, 2.5];

/// The triangles in drawing order; a pixel shows the number of the last one that drew it.
#[track_caller]
fn check(triangles: &[Triangle], expected: [&str; 5]) {
    for algorithm in Algorithm::ALL {
        let mut picture = vec![vec!['.'; 5]; 5];
        for (&triangle, number) in triangles.iter().zip('1'..) {
            for span in rows(algorithm, triangle, &Settings::new([5, 5]), &mut Tally::default()) {
                let row = &mut picture[span.y as usize][span.begin as usize..span.end as usize];
                assert!(row.iter().all(|pixel| *pixel == '.'), "{algorithm:?} draws a pixel twice");
                row.fill(number);
            }
        }
        let picture: Vec<String> = picture.into_iter().map(String::from_iter).collect();
        assert_eq!(picture, expected, "{algorithm:?}");
    }
}

#[test]
fn no_centre_on_an_edge() {
    check(&[[[2.625, 0.25], [0.25, 1.25], [2.875, 4.5]]], ["..1..", "111..", ".11..", "..1..", "....."]);
}

#[test]
fn right_angle_at_the_upper_left() {
    check(&[[A, D, B]], ["1111.", "111..", "11...", "1....", "....."]);
}

#[test]
fn right_angle_at_the_upper_right() {
    check(&[[B, A, C]], ["1111.", ".111.", "..11.", "...1.", "....."]);
}

#[test]
fn right_angle_at_the_lower_right() {
    check(&[[B, D, C]], [".....", "...1.", "..11.", ".111.", "....."]);
}

#[test]
fn right_angle_at_the_lower_left() {
    check(&[[A, D, C]], [".....", "1....", "11...", "111..", "....."]);
}

#[test]
fn four_triangles_around_a_centre() {
    check(
        &[[B, A, MIDDLE], [A, D, MIDDLE], [D, C, MIDDLE], [C, B, MIDDLE]],
        ["1111.", "2114.", "2244.", "2334.", "....."],
    );
}

#[test]
fn two_triangles_along_a_diagonal() {
    check(&[[A, D, C], [B, A, C]], ["2222.", "1222.", "1122.", "1112.", "....."]);
}
