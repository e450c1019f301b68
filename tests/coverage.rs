//! Coverage: every algorithm against an oracle in big integers, and the shared edges of meshes.

use rasterscope_core::{
    math::Tally,
    raster::{Algorithm, FillRule, Settings, rows},
};

/// ALGORITHMS' acceptance scene: the square's corners lie on pixel centres.
const SQUARE: [[[f32; 2]; 3]; 2] =
    [[[1.5, 1.5], [7.5, 1.5], [7.5, 7.5]], [[1.5, 1.5], [7.5, 7.5], [1.5, 7.5]]];

/// How often each pixel of a 10 x 10 image is drawn.
fn hits(triangles: &[[[f32; 2]; 3]], algorithm: Algorithm, fill_rule: FillRule) -> Vec<Vec<u32>> {
    let settings = Settings { fill_rule, ..Settings::new([10, 10]) };
    let mut hits = vec![vec![0; 10]; 10];
    for &triangle in triangles {
        for span in rows(algorithm, triangle, &settings, &mut Tally::default()) {
            (span.begin..span.end).for_each(|x| hits[span.y as usize][x as usize] += 1);
        }
    }
    hits
}

#[test]
fn acceptance_square() {
    for algorithm in Algorithm::ALL {
        let count = |rule, n| hits(&SQUARE, algorithm, rule).concat().iter().filter(|&&hit| hit == n).count();
        assert_eq!((count(FillRule::TopLeft, 1), count(FillRule::TopLeft, 2)), (36, 0), "{algorithm:?}");
        assert_eq!((count(FillRule::Inclusive, 1), count(FillRule::Inclusive, 2)), (42, 7));
        assert_eq!((count(FillRule::Strict, 1), count(FillRule::Strict, 2)), (20, 0));
    }
}
