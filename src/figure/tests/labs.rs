//! Every lab on every preset: whole sentences, readable tables, pictures without accidents.

use rasterscope_core::{
    labs,
    replay::{Budget, Playback},
    scene::{self, PRESETS, Scene},
};
use rasterscope_figure::{
    figure::{Figure, Shape},
    geometry::Rect,
    layout::{self, Placement},
    png, svg, tables, text,
    theme::ThemeName,
    words::Words,
};

const SIZE: [f32; 2] = [692.0, 576.0];
/// Steps of a run that are looked at, spread evenly.
const STEPS: usize = 24;

/// The runs of all presets that name a lab.
fn runs() -> Vec<(&'static str, Box<dyn Playback>)> {
    let mut load = |file: &str| scene::model(file).map(<[u8]>::to_vec).ok_or_else(|| file.to_owned());
    let mut runs = Vec::new();
    for preset in PRESETS {
        let scene = Scene::from_json(preset.json.as_bytes()).and_then(|scene| scene.resolve(&mut load));
        let scene = scene.unwrap_or_else(|error| panic!("{}: {error:?}", preset.name));
        if scene.lab.is_some() {
            let run = labs::play(&scene, Budget::default());
            runs.push((preset.name, run.unwrap_or_else(|problem| panic!("{}: {problem:?}", preset.name))));
        }
    }
    runs
}

/// Calls `look` at the steps of a run that are looked at.
fn each_step(run: &mut dyn Playback, mut look: impl FnMut(&mut dyn Playback)) {
    let stride = (run.len() / STEPS).max(1);
    for step in (0..=run.len()).step_by(stride) {
        run.seek(step);
        look(run);
    }
}

fn drawn(run: &dyn Playback, theme: ThemeName, words: &Words) -> Figure {
    let view = run.view();
    let placement = Placement::fit(&view, SIZE, 12.0);
    layout::draw(&run.marks(), &view, &placement, SIZE, theme.theme(), words)
}

#[test]
fn every_sentence_formula_and_table_is_whole() {
    let words = Words::default();
    for (name, mut run) in runs() {
        each_step(run.as_mut(), |run| {
            let place = format!("{name}, step {}", run.cursor());
            words.try_message(&run.sentence()).unwrap_or_else(|problem| panic!("{place}: {problem}"));
            let before = run.tables_before();
            let mut written: Vec<String> = Vec::new();
            for table in tables::format(&run.tables(), &before, &words) {
                assert!(table.rows.iter().all(|row| row.cells.len() == table.columns.len()), "{place}");
                written.push(table.title);
                written.extend(table.columns);
                for cell in table.rows.into_iter().flat_map(|row| row.cells) {
                    written.extend([cell.text, cell.exact]);
                }
            }
            for formula in run.formulas() {
                written.extend(tables::formula(&formula, &words).into_iter().flatten().map(|run| run.text));
            }
            for text in written {
                assert!(!text.contains('⟨'), "{place}: {text}");
            }
        });
        for (step, marker) in run.markers() {
            assert!(marker.label.is_none_or(|id| words.has(id)), "{name}, step {step}: {:?}", marker.label);
        }
        for (step, caption) in run.captions() {
            assert_eq!(words.try_message(&caption).err(), None, "{name}, step {step}");
        }
    }
}

#[test]
fn no_text_of_a_picture_is_cut_off_covered_or_without_a_glyph() {
    let words = Words::default();
    let canvas = Rect { min: [0.0; 2], max: SIZE.map(f64::from) };
    for (name, mut run) in runs() {
        for theme in [ThemeName::Dark, ThemeName::Projector] {
            each_step(run.as_mut(), |run| {
                let mut boxes: Vec<(String, Rect)> = Vec::new();
                for shape in drawn(run, theme, &words).shapes {
                    let Shape::Text { at, align, text, font, size, .. } = shape else { continue };
                    let place = format!("{name}, step {}, {}: {text}", run.cursor(), theme.name());
                    assert_eq!(text::layout(font, size, &text).missing, [], "{place}");
                    let extent = text::measure(font, size, &text);
                    let min = text::corner(at, align, extent).map(f64::from);
                    let rect = Rect { min, max: [0, 1].map(|axis| min[axis] + f64::from(extent[axis])) };
                    assert!(rect.inside(canvas), "{place} is cut off");
                    for (other, taken) in &boxes {
                        assert!(!rect.overlaps(*taken), "{place} covers {other}");
                    }
                    boxes.push((text, rect));
                }
            });
        }
    }
}

#[test]
fn pictures_are_written_and_alike_every_time() {
    let words = Words::default();
    for (name, mut run) in runs() {
        run.seek(run.len() / 2);
        let figure = drawn(run.as_ref(), ThemeName::Light, &words);
        let svg = svg::svg(&figure);
        assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{name}");
        assert!(svg.len() < 400_000, "{name}: {} bytes", svg.len());
        run.seek(0);
        run.seek(run.len() / 2);
        let again = drawn(run.as_ref(), ThemeName::Light, &words);
        assert_eq!(png::png(&figure, 0.5), png::png(&again, 0.5), "{name}");
    }
}
