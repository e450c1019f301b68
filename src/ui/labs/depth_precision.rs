//! The step of depth: move near and far and see where two planes become one.

use super::{Handle, Kind, Lab, Outcome, count, z_buffer::depth_format};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::{Marker, Role},
    labs::{self, LabInput},
};

/// The smallest distance and gap that can be chosen by hand.
const LEAST: f32 = 1e-6;

/// The lab.
#[derive(Debug)]
pub(crate) struct DepthPrecision;

impl Lab for DepthPrecision {
    fn name(&self) -> &'static str {
        "depth-precision"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        depth_format(ui, face, document);
        choices::check(ui, face, "ui-depth-reversed", &mut document.scene.reversed);
        heading(ui, face, &face.say("ui-precision-distances"));
        let LabInput::DepthPrecision(labs::DepthPrecision { mut gap }) = *document.input() else { return };
        let before = gap;
        let camera = &mut document.scene.camera;
        for (name, value) in [
            ("ui-precision-near", &mut camera.near),
            ("ui-precision-far", &mut camera.far),
            ("ui-precision-gap", &mut gap),
        ] {
            let name = face.say(name);
            choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, value));
            *value = value.max(LEAST);
        }
        camera.far = camera.far.max(camera.near * 1.001);
        if gap != before {
            *document.input_mut() = labs::DepthPrecision { gap }.into();
        }
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::DepthPrecision(labs::DepthPrecision { gap }) = *document.input() else {
            return Vec::new();
        };
        let camera = &document.scene.camera;
        let middle = f32::midpoint(camera.near.log10(), camera.far.log10());
        let handle = |name: &str, at, kind| Handle { name: name.to_owned(), at, kind };
        vec![
            handle("n", [camera.near.log10(), gap.log10()], Kind::SideX),
            handle("f", [camera.far.log10(), gap.log10()], Kind::SideX),
            handle("gap", [middle, gap.log10()], Kind::SideY),
        ]
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count(markers, Role::Accepted),
            unit: Some("depth-precision-unit"),
            given: (2, "depth-precision-planes"),
        })
    }

    /// The drawing's coordinates are powers of ten.
    fn drag(&self, document: &mut Document, handle: usize, [x, y]: [f32; 2]) {
        let power = |exponent: f32| {
            // Three digits are enough by hand.
            let value = 10f32.powf(exponent.clamp(-5.5, 6.0));
            format!("{value:.2e}").parse().unwrap_or(value)
        };
        let camera = &mut document.scene.camera;
        match handle {
            0 => camera.near = power(x).min(camera.far / 1.01),
            1 => camera.far = power(x).max(camera.near * 1.01),
            _ => *document.input_mut() = labs::DepthPrecision { gap: power(y) }.into(),
        }
    }
}
