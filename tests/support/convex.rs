//! Convex windows and lines that break clippers, and what of these is visible.

use super::Random;
use rasterscope_core::{
    clip::line::{ConvexWindow, Point, Segment},
    math::Dyadic,
};

/// A random segment and the corners of a convex polygon, of one of several nasty families.
pub(crate) fn convex(random: &mut Random) -> (Segment, Vec<Point>) {
    let family = random.below(6);
    let corners = corners(random, family);
    let mut coordinate = |axis: usize| match family {
        0 | 1 => random.grid(-3, 8),
        // At a corner, or next to it.
        2 | 4 => {
            let corner = random.pick(&corners);
            random.near(corner[axis])
        }
        3 => random.any(),
        _ => random.uniform(-1e3, 1e3),
    };
    let mut point = || [coordinate(0), coordinate(1)];
    ([point(), point()], corners)
}

/// Three to six corners: points of a random cloud, as far as they stay convex.
fn corners(random: &mut Random, family: u32) -> Vec<Point> {
    loop {
        let mut outline: Vec<Point> = Vec::new();
        for _ in 0..6 {
            let mut coordinate = || match family {
                3 => random.any(),
                // Exponents far apart, so that nothing is exact in binary64.
                4 => random.uniform(0.0, 1.0) * random.pick(&[1e-30, 1e-3, 1.0, 1e7, 1e30]),
                // About as large as the lines are.
                5 => random.uniform(-1e3, 1e3),
                _ => random.grid(0, 5),
            };
            let corner = [coordinate(), coordinate()];
            // Anywhere between two corners where the outline stays convex.
            let grown = (0..=outline.len()).find_map(|place| {
                let mut grown = outline.clone();
                grown.insert(place, corner);
                (grown.len() < 3 || ConvexWindow::new(&grown).is_ok()).then_some(grown)
            });
            outline = grown.unwrap_or(outline);
        }
        if ConvexWindow::new(&outline).is_ok() {
            return outline;
        }
    }
}

/// Parametric clipping against edges, the inside on their left, in rational numbers; rounded once.
pub(crate) fn visible_part_of([p, q]: Segment, edges: &[Segment]) -> Option<Segment> {
    let [px, py, qx, qy] = [p[0], p[1], q[0], q[1]].map(Dyadic::from);
    let (dx, dy) = (&qx - &px, &qy - &py);
    let one = || Dyadic::from(1);
    // Entering and leaving parameters as fractions with a positive denominator.
    let (mut enter, mut leave) = ((Dyadic::from(0), one()), (one(), one()));
    let less = |a: &(Dyadic, Dyadic), b: &(Dyadic, Dyadic)| &a.0 * &b.1 < &b.0 * &a.1;
    for [a, b] in edges {
        let [ax, ay, bx, by] = [a[0], a[1], b[0], b[1]].map(Dyadic::from);
        let (ex, ey) = (&bx - &ax, &by - &ay);
        // Inside iff distance + t speed >= 0.
        let speed = &ex * &dy - &ey * &dx;
        let distance = &ex * &(&py - &ay) - &ey * &(&px - &ax);
        if speed.is_zero() {
            if distance.sign().is_negative() {
                return None;
            }
        } else if speed.sign().is_positive() {
            let t = (-distance, speed);
            enter = if less(&enter, &t) { t } else { enter };
        } else {
            let t = (distance, -speed);
            leave = if less(&t, &leave) { t } else { leave };
        }
    }
    if less(&leave, &enter) {
        return None;
    }
    let at = |(t, one): &(Dyadic, Dyadic), given: i32, end: Point| {
        if *t == &Dyadic::from(given) * one {
            return end; // not cut: bit for bit
        }
        let along = |from: &Dyadic, by: &Dyadic| Dyadic::ratio_to_f32(&(from * one + t * by), one);
        [along(&px, &dx), along(&py, &dy)]
    };
    Some([at(&enter, 0, p), at(&leave, 1, q)])
}
