//! What the edge table says about a step.

use super::{Event, Snapshot};
use crate::message::{Message, Value};

/// More edges than this are not named one by one.
const MOST_NAMES: usize = 6;

impl Snapshot {
    /// The sentence of an event; `self` is the state after it.
    pub(super) fn say(&self, event: &Event) -> Message {
        let y = Value::from(self.row);
        let name = Value::text(event.edge().map_or_else(String::new, |edge| self.name(edge)));
        match *event {
            Event::LeftOut { edge } => {
                let [a, b] = self.ends(edge);
                Message::new(if a[1] == b[1] { "edge-table-horizontal" } else { "edge-table-left-out" })
                    .with("edge", name)
            }
            Event::Edge { first, last, .. } => Message::new("edge-table-edge")
                .with("edge", name)
                .with("first", first)
                .with("last", last)
                .with("count", first.abs_diff(last) + 1),
            Event::Slope { dx_dy, .. } => {
                Message::new("edge-table-slope").with("edge", name).with("slope", dx_dy)
            }
            Event::Built { edges: 0 } => Message::new("edge-table-built-empty"),
            Event::Built { edges } => Message::new("edge-table-built").with("count", edges),
            Event::Row { y } => {
                let centre = y as f32 + 0.5;
                let message = match self.along(centre) {
                    Some(edge) => {
                        Message::new("edge-table-row-along").with("edge", Value::text(self.name(edge)))
                    }
                    None => Message::new("edge-table-row"),
                };
                message.with("y", y).with("centre", centre)
            }
            Event::Take { .. } => Message::new("edge-table-take").with("edge", name).with("y", y),
            Event::Crossing { x, .. } => {
                Message::new("edge-table-crossing").with("edge", name).with("x", x).with("y", y)
            }
            Event::First { x, corrected: true, .. } => Message::new("edge-table-corrected").with("x", x),
            Event::First { x, edge, .. } => {
                let none = x == self.settings.size[0];
                Message::new(if none { "edge-table-first-none" } else { "edge-table-first" })
                    .with("edge", name)
                    .with("x", x)
                    .with("centre", x as f32 + 0.5)
                    .with("at", self.live(edge).and_then(|live| live.x))
            }
            Event::Tie { x, .. } => Message::new("edge-table-tie")
                .with("edge", name)
                .with("centre", self.row.map(|y| Value::from([x as f32 + 0.5, y as f32 + 0.5]))),
            Event::Sorted => Message::new("edge-table-sorted").with("edges", self.names()),
            Event::Across { winding, .. } => Message::new(match self.settings.winding.is_inside(winding) {
                true => "edge-table-across-inside",
                false => "edge-table-across-outside",
            })
            .with("edge", name)
            .with("winding", winding)
            .with("rule", self.rule()),
            Event::Span { begin, end } if begin == end => Message::new("edge-table-span-empty").with("y", y),
            Event::Span { begin, end } => Message::new("edge-table-span")
                .with("y", y)
                .with("begin", begin)
                .with("end", end)
                .with("count", end - begin),
            Event::RowDone => Message::new("edge-table-row-done")
                .with("y", y)
                .with("spans", self.here().len())
                .with("count", Value::Int(self.pixels_here().cast_signed())),
            Event::Drop { .. } => Message::new("edge-table-drop").with("edge", name),
            Event::Done => {
                Message::new("edge-table-done").with("count", Value::Int(self.pixels().cast_signed()))
            }
        }
    }

    pub(super) fn rule(&self) -> Value {
        Value::text(self.settings.winding.name())
    }

    /// The active edges from left to right.
    fn names(&self) -> Value {
        let mut names: Vec<_> =
            self.active.iter().take(MOST_NAMES).map(|live| self.name(live.edge)).collect();
        if self.active.len() > MOST_NAMES {
            names.push("…".to_owned());
        }
        Value::text(names.join(", "))
    }

    /// The horizontal edge, if any, on which the centres at this height lie.
    fn along(&self, centre: f32) -> Option<u32> {
        let on = |edge: &u32| self.ends(*edge).iter().all(|end| end[1] == centre);
        self.table.iter().filter(|listed| listed.rows.is_none()).map(|listed| listed.edge).find(on)
    }
}
