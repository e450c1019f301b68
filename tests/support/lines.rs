//! Lines that break clippers, and what of them is visible.

use super::Random;
use rasterscope_core::{
    clip::line::{Segment, Window},
    math::Dyadic,
};

/// The window of the golden logs.
pub(crate) const LINE_WINDOW: [f32; 4] = [3.5, 2.0, 9.0, 6.5];

pub(crate) fn window(sides: [f32; 4]) -> Window {
    Window::new(sides).expect("the test's window is right")
}

/// A random segment and window of one of several nasty families.
pub(crate) fn line(random: &mut Random) -> (Segment, Window) {
    let family = random.below(5);
    let mut side = || {
        let (a, b) = (random.grid(0, 5), random.grid(0, 5));
        [a.min(b), a.max(b)]
    };
    let [[xmin, xmax], [ymin, ymax]] = [side(), side()];
    let mut coordinate = |sides: [f32; 2]| match family {
        0 | 1 => random.grid(-3, 8),
        2 => {
            let border = random.pick(&sides);
            random.near(border)
        }
        3 => random.any(),
        _ => random.uniform(-1e3, 1e3),
    };
    let mut point = || [coordinate([xmin, xmax]), coordinate([ymin, ymax])];
    ([point(), point()], window([xmin, ymin, xmax, ymax]))
}

/// A random segment and window of any family: those of [`line`], lines through a corner or an ULP
/// beside it, and lines nearly parallel to a border.
pub(crate) fn any_line(random: &mut Random) -> (Segment, Window) {
    let (segment, window) = line(random);
    let segment = match random.below(7) {
        0 => through_a_corner(random, &window),
        1 => nearly_parallel(random, &window),
        _ => segment,
    };
    (segment, window)
}

/// A segment through a corner of the window, or an ULP beside it; sometimes one that ends there.
fn through_a_corner(random: &mut Random, window: &Window) -> Segment {
    let corner = random.pick(&window.corners());
    let direction = [random.grid(-3, 4), random.grid(-3, 4)];
    let reach = [-random.pick(&[0.0, 1.0, 2.0, 8.0]), random.pick(&[0.0, 1.0, 4.0, 1024.0])];
    let mut segment = reach.map(|reach| [0, 1].map(|axis| corner[axis] + reach * direction[axis]));
    if random.below(2) == 0 {
        let end = random.pick(&[0_usize, 1]);
        let axis = random.pick(&[0_usize, 1]);
        segment[end][axis] = random.near(segment[end][axis]);
    }
    segment
}

/// A segment that runs nearly along a border, or right across the window.
fn nearly_parallel(random: &mut Random, window: &Window) -> Segment {
    let axis = random.pick(&[0_usize, 1]);
    let [low, high] = window.sides(axis);
    let at = random.pick(&[low, high, low / 2.0 + high / 2.0]);
    [0, 1].map(|_| {
        let mut end = [random.uniform(-1e3, 1e3); 2];
        end[axis] = random.near(at);
        end
    })
}

/// Parametric clipping in rational numbers: the exact interval of visible parameters, and the ends
/// there; both rounded once.
pub(crate) fn visible_part([p, q]: Segment, w: &Window) -> Option<(Segment, [f32; 2])> {
    let [px, py, qx, qy] = [p[0], p[1], q[0], q[1]].map(Dyadic::from);
    let (dx, dy) = (&qx - &px, &qy - &py);
    // Entering and leaving parameters as fractions with a positive denominator.
    let (mut enter, mut leave) =
        ((Dyadic::from(0.0_f32), Dyadic::from(1.0_f32)), (Dyadic::from(1.0_f32), Dyadic::from(1.0_f32)));
    let less = |a: &(Dyadic, Dyadic), b: &(Dyadic, Dyadic)| &a.0 * &b.1 < &b.0 * &a.1;
    let zero = Dyadic::from(0.0_f32);
    for (delta, start, side, sign) in
        [(&dx, &px, w.xmin, -1), (&dx, &px, w.xmax, 1), (&dy, &py, w.ymin, -1), (&dy, &py, w.ymax, 1)]
    {
        // Inside iff sign (start + t delta - side) <= 0.
        let sign = Dyadic::from(sign);
        let (rate, distance) = (&sign * delta, &sign * &(&Dyadic::from(side) - start));
        if rate == zero {
            if distance < zero {
                return None;
            }
        } else if rate > zero {
            let t = (distance, rate);
            if less(&t, &leave) {
                leave = t;
            }
        } else {
            let t = (-distance, -rate);
            if less(&enter, &t) {
                enter = t;
            }
        }
    }
    if less(&leave, &enter) {
        return None;
    }
    let at = |(t, one): &(Dyadic, Dyadic), given: &Dyadic, end: [f32; 2]| {
        if *t == given * one {
            return end; // not cut: bit for bit
        }
        [Dyadic::ratio_to_f32(&(&px * one + t * &dx), one), Dyadic::ratio_to_f32(&(&py * one + t * &dy), one)]
    };
    let t = [&enter, &leave].map(|(t, one)| Dyadic::ratio_to_f32(t, one));
    Some(([at(&enter, &zero, p), at(&leave, &Dyadic::from(1), q)], t))
}
