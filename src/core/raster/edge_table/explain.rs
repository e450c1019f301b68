//! What the lab shows of an edge table run.

use super::{Event, Snapshot};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, View},
    message::{Message, Value},
    raster::view::view_around,
};

impl Explain for Snapshot {
    const NAME: &'static str = "edge-table";

    const LISTING: &'static [&'static str] = &[
        "edge that meets no row: leave it out",
        "else y first, y last ← rows it meets",
        "     dx/dy ← (x1 − x0) / (y1 − y0)",
        "edge table ← edges sorted by y first",
        "for each row y, from the top",
        "  take in the edges that begin here",
        "  x ← where y + 0.5 meets each edge",
        "  first ← ⌈x − 0.5⌉",
        "  centre on the edge: to its right",
        "  sort the active edges by x",
        "  winding ← winding ± 1 at each edge",
        "  inside ends: draw begin ≤ x < first",
        "  the row is done",
        "  drop the edges that end here",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::LeftOut { .. } => 0,
            Event::Edge { .. } => 1,
            Event::Slope { .. } => 2,
            Event::Built { .. } => 3,
            Event::Row { .. } | Event::Done => 4,
            Event::Take { .. } => 5,
            Event::Crossing { .. } => 6,
            Event::First { .. } => 7,
            Event::Tie { .. } => 8,
            Event::Sorted => 9,
            Event::Across { .. } => 10,
            Event::Span { .. } => 11,
            Event::RowDone => 12,
            Event::Drop { .. } => 13,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::LeftOut { .. } | Event::Sorted | Event::Span { .. } => Operations::new(1, 0, 0),
            Event::Slope { .. } => Operations::new(1, 0, 1),
            Event::Crossing { .. } => Operations::new(0, 1, 0),
            // The next edge's first row, and the last row of each.
            Event::Row { .. } | Event::Across { .. } => Operations::new(1, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::Built { .. } | Event::RowDone => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Built { edges: 0 } => (Role::Skipped, Some("edge-table-marker-empty")),
            Event::Built { .. } => (Role::Neutral, Some("edge-table-marker-rows")),
            Event::Tie { .. } => (Role::Tie, None),
            Event::Sorted => (Role::Changed, None),
            Event::Span { begin, end } if begin < end => (Role::Neutral, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("edge-table-opening").with("rule", Value::text(self.settings.winding.name()))
    }

    fn sentence(&self, event: &Event) -> Message {
        self.say(event)
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        out.extend(self.formula(event));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let active = self.active.iter().map(|live| {
            let cells =
                vec![live.x.into(), live.first.into(), self.direction(live.edge).into(), live.winding.into()];
            Row::new(self.name(live.edge), cells)
                .active(self.at == Some(live.edge))
                .role(live.is_tie.then_some(Role::Tie))
        });
        let columns = vec!["x", "first", "±", "winding"];
        out.push(Table { title: "edge-table-active", columns, rows: active.collect() });
        let spans = self.spans.iter().map(|span| {
            Row::new(span.y.to_string(), vec![span.begin.into(), span.end.into(), span.len().into()])
                .active(self.row == Some(span.y))
        });
        let columns = vec!["begin", "end", "column-pixels"];
        out.push(Table { title: "edge-table-spans", columns, rows: spans.collect() });
        let table = self.table.iter().map(|listed| {
            let [first, last] = match listed.rows {
                Some(rows) => rows.map(Value::from),
                None => [Value::None, Value::None],
            };
            let direction = listed.rows.map(|_| self.direction(listed.edge));
            let cells = vec![first, last, listed.dx_dy.into(), direction.into()];
            let active = self.at == Some(listed.edge) || self.live(listed.edge).is_some();
            let left_out = listed.rows.is_none().then_some(Role::Skipped);
            Row::new(self.name(listed.edge), cells).active(active).role(left_out)
        });
        let columns = vec!["y first", "y last", "dx/dy", "±"];
        out.push(Table { title: "edge-table-table", columns, rows: table.collect() });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.picture(event, out);
    }

    fn view(&self) -> View {
        let points = self.used.iter().flatten().copied();
        view_around(points, self.settings.size, self.settings.y_axis)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let pixels = |span: &crate::raster::Span| {
            let y = span.y;
            (span.begin..span.end).map(move |x| Fact::pixel([x, y], Vec::new()))
        };
        out.extend(self.spans.iter().flat_map(pixels));
    }
}
