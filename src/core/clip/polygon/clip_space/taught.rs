//! As taught: from the corners as they stand, in rounded arithmetic.
//!
//! *Source:* the plane test and the intersection `t = db / (db - da)`, `x = t a + (1 - t) b` as in
//! Foley et al., Computer Graphics: Principles and Practice, 2nd ed., section 3.14. Deviation: `a` is the
//! end inside, so that both triangles at an edge compute the same numbers; [`Order::Walk`] shows what
//! happens otherwise.

use super::{Form, Node, Outside, Region};
use crate::{
    clip::polygon::Plane,
    math::{Real, Sign},
};
use serde::Serialize;
use std::cmp::Ordering;

/// Which end of an edge is `a` in `x = t a + (1 - t) b`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Order {
    /// The end inside: both triangles at an edge do the same.
    #[default]
    InsideFirst,
    /// The end that the walk round the triangle comes to first: the neighbour walks the other way.
    Walk,
}

/// A corner with its numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Values<R> {
    pub(super) at: [R; 4],
    pub(super) attribute: R,
}

/// The form that runs in the rounded arithmetic `R`.
pub(super) struct Taught<R, B> {
    pub(super) vertices: [Values<R>; 3],
    pub(super) region: B,
    pub(super) order: Order,
}

impl<R: Real, B: Region> Taught<R, B> {
    pub(super) fn new(vertices: [[f32; 4]; 3], attribute: [f32; 3], region: B, order: Order) -> Self {
        let vertices = [0, 1, 2]
            .map(|i| Values { at: vertices[i].map(R::from_f32), attribute: R::from_f32(attribute[i]) });
        Self { vertices, region, order }
    }

    fn distance_of(&self, plane: Plane, node: &Node<Values<R>>) -> R {
        self.region.distance(plane, node.value.at)
    }

    /// t, and both ends in the order in which they are weighted.
    fn weighted<'n>(
        &self,
        plane: Plane,
        from: &'n Node<Values<R>>,
        to: &'n Node<Values<R>>,
    ) -> (R, [&'n Values<R>; 2]) {
        let (mut a, mut b) = (from, to);
        let (mut da, mut db) = (self.distance_of(plane, a), self.distance_of(plane, b));
        if self.order == Order::InsideFirst && db >= R::ZERO {
            (a, b, da, db) = (b, a, db, da);
        }
        (db / (db - da), [&a.value, &b.value])
    }
}

impl<R: Real, B: Region> Form for Taught<R, B> {
    type Value = Values<R>;

    fn vertex(&self, index: usize) -> Values<R> {
        self.vertices[index]
    }

    fn outside(&self, plane: Plane, nodes: &[Node<Values<R>>]) -> Outside {
        let outside = |node| self.distance_of(plane, node).partial_cmp(&R::ZERO).is_none_or(Ordering::is_lt);
        Outside::of_all(nodes.iter().map(outside))
    }

    fn side(&mut self, plane: Plane, node: &Node<Values<R>>) -> Sign {
        let distance = self.distance_of(plane, node);
        if distance > R::ZERO {
            Sign::Positive
        } else if distance == R::ZERO {
            Sign::Zero
        } else {
            Sign::Negative
        }
    }

    fn cross(&mut self, plane: Plane, from: &Node<Values<R>>, to: &Node<Values<R>>) -> Values<R> {
        let (t, [a, b]) = self.weighted(plane, from, to);
        let mix = |a: R, b: R| t * a + (R::ONE - t) * b;
        Values {
            at: [0, 1, 2, 3].map(|axis| mix(a.at[axis], b.at[axis])),
            attribute: mix(a.attribute, b.attribute),
        }
    }

    fn distance(&self, plane: Plane, node: &Node<Values<R>>) -> f64 {
        self.distance_of(plane, node).to_f64()
    }

    fn place(&self, node: &Node<Values<R>>) -> [f64; 4] {
        node.value.at.map(R::to_f64)
    }

    fn share(&self, plane: Plane, from: &Node<Values<R>>, to: &Node<Values<R>>) -> f64 {
        self.weighted(plane, from, to).0.to_f64()
    }
}
