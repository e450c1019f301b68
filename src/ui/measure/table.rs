//! The results as numbers.

use super::{Measure, Page};
use crate::{
    face::Face,
    theme::Text,
    widgets::{row, rule, text_in},
};
use egui::{Align2, Rect, Sense, Ui, vec2};
use rasterscope_core::message::Value;
use rasterscope_figure::{numbers, plot};
use rasterscope_measure::{
    claims::{At, CLAIMS},
    pictures,
    race::Row,
};

/// Width of a column of numbers, and in a hall.
const NUMBER: [f32; 2] = [66.0, 84.0];
/// Width of the arithmetic.
const SHORT: f32 = 54.0;

/// Shows the table of the page; the point whose row is under the pointer.
pub(super) fn show(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure) -> Option<[usize; 2]> {
    match measure.shown.page {
        Page::Errors => {
            let pointed = errors(ui, face, measure);
            if let Some(point) = measure.hovered.or(measure.chosen) {
                details(ui, face, measure, point);
            }
            pointed
        }
        Page::Claims => {
            claim(ui, face, measure);
            None
        }
        Page::Growth => growth(ui, face, measure),
    }
}

/// A row of cells: the first takes what the others leave.
fn cells(ui: &Ui, face: &Face<'_>, rect: Rect, first: &str, numbers: &[(&str, f32)], style: [Text; 2]) {
    let mut right = rect.right();
    for (text, width) in numbers.iter().rev() {
        let cell =
            Rect::from_min_max(egui::pos2(right - width, rect.top()), egui::pos2(right, rect.bottom()));
        text_in(ui.painter(), cell, Align2::RIGHT_CENTER, text, face.look.font(style[1]), face.look.text);
        right -= width + 6.0;
    }
    let cell = rect.with_max_x(right);
    text_in(ui.painter(), cell, Align2::LEFT_CENTER, first, face.look.font(style[0]), face.look.text);
}

fn head(ui: &mut Ui, face: &Face<'_>, first: &str, names: &[(&str, f32)]) {
    let (rect, _) =
        ui.allocate_exact_size(vec2(ui.available_width(), face.look.row_height()), Sense::hover());
    cells(ui, face, rect.with_min_x(rect.left() + 22.0), first, names, [Text::Label; 2]);
    rule(ui, rect, face.look);
}

/// A row for each point, with its marker.
fn errors(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure) -> Option<[usize; 2]> {
    let chart = measure.chart(face.words)?;
    let wide = NUMBER[usize::from(face.look.projector())];
    let ids = ["measure-column-algorithm", "measure-column-arithmetic", "measure-column-error"];
    let [algorithm, arithmetic, error] = ids.map(|id| face.say(id));
    let with_arithmetic = !face.look.projector();
    let mut names = vec![("ns", wide - 8.0), (error.as_str(), wide)];
    if with_arithmetic {
        names.insert(0, (arithmetic.as_str(), SHORT));
    }
    head(ui, face, &algorithm, &names);
    let mut points: Vec<([usize; 2], usize)> = (chart.results.iter().enumerate())
        .flat_map(|(i, own)| own.iter().enumerate().map(move |(j, result)| ([i, j], *result)))
        .collect();
    let place = |point: &[usize; 2]| chart.plot.series[point[0]].points[point[1]].at;
    points.sort_by(|(a, _), (b, _)| a[0].cmp(&b[0]).then(place(a)[1].total_cmp(&place(b)[1])));
    let mut pointed = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    for (point, result) in points {
        let data = &measure.rows[result];
        let name = full_name(face, data);
        let lit = measure.hovered == Some(point) || measure.chosen == Some(point);
        let role = chart.plot.series[point[0]].role;
        let [error, ns] = place(&point).map(numbers::measured);
        let response = row(ui, face, face.look.row_height(), &name, lit, |ui, rect| {
            if lit {
                ui.painter().rect_filled(rect, 0, face.look.lit);
            }
            let at = [rect.left() + 9.0, rect.center().y];
            let marker = plot::mark(role, [0.0; 2], face.look.theme);
            crate::paint::shapes(ui.painter(), at.into(), &marker);
            let mut columns = vec![(ns.as_str(), wide - 8.0), (error.as_str(), wide)];
            if with_arithmetic {
                columns.insert(0, (data.arithmetic.name(), SHORT));
            }
            let style = [if lit { Text::LabelStrong } else { Text::Label }, Text::Mono];
            let short = pictures::algorithm(data.algorithm, face.words);
            cells(ui, face, rect.with_min_x(rect.left() + 22.0), &short, &columns, style);
        });
        if response.hovered() {
            pointed = Some(point);
        }
        if response.on_hover_text(name).clicked() {
            measure.chosen = if measure.chosen == Some(point) { None } else { Some(point) };
        }
    }
    pointed
}

