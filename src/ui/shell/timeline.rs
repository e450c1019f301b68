//! The timeline: transport, scrub bar with what happened where, step counter, size and speed.

use crate::{
    document::ViewState,
    face::{Command, Face},
    paint,
    run::Shown,
    shell::keys,
    task::Busy,
    theme::Text,
    widgets::{Icon, State, down, icon_button_at},
};
use egui::{
    Align2, ComboBox, CursorIcon, Painter, Pos2, Rect, Role as Part, Sense, Stroke, Ui, WidgetInfo, pos2,
    vec2,
};
use rasterscope_core::explain::{Level, Marker, Role};

/// Room for counter, step size and speed at the right.
const RIGHT: f32 = 212.0;
/// Most steps that still get a tick each.
const MOST_TICKS: usize = 200;
/// Most names that a place is looked for.
const MOST_CAPTIONS: usize = 64;
/// Markers of one kind nearer than this merge into one.
const MERGE: f32 = 12.0;
/// Steps per second that can be chosen.
const SPEEDS: [f32; 6] = [0.5, 1.0, 2.0, 5.0, 10.0, 30.0];

/// Shows the timeline of a run; without a run it is there but cannot be used.
pub(crate) fn show(
    ui: &mut Ui,
    face: &Face<'_>,
    shown: Option<&Shown>,
    view: &ViewState,
    busy: Option<&Busy>,
) {
    let rect = ui.max_rect();
    let buttons = transport(ui, face, rect, shown, view.playing());
    let right = Rect::from_min_max(pos2(rect.right() - RIGHT + 20.0, rect.top()), rect.right_bottom());
    let bar = Rect::from_min_max(
        pos2(buttons + 24.0, rect.top() + 29.0),
        pos2(right.left() - 20.0, rect.top() + 35.0),
    );
    if let Some(busy) = busy {
        progress(ui, face, bar, busy);
    } else if let Some(shown) = shown {
        scrub(ui, face, bar, shown);
    } else {
        ui.painter().rect_filled(bar, 0, face.look.raised);
    }
    settings(ui, face, right, shown, view);
}

/// How far work beside the window is, where the run is otherwise.
fn progress(ui: &mut Ui, face: &Face<'_>, bar: Rect, busy: &Busy) {
    let look = face.look;
    let stop = face.say("ui-stop");
    let width = if busy.stoppable { text_width(ui, &stop, look.font(Text::Label)) + 20.0 } else { 0.0 };
    let bar = bar.with_max_x(bar.right() - if busy.stoppable { width + 12.0 } else { 0.0 });
    let response = ui.interact(bar.expand(8.0), ui.scope_id().with("progress"), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Part::ProgressIndicator, true, &busy.text));
    ui.painter().rect_filled(bar, 0, look.raised);
    ui.painter().rect_filled(bar.with_max_x(bar.left() + bar.width() * busy.part), 0, look.edge);
    let at = pos2(bar.left(), bar.bottom() + 17.0);
    ui.painter().text(at, Align2::LEFT_CENTER, &busy.text, look.font(Text::Label), look.text);
    if busy.stoppable {
        let height = look.button_height();
        let at = Rect::from_center_size(
            pos2(bar.right() + 12.0 + width / 2.0, bar.center().y),
            vec2(width, height),
        );
        if ui.put(at, egui::Button::new(face.rich(stop, Text::Label))).clicked() {
            face.ask(Command::Stop);
        }
    }
}

fn text_width(ui: &Ui, text: &str, font: egui::FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font, egui::Color32::PLACEHOLDER).size().x
}

