//! Points, their spreads, the lines that join them, and the line along the best of them.

use super::{Plot, Series, Spot, draw::Sheet, ruler::Ruler};
use crate::{figure::Stroke, theme::Theme};

/// Spreads, the frontier and the lines that join points; collects where the points are.
pub(super) fn draw(plot: &Plot, [x, up]: [&Ruler; 2], sheet: &mut Sheet<'_>, spots: &mut Vec<Spot>) {
    let theme = sheet.theme;
    let mut all = Vec::new();
    for (i, Series { role, joined, points, .. }) in plot.series.iter().enumerate() {
        let style = theme.style(*role);
        let mut line = Vec::new();
        for (j, point) in points.iter().enumerate() {
            let (Some(at_x), Some(at_y)) = (x.at(point.at[0]), up.at(point.at[1])) else { continue };
            // In a lane there is room aside, so that equal ones of two arithmetics are both seen.
            let is_lane = [x.zero, x.infinite].contains(&Some(at_x));
            all.push([at_x, at_y]);
            let at_x = if is_lane && !*joined { at_x + aside(i, plot.series.len()) } else { at_x };
            let ends = point.spread.and_then(|[low, high]| Some([up.at(low)?, up.at(high)?]));
            if let Some(ends) = ends {
                let ends = ends.map(|y| [at_x, up.within(y)]);
                sheet.line(ends.to_vec(), Stroke::solid(style.color.alpha(0.6), 2.0));
            }
            line.push([at_x, at_y]);
            spots.push(Spot { at: [at_x, at_y], point: [i, j] });
        }
        if *joined && line.len() > 1 {
            let width = style.width.min(2.5) + theme.extra_stroke * 0.5;
            sheet.line(line, Stroke { color: style.color, width, dash: style.dash, phase: 0.0 });
        }
    }
    if plot.frontier.is_some() && all.len() > 1 {
        sheet.line(frontier(all, x.ends()[1]), frontier_stroke(theme));
    }
}

pub(super) fn frontier_stroke(theme: &Theme) -> Stroke {
    Stroke { dash: &[7.0, 4.0], ..Stroke::solid(theme.dim, 1.5) }
}

/// Steps along the points to the left of and below which there is none, up to the end of the axis.
fn frontier(mut points: Vec<[f32; 2]>, end: f32) -> Vec<[f32; 2]> {
    // The lower of two above one another comes first; y grows downwards.
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(b[1].total_cmp(&a[1])));
    let mut steps: Vec<[f32; 2]> = Vec::new();
    for [x, y] in points {
        match steps.last().copied() {
            Some([_, last]) if y <= last => {}
            Some([_, last]) => steps.extend([[x, last], [x, y]]),
            None => steps.push([x, y]),
        }
    }
    let last = steps.last().copied();
    steps.extend(last.map(|[x, y]| [end.max(x), y]));
    steps
}

/// How far from the middle of a lane the points of a series stand.
fn aside(series: usize, all: usize) -> f32 {
    (series as f32 - (all as f32 - 1.0) / 2.0) * (44.0 / all.max(3) as f32)
}
