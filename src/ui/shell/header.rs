//! The line above the overview's canvas: what is shown, and what else could be.

use crate::{
    document::{Scenery, ViewState},
    face::Face,
    theme::Text,
    widgets::{down, wear},
};
use egui::{ComboBox, Rect, Role as Part, Sense, Ui, UiBuilder, WidgetInfo, pos2, vec2};
use rasterscope_core::{
    message::{Message, Value},
    pipeline::Overlay,
    scene::Scene,
};

/// What the canvas may show, from the right.
const SCENERIES: [(&str, Scenery); 3] = [
    ("ui-scenery-skips", Scenery::Skips),
    ("ui-scenery-space", Scenery::Space),
    ("ui-scenery-image", Scenery::Image),
];

/// Shows the header.
pub(crate) fn show(ui: &mut Ui, face: &Face<'_>, rect: Rect, scene: &Scene, view: &mut ViewState) {
    let image = view.scenery == Scenery::Image;
    let mut x = rect.right() - 14.0;
    if image && toggle(ui, face, &mut x, rect, "ui-outlines", view.outlines) {
        view.outlines = !view.outlines;
    }
    for (name, scenery) in SCENERIES {
        if toggle(ui, face, &mut x, rect, name, view.scenery == scenery) {
            view.scenery = scenery;
        }
    }
    if image {
        overlay(ui, face, &mut x, rect, view);
    }
    // The pressed button says as much as the heading, which needs not be there if there is no room.
    let name = SCENERIES.iter().find(|(_, scenery)| *scenery == view.scenery).map_or("", |(name, _)| *name);
    let galley = ui.painter().layout_no_wrap(face.say(name), face.look.font(Text::Strong), face.look.text);
    let at = pos2(rect.left() + 14.0, rect.center().y - galley.size().y / 2.0);
    let end = at.x + galley.size().x;
    if end > x {
        return;
    }
    ui.painter().galley(at, galley, face.look.text);
    if image {
        let [width, height] = scene.size;
        let size = Message::new("ui-image-size").with("width", width).with("height", height);
        let (font, color) = (face.look.font(Text::Body), face.look.dim);
        let galley = ui.painter().layout_no_wrap(face.words.message(&size), font, color);
        let at = pos2(end + 10.0, rect.center().y - galley.size().y / 2.0);
        if at.x + galley.size().x <= x {
            ui.painter().galley(at, galley, color);
        }
    }
}

/// The choice of what lies on the image, to the left of `x`; moves `x` to its left.
fn overlay(ui: &mut Ui, face: &Face<'_>, x: &mut f32, rect: Rect, view: &mut ViewState) {
    let font = face.look.font(Text::Label);
    let width = |overlay: &Overlay| {
        let name = face.say(overlay.word());
        ui.painter().layout_no_wrap(name, font.clone(), face.look.text).size().x
    };
    // As wide as its longest name, so that nothing moves.
    let width = Overlay::ALL.iter().map(width).fold(0.0, f32::max) + 36.0;
    let height = face.look.button_height();
    let at = Rect::from_min_size(pos2(*x - width, rect.center().y - height / 2.0), vec2(width, height));
    *x = at.left() - 10.0;
    let label = face.say("ui-overlay");
    let is = face.say_with("ui-overlay-is", "name", Value::Word(view.overlay.word()));
    ui.scope_builder(UiBuilder::new().max_rect(at), |ui| {
        let combo = ComboBox::from_id_salt("overlay")
            .width(width)
            .icon(down)
            .selected_text(face.rich(face.say(view.overlay.word()), Text::Label))
            .show_ui(ui, |ui| {
                for (key, overlay) in Overlay::ALL.into_iter().enumerate() {
                    let name = format!("{key}  {}", face.say(overlay.word()));
                    ui.selectable_value(&mut view.overlay, overlay, name);
                }
            });
        combo.response.widget_info(|| WidgetInfo::labeled(Part::ComboBox, true, &is));
        combo.response.on_hover_text(&label);
    });
    let galley = ui.painter().layout_no_wrap(label, font, face.look.dim);
    let start = pos2(*x - galley.size().x, rect.center().y - galley.size().y / 2.0);
    // The tooltip says it, too.
    if start.x >= rect.left() + 14.0 {
        *x = start.x - 10.0;
        ui.painter().galley(start, galley, face.look.dim);
    }
}

/// A button that stays pressed, to the left of `x`; moves `x` to its left.
fn toggle(ui: &Ui, face: &Face<'_>, x: &mut f32, rect: Rect, name: &'static str, on: bool) -> bool {
    let text = face.say(name);
    let galley = ui.painter().layout_no_wrap(text.clone(), face.look.font(Text::Label), face.look.text);
    let size = vec2(galley.size().x + 20.0, face.look.button_height());
    let at = Rect::from_min_size(pos2(*x - size.x, rect.center().y - size.y / 2.0), size);
    *x = at.left() - 8.0;
    let response = ui.interact(at, ui.scope_id().with(name), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Part::Button, true, on, &text));
    wear(ui, &response, at, on, face.look);
    ui.painter().galley(at.center() - galley.size() / 2.0, galley, face.look.text);
    response.clicked()
}
