//! The arithmetics in which the text of the algorithm runs.

use super::{
    super::{ConvexWindow, End, Point, Segment, parametric::difference, parametric::point_at},
    Course, Edge, Parameter,
};
use crate::math::{Approx, Dyadic, Real, Sign, Tally, edge_value, orient2d, rounded_ratio};
use std::ops::Range;

/// The line while it meets one edge after the other.
pub(super) trait Form {
    /// The segment as it was given.
    fn given(&self) -> Segment;
    /// The edges of the window.
    fn edges(&self) -> Range<Edge>;
    /// The sign of D.n, with which the line goes inward.
    fn course(&mut self, edge: Edge) -> Course;
    /// Whether w.n < 0; only asked of a parallel edge.
    fn outside(&mut self, edge: Edge) -> bool;
    /// -w.n / D.n, rounded; not asked of a parallel edge.
    fn divide(&mut self, edge: Edge) -> f32;
    /// The sign of `a - b`; no edge of them is parallel.
    fn order(&mut self, a: Parameter<Edge>, b: Parameter<Edge>) -> Sign;
    /// The point at an edge.
    fn cut(&mut self, edge: Edge) -> Point;
}

/// There are at most [`ConvexWindow::MOST_CORNERS`], so that an index fits.
fn edges(window: &ConvexWindow) -> Range<Edge> {
    0..Edge::try_from(window.edges().len()).unwrap_or(Edge::MAX)
}

/// Decisions and coordinates of the exact line.
///
/// With n1 and n2 the distances of P1 and P2 from an edge's line (each times the edge's length),
/// t = n1 / (n1 - n2).
pub(super) struct Exact<'a> {
    segment: Segment,
    window: &'a ConvexWindow,
    tally: &'a mut Tally,
}

/// The distances of both ends from an edge's line, times its length.
fn distances(segment: Segment, [a, b]: Segment) -> [Approx; 2] {
    segment.map(|p| edge_value(a, b, p))
}

/// The same without error.
fn exact_distances(segment: Segment, edge: Segment) -> [Dyadic; 2] {
    let [[ax, ay], [bx, by]] = edge.map(|p| p.map(Dyadic::from));
    segment.map(|p| {
        let [x, y] = p.map(Dyadic::from);
        &(&bx - &ax) * &(&y - &ay) - &(&by - &ay) * &(&x - &ax)
    })
}

impl<'a> Exact<'a> {
    pub(super) fn new(segment: Segment, window: &'a ConvexWindow, tally: &'a mut Tally) -> Self {
        Self { segment, window, tally }
    }

    fn edge(&self, edge: Edge) -> Segment {
        self.window.edges()[usize::from(edge)]
    }

    /// The sign of a number that is known nearly, or else exactly.
    fn sign(&mut self, nearly: Approx, exactly: impl FnOnce() -> Dyadic) -> Sign {
        self.tally.calls += 1;
        nearly.sign().unwrap_or_else(|| {
            self.tally.exact += 1;
            exactly().sign()
        })
    }

    /// On which side of an edge an end lies: positive is inside.
    fn side(&mut self, edge: Edge, end: End) -> Sign {
        let [a, b] = self.edge(edge);
        orient2d(a, b, self.segment[end as usize], self.tally)
    }

    /// The sign of n1 - n2: of -D.n.
    fn speed(&mut self, edge: Edge) -> Sign {
        let (segment, edge) = (self.segment, self.edge(edge));
        let [n1, n2] = distances(segment, edge);
        self.sign(n1 - n2, || {
            let [n1, n2] = exact_distances(segment, edge);
            n1 - n2
        })
    }
}

