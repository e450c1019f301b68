//! Bridging edges: where an outline runs along a border there and back.

use super::super::outline::Corner;
use crate::clip::line::{Border, Segment, Window};

/// The stretches of the borders that an outline runs along in both directions.
///
/// They have no area beside them: they join pieces that fell apart, or lead to a point that the border
/// only touches. Along each border from its smaller coordinate on. Cost: quadratic in the corners on a
/// border.
pub fn bridges(corners: &[Corner], window: &Window) -> Vec<Segment> {
    let mut found = Vec::new();
    for border in Border::ALL {
        let (fixed, free) = (border.axis(), 1 - border.axis());
        let c = window.at(border);
        let along: Vec<[f32; 2]> = corners
            .iter()
            .zip(corners.iter().cycle().skip(1))
            .filter(|(a, b)| a.at[fixed] == c && b.at[fixed] == c && a.at[free] != b.at[free])
            .map(|(a, b)| [a.at[free], b.at[free]])
            .collect();
        let mut stops: Vec<f32> = along.iter().flatten().copied().collect();
        stops.sort_by(f32::total_cmp);
        stops.dedup();
        for pair in stops.windows(2) {
            let there = along.iter().any(|[a, b]| *a <= pair[0] && pair[1] <= *b);
            let back = along.iter().any(|[a, b]| *b <= pair[0] && pair[1] <= *a);
            if there && back {
                let mut ends = [[c; 2]; 2];
                (ends[0][free], ends[1][free]) = (pair[0], pair[1]);
                found.push(ends);
            }
        }
    }
    found
}
