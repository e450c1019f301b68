//! The few widgets that egui does not have, and icons as painted shapes.

use crate::{
    face::Face,
    theme::{Look, Text},
};
use egui::{
    Align2, Color32, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, StrokeKind, Ui, Vec2,
    WidgetInfo, vec2,
};

/// Icons are shapes, never glyphs: no font has to have them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Icon {
    Begin,
    Back,
    Play,
    Pause,
    Forward,
    End,
    Undo,
    Redo,
    Up,
    Down,
    Cross,
}

impl Icon {
    /// Paints the icon into a square of 12 points round `at`.
    pub(crate) fn paint(self, painter: &Painter, at: Pos2, color: Color32) {
        let bar = |x: f32| {
            painter.rect_filled(Rect::from_center_size(at + vec2(x, 0.0), vec2(2.0, 11.0)), 0, color)
        };
        let triangle = |x: f32, width: f32| {
            let points = vec![at + vec2(x, -5.5), at + vec2(x + width, 0.0), at + vec2(x, 5.5)];
            painter.add(Shape::convex_polygon(points, color, Stroke::NONE));
        };
        match self {
            Self::Begin => {
                bar(-6.0);
                triangle(0.5, -5.0);
                triangle(6.5, -6.0);
            }
            Self::Back => {
                bar(-5.0);
                triangle(4.5, -8.0);
            }
            Self::Play => triangle(-4.0, 9.0),
            Self::Pause => {
                bar(-3.0);
                bar(3.0);
            }
            Self::Forward => {
                triangle(-4.5, 8.0);
                bar(5.0);
            }
            Self::End => {
                triangle(-6.5, 6.0);
                triangle(-0.5, 5.0);
                bar(6.0);
            }
            Self::Undo => turn(painter, at, 1.0, color),
            Self::Redo => turn(painter, at, -1.0, color),
            Self::Up | Self::Down => {
                let y = if self == Self::Up { 2.5 } else { -2.5 };
                let points = vec![at + vec2(-4.5, y), at + vec2(0.0, -y), at + vec2(4.5, y)];
                painter.add(Shape::line(points, Stroke::new(1.5, color)));
            }
            Self::Cross => {
                for y in [-4.0, 4.0] {
                    painter.line_segment([at + vec2(-4.0, y), at + vec2(4.0, -y)], Stroke::new(1.5, color));
                }
            }
        }
    }
}

/// A bent arrow that points to the left (`side` 1) or to the right (`side` -1).
fn turn(painter: &Painter, at: Pos2, side: f32, color: Color32) {
    let stroke = Stroke::new(1.5, color);
    let p = |x: f32, y: f32| at + vec2(x * side, y);
    let mut line = vec![p(-5.0, -2.5), p(1.5, -2.5)];
    line.extend((1..=8).map(|i| {
        let angle = std::f32::consts::PI * (i as f32 / 8.0 - 0.5);
        p(1.5 + 3.8 * angle.cos(), 1.3 + 3.8 * angle.sin())
    }));
    line.push(p(-2.0, 5.1));
    painter.add(Shape::line(line, stroke));
    painter.add(Shape::line(vec![p(-2.0, -5.8), p(-5.4, -2.5), p(-2.0, 0.8)], stroke));
}

/// A chevron to the right, between stages.
pub(crate) fn chevron(painter: &Painter, at: Pos2, stroke: Stroke) {
    painter.add(Shape::line(vec![at + vec2(-2.5, -4.5), at + vec2(2.5, 0.0), at + vec2(-2.5, 4.5)], stroke));
}

/// The fill and outline that a button's state asks for.
pub(crate) fn wear(ui: &Ui, response: &Response, rect: Rect, on: bool, look: &Look) {
    let visuals = ui.style().interact(response);
    let fill = if on && !response.hovered() { look.raised } else { visuals.weak_bg_fill };
    let stroke = if on && !response.has_focus() { Stroke::new(1.0, look.edge) } else { visuals.bg_stroke };
    ui.painter().rect(rect, 4, fill, stroke, StrokeKind::Inside);
}

/// The ring round what has the keyboard, for widgets that paint themselves.
pub(crate) fn focus_ring(ui: &Ui, response: &Response, rect: Rect, look: &Look) {
    if response.has_focus() {
        ui.painter().rect_stroke(rect, 4, look.focus_stroke(), StrokeKind::Inside);
    }
}

