//! The tour: one page with a picture and the numbers of every stage, for any scene.

use rasterscope_cli::tour::{TourOptions, tour};
use rasterscope_core::{labs::Stage, scene::PRESETS};
use rasterscope_figure::words::Words;
use std::{fs, path::PathBuf};

/// A folder of this test's own, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("rasterscope-tour-{name}-{}", std::process::id()));
        Self(path)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn page(file: Option<&str>, name: &str) -> String {
    let folder = Folder::new(name);
    let options = TourOptions { file: file.map(PathBuf::from), output: folder.0.clone() };
    let path = tour(&options, None).expect("the tour can be written");
    fs::read_to_string(path).expect("the page is there")
}

/// The part of the page about one stage.
fn section(page: &str, stage: Stage) -> &str {
    let anchor = stage.word().trim_start_matches("stage-");
    let from = page.find(&format!("<section id=\"{anchor}\">")).unwrap_or_else(|| panic!("no {anchor}"));
    let len = page[from..].find("</section>").expect("sections end");
    &page[from..from + len]
}

#[test]
fn every_stage_has_a_picture_and_numbers() {
    let (page, words) = (page(None, "default"), Words::default());
    for stage in Stage::ALL {
        let section = section(&page, stage);
        assert!(section.contains(&words.word(stage.word())), "{stage:?} has no title");
        assert!(section.contains("<img src=\"data:image/"), "{stage:?} has no picture");
        assert!(section.contains("<td") || section.contains("class=\"dim\""), "{stage:?} has no numbers");
    }
}

/// The counts of the scene that the design gives with its numbers.
#[test]
fn the_default_scene_is_counted_right() {
    let page = page(None, "counts");
    for (stage, came, went) in [
        (Stage::Model, "In: 9 vertices", "Out: 9 vertices"),
        (Stage::Cull, "In: 3 triangles", "Out: 2 triangles"),
        (Stage::Clip, "In: 2 triangles", "Out: 3 triangles"),
        (Stage::Viewport, "In: 7 vertices", "Out: 7 vertices"),
        (Stage::ScanConversion, "In: 3 triangles", "Out: 51 spans"),
        (Stage::Fragments, "In: 51 spans", "Out: 522 fragments"),
        (Stage::Depth, "In: 522 fragments", "Out: 422 fragments"),
        (Stage::Image, "In: 422 fragments", "Out: 360 pixels"),
    ] {
        let section = section(&page, stage);
        assert!(section.contains(came), "{stage:?}: not {came}");
        assert!(section.contains(went), "{stage:?}: not {went}");
    }
    assert!(section(&page, Stage::ScanConversion).contains("A.2"), "clipped parts wear their names");
}

#[test]
fn every_preset_can_be_toured_and_the_page_needs_nothing_else() {
    for preset in PRESETS {
        let page = page(Some(preset.name), preset.name);
        for foreign in ["<script", "src=\"http", "href=\"http", "url(http", "⟨", "NaN<"] {
            assert!(!page.contains(foreign), "{foreign} in the tour of {}", preset.name);
        }
        assert!(page.ends_with("</html>\n"));
    }
}
