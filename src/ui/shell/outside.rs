//! The camera outside: how a drawing in space is turned, and how its points are dragged.
//!
//! A point is dragged in the plane through it that is parallel to the picture. The camera is part of
//! the view: turning it edits nothing and runs nothing.

use crate::{
    document::Snap,
    labs::{Handle, Kind, SolidHandle},
};
use egui::{PointerButton, Rect, Response, Ui, Vec2};
use rasterscope_core::explain::Vantage;
use rasterscope_figure::orbit::Orbit;

/// Points farther from the middle of the picture than this make it fit anew.
const BORDER: f32 = 1.3;

/// What the canvas remembers of a drawing in space from frame to frame.
#[derive(Debug, Default)]
pub(super) struct Outside {
    /// The camera until the user turns it.
    first: Option<Orbit>,
    /// How far away the dragged point was when the drag began.
    depth: Option<f32>,
}

impl Outside {
    /// Looks from the vantage again.
    pub(super) fn fit(&mut self) {
        *self = Self::default();
    }

    /// The camera of this frame: as turned, else one that sees all; it rests during a drag, and as long
    /// as all stays in the picture.
    pub(super) fn camera(&mut self, vantage: &Vantage, turned: Option<Orbit>, dragging: bool) -> Orbit {
        if let Some(orbit) = turned {
            return orbit;
        }
        let sees = |orbit: &Orbit| {
            let inside = |at: [f32; 2]| at.iter().all(|c| c.abs() <= BORDER);
            vantage.points.iter().all(|&point| orbit.project(point).is_some_and(inside))
        };
        match self.first {
            Some(orbit) if dragging || sees(&orbit) => orbit,
            _ => *self.first.insert(Orbit::first(vantage)),
        }
    }

    /// Where a moved handle now is in space.
    pub(super) fn moved(
        &mut self,
        orbit: &Orbit,
        handle: &SolidHandle,
        to: [f32; 2],
        (dragged, snap): (bool, Snap),
    ) -> [f32; 3] {
        let now = orbit.depth(handle.at);
        let depth = if dragged { *self.depth.get_or_insert(now) } else { now };
        orbit.unproject(to, depth).map(|c| match snap {
            Snap::Off => Snap::Off.snap(c),
            Snap::Half | Snap::Centre => (c * 4.0).round() / 4.0 + 0.0,
        })
    }

    /// Looks from where another canvas does until the user turns the camera.
    pub(super) fn follow(&mut self, other: &Self) {
        self.first = other.first;
    }

    /// No handle is dragged in this frame.
    pub(super) fn released(&mut self) {
        self.depth = None;
    }
}

/// The handles as the camera sees them; one that it does not see has no place.
pub(super) fn project(handles: &[SolidHandle], orbit: &Orbit) -> Vec<Handle> {
    let see = |handle: &SolidHandle| Handle {
        name: handle.name.clone(),
        at: orbit.project(handle.at).unwrap_or([f32::NAN; 2]),
        kind: Kind::Point,
    };
    handles.iter().map(see).collect()
}

/// Dragging turns the camera, with Shift or another button it moves; the wheel goes nearer. Answers
/// the camera if it has changed.
pub(super) fn turn(ui: &Ui, rect: Rect, ground: &Response, orbit: Orbit) -> Option<Orbit> {
    let mut turned = orbit;
    let by = ground.drag_delta();
    if ground.dragged() && by != Vec2::ZERO {
        let half = rect.height().min(rect.width()) / 2.0;
        let moves = ground.dragged_by(PointerButton::Secondary) || ui.input(|input| input.modifiers.shift);
        turned = if moves {
            turned.moved([-by.x / half, by.y / half])
        } else {
            turned.turned(-by.x * 0.008, by.y * 0.008)
        };
    }
    if ground.hovered() {
        let (scroll, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
        let factor = (scroll / 240.0).exp2() * pinch;
        if factor != 1.0 {
            turned = turned.nearer(factor);
        }
    }
    (turned != orbit).then_some(turned)
}
