//! Blending: choose factors, operations and order, and edit the layers over one pixel.

use super::{Handle, Lab, Outcome, count};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    blend::{
        BlendComponent, BlendFactor, BlendOperation, Mode,
        layers::{MOST, Order},
    },
    explain::{Marker, Role, letter},
    labs::{self, LabInput, Layer},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Blend;

impl Lab for Blend {
    fn name(&self) -> &'static str {
        "blend"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        let LabInput::Blend(before) = document.input() else { return };
        let mut input = before.clone();
        heading(ui, face, &face.say("ui-conventions"));
        let orders = [
            (Order::AsDrawn, face.say("word-order-as-drawn")),
            (Order::Reversed, face.say("word-order-reversed")),
            (Order::Sorted, face.say("word-order-sorted")),
        ];
        choices::choose(ui, face, "ui-blend-order", &mut input.order, &orders);
        mode(ui, face, &mut input);
        layers(ui, face, &mut input);
        if document.input() != &LabInput::Blend(input.clone()) {
            *document.input_mut() = input.into();
        }
    }

    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, document: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let LabInput::Blend(input) = document.input() else { return None };
        Some(Outcome {
            came: Some(input.layers.len()),
            went: count(markers, Role::Accepted),
            unit: None,
            given: (input.layers.len(), "blend-unit-layers"),
        })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}
}

/// Factors and operations: by name, or one by one.
fn mode(ui: &mut Ui, face: &Face<'_>, input: &mut labs::Blend) {
    let mut chosen = if input.state.is_some() { None } else { Some(input.mode) };
    let mut all: Vec<_> = Mode::ALL.iter().map(|mode| (Some(*mode), face.say(mode.word()))).collect();
    all.push((None, face.say("ui-blend-own")));
    choices::choose(ui, face, "ui-blend-mode", &mut chosen, &all);
    match chosen {
        Some(mode) => (input.mode, input.state) = (mode, None),
        None => input.state = Some(input.blend_state()),
    }
    let mut state = input.blend_state();
    for (name, component) in [("ui-blend-color", &mut state.color), ("ui-blend-alpha", &mut state.alpha)] {
        heading(ui, face, &face.say(name));
        ui.push_id(name, |ui| equation(ui, face, component));
    }
    if state.uses_constant() {
        color(ui, face, &face.say("ui-blend-constant"), &mut state.constant);
    }
    if state != input.blend_state() {
        input.state = Some(state);
    }
}

fn equation(ui: &mut Ui, face: &Face<'_>, component: &mut BlendComponent) {
    let factors = BlendFactor::ALL.map(|factor| (factor, factor.name().to_owned()));
    choices::choose(ui, face, "ui-blend-source-factor", &mut component.src_factor, &factors);
    choices::choose(ui, face, "ui-blend-destination-factor", &mut component.dst_factor, &factors);
    let operations = BlendOperation::ALL.map(|operation| (operation, operation.name().to_owned()));
    choices::choose(ui, face, "ui-blend-operation", &mut component.operation, &operations);
}

/// Colours and depths, each kept in 0..=1.
fn layers(ui: &mut Ui, face: &Face<'_>, input: &mut labs::Blend) {
    heading(ui, face, &face.say("ui-blend-layers"));
    let name = |i: usize, layer: &Layer| if layer.name.is_empty() { letter(i) } else { layer.name.clone() };
    for (i, layer) in input.layers.iter_mut().enumerate() {
        let name = name(i, layer);
        color(ui, face, &name, &mut layer.color);
    }
    color(ui, face, &face.say("ui-blend-clear"), &mut input.clear);
    ui.horizontal(|ui| {
        if input.layers.len() < MOST && ui.button(face.say("ui-layer-add")).clicked() {
            let shade = 0.25 + 0.125 * (input.layers.len() % 5) as f32;
            let last = input.layers.last().map_or(0.5, |layer| layer.depth / 2.0);
            input.layers.push(Layer { name: String::new(), color: [shade, shade, shade, 0.5], depth: last });
        }
        if input.layers.len() > 1 && ui.button(face.say("ui-layer-remove")).clicked() {
            input.layers.pop();
        }
    });
    if input.order == Order::Sorted {
        heading(ui, face, &face.say("ui-blend-depths"));
        for (i, layer) in input.layers.iter_mut().enumerate() {
            let name = name(i, layer);
            choices::fields(ui, face, &name, [&mut layer.depth]);
            layer.depth = layer.depth.clamp(0.0, 1.0);
        }
    }
}

fn color(ui: &mut Ui, face: &Face<'_>, name: &str, color: &mut [f32; 4]) {
    let [r, g, b, a] = color;
    choices::fields(ui, face, name, [r, g, b, a]);
    *color = color.map(|channel| channel.clamp(0.0, 1.0));
}
