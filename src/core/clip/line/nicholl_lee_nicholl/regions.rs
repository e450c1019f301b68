//! The regions that lines from P1 through the window's corners divide the plane into.

use super::{Event, clip_traced};
use crate::{
    clip::line::{Border, Outcode, Point, Window},
    explain::View,
    math::{Arithmetic, Tally},
};

/// The borders that a line is cut at, entry first: the name of P2's region.
pub(super) fn name(cuts: [Option<Border>; 2]) -> String {
    cuts.into_iter().flatten().map(Border::letter).collect()
}

/// The borders where a line that ends at `p2` is cut, or `None` if it is not visible.
fn region(p1: Point, p2: Point, window: &Window) -> Option<[Option<Border>; 2]> {
    let (mut events, mut cuts) = (Vec::new(), [None; 2]);
    clip_traced([p1, p2], window, Arithmetic::Exact, &mut Tally::default(), &mut events)?;
    for event in events {
        if let Event::Cut { border, end, .. } = event {
            cuts[end as usize] = Some(border);
        }
    }
    Some(cuts)
}

/// `a + t (b - a)`.
fn on_the_way(a: Point, b: Point, t: f64) -> Point {
    [0, 1].map(|axis| {
        let [a, b] = [a, b].map(|p| f64::from(p[axis]));
        (a + t * (b - a)) as f32
    })
}

/// How far a ray from `from` through `through` stays in the picture, as a multiple of the distance
/// between the two; `None` if they are one point.
fn reach(from: Point, through: Point, view: &View) -> Option<f64> {
    let axes = (0..2).filter(|&axis| from[axis] != through[axis]).map(|axis| {
        let limit = if through[axis] > from[axis] { view.max } else { view.min };
        (f64::from(limit[axis]) - f64::from(from[axis])) / (f64::from(through[axis]) - f64::from(from[axis]))
    });
    axes.reduce(f64::min)
}

/// The rays from P1 through the corners, as far as the picture goes.
pub(super) fn rays(p1: Point, window: &Window, view: &View) -> Vec<[Point; 2]> {
    let ray = |corner| Some([p1, on_the_way(p1, corner, reach(p1, corner, view)?)]);
    window.corners().into_iter().filter_map(ray).collect()
}

/// The corner where two borders meet.
pub(super) fn corner(window: &Window, [a, b]: [Border; 2]) -> Point {
    let mut corner = [window.at(a); 2];
    corner[b.axis()] = window.at(b);
    corner
}

/// The names of the visible regions, each at a point of it; `code` is that of P1.
pub(super) fn names(p1: Point, code: Outcode, window: &Window, view: &View) -> Vec<(String, Point)> {
    let middle = |a: Point, b: Point| on_the_way(a, b, 0.5);
    let ends = |border: Border| {
        let across =
            if border.axis() == 0 { [Border::Bottom, Border::Top] } else { [Border::Left, Border::Right] };
        across.map(|other| corner(window, [border, other]))
    };
    let near: Vec<Border> = Border::ALL.into_iter().filter(|border| code.has(*border)).collect();
    let mut places = Vec::new();
    // Inside the window: behind each border where the line can enter.
    let [low, _, high, _] = window.corners();
    let centre = middle(low, high);
    places.extend(near.iter().map(|border| {
        let [a, b] = ends(*border);
        middle(middle(a, b), centre)
    }));
    // Beyond each border where it can leave; a corner that it can enter on both sides of splits it.
    let split = match near[..] {
        [a, b] => Some(corner(window, [a, b])),
        _ => None,
    };
    for border in Border::ALL.into_iter().filter(|border| !code.has(*border)) {
        let [a, b] = ends(border);
        let axis = border.axis();
        let crossing = split.and_then(|corner| {
            let [from, to, at] = [p1[axis], corner[axis], window.at(border)].map(f64::from);
            let place = on_the_way(p1, corner, (at - from) / (to - from))[1 - axis];
            let inside = a[1 - axis] < place && place < b[1 - axis];
            let mut point = a;
            point[1 - axis] = place;
            inside.then_some(point)
        });
        let pieces = match crossing {
            Some(c) => vec![middle(a, c), middle(c, b)],
            None => vec![middle(a, b)],
        };
        places.extend(pieces.into_iter().filter_map(|q| {
            let reach = reach(p1, q, view)?;
            (reach > 1.0).then(|| on_the_way(p1, q, (1.0 + reach) / 2.0))
        }));
    }
    let named = |at| Some((name(region(p1, at, window)?), at));
    places.into_iter().filter_map(named).filter(|(name, _)| !name.is_empty()).collect()
}
