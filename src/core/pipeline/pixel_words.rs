//! What the history of a pixel says: message ids with arguments.

use super::outcome::{Later, Outcome, PixelEntry, Placed, SampleEntry};
use crate::{
    blend::{BlendOperation, Terms},
    cull::Facing,
    depth::{DepthFormat, Early},
    explain::Role,
    message::{Message, Value},
    scene::{Draw, Scene},
    stencil::StencilOutcome,
};

/// The channels' names: message ids.
const CHANNELS: [&str; 4] = ["row-red", "row-green", "row-blue", "row-alpha"];

impl Outcome {
    /// Its name, in a few words.
    fn reason(&self) -> Message {
        match *self {
            Outcome::ObjectOutside(plane) => {
                Message::new("pipeline-pixel-object-outside").with("plane", Value::Word(plane.word()))
            }
            Outcome::Outside(plane) => {
                Message::new("pipeline-pixel-outside").with("plane", Value::Word(plane.word()))
            }
            Outcome::Culled { facing: Facing::Back, .. } => Message::new("pipeline-pixel-back-facing"),
            Outcome::Culled { facing: Facing::Front, .. } => Message::new("pipeline-pixel-front-facing"),
            Outcome::Culled { facing: Facing::Degenerate, .. } => Message::new("pipeline-pixel-degenerate"),
            Outcome::ClippedAway(removed) => match removed.last {
                Some(plane) => {
                    Message::new("pipeline-pixel-clipped-away").with("plane", Value::Word(plane.word()))
                }
                None => Message::new("pipeline-pixel-rounded-away"),
            },
            Outcome::CutOff(plane) => {
                Message::new("pipeline-pixel-cut-off").with("plane", Value::Word(plane.word()))
            }
            Outcome::ZeroArea => Message::new("pipeline-pixel-zero-area"),
            Outcome::OutsideEdge { .. } => Message::new("pipeline-pixel-outside-edge"),
            Outcome::LostTie { .. } => Message::new("pipeline-pixel-lost-tie"),
            Outcome::NoSample => Message::new("pipeline-pixel-no-sample"),
            Outcome::Scissored(_) => Message::new("pipeline-pixel-scissored"),
            Outcome::Discarded { .. } => Message::new("pipeline-pixel-discarded"),
            Outcome::Stencil { .. } => Message::new("pipeline-pixel-stencil"),
            Outcome::Depth { .. } => Message::new("pipeline-pixel-depth"),
            Outcome::Written { later: Later::Overwritten, .. } => Message::new("pipeline-pixel-overwritten"),
            Outcome::Written { later: Later::BlendedOver, .. } => Message::new("pipeline-pixel-blended-over"),
            Outcome::Written { later: Later::Shown, .. } => Message::new("pipeline-pixel-written"),
        }
    }
}

impl PixelEntry {
    /// The named reason, in a few words.
    pub fn reason(&self) -> Message {
        self.outcome.reason()
    }

    /// The numbers behind the reason, a few short lines; of several samples those of each, under its number.
    pub fn details(&self, scene: &Scene) -> Vec<Message> {
        let (Some(at), 2..) = (self.at, scene.samples) else {
            let placed = self.samples.first().and_then(|sample| sample.placed);
            return self.numbers((self.outcome, placed), scene);
        };
        let mut lines = vec![Message::new("pipeline-pixel-shaded").with("at", at)];
        for SampleEntry { sample, outcome, placed } in &self.samples {
            let reason = Value::Word(outcome.reason().id);
            lines.push(
                Message::new("pipeline-pixel-sample")
                    .with("index", u32::from(*sample))
                    .with("reason", reason),
            );
            // What all samples have alike, such as a colour, is said of the first one.
            let numbers = self.numbers((*outcome, *placed), scene);
            let new: Vec<_> = numbers.into_iter().filter(|line| !lines.contains(line)).collect();
            lines.extend(new);
        }
        lines
    }

