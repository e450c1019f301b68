//! Marks in space: what a lab draws in three dimensions, and from where it is seen first.
//!
//! An algorithm says where things are in its own space. The camera outside belongs to the view: it is
//! turned without a new run, and is no part of the document. The figure crate looks through it and
//! lays out the marks of the plane that it sees.

use super::{Label, Role};

/// Geometry to draw, in a right-handed space of the algorithm's own units. What is not finite or lies
/// behind the camera is left out.
#[derive(Clone, Debug, PartialEq)]
pub enum Solid {
    /// A point; its marker is the role's.
    Point {
        /// Where.
        at: [f32; 3],
        /// What it means.
        role: Role,
        /// Plate beside it.
        label: Option<Label>,
    },
    /// A segment, dashed and coloured by its role.
    Segment {
        /// Both ends.
        ends: [[f32; 3]; 2],
        /// What it means.
        role: Role,
        /// Plate at its middle.
        label: Option<Label>,
    },
    /// A flat polygon; fills of those farther away lie under those nearer.
    Polygon {
        /// Corners in order.
        points: Vec<[f32; 3]>,
        /// What its outline means.
        role: Role,
        /// Index of the object whose fill it wears; `None`: the role's own fill.
        object: Option<usize>,
        /// Plate inside it.
        label: Option<Label>,
    },
    /// The edges of a box or a frustum.
    Body {
        /// Near, then far; each face in order
        /// ([`frustum_corners`](crate::transform::frustum::frustum_corners)).
        corners: [[f32; 3]; 8],
        /// What its edges mean.
        role: Role,
        /// Text at its highest corner.
        label: Option<Label>,
    },
    /// A sphere: its outline as the camera sees it, and its equator.
    Sphere {
        /// Its middle.
        center: [f32; 3],
        /// Its radius; not negative.
        radius: f32,
        /// What its outline means.
        role: Role,
        /// Text at its highest point.
        label: Option<Label>,
    },
    /// A free text, such as the name of a plane.
    Text {
        /// Where its top left corner is.
        at: [f32; 3],
        /// What is written.
        label: Label,
        /// What it means.
        role: Role,
    },
}

/// From where a drawing in space is seen first: all of `points` from one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Vantage {
    /// What must be visible.
    pub points: Vec<[f32; 3]>,
    /// Angle around the y axis in radians; 0: from the +z side, growing to +x.
    pub yaw: f32,
    /// Angle above the horizon in radians, less than a right one.
    pub pitch: f32,
    /// The names of the axes.
    pub axes: [&'static str; 3],
}

/// The corners of a box with sides along the axes, in the order of [`Solid::Body`].
pub fn box_corners(min: [f32; 3], max: [f32; 3]) -> [[f32; 3]; 8] {
    [0, 1, 2, 3, 4, 5, 6, 7].map(|i| {
        let right = matches!(i % 4, 1 | 2);
        let up = matches!(i % 4, 2 | 3);
        // The near side is the one with the larger z.
        [
            if right { max[0] } else { min[0] },
            if up { max[1] } else { min[1] },
            if i < 4 { max[2] } else { min[2] },
        ]
    })
}
