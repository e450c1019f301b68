//! One section of the page for each stage.

use rasterscope_core::{labs::Stage, message::Message, pipeline::Unit};

use super::{
    numbers, outside,
    page::{self, escape},
    picture::Drawing,
    pixels,
    subject::Subject,
};
use crate::words::{self, WORDS, say};

/// The stage's name in links.
pub(super) fn anchor(stage: Stage) -> &'static str {
    stage.word().trim_start_matches("stage-")
}

/// What happens, what came and went, the picture and the numbers.
pub(super) fn section(subject: &Subject<'_>, stage: Stage, number: usize) -> String {
    let anchor = anchor(stage);
    let (tables, more) = numbers::tables(subject, stage);
    let more: String =
        more.iter().map(|message| format!("<p class=\"more\">{}</p>", escape(&say(message)))).collect();
    format!(
        "<section id=\"{anchor}\"><h2><span class=\"no\">{number}</span>{}</h2><div class=\"columns\">\
         <div class=\"text\"><p>{}</p>{}{}{more}</div>{}</div></section>\n",
        escape(&WORDS.word(stage.word())),
        escape(&words::of(&format!("tour-about-{anchor}"))),
        counts(subject, stage),
        page::tables(&tables, &[]),
        drawing(subject, stage).html(subject.theme),
    )
}

fn drawing(subject: &Subject<'_>, stage: Stage) -> Drawing {
    match stage {
        Stage::Scene => outside::scene(subject),
        Stage::Model => outside::model(subject),
        Stage::View => outside::view(subject),
        Stage::ClipSpace => outside::clip_space(subject),
        Stage::Cull => outside::cull(subject),
        Stage::Clip => outside::clip(subject),
        Stage::Divide => outside::divide(subject),
        Stage::Viewport => pixels::viewport(subject),
        Stage::ScanConversion => pixels::scan_conversion(subject),
        Stage::Fragments => pixels::fragments(subject),
        Stage::Stencil => pixels::stencil(subject),
        Stage::Depth => pixels::depth(subject),
        Stage::Blend => pixels::blend(subject),
        Stage::Image => pixels::final_image(subject),
    }
}

/// A painted tick and a painted cross: markers are shapes, never glyphs.
const TICK: &str = "<svg viewBox=\"0 0 14 14\" aria-hidden=\"true\"><circle cx=\"7\" cy=\"7\" r=\"6.5\" fill=\"var(--accepted)\"/>\
    <path d=\"M3.8 7.2 6.2 9.6 10.4 4.8\" fill=\"none\" stroke=\"var(--canvas)\" stroke-width=\"1.6\"/></svg>";
const CROSS: &str = "<svg viewBox=\"0 0 14 14\" aria-hidden=\"true\">\
    <path d=\"M2.5 2.5 11.5 11.5M11.5 2.5 2.5 11.5\" fill=\"none\" stroke=\"var(--rejected)\" stroke-width=\"2.2\"/></svg>";

/// What came in and went out, and what was dropped and why.
fn counts(subject: &Subject<'_>, stage: Stage) -> String {
    let count = subject.outputs.frame.stats.stage(stage);
    if !count.on {
        return format!(
            "<p class=\"dim\">{}</p>",
            escape(&words::of(&format!("tour-off-{}", anchor(stage))))
        );
    }
    let came = (stage != Stage::Scene).then(|| counted("tour-came", Unit::into(stage), count.came));
    let went = counted("tour-went", Unit::of(stage), count.went);
    let items = came.into_iter().chain([went]).map(|text| format!("<li>{TICK}{}</li>", escape(&text)));
    let dropped = count.reasons().map(|(reason, n)| {
        let message = Message::new("tour-dropped").with("count", n as usize);
        let message = message.with("reason", rasterscope_core::message::Value::Word(reason.word()));
        format!("<li class=\"dropped\">{CROSS}{}</li>", escape(&say(&message)))
    });
    format!("<ul class=\"counts\">{}</ul>", items.chain(dropped).collect::<String>())
}

/// `12 triangles come in.`
fn counted(id: &'static str, unit: Unit, n: u64) -> String {
    let name = match unit {
        Unit::Triangles => "tour-triangles",
        Unit::Vertices => "tour-vertices",
        Unit::Spans => "tour-spans",
        Unit::Fragments => "tour-fragments",
        Unit::Pixels => "tour-pixels",
    };
    let counted = say(&Message::new(name).with("count", n as usize));
    say(&Message::new(id).with("counted", rasterscope_core::message::Value::Text(counted)))
}
