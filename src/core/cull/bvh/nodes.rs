//! What is known of the nodes of a tree, and the path to the one of a step.

use super::{Node, Snapshot};
use crate::{
    clip::polygon::Plane,
    cull::planes::PlaneMask,
    explain::{Role, Row, Table},
    message::Value,
};

/// What is known of a node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Fate {
    /// It was not looked at.
    #[default]
    Unseen,
    /// It is being tested.
    Visited,
    /// Outside this plane.
    Rejected(Plane),
    /// Inside all planes.
    Accepted,
    /// What is below it is looked at.
    Crossed,
}

/// The name of a node.
pub(super) fn node_name(node: u32) -> String {
    format!("#{node}")
}

fn bits(mask: PlaneMask) -> Value {
    // Left to right as the planes are tested.
    let bits = Plane::ALL.into_iter().fold(0, |bits, plane| bits << 1 | u32::from(mask.has(plane)));
    Value::Bits { bits, width: 6 }
}

impl Snapshot {
    /// From the root to the node of this step, and its children.
    pub(super) fn path(&self) -> Table {
        let mut nodes: Vec<u32> = self.now.into_iter().collect();
        while let Some(parent) = nodes.last().and_then(|&node| self.parent(node)) {
            nodes.push(parent);
        }
        nodes.reverse();
        if let Some(children) = self.now.and_then(|node| self.tree.nodes()[node as usize].children) {
            nodes.extend(children.into_iter().filter(|&child| (child as usize) < self.built));
        }
        let rows = nodes.into_iter().map(|node| {
            let fate = self.fates[node as usize];
            let now = self.now == Some(node);
            let mask = if now && fate != Fate::Unseen { bits(self.mask) } else { Value::BLANK };
            let cells = vec![self.below(node).into(), mask, fate.word()];
            Row::new(node_name(node), cells).active(now).role(fate.role())
        });
        Table {
            title: "bvh-path",
            columns: vec!["column-bvh-boxes", "L R B T N F", "column-bvh-fate"],
            rows: rows.collect(),
        }
    }

    fn parent(&self, node: u32) -> Option<u32> {
        let is_parent = |of: &Node| of.children.is_some_and(|children| children.contains(&node));
        self.tree.nodes().iter().position(is_parent).map(|at| at as u32)
    }
}

impl Fate {
    fn word(self) -> Value {
        match self {
            Self::Unseen => Value::BLANK,
            Self::Visited => Value::Word("bvh-fate-visited"),
            Self::Rejected(plane) => Value::Word(plane.word()),
            Self::Accepted => Value::Word("bvh-fate-accepted"),
            Self::Crossed => Value::Word("bvh-fate-crossed"),
        }
    }

    /// What the node means in the picture.
    pub(super) fn role(self) -> Option<Role> {
        match self {
            Self::Unseen | Self::Visited => None,
            Self::Rejected(_) => Some(Role::Rejected),
            Self::Accepted => Some(Role::Accepted),
            Self::Crossed => Some(Role::Neutral),
        }
    }
}
