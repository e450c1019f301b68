//! Draws hand-made marks in every theme and the labs of all presets, to be looked at:
//! `cargo run -p rasterscope-figure --example gallery -- FOLDER`.

use std::{
    fs,
    path::{Path, PathBuf},
};

use rasterscope_core::{
    explain::{Grid, Label, Mark, Role, View},
    labs,
    message::Value,
    replay::Budget,
    scene::{self, PRESETS, Scene},
};
use rasterscope_figure::{
    layout::{self, Placement},
    png, svg,
    theme::ThemeName,
    words::Words,
};

const SIZE: [f32; 2] = [692.0, 576.0];

fn main() -> std::io::Result<()> {
    let folder: PathBuf = std::env::args_os().nth(1).unwrap_or_else(|| "gallery".into()).into();
    fs::create_dir_all(&folder)?;
    let words = Words::default();
    for (name, (view, marks)) in
        [("clip", clipping()), ("scan", scan_conversion()), ("depth", depth()), ("roles", roles())]
    {
        for theme in ThemeName::ALL {
            let placement = Placement::fit(&view, SIZE, 12.0);
            let figure = layout::draw(&marks, &view, &placement, SIZE, theme.theme(), &words);
            let path = folder.join(format!("{name}-{}", theme.name()));
            fs::write(path.with_extension("png"), png::png(&figure, 1.0))?;
            fs::write(path.with_extension("svg"), svg::svg(&figure))?;
        }
    }
    presets(&folder, &words)
}

/// The middle and the end of the run of every preset that names a lab.
fn presets(folder: &Path, words: &Words) -> std::io::Result<()> {
    let mut load = |file: &str| scene::model(file).map(<[u8]>::to_vec).ok_or_else(|| file.to_owned());
    for preset in PRESETS {
        let scene = Scene::from_json(preset.json.as_bytes()).and_then(|scene| scene.resolve(&mut load));
        let run = scene.map(|scene| labs::play(&scene, Budget::default()));
        let Ok(Ok(mut run)) = run else { continue };
        for (part, theme) in [(2, ThemeName::Dark), (1, ThemeName::Light), (3, ThemeName::Projector)] {
            run.seek(run.len() / part);
            let view = run.view();
            let placement = Placement::fit(&view, SIZE, 12.0);
            let figure = layout::draw(&run.marks(), &view, &placement, SIZE, theme.theme(), words);
            let name = format!("{}-{}-{}.png", run.name(), preset.name, theme.name());
            fs::write(folder.join(name), png::png(&figure, 1.0))?;
        }
    }
    Ok(())
}

fn segment(ends: [[f32; 2]; 2], role: Role) -> Mark {
    Mark::Segment { ends, role, label: None }
}

fn point(at: [f32; 2], role: Role, name: &str) -> Mark {
    Mark::Point { at, role, label: Some(Label::new(name, at)) }
}

/// A line cut at the lower border of a window.
fn clipping() -> (View, Vec<Mark>) {
    let mut marks = vec![Mark::Polygon {
        points: vec![[3.5, 2.0], [9.0, 2.0], [9.0, 6.5], [3.5, 6.5]],
        role: Role::Neutral,
        object: None,
        label: None,
    }];
    for (axis, at, name, role) in [
        (1, 6.5, "ymax", Role::Candidate),
        (1, 2.0, "ymin", Role::Active),
        (0, 9.0, "xmax", Role::Candidate),
        (0, 3.5, "xmin", Role::Candidate),
    ] {
        marks.push(Mark::Guide { axis, at, role, label: Some(Label::new(name, at)), note: None });
    }
    for (y, vertical) in [(9.9, 0b1000), (6.5, 0), (2.0, 0b0100)] {
        for (x, horizontal) in [(-0.8, 0b0001), (3.5, 0), (9.0, 0b0010)] {
            let bits = vertical | horizontal;
            let role = if bits < 2 { Role::Neutral } else { Role::Candidate };
            let label = Label::new("", Value::Bits { bits, width: 4 });
            marks.push(Mark::Text { at: [x, y], label, role, big: true });
        }
    }
    let [p1, p2, cut1, cut2] = [[0.5, 0.5], [10.5, 8.5], [2.375, 2.0], [8.0, 6.5]];
    marks.push(segment([p1, cut1], Role::Rejected));
    marks.push(segment([cut2, p2], Role::Rejected));
    marks.push(segment([cut1, cut2], Role::Active));
    marks.push(point(p1, Role::Neutral, "P1"));
    marks.push(point(p2, Role::Neutral, "P2"));
    marks.push(point(cut1, Role::Active, "P1′"));
    marks.push(point(cut2, Role::Neutral, "P2′"));
    (View { min: [-0.8, -1.2], max: [12.5, 9.9], y_up: true, grid: Grid::Units }, marks)
}

