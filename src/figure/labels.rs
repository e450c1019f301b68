//! Labels: a name and its value in one plate that covers nothing that matters.
//!
//! A plate stands 14 points from its point: right below, left above, right above or left below,
//! the first place that meets no handle, no other plate and no line of the current step; else
//! farther off with a leader line. The name of an area stands inside it, in the colour of its object. At most twelve plates show values, beyond that names only.

use rasterscope_core::{
    explain::{Label, Role},
    message::Value,
};

use crate::{
    canvas::{Canvas, Layer, TextStyle, narrow},
    figure::{Font, Shape, Stroke},
    geometry::Rect,
    interior,
    theme::Color,
};

/// More plates than this show names only.
const WITH_VALUES: usize = 12;
/// More labels than this are not placed at all.
const LABELS: usize = 60;
/// Distance of a plate from its point.
const GAP: f64 = 14.0;
/// Height of a plate in sizes of its text.
pub(crate) const PLATE: f64 = 1.42;
/// What stays free at the canvas's sides.
const BORDER: f64 = 4.0;
/// Right below, left above, right above, left below.
const CORNERS: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];

/// What a label is attached to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Anchor {
    /// A point.
    Point([f64; 2]),
    /// The middle of a segment.
    Segment([[f64; 2]; 2]),
    /// An area: its number among those of the canvas, and its middle.
    Area(usize, [f64; 2]),
}

impl Anchor {
    fn at(self) -> [f64; 2] {
        match self {
            Self::Point(p) | Self::Area(_, p) => p,
            Self::Segment([a, b]) => crate::geometry::mix(a, b, 0.5),
        }
    }
}

/// A label that wants a place.
#[derive(Clone, Debug)]
pub(crate) struct Wish {
    pub(crate) anchor: Anchor,
    /// What it may be attached to if there is no free place at that.
    pub(crate) others: Vec<Anchor>,
    pub(crate) label: Label,
    pub(crate) role: Role,
}

/// Where one label stands.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Place {
    /// From the anchor to the plate's middle; none: the label is left out.
    offset: Option<[f64; 2]>,
    /// Whether a line leads from the anchor to the plate.
    leader: bool,
}

/// Where the labels of a drawing stand, to hold them still while something is dragged.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Places(Vec<Place>);

/// The words of a label; `true` if it is a phrase, not a name of the listing or a number.
pub(crate) fn written(canvas: &Canvas<'_>, label: &Label, with_value: bool) -> (String, bool) {
    let phrase = match &label.value {
        Value::Word(_) => true,
        Value::None => label.name.contains(' '),
        _ => false,
    };
    let value = if with_value && label.value != Value::None {
        canvas.words.value(&label.value)
    } else {
        String::new()
    };
    let space = if label.name.is_empty() || value.is_empty() { "" } else { " " };
    (format!("{}{space}{value}", label.name), phrase)
}

/// The colour of words about `role`: what is plain input is written in plain text.
pub(crate) fn color(canvas: &Canvas<'_>, role: Role) -> Color {
    match role {
        Role::Active | Role::Rejected | Role::Changed | Role::Tie | Role::Taught => {
            canvas.theme.style(role).color
        }
        _ => canvas.theme.text,
    }
}

