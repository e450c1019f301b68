//! A convex window: any convex polygon, either way round.

use super::{Point, Segment, Window};
use crate::math::{Sign, Tally, next_down, next_up, orient2d};

/// Why a list of corners is no convex window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// Fewer than three corners, or more than [`ConvexWindow::MOST_CORNERS`].
    Corners,
    /// A coordinate is not finite.
    NotFinite,
    /// All corners lie on one line: there is no inside.
    NoArea,
    /// Some corner bends inward, or the outline crosses itself.
    NotConvex,
}

impl Flaw {
    /// Every flaw.
    pub const ALL: [Self; 4] = [Self::Corners, Self::NotFinite, Self::NoArea, Self::NotConvex];

    /// The message that says so of a field of a scene file, whose argument `path` is the field.
    pub(crate) fn problem(self) -> &'static str {
        match self {
            Self::Corners => "error-scene-polygon-corners",
            Self::NotFinite => "error-scene-not-finite",
            Self::NoArea => "error-scene-polygon-no-area",
            Self::NotConvex => "error-scene-polygon-not-convex",
        }
    }

    /// The message that says so.
    pub fn message(self) -> &'static str {
        match self {
            Self::Corners => "error-polygon-corners",
            Self::NotFinite => "error-polygon-not-finite",
            Self::NoArea => "error-polygon-no-area",
            Self::NotConvex => "error-polygon-not-convex",
        }
    }
}

/// A closed convex window with finite corners, y up.
#[derive(Clone, Debug, PartialEq)]
pub struct ConvexWindow {
    corners: Vec<Point>,
    edges: Vec<Segment>,
}

impl ConvexWindow {
    /// The most corners of a window: enough for a circle, and few enough to look at.
    pub const MOST_CORNERS: usize = 32;

    /// From the corners in order, clockwise or counter-clockwise. Corners may repeat or lie on the
    /// line of their neighbours. Decided exactly; the cost grows with the square of the corners.
    ///
    /// # Errors
    /// What keeps it from being a convex window.
    pub fn new(corners: &[Point]) -> Result<Self, Flaw> {
        if !(3..=Self::MOST_CORNERS).contains(&corners.len()) {
            return Err(Flaw::Corners);
        }
        if !corners.iter().flatten().all(|x| x.is_finite()) {
            return Err(Flaw::NotFinite);
        }
        let next = corners.iter().cycle().skip(1);
        let mut edges: Vec<Segment> = corners.iter().zip(next).map(|(a, b)| [*a, *b]).collect();
        // Convex means that every corner is on the same side of every edge.
        let mut tally = Tally::default();
        let mut turn = Sign::Zero;
        for [a, b] in &edges {
            for c in corners {
                let side = orient2d(*a, *b, *c, &mut tally);
                if !side.is_zero() && side == -turn {
                    return Err(Flaw::NotConvex);
                }
                turn = if side.is_zero() { turn } else { side };
            }
        }
        if turn.is_zero() {
            return Err(Flaw::NoArea);
        }
        if turn.is_negative() {
            for edge in &mut edges {
                edge.reverse();
            }
        }
        Ok(Self { corners: corners.to_vec(), edges })
    }

    /// The corners as they were given.
    pub fn corners(&self) -> &[Point] {
        &self.corners
    }

    /// The edges, each from one corner to the next: two points of its line, the inside on the left.
    pub fn edges(&self) -> &[Segment] {
        &self.edges
    }
}

/// A rectangle, also one without area: its edges then keep their directions.
impl From<Window> for ConvexWindow {
    fn from(window: Window) -> Self {
        let rising = |low: f32, high: f32| match low < high {
            true => [low, high],
            false if low < f32::MAX => [low, next_up(low)],
            false => [next_down(low), low],
        };
        let [x, y] = [0, 1].map(|axis| {
            let [low, high] = window.sides(axis);
            rising(low, high)
        });
        let Window { xmin, ymin, xmax, ymax } = window;
        let edges = vec![
            [[x[0], ymin], [x[1], ymin]],
            [[xmax, y[0]], [xmax, y[1]]],
            [[x[1], ymax], [x[0], ymax]],
            [[xmin, y[1]], [xmin, y[0]]],
        ];
        Self { corners: window.corners().to_vec(), edges }
    }
}
