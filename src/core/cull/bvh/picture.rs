//! The boxes in space, seen from outside, under the tree that they make.

use super::{
    Aabb, Event, Snapshot,
    nodes::{Fate, node_name},
};
use crate::explain::{Label, Mark, Role, Solid, Vantage, box_corners};

/// The tree stands in the upper part of the picture: its highest and lowest row, and its half width.
const TREE: [f32; 3] = [0.95, 0.5, 0.98];

/// More levels than this are not drawn: their nodes would touch.
const MOST_LEVELS: u32 = 7;

/// Of more boxes only the middles are drawn, and of more nodes no mark for one that was gone through.
const MOST_BODIES: usize = 40;

fn middle([min, max]: Aabb) -> [f32; 3] {
    [0, 1, 2].map(|i| min[i] / 2.0 + max[i] / 2.0)
}

/// Sees the frustum and all boxes, below the tree.
pub(super) fn vantage(of: &Snapshot) -> Vantage {
    let mut points: Vec<[f32; 3]> = of.input.corners.into_iter().flatten().collect();
    if let Some(root) = of.tree.nodes().first() {
        points.extend(box_corners(root.bounds[0], root.bounds[1]));
    }
    let [low, high] = super::build::union(points.iter().map(|&point| [point, point]));
    // Room for the tree.
    let above = high[1] + (high[1] - low[1]).max(0.5 * (high[0] - low[0])) * 0.7;
    if above.is_finite() {
        points.push([low[0] / 2.0 + high[0] / 2.0, above, low[2] / 2.0 + high[2] / 2.0]);
    }
    Vantage { points, yaw: 0.7, pitch: 0.45, axes: ["x", "y", "z"] }
}

pub(super) fn marks(of: &Snapshot, event: Option<&Event>, out: &mut Vec<Mark>) {
    if let Some(corners) = of.input.corners {
        out.push(Mark::Space(Solid::Body { corners, role: Role::Neutral, label: None }));
    }
    boxes(of, out);
    nodes(of, out);
    tree(of, event, out);
}

/// Every object's box, or its middle where there are many.
fn boxes(of: &Snapshot, out: &mut Vec<Mark>) {
    let few = of.input.boxes.len() <= MOST_BODIES;
    for (index, (&bounds, known)) in of.input.boxes.iter().zip(&of.known).enumerate() {
        let now = of.item == Some(index as u32);
        let role = match known {
            _ if now => Role::Active,
            None => Role::Candidate,
            Some(None) => Role::Accepted,
            Some(Some(_)) => Role::Rejected,
        };
        let label = now.then(|| Label::name(of.input.names[index].clone()));
        if let (Some(&triangle), false) = (of.input.triangles.get(index), now) {
            let points = triangle.to_vec();
            out.push(Mark::Space(Solid::Polygon { points, role, object: None, label }));
        } else if few || now {
            let corners = box_corners(bounds[0], bounds[1]);
            out.push(Mark::Space(Solid::Body { corners, role, label }));
        } else {
            out.push(Mark::Space(Solid::Point { at: middle(bounds), role, label }));
        }
    }
}

/// The boxes of the nodes that were decided, and of the one of this step.
fn nodes(of: &Snapshot, out: &mut Vec<Mark>) {
    let body = |node: u32, role| {
        let [min, max] = of.tree.nodes()[node as usize].bounds;
        let label = (role == Role::Active).then(|| Label::name(node_name(node)));
        Mark::Space(Solid::Body { corners: box_corners(min, max), role, label })
    };
    for (node, fate) in (0..).zip(&of.fates) {
        if let (Fate::Rejected(_) | Fate::Accepted, Some(role)) = (fate, fate.role()) {
            out.push(body(node, role));
        }
    }
    let Some(now) = of.now else { return };
    let traversing = of.fates.first().is_some_and(|root| *root != Fate::Unseen);
    let children = of.tree.nodes()[now as usize].children.into_iter().flatten();
    out.extend(
        children
            .filter(|child| !traversing && (*child as usize) < of.built)
            .map(|child| body(child, Role::Candidate)),
    );
    if of.item.is_none() {
        out.push(body(now, Role::Active));
    }
}

/// The tree, as far as it is built.
fn tree(of: &Snapshot, event: Option<&Event>, out: &mut Vec<Mark>) {
    let nodes = of.tree.nodes();
    let levels = nodes.iter().map(|node| node.depth).max().unwrap_or_default().clamp(1, MOST_LEVELS);
    let count = of.input.boxes.len().max(1) as f32;
    let [top, bottom, half] = TREE;
    let place = |node: u32| {
        let node = &nodes[node as usize];
        let [first, len] = node.range.map(|n| n as f32);
        let across = (first + len / 2.0) / count;
        [half * (2.0 * across - 1.0), top - (top - bottom) * node.depth as f32 / levels as f32]
    };
    let shown = |node: u32| (node as usize) < of.built && nodes[node as usize].depth <= levels;
    for (index, node) in (0..).zip(nodes).filter(|(index, _)| shown(*index)) {
        for child in node.children.into_iter().flatten().filter(|&child| shown(child)) {
            let seen = of.fates[child as usize] != Fate::Unseen;
            let role = if seen { Role::Neutral } else { Role::Skipped };
            out.push(Mark::Segment { ends: [place(index), place(child)], role, label: None });
        }
    }
    for index in (0..of.built as u32).filter(|&index| shown(index)) {
        let fate = of.fates[index as usize];
        let now = event.is_some() && of.now == Some(index);
        let role = if now { Some(Role::Active) } else { fate.role() };
        let marked = now || fate != Fate::Crossed || nodes.len() <= MOST_BODIES;
        if let (Some(role), true) = (role, marked) {
            let label = now.then(|| Label::name(node_name(index)));
            out.push(Mark::Point { at: place(index), role, label });
        }
    }
}
