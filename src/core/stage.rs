//! The stages of the pipeline by name.

/// The stages of the pipeline, left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[expect(missing_docs, reason = "the names are the meaning")]
pub enum Stage {
    Scene,
    Model,
    View,
    ClipSpace,
    Cull,
    Clip,
    Divide,
    Viewport,
    ScanConversion,
    Fragments,
    Stencil,
    Depth,
    Blend,
    Image,
}

impl Stage {
    /// In the order of the data flow.
    pub const ALL: [Self; 14] = [
        Self::Scene,
        Self::Model,
        Self::View,
        Self::ClipSpace,
        Self::Cull,
        Self::Clip,
        Self::Divide,
        Self::Viewport,
        Self::ScanConversion,
        Self::Fragments,
        Self::Stencil,
        Self::Depth,
        Self::Blend,
        Self::Image,
    ];

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Scene => "stage-scene",
            Self::Model => "stage-model",
            Self::View => "stage-view",
            Self::ClipSpace => "stage-clip-space",
            Self::Cull => "stage-cull",
            Self::Clip => "stage-clip",
            Self::Divide => "stage-divide",
            Self::Viewport => "stage-viewport",
            Self::ScanConversion => "stage-scan-conversion",
            Self::Fragments => "stage-fragments",
            Self::Stencil => "stage-stencil",
            Self::Depth => "stage-depth",
            Self::Blend => "stage-blend",
            Self::Image => "stage-image",
        }
    }
}