    fn numbers(&self, (outcome, placed): (Outcome, Option<Placed>), scene: &Scene) -> Vec<Message> {
        let format = scene.depth_format;
        let draw = &scene.draws[self.draw];
        match outcome {
            Outcome::Culled { determinant, would_cover, .. } => {
                let number = Message::new("pipeline-pixel-determinant").with("value", determinant);
                let id = if scene.samples > 1 {
                    "pipeline-pixel-would-cover-samples"
                } else {
                    "pipeline-pixel-would-cover"
                };
                let covers = would_cover.then(|| Message::new(id));
                std::iter::once(number).chain(covers).collect()
            }
            Outcome::OutsideEdge { edge, value } => {
                vec![
                    Message::new("pipeline-pixel-edge-value")
                        .with("edge", edge_name(edge))
                        .with("value", value),
                ]
            }
            Outcome::LostTie { edge } => {
                vec![Message::new("pipeline-pixel-on-edge").with("edge", edge_name(edge))]
            }
            Outcome::ClippedAway(removed) => removed
                .others
                .iter()
                .map(|plane| {
                    Message::new("pipeline-pixel-cut-before").with("plane", Value::Word(plane.word()))
                })
                .collect(),
            Outcome::Scissored(scissor) => {
                let [right, bottom] = scissor.end();
                let ends = [("left", scissor.x), ("right", right), ("top", scissor.y), ("bottom", bottom)];
                let message = Message::new("pipeline-pixel-scissor");
                vec![ends.into_iter().fold(message, |message, (name, end)| message.with(name, end))]
            }
            Outcome::Discarded { alpha } => {
                let test = draw.alpha_test.unwrap_or_default();
                let sign = test.compare.opposite_sign();
                let id = if sign.is_empty() { "pipeline-pixel-alpha-never" } else { "pipeline-pixel-alpha" };
                let numbers = Message::new(id)
                    .with("alpha", alpha)
                    .with("compare", Value::text(sign))
                    .with("reference", test.reference);
                let early = match Early::of(true, draw.depth.test, draw.stencil.as_ref()) {
                    Early::Never => "pipeline-pixel-early-never",
                    Early::Whole | Early::TestOnly => "pipeline-pixel-early-test",
                };
                vec![numbers, Message::new(early)]
            }
            Outcome::Stencil { stored } => self.stencil(draw, stored, StencilOutcome::Fail),
            Outcome::Depth { new, stored, stencil } => {
                let mut lines = self.stencil(draw, stencil, StencilOutcome::DepthFail);
                lines.extend(placed.map(made_of));
                lines.extend(depths(
                    "pipeline-pixel-depth-kept",
                    draw.depth.compare.opposite_sign(),
                    format,
                    [new, stored],
                ));
                lines
            }
            Outcome::Written { depth, stored, color: [before, after], stencil, .. } => {
                let mut lines = self.stencil(draw, stencil, StencilOutcome::Pass);
                if let Some(new) = depth {
                    lines.extend(placed.map(made_of));
                    let id = if draw.depth.write {
                        "pipeline-pixel-depth-stored"
                    } else {
                        "pipeline-pixel-depth-unwritten"
                    };
                    lines.extend(depths(id, draw.depth.compare.sign(), format, [new, stored]));
                }
                let id =
                    if draw.blend.is_some() { "pipeline-pixel-blended" } else { "pipeline-pixel-replaced" };
                let codes = |[r, g, b, a]: [u8; 4]| Value::text(format_args!("({r}, {g}, {b}, {a})"));
                lines.extend(self.blended(draw, before, after));
                lines.push(Message::new(id).with("before", codes(before)).with("after", codes(after)));
                lines
            }
            _ => Vec::new(),
        }
    }

