//! The canvas: the drawing of the step, handles to drag, zoom, pan, and the readout.

use crate::{
    document::{Document, Snap, Tab, ViewState},
    face::Face,
    labs::{Handle, Kind, Lab},
    paint::{self, Textures},
    theme::Text,
    widgets::text_in,
};
use egui::{
    Align2, CursorIcon, Id, Key, Modifiers, PointerButton, Pos2, Rect, Response, Role as Part, Sense, Stroke,
    StrokeKind, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use rasterscope_core::explain::{Grid, Mark, View};
use rasterscope_figure::{figure::Figure, layout, placement::Placement, theme::ThemeName, words::Words};

/// A handle is caught within this distance.
const CATCH: f32 = 14.0;
/// Handles nearer than this to the border make the drawing fit anew.
const BORDER: f32 = 24.0;
/// Room round a fitted drawing.
const INSET: f32 = 12.0;

/// What is to be drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drawing<'a> {
    pub(crate) marks: &'a [Mark],
    pub(crate) view: &'a View,
    /// Differs whenever the marks or the view may have changed: who made them, and which.
    pub(crate) rev: (Maker, u64),
}

/// Who made a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Maker {
    /// The run of a lab.
    Run,
    /// The overview, as the image.
    Image,
    /// The overview, from outside.
    Space,
}

/// What the canvas remembers from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct Canvas {
    placement: Option<Placement>,
    /// What the placement was fitted to: the view, the canvas's size, and whose drawing.
    fitted: Option<(View, Vec2, Maker)>,
    /// Whether the user has zoomed or moved the drawing.
    moved: bool,
    figure: Option<(FigureKey, Figure)>,
    handles: Vec<Id>,
    dragging: bool,
    /// How often a figure was laid out: tests assert on it.
    pub(crate) drawn: usize,
}

/// What a figure was made of.
type FigureKey = ((Maker, u64), Placement, Vec2, ThemeName);

impl Canvas {
    /// Fits the drawing into the canvas at the next frame.
    pub(crate) fn fit(&mut self) {
        self.moved = false;
        self.placement = None;
    }

    /// The handles of the last frame.
    pub(crate) fn handles(&self) -> &[Id] {
        &self.handles
    }

    /// Whether a handle is being dragged.
    pub(crate) fn dragging(&self) -> bool {
        self.dragging
    }

    /// Shows a drawing; drags edit the document.
    pub(crate) fn show(
        &mut self,
        ui: &mut Ui,
        face: &Face<'_>,
        textures: &mut Textures,
        drawing: Drawing<'_>,
        lab: &dyn Lab,
        document: &mut Document,
        view: &mut ViewState,
    ) {
        let rect = ui.max_rect();
        // A camera of its own looks at the scene from outside: there is no plane to drag in.
        let space = drawing.rev.0 == Maker::Space;
        let handles = if space { Vec::new() } else { lab.handles(document) };
        self.place(drawing, rect.size(), &handles);
        let background = ui.interact(rect, ui.scope_id().with("canvas"), Sense::click_and_drag());
        background.widget_info(|| WidgetInfo::labeled(Part::Canvas, true, face.say("ui-canvas")));
        if space {
            turn(ui, rect, &background, view);
        } else {
            self.navigate(ui, rect, &background, drawing, view);
        }
        let Some(placement) = self.placement else { return };
        self.handles.clear();
        let before = document.clone();
        let shown: Vec<(Response, Handle)> = handles
            .into_iter()
            .enumerate()
            .filter(|(_, handle)| rect.contains(place(rect, placement, handle.at)))
            .map(|(i, handle)| {
                (self.handle(ui, rect, placement, i, &handle, drawing, lab, document, view), handle)
            })
            .collect();
        self.dragging = shown.iter().any(|(response, _)| response.dragged());
        if *document != before {
            // The run is behind by one edit; the next frame shows it.
            ui.ctx().request_repaint();
        }
        let figure = self.figure(drawing, placement, rect.size(), face);
        paint::figure(ui.painter(), textures, rect.min, figure);
        for (response, handle) in &shown {
            let at = place(rect, placement, handle.at);
            paint_handle(ui, face, response, at, handle.kind);
        }
        readout(ui, face, rect, placement, &background, drawing, space);
    }

    fn place(&mut self, drawing: Drawing<'_>, size: Vec2, handles: &[Handle]) {
        let (view, (maker, _)) = (drawing.view, drawing.rev);
        let stale = match (&self.fitted, self.placement) {
            (Some((_, _, old)), Some(_)) if *old != maker => true,
            (Some((fitted, old, _)), Some(placement)) if !self.moved => {
                let canvas = Rect::from_min_size(Pos2::ZERO, size).shrink(BORDER);
                let out =
                    handles.iter().any(|handle| !canvas.contains(Pos2::from(placement.to_points(handle.at))));
                let span = |view: &View| (view.max[0] - view.min[0]).max(view.max[1] - view.min[1]);
                let much_smaller = span(view) < 0.5 * span(fitted);
                *old != size
                    || fitted.y_up != view.y_up
                    || fitted.grid != view.grid
                    || maker != Maker::Run && fitted != view
                    || view.grid == Grid::Pixels && fitted != view
                    || !self.dragging && (out || much_smaller)
            }
            (_, Some(_)) => false,
            (_, None) => true,
        };
        if stale {
            self.placement = Some(Placement::fit(view, [size.x, size.y], INSET));
            self.fitted = Some((*view, size, maker));
            self.moved = false;
        }
    }

