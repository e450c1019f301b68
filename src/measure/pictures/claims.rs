//! A claim of the lectures with its numbers: a curve or bars for each series.

use rasterscope_core::message::{Message, Value};
use rasterscope_figure::{
    plot::{Axis, Guide, Plot, Point, Scale, Series},
    words::Words,
};

use super::{CURVES, Chart, foot};
use crate::{
    Machine,
    claims::{At, Claim, Finding, Steps},
};

/// The diagram of what was found about a claim.
pub fn claim(claim: &Claim, finding: &Finding, machine: &Machine, rounds: u32, words: &Words) -> Chart {
    let word = |kind: &str, name: &str| words.word(&format!("bench-{kind}-{name}"));
    let names: Vec<String> = finding.series.first().map_or(Vec::new(), |series| {
        let name = |at: &At| if let At::Name(name) = at { Some(without_ending(name)) } else { None };
        series.numbers.iter().filter_map(|number| name(&number.at)).collect()
    });
    let are_bars = !names.is_empty();
    let series = finding.series.iter().take(claim.drawn).zip(CURVES).map(|(series, role)| Series {
        name: word("curve", series.name),
        role,
        joined: !are_bars,
        points: (series.numbers.iter().enumerate())
            .map(|(i, number)| {
                let x = if let At::Number(x) = number.at { x } else { i as f64 };
                Point { at: [x, number.value], spread: None, label: String::new() }
            })
            .collect(),
    });
    let results =
        finding.series.iter().take(claim.drawn).map(|series| (0..series.numbers.len()).collect()).collect();
    let across = if are_bars { Scale::Names(names) } else { scale(claim.steps[0]) };
    let verdict = Message::new("bench-claim-verdict")
        .with("verdict", Value::text(word("verdict", finding.verdict.name())))
        .with("here", Value::text(word("claim", &format!("{}-here", claim.name))));
    let plot = Plot {
        title: word("claim", claim.name),
        subtitle: words.message(&verdict),
        axes: [
            Axis::new(word("x", claim.axes[0]), across),
            Axis::new(word("y", claim.axes[1]), scale(claim.steps[1])),
        ],
        series: series.collect(),
        guides: claim.guide.map(|at| Guide { at, label: word("guide", claim.name) }).into_iter().collect(),
        frontier: None,
        foot: foot(machine, rounds, words),
    };
    Chart { plot, results }
}

fn scale(steps: Steps) -> Scale {
    match steps {
        Steps::Sums => Scale::Linear,
        Steps::Factors => Scale::Log,
    }
}

/// A model's name without its ending.
fn without_ending(name: &str) -> String {
    name.strip_suffix(".obj").unwrap_or(name).to_owned()
}