    /// The stencil test with its masks, and what it stored; nothing without one.
    fn stencil(&self, draw: &Draw, [before, after]: [u8; 2], outcome: StencilOutcome) -> Vec<Message> {
        let Some(state) = draw.stencil else { return Vec::new() };
        let code = |value: u8| Value::Code { code: value.into(), width: 8 };
        let failed = outcome == StencilOutcome::Fail;
        let sign = if failed { state.compare.opposite_sign() } else { state.compare.sign() };
        let test = if sign.is_empty() {
            Message::new("pipeline-pixel-stencil-compare").with("compare", Value::text(state.compare.name()))
        } else {
            Message::new("pipeline-pixel-stencil-values")
                .with("reference", u32::from(state.reference))
                .with("stored", u32::from(before))
                .with("mask", code(state.read_mask))
                .with("compare", Value::text(sign))
        };
        let stored = Message::new("pipeline-pixel-stencil-stored")
            .with("operation", Value::text(state.operation(outcome).name()))
            .with("before", u32::from(before))
            .with("after", u32::from(after))
            .with("mask", code(state.write_mask));
        vec![test, stored]
    }

    /// The blend equation of each channel in numbers; nothing without one.
    fn blended(&self, draw: &Draw, before: [u8; 4], after: [u8; 4]) -> Vec<Message> {
        let (Some(state), Some(source)) = (draw.blend, self.source) else { return Vec::new() };
        let line = |channel: usize| {
            let terms = Terms::new(&state, channel, source, before);
            let id = match state.component(channel).operation {
                BlendOperation::Add => "pipeline-pixel-blend-add",
                BlendOperation::Subtract => "pipeline-pixel-blend-subtract",
                BlendOperation::ReverseSubtract => "pipeline-pixel-blend-reverse",
                BlendOperation::Min => "pipeline-pixel-blend-min",
                BlendOperation::Max => "pipeline-pixel-blend-max",
            };
            Message::new(id)
                .with("channel", Value::Word(CHANNELS[channel]))
                .with("source", terms.source)
                .with("source-factor", terms.source_factor)
                .with("stored", terms.stored)
                .with("stored-factor", terms.stored_factor)
                .with("result", terms.result)
                .with("code", Value::text(after[channel]))
        };
        (0..4).map(line).collect()
    }

    /// Whether it is a fragment: what a run over the fragments steps through.
    pub fn is_fragment(&self) -> bool {
        matches!(
            self.outcome,
            Outcome::Discarded { .. }
                | Outcome::Stencil { .. }
                | Outcome::Depth { .. }
                | Outcome::Written { .. }
        )
    }

    /// Whether it was drawn, not drawn, or never looked at here.
    pub fn role(&self) -> Role {
        match self.outcome {
            Outcome::Written { .. } => Role::Accepted,
            Outcome::LostTie { .. } => Role::Tie,
            Outcome::Stencil { .. }
            | Outcome::Depth { .. }
            | Outcome::Scissored(_)
            | Outcome::Discarded { .. }
            | Outcome::Culled { would_cover: true, .. } => Role::Rejected,
            _ => Role::Skipped,
        }
    }
}

/// What a depth is made of.
fn made_of(Placed { plane, bias }: Placed) -> Message {
    let sum = (plane + bias).clamp(0.0, 1.0);
    let id = if bias == 0.0 {
        "pipeline-pixel-clamped"
    } else if sum == plane + bias {
        "pipeline-pixel-biased"
    } else {
        "pipeline-pixel-biased-clamped"
    };
    Message::new(id).with("plane", plane).with("bias", bias).with("sum", sum)
}

/// A depth test in numbers, and in codes unless the depths are the codes.
fn depths(id: &'static str, sign: &'static str, format: DepthFormat, codes: [u32; 2]) -> Vec<Message> {
    let line = |id, [new, stored]: [Value; 2]| {
        Message::new(id).with("new", new).with("compare", Value::text(sign)).with("stored", stored)
    };
    let code = |code| Value::Code { code, width: format.bits() };
    vec![
        line(id, codes.map(|code| Value::F64(format.decode(code)))),
        line("pipeline-pixel-codes", codes.map(code)),
    ]
}

/// An edge's name on the canvas.
fn edge_name(edge: u8) -> Value {
    Value::text(format_args!("E{edge}"))
}
