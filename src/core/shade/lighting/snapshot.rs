//! What is known of a point while its brightness is computed.

use super::{Brightness, Event, Subject, Surface, Vector};
use crate::{
    math::Arithmetic,
    replay::State,
    shade::{Illumination, Light, Material},
    transform::matrices,
};
use std::sync::Arc;

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) subject: Subject,
    pub(super) lights: Arc<[Light]>,
    /// How many lights have begun.
    pub(super) begun: usize,
    /// The normal in world space.
    pub(super) turned: Option<[f32; 3]>,
    /// Of length 1, or zero where there is no direction: n, v, l.
    pub(super) units: [Option<[f32; 3]>; 3],
    pub(super) distance: Option<f32>,
    pub(super) fade: Option<f64>,
    pub(super) incidence: Option<f64>,
    /// r, or h.
    pub(super) bisector: Option<[f32; 3]>,
    pub(super) highlight: Option<f64>,
    pub(super) power: Option<f64>,
    /// Ambient, diffuse and specular, of all lights so far.
    pub(super) terms: [Option<f64>; 3],
    /// The term that the last event computed, if it did.
    pub(super) computed: Option<usize>,
    pub(super) result: Option<f32>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(subject: Subject) -> Self {
        Self::of_lights(subject, Arc::new([subject.light]))
    }

    /// The same of a point with its normal in world space, in the light of a draw.
    pub(in crate::shade) fn in_world(surface: Surface, by: &Illumination, material: Material) -> Self {
        let subject = Subject {
            surface,
            model: matrices::IDENTITY,
            mistaken: false,
            light: by.lights[0],
            eye: by.eye,
            material,
            arithmetic: Arithmetic::F64,
        };
        Self { turned: Some(surface.normal), ..Self::of_lights(subject, Arc::clone(&by.lights)) }
    }

    fn of_lights(subject: Subject, lights: Arc<[Light]>) -> Self {
        Self {
            subject,
            lights,
            begun: 0,
            turned: None,
            units: [None; 3],
            distance: None,
            fade: None,
            incidence: None,
            bisector: None,
            highlight: None,
            power: None,
            terms: [None; 3],
            computed: None,
            result: None,
        }
    }

    /// The brightness of a white point, once it is known.
    pub fn result(&self) -> Option<f32> {
        self.result
    }

    /// The terms so far.
    pub fn brightness(&self) -> Brightness {
        let [ambient, diffuse, gloss] = self.terms.map(|term| term.unwrap_or(0.0));
        Brightness { matte: ambient + diffuse, gloss }
    }

    /// The light in hand.
    pub(super) fn light(&self) -> Light {
        self.lights.get(self.begun.saturating_sub(1)).copied().unwrap_or(self.subject.light)
    }

    fn add(&mut self, term: usize, value: f64) {
        self.terms[term] = Some(self.terms[term].unwrap_or(0.0) + value);
        self.computed = Some(term);
    }

    /// A vector is known; what the last light gave goes when the next one begins.
    fn know(&mut self, vector: Vector, unit: [f32; 3]) {
        if vector == Vector::Light {
            self.begun += 1;
            (self.distance, self.fade, self.incidence) = (None, None, None);
            (self.bisector, self.highlight, self.power) = (None, None, None);
        }
        self.units[vector as usize] = Some(unit);
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.computed = None;
        match *event {
            Event::Turned { normal } => self.turned = Some(normal),
            Event::Unit { vector, unit } => self.know(vector, unit),
            Event::AsItIs { normal } => self.know(Vector::Normal, normal),
            Event::NoDirection { vector } => self.know(vector, [0.0; 3]),
            Event::Flipped { unit } => self.units[Vector::Normal as usize] = Some(unit),
            Event::Ambient { value } => self.add(0, value),
            Event::Fade { distance, factor } => {
                (self.distance, self.fade) = (Some(distance), Some(factor));
            }
            Event::Incidence { cosine } => self.incidence = Some(cosine),
            Event::Behind => {
                self.add(1, 0.0);
                self.add(2, 0.0);
                self.computed = None;
            }
            Event::Diffuse { value } => self.add(1, value),
            Event::Mirrored { r: bisector } | Event::Halfway { h: bisector } => {
                self.bisector = Some(bisector);
            }
            Event::Highlight { cosine, .. } => self.highlight = Some(cosine),
            Event::Power { value, .. } => self.power = Some(value),
            Event::Specular { value } => self.add(2, value),
            Event::Sum { value } => self.result = Some(value),
        }
    }
}
