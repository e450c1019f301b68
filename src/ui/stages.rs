//! What the ribbon says of each stage.

use crate::{app::App, shell::ribbon::Chip};
use rasterscope_core::labs::Stage;

/// The message that says what is said in one sentence about a lab.
pub(crate) fn about(lab: &str) -> &'static str {
    match lab {
        "pipeline" => "pipeline-about",
        "transform" => "transform-about",
        "cohen-sutherland" => "cohen-sutherland-about",
        "scanline" => "scanline-about",
        _ => "z-buffer-about",
    }
}

impl App {
    /// The chips of the ribbon.
    pub(crate) fn chips(&self) -> Vec<Chip> {
        Stage::ALL
            .into_iter()
            .map(|stage| Chip { stage, count: None, unit: String::new(), skipped: None, thumbnail: None })
            .collect()
    }
}
