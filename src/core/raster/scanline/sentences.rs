//! What the scan line says about a step.

use super::{Between, Event, Side, Snapshot};
use crate::{
    message::{Message, Value},
    raster::{FillRule, YAxis},
};

impl Snapshot {
    /// The sentence of an event; `self` is the state after it.
    pub(super) fn say(&self, event: &Event) -> Message {
        let y = Value::from(self.row().map_or(0, |row| row.y));
        match *event {
            Event::Sorted { order } => {
                let [top, middle, bottom] =
                    order.map(|index| Value::text(Self::vertex_name(usize::from(index))));
                Message::new("scanline-sorted").with("top", top).with("middle", middle).with("bottom", bottom)
            }
            Event::ZeroArea => Message::new("scanline-zero-area"),
            Event::Slope { edge, dx_dy } => {
                Message::new("scanline-slope").with("edge", self.edge(edge)).with("slope", dx_dy)
            }
            Event::Half { edge, begin, end } => self.say_half(edge, begin, end),
            Event::Row { y } => {
                let centre = y as f32 + 0.5;
                let message = match self.flat(centre) {
                    Some(Between::TopMiddle) => Message::new("scanline-row-top-edge"),
                    Some(_) => Message::new("scanline-row-bottom-edge"),
                    None => Message::new("scanline-row"),
                };
                message
                    .with("y", y)
                    .with("centre", centre)
                    .with("edge", self.flat(centre).map(|e| self.edge(e)))
            }
            Event::Crossing { side, edge, x } => Message::new(match side {
                Side::Left => "scanline-crossing-left",
                Side::Right => "scanline-crossing-right",
            })
            .with("edge", self.edge(edge))
            .with("x", x),
            Event::End { x, corrected: true, .. } => Message::new("scanline-corrected").with("x", x),
            Event::End { side, x, .. } => self.say_end(side, x),
            Event::Tie { side, edge, x, drawn } => {
                let centre = self.row().map(|row| Value::from([x as f32 + 0.5, row.y as f32 + 0.5]));
                Message::new(match (side, drawn) {
                    (Side::Left, true) => "scanline-tie-left-drawn",
                    (Side::Left, false) => "scanline-tie-left-lost",
                    (Side::Right, true) => "scanline-tie-right-drawn",
                    (Side::Right, false) => "scanline-tie-right-lost",
                })
                .with("x", x)
                .with("y", y)
                .with("edge", self.edge(edge))
                .with("centre", centre)
                .with("rule", self.rule())
            }
            Event::Span { begin, end } if begin == end => Message::new("scanline-span-empty").with("y", y),
            Event::Span { begin, end } => Message::new("scanline-span")
                .with("y", y)
                .with("first", begin)
                .with("end", end)
                .with("count", end - begin),
            Event::Pixel { x } => Message::new("scanline-pixel").with("x", x).with("y", y),
            Event::Done => Message::new("scanline-done")
                .with("count", Value::count(usize::try_from(self.pixels()).unwrap_or(usize::MAX))),
        }
    }

    /// Which rows lie between which edges, and whether a row on a horizontal edge is left out.
    fn say_half(&self, edge: Between, begin: u32, end: u32) -> Message {
        let [from, to] = self.ends(edge).map(|end| Value::text(Self::vertex_name(end)));
        if begin == end {
            return Message::new("scanline-half-empty").with("from", from).with("to", to);
        }
        let [first, last] = match self.settings.y_axis {
            YAxis::Down => [begin, end - 1],
            YAxis::Up => [end - 1, begin],
        };
        let mut left_out = None;
        for beside in [begin.checked_sub(1), Some(end).filter(|&y| y < self.settings.size[1])] {
            let lost = beside.and_then(|y| Some((y, self.flat(y as f32 + 0.5)?)));
            left_out = left_out.or(lost);
        }
        let message = match left_out {
            Some((y, flat)) => Message::new("scanline-half-left-out")
                .with("y", y)
                .with("flat", self.edge(flat))
                .with("rule", self.rule()),
            None => Message::new("scanline-half"),
        };
        message
            .with("long", self.edge(Between::TopBottom))
            .with("short", self.edge(edge))
            .with("first", first)
            .with("last", last)
            .with("count", end - begin)
    }

    /// Why the span begins or ends there.
    fn say_end(&self, side: Side, x: u32) -> Message {
        let at = self.row().and_then(|row| row.crossings[side as usize]).map(|(_, at)| at);
        // Whether a centre exactly at the crossing counts.
        let closed = match side {
            Side::Left => self.settings.fill_rule != FillRule::Strict,
            Side::Right => self.settings.fill_rule != FillRule::Inclusive,
        };
        Message::new(match (side, x == self.settings.size[0]) {
            (Side::Left, false) => "scanline-first",
            (Side::Right, false) => "scanline-end",
            (Side::Left, true) => "scanline-first-none",
            (Side::Right, true) => "scanline-end-border",
        })
        .with("x", x)
        .with("centre", x as f32 + 0.5)
        .with("at", at)
        .with("closed", Value::text(closed))
    }

    /// The horizontal edge, if any, on which the centres at this height lie.
    fn flat(&self, centre: f32) -> Option<Between> {
        let on = |edge: &Between| self.ends(*edge).iter().all(|&end| self.vertices[end][1] == centre);
        [Between::TopMiddle, Between::MiddleBottom].into_iter().find(on)
    }

    fn edge(&self, edge: Between) -> Value {
        Value::text(self.edge_name(edge))
    }

    fn rule(&self) -> Value {
        Value::text(self.settings.fill_rule.name())
    }
}
