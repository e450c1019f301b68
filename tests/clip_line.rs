//! All line clipping algorithms against one exact oracle that knows none of them, and each other.

use crate::support::{
    Clipper, CohenSutherland, CyrusBeck, LiangBarsky, Midpoint, NichollLeeNicholl, Random, any_line, bits,
    visible_part,
};
use rasterscope_core::{
    clip::line::{Segment, Window},
    math::ulps_between,
};

/// What every answer keeps, however it is found: the order of the ends does not matter, it lies in
/// the window, and an end inside keeps its bits.
#[track_caller]
fn keeps_the_contract<C: Clipper>(segment: Segment, window: &Window) -> Option<Segment> {
    let answer = C::clip(segment, window);
    let [p1, p2] = segment;
    let reversed = C::clip([p2, p1], window).map(|[a, b]| [b, a]);
    assert_eq!(bits(answer), bits(reversed), "{segment:?} reversed in {window:?}");
    for (given, found) in segment.into_iter().zip(answer.into_iter().flatten()) {
        let inside = |[x, y]: [f32; 2]| {
            (window.xmin..=window.xmax).contains(&x) && (window.ymin..=window.ymax).contains(&y)
        };
        assert!(inside(found), "{segment:?} leaves {window:?}: {found:?}");
        if inside(given) {
            assert_eq!(given.map(f32::to_bits), found.map(f32::to_bits), "{segment:?} in {window:?}");
        }
    }
    answer
}

#[test]
fn every_algorithm_answers_as_the_rational_oracle_does() {
    let mut random = Random::new(1984);
    let (mut visible, mut off) = (0, 0);
    for _ in 0..100_000 {
        let (segment, window) = any_line(&mut random);
        let expected = visible_part(segment, &window).map(|(ends, _)| ends);
        let answer = keeps_the_contract::<CohenSutherland>(segment, &window);
        assert_eq!(answer, expected, "{segment:?} in {window:?}");
        for sibling in [
            keeps_the_contract::<LiangBarsky>(segment, &window),
            keeps_the_contract::<NichollLeeNicholl>(segment, &window),
            keeps_the_contract::<CyrusBeck>(segment, &window),
        ] {
            assert_eq!(bits(sibling), bits(answer), "{segment:?} in {window:?}");
        }
        let halved = keeps_the_contract::<Midpoint>(segment, &window);
        assert_eq!(halved.is_some(), answer.is_some(), "{segment:?} in {window:?}");
        let coordinates = |ends: Option<Segment>| ends.into_iter().flatten().flatten();
        for (a, b) in coordinates(halved).zip(coordinates(answer)) {
            let apart = ulps_between(a, b);
            assert!(apart <= 1, "{segment:?} in {window:?}: {halved:?}, not {answer:?}");
            off += apart;
        }
        visible += u32::from(answer.is_some());
    }
    assert!((20_000..80_000).contains(&visible), "the families are lopsided: {visible} visible");
    assert!(off > 1_000, "halving never shows its step: {off}");
}
