//! The drawing of an edge table run.

use super::{Event, Point, Snapshot, names, snapshot::Live};
use crate::{
    explain::{Label, MOST_PIXELS, Mark, Role},
    message::Value,
    raster::Span,
};

/// With more active edges than this, only the one at hand shows its crossing's number.
const MOST_CROSSINGS: usize = 4;
/// With more corners than this, they show their names without their numbers.
const MOST_PLACES: usize = 5;

impl Snapshot {
    /// The pixels, the contours, the active edges and the row.
    pub(super) fn picture(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let many = self.outcome.is_empty() && self.pixels() > MOST_PIXELS as u64;
        for span in &self.spans {
            mark_span(span, Role::Accepted, Some(0), many, out);
        }
        if self.row.is_some() {
            for span in self.outcome.iter().filter(|span| !self.spans.contains(span)) {
                mark_span(span, Role::Candidate, None, many, out);
            }
        }
        for (given, used) in self.given.iter().zip(self.used.iter()) {
            if given != used {
                out.push(outline(given, Role::Exact));
            }
            out.push(outline(used, Role::Neutral));
        }
        for listed in &self.table {
            let role = match listed.rows {
                _ if self.at == Some(listed.edge) => Role::Active,
                None => Role::Skipped,
                Some(_) if self.live(listed.edge).is_some() => Role::Accepted,
                Some(_) => continue,
            };
            let slope = matches!(event, Some(Event::Slope { edge, .. }) if *edge == listed.edge);
            let label = listed.dx_dy.filter(|_| slope).map(|slope| Label::new("dx/dy", slope));
            out.push(Mark::Segment { ends: self.ends(listed.edge), role, label });
        }
        if let Some(y) = self.row {
            self.mark_row(y, event, out);
        }
        let few = self.used.iter().map(Vec::len).sum::<usize>() <= MOST_PLACES;
        for (contour, corners) in self.used.iter().enumerate() {
            for (index, &at) in corners.iter().enumerate() {
                let name = names::corner(contour, index);
                let label = if few { Label::new(name, at) } else { Label::name(name) };
                out.push(Mark::Point { at, role: Role::Neutral, label: Some(label) });
            }
        }
    }

    /// The centre line, where the edges meet it, and the winding numbers between them.
    fn mark_row(&self, y: u32, event: Option<&Event>, out: &mut Vec<Mark>) {
        let centre = y as f32 + 0.5;
        out.push(Mark::Guide { axis: 1, at: centre, role: Role::Active, label: None, note: None });
        let at = |live: &Live| live.x.map(|x| x as f32).filter(|x| x.is_finite());
        for pair in self.active.windows(2) {
            let (Some(left), Some(right), Some(winding)) = (at(&pair[0]), at(&pair[1]), pair[0].winding)
            else {
                continue;
            };
            let inside = self.settings.winding.is_inside(winding);
            if inside && pair[0].first < pair[1].first {
                out.push(Mark::Span { y: y as i32, ends: [left, right], role: Role::Active });
            }
            let role = if inside { Role::Active } else { Role::Rejected };
            let middle = [left / 2.0 + right / 2.0, centre];
            let label = Some(Label::new("", Value::from(winding)));
            out.push(Mark::Segment { ends: [middle, middle], role, label });
        }
        for live in &self.active {
            let Some(x) = at(live) else { continue };
            let here = self.at == Some(live.edge);
            let on_centre = live.first.is_some_and(|column| live.is_tie && x == column as f32 + 0.5);
            let role = match (on_centre, here) {
                (true, _) => Role::Tie,
                (false, true) => Role::Active,
                (false, false) => Role::Accepted,
            };
            let walking = live.winding.is_some();
            let named = !walking && (here || self.active.len() <= MOST_CROSSINGS);
            let label = named.then(|| Label::new("x", x));
            out.push(Mark::Point { at: [x, centre], role, label });
            if let (true, Some(column)) = (live.is_tie, live.first) {
                mark_pixel(column, y, Role::Tie, None, out);
            }
        }
        if let Some(Event::Span { begin, end }) = event
            && (end - begin) as usize <= MOST_PIXELS
        {
            (*begin..*end).for_each(|x| mark_pixel(x, y, Role::Active, Some(0), out));
        }
    }
}

fn mark_span(span: &Span, role: Role, object: Option<usize>, many: bool, out: &mut Vec<Mark>) {
    if many {
        let columns = [span.begin, span.end].map(|x| x as i32);
        out.push(Mark::Run { y: span.y as i32, columns, role, object });
    } else {
        (span.begin..span.end).for_each(|x| mark_pixel(x, span.y, role, object, out));
    }
}

fn mark_pixel(x: u32, y: u32, role: Role, object: Option<usize>, out: &mut Vec<Mark>) {
    out.push(Mark::Pixel { at: [x as i32, y as i32], role, object, value: Value::None });
}

fn outline(points: &[Point], role: Role) -> Mark {
    Mark::Polygon { points: points.to_vec(), role, object: None, label: None }
}
