//! What the history of a pixel says: message ids with arguments.

use super::pixel::{Outcome, PixelEntry, PixelHistory};
use crate::{
    cull::Facing,
    depth::DepthFormat,
    explain::Role,
    message::{Message, Value},
    scene::Scene,
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
            Outcome::Written { overwritten: true, .. } => Message::new("pipeline-pixel-overwritten"),
            Outcome::Written { .. } => Message::new("pipeline-pixel-written"),
        }
    }

    /// The numbers behind the reason, at most two lines.
    pub fn details(&self, scene: &Scene) -> Vec<Message> {
        let format = scene.depth_format;
        let draw = &scene.draws[self.draw];
        match self.outcome {
            Outcome::Culled { would_cover: true, .. } => vec![Message::new("pipeline-pixel-would-cover")],
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
            Outcome::Stencil { stored } => draw
                .stencil
                .iter()
                .map(|state| {
                    let masked = |value: u8| Value::Code { code: (value & state.read_mask).into(), width: 8 };
                    Message::new("pipeline-pixel-stencil-values")
                        .with("reference", masked(state.reference))
                        .with("compare", Value::text(state.compare.sign()))
                        .with("stored", masked(stored))
                })
                .collect(),
            Outcome::Depth { new, stored } | Outcome::Written { depth: Some(new), stored, .. } => {
                let failed = matches!(self.outcome, Outcome::Depth { .. });
                let compare = draw.depth.compare;
                let compare = if failed { compare.opposite_sign() } else { compare.sign() };
                let line = |id, [new, stored]: [Value; 2]| {
                    Message::new(id)
                        .with("new", new)
                        .with("compare", Value::text(compare))
                        .with("stored", stored)
                };
                let id = if failed { "pipeline-pixel-depth-kept" } else { "pipeline-pixel-depth-stored" };
                let mut lines = vec![line(id, [new, stored].map(|code| Value::F64(format.decode(code))))];
                if format != DepthFormat::F32 {
                    let code = |code| Value::Code { code, width: format.bits() };
                    lines.push(line("pipeline-pixel-codes", [new, stored].map(code)));
                }
                lines
            }
            _ => Vec::new(),
        }
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