    /// Wheel zooms at the pointer, dragging the ground moves the drawing, a click chooses a pixel.
    fn navigate(
        &mut self,
        ui: &Ui,
        rect: Rect,
        ground: &Response,
        drawing: Drawing<'_>,
        view: &mut ViewState,
    ) {
        let Some(placement) = &mut self.placement else { return };
        if ground.dragged() {
            let by = ground.drag_delta();
            *placement = placement.pan([by.x, by.y]);
            self.moved |= by != Vec2::ZERO;
        }
        if let Some(at) = ground.hover_pos() {
            let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
            let factor = (scroll / 240.0).exp2() * pinch;
            if factor != 1.0 {
                let about = at - rect.min;
                *placement = placement.zoom(factor, [about.x, about.y]);
                self.moved = true;
            }
        }
        if let Some(at) = ground.interact_pointer_pos().filter(|_| ground.clicked() && has_pixels(drawing)) {
            view.pixel = pixel_at(*placement, rect, at);
            if drawing.rev.0 == Maker::Image {
                view.tab = Tab::Pixel;
            }
        }
    }

    #[expect(clippy::too_many_arguments, reason = "one step of `show`, cut out to be readable")]
    fn handle(
        &mut self,
        ui: &Ui,
        rect: Rect,
        placement: Placement,
        index: usize,
        handle: &Handle,
        drawing: Drawing<'_>,
        lab: &dyn Lab,
        document: &mut Document,
        view: &ViewState,
    ) -> Response {
        let at = place(rect, placement, handle.at);
        let id = ui.scope_id().with(("handle", lab.name(), index));
        let catch = Rect::from_center_size(at, Vec2::splat(2.0 * CATCH)).intersect(rect);
        let response = ui.interact(catch, id, Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Part::Slider, true, &handle.name));
        self.handles.push(id);
        let (snap, shift, alt) = ui.input(|input| (view.snap, input.modifiers.shift, input.modifiers.alt));
        let snap = if alt { Snap::Off } else { snap };
        if response.drag_started() || response.clicked() {
            response.request_focus();
        }
        if let Some(pointer) = response.interact_pointer_pos().filter(|_| response.dragged()) {
            let start = ui.input(|input| input.pointer.press_origin()).unwrap_or(pointer);
            let mut to = pointer - rect.min;
            if shift {
                let by = pointer - start;
                let origin = start - rect.min;
                to = if by.x.abs() > by.y.abs() { vec2(to.x, origin.y) } else { vec2(origin.x, to.y) };
            }
            let to = placement.to_scene([to.x, to.y]).map(|c| snap.snap(c));
            lab.drag(document, index, only(handle.kind, handle.at, to));
        }
        if response.has_focus() {
            let by = arrows(ui, drawing.view.y_up);
            if by != Vec2::ZERO {
                let step = if shift { snap.step() / 10.0 } else { snap.step() };
                let to = [handle.at[0] + by.x * step, handle.at[1] + by.y * step]
                    .map(|c| (c * 4096.0).round() / 4096.0);
                lab.drag(document, index, only(handle.kind, handle.at, to));
            }
        }
        let dragged = response.dragged();
        response.on_hover_cursor(match handle.kind {
            Kind::SideX => CursorIcon::ResizeHorizontal,
            Kind::SideY => CursorIcon::ResizeVertical,
            _ if dragged => CursorIcon::Grabbing,
            _ => CursorIcon::Grab,
        })
    }

    fn figure(&mut self, drawing: Drawing<'_>, placement: Placement, size: Vec2, face: &Face<'_>) -> &Figure {
        let key = (drawing.rev, placement, size, face.look.theme.name);
        if self.figure.as_ref().is_none_or(|(old, _)| *old != key) {
            self.drawn += 1;
            let view = View { grid: grid(drawing, placement), ..*drawing.view };
            let drawing = Drawing { view: &view, ..drawing };
            self.figure = Some((key, draw(drawing, placement, size, face.look.theme.name, face.words)));
        }
        &self.figure.as_ref().expect("made above").1
    }
}

