//! How the two sides differ: how much, in what, what each costs, and one part explained.

use super::{inset, part_line, table};
use crate::{
    document::ViewState,
    face::Face,
    shell::split::Sides,
    theme::Text,
    widgets::{row, text_in},
};
use egui::{
    Align2, Rect, Sense, Stroke, StrokeKind, Ui, pos2,
    text::{LayoutJob, TextFormat},
    vec2,
};
use rasterscope_core::{
    compare::{Fact, Pair, Part, Side, Subject, equal, totals, ulps},
    explain::{Operations, Role},
    message::{Message, Value},
};
use rasterscope_figure::{
    numbers,
    split::{Kind, stroke},
    tables::{TextCell, TextRow, TextTable},
};

/// Most rows of the list of parts.
const MOST_ROWS: usize = 100;

/// Shows the tab.
pub(super) fn show(
    ui: &mut Ui,
    face: &Face<'_>,
    sides: &Sides,
    (pair, costs): (&Pair, [Operations; 2]),
    view: &mut ViewState,
) {
    inset(ui, |ui| {
        ui.add_space(14.0);
        headline(ui, face, pair);
        legend(ui, face, pair);
        ui.add_space(8.0);
    });
    part_line(ui, face);
    table::show(ui, face, &counts(face, pair, costs), None, false);
    let chosen = view.part.clone().or_else(|| pair.difference().parts().next()?.either().cloned());
    if let Some(of) = &chosen {
        part_line(ui, face);
        explain(ui, face, sides, pair.part(of), of);
    }
    if pair.difference().count() > 1 {
        part_line(ui, face);
        list(ui, face, pair, chosen.as_ref(), view);
    }
}

/// How many parts differ, and what they are.
fn headline(ui: &mut Ui, face: &Face<'_>, pair: &Pair) {
    let difference = pair.difference();
    let pixels = difference
        .parts()
        .all(|part| part.either().is_some_and(|fact| matches!(fact.subject, Subject::Pixel(_))));
    let id = match (difference.count(), pixels) {
        (0, _) => "ui-difference-none",
        (_, true) => "ui-difference-pixels",
        (_, false) => "ui-difference-parts",
    };
    let look = face.look;
    let mut job = LayoutJob::default();
    job.wrap.max_width = ui.available_width();
    for piece in face.words.runs(&Message::new(id).with("count", difference.count())) {
        let color = if piece.strong { look.role(Role::Changed) } else { look.text };
        job.append(&piece.text, 0.0, TextFormat::simple(look.font(Text::Headline), color));
    }
    ui.label(job);
    if difference.count() == 0 {
        ui.add_space(4.0);
        ui.label(face.dim(face.say_with("ui-difference-equal", "count", difference.same), Text::Body));
    }
}

/// What the outlines mean, with counts.
fn legend(ui: &mut Ui, face: &Face<'_>, pair: &Pair) {
    let difference = pair.difference();
    let numbers_only = difference.in_numbers_only();
    let kinds = [
        ("ui-difference-changed", difference.changed.len() - numbers_only, Kind::Changed),
        ("ui-difference-only-a", difference.only_a.len(), Kind::OneSide),
        ("ui-difference-only-b", difference.only_b.len(), Kind::OneSide),
        ("ui-difference-number", numbers_only, Kind::Number),
    ];
    for (name, count, kind) in kinds.into_iter().filter(|(_, count, _)| *count > 0) {
        let (rect, _) =
            ui.allocate_exact_size(vec2(ui.available_width(), face.look.row_height() + 3.0), Sense::hover());
        let box_ = Rect::from_center_size(pos2(rect.left() + 9.0, rect.center().y), vec2(17.0, 17.0));
        swatch(ui, face, box_, kind);
        let room = rect.with_min_x(rect.left() + 29.0);
        let (font, strong) = (face.look.font(Text::Body), face.look.font(Text::Strong));
        text_in(ui.painter(), room, Align2::LEFT_CENTER, &face.say(name), font, face.look.text);
        let count = numbers::integer(i64::try_from(count).unwrap_or(i64::MAX));
        text_in(ui.painter(), room, Align2::RIGHT_CENTER, &count, strong, face.look.text);
    }
    if let Some(ulps) = difference.ulps() {
        ui.add_space(2.0);
        let ulps = i64::try_from(ulps).unwrap_or(i64::MAX);
        ui.label(face.dim(face.say_with("ui-difference-farthest", "ulps", ulps), Text::Body));
    }
}

