//! Where objects stand and where they are seen from: every number of the transform chain.

use crate::{face::Face, shell::choices, widgets::heading};
use egui::Ui;
use rasterscope_core::{
    scene::{Scene, Transform},
    transform::Projection,
};

/// From object space to world space, for one draw.
pub(super) fn transform(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene, draw: usize) {
    let Some(before) = scene.draws.get(draw).map(|draw| draw.transform) else { return };
    heading(ui, face, &face.say("ui-placing"));
    let mut after = before;
    match &mut after {
        Transform::Parts { translate, rotate_degrees, scale } => {
            for (name, values) in [("ui-move", translate), ("ui-turn", rotate_degrees), ("ui-scale", scale)] {
                let [x, y, z] = values;
                choices::fields(ui, face, &face.say(name), [x, y, z]);
            }
        }
        Transform::Matrix(matrix) => {
            // The numbers stand in columns; a row of fields is a row of the matrix.
            for row in 0..4 {
                let mut line = [0, 1, 2, 3].map(|column| matrix[4 * column + row]);
                let [x, y, z, w] = &mut line;
                choices::fields(ui, face, &format!("M{row}"), [x, y, z, w]);
                for (column, value) in line.into_iter().enumerate() {
                    matrix[4 * column + row] = value;
                }
            }
        }
    }
    if after != before {
        scene.draws[draw].transform = after;
        if scene.validate().is_err() {
            scene.draws[draw].transform = before;
        }
    }
}

/// The eye, what it looks at, and the frustum.
pub(super) fn camera(ui: &mut Ui, face: &Face<'_>, scene: &mut Scene) {
    let before = scene.camera;
    heading(ui, face, &face.say("ui-camera"));
    let camera = &mut scene.camera;
    for (name, values) in
        [("ui-eye", &mut camera.eye), ("ui-target", &mut camera.target), ("ui-up", &mut camera.up)]
    {
        let [x, y, z] = values;
        choices::fields(ui, face, &face.say(name), [x, y, z]);
    }
    let (name, value) = match &mut camera.projection {
        Projection::Perspective { fovy_degrees } => ("ui-fovy", fovy_degrees),
        Projection::Orthographic { height } => ("ui-height", height),
    };
    for (name, value) in [(name, value), ("ui-near", &mut camera.near), ("ui-far", &mut camera.far)] {
        let text = face.say(name);
        let label =
            choices::labelled(ui, face, &text, |ui, width| choices::number(ui, face, width, &text, value));
        face.explain(label, name);
    }
    // What cannot be seen through leaves the camera as it was.
    if scene.camera != before && scene.validate().is_err() {
        scene.camera = before;
    }
}