/// Places and paints all labels; with `held`, where they stood before.
pub(crate) fn draw(canvas: &mut Canvas<'_>, wishes: &[Wish], held: Option<&Places>) -> Places {
    let held = held.filter(|held| held.0.len() == wishes.len());
    let mut order: Vec<usize> = (0..wishes.len()).collect();
    order.sort_by_key(|&i| wishes[i].role != Role::Active);
    let mut places = vec![Place::default(); wishes.len()];
    let mut plates = 0;
    for index in order.into_iter().take(LABELS) {
        let wish = &wishes[index];
        let at = wish.anchor.at();
        if !canvas.rect.contains(at) {
            continue;
        }
        let valued = wish.label.value != Value::None;
        let (text, phrase) = written(canvas, &wish.label, plates < WITH_VALUES);
        if text.is_empty() {
            continue;
        }
        plates += usize::from(valued && plates < WITH_VALUES);
        let font = match wish.anchor {
            Anchor::Segment(_) if wish.role != Role::Active => Font::Mono,
            _ if phrase => Font::SansBold,
            Anchor::Area(..) => Font::SansBold,
            _ => Font::MonoBold,
        };
        let size = match wish.anchor {
            Anchor::Area(..) if !valued => canvas.theme.sizes.title,
            _ => canvas.theme.sizes.canvas,
        };
        let style = TextStyle { text: &text, font, size, color: color(canvas, wish.role) };
        let extent = [style.measure()[0] + 12.0, f64::from(size) * PLATE];
        places[index] = match held {
            Some(held) => held.0[index],
            None => place_at_any(canvas, wish, extent),
        };
        if let Some(offset) = places[index].offset {
            let rect = Rect::around([at[0] + offset[0], at[1] + offset[1]], extent);
            if places[index].leader {
                leader(canvas, at, rect);
            }
            match wish.label.object {
                Some(object) => canvas.object_plate(rect, object, style),
                None => canvas.plate(rect, canvas.theme.canvas.alpha(0.9), None, style),
            }
            canvas.kept_clear.push(rect);
        }
    }
    Places(places)
}

/// The first place that covers nothing at all, at any of the anchors; else what there is at the first.
fn place_at_any(canvas: &Canvas<'_>, wish: &Wish, size: [f64; 2]) -> Place {
    let at = wish.anchor.at();
    let first = place(canvas, wish.anchor, size);
    let clear = |anchor: Anchor, place: &Place| {
        let [x, y] = anchor.at();
        let rect = place.offset.map(|offset| Rect::around([x + offset[0], y + offset[1]], size));
        !place.leader && rect.is_some_and(|rect| free(canvas, rect, true))
    };
    if wish.others.is_empty() || clear(wish.anchor, &first) {
        return first;
    }
    let others = wish.others.iter().map(|&anchor| (anchor, place(canvas, anchor, size)));
    let found = others.into_iter().find(|(anchor, place)| clear(*anchor, place));
    let Some((anchor, Place { offset: Some(offset), .. })) = found else { return first };
    let from = [0, 1].map(|axis| anchor.at()[axis] - at[axis] + offset[axis]);
    Place { offset: Some(from), leader: false }
}

/// The first place that is free.
fn place(canvas: &Canvas<'_>, anchor: Anchor, size: [f64; 2]) -> Place {
    let at = anchor.at();
    if let Anchor::Area(index, _) = anchor
        && let Some([x, y]) =
            interior::place(&canvas.areas, index, size, |rect, strictly| free(canvas, rect, strictly))
    {
        return Place { offset: Some([x - at[0], y - at[1]]), leader: false };
    }
    let mut near = near(anchor, size);
    for offset in near.iter_mut().filter(|offset| offset[1].abs() > GAP) {
        // Above or below its point a plate may slide to stay on the canvas.
        let bound = BORDER + size[0] / 2.0;
        let far = (canvas.rect.max[0] - bound).max(bound);
        offset[0] = (at[0] + offset[0]).clamp(bound, far) - at[0];
    }
    let rect = |offset: [f64; 2]| Rect::around([at[0] + offset[0], at[1] + offset[1]], size);
    let free = near.iter().find(|&&offset| free(canvas, rect(offset), true));
    if let Some(&offset) =
        free.or_else(|| near.iter().find(|&&offset| self::free(canvas, rect(offset), false)))
    {
        return Place { offset: Some(offset), leader: false };
    }
    for distance in [34.0, 56.0, 84.0, 120.0, 170.0] {
        for [x, y] in [
            [1.0, 0.5],
            [-1.0, -0.5],
            [1.0, -0.5],
            [-1.0, 0.5],
            [0.0, 1.0],
            [0.0, -1.0],
            [1.0, 0.0],
            [-1.0, 0.0],
        ] {
            let offset = [x * (distance + size[0] / 2.0), y * (distance + size[1] / 2.0)];
            if self::free(canvas, rect(offset), false) {
                return Place { offset: Some(offset), leader: true };
            }
        }
    }
    Place::default()
}

