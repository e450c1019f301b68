//! What lights the scene, and how its surfaces answer.

use crate::{face::Face, shell::choices, widgets::heading};
use egui::Ui;
use rasterscope_core::{
    scene::{Scene, Shade},
    shade::{Light, MOST_EXPONENT, Material, Model, Place},
};

/// More lights than these cannot be added by hand.
const MOST_LIGHTS: usize = 4;

/// How the draws are shaded: the first one's, for all of them.
pub(super) fn shade(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene) {
    let Some(before) = scene.draws.first().map(|draw| draw.shade) else { return };
    let mut shade = before;
    let all = Shade::ALL.map(|shade| (shade, face.say(shade.word())));
    choices::choose(ui, face, "ui-shade-shade", &mut shade, &all);
    if shade != before {
        scene.draws.iter_mut().for_each(|draw| draw.shade = shade);
    }
}

/// The material of the draws, the first one's for all of them, and the lights.
pub(super) fn show(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene) {
    let Some(before) = scene.draws.first().map(|draw| draw.material) else { return };
    let mut after = before;
    heading(ui, face, &face.say("ui-shade-material"));
    let models = Model::ALL.map(|model| (model, face.say(model.word())));
    choices::choose(ui, face, "ui-shade-model", &mut after.model, &models);
    let Material { ambient, diffuse, specular, exponent, two_sided, .. } = &mut after;
    shares(ui, face, [ambient, diffuse, specular], exponent);
    choices::check(ui, face, "ui-shade-two-sided", two_sided);
    if after != before {
        scene.draws.iter_mut().for_each(|draw| draw.material = after);
    }
    lights(ui, face, &mut scene.lights);
}

/// ka, kd, ks and s.
pub(super) fn shares(ui: &mut Ui, face: &Face<'_>, shares: [&mut f32; 3], exponent: &mut u32) {
    for (name, value) in ["ka", "kd", "ks"].into_iter().zip(shares) {
        choices::labelled(ui, face, name, |ui, width| choices::number(ui, face, width, name, value));
        *value = value.clamp(0.0, 1.0);
    }
    let mut whole = *exponent as usize;
    choices::index(ui, face, "ui-shade-exponent", &mut whole);
    *exponent = whole.clamp(1, MOST_EXPONENT as usize) as u32;
}

/// How bright a light is, and how it fades.
pub(super) fn strength(ui: &mut Ui, face: &Face<'_>, intensity: &mut f32, attenuation: &mut [f32; 3]) {
    let name = face.say("ui-shade-intensity");
    choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, intensity));
    *intensity = intensity.max(0.0);
    let before = *attenuation;
    let [c0, c1, c2] = attenuation;
    choices::fields(ui, face, "c", [c0, c1, c2]);
    if *attenuation == [0.0; 3] || attenuation.iter().any(|c| *c < 0.0) {
        *attenuation = before;
    }
}

fn lights(ui: &mut Ui, face: &Face<'_>, lights: &mut Vec<Light>) {
    heading(ui, face, &face.say("ui-shade-lights"));
    if lights.is_empty() {
        ui.label(face.dim(face.say("ui-shade-headlight"), crate::theme::Text::Label));
    }
    let mut remove = None;
    for (i, light) in lights.iter_mut().enumerate() {
        ui.push_id(("light", i), |ui| {
            let before = light.place;
            let (Place::Position(vector) | Place::Direction(vector)) = &mut light.place;
            let [x, y, z] = vector;
            choices::fields(ui, face, &format!("L{i}"), [x, y, z]);
            if light.place == Place::Direction([0.0; 3]) {
                light.place = before;
            }
            let mut far = matches!(light.place, Place::Direction(_));
            choices::check(ui, face, "ui-shade-far", &mut far);
            light.place = match (light.place, far) {
                (Place::Position(at), true) if at != [0.0; 3] => Place::Direction(at),
                (Place::Direction(to), false) => Place::Position(to),
                (place, _) => place,
            };
            strength(ui, face, &mut light.intensity, &mut light.attenuation);
            if ui.button(face.say_with("ui-shade-remove-light", "number", i)).clicked() {
                remove = Some(i);
            }
        });
    }
    if let Some(i) = remove {
        lights.remove(i);
    }
    if lights.len() < MOST_LIGHTS && ui.button(face.say("ui-shade-add-light")).clicked() {
        lights.push(Light::new(Place::Direction([1.0, 1.0, 1.0])));
    }
}
