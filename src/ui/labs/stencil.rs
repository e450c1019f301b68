//! The stencil test: choose how outlines are made, or edit the state of every draw.

use super::{Handle, Lab, Outcome, count, pipeline, scanline::fill_rule, z_buffer::depth_format};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    depth::CompareFunction,
    explain::{Marker, Role},
    labs::{self, LabInput, Order},
    message::Value,
    pipeline::draw_name,
    scene::Scene,
    stencil::{StencilOperation, StencilState, Way},
};

/// Of more draws only the first have their state shown.
const MOST_DRAWS: usize = 8;

/// The lab.
#[derive(Debug)]
pub(crate) struct Stencil;

impl Lab for Stencil {
    fn name(&self) -> &'static str {
        "stencil"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        heading(ui, face, &face.say("ui-conventions"));
        if let LabInput::Stencil(mut input) = *document.input() {
            outline(ui, face, &mut input, &document.scene);
            if document.input() != &LabInput::Stencil(input) {
                *document.input_mut() = LabInput::Stencil(input);
            }
            if input.way(&document.scene).is_none() {
                depth_format(ui, face, document);
            }
        }
        fill_rule(ui, face, document);
        choices::snapping(ui, face, view);
        if matches!(document.input(), LabInput::Stencil(labs::Stencil { outline: None, .. })) {
            states(ui, face, &mut document.scene);
        }
        super::objects::show(ui, face, &mut document.scene);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        pipeline::Pipeline.handles(document)
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let passed = count(markers, Role::Accepted);
        Some(Outcome {
            came: Some(passed + count(markers, Role::Rejected)),
            went: passed,
            unit: None,
            given: (document.scene.draws.len(), "pipeline-unit-triangles"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        pipeline::Pipeline.drag(document, handle, to);
    }
}

/// How outlines are made, and how far they reach.
fn outline(ui: &mut Ui, face: &Face<'_>, input: &mut labs::Stencil, scene: &Scene) {
    let all = [
        (None, face.say("word-outline-of-scene")),
        (Some(Way::Scale), face.say("word-outline-scale")),
        (Some(Way::Normals), face.say("word-outline-normals")),
        (Some(Way::Pixels), face.say("word-outline-pixels")),
    ];
    choices::choose(ui, face, "ui-outline", &mut input.outline, &all);
    let Some(way) = input.way(scene) else { return };
    let orders = [
        (Order::Together, face.say("word-outlines-together")),
        (Order::OneByOne, face.say("word-outlines-one-by-one")),
    ];
    choices::choose(ui, face, "ui-outlines-drawn", &mut input.order, &orders);
    let (name, amount) = match way {
        Way::Scale => ("ui-outline-factor", &mut input.factor),
        Way::Normals => ("ui-outline-distance", &mut input.distance),
        Way::Pixels => ("ui-outline-pixels", &mut input.pixels),
    };
    let name = face.say(name);
    choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, amount));
}

/// The stencil state of every draw.
fn states(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene) {
    for (index, draw) in scene.draws.iter_mut().enumerate().take(MOST_DRAWS) {
        let name = draw_name((index, draw));
        heading(ui, face, &face.say_with("ui-stencil-of", "object", Value::text(&name)));
        ui.push_id(index, |ui| {
            let mut on = draw.stencil.is_some();
            choices::check(ui, face, "ui-stencil-test", &mut on);
            if on != draw.stencil.is_some() {
                draw.stencil = on.then(StencilState::default);
            }
            if let Some(stencil) = &mut draw.stencil {
                state(ui, face, stencil);
            }
        });
    }
}

/// Compare function, operations, masks and reference, under WebGPU's names.
fn state(ui: &mut Ui, face: &Face<'_>, state: &mut StencilState) {
    let compares = CompareFunction::ALL.map(|compare| (compare, compare.name().to_owned()));
    choices::choose(ui, face, "ui-stencil-compare", &mut state.compare, &compares);
    let operations = StencilOperation::ALL.map(|operation| (operation, operation.name().to_owned()));
    for (name, operation) in [
        ("ui-stencil-fail", &mut state.fail_op),
        ("ui-stencil-depth-fail", &mut state.depth_fail_op),
        ("ui-stencil-pass", &mut state.pass_op),
    ] {
        choices::choose(ui, face, name, operation, &operations);
    }
    for (name, value) in [
        ("ui-stencil-reference", &mut state.reference),
        ("ui-stencil-read-mask", &mut state.read_mask),
        ("ui-stencil-write-mask", &mut state.write_mask),
    ] {
        let mut number = usize::from(*value);
        choices::index(ui, face, name, &mut number);
        *value = u8::try_from(number).unwrap_or(u8::MAX);
    }
}
