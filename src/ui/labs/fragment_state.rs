//! What a draw's fragments meet before the tests: depth bias, depth clamp, scissor, alpha test.

use crate::{face::Face, shell::choices, widgets::heading};
use egui::{DragValue, Id, Ui, vec2};
use rasterscope_core::{
    blend::AlphaTest,
    depth::CompareFunction,
    explain::letter,
    labs::TriangleState,
    pipeline::draw_name,
    raster::Scissor,
    scene::{Draw, Scene},
};

/// The state of one of the scene's draws, chosen by name.
pub(super) fn of_draws(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene) {
    let names = scene.draws.iter().enumerate().map(draw_name).collect();
    let Some(index) = choose(ui, face, names) else { return };
    let size = scene.size;
    let draw = &mut scene.draws[index];
    let before = state_of(draw);
    let mut state = before;
    edit(ui, face, &mut state, size);
    if state != before {
        (draw.placement.bias, draw.placement.unclipped) = (state.bias, state.unclipped);
        (draw.scissor, draw.alpha_test) = (state.scissor, state.alpha_test);
    }
}

/// The state of one of a lab's own triangles, chosen by letter; alpha at its vertices, too.
pub(super) fn of_triangles(
    ui: &mut Ui,
    face: &Face<'_>,
    (states, triangles): (&mut Vec<TriangleState>, usize),
    size: [u32; 2],
) {
    let Some(index) = choose(ui, face, (0..triangles).map(letter).collect()) else { return };
    let before = states.get(index).copied().unwrap_or_default();
    let mut state = before;
    edit(ui, face, &mut state, size);
    if state.alpha_test.is_some() {
        let [a, b, c] = state.alpha.get_or_insert([1.0; 3]);
        choices::fields(ui, face, &face.say("ui-alpha-vertices"), [a, b, c]);
        state.alpha = state.alpha.map(|alpha| alpha.map(|value| value.clamp(0.0, 1.0)));
    } else {
        state.alpha = before.alpha;
    }
    if state != before {
        if states.len() <= index {
            states.resize(index + 1, TriangleState::default());
        }
        states[index] = state;
    }
}

fn state_of(draw: &Draw) -> TriangleState {
    TriangleState {
        bias: draw.placement.bias,
        unclipped: draw.placement.unclipped,
        scissor: draw.scissor,
        alpha_test: draw.alpha_test,
        alpha: None,
    }
}

/// Which of several is edited; nothing of none. Remembered while the window is open.
fn choose(ui: &mut Ui, face: &Face<'_>, names: Vec<String>) -> Option<usize> {
    let last = names.len().checked_sub(1)?;
    heading(ui, face, &face.say("ui-fragments"));
    let id = Id::unique("edited fragments");
    let mut index: usize = ui.data(|data| data.get_temp(id)).unwrap_or(last).min(last);
    let all: Vec<_> = names.into_iter().enumerate().collect();
    choices::choose(ui, face, "ui-fragments-of", &mut index, &all);
    ui.data_mut(|data| data.insert_temp(id, index));
    Some(index)
}

fn edit(ui: &mut Ui, face: &Face<'_>, state: &mut TriangleState, size: [u32; 2]) {
    let bias = &mut state.bias;
    whole(ui, face, "ui-bias-constant", &mut bias.constant);
    for (name, value) in [("ui-bias-slope", &mut bias.slope), ("ui-bias-clamp", &mut bias.clamp)] {
        let name = face.say(name);
        choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, value));
    }
    choices::check(ui, face, "ui-unclipped", &mut state.unclipped);
    let mut on = state.scissor.is_some();
    choices::check(ui, face, "ui-scissor", &mut on);
    let whole_image = Scissor { x: 0, y: 0, width: size[0], height: size[1] };
    state.scissor = on.then(|| state.scissor.unwrap_or(whole_image));
    if let Some(scissor) = &mut state.scissor {
        rectangle(ui, face, scissor);
    }
    let mut on = state.alpha_test.is_some();
    choices::check(ui, face, "ui-alpha-test", &mut on);
    state.alpha_test = on.then(|| state.alpha_test.unwrap_or_default());
    if let Some(AlphaTest { compare, reference }) = &mut state.alpha_test {
        let all = CompareFunction::ALL.map(|compare| (compare, compare.name().to_owned()));
        choices::choose(ui, face, "ui-alpha-compare", compare, &all);
        let name = face.say("ui-alpha-reference");
        choices::labelled(ui, face, &name, |ui, width| choices::number(ui, face, width, &name, reference));
        *reference = reference.clamp(0.0, 1.0);
    }
}

/// A whole number of either sign.
fn whole(ui: &mut Ui, face: &Face<'_>, label: &'static str, value: &mut i32) {
    let label = face.say(label);
    choices::labelled(ui, face, &label, |ui, width| {
        let drag = DragValue::new(value).speed(0.2).update_while_editing(false);
        ui.add_sized(vec2(width, face.look.button_height()), drag).accessible_name(&label);
    });
}

/// First column and row, width and height.
fn rectangle(ui: &mut Ui, face: &Face<'_>, scissor: &mut Scissor) {
    let label = face.say("ui-scissor");
    let Scissor { x, y, width, height } = scissor;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let wide = (ui.available_width() - 9.0) / 4.0;
        for (value, name) in [(x, "x"), (y, "y"), (width, "w"), (height, "h")] {
            let drag = DragValue::new(value).range(0..=16384).speed(0.1).prefix(format!("{name} "));
            let size = vec2(wide, face.look.button_height());
            ui.add_sized(size, drag.update_while_editing(false)).accessible_name(format!("{label} {name}"));
        }
    });
}
