//! The pipeline as a strip: every stage with what comes out of it and what it skipped.

use crate::{
    face::{Command, Face},
    paint::{self, Textures},
    theme::Text,
    widgets::{chevron, focus_ring, text_in},
};
use egui::{Align2, Rect, Response, Role as Part, Sense, Stroke, StrokeKind, Ui, WidgetInfo, pos2, vec2};
use rasterscope_core::{explain::Role, labs::Stage};
use rasterscope_figure::figure::Figure;

/// One stage as the ribbon shows it.
#[derive(Clone, Debug)]
pub(crate) struct Chip {
    /// Which stage.
    pub(crate) stage: Stage,
    /// How many come out; `None`: the stage is off.
    pub(crate) count: Option<String>,
    /// What is counted.
    pub(crate) unit: String,
    /// What was skipped and why, the most frequent reason first.
    pub(crate) skipped: Vec<String>,
    /// What comes out, as a picture of 36 by 24 points.
    pub(crate) thumbnail: Option<Figure>,
}

/// How the ribbon is laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Shape {
    /// With pictures and skips.
    Tall,
    /// Names and counts.
    Flat,
    /// The stages round the current one, in a narrow window.
    Path,
}

impl Shape {
    /// The ribbon's height.
    pub(crate) fn height(self) -> f32 {
        if self == Self::Tall { 84.0 } else { 44.0 }
    }
}

/// Shows the ribbon.
pub(crate) fn show(
    ui: &mut Ui,
    face: &Face<'_>,
    textures: &mut Textures,
    shape: Shape,
    chips: &[Chip],
    current: Stage,
) {
    let rect = ui.max_rect();
    if shape == Shape::Path {
        return path(ui, face, chips, current);
    }
    let width = (rect.width() - 16.0) / chips.len().max(1) as f32;
    for (i, chip) in chips.iter().enumerate() {
        let at = Rect::from_min_size(
            pos2(rect.left() + 8.0 + i as f32 * width, rect.top()),
            vec2(width, rect.height()),
        );
        let response = press(ui, face, at, chip);
        let chosen = chip.stage == current;
        if chosen || response.hovered() {
            ui.painter().rect_filled(at, 0, if chosen { face.look.raised } else { face.look.field });
        }
        if i > 0 {
            let y = if shape == Shape::Tall { rect.top() + 38.0 } else { rect.center().y - 2.0 };
            chevron(ui.painter(), pos2(at.left(), y), face.look.stroke(1.0, face.look.dim));
        }
        match shape {
            Shape::Tall => {
                tall(ui, face, textures, at, chip, chosen);
                let right = chips.get(i + 1);
                skipped(ui, face, at, chip, right.is_some_and(|chip| chip.skipped.is_empty()));
            }
            _ => flat(ui, face, at, chip, chosen),
        }
        if chosen {
            let foot = Rect::from_min_max(pos2(at.left(), at.bottom() - 3.0), at.max);
            ui.painter().rect_filled(foot, 0, face.look.text);
        }
        focus_ring(ui, &response, at.shrink(1.0), face.look);
    }
}

fn press(ui: &Ui, face: &Face<'_>, at: Rect, chip: &Chip) -> Response {
    let response = ui.interact(at, ui.scope_id().with(chip.stage as usize), Sense::click());
    let name = face.say(chip.stage.word());
    let count = chip.count.clone().unwrap_or_else(|| face.say("ui-stage-off"));
    response
        .widget_info(|| WidgetInfo::labeled(Part::Button, true, format!("{name}: {count} {}", chip.unit)));
    if response.clicked() {
        face.ask(Command::Stage(chip.stage));
    }
    let meaning = face.words.meaning(chip.stage.word()).unwrap_or_default();
    let mut all = format!("{meaning}\n{}", line(face, chip));
    if !chip.skipped.is_empty() {
        all = format!("{all}\n{}", chip.skipped.join(", "));
    }
    response.on_hover_text(all)
}

fn colors(face: &Face<'_>, chip: &Chip, chosen: bool) -> [egui::Color32; 2] {
    let look = face.look;
    match (chosen, chip.count.is_some()) {
        (true, _) => [look.text, look.text],
        (_, true) => [look.text, look.dim],
        _ => [look.faint, look.faint],
    }
}