/// Offsets of a plate that need no leader line, best first.
fn near(anchor: Anchor, [width, height]: [f64; 2]) -> Vec<[f64; 2]> {
    let mut offsets = Vec::new();
    let mut around = |gap: f64| {
        // Beside the point, then diagonally away from it, then above and below.
        offsets.extend(CORNERS.map(|[x, y]| [x * (gap + width / 2.0), y * 6.0]));
        offsets.extend(CORNERS.map(|[x, y]| [x * (gap * 0.6 + width / 2.0), y * (gap + 2.0 + height / 2.0)]));
        offsets.extend([1.0, -1.0].map(|y| [0.0, y * (gap + 2.0 + height / 2.0)]));
    };
    match anchor {
        Anchor::Point(_) => around(GAP),
        // Beside an area a name would be read as that of another: a line must lead to it.
        Anchor::Area(..) => {}
        Anchor::Segment([a, b]) => {
            let length = crate::geometry::distance(a, b).max(1e-9);
            let normal = [(a[1] - b[1]) / length, (b[0] - a[0]) / length];
            let reach = 6.0 + (normal[0].abs() * width + normal[1].abs() * height) / 2.0;
            // Beside the middle, then beside other parts of it.
            for t in [0.0, -0.15, 0.15, -0.3, 0.3] {
                let [x, y] = [t * (b[0] - a[0]), t * (b[1] - a[1])];
                offsets.extend([reach, -reach].map(|reach| [x + normal[0] * reach, y + normal[1] * reach]));
            }
            offsets.extend(CORNERS.map(|[x, y]| [x * (6.0 + width / 2.0), y * (6.0 + height / 2.0)]));
        }
    }
    offsets
}

/// Whether a plate may stand there; `strictly`: clear also of what it might cover if need be.
fn free(canvas: &Canvas<'_>, rect: Rect, strictly: bool) -> bool {
    let covers = |rects: &[Rect]| rects.iter().any(|other| other.overlaps(rect));
    let near = rect.grown(3.0);
    if !rect.inside(canvas.rect.grown(-BORDER))
        || covers(&canvas.kept_clear)
        || canvas.active_lines.iter().any(|&ends| near.clip(ends).is_some())
    {
        return false;
    }
    let crosses = || canvas.lines.iter().any(|&ends| rect.clip(ends).is_some());
    !strictly || !(covers(&canvas.small) || crosses())
}

/// From the anchor to the nearest point of the plate.
fn leader(canvas: &mut Canvas<'_>, at: [f64; 2], plate: Rect) {
    let to = [0, 1].map(|axis| at[axis].clamp(plate.min[axis], plate.max[axis]));
    let stroke = Stroke::solid(canvas.theme.dim, 1.0 + canvas.theme.extra_stroke);
    let points = vec![narrow(at), narrow(to)];
    canvas.push(Layer::Outline, Shape::Line { points, closed: false, stroke });
}

/// The plate of a guide at the canvas's left or lower side; the opposite one if that is taken.
pub(crate) fn guide(canvas: &mut Canvas<'_>, axis: usize, at: f64, label: &Label, role: Role) {
    let theme = canvas.theme;
    let (text, _) = written(canvas, label, true);
    let active = role == Role::Active;
    let font = if active { Font::MonoBold } else { Font::Mono };
    let style = TextStyle { text: &text, font, size: theme.sizes.canvas, color: color(canvas, role) };
    let extent = [style.measure()[0] + 12.0, f64::from(theme.sizes.canvas) * PLATE];
    let far = canvas.rect.max;
    let centers = if axis == 0 {
        [[at, far[1] - 6.0 - extent[1] / 2.0], [at, 6.0 + extent[1] / 2.0]]
    } else {
        [[5.0 + extent[0] / 2.0, at], [far[0] - 5.0 - extent[0] / 2.0, at]]
    };
    let plates = centers.map(|center| Rect::around(center, extent));
    let fits = |rect: &&Rect| {
        rect.inside(canvas.rect.grown(-2.0)) && !canvas.kept_clear.iter().any(|other| other.overlaps(**rect))
    };
    let Some(&rect) = plates.iter().find(fits) else { return };
    let lit = if active { (theme.lit, theme.style(role).color) } else { (theme.panel, theme.line) };
    canvas.plate(rect, lit.0, Some(lit.1), style);
    canvas.kept_clear.push(rect);
}
