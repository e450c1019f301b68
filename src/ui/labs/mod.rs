//! The labs: one small file each, and the registry, the only list of them.
//!
//! A lab says what of the document can be dragged and chosen. Running, stepping, listing,
//! inspector and painting are the shell's, the same for all.

mod aabb;
mod area_ratios;
mod back_face;
mod backtracking;
mod blend;
mod bresenham;
mod bvh;
mod clip_line;
mod clip_plane;
mod clip_polygon;
mod clip_triangle;
mod cohen_sutherland;
mod corners;
mod cyrus_beck;
mod dda;
mod depth_precision;
mod diamond_exit;
mod draw_line;
mod edge_table;
mod fill_triangle;
mod fragment_state;
mod frustum_culling;
mod homogeneous;
mod interpolation;
mod liang_barsky;
mod light;
mod lighting;
mod midpoint;
mod msaa;
mod nicholl_lee_nicholl;
mod objects;
mod perspective_correction;
mod pipeline;
mod placing;
mod plane_equation;
mod point_clipping;
mod points;
mod scanline;
mod shading;
mod stencil;
mod stress;
mod sutherland_hodgman;
mod tiled;
mod transform;
mod weiler_atherton;
mod window;
mod z_buffer;
mod zigzag;

use crate::{
    document::{Document, ViewState},
    face::Face,
};
use egui::Ui;
use rasterscope_core::explain::{Marker, Role};
use rasterscope_figure::numbers;

/// A stage as the shell sees it.
pub(crate) trait Lab: std::fmt::Debug {
    /// Its name in the core's registry.
    fn name(&self) -> &'static str;

    /// Widgets that edit the document.
    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState);

    /// What can be dragged on the canvas, in the units of the drawing.
    fn handles(&self, document: &Document) -> Vec<Handle>;

    /// What the run did, for the ribbon: from the marks of its timeline.
    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome>;

    /// Moves a handle: the only way in which the canvas edits the document.
    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]);

    /// What can be dragged of a drawing in space.
    fn solid_handles(&self, _: &Document) -> Vec<SolidHandle> {
        Vec::new()
    }

    /// Moves a handle of a drawing in space.
    fn drag_solid(&self, _: &mut Document, _: usize, _: [f32; 3]) {}
}

/// A point of a drawing in space that can be dragged, in the plane through it that the picture shows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SolidHandle {
    /// Its accessible name.
    pub(crate) name: String,
    /// Where it is, in the space of the drawing.
    pub(crate) at: [f32; 3],
}

/// What a lab did, as its chip says it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Outcome {
    /// What came in, if that is not said by the chip before.
    pub(crate) came: Option<usize>,
    /// What went out.
    pub(crate) went: usize,
    /// The message that names what went out, where it is not clear.
    pub(crate) unit: Option<&'static str>,
    /// The input of a lab that draws nothing of the scene: how many, and the message that names them.
    pub(crate) given: (usize, &'static str),
}

impl Outcome {
    /// The count as the chip shows it.
    pub(crate) fn count(&self) -> String {
        let number = |n: usize| numbers::integer(i64::try_from(n).unwrap_or(i64::MAX));
        match self.came {
            Some(came) => format!("{} → {}", number(came), number(self.went)),
            None => number(self.went),
        }
    }
}

/// How many marks of the timeline have a role.
fn count(markers: &[(usize, Marker)], role: Role) -> usize {
    markers.iter().filter(|(_, marker)| marker.role == role).count()
}

/// How many plain marks the timeline has: one for each span.
fn count_plain(markers: &[(usize, Marker)]) -> usize {
    markers.iter().filter(|(_, marker)| marker.role == Role::Neutral && marker.label.is_none()).count()
}

/// What is open, to be edited.
#[derive(Debug)]
pub(crate) struct Open<'a> {
    pub(crate) lab: &'a dyn Lab,
    pub(crate) document: &'a mut Document,
    pub(crate) view: &'a mut ViewState,
}

/// A point of the drawing that can be dragged.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Handle {
    /// Its accessible name.
    pub(crate) name: String,
    /// Where it is.
    pub(crate) at: [f32; 2],
    /// What it does.
    pub(crate) kind: Kind,
}

/// What a handle moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A point.
    Point,
    /// A side that moves along x.
    SideX,
    /// A side that moves along y.
    SideY,
    /// A corner.
    Corner,
}

/// All labs, in pipeline order.
pub(crate) fn registry() -> Vec<Box<dyn Lab>> {
    vec![
        Box::new(pipeline::Pipeline),
        Box::new(transform::Transform),
        Box::new(back_face::BackFace),
        Box::new(frustum_culling::FrustumCulling),
        Box::new(bvh::Bvh),
        Box::new(point_clipping::PointClipping),
        Box::new(cohen_sutherland::LAB),
        Box::new(liang_barsky::LAB),
        Box::new(clip_plane::ClipPlane),
        Box::new(cyrus_beck::CyrusBeck),
        Box::new(midpoint::LAB),
        Box::new(nicholl_lee_nicholl::LAB),
        Box::new(clip_triangle::ClipTriangle),
        Box::new(sutherland_hodgman::LAB),
        Box::new(weiler_atherton::LAB),
        Box::new(scanline::LAB),
        Box::new(aabb::LAB),
        Box::new(backtracking::LAB),
        Box::new(zigzag::LAB),
        Box::new(tiled::LAB),
        Box::new(homogeneous::Homogeneous),
        Box::new(edge_table::EdgeTable),
        Box::new(dda::LAB),
        Box::new(bresenham::LAB),
        Box::new(diamond_exit::LAB),
        Box::new(points::Points),
        Box::new(stress::Stress),
        Box::new(stencil::Stencil),
        Box::new(msaa::Msaa),
        Box::new(area_ratios::LAB),
        Box::new(plane_equation::LAB),
        Box::new(perspective_correction::PerspectiveCorrection),
        Box::new(lighting::Lighting),
        Box::new(shading::Shading),
        Box::new(z_buffer::ZBuffer),
        Box::new(depth_precision::DepthPrecision),
        Box::new(blend::Blend),
    ]
}
