//! Pieces of the page: text, tables, embedded pictures.

use base64::{Engine, engine::general_purpose::STANDARD};
use rasterscope_core::explain::{Role, Table};
pub(super) use rasterscope_figure::svg::escape;
use rasterscope_figure::{
    tables::{self, Run, TextTable},
    theme::{Color, Theme},
};
use std::fmt::Write;

use crate::words::WORDS;

/// A picture inside the page.
pub(super) fn embed(kind: &str, bytes: &[u8], size: [f32; 2], words: &str) -> String {
    let [width, height] = size.map(f32::round);
    let data = STANDARD.encode(bytes);
    let words = escape(words);
    format!("<img src=\"data:{kind};base64,{data}\" width=\"{width}\" height=\"{height}\" alt=\"{words}\">")
}

/// Tables one below the other; what differs from `before` is marked.
pub(super) fn tables(tables: &[Table], before: &[Table]) -> String {
    tables::format(tables, before, &WORDS).iter().map(table).collect()
}

fn table(table: &TextTable) -> String {
    let mut out = format!("<div class=\"table\"><table><caption>{}</caption>", escape(&table.title));
    let headings: String =
        table.columns.iter().map(|c| format!("<th scope=\"col\">{}</th>", escape(c))).collect();
    let _ = write!(out, "<tr><td></td>{headings}</tr>"); // writing to a String cannot fail
    for row in &table.rows {
        let class = if row.active { " class=\"lit\"" } else { "" };
        let _ = write!(out, "<tr{class}><th scope=\"row\">{}</th>", escape(&row.name));
        for cell in &row.cells {
            let class = if cell.changed { " class=\"changed\"" } else { "" };
            let _ = write!(out, "<td{class}>{}</td>", escape(&cell.text));
        }
        out.push_str("</tr>");
    }
    out + "</table></div>"
}

/// A line of a formula, numbers bold and the result lit.
pub(super) fn formula(runs: &[Run]) -> String {
    let run = |run: &Run| match (run.highlighted, run.strong) {
        (true, _) => format!("<mark>{}</mark>", escape(&run.text)),
        (false, true) => format!("<b>{}</b>", escape(&run.text)),
        (false, false) => escape(&run.text),
    };
    runs.iter().map(run).collect()
}

/// The listing with one line lit.
pub(super) fn listing(lines: &[&str], lit: Option<usize>) -> String {
    let item = |(i, line): (usize, &&str)| {
        let class = if lit == Some(i) { " class=\"lit\"" } else { "" };
        format!("<li{class}>{}</li>", escape(line))
    };
    format!("<ol class=\"listing\">{}</ol>", lines.iter().enumerate().map(item).collect::<String>())
}

/// The page around its parts.
pub(super) fn page(title: &str, theme: &Theme, body: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{}</title>\n<style>\n:root {{{}}}\n{}</style>\n</head>\n<body>\n{body}</body>\n</html>\n",
        escape(title),
        colors(theme),
        include_str!("style.css"),
    )
}

/// The theme's colours by their names in the style sheet.
fn colors(theme: &Theme) -> String {
    let tokens: [(&str, Color); 10] = [
        ("canvas", theme.canvas),
        ("panel", theme.panel),
        ("line", theme.line),
        ("grid", theme.grid),
        ("text", theme.text),
        ("dim", theme.dim),
        ("lit", theme.lit),
        ("changed", theme.changed_bg),
        ("rejected", theme.style(Role::Rejected).color),
        ("accepted", theme.style(Role::Accepted).color),
    ];
    tokens.iter().map(|(name, color)| format!("--{name}:{};", color.css())).collect()
}
