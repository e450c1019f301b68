//! Nothing depends on colour alone: in a greyscale picture of each scene of the mocks, a mark of
//! another role would be seen.

use rasterscope_core::{
    explain::{Mark, Role, View},
    labs,
    replay::{Budget, Playback},
    scene::{self, Scene},
};
use rasterscope_figure::{
    layout::{self, Placement},
    png,
    theme::{Theme, ThemeName},
    words::Words,
};

const SIZE: [f32; 2] = [692.0, 576.0];
/// A difference that an eye sees, of 255.
const SEEN: u8 = 32;
/// So many points that it sees them.
const ENOUGH: usize = 12;

/// The run of a preset at the step whose sentence is `sentence`, for the `nth` time.
fn at(preset: &str, sentence: &str, nth: usize) -> Box<dyn Playback> {
    let preset = scene::preset(preset).expect("the preset is built in");
    let mut load = |file: &str| scene::model(file).map(<[u8]>::to_vec).ok_or_else(|| file.to_owned());
    let scene = Scene::from_json(preset.json.as_bytes()).and_then(|scene| scene.resolve(&mut load));
    let mut run = labs::play(&scene.expect("it is right"), Budget::default()).expect("it runs");
    let mut left = nth;
    for step in 0..=run.len() {
        run.seek(step);
        left -= usize::from(run.sentence().id == sentence);
        if left == 0 {
            return run;
        }
    }
    panic!("{sentence} is not said {nth} times");
}

/// The brightness of each point.
fn grey(marks: &[Mark], view: &View, theme: &Theme, words: &Words) -> Vec<u8> {
    let placement = Placement::fit(view, SIZE, 12.0);
    let figure = layout::draw(marks, view, &placement, SIZE, theme, words);
    let weigh = |[red, green, blue]: [u8; 3]| {
        (0.2126 * f32::from(red) + 0.7152 * f32::from(green) + 0.0722 * f32::from(blue)) as u8
    };
    let pixels = png::pixmap(&figure, 1.0);
    pixels.pixels().iter().map(|pixel| weigh([pixel.red(), pixel.green(), pixel.blue()])).collect()
}

/// The role of a mark that is drawn by its role, and the kind of mark.
fn role_of(mark: &mut Mark) -> Option<(&mut Role, u8)> {
    match mark {
        Mark::Point { role, .. } => Some((role, 0)),
        Mark::Segment { role, .. } => Some((role, 1)),
        Mark::Polygon { role, .. } => Some((role, 2)),
        Mark::Pixel { role, .. } => Some((role, 3)),
        Mark::Guide { role, .. } => Some((role, 4)),
        Mark::Curve { role, .. } => Some((role, 5)),
        Mark::Run { .. }
        | Mark::Shade { .. }
        | Mark::Span { .. }
        | Mark::Text { .. }
        | Mark::Key { .. }
        | Mark::Hint { .. }
        | Mark::Image { .. }
        | Mark::Numbers(_)
        | Mark::Ramp { .. }
        | Mark::Wires(_)
        | Mark::Space(_) => None,
    }
}

/// The first mark of each role and kind: its place among `marks`.
fn samples(marks: &[Mark]) -> Vec<(usize, Role, u8)> {
    let mut found: Vec<(usize, Role, u8)> = Vec::new();
    for (index, mark) in marks.iter().enumerate() {
        if let Some((role, kind)) = role_of(&mut mark.clone())
            && !found.iter().any(|&(_, known, of)| (known, of) == (*role, kind))
        {
            found.push((index, *role, kind));
        }
    }
    found
}

/// Without labels, whose words would tell more than the roles do.
fn bare(mut marks: Vec<Mark>) -> Vec<Mark> {
    for mark in &mut marks {
        match mark {
            Mark::Point { label, .. }
            | Mark::Segment { label, .. }
            | Mark::Polygon { label, .. }
            | Mark::Curve { label, .. } => *label = None,
            Mark::Guide { label, note, .. } => (*label, *note) = (None, None),
            _ => {}
        }
    }
    marks
}

#[test]
fn roles_are_told_apart_without_colour() {
    let words = Words::default();
    for (name, theme, run) in [
        ("2", ThemeName::Light, at("line-three-cuts", "cohen-sutherland-cut", 2)),
        ("3", ThemeName::Dark, at("span-left-tie", "scanline-span", 4)),
        ("4", ThemeName::Projector, at("depth-two-triangles", "z-buffer-pass-nearer", 5)),
        ("transform", ThemeName::Dark, at("vertex-behind-the-eye", "transform-divide-behind", 1)),
    ] {
        let (marks, view, theme) = (bare(run.marks()), run.view(), theme.theme());
        let picture = grey(&marks, &view, theme, &words);
        let differ = |changed: &[Mark]| {
            let redrawn = grey(changed, &view, theme, &words);
            picture.iter().zip(&redrawn).filter(|(a, b)| a.abs_diff(**b) >= SEEN).count()
        };
        let samples = samples(&marks);
        let mut compared = 0;
        for &(index, role, kind) in &samples {
            let mut without = marks.clone();
            without.remove(index);
            if differ(&without) < ENOUGH {
                continue; // what it means another mark shows as well
            }
            for &(_, other, _) in samples.iter().filter(|(_, other, of)| *of == kind && *other != role) {
                let mut changed = marks.clone();
                let (slot, _) = role_of(&mut changed[index]).expect("it has a role");
                *slot = other;
                let points = differ(&changed);
                let mark = &marks[index];
                assert!(
                    points >= ENOUGH,
                    "picture {name}: as {other:?} only {points} points differ: {mark:?}"
                );
                compared += 1;
            }
        }
        assert!(compared >= 4, "picture {name} tells {compared} pairs of roles");
    }
}
