//! How the tree of boxes is built: top down, every node split across one axis.

use super::{Aabb, Event};
use crate::trace::{NoTrace, Tracer};
use serde::{Deserialize, Serialize};

/// Where a node is split.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Split {
    /// Half of the boxes to each side, across the axis along which their middles lie farthest apart.
    #[default]
    Median,
    /// Where the sum of surface times count is least: the surface area heuristic, all places tried.
    SurfaceArea,
}

impl Split {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Median, Self::SurfaceArea];

    /// The id of the words for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Median => "bvh-split-median",
            Self::SurfaceArea => "bvh-split-surface-area",
        }
    }
}

/// Most boxes in a leaf.
pub(super) const MOST_IN_LEAF: usize = 2;

/// A node of the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Node {
    /// The box around all boxes below it: exactly their union.
    pub bounds: Aabb,
    /// Its two children; `None` for a leaf.
    pub children: Option<[u32; 2]>,
    /// Which part of the order of the boxes lies below it: the first place, and how many.
    pub range: [u32; 2],
    /// How far below the root it is.
    pub depth: u32,
}

/// A tree of boxes; each box lies in exactly one leaf.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tree {
    nodes: Vec<Node>,
    order: Vec<u32>,
    boxes: Vec<Aabb>,
}

/// The union of boxes, exactly; of none: the empty box.
pub fn union(boxes: impl Iterator<Item = Aabb>) -> Aabb {
    boxes.fold([[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]], |[min, max], [low, high]| {
        let axes = [0, 1, 2];
        [axes.map(|i| min[i].min(low[i])), axes.map(|i| max[i].max(high[i]))]
    })
}

/// Twice the middle of a box along an axis, in binary64: nothing overflows.
fn middle([min, max]: Aabb, axis: usize) -> f64 {
    f64::from(min[axis]) + f64::from(max[axis])
}

/// Half the surface of a box; 0 for the empty one.
fn surface([min, max]: Aabb) -> f64 {
    let [x, y, z] = [0, 1, 2].map(|i| (f64::from(max[i]) - f64::from(min[i])).max(0.0));
    x * y + y * z + z * x
}

impl Tree {
    /// Builds a tree over boxes with finite corners, at most 2^31 of them; none give an empty tree.
    ///
    /// Equal boxes keep their order, so the tree is the same on every machine. n log² n comparisons.
    pub fn build(boxes: &[Aabb], split: Split) -> Self {
        Self::build_traced(boxes, split, &mut NoTrace)
    }

    /// [`build`](Self::build), with every decision reported.
    pub fn build_traced<T: Tracer<Event>>(boxes: &[Aabb], split: Split, t: &mut T) -> Self {
        let count = boxes.len() as u32;
        let mut tree = Self { nodes: Vec::new(), order: (0..count).collect(), boxes: boxes.to_vec() };
        if count == 0 {
            return tree;
        }
        tree.nodes.push(tree.node([0, count], 0));
        // Breadth first, so that the two children of a node stand side by side.
        let mut next = 0;
        while let Some(&node) = tree.nodes.get(next) {
            let index = next as u32;
            next += 1;
            let [first, len] = node.range;
            if len as usize <= MOST_IN_LEAF {
                t.emit(|| Event::Leaf { node: index });
                continue;
            }
            let (axis, left) = match split {
                Split::Median => tree.at_median(first, len),
                Split::SurfaceArea => tree.at_least_cost(first, len),
            };
            tree.sort(first, len, axis);
            let child = tree.nodes.len() as u32;
            for range in [[first, left], [first + left, len - left]] {
                tree.nodes.push(tree.node(range, node.depth + 1));
            }
            tree.nodes[index as usize].children = Some([child, child + 1]);
            t.emit(|| Event::Split { node: index, axis: axis as u8, first: child });
        }
        tree
    }

    fn node(&self, range: [u32; 2], depth: u32) -> Node {
        let bounds = union(self.order_of(range).iter().map(|&item| self.boxes[item as usize]));
        Node { bounds, children: None, range, depth }
    }

    fn order_of(&self, [first, len]: [u32; 2]) -> &[u32] {
        &self.order[first as usize..(first + len) as usize]
    }

    /// Sorts a part of the boxes by their middles; equal ones by their index.
    fn sort(&mut self, first: u32, len: u32, axis: usize) {
        let Self { order, boxes, .. } = self;
        order[first as usize..(first + len) as usize].sort_by(|&a, &b| {
            let key = |item: u32| middle(boxes[item as usize], axis);
            key(a).total_cmp(&key(b)).then(a.cmp(&b))
        });
    }

    /// The axis along which the middles lie farthest apart, and half of the boxes.
    fn at_median(&self, first: u32, len: u32) -> (usize, u32) {
        let extent = |axis: usize| {
            let middles =
                self.order_of([first, len]).iter().map(|&item| middle(self.boxes[item as usize], axis));
            let (low, high) =
                middles.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), m| (low.min(m), high.max(m)));
            high - low
        };
        // Of equal extents the first axis.
        let axis = (1..3).fold(0, |best, axis| if extent(axis) > extent(best) { axis } else { best });
        (axis, len / 2)
    }

    /// The axis and the place with the least sum of surface times count.
    fn at_least_cost(&mut self, first: u32, len: u32) -> (usize, u32) {
        let mut best = (f64::INFINITY, 0, len / 2);
        // Of equal costs the place nearest to the half: equal boxes must not make a list of the tree.
        let off = |left: u32| left.abs_diff(len - left);
        for axis in 0..3 {
            self.sort(first, len, axis);
            let boxes: Vec<Aabb> =
                self.order_of([first, len]).iter().map(|&item| self.boxes[item as usize]).collect();
            let mut suffix = union(std::iter::empty());
            let mut right = vec![0.0; boxes.len()];
            for (i, &bounds) in boxes.iter().enumerate().rev() {
                suffix = union([suffix, bounds].into_iter());
                right[i] = surface(suffix);
            }
            let mut prefix = union(std::iter::empty());
            for left in 1..boxes.len() {
                prefix = union([prefix, boxes[left - 1]].into_iter());
                let cost = surface(prefix) * left as f64 + right[left] * (boxes.len() - left) as f64;
                let left = left as u32;
                if cost < best.0 || cost == best.0 && off(left) < off(best.2) {
                    best = (cost, axis, left);
                }
            }
        }
        let (_, axis, left) = best;
        (axis, left)
    }

    /// The nodes, the root first; children stand behind their parent, side by side.
    pub fn nodes(&self) -> &[Node] {
        &self.nodes
    }

    /// The boxes as they were given.
    pub fn boxes(&self) -> &[Aabb] {
        &self.boxes
    }

    /// The boxes below a node.
    pub fn items(&self, node: &Node) -> &[u32] {
        self.order_of(node.range)
    }
}
