//! Why a pixel looks as it does, in one sentence: the decisive entry of its history.

use super::outcome::{Later, Outcome, PixelEntry, PixelHistory, SampleEntry};
use crate::{
    cull::Facing,
    message::{Message, Value},
};

impl PixelHistory {
    /// Who drew the pixel; or, where nobody did, what came nearest to it and why that failed. It also says
    /// what a person would look for in vain: a drawn colour that is black, or a blend that changed nothing.
    pub fn sentence(&self) -> Message {
        let samples = self.samples.count();
        let mut seen = self.entries.iter().map(|entry| (entry, entry.seen())).filter(|(_, seen)| *seen > 0);
        if let Some((entry, _)) = seen.clone().find(|(_, seen)| *seen == samples) {
            return about(self.drawn(entry), entry);
        }
        if seen.next().is_some() {
            return self.mean();
        }
        // Of several that came as far, the last one: it would have been seen.
        match self.entries.iter().enumerate().max_by_key(|(i, entry)| (entry.reached(), *i)) {
            Some((_, entry)) if entry.reached() > 0 => about(entry.missed(), entry),
            _ => Message::new("pipeline-pixel-why-nothing"),
        }
    }

    /// Who is seen in how many of several samples.
    fn mean(&self) -> Message {
        let seen = self.entries.iter().map(|entry| (entry, entry.seen())).filter(|(_, seen)| *seen > 0);
        let parts: Vec<_> = seen.clone().map(|(entry, seen)| format!("{seen} × {}", entry.name)).collect();
        let (count, parts) = (self.samples.count(), Value::Text(parts.join(", ")));
        let clear = count - seen.map(|(_, seen)| seen).sum::<u32>();
        let id = if clear > 0 { "pipeline-pixel-why-mean-clear" } else { "pipeline-pixel-why-mean" };
        Message::new(id).with("count", count).with("parts", parts).with("clear", clear)
    }

    /// What the last written entry made of the pixel.
    fn drawn(&self, entry: &PixelEntry) -> &'static str {
        let Outcome::Written { color: [before, after], .. } = entry.outcome else {
            return "pipeline-pixel-drawn";
        };
        let black = |[r, g, b, _]: [u8; 4]| [r, g, b] == [0; 3];
        let own_black = entry.source.is_some_and(|[r, g, b, _]| [r, g, b] == [0.0; 3]);
        if before == after && entry.source.is_some_and(|[.., alpha]| alpha == 0.0) {
            "pipeline-pixel-why-transparent"
        } else if !black(after) {
            "pipeline-pixel-drawn"
        } else if own_black {
            "pipeline-pixel-why-own-black"
        } else {
            "pipeline-pixel-why-left-black"
        }
    }
}

fn about(id: &'static str, entry: &PixelEntry) -> Message {
    let message = Message::new(id).with("name", Value::text(&entry.name));
    match entry.outcome {
        Outcome::CutOff(plane) => message.with("plane", Value::Word(plane.word())),
        _ => message,
    }
}

impl PixelEntry {
    /// In how many samples it is what is seen.
    fn seen(&self) -> u32 {
        let shown =
            |sample: &SampleEntry| matches!(sample.outcome, Outcome::Written { later: Later::Shown, .. });
        self.samples.iter().map(|sample| u32::from(shown(sample))).sum()
    }

    /// How near to being drawn here it came; 0 is not at all.
    fn reached(&self) -> u8 {
        match self.outcome {
            Outcome::Written { .. } => 9,
            Outcome::Depth { .. } => 8,
            Outcome::Stencil { .. } => 7,
            Outcome::Discarded { .. } => 6,
            Outcome::Scissored(_) => 5,
            Outcome::LostTie { .. } | Outcome::NoSample => 4,
            Outcome::CutOff(_) => 3,
            Outcome::Culled { would_cover: true, .. } => 2,
            _ => 0,
        }
    }

    /// Why it was not drawn, although it came near.
    fn missed(&self) -> &'static str {
        match self.outcome {
            Outcome::Depth { .. } => "pipeline-pixel-why-depth",
            Outcome::Stencil { .. } => "pipeline-pixel-why-stencil",
            Outcome::Discarded { .. } => "pipeline-pixel-why-discarded",
            Outcome::Scissored(_) => "pipeline-pixel-why-scissored",
            Outcome::LostTie { .. } => "pipeline-pixel-why-lost-tie",
            Outcome::NoSample => "pipeline-pixel-why-no-sample",
            Outcome::CutOff(_) => "pipeline-pixel-why-cut-off",
            Outcome::Culled { facing: Facing::Front, .. } => "pipeline-pixel-why-front-facing",
            Outcome::Culled { .. } => "pipeline-pixel-why-back-facing",
            _ => "pipeline-pixel-why-nothing",
        }
    }
}
