//! The canvas: the drawing of the step, handles to drag, zoom, pan, and the readout.

use super::{
    halo,
    handles::{self, Plane},
    outside::{self, Outside},
    readout::{self, readout},
};
use crate::{
    document::{Snap, Tab, ViewState},
    face::Face,
    labs::{Handle, Open, SolidHandle},
    overview::Hover,
    paint::{self, Textures},
    widgets::focus_ring,
};
use egui::{Id, Pos2, Rect, Response, Role as Part, Sense, Ui, Vec2, WidgetInfo};
use rasterscope_core::{
    compare::{Difference, Fact, Side},
    explain::{Grid, Mark, Vantage, View},
    message::Value,
    pipeline::Overlay,
};
use rasterscope_figure::{
    figure::Figure,
    layout::{self, Placement, Places},
    orbit::Orbit,
    space, split,
    theme::ThemeName,
};

/// Handles nearer than this to the border make the drawing fit anew.
const BORDER: f32 = 24.0;
/// A click nearer than this to a point of the result chooses it.
const NEAR: f32 = 24.0;
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
    /// What it is compared with, if it is one of two.
    pub(crate) compared: Option<Compared<'a>>,
    /// The pixel that the inspector explains, if it is to be outlined.
    pub(crate) chosen: Option<[u32; 2]>,
}

/// What a drawing is compared with.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Compared<'a> {
    pub(crate) side: Side,
    /// All parts of this side's result.
    pub(crate) facts: &'a [Fact],
    /// What differs, once both results are there.
    pub(crate) difference: Option<&'a Difference>,
    /// The part that is explained.
    pub(crate) chosen: Option<&'a Fact>,
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
type FigureKey = ((Maker, u64), Placement, Option<Orbit>, Vec2, ThemeName, bool, Option<Fact>);

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

    /// Where the drawing lies.
    pub(crate) fn placement(&self) -> Option<Placement> {
        self.placement
    }

    /// Lays the drawing of a view beside that of another canvas, and looks through its camera.
    pub(crate) fn follow(&mut self, other: &Self, placement: Placement, view: View, size: Vec2) {
        self.placement = Some(placement);
        self.fitted = Some((view, size, Maker::Run));
        self.moved = true;
        self.outside.follow(&other.outside);
    }

    /// Takes over where the user moved the drawing on another canvas.
    pub(crate) fn moved_to(&mut self, placement: Placement) {
        self.placement = Some(placement);
        self.moved = true;
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
        let mut handles = match camera {
            Some(camera) => outside::project(&solid, &camera),
            None if overview => Vec::new(),
            None => open.lab.handles(open.document),
        };
        if drawing.compared.is_some_and(|compared| compared.side == Side::B) {
            // Every handle is there twice.
            for handle in &mut handles {
                handle.name = face.say_with("ui-split-handle", "name", Value::text(&handle.name));
            }
        }
        let foot = if overview || drawing.vantage.is_some() { readout::height(face) } else { 0.0 };
        self.place(drawing, (rect.size(), foot), &handles);
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
        let here = background.contains_pointer() || shown.iter().any(|(at, _)| at.contains_pointer());
        let on = ui.ctx().pointer_hover_pos().filter(|at| !overview && here && rect.contains(*at));
        // Marks in space are looked for only while somebody points at something.
        let pointed = on.is_some() || face.links.now().is_some();
        let marks = space::seen(drawing.marks, drawing.vantage.filter(|_| pointed), camera.as_ref());
        let thing = on.and_then(|at| halo::pointed(&plane, &marks, drawing.view, at));
        thing.into_iter().for_each(|thing| face.links.point_at(thing));
        halo::under(ui.painter(), face, &plane, &marks);
        let figure = self.figure(drawing, camera, placement, rect.size(), face);
        paint::figure(ui.painter(), textures, rect.min, figure);
        let pixel = on.and_then(|at| pixel_at(&plane, at));
        let under =
            hover.filter(|hover| Some(hover.pixel) == pixel).and_then(|hover| hover.triangle.as_ref());
        if let Some((corners, name)) = under.filter(|_| open.view.overlay == Overlay::Triangle) {
            halo::triangle(ui.painter(), face, &plane, corners, name);
        }
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

    /// Fits the drawing into the canvas above its foot, which belongs to the readout.
    fn place(&mut self, drawing: Drawing<'_>, (size, foot): (Vec2, f32), handles: &[Handle]) {
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
            self.placement = Some(Placement::fit(view, [size.x, size.y - foot], INSET));
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
        if let (Some(compared), Some(at)) =
            (drawing.compared, ground.interact_pointer_pos().filter(|_| ground.clicked()))
        {
            let plane = Plane { rect, placement: *placement, y_up: drawing.view.y_up };
            let clicked = if has_pixels(drawing) {
                pixel_at(&plane, at).map(|pixel| Fact::pixel(pixel, Vec::new()))
            } else {
                let distance = |fact: &Fact| fact.at.map(|place| plane.place(place).distance(at));
                let points = compared.facts.iter().filter_map(|fact| Some((distance(fact)?, fact)));
                let nearest = points.min_by(|a, b| a.0.total_cmp(&b.0));
                nearest.filter(|(distance, _)| *distance <= NEAR).map(|(_, fact)| fact.clone())
            };
            view.part = clicked.or_else(|| view.part.take());
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
        let pixel = drawing.chosen.map(|pixel| Fact::pixel(pixel, Vec::new()));
        let chosen = drawing.compared.and_then(|compared| compared.chosen).or(pixel.as_ref());
        let key = (drawing.rev, placement, camera, size, theme.name, self.dragging, chosen.cloned());
        if self.figure.as_ref().is_none_or(|(old, ..)| *old != key) {
            self.drawn += 1;
            let view = View { grid: grid(drawing, placement), ..*drawing.view };
            // Labels stay where they are while something is dragged, so that they do not jump.
            let held = self.figure.take().filter(|_| self.dragging).map(|(_, _, places)| places);
            let (size, words) = ([size.x, size.y], (theme, face.words));
            let marks = space::seen(drawing.marks, drawing.vantage, camera.as_ref());
            let (mut figure, places) =
                layout::draw_held(&marks, &view, &placement, size, words, held.as_ref());
            if let Some(Compared { side, difference: Some(difference), .. }) = drawing.compared {
                split::outline(&mut figure, difference, side, &placement, theme);
            }
            if let Some(chosen) = chosen {
                split::choose(&mut figure, chosen, &placement, theme);
            }
            self.figure = Some((key, figure, places));
        }
        &self.figure.as_ref().expect("made above").1
    }
}

/// Whether the drawing is of pixels.
pub(super) fn has_pixels(drawing: Drawing<'_>) -> bool {
    drawing.view.grid == Grid::Pixels || drawing.rev.0 == Maker::Image
}

/// A large image gets its grid as soon as there is room for it.
fn grid(drawing: Drawing<'_>, placement: Placement) -> Grid {
    let large = drawing.rev.0 == Maker::Image;
    if large && placement.scale >= 5.0 { Grid::Pixels } else { drawing.view.grid }
}

pub(super) fn pixel_at(plane: &Plane, at: Pos2) -> Option<[u32; 2]> {
    let [x, y] = plane.point(at);
    (x >= 0.0 && y >= 0.0).then_some([x as u32, y as u32])
}
