//! The numbers of each stage as tables: all rows of a small scene, the first ones of a large one.

use rasterscope_core::{
    cull::{CullMode, Facing},
    explain::{Row, Table},
    labs::Stage,
    message::{Message, Value},
    pipeline::{DrawOutputs, Fate, Point, Skip, screen_names},
    transform::{Matrix, matrices::row},
};
use std::collections::BTreeMap;

use super::{pixels::stored_clear, subject::Subject};

/// Most rows of a table.
const MOST_ROWS: usize = 12;
/// Most matrices of a kind.
const MOST_MATRICES: usize = 3;

/// The tables of a stage, and what to say about rows that are left out.
pub(super) fn tables(subject: &Subject<'_>, stage: Stage) -> (Vec<Table>, Option<Message>) {
    match stage {
        Stage::Scene => first("tour-table-draws", DRAW_COLUMNS.to_vec(), draws(subject)),
        Stage::Model => {
            let matrices = subject.outputs.draws.iter().take(MOST_MATRICES).enumerate();
            let mut tables: Vec<_> = Vec::new();
            let rows = matrices.flat_map(|(i, draw)| matrix_rows(draw.model(), &subject.name(i)));
            tables.push(table("tour-table-model-matrix", vec!["x", "y", "z", "1"], rows.collect()));
            with(tables, points(subject, "tour-table-world", "w", DrawOutputs::world))
        }
        Stage::View => {
            let matrix = matrix("tour-table-view-matrix", &subject.outputs.view);
            with(vec![matrix], points(subject, "tour-table-view", "w", DrawOutputs::view))
        }
        Stage::ClipSpace => {
            let matrix = matrix("tour-table-projection-matrix", &subject.outputs.projection);
            with(vec![matrix], points(subject, "tour-table-clip", "w", DrawOutputs::clip))
        }
        Stage::Cull => {
            first("tour-table-triangles", vec!["column-facing", "column-fate"], decisions(subject))
        }
        Stage::Clip => first("tour-table-polygons", vec!["column-corners", "column-cut"], polygons(subject)),
        Stage::Divide => points(subject, "tour-table-ndc", "1/w", DrawOutputs::ndc),
        Stage::Viewport => points(subject, "tour-table-screen", "1/w", DrawOutputs::screen),
        Stage::ScanConversion => {
            let columns = vec!["column-first-row", "column-rows", "column-pixels"];
            first("tour-table-coverage", columns, coverage(subject))
        }
        Stage::Fragments => fragments(subject),
        Stage::Stencil => histogram(
            "tour-table-stencil",
            subject.outputs.frame.stencil.iter().map(std::string::ToString::to_string),
        ),
        Stage::Depth => depth(subject),
        Stage::Blend => first("tour-table-blend", vec!["column-color", "column-alpha"], blends(subject)),
        Stage::Image => image(subject),
    }
}

fn table(title: &'static str, columns: Vec<&'static str>, rows: Vec<Row>) -> Table {
    Table { title, columns, rows }
}

/// The first rows of many, and how many more there are.
fn first(
    title: &'static str,
    columns: Vec<&'static str>,
    rows: impl Iterator<Item = Row>,
) -> (Vec<Table>, Option<Message>) {
    let mut rows = rows.peekable();
    let mut shown: Vec<_> = rows.by_ref().take(MOST_ROWS).collect();
    if shown.is_empty() {
        return (Vec::new(), None);
    }
    // One row more is no longer than the sentence that would stand for it.
    let rest = rows.next().map(|last| (last, rows.count()));
    let more = match rest {
        Some((last, 0)) => {
            shown.push(last);
            None
        }
        Some((_, more)) => Some(Message::new("tour-more-rows").with("rows", more + 1)),
        None => None,
    };
    (vec![table(title, columns, shown)], more)
}

fn with(
    mut tables: Vec<Table>,
    (more, message): (Vec<Table>, Option<Message>),
) -> (Vec<Table>, Option<Message>) {
    tables.retain(|table| !table.rows.is_empty());
    tables.extend(more);
    (tables, message)
}

