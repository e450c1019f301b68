//! What a shading run has done so far.

use super::{Event, Image, Input, Object, Shown, Subject, surface, world_corners};
use crate::{
    pipeline::{DrawOutputs, Piece},
    replay::State,
    scene::Shade,
    shade::{Surface, illumination::centroid, lighting, normals::face_normal},
};
use std::sync::Arc;

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) subject: Arc<Subject>,
    pub(super) image: Image,
    pub(super) object: usize,
    /// The vertex in hand.
    pub(super) vertex: Option<usize>,
    /// The colour that it leaves the vertex stage with.
    pub(super) vertex_color: Option<[f32; 3]>,
    /// The piece in hand.
    pub(super) piece: Option<usize>,
    /// Of flat shading.
    pub(super) factor: Option<f32>,
    pub(super) row: u32,
    pub(super) pixel: Option<[u32; 2]>,
    /// Whether the pixel in hand was hidden.
    pub(super) hidden: bool,
    /// What the fragment stage was given: place, normal, colour, texture coordinates.
    pub(super) inputs: [Option<[f32; 3]>; 4],
    /// What it gave.
    pub(super) output: Option<([u8; 4], f32)>,
    /// The point that is lit.
    pub(super) point: Option<lighting::Snapshot>,
    /// Lights computed, fragments drawn, fragments hidden.
    pub(super) counts: [u64; 3],
}

impl Snapshot {
    /// Before the first event.
    pub fn new(subject: Arc<Subject>) -> Self {
        Self {
            image: subject.empty(),
            subject,
            object: 0,
            vertex: None,
            vertex_color: None,
            piece: None,
            factor: None,
            row: 0,
            pixel: None,
            hidden: false,
            inputs: [None; 4],
            output: None,
            point: None,
            counts: [0; 3],
        }
    }

    /// The image so far.
    pub fn result(&self) -> Image {
        self.image.clone()
    }

    /// The object in hand.
    pub(super) fn object(&self) -> Option<(&Object, &DrawOutputs)> {
        Some((self.subject.objects.get(self.object)?, self.subject.outputs.draws.get(self.object)?))
    }

    /// The piece in hand.
    pub(super) fn piece(&self) -> Option<&Piece> {
        let (_, stages) = self.object()?;
        stages.clipped().pieces.get(self.piece?)
    }

    /// A point is about to be lit.
    fn lit(&self, surface: Option<Surface>) -> Option<lighting::Snapshot> {
        let (object, _) = self.object()?;
        let material = match object.shade {
            Shade::Flat => object.illumination.matte(),
            _ => object.illumination.material,
        };
        Some(lighting::Snapshot::in_world(surface?, &object.illumination, material))
    }

    /// The middle of the face in hand, with its normal.
    fn face(&self) -> Option<Surface> {
        let (_, stages) = self.object()?;
        let corners = world_corners(stages, self.piece()?);
        let narrow = |v: [f64; 3]| v.map(|c| c as f32);
        Some(Surface { position: narrow(centroid(corners)), normal: narrow(face_normal(corners)) })
    }

    fn begin_pixel(&mut self, x: u16, hidden: bool) {
        (self.pixel, self.hidden) = (Some([x.into(), self.row]), hidden);
        (self.inputs, self.output, self.point) = ([None; 4], None, None);
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Object { index } => {
                self.object = index.into();
                (self.vertex, self.piece, self.pixel, self.point) = (None, None, None, None);
            }
            Event::Vertex { index } => {
                (self.vertex, self.vertex_color) = (Some(index as usize), None);
                let surface = self.object().and_then(|(object, stages)| {
                    if object.shade == Shade::Gouraud { surface(stages, index as usize) } else { None }
                });
                self.point = self.lit(surface);
            }
            Event::VertexColor { shade, color } => {
                self.vertex_color = Some(color);
                self.counts[0] += u64::from(shade == Shade::Gouraud);
            }
            Event::Light(event) => {
                if let Some(point) = &mut self.point {
                    point.apply(&event);
                }
            }
            Event::Triangle { piece } => {
                (self.piece, self.vertex, self.pixel) = (Some(piece as usize), None, None);
                (self.factor, self.point) = (None, None);
                if self.object().is_some_and(|(object, _)| object.shade == Shade::Flat) {
                    self.point = self.lit(self.face());
                }
            }
            Event::Face { factor } => {
                self.factor = Some(factor);
                self.counts[0] += 1;
            }
            Event::Row { y, .. } => (self.row, self.pixel) = (y, None),
            Event::Hidden { x } => {
                self.begin_pixel(x, true);
                self.counts[2] += 1;
            }
            Event::Fragment { x } => self.begin_pixel(x, false),
            Event::Varying { input, value } => {
                self.inputs[input as usize] = Some(value);
                if let (Input::Normal, Some(position)) = (input, self.inputs[Input::Place as usize]) {
                    self.point = self.lit(Some(Surface { position, normal: value }));
                }
            }
            Event::Output { shade, code, value } => {
                self.output = Some((code, value));
                let owner = (self.object as u16, self.piece.unwrap_or_default() as u32);
                if let Some(pixel) = self.pixel {
                    self.image.show(pixel, Shown { code, value, owner });
                }
                self.counts[0] += u64::from(shade == Shade::Phong);
                self.counts[1] += 1;
            }
            Event::Done { .. } => (self.pixel, self.point) = (None, None),
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.image.pixels.len() * size_of::<Option<Shown>>()
    }
}