/// The outline as on the canvas.
fn swatch(ui: &Ui, face: &Face<'_>, rect: Rect, kind: Kind) {
    let style = stroke(face.look.theme, kind);
    let line = Stroke::new(style.width, face.look.role(Role::Changed));
    if style.dash.is_empty() {
        ui.painter().rect_stroke(rect, 0, line, StrokeKind::Middle);
    } else {
        let corners =
            [rect.left_top(), rect.right_top(), rect.right_bottom(), rect.left_bottom(), rect.left_top()];
        ui.painter().extend(egui::Shape::dashed_line(&corners, line, style.dash[0], style.dash[1]));
    }
}

/// What each side costs, and what its result holds.
fn counts(face: &Face<'_>, pair: &Pair, costs: [Operations; 2]) -> TextTable {
    let [a, b] = Side::ALL.map(|side| {
        let run = pair.run(side);
        let whole = costs[side as usize];
        let count = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
        let mut all = vec![
            ("ui-count-steps", i64::try_from(run.len()).unwrap_or(i64::MAX)),
            ("ui-count-comparisons", count(whole.comparisons)),
            ("ui-count-multiplications", count(whole.multiplications)),
            ("ui-count-divisions", count(whole.divisions)),
        ];
        all.extend(totals(pair.facts(side)));
        all
    });
    let mut names: Vec<&'static str> = a.iter().chain(&b).map(|(name, _)| *name).collect();
    let mut seen = Vec::new();
    names.retain(|name| {
        !seen.contains(name) && {
            seen.push(*name);
            true
        }
    });
    let of = |all: &[(&str, i64)], name: &str| all.iter().find(|(n, _)| *n == name).map_or(0, |(_, n)| *n);
    let rows = names.iter().map(|name| {
        let [a, b] = [of(&a, name), of(&b, name)];
        let cell = |n: i64, changed| TextCell { text: numbers::integer(n), exact: n.to_string(), changed };
        TextRow {
            name: face.say(name),
            cells: vec![cell(a, false), cell(b, a != b)],
            active: false,
            role: None,
        }
    });
    let columns = Side::ALL.map(|side| side.name().to_owned()).to_vec();
    let meanings = vec![None; 1 + columns.len()];
    TextTable { title: face.say("ui-difference-counts"), columns, meanings, rows: rows.collect() }
}

/// What a part is called.
fn title(face: &Face<'_>, fact: &Fact) -> String {
    match &fact.subject {
        Subject::Answer => face.say("ui-part-answer"),
        Subject::Named(name) => name.clone().into_owned(),
        Subject::Corner => face.say_with("ui-part-corner", "at", fact.at.map_or(Value::None, Value::from)),
        Subject::Pixel([x, y]) => {
            let centre = [*x as f32 + 0.5, *y as f32 + 0.5];
            let message = Message::new("ui-part-pixel").with("x", *x).with("y", *y).with("centre", centre);
            face.words.message(&message)
        }
    }
}

/// A value of a part, or that there is none.
fn written(face: &Face<'_>, value: Option<&Value>) -> String {
    value.map_or_else(|| numbers::UNDEFINED.to_owned(), |value| face.words.value(value))
}

/// As many digits as tell a number from its neighbours.
fn every_digit(value: Option<&Value>) -> String {
    let text = match value {
        Some(Value::F32(x)) => x.to_string(),
        Some(Value::F64(x)) => x.to_string(),
        Some(other) => numbers::short(other),
        None => numbers::UNDEFINED.to_owned(),
    };
    text.replace('-', &numbers::MINUS.to_string())
}

/// One part on both sides.
fn explain(ui: &mut Ui, face: &Face<'_>, sides: &Sides, part: Part<'_>, of: &Fact) {
    let rows = part.values().into_iter().map(|(name, [a, b])| {
        let changed = match (a, b) {
            (Some(a), Some(b)) => !equal(a, b),
            _ => true,
        };
        let texts = [a, b].map(|value| written(face, value));
        // What differs must not look the same.
        let texts = if changed && texts[0] == texts[1] { [a, b].map(every_digit) } else { texts };
        let [text_a, text_b] = texts;
        let cell = |text: String, value: Option<&Value>, changed| TextCell {
            text,
            exact: value.map_or_else(String::new, numbers::exact),
            changed,
        };
        let name = if name.starts_with("column-") { face.say(name) } else { name.to_owned() };
        TextRow {
            name,
            cells: vec![cell(text_a, a, false), cell(text_b, b, changed)],
            active: false,
            role: None,
        }
    });
    let columns = Side::ALL.map(|side| side.name().to_owned()).to_vec();
    let meanings = vec![None; 1 + columns.len()];
    let one = TextTable { title: title(face, of), columns, meanings, rows: rows.collect() };
    if one.rows.is_empty() {
        inset(ui, |ui| {
            ui.add_space(8.0);
            ui.label(face.rich(&one.title, Text::Strong));
            ui.add_space(6.0);
        });
    }
    table::show(ui, face, &one, None, false);
    inset(ui, |ui| {
        ui.label(face.dim(sentence(face, sides, part), Text::Body));
        ui.add_space(10.0);
    });
}