fn transport(ui: &mut Ui, face: &Face<'_>, rect: Rect, shown: Option<&Shown>, playing: bool) -> f32 {
    let at_start = shown.is_none_or(|s| s.cursor == 0);
    let at_end = shown.is_none_or(|s| s.cursor == s.len);
    let (play, play_name) =
        if playing { (Icon::Pause, "ui-timeline-pause") } else { (Icon::Play, "ui-timeline-play") };
    let buttons = [
        (Icon::Begin, "ui-timeline-begin", "ui-key-home", Command::Begin, at_start),
        (Icon::Back, "ui-timeline-back", "←", Command::Back, at_start),
        (play, play_name, "ui-key-space", Command::Play, shown.is_none()),
        (Icon::Forward, "ui-timeline-forward", "→", Command::Next, at_end),
        (Icon::End, "ui-timeline-end", "ui-key-end", Command::End, at_end),
    ];
    let mut x = rect.left() + 12.0;
    for (index, (icon, name, key, command, disabled)) in buttons.into_iter().enumerate() {
        let size = vec2(36.0, if face.look.projector() { 34.0 } else { 28.0 });
        let button = Rect::from_min_size(pos2(x, rect.top() + 8.0), size);
        let name = face.say(name);
        let key = if key.starts_with("ui-") { face.say(key) } else { key.to_owned() };
        let sense = if disabled { Sense::hover() } else { Sense::click() };
        let response = ui.interact(button, ui.scope_id().with(("transport", index)), sense);
        response.widget_info(|| WidgetInfo::labeled(Part::Button, !disabled, &name));
        let state = match (disabled, icon) {
            (true, _) => State::Disabled,
            (_, Icon::Pause) => State::On,
            _ => State::Off,
        };
        icon_button_at(ui, face, icon, button, &response, state, false);
        let (font, dim) = (face.look.font(Text::Small), face.look.dim);
        ui.painter().text(
            pos2(button.center().x, rect.bottom() - 13.0),
            Align2::CENTER_CENTER,
            &key,
            font,
            dim,
        );
        if response.on_hover_text(format!("{name} ({key})")).clicked() {
            face.ask(command);
        }
        x = button.right() + 4.0;
    }
    x - 4.0
}

fn scrub(ui: &mut Ui, face: &Face<'_>, bar: Rect, shown: &Shown) {
    let look = face.look;
    let catch = Rect::from_min_max(bar.min - vec2(8.0, 22.0), bar.max + vec2(8.0, 10.0));
    let response = ui.interact(catch, ui.scope_id().with("scrub"), Sense::click_and_drag());
    let name = face.say("ui-timeline-scrub");
    response.widget_info(|| WidgetInfo::slider(true, shown.cursor as f64, &name));
    if (response.dragged() || response.clicked())
        && let Some(at) = response.interact_pointer_pos()
    {
        let part = ((at.x - bar.left()) / bar.width()).clamp(0.0, 1.0);
        let step = (part * shown.len as f32).round() as usize;
        if step != shown.cursor {
            face.ask(Command::Seek(step));
        }
    }
    let response = response.on_hover_cursor(CursorIcon::PointingHand);

    let x_of = |step: usize| bar.left() + bar.width() * step as f32 / shown.len.max(1) as f32;
    let now = x_of(shown.cursor);
    let painter = ui.painter();
    painter.rect_filled(bar, 0, look.raised);
    painter.rect_filled(bar.with_max_x(now), 0, look.edge);
    if shown.len <= MOST_TICKS {
        let stroke = Stroke::new(1.0, look.edge);
        for step in 1..shown.len {
            let x = painter.round_to_pixel_center(x_of(step));
            painter.vline(x, bar.top() - 12.0..=bar.top() - 7.0, stroke);
        }
    }
    markers(painter, face, bar, shown, x_of);
    labels(painter, face, bar, shown, x_of);
    let centre = pos2(now, bar.center().y);
    let ring = Stroke::new(1.5, if look.now == look.role(Role::Active) { look.canvas } else { look.text });
    painter.line_segment([centre, pos2(now, bar.bottom() + 11.0)], Stroke::new(2.5, look.now));
    painter.circle(centre, 7.5, look.now, ring);
    if response.has_focus() {
        painter.circle_stroke(centre, 11.0, look.focus_stroke());
    }
}

/// Marks what happened where, above the bar; a plain mark is a tall tick.
fn markers(painter: &Painter, face: &Face<'_>, bar: Rect, shown: &Shown, x_of: impl Fn(usize) -> f32) {
    let y = bar.top() - 13.0;
    let mut last: Vec<(Role, f32)> = Vec::new();
    // In a long run what passed is the rule; marks are for what did not.
    let calm = shown.len > MOST_TICKS;
    let worth = |marker: &Marker| !(calm && marker.role == Role::Accepted && marker.label.is_none());
    for (step, marker) in shown.markers.iter().filter(|(_, marker)| worth(marker)) {
        let x = x_of(*step);
        let near = last.iter_mut().find(|(role, _)| *role == marker.role);
        match near {
            Some((_, at)) if x - *at < MERGE => continue,
            Some((_, at)) => *at = x,
            None => last.push((marker.role, x)),
        }
        if plain(*marker) {
            let x = painter.round_to_pixel_center(x);
            painter.vline(x, y - 6.0..=y + 6.0, Stroke::new(2.0, face.look.text));
        } else {
            paint::marker(painter, pos2(x, y), marker.role, 9.0, face.look);
        }
    }
}

