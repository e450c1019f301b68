//! What the history of a pixel says: message ids with arguments.

use super::pixel::{Later, Outcome, PixelEntry, PixelHistory};
use crate::{
    cull::Facing,
    depth::DepthFormat,
    explain::Role,
    message::{Message, Value},
    scene::{Draw, Scene},
    stencil::StencilOutcome,
};

impl PixelEntry {
    /// The named reason, in a few words.
    pub fn reason(&self) -> Message {
        match self.outcome {
            Outcome::ObjectOutside(plane) => {
                Message::new("pipeline-pixel-object-outside").with("plane", Value::Word(plane.word()))
            }
            Outcome::Outside(plane) => {
                Message::new("pipeline-pixel-outside").with("plane", Value::Word(plane.word()))
            }
            Outcome::Culled { facing: Facing::Back, .. } => Message::new("pipeline-pixel-back-facing"),
            Outcome::Culled { facing: Facing::Front, .. } => Message::new("pipeline-pixel-front-facing"),
            Outcome::Culled { facing: Facing::Degenerate, .. } => Message::new("pipeline-pixel-degenerate"),
            Outcome::ClippedAway => Message::new("pipeline-pixel-clipped-away"),
            Outcome::CutOff(plane) => {
                Message::new("pipeline-pixel-cut-off").with("plane", Value::Word(plane.word()))
            }
            Outcome::ZeroArea => Message::new("pipeline-pixel-zero-area"),
            Outcome::OutsideEdge { .. } => Message::new("pipeline-pixel-outside-edge"),
            Outcome::LostTie { .. } => Message::new("pipeline-pixel-lost-tie"),
            Outcome::Stencil { .. } => Message::new("pipeline-pixel-stencil"),
            Outcome::Depth { .. } => Message::new("pipeline-pixel-depth"),
            Outcome::Written { later: Later::Overwritten, .. } => Message::new("pipeline-pixel-overwritten"),
            Outcome::Written { later: Later::BlendedOver, .. } => Message::new("pipeline-pixel-blended-over"),
            Outcome::Written { later: Later::Shown, .. } => Message::new("pipeline-pixel-written"),
        }
    }

    /// The numbers behind the reason, a few short lines.
    pub fn details(&self, scene: &Scene) -> Vec<Message> {
        let format = scene.depth_format;
        let draw = &scene.draws[self.draw];
        match self.outcome {
            Outcome::Culled { determinant, would_cover, .. } => {
                let number = Message::new("pipeline-pixel-determinant").with("value", determinant);
                let covers = would_cover.then(|| Message::new("pipeline-pixel-would-cover"));
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
            Outcome::Stencil { stored } => self.stencil(draw, stored, StencilOutcome::Fail),
            Outcome::Depth { new, stored, stencil } => {
                let mut lines = self.stencil(draw, stencil, StencilOutcome::DepthFail);
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

    /// Whether it is a fragment: what a run over the fragments steps through.
    pub fn is_fragment(&self) -> bool {
        matches!(self.outcome, Outcome::Stencil { .. } | Outcome::Depth { .. } | Outcome::Written { .. })
    }

    /// Whether it was drawn, not drawn, or never looked at here.
    pub fn role(&self) -> Role {
        match self.outcome {
            Outcome::Written { .. } => Role::Accepted,
            Outcome::LostTie { .. } => Role::Tie,
            Outcome::Stencil { .. } | Outcome::Depth { .. } | Outcome::Culled { would_cover: true, .. } => {
                Role::Rejected
            }
            _ => Role::Skipped,
        }
    }
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

impl PixelHistory {
    /// Who drew the pixel, in one sentence.
    pub fn sentence(&self) -> Message {
        let drawn = self.entries.iter().rfind(|entry| matches!(entry.outcome, Outcome::Written { .. }));
        match drawn {
            Some(entry) => Message::new("pipeline-pixel-drawn").with("name", Value::text(&entry.name)),
            None => Message::new("pipeline-pixel-clear"),
        }
    }
}