/// The fourth row of a triangle, with a tie on its left edge.
fn scan_conversion() -> (View, Vec<Mark>) {
    let [v0, v1, v2] = [[4.4375, 0.75], [10.6875, 5.75], [2.5625, 8.25]];
    let mut marks =
        vec![Mark::Polygon { points: vec![v0, v1, v2], role: Role::Neutral, object: None, label: None }];
    let pixel = |at: [i32; 2], role, object| Mark::Pixel { at, role, object, value: Value::None };
    for (y, first, end) in [(1, 4, 5), (2, 4, 7), (3, 4, 8)] {
        marks.extend((first..end).map(|x| pixel([x, y], Role::Accepted, Some(0))));
    }
    marks.push(pixel([3, 4], Role::Tie, Some(0)));
    for (y, first, end) in [(4, 4, 9), (5, 3, 10), (6, 3, 8), (7, 3, 5)] {
        marks.extend((first..end).map(|x| pixel([x, y], Role::Candidate, None)));
    }
    marks.push(Mark::Guide { axis: 1, at: 4.5, role: Role::Active, label: None, note: None });
    marks.push(Mark::Span { y: 4, ends: [3.5, 9.125], role: Role::Active });
    for (ends, slope) in [([v0, v1], 1.25), ([v0, v2], -0.25), ([v1, v2], -3.25)] {
        let label = Some(Label::new("dx/dy", slope));
        marks.push(Mark::Segment { ends, role: Role::Neutral, label });
    }
    for (at, name) in [(v0, "V0"), (v1, "V1"), (v2, "V2")] {
        marks.push(point(at, Role::Neutral, name));
    }
    for (x, name) in [(3.5, "x left"), (9.125, "x right")] {
        let label = Some(Label::new(name, x));
        marks.push(Mark::Point { at: [x, 4.5], role: Role::Active, label });
    }
    (View { min: [1.0, 0.0], max: [12.0, 9.0], y_up: false, grid: Grid::Pixels }, marks)
}

/// Depth values under two triangles, one arriving.
fn depth() -> (View, Vec<Mark>) {
    let mut marks = Vec::new();
    let a = [[0.3, 0.7], [7.8, 1.6], [2.2, 6.8]];
    let b = [[7.7, 0.4], [7.2, 6.3], [0.6, 5.2]];
    for y in 0..7 {
        for x in 0..8 {
            let value = 0.25 + 0.0637 * x as f32 + 0.0069 * y as f32;
            let (role, object, value) = match (x, y) {
                (4, 4) => (Role::Active, Some(1), value),
                (6.., 1..3) | (4..7, 3) => (Role::Accepted, Some(1), value),
                (3, 3) | (3, 4) => (Role::Rejected, Some(0), value),
                (1..6, 1..3) | (1..3, 3..5) => (Role::Neutral, Some(0), value),
                _ => (Role::Neutral, None, 1.0),
            };
            marks.push(Mark::Pixel { at: [x, y], role, object, value: value.into() });
        }
    }
    for (points, role, name) in [(a, Role::Taught, "A"), (b, Role::Neutral, "B")] {
        let points = points.to_vec();
        marks.push(Mark::Polygon { points, role, object: None, label: Some(Label::name(name)) });
    }
    (View { min: [0.0, 0.0], max: [8.0, 7.0], y_up: false, grid: Grid::Pixels }, marks)
}

/// Every role as a point, a line and an area.
fn roles() -> (View, Vec<Mark>) {
    let mut marks = Vec::new();
    for (i, role) in Role::ALL.into_iter().enumerate() {
        let y = i as f32;
        let name = format!("{role:?}");
        marks.push(Mark::Point { at: [0.5, y], role, label: Some(Label::name(name)) });
        marks.push(segment([[3.0, y], [6.0, y]], role));
        let points = vec![[7.0, y - 0.35], [10.0, y - 0.35], [10.0, y + 0.35], [8.0, y + 0.1]];
        marks.push(Mark::Polygon { points, role, object: None, label: None });
        let points = vec![[10.5, y - 0.35], [12.0, y - 0.35], [11.3, y + 0.35]];
        marks.push(Mark::Polygon { points, role: Role::Neutral, object: Some(i), label: None });
    }
    (View { min: [0.0, -1.0], max: [12.0, 10.0], y_up: true, grid: Grid::None }, marks)
}