fn tall(ui: &Ui, face: &Face<'_>, textures: &mut Textures, at: Rect, chip: &Chip, chosen: bool) {
    let (painter, look) = (ui.painter(), face.look);
    let [ink, dim] = colors(face, chip, chosen);
    let left = at.left() + 9.0;
    let row = |y: f32, height: f32| {
        Rect::from_min_max(pos2(left, at.top() + y), pos2(at.right() - 4.0, at.top() + y + height))
    };
    let name = face.say(chip.stage.word());
    let font = name_font(ui, face, &name, row(3.0, 20.0).width(), chosen);
    text_in(painter, row(3.0, 20.0), Align2::LEFT_CENTER, &name, font, ink);
    let frame = Rect::from_min_size(pos2(left, at.top() + 26.0), vec2(36.0, 24.0));
    painter.rect_filled(frame, 0, look.canvas);
    if let Some(figure) = &chip.thumbnail {
        paint::figure(painter, textures, frame.min, figure);
    }
    painter.rect_stroke(frame, 0, Stroke::new(1.0, look.line), StrokeKind::Outside);
    let beside = |y: f32| {
        Rect::from_min_max(pos2(left + 42.0, at.top() + y), pos2(at.right() - 1.0, at.top() + y + 18.0))
    };
    let off = face.say("ui-stage-off");
    match &chip.count {
        Some(count) => {
            let (count, font) = fitting(ui, face, count, beside(22.0).width());
            text_in(painter, beside(22.0), Align2::LEFT_CENTER, &count, font, ink);
            let unit = beside(37.0).with_max_x(at.right() + 6.0);
            text_in(painter, unit, Align2::LEFT_CENTER, &chip.unit, look.font(Text::Small), look.dim);
        }
        None => text_in(painter, beside(29.0), Align2::LEFT_CENTER, &off, look.font(Text::Listing), dim),
    }
}

/// What was skipped, at the foot; it may end in the place of a right neighbour that has nothing to say.
fn skipped(ui: &Ui, face: &Face<'_>, at: Rect, chip: &Chip, right_free: bool) {
    let Some(most) = chip.skipped.first() else { return };
    let (painter, color) = (ui.painter(), face.look.role(Role::Rejected));
    let left = at.left() + 23.0;
    let end = at.right() + if right_free { 60.0 } else { 2.0 };
    // All reasons if there is room for them, else the most frequent one, else its number alone.
    let short = in_thousands(face, most);
    let number = in_thousands(face, most.split(char::is_alphabetic).next().unwrap_or_default().trim());
    let ways = [chip.skipped.join(", "), most.clone(), short.clone(), number];
    let font = face.look.font(Text::Small);
    let fits =
        |text: &&String| painter.layout_no_wrap((*text).clone(), font.clone(), color).size().x <= end - left;
    let text = ways.iter().find(fits).unwrap_or(&short);
    let y = at.top() + 67.0;
    paint::marker(painter, pos2(left - 9.0, y), Role::Rejected, 8.0, face.look);
    let room = Rect::from_min_max(pos2(left, y - 9.0), pos2(end, y + 9.0));
    text_in(painter, room, Align2::LEFT_CENTER, text, font, color);
}

/// The largest of some fonts in which a text fits; the last one if none does.
fn largest(ui: &Ui, face: &Face<'_>, text: &str, width: f32, fonts: &[Text]) -> (egui::FontId, bool) {
    let fits = |font: &egui::FontId| {
        ui.painter().layout_no_wrap(text.to_owned(), font.clone(), face.look.text).size().x <= width
    };
    let fonts: Vec<_> = fonts.iter().map(|text| face.look.font(*text)).collect();
    match fonts.iter().find(|font| fits(font)) {
        Some(font) => (font.clone(), true),
        None => (fonts[fonts.len() - 1].clone(), false),
    }
}

/// The font of a stage's name.
fn name_font(ui: &Ui, face: &Face<'_>, name: &str, width: f32, chosen: bool) -> egui::FontId {
    let first = if chosen { Text::LabelStrong } else { Text::Label };
    largest(ui, face, name, width, &[first, Text::Small]).0
}

/// A count in full if it fits, else in thousands; the tooltip has it in full.
fn fitting(ui: &Ui, face: &Face<'_>, count: &str, width: f32) -> (String, egui::FontId) {
    let (font, fits) = largest(ui, face, count, width, &[Text::Count, Text::LabelStrong]);
    if fits {
        return (count.to_owned(), font);
    }
    // A number that is cut would be another number.
    let count = in_thousands(face, count);
    let (font, _) = largest(ui, face, &count, width, &[Text::Count, Text::LabelStrong, Text::Small]);
    (count, font)
}

/// A text with each of its numbers of more than three digits in thousands.
fn in_thousands(face: &Face<'_>, text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(begin) = rest.find(|c: char| c.is_ascii_digit()) {
        // Groups of digits are one number; the space before a word is not of it.
        let group = |c: char| c.is_ascii_digit() || c == '\u{2009}';
        let number = &rest[begin..];
        let number = number[..number.find(|c| !group(c)).unwrap_or(number.len())].trim_end();
        let digits: String = number.chars().filter(char::is_ascii_digit).collect();
        out.push_str(&rest[..begin]);
        if digits.len() > 3 {
            let thousands = digits.parse().map_or(0, |n: u64| (n + 500) / 1000);
            out.push_str(&face.say_with("ui-thousands", "count", thousands as usize));
        } else {
            out.push_str(number);
        }
        rest = &rest[begin + number.len()..];
    }
    out + rest
}

