//! Which whole objects need not be looked at, found in one of three ways.

use super::draw::{DrawOutputs, Shared};
use crate::{
    clip::polygon::Plane,
    cull::{
        bvh::{self, Split, Tree},
        planes::{Frustum, PlaneMask},
    },
};

/// What stands for an object when it is tested against the frustum. All give the same image; a closer
/// body finds more objects outside.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Bounding {
    /// Its box in object space, turned with it: the closest of the three, kept with the mesh.
    #[default]
    Box,
    /// A small sphere in object space, kept with the mesh.
    Sphere,
    /// Its box in world space, in a tree of all of them: many objects by one test.
    Tree,
}

impl Bounding {
    /// All three, the default first.
    pub const ALL: [Self; 3] = [Self::Box, Self::Sphere, Self::Tree];

    /// The name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Sphere => "sphere",
            Self::Tree => "tree",
        }
    }

    /// For each draw a plane that all of it lies outside of, if one is found. Never wrong.
    pub(super) fn outside(self, draws: &[DrawOutputs], shared: &Shared<'_>) -> Vec<Option<Plane>> {
        let range = shared.scene.depth_range;
        if self == Self::Tree {
            let (indices, boxes): (Vec<_>, Vec<_>) =
                draws.iter().enumerate().filter_map(|(index, draw)| Some((index, draw.world_box()?))).unzip();
            let frustum = Frustum::before(&[&shared.view, &shared.projection], range);
            let found = bvh::cull(&Tree::build(&boxes, Split::Median), &frustum);
            let mut outside = vec![None; draws.len()];
            for (index, plane) in indices.into_iter().zip(found.outside) {
                outside[index] = plane;
            }
            return outside;
        }
        let of_one = |draw: &DrawOutputs| {
            let frustum = Frustum::before(&[draw.model(), &shared.view, &shared.projection], range);
            frustum.test(draw.body()?, PlaneMask::ALL, |_, _| {}).err()
        };
        draws.iter().map(of_one).collect()
    }
}
