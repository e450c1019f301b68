//! What is visible of a segment, in rational numbers, and what is wrong with an answer.

use super::{Answer, Segment, Sides};
use crate::exact::{between, integer, nearest, rational};
use num_traits::Zero;

/// The visible part of a closed window, each coordinate rounded once: the exact interval of the
/// parameter, as Cyrus and Beck define it. An end that is visible comes back as it is.
pub fn visible([p, q]: Segment, [xmin, ymin, xmax, ymax]: Sides) -> Option<Segment> {
    let [p_exact, q_exact] = [p, q].map(|point| point.map(rational));
    let (mut enter, mut leave) = (integer(0), integer(1));
    for (axis, side, sign) in [(0, xmin, -1), (0, xmax, 1), (1, ymin, -1), (1, ymax, 1)] {
        // Inside where rate * t <= distance.
        let rate = (&q_exact[axis] - &p_exact[axis]) * integer(sign);
        let distance = (rational(side) - &p_exact[axis]) * integer(sign);
        if rate.is_zero() {
            if distance < integer(0) {
                return None;
            }
            continue;
        }
        let t = distance / &rate;
        if rate > integer(0) {
            leave = leave.min(t);
        } else {
            enter = enter.max(t);
        }
    }
    if enter > leave {
        return None;
    }
    let at = |t, whole, given| {
        if t == integer(whole) {
            return given;
        }
        [0, 1].map(|axis| nearest(&between(&p_exact[axis], &q_exact[axis], &t)))
    };
    Some([at(enter, 0, p), at(leave, 1, q)])
}

/// Not visible, but kept; visible, but dropped; an end outside the window; an end that is not the
/// nearest binary32 (an answer in binary64 is rounded to binary32 first).
pub const COLUMNS: [&str; 4] = ["kept", "dropped", "outside", "not nearest"];

/// How many answers are wrong in which way, in the order of [`COLUMNS`].
pub fn count(
    answers: &[Answer],
    expected: &[Option<Segment>],
    [xmin, ymin, xmax, ymax]: Sides,
) -> Vec<usize> {
    let [xmin, ymin, xmax, ymax] = [xmin, ymin, xmax, ymax].map(f64::from);
    let mut counts = vec![0; COLUMNS.len()];
    for (answer, expected) in answers.iter().zip(expected) {
        match (answer, expected) {
            (None, None) => {}
            (Some(_), None) => counts[0] += 1,
            (None, Some(_)) => counts[1] += 1,
            (Some(answer), Some(expected)) => {
                let inside = |[x, y]: &[f64; 2]| xmin <= *x && *x <= xmax && ymin <= *y && *y <= ymax;
                counts[2] += usize::from(!answer.iter().all(inside));
                counts[3] += usize::from(answer.map(|p| p.map(|x| x as f32)) != *expected);
            }
        }
    }
    counts
}
