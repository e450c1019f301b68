//! What the lab shows of layers over one pixel.

use super::{Event, Snapshot, picture};
use crate::{
    blend::{BlendOperation, Terms},
    compare::Fact,
    explain::{Explain, Formula, Grid, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
};

/// The channels' names: message ids.
const CHANNELS: [&str; 4] = ["row-red", "row-green", "row-blue", "row-alpha"];

impl Explain for Snapshot {
    const NAME: &'static str = "blend";

    const LISTING: &'static [&'static str] = &[
        "of a list: for each layer: append it",
        "  while nearer than the one behind: swap",
        "for each layer, from first to last",
        "  for each channel: new ← src·Fs op dst·Fd",
        "  dst ← ⌊255 new + ½⌋, all four at once",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Append { .. } => 0,
            Event::Compare { .. } => 1,
            Event::Layer { .. } => 2,
            Event::Channel { .. } => 3,
            Event::Store { .. } => 4,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Compare { .. } => Operations::new(1, 0, 0),
            // Two products and the one with 255.
            Event::Channel { .. } => Operations::new(0, 3, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Store { .. } => Level::Primitive,
            Event::Append { .. } | Event::Compare { .. } => Level::Row,
            Event::Layer { .. } | Event::Channel { .. } => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        match event {
            Event::Layer { .. } => Some(Marker { role: Role::Neutral, label: Some("blend-marker-layer") }),
            Event::Compare { swapped: true, .. } => Some(Marker { role: Role::Changed, label: None }),
            Event::Store { .. } => Some(Marker { role: Role::Accepted, label: None }),
            _ => None,
        }
    }

    fn caption(&self, event: &Event) -> Option<Message> {
        let label = Self::marker(event)?.label?;
        let Event::Layer { index } = *event else { return None };
        Some(Message::new(label).with("object", self.name(index)))
    }

    fn opening(&self) -> Message {
        Message::new("blend-opening")
            .with("codes", Value::text(picture::codes(self.result.color)))
            .with("count", self.layers.len())
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Append { index } => Message::new("blend-append")
                .with("object", self.name(index))
                .with("depth", self.layers[usize::from(index)].depth),
            Event::Compare { at, swapped } => {
                let [first, second] = [at, at + 1].map(|place| self.list[usize::from(place)]);
                Message::new(if swapped { "blend-swap" } else { "blend-keep" })
                    .with("first", self.name(first))
                    .with("second", self.name(second))
                    .with("far", self.layers[usize::from(first)].depth)
                    .with("near", self.layers[usize::from(second)].depth)
            }
            Event::Layer { index } => Message::new("blend-layer")
                .with("object", self.name(index))
                .with("codes", Value::text(picture::codes(self.result.color))),
            Event::Channel { channel, code } => {
                let Some(terms) = self.terms(usize::from(channel)) else { return self.opening() };
                let outside = !(0.0..=1.0).contains(&terms.result);
                Message::new(if outside { "blend-channel-clamped" } else { "blend-channel" })
                    .with("object", self.layer.map(|index| self.name(index)))
                    .with("channel", Value::Word(CHANNELS[usize::from(channel)]))
                    .with("result", terms.result)
                    .with("code", Value::text(code))
            }
            Event::Store { codes } => Message::new("blend-store")
                .with("object", self.layer.map(|index| self.name(index)))
                .with("codes", Value::text(picture::codes(codes))),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let Event::Channel { channel, code } = *event else { return };
        let (Some(terms), Some(index)) = (self.terms(usize::from(channel)), self.layer) else { return };
        let state = &self.layers[usize::from(index)].state;
        let number = |x: f64| Piece::Number(x.into());
        let (text, result) = (Piece::Text, Piece::Result(terms.result.into()));
        let new = [text("= "), number(terms.source), text(" · "), number(terms.source_factor)];
        let old = [number(terms.stored), text(" · "), number(terms.stored_factor)];
        let (general, numbers) = match state.component(usize::from(channel)).operation {
            BlendOperation::Add => {
                ("c = src · Fs + dst · Fd", new.into_iter().chain([text(" + ")]).chain(old).collect())
            }
            BlendOperation::Subtract => {
                ("c = src · Fs − dst · Fd", new.into_iter().chain([text(" − ")]).chain(old).collect())
            }
            BlendOperation::ReverseSubtract => {
                let [_, new @ ..] = new;
                let all = [text("= ")].into_iter().chain(old).chain([text(" − ")]).chain(new);
                ("c = dst · Fd − src · Fs", all.collect())
            }
            BlendOperation::Min => ("c = min(src, dst)", least_or_most("= min(", &terms)),
            BlendOperation::Max => ("c = max(src, dst)", least_or_most("= max(", &terms)),
        };
        let mut numbers: Vec<Piece> = numbers;
        numbers.extend([text(" = "), result]);
        out.push(Formula { general, numbers });
        let clamped = if (0.0..=1.0).contains(&terms.result) {
            "code = ⌊255 · c + ½⌋"
        } else {
            "code = ⌊255 · c + ½⌋, kept in 0 … 255"
        };
        let numbers =
            vec![text("= ⌊255 · "), number(terms.result), text(" + ½⌋ = "), Piece::Result(Value::text(code))];
        out.push(Formula { general: clamped, numbers });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.channel_table());
        out.push(self.factor_table());
        let done = |index: u8| self.result.after.iter().find(|(layer, _)| *layer == index);
        let row = |&index: &u8| {
            let codes = done(index).map(|(_, codes)| *codes);
            let cells = [0, 1, 2, 3].map(|i| codes.map(|codes| Value::text(codes[i])).into());
            let depth = Value::from(self.layers[usize::from(index)].depth);
            let name = &self.names[usize::from(index)];
            Row::new(name, [depth].into_iter().chain(cells).collect()).active(self.layer == Some(index))
        };
        out.push(Table {
            title: "blend-layers",
            columns: vec!["column-depth", "column-red", "column-green", "column-blue", "column-alpha"],
            rows: self.list.iter().map(row).collect(),
        });
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::mark(self, out);
    }

    fn view(&self) -> View {
        let [width, height] = picture::size(self.layers.len());
        View { min: [0.0; 2], max: [width as f32, height as f32], y_up: false, grid: Grid::None }
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let parts = [0, 1, 2, 3].map(|i| {
            let names = ["column-red", "column-green", "column-blue", "column-alpha"];
            (names[i], Value::text(self.result.color[i]))
        });
        out.push(Fact { values: parts.to_vec(), ..Fact::answer("blend") });
    }
}

