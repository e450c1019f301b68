//! The drawing of a traversal.

use super::{Event, Show, Snapshot, Traversal, Verdict, cells::Cell, explain::NAMES};
use crate::{
    explain::{Label, MOST_PIXELS, Mark, Role},
    message::Value,
    raster::Span,
};

impl<A: Traversal> Snapshot<A> {
    /// The drawing: pixels, tiles, triangle, and the centre in hand.
    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let many = self.cells.len() > MOST_PIXELS;
        if many {
            let spans = self.result().into_iter();
            out.extend(spans.map(|Span { y, begin, end }| Mark::Run {
                y: y as i32,
                columns: [begin as i32, end as i32],
                role: Role::Accepted,
                object: Some(0),
            }));
        } else {
            for (at, cell) in self.cells.all() {
                self.draw_cell(at, cell, out);
            }
        }
        if self.given != self.vertices {
            out.push(outline(self.given.to_vec(), Role::Exact));
        }
        for &(x, y, size, verdict) in &self.nested {
            let [left, top] = [x, y].map(f32::from);
            let (right, bottom) = (left + f32::from(size), top + f32::from(size));
            let now = matches!(event, Some(Event::Tile { size: of, .. }) if *of == size);
            let role = match verdict {
                _ if now => Role::Active,
                Verdict::Outside { .. } => Role::Rejected,
                Verdict::Inside => Role::Accepted,
                Verdict::Split => Role::Candidate,
            };
            out.push(outline(vec![[left, top], [right, top], [right, bottom], [left, bottom]], role));
        }
        out.push(outline(self.vertices.to_vec(), Role::Neutral));
        if let Some(edges) = &self.edges {
            let keeping = match event {
                Some(Event::Test { keeps_out, .. }) => *keeps_out,
                Some(Event::Tile { verdict: Verdict::Outside { edge }, .. }) => 1 << edge,
                _ => 0,
            };
            for (i, edge) in edges.0.iter().enumerate() {
                let role = if keeping & 1 << i == 0 { Role::Neutral } else { Role::Rejected };
                out.push(Mark::Segment { ends: edge.ends, role, label: Some(Label::name(NAMES[i])) });
            }
        }
        if let Some(at) = self.now {
            let object = self.cells.at(at[0], at[1]).filter(|cell| cell.is_drawn()).map(|_| 0);
            let role = if self.tie(at).is_some() { Role::Tie } else { Role::Active };
            out.push(pixel(at, role, object, Value::BLANK));
        }
        for (index, at) in self.vertices.into_iter().enumerate() {
            let label = Some(Label::new(["V0", "V1", "V2"][index], at));
            out.push(Mark::Point { at, role: Role::Neutral, label });
        }
    }

    /// One centre of the box, if it was tested or drawn.
    fn draw_cell(&self, at: [u16; 2], cell: Cell, out: &mut Vec<Mark>) {
        let (drawn, tests) = (cell.is_drawn(), cell.tests());
        let object = drawn.then_some(0);
        match (self.show, self.cells.when(at[0], at[1])) {
            (Show::Visits, Some(share)) => {
                let role = if drawn { Role::Accepted } else { Role::Rejected };
                out.push(pixel(at, role, object, Value::from(self.cells.first(at[0], at[1]))));
                out.push(Mark::Shade { at: at.map(i32::from), share });
            }
            _ if drawn || tests > 0 => {
                let role = if drawn { Role::Accepted } else { Role::Skipped };
                let again = if tests > 1 { Value::from(tests) } else { Value::None };
                out.push(pixel(at, role, object, again));
            }
            _ => {}
        }
    }
}

fn pixel([x, y]: [u16; 2], role: Role, object: Option<usize>, value: Value) -> Mark {
    Mark::Pixel { at: [x.into(), y.into()], role, object, value }
}

fn outline(points: Vec<[f32; 2]>, role: Role) -> Mark {
    Mark::Polygon { points, role, object: None, label: None }
}
