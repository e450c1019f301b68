//! Stress: pick a family, turn the dial, see where each arithmetic breaks; make the case small and open it.

use super::{Handle, Lab, Outcome, count};
use crate::{
    document::{Document, ViewState},
    face::{Command, Face},
    shell::choices,
};
use egui::{DragValue, Slider, Ui, vec2};
use rasterscope_core::{
    explain::{Marker, Role},
    labs::LabInput,
    math::Arithmetic,
    stress::{
        dial::{self, MOST, Operation},
        trial::CASES,
    },
};

/// The lab.
#[derive(Debug)]
pub(crate) struct Stress;

impl Lab for Stress {
    fn name(&self) -> &'static str {
        "stress"
    }

    fn controls(&self, ui: &mut Ui, face: &Face<'_>, document: &mut Document, _: &mut ViewState) {
        let LabInput::Stress(mut input) = *document.input() else { return };
        let before = input;
        let all = Operation::ALL.map(|each| (each, face.say(each.word())));
        choices::choose(ui, face, "stress-operation", &mut input.operation, &all);
        let families = input.operation.families();
        if !families.contains(&input.family) {
            input.family = families[0];
        }
        let all: Vec<_> = families.iter().map(|each| (*each, face.say(dial::word(*each)))).collect();
        choices::choose(ui, face, "stress-family", &mut input.family, &all);
        let name = face.say("stress-dial");
        let row = choices::labelled(ui, face, &name, |ui, width| {
            let spacing = ui.spacing_mut();
            let number = 34.0;
            spacing.slider_width = width - number - spacing.item_spacing.x;
            ui.add(Slider::new(&mut input.dial, 0..=MOST).show_value(false)).accessible_name(&name);
            let typed = DragValue::new(&mut input.dial).speed(0.05).range(0..=MOST);
            ui.add_sized(vec2(number, face.look.button_height()), typed)
                .accessible_name(face.say("stress-dial-number"));
        });
        row.on_hover_text(face.say("stress-dial-about"));
        let known: Vec<Arithmetic> = input.subject(&document.scene).rounded().collect();
        if !known.contains(&input.arithmetic) {
            input.arithmetic = Arithmetic::F32;
        }
        let all: Vec<_> = known.iter().map(|each| (*each, face.say(each.word()))).collect();
        choices::choose(ui, face, "ui-arithmetic", &mut input.arithmetic, &all);
        choices::check(ui, face, "stress-shrink", &mut input.shrink);
        if ui.button(face.say("stress-open")).clicked() {
            face.ask(Command::CaseInLab);
        }
        if input != before {
            *document.input_mut() = input.into();
        }
    }

    /// Cases are made by the dial, not by hand.
    fn handles(&self, _: &Document) -> Vec<Handle> {
        Vec::new()
    }

    fn outcome(&self, _: &Document, markers: &[(usize, Marker)]) -> Option<Outcome> {
        Some(Outcome {
            came: None,
            went: count(markers, Role::Rejected),
            unit: Some("stress-unit-broken"),
            given: (CASES, "stress-unit-cases"),
        })
    }

    fn drag(&self, _: &mut Document, _: usize, _: [f32; 2]) {}
}
