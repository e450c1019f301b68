//! The canvas: the drawing of the step, handles to drag, zoom, pan, and the readout.

use super::{
    halo,
    handles::{self, Plane},
    outside::{self, Outside},
};
use crate::{
    document::{Snap, Tab, ViewState},
    face::Face,
    labs::{Handle, Open, SolidHandle},
    overview::Hover,
    paint::{self, Textures},
    theme::Text,
    widgets::{focus_ring, text_in},
};
use egui::{Align2, Id, Pos2, Rect, Response, Role as Part, Sense, Ui, Vec2, WidgetInfo, pos2, vec2};
use rasterscope_core::{
    explain::{Grid, Mark, Vantage, View},
    message::{Message, Value},
};
use rasterscope_figure::{
    figure::Figure,
    layout::{self, Placement, Places},
    orbit::Orbit,
    space,
    theme::ThemeName,
};

/// Handles nearer than this to the border make the drawing fit anew.
const BORDER: f32 = 24.0;
/// Room round a fitted drawing.
pub(crate) const INSET: f32 = 12.0;

/// What is to be drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drawing<'a> {
    pub(crate) marks: &'a [Mark],
    pub(crate) view: &'a View,
    /// From where a drawing in space is seen first.
    pub(crate) vantage: Option<&'a Vantage>,
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
    figure: Option<(FigureKey, Figure, Places)>,
    handles: Vec<Id>,
    dragging: bool,
    outside: Outside,
    /// The pixel under the pointer in the last frame.
    pub(crate) hovered: Option<[u32; 2]>,
    /// How often a figure was laid out: tests assert on it.
    pub(crate) drawn: usize,
}

/// What a figure was made of.
type FigureKey = ((Maker, u64), Placement, Option<Orbit>, Vec2, ThemeName, bool);

impl Canvas {
    /// Fits the drawing into the canvas at the next frame.
    pub(crate) fn fit(&mut self) {
        self.moved = false;
        self.placement = None;
        self.outside.fit();
    }

    /// The handles of the last frame.
    pub(crate) fn handles(&self) -> &[Id] {
        &self.handles
    }

    /// The drawing of the last frame.
    pub(crate) fn last_figure(&self) -> Option<&Figure> {
        self.figure.as_ref().map(|(_, figure, _)| figure)
    }

    /// The size of the drawing of the last frame.
    pub(crate) fn size(&self) -> Option<Vec2> {
        self.figure.as_ref().map(|((_, _, _, size, ..), ..)| *size)
    }

    /// The camera outside through which the drawing of the last frame was seen.
    pub(crate) fn camera(&self) -> Option<Orbit> {
        self.figure.as_ref().and_then(|((_, _, camera, ..), ..)| *camera)
    }

