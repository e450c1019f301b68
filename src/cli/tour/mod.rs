//! `rasterscope tour`: a web page that walks a scene through every stage.
//!
//! The page is one file without scripts, its pictures inside, so that it can be mailed, printed and
//! opened anywhere. It shows the same numbers as the window: both ask the same pipeline.

mod numbers;
mod outside;
mod page;
mod paint;
mod picture;
mod pixels;
mod stages;
mod steps;
mod subject;

pub(crate) use paint::opaque;
pub(crate) use pixels::view as image_view;

use rasterscope_core::{
    labs::Stage,
    message::{Message, Value},
    pipeline::{Pipeline, PixelCounts, Skips, Unit},
    scene::Scene,
};
use rasterscope_figure::{numbers as written, theme::ThemeName};
use std::{
    io::Write,
    path::{Path, PathBuf},
};

use crate::{
    Failure, files,
    progress::Progress,
    words::{self, WORDS, say},
};
use page::escape;
use subject::Subject;

/// What to tour, and where the page goes.
#[derive(Clone, Debug)]
pub struct TourOptions {
    /// A scene, a model or a preset; the default preset if there is none.
    pub file: Option<PathBuf>,
    /// The folder of the page; made if it is not there.
    pub output: PathBuf,
}

/// Writes the page whole or not at all; returns its path. `progress` gets a line that is written
/// over and over, and is for terminals only.
pub fn tour(options: &TourOptions, progress: Option<&mut dyn Write>) -> Result<PathBuf, Failure> {
    let scene = files::open_scene(options.file.as_deref())?;
    let page = page_of(&scene, title(&scene, options.file.as_deref()), progress);
    let path = options.output.join("index.html");
    files::make_folder(&options.output)?;
    files::write(&path, page.as_bytes())?;
    Ok(path)
}

/// The name of a scene: its own, in words if it is a message's id, or the file's.
fn title(scene: &Scene, file: Option<&Path>) -> String {
    let words = in_words(&scene.name);
    match file.and_then(Path::file_name) {
        Some(file) if words.is_empty() => file.to_string_lossy().into_owned(),
        _ => words,
    }
}

/// Text of a scene: it may be the id of a message.
fn in_words(text: &str) -> String {
    let found = words::of(text);
    if found.is_empty() { text.to_owned() } else { found }
}

/// The whole page.
fn page_of(scene: &Scene, title: String, progress: Option<&mut dyn Write>) -> String {
    let mut progress = Progress(progress);
    let mut pipeline = Pipeline::default();
    let outputs = pipeline.update(scene, &Skips::ALL);
    let counts = PixelCounts::of(scene, outputs);
    let subject = Subject { scene, outputs, counts: &counts, theme: ThemeName::Light.theme() };
    let mut body = header(&subject, &title);
    body += &ribbon(&subject);
    // Where nothing is drawn, the run of the lab is what the scene is about.
    let steps = steps::section(&subject);
    if scene.draws.is_empty() {
        body += &steps;
    }
    for (number, stage) in (1..).zip(Stage::ALL) {
        let message = Message::new("tour-progress").with("number", number).with("all", Stage::ALL.len());
        progress.say(&message.with("stage", Value::Word(stage.word())));
        body += &stages::section(&subject, stage, number);
    }
    if !scene.draws.is_empty() {
        body += &steps;
    }
    body += &format!("<footer><p>{}</p></footer>\n", escape(&WORDS.word("tour-footer")));
    progress.clear();
    page::page(&title, subject.theme, &body)
}

fn header(subject: &Subject<'_>, title: &str) -> String {
    let scene = subject.scene;
    let facts = Message::new("tour-facts")
        .with("width", scene.size[0])
        .with("height", scene.size[1])
        .with("draws", scene.draws.len())
        .with(
            "triangles",
            subject.outputs.draws.iter().map(|draw| draw.mesh().triangles.len()).sum::<usize>(),
        );
    let note = in_words(&scene.note);
    format!(
        "<header><p class=\"dim\">{}</p><h1>{}</h1><p>{}</p><p class=\"dim\">{}</p></header>\n",
        escape(&WORDS.word("tour-title")),
        escape(title),
        escape(&note),
        escape(&say(&facts)),
    )
}

/// The stages as links, each with what comes out of it and what was dropped.
fn ribbon(subject: &Subject<'_>) -> String {
    let stats = &subject.outputs.frame.stats;
    let chip = |stage: Stage| {
        let count = stats.stage(stage);
        let out = if count.on || stage == Stage::Image || stage == Stage::Scene {
            let n = written::integer(i64::try_from(count.went).unwrap_or(i64::MAX));
            let unit = say(&Message::new(Unit::of(stage).word()).with("count", count.went as usize));
            format!("<span class=\"count\">{n}</span> <span class=\"unit\">{}</span>", escape(&unit))
        } else {
            format!("<span class=\"off\">{}</span>", escape(&WORDS.word("tour-off")))
        };
        let skips: String = count
            .reasons()
            .map(|(reason, n)| {
                let n = written::integer(i64::try_from(n).unwrap_or(i64::MAX));
                format!("<span class=\"skip\">{n} {}</span>", escape(&WORDS.word(reason.word())))
            })
            .collect();
        let name = escape(&WORDS.word(stage.word()));
        format!("<li><a href=\"#{}\">{name}<br>{out}{skips}</a></li>", stages::anchor(stage))
    };
    format!("<nav><ol>{}</ol></nav>\n", Stage::ALL.map(chip).concat())
}
