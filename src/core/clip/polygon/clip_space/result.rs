//! What is left of a triangle: a convex polygon, and the triangles that it is made of.

use super::{ClipSpace, Corner, Event, MOST_CORNERS, Node, Nodes, Origin, Region, exact::Triangle};
use crate::{math::Tally, trace::Tracer};

/// A clipped triangle: a convex polygon that turns like the triangle. It fulfils the planes'
/// inequalities exactly and no corner occurs twice; it has no corner or at least three.
#[derive(Clone, Debug)]
pub struct Polygon<R = ClipSpace> {
    corners: [Corner; MOST_CORNERS],
    len: usize,
    triangle: Triangle<R>,
}

impl<R: Region> Polygon<R> {
    /// Rounds the corners. Two that become the same are one, and what has no third corner is empty.
    #[inline(never)]
    pub(super) fn new<T: Tracer<Event>>(
        triangle: Triangle<R>,
        nodes: &Nodes<()>,
        tally: &mut Tally,
        t: &mut T,
    ) -> Self {
        let nothing = Corner { position: [0.0; 4], origin: Origin::Vertex(0) };
        let mut polygon = Self { corners: [nothing; MOST_CORNERS], len: 0, triangle };
        for &Node { origin, .. } in nodes.all() {
            let position = triangle.place(origin, tally);
            t.emit(|| Event::Round { corner: polygon.len as u8, at: position });
            polygon.corners[polygon.len] = Corner { position, origin };
            polygon.len += 1;
        }
        if !polygon.is_whole() {
            polygon.merge(t);
        }
        polygon
    }

    /// Removes corners that rounding has put on the corner before them.
    fn merge<T: Tracer<Event>>(&mut self, t: &mut T) {
        let all = self.corners;
        let len = self.len;
        self.len = 0;
        for i in 0..len {
            if all[i].position != all[(i + len - 1) % len].position {
                self.corners[self.len] = all[i];
                self.len += 1;
            } else {
                t.emit(|| Event::Merge { corner: i as u8 });
            }
        }
        if self.len < 3 {
            self.len = 0;
        }
    }

    /// The corners in order.
    pub fn corners(&self) -> &[Corner] {
        &self.corners[..self.len]
    }

    /// Whether the triangle came through as it was.
    pub fn is_whole(&self) -> bool {
        self.len == 3 && self.corners().iter().all(|corner| matches!(corner.origin, Origin::Vertex(_)))
    }

    /// An attribute at a corner, from its values at the triangle's vertices: the correctly rounded value of
    /// the affine function on the unclipped triangle; at a vertex its value bit for bit.
    pub fn attribute(&self, corner: &Corner, values: [f32; 3], tally: &mut Tally) -> f32 {
        self.triangle.interpolate(corner.origin, values, tally)
    }

    /// Triangles that make up the polygon, as indices of corners, turning like it.
    ///
    /// All share the corner with the largest y (then x, z, w), wherever the polygon starts, so that the
    /// order of the vertices does not show in the triangles. Three corners are left in their order.
    pub fn fan(&self) -> impl Iterator<Item = [usize; 3]> {
        fan(self.corners())
    }
}

/// [`Polygon::fan`] of corners that lie in a list.
pub fn fan(corners: &[Corner]) -> impl Iterator<Item = [usize; 3]> {
    let len = corners.len();
    let highest = (0..len).max_by(|&i, &j| {
        let [a, b] = [i, j].map(|i| corners[i].position);
        let by = |axis: usize| a[axis].total_cmp(&b[axis]);
        by(1).then(by(0)).then(by(2)).then(by(3))
    });
    let apex = if len == 3 { 0 } else { highest.unwrap_or(0) };
    (2..len).map(move |i| [apex, (apex + i - 1) % len, (apex + i) % len])
}
