//! One point in a light: drag the point, its normal, the light and the eye.

use super::{Handle, Kind, Lab, Outcome, light};
use crate::{
    document::{Document, ViewState},
    face::Face,
    shell::choices,
    widgets::heading,
};
use egui::Ui;
use rasterscope_core::{
    explain::Marker,
    labs::{self, LabInput},
    math::Arithmetic,
    shade::{Mistake, Model},
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Lighting;

impl Lab for Lighting {
    fn name(&self) -> &'static str {
        "lighting"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, view: &mut ViewState) {
        let LabInput::Lighting(input) = document.input_mut() else { return };
        heading(ui, face, &face.say("ui-conventions"));
        let models = Model::ALL.map(|model| (model, face.say(model.word())));
        choices::choose(ui, face, "ui-shade-model", &mut input.model, &models);
        let all = [Arithmetic::F64, Arithmetic::F32].map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        choices::check(ui, face, "ui-shade-two-sided", &mut input.two_sided);
        choices::check(ui, face, "ui-shade-far", &mut input.far);
        choices::snapping(ui, face, view);
        heading(ui, face, &face.say("ui-mistakes"));
        let words = ["mistake-model-normals", "mistake-model-normals-effect"];
        let mut on = input.mistake == Mistake::ModelNormals;
        choices::mistake(ui, face, words, &mut on);
        input.mistake = if on { Mistake::ModelNormals } else { Mistake::None };
        heading(ui, face, &face.say("ui-shade-places"));
        for (name, [x, y]) in [
            ("P", &mut input.point),
            ("N", &mut input.normal),
            ("L", &mut input.light),
            ("E", &mut input.eye),
            ("M", &mut input.scale),
        ] {
            choices::fields(ui, face, name, [x, y]);
        }
        if input.far && input.light == [0.0; 2] {
            input.light = [0.0, 1.0];
        }
        heading(ui, face, &face.say("ui-shade-light"));
        light::strength(ui, face, &mut input.intensity, &mut input.attenuation);
        heading(ui, face, &face.say("ui-shade-material"));
        let shares = [&mut input.ambient, &mut input.diffuse, &mut input.specular];
        light::shares(ui, face, shares, &mut input.exponent);
    }

    fn handles(&self, document: &Document) -> Vec<Handle> {
        let LabInput::Lighting(input) = document.input() else { return Vec::new() };
        let ends = [("P", input.point), ("N", tip(input)), ("L", source(input)), ("E", input.eye)];
        let handle = |(name, at): (&str, _)| Handle { name: name.to_owned(), at, kind: Kind::Point };
        ends.map(handle).to_vec()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        let done = |marker: &&(usize, Marker)| marker.1.label == Some("shade-marker-sum");
        Some(Outcome {
            came: None,
            went: markers.iter().filter(done).count(),
            unit: Some("pipeline-unit-values"),
            given: (1, "shade-unit-points"),
        })
    }

    fn drag(&self, document: &mut Document, handle: usize, to: [f32; 2]) {
        let LabInput::Lighting(input) = document.input_mut() else { return };
        let from_point = [0, 1].map(|axis| to[axis] - input.point[axis]);
        match handle {
            0 => input.point = to,
            1 => input.normal = from_point,
            2 if !input.far => input.light = to,
            // A direction of length 0 is none.
            2 if from_point != [0.0; 2] => input.light = from_point,
            3 => input.eye = to,
            _ => {}
        }
    }
}

/// Where the normal ends.
fn tip(input: &labs::Lighting) -> [f32; 2] {
    [0, 1].map(|axis| input.point[axis] + input.normal[axis])
}

/// Where the light is drawn: the end of its direction, if it is far.
fn source(input: &labs::Lighting) -> [f32; 2] {
    if input.far { [0, 1].map(|axis| input.point[axis] + input.light[axis]) } else { input.light }
}