    /// Where the run's drawing lies, if it is on the canvas.
    pub(crate) fn placement_of_run(&self) -> Option<Placement> {
        let of_run = matches!(self.fitted, Some((_, _, Maker::Run)));
        self.placement.filter(|_| of_run)
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
        open: &mut Open<'_>,
        hover: Option<&Hover>,
    ) {
        let rect = ui.max_rect();
        // The overview's camera outside looks at the scene: there is nothing to drag.
        let overview = drawing.rev.0 == Maker::Space;
        let camera =
            drawing.vantage.map(|first| self.outside.camera(first, open.view.outside, self.dragging));
        let solid = if camera.is_some() { open.lab.solid_handles(open.document) } else { Vec::new() };
        let handles = match camera {
            Some(camera) => outside::project(&solid, &camera),
            None if overview => Vec::new(),
            None => open.lab.handles(open.document),
        };
        self.place(drawing, rect.size(), &handles);
        let background = ui.interact(rect, ui.scope_id().with("canvas"), Sense::click_and_drag());
        background.widget_info(|| WidgetInfo::labeled(Part::Canvas, true, face.say("ui-canvas")));
        if let Some(camera) = camera {
            if let Some(turned) = outside::turn(ui, rect, &background, camera) {
                open.view.outside = Some(turned);
                ui.ctx().request_repaint();
            }
        } else if let (true, Some(orbit)) = (overview, &mut open.view.orbit) {
            *orbit = outside::turn(ui, rect, &background, *orbit).unwrap_or(*orbit);
        } else if !overview {
            self.navigate(ui, rect, &background, drawing, open.view);
        }
        let Some(placement) = self.placement else { return };
        let plane = Plane { rect, placement, y_up: drawing.view.y_up };
        let shown = self.move_handles(ui, &plane, &handles, camera.map(|camera| (camera, &solid[..])), open);
        let flat = !overview && camera.is_none();
        let on =
            ui.ctx().pointer_hover_pos().filter(|at| flat && rect.contains(*at) && ui.ui_contains_pointer());
        let thing = on.and_then(|at| halo::pointed(&plane, drawing.marks, drawing.view, at));
        thing.into_iter().for_each(|thing| face.links.point_at(thing));
        halo::under(ui.painter(), face, &plane, drawing.marks);
        let figure = self.figure(drawing, camera, placement, rect.size(), face);
        paint::figure(ui.painter(), textures, rect.min, figure);
        if on.is_none() {
            halo::over(ui.painter(), face, &plane, drawing.view);
        }
        for (response, handle) in &shown {
            handles::paint(ui, face, response, plane.place(handle.at), handle.kind);
        }
        focus_ring(ui, &background, rect.shrink(1.0), face.look);
        self.hovered = readout(ui, face, &plane, &background, drawing, hover);
    }