/// Algorithm, arithmetic and inputs.
fn full_name(face: &Face<'_>, row: &Row) -> String {
    let words = face.words;
    let fast =
        if row.call == "fast" { format!(", {}", words.word("bench-call-fast")) } else { String::new() };
    format!(
        "{}{fast}, {}\n{}",
        pictures::algorithm(row.algorithm, words),
        words.word(row.arithmetic.word()),
        words.word(&format!("bench-family-{}", row.family.name())),
    )
}

/// Every number of a point.
fn details(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure, point: [usize; 2]) {
    let Some(row) = measure.row(point, face.words).cloned() else { return };
    ui.add_space(8.0);
    ui.label(face.rich(full_name(face, &row).replace('\n', ": "), Text::LabelStrong));
    let item = face.words.word(&format!("bench-item-{}", row.item));
    let measured = numbers::measured;
    let [low, high] = row.quartiles.map(measured);
    let mut lines = vec![
        ("measure-detail-time", format!("{} ns {item}", measured(row.ns))),
        ("measure-detail-quartiles", format!("{low} – {high} ns")),
    ];
    if row.values > 0 {
        lines.push(("measure-detail-worst", format!("{} ULP", measured(row.max_ulps as f64))));
        lines.push(("measure-detail-mean", format!("{} ULP", measured(row.mean_ulps))));
        lines.push(("measure-detail-not-finite", format!("{} / {}", row.not_finite, row.values)));
    }
    if row.decisions > 0 {
        let wrong = (row.wrong_per_million * row.decisions as f64 / 1e6).round();
        lines.push(("measure-detail-wrong", format!("{wrong:.0} / {}", row.decisions)));
    }
    if let Some(share) = row.exact_share {
        lines.push(("measure-detail-tail", format!("{} %", measured(share * 100.0))));
    }
    for (name, value) in lines {
        let height = face.look.row_height() - 2.0;
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
        text_in(
            ui.painter(),
            rect,
            Align2::LEFT_CENTER,
            &face.say(name),
            face.look.font(Text::Label),
            face.look.dim,
        );
        text_in(ui.painter(), rect, Align2::RIGHT_CENTER, &value, face.look.font(Text::Mono), face.look.text);
    }
}

/// The numbers of a claim, a table for each of its series.
fn claim(ui: &mut Ui, face: &Face<'_>, measure: &Measure) {
    let Some(finding) = &measure.findings[measure.shown.claim] else { return };
    let name = CLAIMS[measure.shown.claim].name;
    ui.horizontal_wrapped(|ui| {
        let verdict = face.words.word(&format!("bench-verdict-{}", finding.verdict.name()));
        let color = face.look.role(super::side::role(finding.verdict));
        ui.label(face.rich(verdict, Text::Strong).color(color));
        ui.label(face.dim(face.words.word(&format!("bench-claim-{name}-here")), Text::Label));
    });
    ui.spacing_mut().item_spacing.y = 0.0;
    for series in &finding.series {
        ui.add_space(8.0);
        ui.label(face.dim(face.words.word(&format!("bench-series-{}", series.name)), Text::LabelStrong));
        for number in &series.numbers {
            let at = match number.at {
                At::Name(name) => name.to_owned(),
                At::Number(x) => numbers::short(&Value::F64(x)),
            };
            let height = face.look.row_height() - 2.0;
            let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
            cells(
                ui,
                face,
                rect,
                &at,
                &[(numbers::measured(number.value).as_str(), 130.0)],
                [Text::Label, Text::Mono],
            );
        }
    }
}

/// A row for each frame by each method.
fn growth(ui: &mut Ui, face: &Face<'_>, measure: &mut Measure) -> Option<[usize; 2]> {
    let chart = measure.chart(face.words)?;
    let wide = NUMBER[usize::from(face.look.projector())];
    let mut pointed = None;
    ui.spacing_mut().item_spacing.y = 0.0;
    for (i, series) in chart.plot.series.iter().enumerate() {
        ui.add_space(6.0);
        let times = face.say("measure-column-times");
        head(ui, face, &series.name, &[("ms", wide), (times.as_str(), wide)]);
        let first = series.points.first().map_or(1.0, |point| point.at[1]);
        for (j, point) in series.points.iter().enumerate() {
            let [x, ms] = point.at;
            let lit = measure.hovered == Some([i, j]);
            let name = numbers::integer(x as i64);
            let response = row(ui, face, face.look.row_height(), &name, lit, |ui, rect| {
                if lit {
                    ui.painter().rect_filled(rect, 0, face.look.lit);
                }
                let columns = [(numbers::measured(ms), wide), (numbers::measured(ms / first), wide)];
                let columns: Vec<_> = columns.iter().map(|(text, width)| (text.as_str(), *width)).collect();
                cells(ui, face, rect.with_min_x(rect.left() + 22.0), &name, &columns, [Text::Mono; 2]);
            });
            if response.hovered() {
                pointed = Some([i, j]);
            }
        }
    }
    pointed
}
