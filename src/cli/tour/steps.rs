//! The steps of the lab that the scene opens.

use rasterscope_core::{
    explain::Level,
    labs,
    labs::LabInput,
    message::{Message, Value},
    replay::{Budget, Playback},
};
use rasterscope_figure::{svg, tables};
use std::fmt::Write;

use super::{
    page::{self, embed, escape},
    subject::Subject,
};
use crate::{
    figure::draw,
    words::{self, WORDS, say},
};

/// Most steps that are shown one by one.
const MOST_STEPS: usize = 24;
/// Width and height of their pictures in points.
const SIZE: [f32; 2] = [720.0, 540.0];

/// The run of the scene's lab, step by step; nothing if it opens none.
pub(super) fn section(subject: &Subject<'_>) -> String {
    let Some(lab) = subject.scene.lab.as_ref().filter(|lab| lab.input != LabInput::PIPELINE) else {
        return String::new();
    };
    let name = lab.input.name();
    let heading = format!("<section id=\"steps\"><h2>{}</h2>", escape(&words::of(name)));
    let mut run = match labs::play(subject.scene, Budget::default()) {
        Ok(run) => run,
        Err(message) => return format!("{heading}<p>{}</p></section>\n", escape(&say(&message))),
    };
    let steps = chosen(&mut *run);
    let shown = Message::new("tour-steps").with("shown", steps.len() - 1).with("all", run.len());
    let mut out = format!(
        "{heading}<p>{}</p><p class=\"dim\">{}</p>",
        escape(&words::of(&format!("{name}-about"))),
        escape(&say(&shown)),
    );
    let mut before = Vec::new();
    for step in steps {
        run.seek(step);
        let after = run.tables();
        let (sentence, figure) = (say(&run.sentence()), draw(&*run, SIZE, subject.theme));
        let picture = embed("image/svg+xml", svg::svg(&figure).as_bytes(), SIZE, &sentence);
        let heading = Message::new("tour-step").with("step", Value::count(step));
        // Writing to a String cannot fail.
        let _ = write!(
            out,
            "<div class=\"step columns\"><div class=\"text\"><h3>{}</h3><p class=\"sentence\">{}</p>{}{}{}</div>\
             <figure>{picture}</figure></div>",
            escape(&say(&heading)),
            escape(&sentence),
            formulas(&*run),
            page::listing(run.listing(), run.line()),
            page::tables(&after, &before),
        );
        before = after;
    }
    out + "</section>\n"
}

fn formulas(run: &dyn Playback) -> String {
    let formula = |formula| {
        let [general, numbers] = tables::formula(formula, &WORDS).map(|runs| page::formula(&runs));
        format!("<p class=\"formula\"><span class=\"dim\">{general}</span>{numbers}</p>")
    };
    run.formulas().iter().map(formula).collect()
}

/// All steps with the start, or the coarser ones if there are too many, or some of those.
fn chosen(run: &mut dyn Playback) -> Vec<usize> {
    let mut steps = Vec::new();
    for level in [Level::Detail, Level::Row, Level::Primitive] {
        steps = ends(run, level);
        if steps.len() <= MOST_STEPS + 1 {
            return steps;
        }
    }
    let last = steps.len() - 1;
    (0..=MOST_STEPS).map(|i| steps[i * last / MOST_STEPS]).collect()
}

/// The start and the ends of all events of a level or coarser.
fn ends(run: &mut dyn Playback, level: Level) -> Vec<usize> {
    run.seek(0);
    let mut steps = vec![0];
    while run.cursor() < run.len() {
        run.next(level);
        steps.push(run.cursor());
    }
    steps
}