    /// Lets every handle be moved; what moves edits the document.
    fn move_handles<'h>(
        &mut self,
        ui: &Ui,
        plane: &Plane,
        handles: &'h [Handle],
        solid: Option<(Orbit, &[SolidHandle])>,
        open: &mut Open<'_>,
    ) -> Vec<(Response, &'h Handle)> {
        self.handles.clear();
        let mut shown = Vec::with_capacity(handles.len());
        for (index, handle) in handles.iter().enumerate() {
            if !plane.rect.contains(plane.place(handle.at)) {
                continue;
            }
            let id = ui.scope_id().with(("handle", open.lab.name(), index));
            self.handles.push(id);
            let snap = if solid.is_some() { Snap::Off } else { open.view.snap };
            let (response, moved) = handles::interact(ui, plane, id, handle, snap);
            if let Some(to) = moved.filter(|to| *to != handle.at) {
                match solid {
                    Some((orbit, solid)) => {
                        let free = ui.input(|input| input.modifiers.alt);
                        let snap = if free { Snap::Off } else { open.view.snap };
                        let how = (response.dragged(), snap);
                        let to = self.outside.moved(&orbit, &solid[index], to, how);
                        open.lab.drag_solid(open.document, index, to);
                    }
                    None => open.lab.drag(open.document, index, to),
                }
                // The run is behind by one edit; the next frame shows it.
                ui.ctx().request_repaint();
            }
            shown.push((response, handle));
        }
        self.dragging = shown.iter().any(|(response, _)| response.dragged());
        if !self.dragging {
            self.outside.released();
        }
        shown
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
            view.pixel = pixel_at(&Plane { rect, placement: *placement, y_up: drawing.view.y_up }, at);
            if drawing.rev.0 == Maker::Image {
                view.tab = Tab::Pixel;
            }
        }
    }

    fn figure(
        &mut self,
        drawing: Drawing<'_>,
        camera: Option<Orbit>,
        placement: Placement,
        size: Vec2,
        face: &Face<'_>,
    ) -> &Figure {
        let theme = face.look.theme;
        let key = (drawing.rev, placement, camera, size, theme.name, self.dragging);
        if self.figure.as_ref().is_none_or(|(old, ..)| *old != key) {
            self.drawn += 1;
            let view = View { grid: grid(drawing, placement), ..*drawing.view };
            // Labels stay where they are while something is dragged, so that they do not jump.
            let held = self.figure.take().filter(|_| self.dragging).map(|(_, _, places)| places);
            let (size, words) = ([size.x, size.y], (theme, face.words));
            let marks = space::seen(drawing.marks, drawing.vantage, camera.as_ref());
            let (figure, places) = layout::draw_held(&marks, &view, &placement, size, words, held.as_ref());
            self.figure = Some((key, figure, places));
        }
        &self.figure.as_ref().expect("made above").1
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

fn pixel_at(plane: &Plane, at: Pos2) -> Option<[u32; 2]> {
    let [x, y] = plane.point(at);
    (x >= 0.0 && y >= 0.0).then_some([x as u32, y as u32])
}

/// What lies under the pointer, at the foot of the canvas; returns the pixel there.
fn readout(
    ui: &Ui,
    face: &Face<'_>,
    plane: &Plane,
    ground: &Response,
    drawing: Drawing<'_>,
    known: Option<&Hover>,
) -> Option<[u32; 2]> {
    if drawing.rev.0 == Maker::Space || drawing.vantage.is_some() {
        foot(ui, face, plane.rect, &face.say("ui-readout-space"), false);
        return None;
    }
    let hover = ui.ctx().pointer_hover_pos();
    let at = hover.filter(|at| plane.rect.contains(*at) && ground.contains_pointer())?;
    if !has_pixels(drawing) {
        if drawing.view.grid == Grid::Units {
            let at = plane.point(at).map(|c| (c * 100.0).round() / 100.0);
            let text = face.words.message(&Message::new("ui-readout-point").with("at", at));
            foot(ui, face, plane.rect, &text, false);
        }
        return None;
    }
    let pixel = pixel_at(plane, at)?;
    let [x, y] = pixel;
    let centre = [x as f32 + 0.5, y as f32 + 0.5];
    let place = Message::new("ui-readout-pixel").with("x", x).with("y", y).with("centre", centre);
    let mut line = face.words.message(&place);
    if let Some(known) = known.filter(|known| known.pixel == pixel) {
        line = format!("{line}  {}", known.text);
    } else if let Some(value) = value_at(drawing.marks, pixel) {
        line = format!("{line}  {}", face.say_with("ui-readout-value", "value", value));
    }
    let legend = drawing.marks.iter().any(|mark| matches!(mark, Mark::Key { .. }));
    foot(ui, face, plane.rect, &line, legend);
    Some(pixel)
}

/// The value that a drawing has at a pixel.
fn value_at(marks: &[Mark], pixel: [u32; 2]) -> Option<Value> {
    let here = |mark: &Mark| match mark {
        Mark::Pixel { at, value, .. } if at.map(i64::from) == pixel.map(i64::from) => Some(value.clone()),
        _ => None,
    };
    marks.iter().rev().find_map(here).filter(|value| *value != Value::None)
}

/// One line at the foot of the canvas; it takes the whole width where a legend has its place.
fn foot(ui: &Ui, face: &Face<'_>, rect: Rect, message: &str, whole: bool) {
    let room = rect.width() - 28.0;
    let measure = |text| {
        let font = face.look.font(text);
        (ui.painter().layout_no_wrap(message.to_owned(), font.clone(), face.look.dim).size(), font)
    };
    let (size, font) = Some(measure(Text::Listing))
        .filter(|(size, _)| size.x <= room)
        .unwrap_or_else(|| measure(Text::SmallMono));
    let right = if whole { rect.right() } else { rect.left() + size.x.min(room) + 28.0 };
    let plate = Rect::from_min_max(
        pos2(rect.left(), rect.bottom() - size.y - 14.0),
        pos2(right, rect.bottom() - if whole { 0.0 } else { 4.0 }),
    );
    ui.painter().rect_filled(plate, 0, face.look.canvas);
    text_in(ui.painter(), plate.shrink2(vec2(14.0, 0.0)), Align2::LEFT_CENTER, message, font, face.look.dim);
}