fn plain(marker: Marker) -> bool {
    matches!(marker.role, Role::Neutral | Role::Active)
}

/// Names below the bar, as many as fit; the one of the current step first and strong.
fn labels(painter: &Painter, face: &Face<'_>, bar: Rect, shown: &Shown, x_of: impl Fn(usize) -> f32) {
    let role_at = |step: usize| {
        let at = shown.markers.binary_search_by_key(&step, |(step, _)| *step).ok();
        at.map_or(Role::Neutral, |at| shown.markers[at].1.role)
    };
    let current = shown.captions.iter().rposition(|(step, _)| *step <= shown.cursor);
    let mut taken: Vec<Rect> = Vec::new();
    // Of many not even every one is tried: no more would fit.
    let every = shown.captions.len().div_ceil(MOST_CAPTIONS).max(1);
    let others = (0..shown.captions.len()).step_by(every).filter(|i| Some(*i) != current);
    for i in current.into_iter().chain(others) {
        let (now, (step, caption)) = (Some(i) == current, &shown.captions[i]);
        let (step, role) = (*step, role_at(*step));
        let font = face.look.font(if now { Text::LabelStrong } else { Text::Small });
        let color = match role {
            Role::Accepted | Role::Rejected | Role::Tie => face.look.role(role),
            _ if now => face.look.text,
            _ => face.look.dim,
        };
        let galley = painter.layout_no_wrap(face.words.message(caption), font, color);
        let half = galley.size().x / 2.0;
        let x = x_of(step).clamp(bar.left() + half - 12.0, bar.right() - half + 12.0);
        let at = Rect::from_center_size(pos2(x, bar.bottom() + 17.0), galley.size());
        if taken.iter().all(|other| !other.expand2(vec2(8.0, 0.0)).intersects(at)) {
            painter.galley(at.min, galley, color);
            taken.push(at);
        }
    }
}

fn settings(ui: &mut Ui, face: &Face<'_>, rect: Rect, shown: Option<&Shown>, view: &ViewState) {
    let look = face.look;
    let (cursor, len) = shown.map_or((0, 0), |s| (s.cursor, s.len));
    let at = rect.left_top() + vec2(0.0, if look.projector() { 17.0 } else { 19.0 });
    let end = counter(ui.painter(), face, at, &cursor.to_string(), Text::Counter, look.text);
    counter(ui.painter(), face, pos2(end + 8.0, at.y), &format!("/ {len}"), Text::Mono, look.dim);
    let height = look.button_height() - 2.0;
    let row = Rect::from_min_max(pos2(rect.left(), rect.bottom() - height - 6.0), rect.max - vec2(12.0, 6.0));
    ui.scope_builder(egui::UiBuilder::new().max_rect(row), |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().interact_size.y = height;
            ui.spacing_mut().button_padding.y = 1.0;
            let text = face.rich(face.say(keys::level(view.level)), Text::Label);
            let combo = ComboBox::from_id_salt("level").width(94.0).icon(down).selected_text(text).show_ui(
                ui,
                |ui| {
                    for each in Level::ALL {
                        if ui.selectable_label(each == view.level, face.say(keys::level(each))).clicked() {
                            face.ask(Command::Level(each));
                        }
                    }
                },
            );
            name(&combo.response, &face.say("ui-timeline-level"));
            let say = |speed: f32| face.say_with("ui-timeline-per-second", "speed", speed);
            let text = face.rich(say(view.speed), Text::Label);
            let combo = ComboBox::from_id_salt("speed").width(78.0).icon(down).selected_text(text).show_ui(
                ui,
                |ui| {
                    for speed in SPEEDS {
                        if ui.selectable_label(speed == view.speed, say(speed)).clicked() {
                            face.ask(Command::Speed(speed));
                        }
                    }
                },
            );
            name(&combo.response, &face.say("ui-timeline-speed"));
        });
    });
}

fn name(response: &egui::Response, name: &str) {
    response.widget_info(|| WidgetInfo::labeled(Part::ComboBox, true, name));
    response.clone().on_hover_text(name);
}

fn counter(
    painter: &Painter,
    face: &Face<'_>,
    at: Pos2,
    text: &str,
    style: Text,
    color: egui::Color32,
) -> f32 {
    painter.text(at, Align2::LEFT_CENTER, text, face.look.font(style), color).right()
}