impl Form for Exact<'_> {
    fn given(&self) -> Segment {
        self.segment
    }

    fn edges(&self) -> Range<Edge> {
        edges(self.window)
    }

    fn course(&mut self, edge: Edge) -> Course {
        Course::outward(self.speed(edge))
    }

    fn outside(&mut self, edge: Edge) -> bool {
        self.side(edge, End::P1) == Sign::Negative
    }

    fn divide(&mut self, edge: Edge) -> f32 {
        let (segment, edge) = (self.segment, self.edge(edge));
        let [n1, n2] = distances(segment, edge);
        let exact = || {
            let [n1, n2] = exact_distances(segment, edge);
            let den = &n1 - &n2;
            (n1, den)
        };
        rounded_ratio(n1 / (n1 - n2), exact, self.tally)
    }

    fn order(&mut self, a: Parameter<Edge>, b: Parameter<Edge>) -> Sign {
        match (a, b) {
            (Parameter::Of(a), Parameter::Of(b)) => difference(a as u8, b as u8),
            // t and t - 1 are n1 and n2 over n1 - n2.
            (Parameter::At(edge), Parameter::Of(end)) => self.side(edge, end) * self.speed(edge),
            (Parameter::Of(_), Parameter::At(_)) => -self.order(b, a),
            (Parameter::At(a), Parameter::At(b)) => {
                let speeds = self.speed(a) * self.speed(b);
                let (segment, a, b) = (self.segment, self.edge(a), self.edge(b));
                let ([a1, a2], [b1, b2]) = (distances(segment, a), distances(segment, b));
                let sign = self.sign(b1 * a2 - a1 * b2, || {
                    let ([a1, a2], [b1, b2]) = (exact_distances(segment, a), exact_distances(segment, b));
                    b1 * a2 - a1 * b2
                });
                sign * speeds
            }
        }
    }

    /// `(n1 P2 - n2 P1) / (n1 - n2)`, each coordinate rounded once.
    fn cut(&mut self, edge: Edge) -> Point {
        let (segment, edge) = (self.segment, self.edge(edge));
        let [n1, n2] = distances(segment, edge);
        let point = [0, 1].map(|axis| {
            let ([a, b], [p, q]) = (edge.map(|p| p[axis]), segment.map(|p| p[axis]));
            if a == b {
                return a; // the edge is parallel to the other axis
            }
            if p == q {
                return p + 0.0;
            }
            let nearly = (n1 * Approx::from(q) - n2 * Approx::from(p)) / (n1 - n2);
            let exact = || {
                let ([n1, n2], [p, q]) = (exact_distances(segment, edge), [p, q].map(Dyadic::from));
                (&n1 * &q - &n2 * &p, n1 - n2)
            };
            rounded_ratio(nearly, exact, self.tally)
        });
        let corner = self.window.corners().iter().find(|corner| **corner == point);
        corner.copied().unwrap_or(point)
    }
}

/// D.n and w.n of an edge in the arithmetic `R`, and what they are computed from: n, D, w.
pub(super) fn measured<R: Real>(segment: Segment, edge: Segment) -> ([R; 2], [[R; 2]; 3]) {
    let [p1, p2] = segment.map(|p| p.map(R::from_f32));
    let [a, b] = edge.map(|p| p.map(R::from_f32));
    let normal = [a[1] - b[1], b[0] - a[0]];
    let direction = [p2[0] - p1[0], p2[1] - p1[1]];
    let to_p1 = [p1[0] - a[0], p1[1] - a[1]];
    let product = |u: [R; 2]| u[0] * normal[0] + u[1] * normal[1];
    ([product(direction), product(to_p1)], [normal, direction, to_p1])
}

/// As taught, in the rounded arithmetic `R`.
pub(super) struct Taught<'a, R> {
    segment: Segment,
    window: &'a ConvexWindow,
    /// D.n and w.n of the edge at hand.
    measured: [R; 2],
    /// The t of each edge, once divided.
    quotients: Vec<R>,
}

impl<'a, R: Real> Taught<'a, R> {
    pub(super) fn new(segment: Segment, window: &'a ConvexWindow) -> Self {
        let quotients = vec![R::ZERO; window.edges().len()];
        Self { segment, window, measured: [R::ZERO; 2], quotients }
    }

    fn quotient(&self, parameter: Parameter<Edge>) -> R {
        match parameter {
            Parameter::Of(End::P1) => R::ZERO,
            Parameter::Of(End::P2) => R::ONE,
            Parameter::At(edge) => self.quotients[usize::from(edge)],
        }
    }
}

impl<R: Real> Form for Taught<'_, R> {
    fn given(&self) -> Segment {
        self.segment
    }

    fn edges(&self) -> Range<Edge> {
        edges(self.window)
    }

    fn course(&mut self, edge: Edge) -> Course {
        (self.measured, _) = measured(self.segment, self.window.edges()[usize::from(edge)]);
        Course::outward(-difference(self.measured[0], R::ZERO))
    }

    fn outside(&mut self, _: Edge) -> bool {
        self.measured[1] < R::ZERO
    }

    fn divide(&mut self, edge: Edge) -> f32 {
        let [speed, distance] = self.measured;
        let t = -distance / speed;
        self.quotients[usize::from(edge)] = t;
        t.to_f32()
    }

    fn order(&mut self, a: Parameter<Edge>, b: Parameter<Edge>) -> Sign {
        difference(self.quotient(a), self.quotient(b))
    }

    fn cut(&mut self, edge: Edge) -> Point {
        point_at(self.segment, self.quotient(Parameter::At(edge)))
    }
}
