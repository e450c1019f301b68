//! Where the name of an area stands: inside it, and inside no other if there is such a place.

use crate::geometry::{Rect, centroid, distance, edges};

/// Places tried across and down.
const PLACES: usize = 16;
/// More areas than this are not told apart.
const MOST: usize = 64;

/// The middle of a plate of that size inside area number `own`, best: wholly inside and clear of the
/// others; then its middle inside no other; then inside at all. Of equals the one nearest to the
/// centroid. `None` if nowhere inside is free.
///
/// `free` says whether a plate may stand there; its second argument asks for a place that is also
/// clear of what could be covered if need be.
pub(crate) fn place(
    areas: &[Vec<[f64; 2]>],
    own: usize,
    size: [f64; 2],
    free: impl Fn(Rect, bool) -> bool,
) -> Option<[f64; 2]> {
    let polygon = areas.get(own)?;
    let middle = centroid(polygon);
    let others = || areas.iter().enumerate().filter(|&(i, _)| i != own).map(|(_, other)| other).take(MOST);
    let rank = |at: [f64; 2]| {
        let plate = Rect::around(at, size);
        if !contains(polygon, at) || !free(plate, false) {
            return None;
        }
        let corners = [plate.min, [plate.max[0], plate.min[1]], plate.max, [plate.min[0], plate.max[1]]];
        let alone = |p: [f64; 2]| !others().any(|other| contains(other, p));
        if !alone(at) {
            return Some(2);
        }
        let clear =
            free(plate, true) && corners.iter().all(|&corner| contains(polygon, corner) && alone(corner));
        Some(if clear { 0 } else { 1 })
    };
    if rank(middle) == Some(0) {
        return Some(middle);
    }
    let corner = |pick: fn(f64, f64) -> f64| {
        polygon.iter().copied().reduce(|a, b| [pick(a[0], b[0]), pick(a[1], b[1])]).unwrap_or(middle)
    };
    let (low, high) = (corner(f64::min), corner(f64::max));
    let step = [0, 1].map(|axis| (high[axis] - low[axis]) / PLACES as f64);
    let inside = (0..PLACES * PLACES).map(|i| {
        let [x, y] = [i % PLACES, i / PLACES].map(|n| n as f64 + 0.5);
        [low[0] + x * step[0], low[1] + y * step[1]]
    });
    std::iter::once(middle)
        .chain(inside)
        .filter_map(|at| Some((rank(at)?, distance(at, middle), at)))
        .min_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)))
        .map(|(_, _, at)| at)
}

/// Whether a polygon contains a point, by the even-odd rule.
fn contains(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let crosses = |&[a, b]: &[[f64; 2]; 2]| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
    };
    edges(polygon).filter(crosses).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: [f64; 2] = [10.0, 10.0];

    fn triangle(x: f64) -> Vec<[f64; 2]> {
        vec![[x, 0.0], [x + 100.0, 0.0], [x + 50.0, 100.0]]
    }

    #[test]
    fn an_area_by_itself_is_named_at_its_centroid() {
        let at = place(&[triangle(0.0)], 0, SIZE, |_, _| true);
        assert_eq!(at, Some(centroid(&triangle(0.0))));
    }

    #[test]
    fn overlapping_areas_are_named_where_only_one_of_them_is() {
        let areas = [triangle(0.0), triangle(30.0)];
        for own in [0, 1] {
            let at = place(&areas, own, SIZE, |_, _| true).expect("there is room");
            assert!(contains(&areas[own], at) && !contains(&areas[1 - own], at), "{at:?}");
        }
    }

    #[test]
    fn an_area_wholly_inside_another_is_named_inside_all_the_same() {
        let inner = vec![[40.0, 10.0], [60.0, 10.0], [50.0, 40.0]];
        let at = place(&[triangle(0.0), inner.clone()], 1, SIZE, |_, _| true).expect("there is room");
        assert!(contains(&inner, at));
    }

    #[test]
    fn a_full_area_has_no_place() {
        assert_eq!(place(&[triangle(0.0)], 0, SIZE, |_, _| false), None);
        assert_eq!(place(&[], 0, SIZE, |_, _| true), None);
    }
}
