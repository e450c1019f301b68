//! Points of the drawing that are dragged, or moved by the arrow keys.

use crate::{
    document::Snap,
    face::Face,
    labs::{Handle, Kind},
};
use egui::{
    CursorIcon, Id, Key, Modifiers, Pos2, Rect, Response, Role as Part, Sense, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo, vec2,
};
use rasterscope_figure::placement::Placement;

/// A handle is caught within this distance.
const CATCH: f32 = 14.0;

/// A canvas: where it is, and what it shows where.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plane {
    pub(crate) rect: Rect,
    pub(crate) placement: Placement,
    /// Whether larger y is higher on the screen.
    pub(crate) y_up: bool,
}

impl Plane {
    /// Where a point of the drawing is on the screen.
    pub(crate) fn place(&self, at: [f32; 2]) -> Pos2 {
        self.rect.min + Vec2::from(self.placement.to_points(at))
    }

    /// Which point of the drawing is there.
    pub(crate) fn point(&self, at: Pos2) -> [f32; 2] {
        self.placement.to_scene((at - self.rect.min).into())
    }
}

/// Lets the user move a handle; returns where to, if it moves in this frame.
pub(crate) fn interact(
    ui: &Ui,
    plane: &Plane,
    id: Id,
    handle: &Handle,
    snap: Snap,
) -> (Response, Option<[f32; 2]>) {
    let catch =
        Rect::from_center_size(plane.place(handle.at), Vec2::splat(2.0 * CATCH)).intersect(plane.rect);
    let response = ui.interact(catch, id, Sense::click_and_drag());
    response.widget_info(|| WidgetInfo::labeled(Part::Slider, true, &handle.name));
    let (shift, alt) = ui.input(|input| (input.modifiers.shift, input.modifiers.alt));
    let snap = if alt { Snap::Off } else { snap };
    let mut moved = None;
    if let Some(mut pointer) = response.interact_pointer_pos().filter(|_| response.dragged()) {
        let start = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
        if shift {
            let by = pointer - start;
            let along_x = by.x.abs() > by.y.abs();
            pointer = if along_x { Pos2::new(pointer.x, start.y) } else { Pos2::new(start.x, pointer.y) };
        }
        moved = Some(plane.point(pointer).map(|c| snap.snap(c)));
    }
    if response.has_focus() {
        let by = arrows(ui, plane.y_up) * if shift { snap.step() / 10.0 } else { snap.step() };
        if by != Vec2::ZERO {
            moved = Some([handle.at[0] + by.x, handle.at[1] + by.y].map(|c| Snap::Off.snap(c)));
        }
    }
    let cursor = match handle.kind {
        Kind::SideX => CursorIcon::ResizeHorizontal,
        Kind::SideY => CursorIcon::ResizeVertical,
        _ if response.dragged() => CursorIcon::Grabbing,
        _ => CursorIcon::Grab,
    };
    (response.on_hover_and_drag_cursor(cursor), moved.map(|to| only(handle.kind, handle.at, to)))
}

/// A side moves along one axis only.
fn only(kind: Kind, from: [f32; 2], to: [f32; 2]) -> [f32; 2] {
    match kind {
        Kind::SideX => [to[0], from[1]],
        Kind::SideY => [from[0], to[1]],
        Kind::Point | Kind::Corner => to,
    }
}

/// The arrow keys pressed, as a direction in the scene.
fn arrows(ui: &Ui, y_up: bool) -> Vec2 {
    let up = if y_up { 1.0 } else { -1.0 };
    let keys = [
        (Key::ArrowLeft, vec2(-1.0, 0.0)),
        (Key::ArrowRight, vec2(1.0, 0.0)),
        (Key::ArrowUp, vec2(0.0, up)),
        (Key::ArrowDown, vec2(0.0, -up)),
    ];
    ui.input_mut(|input| {
        keys.into_iter()
            .map(|(key, by)| by * input.count_and_consume_key(Modifiers::NONE, key) as f32)
            .fold(Vec2::ZERO, |sum, by| sum + by)
    })
}

/// Paints a handle over the drawing.
pub(crate) fn paint(ui: &Ui, face: &Face<'_>, response: &Response, at: Pos2, kind: Kind) {
    let (painter, look) = (ui.painter(), face.look);
    let busy = response.dragged() || response.hovered();
    let fill = if response.dragged() { look.text } else { look.canvas };
    match kind {
        Kind::Point => {
            painter.circle(at, 7.0, fill, look.stroke(if busy { 3.0 } else { 2.0 }, look.text));
            painter.circle_filled(at, 2.2, look.text);
        }
        _ => {
            let square = Rect::from_center_size(at, Vec2::splat(if busy { 11.0 } else { 10.0 }));
            let stroke = Stroke::new(if busy { 2.5 } else { 1.5 }, look.text);
            painter.rect(square, 0, fill, stroke, StrokeKind::Middle);
        }
    }
    if response.has_focus() {
        painter.circle_stroke(at, 12.0, look.focus_stroke());
    }
}