/// Dragging turns the camera outside, with Shift or another button it moves; the wheel goes nearer.
fn turn(ui: &Ui, rect: Rect, ground: &Response, view: &mut ViewState) {
    let Some(orbit) = &mut view.orbit else { return };
    let by = ground.drag_delta();
    if ground.dragged() && by != Vec2::ZERO {
        let half = rect.height().min(rect.width()) / 2.0;
        let moves = ground.dragged_by(PointerButton::Secondary) || ui.input(|input| input.modifiers.shift);
        *orbit = if moves {
            orbit.moved([-by.x / half, by.y / half])
        } else {
            orbit.turned(-by.x * 0.008, by.y * 0.008)
        };
    }
    if ground.hovered() {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        let factor = (scroll / 240.0).exp2() * pinch;
        if factor != 1.0 {
            *orbit = orbit.nearer(factor);
        }
    }
}

/// Whether the drawing is of pixels.
fn has_pixels(drawing: Drawing<'_>) -> bool {
    drawing.view.grid == Grid::Pixels || drawing.rev.0 == Maker::Image
}

/// A large image gets its grid as soon as there is room for it.
fn grid(drawing: Drawing<'_>, placement: Placement) -> Grid {
    let large = drawing.rev.0 == Maker::Image;
    if large && placement.scale >= 5.0 { Grid::Pixels } else { drawing.view.grid }
}

/// A drawing as a figure.
pub(crate) fn draw(
    drawing: Drawing<'_>,
    placement: Placement,
    size: Vec2,
    theme: ThemeName,
    words: &Words,
) -> Figure {
    layout::draw(drawing.marks, drawing.view, &placement, [size.x, size.y], theme.theme(), words)
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

fn place(rect: Rect, placement: Placement, at: [f32; 2]) -> Pos2 {
    rect.min + Vec2::from(placement.to_points(at))
}

fn pixel_at(placement: Placement, rect: Rect, at: Pos2) -> Option<[u32; 2]> {
    let at = at - rect.min;
    let [x, y] = placement.to_scene([at.x, at.y]);
    (x >= 0.0 && y >= 0.0).then(|| [x as u32, y as u32])
}

fn paint_handle(ui: &Ui, face: &Face<'_>, response: &Response, at: Pos2, kind: Kind) {
    let (painter, look) = (ui.painter(), face.look);
    let busy = response.dragged() || response.hovered();
    let stroke = look.stroke(if busy { 3.0 } else { 2.0 }, look.text);
    let fill = if response.dragged() { look.text } else { look.canvas };
    match kind {
        Kind::Point => {
            painter.circle(at, 7.0, fill, stroke);
            painter.circle_filled(at, 2.2, look.text);
        }
        _ => {
            let square = Rect::from_center_size(at, Vec2::splat(if busy { 11.0 } else { 10.0 }));
            painter.rect(
                square,
                0,
                fill,
                Stroke::new(if busy { 2.5 } else { 1.5 }, look.text),
                StrokeKind::Middle,
            );
        }
    }
    if response.has_focus() {
        painter.circle_stroke(at, 12.0, look.focus_stroke());
    }
}

/// What lies under the pointer, at the foot of the canvas.
fn readout(
    ui: &Ui,
    face: &Face<'_>,
    rect: Rect,
    placement: Placement,
    ground: &Response,
    drawing: Drawing<'_>,
    space: bool,
) {
    if space {
        return foot(ui, face, rect, &face.say("ui-readout-space"));
    }
    let Some(at) = ui.ctx().pointer_hover_pos().filter(|at| rect.contains(*at) && ground.contains_pointer())
    else {
        return;
    };
    let [x, y] = placement.to_scene((at - rect.min).into());
    let kind = if has_pixels(drawing) { Grid::Pixels } else { drawing.view.grid };
    let message = match (kind, pixel_at(placement, rect, at)) {
        (Grid::Pixels, Some([x, y])) => face.words.message(
            &rasterscope_core::message::Message::new("ui-readout-pixel")
                .with("x", x)
                .with("y", y)
                .with("centre", [x as f32 + 0.5, y as f32 + 0.5]),
        ),
        (Grid::Pixels, None) | (Grid::None, _) => return,
        (Grid::Units, _) => {
            let round = |c: f32| (c * 100.0).round() / 100.0;
            face.say_with("ui-readout-point", "at", [round(x), round(y)])
        }
    };
    foot(ui, face, rect, &message);
}

/// One line at the foot of the canvas.
fn foot(ui: &Ui, face: &Face<'_>, rect: Rect, message: &str) {
    let font = face.look.font(Text::Listing);
    let size = ui.painter().layout_no_wrap(message.to_owned(), font.clone(), face.look.dim).size();
    let plate =
        Rect::from_min_size(pos2(rect.left() + 8.0, rect.bottom() - size.y - 12.0), size + vec2(12.0, 6.0));
    ui.painter().rect_filled(plate, 3, face.look.canvas);
    text_in(ui.painter(), plate.shrink2(vec2(6.0, 0.0)), Align2::LEFT_CENTER, message, font, face.look.dim);
}