const DRAW_COLUMNS: [&str; 4] = ["column-vertices", "column-triangles", "column-cull", "column-depth"];

fn draws(subject: &Subject<'_>) -> impl Iterator<Item = Row> {
    subject.scene.draws.iter().zip(&subject.outputs.draws).enumerate().map(|(i, (draw, outputs))| {
        let mesh = outputs.mesh();
        let cull = match draw.cull {
            CullMode::None => "tour-cull-none",
            CullMode::Back => "tour-cull-back",
            CullMode::Front => "tour-cull-front",
        };
        let depth =
            if draw.depth.test { Value::text(draw.depth.compare.name()) } else { Value::Word("tour-off") };
        let cells = vec![mesh.positions.len().into(), mesh.triangles.len().into(), Value::Word(cull), depth];
        Row::new(subject.name(i), cells)
    })
}

/// The rows of a matrix: what each component of the result is made of.
fn matrix_rows(matrix: &Matrix, name: &str) -> Vec<Row> {
    let component = |i: usize| {
        let heading = format!("{name} {}", ["x′", "y′", "z′", "w′"][i]);
        Row::new(heading.trim(), row(matrix, i).into_iter().map(Value::from).collect())
    };
    (0..4).map(component).collect()
}

fn matrix(title: &'static str, matrix: &Matrix) -> Table {
    table(title, vec!["x", "y", "z", "w"], matrix_rows(matrix, ""))
}

/// The points of a space, draw by draw.
fn points(
    subject: &Subject<'_>,
    title: &'static str,
    fourth: &'static str,
    points: for<'d> fn(&'d DrawOutputs) -> &'d [Point],
) -> (Vec<Table>, Option<Message>) {
    let rows = subject.outputs.draws.iter().enumerate().flat_map(|(index, draw)| {
        let name = subject.name(index);
        points(draw).iter().enumerate().map(move |(i, point)| {
            Row::new(format!("{name} {i}"), point.iter().copied().map(Value::from).collect())
        })
    });
    first(title, vec!["x", "y", "z", fourth], rows)
}

fn decisions(subject: &Subject<'_>) -> impl Iterator<Item = Row> {
    subject.outputs.draws.iter().enumerate().flat_map(move |(index, draw)| {
        draw.culled().decisions.iter().enumerate().map(move |(i, decision)| {
            let facing = match (decision.facing, decision.outside) {
                (Some(Facing::Front), _) => Value::Word("tour-facing-front"),
                (Some(Facing::Back), _) => Value::Word("tour-facing-back"),
                (Some(Facing::Degenerate), _) => Value::Word("tour-facing-degenerate"),
                (None, Some(plane)) => Value::Word(plane.word()),
                (None, None) => Value::None,
            };
            let fate = if decision.fate == Fate::Dropped { "tour-fate-dropped" } else { "tour-fate-kept" };
            Row::new(subject.triangle_name(index, i as u32), vec![facing, Value::Word(fate)])
        })
    })
}

fn polygons(subject: &Subject<'_>) -> impl Iterator<Item = Row> {
    subject.outputs.draws.iter().enumerate().flat_map(move |(index, draw)| {
        draw.clipped().polygons.iter().map(move |polygon| {
            let cut = Value::Word(if polygon.cut { "tour-yes" } else { "tour-no" });
            Row::new(subject.triangle_name(index, polygon.triangle), vec![polygon.len.into(), cut])
        })
    })
}

fn coverage(subject: &Subject<'_>) -> impl Iterator<Item = Row> {
    let triangles: Vec<_> = subject.outputs.triangles().collect();
    let names: Vec<_> = screen_names(subject.scene, &triangles).collect();
    triangles.into_iter().zip(names).map(|(triangle, name)| {
        let spans = subject.spans(&triangle);
        let pixels = spans.iter().map(|span| span.len() as usize).sum::<usize>();
        let first = spans.first().map(|span| span.y);
        let cells = vec![first.into(), spans.len().into(), pixels.into()];
        Row::new(name, cells)
    })
}

