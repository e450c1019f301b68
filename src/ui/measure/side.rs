//! What stands beside the diagram: choices, how far the work is, the results as a table, and saving.

use super::{Measure, Page, Scope, Shown, table};
use crate::{
    face::{Command, Face},
    shell::choices::choose,
    task::Busy,
    theme::Text,
    widgets::{row, text_in},
};
use egui::{Align2, Rect, Role as Part, ScrollArea, Sense, Ui, WidgetInfo, vec2};
use rasterscope_core::{explain::Role, stress::Family};
use rasterscope_measure::{
    claims::{CLAIMS, Verdict},
    growth::Growing,
    pictures::ErrorKind,
    race::STAGES,
};

/// The buttons and a few lines of the table below a list are so high.
const NUMBERS: f32 = 200.0;

/// Shows the side; the point whose row is under the pointer.
pub(super) fn show(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure, now: f64) -> Option<[usize; 2]> {
    let before = measure.shown;
    match measure.shown.page {
        Page::Errors => errors(ui, face, &mut measure.shown),
        Page::Claims => claims(ui, face, measure),
        Page::Growth => growth(ui, face, &mut measure.shown),
    }
    if measure.shown != before {
        measure.chosen = None;
    }
    ui.add_space(6.0);
    start(ui, face, measure, now);
    ui.add_space(2.0);
    // The buttons below keep their place.
    let foot = face.look.button_height() + 8.0;
    let room = (ui.available_height() - foot).max(60.0);
    let pointed = ScrollArea::vertical()
        .id_salt("table")
        .max_height(room)
        .auto_shrink([false, false])
        .show(ui, |ui| table::show(ui, face, measure))
        .inner;
    ui.horizontal(|ui| {
        let can = measure.figure().is_some() && measure.chart(face.words).is_some();
        for (name, command) in
            [("measure-save-picture", Command::AskPicture), ("measure-copy-table", Command::CopyValues)]
        {
            let button = egui::Button::new(face.rich(face.say(name), Text::Label));
            if ui.add_enabled(can, button).clicked() {
                face.ask(command);
            }
        }
    });
    pointed
}

fn errors(ui: &mut Ui, face: &Face<'_>, shown: &mut Shown) {
    let word = |kind: &str, name: &str| face.words.word(&format!("bench-{kind}-{name}"));
    let stages: Vec<_> = STAGES.iter().map(|stage| word("stage", stage.name)).enumerate().collect();
    choose(ui, face, "measure-operation", &mut shown.stage, &stages);
    let families = shown.stage().families;
    // Another operation may not have the family.
    if shown.family.is_some_and(|family| !families.contains(&family)) {
        shown.family = Some(Family::Ordinary);
    }
    let each = families.iter().map(|family| (Some(*family), word("family", family.name())));
    let all: Vec<_> = each.chain([(None, face.say("bench-family-all"))]).collect();
    choose(ui, face, "measure-inputs", &mut shown.family, &all);
    let errors = ErrorKind::ALL.map(|error| (error, word("short-error", error.name())));
    choose(ui, face, "measure-error", &mut shown.error, &errors);
}

fn growth(ui: &mut Ui, face: &Face<'_>, shown: &mut Shown) {
    let all =
        Growing::ALL.map(|growing| (growing, face.words.word(&format!("bench-growing-{}", growing.name()))));
    choose(ui, face, "measure-what-grows", &mut shown.growing, &all);
}

/// Every claim with its verdict.
fn claims(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure) {
    let height = face.look.row_height();
    // All of them if that leaves room for numbers, else somewhat more than half.
    let whole = ui.available_height();
    let room = (height * CLAIMS.len() as f32).min(whole - NUMBERS).max(whole * 0.58);
    let known = ui.scope_id().with("claim");
    let moved = ui.data(|data| data.get_temp(known)) != Some(measure.shown.claim);
    ui.data_mut(|data| data.insert_temp(known, measure.shown.claim));
    let list = ScrollArea::vertical().id_salt("claims").max_height(room).auto_shrink([false, true]);
    list.show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        for (i, claim) in CLAIMS.iter().enumerate() {
            let sentence = face.words.word(&format!("bench-claim-{}", claim.name));
            let verdict = measure.findings[i].as_ref().map(|finding| finding.verdict);
            let chosen = measure.shown.claim == i;
            let response = row(ui, face, height, &sentence, chosen, |ui, rect| {
                if chosen {
                    ui.painter().rect_filled(rect, 0, face.look.raised);
                    let bar = Rect::from_min_size(rect.min, vec2(4.0, rect.height()));
                    ui.painter().rect_filled(bar, 0, face.look.text);
                }
                let at = rect.left_center() + vec2(16.0, 0.0);
                if let Some(verdict) = verdict {
                    crate::paint::marker(ui.painter(), at, role(verdict), 13.0, face.look);
                }
                let font = face.look.font(if chosen { Text::LabelStrong } else { Text::Label });
                let text = face.words.word(&format!("bench-short-claim-{}", claim.name));
                let room = rect.with_min_x(rect.left() + 30.0);
                text_in(ui.painter(), room, Align2::LEFT_CENTER, &text, font, face.look.text);
            });
            if chosen && moved {
                response.scroll_to_me(None);
            }
            if response.on_hover_text(&sentence).clicked() {
                measure.shown.claim = i;
            }
        }
    });
}

/// What a verdict looks like.
pub(super) fn role(verdict: Verdict) -> Role {
    match verdict {
        Verdict::Holds => Role::Accepted,
        Verdict::UnderACondition => Role::Tie,
        Verdict::DoesNotHold => Role::Rejected,
    }
}

/// The buttons that start the work, or how far it is.
fn start(ui: &mut Ui, face: &Face<'_>, measure: &Measure, now: f64) {
    if measure.is_busy() {
        let busy = measure.busy(now, face.words);
        return progress(ui, face, busy.as_ref());
    }
    ui.horizontal(|ui| {
        let mut button = |name: &'static str, scope| {
            if ui.button(face.rich(face.say(name), Text::Label)).clicked() {
                face.ask(Command::StartMeasuring(scope));
            }
        };
        button("measure-start-shown", Scope::Shown);
        if measure.shown.page != Page::Growth {
            button("measure-start-all", Scope::All);
        }
    });
}

/// A bar, what is being measured, and a button that stops it.
fn progress(ui: &mut Ui, face: &Face<'_>, busy: Option<&Busy>) {
    let look = face.look;
    ui.horizontal(|ui| {
        if ui.button(face.rich(face.say("ui-stop"), Text::Label)).clicked() {
            face.ask(Command::Stop);
        }
        let (rect, response) =
            ui.allocate_exact_size(vec2(ui.available_width(), look.button_height()), Sense::hover());
        let (text, part) = busy.map_or((String::new(), 0.0), |busy| (busy.text.clone(), busy.part));
        response.widget_info(|| WidgetInfo::labeled(Part::ProgressIndicator, true, &text));
        let bar = Rect::from_min_max(rect.left_bottom() - vec2(0.0, 6.0), rect.right_bottom());
        ui.painter().rect_filled(bar, 0, look.raised);
        ui.painter().rect_filled(bar.with_max_x(bar.left() + bar.width() * part), 0, look.edge);
        let line = rect.with_max_y(bar.top());
        text_in(ui.painter(), line, Align2::LEFT_CENTER, &text, look.font(Text::Small), look.text);
        response.on_hover_text(text);
    });
}
