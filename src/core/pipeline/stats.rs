//! What came into each stage, what went out, what was dropped and why.

use serde::{Serialize, Serializer, ser::SerializeMap};

use super::Skip;
use crate::{math::Tally, message::Value, stage::Stage};

/// Why something does not go on to the next stage.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Reason {
    /// A body around the object lies outside the frustum.
    ObjectFrustum,
    /// The triangle lies outside one plane of the frustum.
    Frustum,
    /// It faces away and the draw culls that.
    BackFace,
    /// It faces the eye and the draw culls that.
    FrontFace,
    /// It has no area as seen from the eye.
    Degenerate,
    /// Clipping left nothing of it.
    Clipped,
    /// It was meant to be dropped earlier, but that skip is off.
    Carried,
    /// The scissor rectangle does not hold its pixel.
    Scissor,
    /// The alpha test discarded it.
    Discarded,
    /// The stencil test failed.
    Stencil,
    /// The depth test failed.
    Depth,
    /// The pixel was written before.
    Redrawn,
}

impl Reason {
    /// Every reason, in pipeline order.
    pub const ALL: [Self; 12] = [
        Self::ObjectFrustum,
        Self::Frustum,
        Self::BackFace,
        Self::FrontFace,
        Self::Degenerate,
        Self::Clipped,
        Self::Carried,
        Self::Scissor,
        Self::Discarded,
        Self::Stencil,
        Self::Depth,
        Self::Redrawn,
    ];

    /// Its name in the statistics of `render`.
    pub fn name(self) -> &'static str {
        match self {
            Self::ObjectFrustum => "object-frustum",
            Self::Frustum => "frustum",
            Self::BackFace => "back-face",
            Self::FrontFace => "front-face",
            Self::Degenerate => "degenerate",
            Self::Clipped => "clipped",
            Self::Carried => "carried",
            Self::Scissor => "scissor",
            Self::Discarded => "discarded",
            Self::Stencil => "stencil",
            Self::Depth => "depth",
            Self::Redrawn => "redrawn",
        }
    }

    /// Message id of a word behind the count: `5 back-facing`.
    pub fn word(self) -> &'static str {
        match self {
            Self::ObjectFrustum => "pipeline-reason-object-frustum",
            Self::Frustum => "pipeline-reason-frustum",
            Self::BackFace => "pipeline-reason-back-face",
            Self::FrontFace => "pipeline-reason-front-face",
            Self::Degenerate => "pipeline-reason-degenerate",
            Self::Clipped => "pipeline-reason-clipped",
            Self::Carried => "pipeline-reason-carried",
            Self::Scissor => "pipeline-reason-scissor",
            Self::Discarded => "pipeline-reason-discarded",
            Self::Stencil => "pipeline-reason-stencil",
            Self::Depth => "pipeline-reason-depth",
            Self::Redrawn => "pipeline-reason-redrawn",
        }
    }
}

/// What a stage counts at its end.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unit {
    /// Triangles.
    Triangles,
    /// Vertices, or corners of polygons.
    Vertices,
    /// Spans of pixels.
    Spans,
    /// Fragments.
    Fragments,
    /// Pixels.
    Pixels,
}

impl Unit {
    /// What comes out of a stage.
    pub fn of(stage: Stage) -> Self {
        match stage {
            Stage::Scene | Stage::Cull | Stage::Clip => Self::Triangles,
            Stage::Model | Stage::View | Stage::ClipSpace | Stage::Divide | Stage::Viewport => Self::Vertices,
            Stage::ScanConversion => Self::Spans,
            Stage::Fragments | Stage::Stencil | Stage::Depth | Stage::Blend => Self::Fragments,
            Stage::Image => Self::Pixels,
        }
    }

    /// What comes into a stage.
    pub fn into(stage: Stage) -> Self {
        match stage {
            Stage::Scene | Stage::Cull | Stage::Clip | Stage::ScanConversion => Self::Triangles,
            Stage::Model | Stage::View | Stage::ClipSpace | Stage::Divide | Stage::Viewport => Self::Vertices,
            Stage::Fragments => Self::Spans,
            Stage::Stencil | Stage::Depth | Stage::Blend | Stage::Image => Self::Fragments,
        }
    }

