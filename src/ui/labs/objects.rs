//! What the scene draws, in drawing order: added, removed, named, recoloured, reordered.

use crate::{
    face::Face,
    theme::Text,
    widgets::{Icon, State, heading, icon_button},
};
use egui::{TextEdit, Ui, vec2};
use rasterscope_core::{
    scene::{DEFAULT_COLOR, Draw, Geometry, Mesh, Scene},
    transform::matrices,
};
use rasterscope_figure::theme::{Color, ThemeName};
use std::sync::Arc;

/// Of longer lists only so many are shown.
const MOST: usize = 40;

/// What was asked of the list.
enum Edit {
    Swap(usize, usize),
    Remove(usize),
    Add,
}

/// Shows the list and edits the scene.
pub(super) fn show(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene) {
    heading(ui, face, &face.say("ui-objects"));
    let count = scene.draws.len();
    let mut edit = None;
    for (i, draw) in scene.draws.iter_mut().enumerate().take(MOST) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            color(ui, face, draw);
            let size = vec2(face.look.button_height(), face.look.button_height());
            let room = ui.available_width() - 3.0 * (size.x + 4.0);
            let field = TextEdit::singleline(&mut draw.name).desired_width(room).clip_text(true);
            let name = face.say_with("ui-object-name", "number", i + 1);
            ui.add_sized(vec2(room, size.y), field).accessible_name(name);
            for (icon, name, can, asked) in [
                (Icon::Up, "ui-object-earlier", i > 0, Edit::Swap(i.saturating_sub(1), i)),
                (Icon::Down, "ui-object-later", i + 1 < count, Edit::Swap(i, i + 1)),
                (Icon::Cross, "ui-object-remove", true, Edit::Remove(i)),
            ] {
                let state = if can { State::Off } else { State::Disabled };
                let name = face.say_with(name, "number", i + 1);
                if icon_button(ui, face, icon, size, &name, state).clicked() {
                    edit = Some(asked);
                }
            }
        });
    }
    if count > MOST {
        ui.label(face.dim(face.say_with("ui-more-rows", "count", count - MOST), Text::Small));
    }
    if ui.button(face.say("ui-object-add")).clicked() {
        edit = Some(Edit::Add);
    }
    match edit {
        Some(Edit::Swap(a, b)) => scene.draws.swap(a, b),
        Some(Edit::Remove(i)) => drop(scene.draws.remove(i)),
        Some(Edit::Add) => add(scene),
        None => {}
    }
}

/// The colour of an object: that of its first vertex; a new one is for all of them.
fn color(ui: &mut Ui, face: &Face<'_>, draw: &mut Draw) {
    let old = draw.geometry.mesh().and_then(|mesh| mesh.colors.first().copied()).unwrap_or(DEFAULT_COLOR);
    let mut codes = old.map(|channel| (channel * 255.0).round() as u8);
    let response = ui.color_edit_button_srgba_unmultiplied(&mut codes);
    // The button multiplies by alpha and divides again, so codes may differ where nobody chose.
    if !response.on_hover_text(face.say("ui-object-color")).changed() {
        return;
    }
    let new = codes.map(|code| f32::from(code) / 255.0);
    let paint = |mesh: &mut Arc<Mesh>| {
        let mesh = Arc::make_mut(mesh);
        mesh.colors = vec![new; mesh.positions.len()];
    };
    match &mut draw.geometry {
        Geometry::Mesh(mesh) => paint(mesh),
        Geometry::Model { color, mesh, .. } => {
            *color = Some(new);
            mesh.iter_mut().for_each(paint);
        }
    }
}

/// Adds a triangle that stands upright where the camera looks.
fn add(scene: &mut Scene) {
    let view = matrices::view(&scene.camera);
    let [right, up] = [0, 1].map(|row| [view[row], view[4 + row], view[8 + row]]);
    let away = |axis: usize| scene.camera.eye[axis] - scene.camera.target[axis];
    let size = 0.2 * (away(0).powi(2) + away(1).powi(2) + away(2).powi(2)).sqrt();
    let corner = |[x, y]: [f32; 2]| {
        [0, 1, 2].map(|axis| {
            let at = scene.camera.target[axis] + size * (x * right[axis] + y * up[axis]);
            // Shown numbers have at most four decimals.
            (at * 4096.0).round() / 4096.0 + 0.0
        })
    };
    let corners = [[-1.0, -0.75], [1.0, -0.75], [0.0, 1.0]].map(corner);
    let objects = ThemeName::Dark.theme().objects;
    let Color(codes) = objects[scene.draws.len() % objects.len()];
    let mesh = Mesh::soup(corners.to_vec(), codes.map(|code| f32::from(code) / 255.0));
    let mut draw = Draw::new(free_name(scene), Geometry::Mesh(Arc::new(mesh)));
    if let Some(last) = scene.draws.last() {
        (draw.cull, draw.front, draw.depth) = (last.cull, last.front, last.depth);
    }
    scene.draws.push(draw);
}

/// The first letter that names nothing yet.
fn free_name(scene: &Scene) -> String {
    let taken = |name: &String| scene.draws.iter().any(|draw| draw.name == *name);
    ('A'..='Z').map(String::from).find(|name| !taken(name)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use rasterscope_core::pipeline::{Skips, render};

    #[test]
    fn an_added_triangle_is_seen_and_has_a_free_name() {
        let mut scene = Scene::empty([36, 24]);
        add(&mut scene);
        add(&mut scene);
        let names: Vec<&str> = scene.draws.iter().map(|draw| draw.name.as_str()).collect();
        assert_eq!(names, ["A", "B"]);
        assert_eq!(scene.validate(), Ok(()));
        let frame = render(&scene, &Skips::ALL);
        assert!(frame.color.chunks(4).any(|pixel| pixel[3] != 0), "it is in the image");
    }
}
