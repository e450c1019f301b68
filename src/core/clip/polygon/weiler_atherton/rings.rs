//! Which rings are holes, and of which piece.

use super::{
    super::outline::{Carrier, Corner, Given},
    Piece, Ring,
};
use crate::{
    clip::line::Point,
    math::{Sign, Tally, orient2d},
};
use std::cmp::Ordering;

impl Given<'_> {
    /// Whether a contour that lies inside the window surrounds what is outside of the polygon: whether an
    /// odd number of other contours is around it.
    ///
    /// Asked at its first corner that is on no other contour. Contours that cross each other have no
    /// clear answer; the even-odd rule over all rings gives the same set either way.
    pub(super) fn is_hole(&self, contour: usize, tally: &mut Tally) -> bool {
        let corners = self.contour(contour);
        let own = corners.clone();
        let mut odd = corners.filter_map(|corner| {
            let others = (0..self.points.len() as u32).filter(|edge| !own.contains(edge));
            let mut inside = false;
            for edge in others {
                let ends = self.edge(edge);
                let point = self.points[corner as usize];
                let above = ends.map(|end| end[1] > point[1]);
                let side = orient2d(ends[0], ends[1], point, tally);
                if side.is_zero() && is_between(ends, point) {
                    return None;
                }
                inside ^= above[0] != above[1] && (side == Sign::Positive) == above[1];
            }
            Some(inside)
        });
        odd.next().unwrap_or_default()
    }

    /// Whether a ring surrounds a given point that is not on it, by the even-odd rule: along a ray from
    /// the point to the right.
    fn surrounds(&self, ring: &[Corner], point: Point, tally: &mut Tally) -> bool {
        let mut inside = false;
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            let above = [a, b].map(|corner| self.compare(corner, 1, point[1], tally) == Ordering::Greater);
            if above[0] == above[1] {
                continue;
            }
            inside ^= match a.next {
                Carrier::Border(border) => border.is_upper(),
                Carrier::Edge(edge) => {
                    let [p, q] = self.edge(edge);
                    let rises = p[1] < q[1];
                    (orient2d(p, q, point, tally) == Sign::Positive) == rises
                }
            };
        }
        inside
    }

    /// Gives each hole to the innermost outer ring around it; `given` hears of both, as indices of rings.
    pub(super) fn pieces(
        &self,
        rings: Vec<(Ring, bool)>,
        tally: &mut Tally,
        mut given: impl FnMut(usize, usize),
    ) -> Vec<Piece> {
        let outers: Vec<usize> = (0..rings.len()).filter(|&i| !rings[i].1).collect();
        let mut owners = vec![None; rings.len()];
        for (i, (ring, hole)) in rings.iter().enumerate() {
            if !hole {
                continue;
            }
            let around = |point: Point, tally: &mut Tally| {
                let outers = outers.iter().copied();
                outers.filter(|&outer| self.surrounds(&rings[outer].0, point, tally)).collect::<Vec<_>>()
            };
            // Of the rings around it, the innermost is within all others.
            let candidates = around(ring[0].at, tally);
            owners[i] = candidates.iter().copied().max_by_key(|&inner| {
                let around_it = around(rings[inner].0[0].at, tally);
                candidates.iter().filter(|&&other| other != inner && around_it.contains(&other)).count()
            });
            owners[i].into_iter().for_each(|outer| given(i, outer));
        }
        let mut pieces: Vec<(usize, Piece)> = Vec::new();
        let mut holes = Vec::new();
        for (i, (ring, _)) in rings.into_iter().enumerate() {
            match owners[i] {
                Some(owner) => holes.push((owner, ring)),
                None => pieces.push((i, Piece { outer: ring, holes: Vec::new() })),
            }
        }
        for (owner, ring) in holes {
            if let Some((_, piece)) = pieces.iter_mut().find(|(i, _)| *i == owner) {
                piece.holes.push(ring);
            }
        }
        pieces.into_iter().map(|(_, piece)| piece).collect()
    }
}

/// Whether a point on the line through both ends lies between them.
fn is_between([p, q]: [Point; 2], point: Point) -> bool {
    (0..2).all(|axis| p[axis].min(q[axis]) <= point[axis] && point[axis] <= p[axis].max(q[axis]))
}
