//! What stands round the two drawings of the split view.

use crate::{
    face::{Command, Face},
    run::Shown,
    theme::Text,
    widgets::{down, focus_ring, rule, text_in},
};
use egui::{
    Align2, ComboBox, Rect, Role as Part, Sense, Ui, UiBuilder, WidgetInfo, pos2,
    text::{LayoutJob, TextFormat},
    vec2,
};
use rasterscope_core::compare::{Setting, Side};
use rasterscope_figure::split::counts;

/// The setting in which two sides differ, in words.
#[derive(Clone, Debug)]
pub(crate) struct Sides {
    /// What it is called.
    pub(crate) name: String,
    /// What each side has.
    pub(crate) own: [Option<Setting>; 2],
    /// Each value that a side can have.
    pub(crate) all: Vec<(Setting, String)>,
}

impl Sides {
    /// What a side has, in words.
    pub(crate) fn value(&self, side: Side) -> &str {
        let own = self.own[side as usize];
        self.all.iter().find(|(setting, _)| Some(*setting) == own).map_or("", |(_, name)| name)
    }
}

/// The line above a drawing: its letter, what it has of the setting, what it costs.
pub(crate) fn header(
    ui: &mut Ui,
    face: &Face<'_>,
    rect: Rect,
    side: Side,
    sides: &Sides,
    shown: Option<&Shown>,
) {
    let look = face.look;
    ui.painter().rect_filled(rect, 0, look.panel);
    rule(ui, rect, look);
    let middle = rect.center().y;
    let letter = Rect::from_center_size(pos2(rect.left() + 26.0, middle), vec2(24.0, 24.0));
    ui.painter().rect_filled(letter, 3, look.raised);
    ui.painter().text(
        letter.center(),
        Align2::CENTER_CENTER,
        side.name(),
        look.font(Text::Strong),
        look.text,
    );
    let lay_out =
        |text: &str, style, color| ui.painter().layout_no_wrap(text.to_owned(), look.font(style), color);
    let so_far = shown.and_then(|shown| shown.operations).map(|[so_far, _]| so_far);
    let counts = so_far.map_or_else(String::new, |so_far| counts(face.words, so_far));
    let (name, counts) =
        (lay_out(&sides.name, Text::Body, look.dim), lay_out(&counts, Text::SmallMono, look.dim));
    // The value comes first, then what it costs, then what the setting is called.
    let value = (lay_out(sides.value(side), Text::Label, look.text).size().x + 44.0).max(96.0);
    let room = rect.right() - 14.0 - letter.right() - 10.0;
    let counted = value + 12.0 + counts.size().x <= room;
    let named = value + 10.0 + name.size().x + if counted { 12.0 + counts.size().x } else { 0.0 } <= room;
    let mut x = letter.right() + 10.0;
    let mut right = rect.right() - 2.0;
    if named {
        let end = x + name.size().x + 10.0;
        ui.painter().galley(pos2(x, middle - name.size().y / 2.0), name, look.dim);
        x = end;
    }
    if counted {
        right = rect.right() - 14.0 - counts.size().x;
        ui.painter().galley(pos2(right, middle - counts.size().y / 2.0), counts, look.dim);
    }
    let height = look.button_height();
    let width = (right - 12.0 - x).min(value.max(150.0));
    let place = Rect::from_min_size(pos2(x, middle - height / 2.0), vec2(width, height));
    ui.scope_builder(UiBuilder::new().id_salt(("setting", side.name())).max_rect(place), |ui| {
        let mut chosen = sides.own[side as usize];
        let combo = ComboBox::from_id_salt("value")
            .width(width)
            .truncate()
            .icon(down)
            .selected_text(face.rich(sides.value(side), Text::Label))
            .show_ui(ui, |ui| {
                for (setting, name) in &sides.all {
                    ui.selectable_value(&mut chosen, Some(*setting), name);
                }
            });
        let name = format!("{}: {}", side.name(), sides.name);
        combo.response.widget_info(|| WidgetInfo::labeled(Part::ComboBox, true, &name));
        if let Some(setting) = chosen.filter(|_| chosen != sides.own[side as usize]) {
            face.ask(Command::OfSide(side, setting));
        }
    });
}

/// What happened last, below a drawing.
pub(crate) fn foot(ui: &Ui, face: &Face<'_>, rect: Rect, shown: &Shown) {
    let look = face.look;
    let mut job = LayoutJob::default();
    job.wrap.max_width = rect.width() - 28.0;
    job.wrap.max_rows = 2;
    for piece in face.words.runs(&shown.sentence) {
        let style = if piece.strong { Text::LabelStrong } else { Text::Label };
        job.append(&piece.text, 0.0, TextFormat::simple(look.font(style), look.text));
    }
    let galley = ui.painter().layout_job(job);
    ui.painter().galley(pos2(rect.left() + 14.0, rect.center().y - galley.size().y / 2.0), galley, look.text);
}

/// Why a side has no drawing.
pub(crate) fn problem(ui: &Ui, face: &Face<'_>, rect: Rect, text: &str) {
    let room = rect.shrink(32.0);
    let font = face.look.font(Text::Sentence);
    let galley = ui.painter().layout(text.to_owned(), font, face.look.dim, room.width());
    let at = Align2::CENTER_CENTER.align_size_within_rect(galley.size(), room).min;
    ui.painter().galley(at, galley, face.look.dim);
}

/// Two buttons: which side is explained.
pub(crate) fn chooser(ui: &mut Ui, face: &Face<'_>, sides: &Sides, explained: Side) {
    let look = face.look;
    let (rect, _) =
        ui.allocate_exact_size(vec2(ui.available_width(), look.button_height() + 12.0), Sense::hover());
    let width = (rect.width() - 32.0 - 8.0) / 2.0;
    for side in Side::ALL {
        let left = rect.left() + 16.0 + side as u8 as f32 * (width + 8.0);
        let at = Rect::from_min_size(pos2(left, rect.top() + 6.0), vec2(width, look.button_height()));
        let name = format!("{}  {}", side.name(), sides.value(side));
        let response = ui.interact(at, ui.scope_id().with(("explain", side.name())), Sense::click());
        let chosen = side == explained;
        response.widget_info(|| WidgetInfo::selected(Part::Button, true, chosen, &name));
        crate::widgets::wear(ui, &response, at, chosen, look);
        let (font, color) = if chosen { (Text::LabelStrong, look.text) } else { (Text::Label, look.dim) };
        text_in(ui.painter(), at.shrink2(vec2(8.0, 0.0)), Align2::LEFT_CENTER, &name, look.font(font), color);
        if chosen {
            let foot = Rect::from_min_max(pos2(at.left() + 4.0, at.bottom() - 3.0), at.max - vec2(4.0, 0.0));
            ui.painter().rect_filled(foot, 0, look.text);
        }
        focus_ring(ui, &response, at, look);
        if response.clicked() {
            face.ask(Command::Explain(side));
        }
    }
    rule(ui, rect, look);
}