    /// Message id of its short name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Triangles => "pipeline-unit-triangles",
            Self::Vertices => "pipeline-unit-vertices",
            Self::Spans => "pipeline-unit-spans",
            Self::Fragments => "pipeline-unit-fragments",
            Self::Pixels => "pipeline-unit-pixels",
        }
    }
}

/// The counters of one stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StageCount {
    /// What came in, in [`Unit::into`] the stage.
    pub came: u64,
    /// What went out, in [`Unit::of`] the stage.
    pub went: u64,
    /// Whether any draw uses the stage.
    pub on: bool,
    dropped: [u64; Reason::ALL.len()],
}

impl StageCount {
    /// How many were dropped for a reason.
    pub fn dropped(&self, reason: Reason) -> u64 {
        self.dropped[reason as usize]
    }

    /// The reasons with their counts, without those that did not occur.
    pub fn reasons(&self) -> impl Iterator<Item = (Reason, u64)> {
        Reason::ALL.into_iter().zip(self.dropped).filter(|(_, count)| *count > 0)
    }

    pub(super) fn drop(&mut self, reason: Reason, count: u64) {
        self.dropped[reason as usize] += count;
    }
}

/// The counters of one image.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stats {
    stages: [StageCount; Stage::ALL.len()],
    skipped: [u64; Skip::ALL.len()],
    /// Triangles that clipping cut.
    pub cut: u64,
    /// Decisions and roundings, and those that needed exact arithmetic.
    pub tally: Tally,
}

impl Stats {
    /// The counters of a stage.
    pub fn stage(&self, stage: Stage) -> &StageCount {
        &self.stages[stage as usize]
    }

    /// How much work a skip saved: objects' triangles, triangles, pixels, fragments, or stages.
    pub fn skipped(&self, skip: Skip) -> u64 {
        self.skipped[skip as usize]
    }

    /// What went out of a stage, for its chip.
    pub fn went(&self, stage: Stage) -> Value {
        Value::Int(i64::try_from(self.stage(stage).went).unwrap_or(i64::MAX))
    }

    pub(super) fn stage_mut(&mut self, stage: Stage) -> &mut StageCount {
        &mut self.stages[stage as usize]
    }

    /// Counts what passes a stage.
    pub(super) fn pass(&mut self, stage: Stage, came: usize, went: usize) {
        let count = self.stage_mut(stage);
        count.on = true;
        count.came += came as u64;
        count.went += went as u64;
    }

    /// Adds the counters of other stages.
    pub(super) fn add(&mut self, other: &Self) {
        for (count, more) in self.stages.iter_mut().zip(&other.stages) {
            count.came += more.came;
            count.went += more.went;
            count.on |= more.on;
            count.dropped.iter_mut().zip(more.dropped).for_each(|(count, more)| *count += more);
        }
        self.skipped.iter_mut().zip(other.skipped).for_each(|(count, more)| *count += more);
        self.cut += other.cut;
        self.tally += other.tally;
    }

    pub(super) fn skip(&mut self, skip: Skip, count: u64) {
        self.skipped[skip as usize] += count;
    }
}

/// As `render` prints it: one object a stage, then the skips.
impl Serialize for Stats {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for stage in Stage::ALL {
            let name = stage.word().trim_start_matches("stage-");
            map.serialize_entry(name, self.stage(stage))?;
        }
        let skipped: Vec<_> = Skip::ALL.into_iter().zip(self.skipped).collect();
        map.serialize_entry("skipped", &Pairs(&skipped, Skip::name))?;
        map.serialize_entry("cut", &self.cut)?;
        map.serialize_entry("decisions", &self.tally.calls)?;
        map.serialize_entry("exact", &self.tally.exact)?;
        map.end()
    }
}

impl Serialize for StageCount {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("in", &self.came)?;
        map.serialize_entry("out", &self.went)?;
        let dropped: Vec<_> = self.reasons().collect();
        if !dropped.is_empty() {
            map.serialize_entry("dropped", &Pairs(&dropped, Reason::name))?;
        }
        map.end()
    }
}

/// Counts under their names.
struct Pairs<'p, N>(&'p [(N, u64)], fn(N) -> &'static str);

impl<N: Copy> Serialize for Pairs<'_, N> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|&(name, count)| (self.1(name), count)))
    }
}
