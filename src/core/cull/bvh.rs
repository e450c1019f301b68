//! A tree of boxes: what lies outside the frustum is rejected, what lies inside accepted, whole subtrees at
//! a time.
//!
//! *Source:* Clark, Hierarchical Geometric Models for Visible Surface Algorithms, 1976; Kay and Kajiya,
//! Ray Tracing Complex Scenes, 1986 (splitting at the median); Goldsmith and Salmon, Automatic Creation
//! of Object Hierarchies, 1987, and MacDonald and Booth, Heuristics for Ray Tracing using Space Subdivision,
//! 1990 (the surface area heuristic); Assarsson and Möller, Optimized View Frustum Culling Algorithms, 2000
//! (plane masks). Deviation: boxes are unions of binary32 boxes, without any rounding.

mod build;
mod explain;
mod nodes;
mod picture;

pub use build::{Node, Split, Tree, union};
pub use explain::{Input, Snapshot};

use super::planes::{Frustum, PlaneMask, Side, Volume};
use crate::{
    clip::polygon::Plane,
    replay::{Budget, Player},
    trace::{NoTrace, Tracer},
};
use serde::Serialize;

/// The smallest and the largest corner of a box with sides along the axes.
pub type Aabb = [[f32; 3]; 2];

/// What the run did. At most 16 bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Event {
    /// A node was split in two at its build.
    Split {
        /// The node; its children are the next two.
        node: u32,
        /// Across which axis: 0 to 2.
        axis: u8,
        /// The first child.
        first: u32,
    },
    /// A node became a leaf at its build.
    Leaf {
        /// The node.
        node: u32,
    },
    /// The traversal came to a node.
    Visit {
        /// The node.
        node: u32,
        /// The planes that its parent crosses.
        mask: PlaneMask,
    },
    /// A node's box was tested against a plane.
    Plane {
        /// The node.
        node: u32,
        /// The plane.
        plane: Plane,
        /// On which side it lies.
        side: Side,
    },
    /// The node lies outside a plane: nothing below it is looked at.
    Reject {
        /// The node.
        node: u32,
        /// The plane.
        plane: Plane,
    },
    /// The node lies inside all planes: nothing below it is tested.
    Accept {
        /// The node.
        node: u32,
    },
    /// The node crosses a plane: its children are next.
    Descend {
        /// The node.
        node: u32,
    },
    /// A box of a leaf was tested against a plane.
    ItemPlane {
        /// The box.
        item: u32,
        /// The plane.
        plane: Plane,
        /// On which side it lies.
        side: Side,
    },
    /// It is known whether a box of a leaf is outside.
    Item {
        /// The box.
        item: u32,
        /// A plane that it lies outside of.
        outside: Option<Plane>,
    },
    /// Nothing is left on the stack.
    Done,
}
const _: () = assert!(size_of::<Event>() <= 16);

/// What the traversal found, and what that cost.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Found {
    /// For each box a plane that it lies wholly outside of; `None` if none is certain.
    pub outside: Vec<Option<Plane>>,
    /// The cost.
    pub counts: Counts,
}

/// What a traversal did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Nodes that were looked at.
    pub visited: u32,
    /// Tests of a box, of a node or in a leaf, against one plane.
    pub tests: u32,
    /// Subtrees rejected whole.
    pub rejected: u32,
    /// Subtrees accepted whole.
    pub accepted: u32,
    /// Boxes tested in leaves.
    pub items: u32,
}

/// Finds the boxes that lie wholly outside one plane of the frustum.
///
/// All in one space, in which `frustum` was made. Never calls a box outside that holds something visible;
/// like any test plane by plane it keeps some boxes beside the frustum. About 5 ns a plane tested.
pub fn cull(tree: &Tree, frustum: &Frustum) -> Found {
    cull_traced(tree, frustum, &mut NoTrace)
}

/// Builds a tree and culls with it, as a run that can be scrubbed.
pub fn play(input: Input, budget: Budget) -> Player<Snapshot> {
    let (boxes, split, frustum) = (input.boxes.clone(), input.split, input.frustum);
    Player::new(Snapshot::new(input), budget, move |t| {
        let tree = Tree::build_traced(&boxes, split, t);
        cull_traced(&tree, &frustum, t);
    })
}

/// The traversal: [`cull`] and [`play`] are this with two tracers.
pub fn cull_traced<T: Tracer<Event>>(tree: &Tree, frustum: &Frustum, t: &mut T) -> Found {
    let mut outside = vec![None; tree.boxes().len()];
    let mut counts = Counts::default();
    let mut stack = Vec::with_capacity(32);
    stack.extend((!tree.nodes().is_empty()).then_some((0, PlaneMask::ALL)));
    while let Some((index, mask)) = stack.pop() {
        let node = &tree.nodes()[index as usize];
        t.emit(|| Event::Visit { node: index, mask });
        counts.visited += 1;
        let side = frustum.test(&Volume::Box(node.bounds), mask, |plane, side| {
            counts.tests += 1;
            t.emit(|| Event::Plane { node: index, plane, side });
        });
        match (side, node.children) {
            (Err(plane), _) => {
                t.emit(|| Event::Reject { node: index, plane });
                counts.rejected += 1;
                tree.items(node).iter().for_each(|&item| outside[item as usize] = Some(plane));
            }
            (Ok(PlaneMask::NONE), _) => {
                t.emit(|| Event::Accept { node: index });
                counts.accepted += 1;
            }
            (Ok(crossed), Some([left, right])) => {
                t.emit(|| Event::Descend { node: index });
                stack.extend([(right, crossed), (left, crossed)]);
            }
            (Ok(crossed), None) => {
                for &item in tree.items(node) {
                    let bounds = tree.boxes()[item as usize];
                    let side = frustum.test(&Volume::Box(bounds), crossed, |plane, side| {
                        counts.tests += 1;
                        t.emit(|| Event::ItemPlane { item, plane, side });
                    });
                    counts.items += 1;
                    outside[item as usize] = side.err();
                    t.emit(|| Event::Item { item, outside: side.err() });
                }
            }
        }
    }
    t.emit(|| Event::Done);
    Found { outside, counts }
}

/// How many plane tests it takes without a tree: each box until one plane rejects it.
pub fn tests_without_tree(boxes: &[Aabb], frustum: &Frustum) -> u32 {
    let mut tests = 0;
    for &bounds in boxes {
        let _ = frustum.test(&Volume::Box(bounds), PlaneMask::ALL, |_, _| tests += 1);
    }
    tests
}