/// Names and counts.
fn flat(ui: &Ui, face: &Face<'_>, at: Rect, chip: &Chip, chosen: bool) {
    let [ink, dim] = colors(face, chip, chosen);
    let row =
        |y: f32| Rect::from_min_size(pos2(at.left() + 10.0, at.top() + y), vec2(at.width() - 14.0, 18.0));
    let name = face.say(chip.stage.word());
    let font = name_font(ui, face, &name, row(4.0).width(), chosen);
    text_in(ui.painter(), row(4.0), Align2::LEFT_CENTER, &name, font, ink);
    let font = face.look.font(Text::Small);
    let text = counted(ui, face, chip, row(21.0).width());
    text_in(ui.painter(), row(21.0), Align2::LEFT_CENTER, &text, font, dim);
}

/// The count with its unit, else without, else in thousands: a number is never cut.
fn counted(ui: &Ui, face: &Face<'_>, chip: &Chip, width: f32) -> String {
    let all = line(face, chip);
    let Some(count) = &chip.count else { return all };
    let short = in_thousands(face, count);
    let ways = [all, count.clone()];
    let fits = |text: &String| largest(ui, face, text, width, &[Text::Small]).1;
    ways.into_iter().find(fits).unwrap_or(short)
}

fn line(face: &Face<'_>, chip: &Chip) -> String {
    match &chip.count {
        Some(count) => format!("{count} {}", chip.unit).trim_end().to_owned(),
        None => face.say("ui-stage-off"),
    }
}

/// The current stage with its neighbours, as many as fit.
fn path(ui: &mut Ui, face: &Face<'_>, chips: &[Chip], current: Stage) {
    // While the first scene is on its way, there is none.
    if chips.is_empty() {
        return;
    }
    let (rect, look) = (ui.max_rect(), face.look);
    let at = chips.iter().position(|chip| chip.stage == current).unwrap_or(0);
    let painter = ui.painter().clone();
    let galleys: Vec<_> = chips
        .iter()
        .map(|chip| {
            let [ink, dim] = colors(face, chip, chip.stage == current);
            let strong = if chip.stage == current { Text::Strong } else { Text::Body };
            let name = painter.layout_no_wrap(face.say(chip.stage.word()), look.font(strong), ink);
            let count = painter.layout_no_wrap(line(face, chip), look.font(Text::Listing), dim);
            (name, count)
        })
        .collect();
    let width =
        |i: usize| galleys[i].0.size().x + galleys[i].1.size().x + 7.0 + if i == at { 40.0 } else { 26.0 };
    let room = rect.width() - 32.0 - 2.0 * 130.0;
    let (mut first, mut end, mut used) = (at, at + 1, width(at));
    loop {
        let left =
            (first > 0).then(|| width(first - 1)).filter(|w| used + w <= room && at - first <= end - at);
        let right = (end < chips.len()).then(|| width(end)).filter(|w| used + w <= room);
        match (left, right) {
            (Some(w), _) => (first, used) = (first - 1, used + w),
            (_, Some(w)) => (end, used) = (end + 1, used + w),
            _ => {
                let Some(w) = (first > 0).then(|| width(first - 1)).filter(|w| used + w <= room) else {
                    break;
                };
                (first, used) = (first - 1, used + w);
            }
        }
    }
    let mut x = rect.left() + 16.0;
    let y = rect.center().y;
    let arrow = |x: f32| chevron(&painter, pos2(x + 13.0, y), look.stroke(1.5, look.text));
    let rest = |n: usize, id| {
        painter.layout_no_wrap(face.say_with(id, "count", n), look.font(Text::Label), look.dim)
    };
    if first > 0 {
        let galley = rest(first, "ui-stage-earlier");
        let end = x + galley.size().x;
        painter.galley(pos2(x, y - galley.size().y / 2.0), galley, look.dim);
        arrow(end);
        x = end + 26.0;
    }
    for i in first..end {
        let (name, count) = galleys[i].clone();
        let inset = if i == at { 8.0 } else { 0.0 };
        let size = vec2(name.size().x + 7.0 + count.size().x + 2.0 * inset, rect.height() - 8.0);
        let place = Rect::from_min_size(pos2(x, rect.top() + 4.0), size);
        let response = press(ui, face, place, &chips[i]);
        if i == at {
            painter.rect(place, 3, look.raised, look.stroke(1.0, look.text), StrokeKind::Inside);
        }
        let count_x = x + inset + name.size().x + 7.0;
        painter.galley(pos2(x + inset, y - name.size().y / 2.0), name, look.text);
        painter.galley(pos2(count_x, y - count.size().y / 2.0), count, look.dim);
        focus_ring(ui, &response, place, look);
        if i + 1 < chips.len() {
            arrow(place.right());
        }
        x = place.right() + 26.0;
    }
    if end < chips.len() {
        let galley = rest(chips.len() - end, "ui-stage-later");
        painter.galley(pos2(x, y - galley.size().y / 2.0), galley, look.dim);
    }
}