/// A button with an icon; `name` is its accessible name and its tooltip.
pub(crate) fn icon_button(
    ui: &mut Ui,
    face: &Face<'_>,
    icon: Icon,
    size: Vec2,
    name: &str,
    state: State,
) -> Response {
    let sense = if state == State::Disabled { Sense::hover() } else { Sense::click() };
    let (rect, response) = ui.allocate_exact_size(size, sense);
    icon_button_at(ui, face, icon, rect, &response, state, true);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, state != State::Disabled, name));
    response.on_hover_text(name)
}

/// Whether a button can be pressed, and whether it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum State {
    Off,
    On,
    Disabled,
}

/// Paints a button with an icon.
pub(crate) fn icon_button_at(
    ui: &Ui,
    face: &Face<'_>,
    icon: Icon,
    rect: Rect,
    response: &Response,
    state: State,
    frameless: bool,
) {
    if !frameless || (state != State::Disabled && (response.hovered() || response.has_focus())) {
        wear(ui, response, rect, state == State::On, face.look);
    }
    let color = if state == State::Disabled { face.look.disabled() } else { face.look.text };
    icon.paint(ui.painter(), rect.center(), color);
}

/// A flat row that can be pressed; `content` paints it.
pub(crate) fn row(
    ui: &mut Ui,
    face: &Face<'_>,
    height: f32,
    name: &str,
    chosen: bool,
    content: impl FnOnce(&Ui, Rect),
) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, true, chosen, name));
    if ui.is_rect_visible(rect) {
        if !chosen && response.hovered() {
            ui.painter().rect_filled(rect, 0, face.look.field);
        }
        content(ui, rect);
        focus_ring(ui, &response, rect, face.look);
    }
    response
}

/// Text in one line, cut with an ellipsis where it does not fit.
pub(crate) fn text_in(
    painter: &Painter,
    rect: Rect,
    align: Align2,
    text: &str,
    font: egui::FontId,
    color: Color32,
) {
    let mut job = egui::text::LayoutJob::simple_singleline(text.to_owned(), font, color);
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width());
    let galley = painter.layout_job(job);
    let at = align.align_size_within_rect(galley.size(), rect).min;
    painter.galley(at, galley, color);
}

/// Text in as many lines as it needs, in the middle of a room's height.
pub(crate) fn text_lines(painter: &Painter, room: Rect, text: &str, font: egui::FontId, color: Color32) {
    let galley = painter.layout(text.to_owned(), font, color, room.width());
    painter.galley(Align2::LEFT_CENTER.align_size_within_rect(galley.size(), room).min, galley, color);
}

/// A heading of a group.
pub(crate) fn heading(ui: &mut Ui, face: &Face<'_>, text: &str) {
    ui.add_space(6.0);
    ui.label(egui::RichText::new(text).font(face.look.font(Text::LabelStrong)).color(face.look.dim));
}

/// Scrolls what has got the keyboard into sight; called at the end of what scrolls.
pub(crate) fn follow_focus(ui: &Ui) {
    let ctx = ui.ctx();
    let focused = ctx.memory(egui::Memory::focused);
    let key = ui.unique_id().with("followed");
    if ctx.data(|data| data.get_temp::<Option<egui::Id>>(key)).flatten() == focused {
        return;
    }
    ctx.data_mut(|data| data.insert_temp(key, focused));
    let place = focused.and_then(|id| ctx.read_response(id)).map(|response| response.rect);
    if let Some(rect) = place.filter(|rect| ui.min_rect().contains_rect(*rect)) {
        ui.scroll_to_rect(rect.expand(2.0), None);
    }
}

/// A line of 1 px over the full width.
pub(crate) fn rule(ui: &Ui, rect: Rect, look: &Look) {
    let y = ui.painter().round_to_pixel_center(rect.bottom());
    ui.painter().hline(rect.x_range(), y, Stroke::new(1.0, look.line));
}

/// The sign of a combo: a chevron down.
pub(crate) fn down(ui: &Ui, rect: Rect, visuals: &egui::style::WidgetVisuals, _open: bool) {
    let at = rect.center();
    let points = vec![at + vec2(-4.0, -2.0), at + vec2(0.0, 2.0), at + vec2(4.0, -2.0)];
    ui.painter().add(Shape::line(points, Stroke::new(1.5, visuals.fg_stroke.color)));
}
