//! The stages before scan conversion: what each computes, from values to values.

use super::{Skip, Skips, lit::Varyings, visible::Visible};
use crate::{
    clip::polygon::Plane,
    cull::{CullMode, Facing, FrontFace, facing},
    math::Tally,
    scene::{Draw, Mesh},
    transform::DepthRange,
};

/// A point of a homogeneous space.
pub type Point = [f32; 4];

/// What culling decided about a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decision {
    /// How it stands to the eye; `None` if the frustum decided before.
    pub facing: Option<Facing>,
    /// A plane that it lies wholly outside of, if that was looked for.
    pub outside: Option<Plane>,
    /// Whether it lies inside all planes, if that was looked for: then nothing clips it.
    pub inside: bool,
    /// What becomes of it.
    pub fate: Fate,
}

/// What becomes of a triangle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It goes on and is drawn.
    Drawn,
    /// It is not drawn, but the skip that drops it here is off: its fragments are dropped.
    Carried,
    /// It ends here.
    Dropped,
}

/// The draw's state that decides about its triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CullKey {
    pub(super) mode: CullMode,
    pub(super) front: FrontFace,
    pub(super) visible: Visible,
    pub(super) frustum: bool,
    pub(super) back_face: bool,
    pub(super) degenerate: bool,
}

impl CullKey {
    pub(super) fn new(draw: &Draw, range: DepthRange, skips: Skips) -> Self {
        Self {
            mode: draw.cull,
            front: draw.front,
            visible: Visible { range, unclipped: draw.placement.unclipped },
            frustum: skips.has(Skip::Frustum),
            back_face: skips.has(Skip::BackFace),
            degenerate: skips.has(Skip::Degenerate),
        }
    }

    /// Decides about one triangle in clip space, by its unclipped vertices and their outcodes.
    fn decide(&self, clip: [Point; 3], outcodes: [u8; 3], tally: &mut Tally) -> Decision {
        let [a, b, c] = outcodes;
        let outside = Plane::ALL.get((a & b & c).trailing_zeros() as usize).copied();
        let inside = self.frustum && a | b | c == 0;
        if outside.is_some() {
            return Decision { facing: None, outside, inside, fate: Fate::Dropped };
        }
        let facing = facing(clip, self.front, tally);
        let skip = if facing == Facing::Degenerate { self.degenerate } else { self.back_face };
        let fate = match (self.mode.drops(facing), skip) {
            (false, _) => Fate::Drawn,
            (true, true) => Fate::Dropped,
            (true, false) => Fate::Carried,
        };
        Decision { facing: Some(facing), outside, inside, fate }
    }
}

/// The decisions about all triangles of a draw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Culled {
    /// One for each triangle.
    pub decisions: Vec<Decision>,
    /// Signs asked for.
    pub tally: Tally,
}

pub(super) fn cull(key: &CullKey, clip: &[Point], mesh: &Mesh) -> Culled {
    let mut tally = Tally::default();
    let corners = |triangle: &[u32; 3]| triangle.map(|i| clip[i as usize]);
    // No vertex was transformed if the whole object is outside.
    let triangles = if clip.is_empty() { &[] } else { &mesh.triangles[..] };
    let outcodes: Vec<u8> =
        clip.iter().map(|&point| if key.frustum { key.visible.outcode(point) } else { 0 }).collect();
    let outside = |triangle: &[u32; 3]| triangle.map(|i| outcodes[i as usize]);
    let decide = |triangle| key.decide(corners(triangle), outside(triangle), &mut tally);
    let decisions = triangles.iter().map(decide).collect();
    Culled { decisions, tally }
}

/// What clipping left of one triangle: a convex polygon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ClippedPolygon {
    /// Which triangle of the mesh.
    pub triangle: u32,
    /// The first of its corners.
    pub first: u32,
    /// How many corners it has.
    pub len: u32,
    /// Whether a plane cut it.
    pub cut: bool,
    /// Whether its fragments are dropped.
    pub carried: bool,
}

/// A triangle of the fan of a clipped polygon: what is scan converted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its corners.
    pub corners: [u32; 3],
    /// Which triangle of the mesh.
    pub triangle: u32,
    /// Which part of it, from 0.
    pub part: u32,
    /// Whether its fragments are dropped.
    pub carried: bool,
}