/// Values with the number of pixels that have each.
fn histogram(title: &'static str, values: impl Iterator<Item = String>) -> (Vec<Table>, Option<Message>) {
    let mut pixels: BTreeMap<(usize, String), usize> = BTreeMap::new();
    // By length first, so that 10 comes after 9.
    values.for_each(|value| *pixels.entry((value.len(), value)).or_default() += 1);
    let rows = pixels.into_iter().map(|((_, value), count)| Row::new(value, vec![count.into()]));
    first(title, vec!["column-pixels"], rows)
}

fn fragments(subject: &Subject<'_>) -> (Vec<Table>, Option<Message>) {
    histogram("tour-table-fragments", subject.counts.generated.iter().map(std::string::ToString::to_string))
}

fn depth(subject: &Subject<'_>) -> (Vec<Table>, Option<Message>) {
    let frame = &subject.outputs.frame;
    let clear = stored_clear(subject);
    let drawn: Vec<_> = (0..frame.depth.len()).filter(|&i| frame.depth[i] != clear).collect();
    let by_depth = |a: &&usize, b: &&usize| frame.depth[**a].total_cmp(&frame.depth[**b]);
    let width = subject.scene.size[0] as usize;
    let bits = subject.scene.depth_format.bits();
    let at = |name: &str, i: &usize| {
        let (x, y) = (i % width, i / width);
        let code = frame.depth_codes.as_ref().map_or(frame.depth[*i].to_bits(), |codes| codes[*i]);
        let cells = vec![x.into(), y.into(), frame.depth[*i].into(), Value::Code { code, width: bits }];
        Row::new(name, cells)
    };
    let smallest = drawn.iter().min_by(by_depth).map(|i| at("min", i));
    let largest = drawn.iter().max_by(by_depth).map(|i| at("max", i));
    let columns = vec!["x", "y", "column-depth", "column-code"];
    let (mut tables, _) = first("tour-table-depth", columns, smallest.into_iter().chain(largest));
    let clear_pixels = frame.depth.len() - drawn.len();
    let row = |name: &str, count: usize| Row::new(name, vec![count.into()]);
    let rows = vec![row("≠ clear", drawn.len()), row("= clear", clear_pixels)];
    tables.push(table("tour-table-depth-pixels", vec!["column-pixels"], rows));
    (tables, None)
}

fn blends(subject: &Subject<'_>) -> impl Iterator<Item = Row> {
    subject.scene.draws.iter().enumerate().map(|(i, draw)| {
        let replaces = || Value::Word("tour-replaces");
        let cells = match draw.blend {
            Some(blend) => [blend.color, blend.alpha].map(|part| {
                let [src, dst] = [part.src_factor, part.dst_factor].map(|factor| serialized(&factor));
                Value::text(format!("{src} · src {} {dst} · dst", serialized(&part.operation)))
            }),
            None => [replaces(), replaces()],
        };
        Row::new(subject.name(i), cells.to_vec())
    })
}

/// A name as scene files write it.
fn serialized(name: &impl serde::Serialize) -> String {
    let value = serde_json::to_value(name).unwrap_or_default();
    value.as_str().unwrap_or_default().to_owned()
}

fn image(subject: &Subject<'_>) -> (Vec<Table>, Option<Message>) {
    let stats = &subject.outputs.frame.stats;
    let row =
        |name: &str, count: u64| Row::new(name, vec![Value::Int(i64::try_from(count).unwrap_or(i64::MAX))]);
    let skipped = Skip::ALL.into_iter().filter(|skip| stats.skipped(*skip) > 0);
    let skipped = skipped.map(|skip| row(skip.name(), stats.skipped(skip))).collect();
    let decisions = vec![row("all", stats.tally.calls), row("exact", stats.tally.exact)];
    let tables = vec![
        table("tour-table-skipped", vec!["column-count"], skipped),
        table("tour-table-decisions", vec!["column-count"], decisions),
    ];
    with(tables, (Vec::new(), None))
}