impl Snapshot {
    /// A layer's name.
    fn name(&self, index: u8) -> Value {
        Value::text(&self.names[usize::from(index)])
    }

    /// The codes that the layer in hand is blended over.
    fn before(&self) -> [u8; 4] {
        let done = self.result.after.iter().rposition(|(layer, _)| self.layer == Some(*layer));
        match done {
            None => self.result.color,
            Some(0) => self.settings.codes(),
            Some(place) => self.result.after[place - 1].1,
        }
    }

    /// What a channel of the layer in hand is made of.
    fn terms(&self, channel: usize) -> Option<Terms> {
        let layer = self.layers[usize::from(self.layer?)];
        Some(Terms::new(&layer.state, channel, layer.color, self.before()))
    }

    /// The numbers of all four channels.
    fn channel_table(&self) -> Table {
        let row = |channel: usize| {
            let code = Value::from(self.new[channel].map(Value::text));
            let known = self.new[channel].is_some();
            let cells = match self.terms(channel) {
                None => vec![Value::None; 6],
                Some(terms) => {
                    let result = Value::from(known.then_some(terms.result));
                    let of = [terms.source, terms.source_factor, terms.stored, terms.stored_factor];
                    of.into_iter().map(Value::from).chain([result, code]).collect()
                }
            };
            Row::new(CHANNELS[channel], cells).active(self.channel == Some(channel as u8))
        };
        Table {
            title: "blend-channels",
            columns: vec!["src", "Fs", "dst", "Fd", "c", "column-code"],
            rows: (0..4).map(row).collect(),
        }
    }

    /// The factors and operations by name.
    fn factor_table(&self) -> Table {
        let state = self.layer.map(|index| self.layers[usize::from(index)].state);
        let rows = [("row-color", 0), ("row-alpha", 3)].map(|(name, channel)| {
            let cells = match state {
                None => vec![Value::None; 3],
                Some(state) => {
                    let component = state.component(channel);
                    let [fs, fd] =
                        [component.src_factor, component.dst_factor].map(|f| Value::text(f.name()));
                    vec![fs, Value::text(component.operation.name()), fd]
                }
            };
            Row::new(name, cells)
        });
        Table { title: "blend-factors", columns: vec!["Fs", "op", "Fd"], rows: rows.to_vec() }
    }
}

/// `min(src, dst)` in numbers.
fn least_or_most(name: &'static str, terms: &Terms) -> Vec<Piece> {
    let [new, old] = [terms.source, terms.stored].map(|x| Piece::Number(x.into()));
    vec![Piece::Text(name), new, Piece::Text(", "), old, Piece::Text(")")]
}