/// What the difference of one part is, in a sentence.
fn sentence(face: &Face<'_>, sides: &Sides, part: Part<'_>) -> String {
    let (id, side) = match (part.a, part.b) {
        (None, None) => ("ui-part-neither", Side::A),
        (Some(_), None) => ("ui-part-only", Side::A),
        (None, Some(_)) => ("ui-part-only", Side::B),
        (Some(_), Some(_)) if part.agrees() => ("ui-part-same", Side::A),
        (Some(_), Some(_)) => ("ui-part-differs", Side::A),
    };
    let message = Message::new(id)
        .with("side", Value::text(side.name()))
        .with("name", Value::text(&sides.name))
        .with("value", Value::text(sides.value(side)));
    let said = face.words.message(&message);
    let far = part.values().iter().filter_map(|(_, [a, b])| ulps((*a)?, (*b)?)).max().filter(|far| *far > 0);
    let Some(far) = far else { return said };
    let far = i64::try_from(far).unwrap_or(i64::MAX);
    format!("{said} {}", face.say_with("ui-part-ulps", "ulps", far))
}

/// Every part that differs; a click explains it.
fn list(ui: &mut Ui, face: &Face<'_>, pair: &Pair, chosen: Option<&Fact>, view: &mut ViewState) {
    let count = pair.difference().count();
    inset(ui, |ui| {
        ui.add_space(8.0);
        ui.label(face.dim(face.say("ui-difference-list"), Text::LabelStrong));
    });
    for part in pair.difference().parts().take(MOST_ROWS) {
        let Some(fact) = part.either() else { continue };
        let is = chosen.is_some_and(|chosen| [part.a, part.b].into_iter().flatten().any(|f| same(f, chosen)));
        let values = [part.a, part.b].map(|side| brief(face, side, part));
        let name = short(face, fact);
        let said = format!("{name}: {} | {}", values[0], values[1]);
        let look = face.look;
        let response = row(ui, face, look.row_height(), &said, is, |ui, rect| {
            if is {
                ui.painter().rect_filled(rect, 0, look.raised);
                ui.painter().rect_filled(rect.with_max_x(rect.left() + 4.0), 0, look.text);
            }
            let room = rect.shrink2(vec2(16.0, 0.0));
            let third = room.width() / 3.0;
            let font = look.font(Text::SmallMono);
            text_in(ui.painter(), room, Align2::LEFT_CENTER, &name, font.clone(), look.text);
            for (i, value) in values.iter().enumerate() {
                let right = room.left() + third * (i as f32 + 2.0);
                let at =
                    Rect::from_min_max(pos2(right - third + 6.0, room.top()), pos2(right, room.bottom()));
                let color = if i == 1 { look.role(Role::Changed) } else { look.text };
                text_in(ui.painter(), at, Align2::RIGHT_CENTER, value, font.clone(), color);
            }
        });
        if response.clicked() {
            view.part = Some(fact.clone());
        }
    }
    inset(ui, |ui| {
        if count > MOST_ROWS {
            ui.label(face.dim(face.say_with("ui-more-rows", "count", count - MOST_ROWS), Text::Small));
        }
        ui.add_space(10.0);
    });
}

/// Whether two facts are about the same.
fn same(a: &Fact, b: &Fact) -> bool {
    a.subject == b.subject && (a.subject != Subject::Corner || a.at == b.at)
}

/// A part's name in a list.
fn short(face: &Face<'_>, fact: &Fact) -> String {
    match &fact.subject {
        Subject::Pixel([x, y]) => format!("({x}, {y})"),
        Subject::Corner => face.say("ui-part-corner-short"),
        _ => title(face, fact),
    }
}

/// The first value that differs, as one side has it; of what only one side has, all values.
fn brief(face: &Face<'_>, side: Option<&Fact>, part: Part<'_>) -> String {
    let Some(fact) = side else { return numbers::UNDEFINED.to_owned() };
    let values = part.values();
    let first = match (part.a, part.b) {
        (Some(_), Some(_)) => values.iter().position(|(_, [a, b])| match (a, b) {
            (Some(a), Some(b)) => !equal(a, b),
            _ => true,
        }),
        _ => None,
    };
    match first.and_then(|first| fact.values.get(first)) {
        Some((_, value)) => face.words.value(value),
        None if fact.values.is_empty() => face.say("ui-part-there"),
        None => {
            let all: Vec<_> = fact.values.iter().map(|(_, value)| face.words.value(value)).collect();
            all.join(", ")
        }
    }
}