/// The clipped triangles of a draw.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clipped {
    /// Those of which something is left.
    pub polygons: Vec<ClippedPolygon>,
    /// Their fans.
    pub pieces: Vec<Piece>,
    /// The polygons' corners in clip space, one polygon after the other.
    pub corners: Vec<Point>,
    /// The colour at each corner.
    pub colors: Vec<[f32; 4]>,
    /// The texture coordinates at each corner, or none at all.
    pub uvs: Vec<[f32; 2]>,
    /// The normal in world space at each corner, not of length 1, if pixels are lit.
    pub normals: Vec<[f32; 3]>,
    /// The place in world space of each corner, if pixels are lit.
    pub places: Vec<[f32; 3]>,
    /// Triangles of which nothing was left.
    pub lost: usize,
    /// Signs and roundings asked for.
    pub tally: Tally,
}

pub(super) fn clip(culled: &Culled, clip: &[Point], varyings: &Varyings<'_>, visible: Visible) -> Clipped {
    let mut out = Clipped::default();
    for (index, decision) in (0..).zip(&culled.decisions) {
        if decision.fate == Fate::Dropped {
            continue;
        }
        let carried = decision.fate == Fate::Carried;
        if decision.inside && !carried {
            out.push_whole(index, clip, varyings);
        } else if !out.push(index, carried, clip, varyings, visible) {
            out.lost += 1;
        }
    }
    out
}

impl Clipped {
    /// Takes a triangle that lies inside all planes and has an area.
    fn push_whole(&mut self, triangle: u32, clip: &[Point], varyings: &Varyings<'_>) {
        let indices = varyings.triangles[triangle as usize].map(|i| i as usize);
        let first = self.corners.len() as u32;
        self.corners.extend(indices.map(|i| clip[i]));
        self.take_whole(indices, varyings);
        self.polygons.push(ClippedPolygon { triangle, first, len: 3, cut: false, carried: false });
        let corners = [first, first + 1, first + 2];
        self.pieces.push(Piece { corners, triangle, part: 0, carried: false });
    }

    /// Takes the attributes of a triangle's own corners.
    fn take_whole(&mut self, corners: [usize; 3], varyings: &Varyings<'_>) {
        self.colors.extend(corners.map(|i| varyings.colors[i]));
        self.uvs.extend(of_corners(varyings.uvs, corners).into_iter().flatten());
        self.normals.extend(of_corners(varyings.normals, corners).into_iter().flatten());
        self.places.extend(of_corners(varyings.places, corners).into_iter().flatten());
    }

    /// Clips one triangle; `false` if nothing is left of it.
    pub(super) fn push(
        &mut self,
        triangle: u32,
        carried: bool,
        clip: &[Point],
        varyings: &Varyings<'_>,
        visible: Visible,
    ) -> bool {
        let indices = varyings.triangles[triangle as usize].map(|i| i as usize);
        let polygon = visible.clip(indices.map(|i| clip[i]), &mut self.tally);
        let corners = polygon.corners();
        // Where w rounds to zero there is no place on the screen: the eye's own point.
        if corners.is_empty() || corners.iter().any(|corner| corner.position[3] == 0.0) {
            return false;
        }
        let first = self.corners.len() as u32;
        self.corners.extend(corners.iter().map(|corner| corner.position));
        if polygon.is_whole() {
            self.take_whole(indices, varyings);
        } else {
            let colors = indices.map(|i| varyings.colors[i]);
            let uvs = of_corners(varyings.uvs, indices);
            let normals = of_corners(varyings.normals, indices);
            let places = of_corners(varyings.places, indices);
            for corner in corners {
                let mut attribute = |values| polygon.attribute(corner, values, &mut self.tally);
                self.colors.push([0, 1, 2, 3].map(|channel| attribute(colors.map(|color| color[channel]))));
                self.uvs.extend(uvs.map(|uvs| [0, 1].map(|axis| attribute(uvs.map(|uv| uv[axis])))));
                let mut vector = |vectors: [[f32; 3]; 3]| {
                    [0, 1, 2].map(|axis| attribute(vectors.map(|vector| vector[axis])))
                };
                self.normals.extend(normals.map(&mut vector));
                self.places.extend(places.map(&mut vector));
            }
        }
        let (len, cut) = (corners.len() as u32, !polygon.is_whole());
        self.polygons.push(ClippedPolygon { triangle, first, len, cut, carried });
        self.pieces.extend((0..).zip(polygon.fan()).map(|(part, fan)| {
            let corners = fan.map(|i| first + i as u32);
            Piece { corners, triangle, part, carried }
        }));
        true
    }
}

/// An attribute at the corners of a triangle, if there is one.
fn of_corners<const N: usize>(values: &[[f32; N]], corners: [usize; 3]) -> Option<[[f32; N]; 3]> {
    (!values.is_empty()).then(|| corners.map(|i| values[i]))
}
