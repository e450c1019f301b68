//! How cost grows, a curve for each method.

use rasterscope_core::message::{Message, Value};
use rasterscope_figure::{
    plot::{Axis, Plot, Point, Scale, Series},
    words::Words,
};

use super::{CURVES, Chart, foot};
use crate::{
    Machine,
    growth::{Frame, Growing, METHODS},
};

/// The diagram of what grows.
pub fn growth(frames: &[Frame], growing: Growing, machine: &Machine, rounds: u32, words: &Words) -> Chart {
    let (mut series, mut results) = (Vec::new(), Vec::new());
    for (method, role) in METHODS.into_iter().zip(CURVES) {
        let (mut points, mut own) = (Vec::new(), Vec::new());
        for (i, frame) in frames.iter().enumerate() {
            if frame.method == method && frame.growing == growing {
                let many = if growing == Growing::Triangles { frame.triangles } else { frame.pixels };
                let at = [f64::from(many), frame.ms];
                points.push(Point { at, spread: Some(frame.quartiles), label: String::new() });
                own.push(i);
            }
        }
        let name = words.word(&format!("bench-method-{method}"));
        series.push(Series { name, role, joined: true, points });
        results.push(own);
    }
    let word = |kind: &str| words.word(&format!("bench-{kind}-{}", growing.name()));
    let factors = growing.factors().map(|factor| factor.to_string()).join(", ");
    let subtitle = Message::new("bench-growth-subtitle").with("factors", Value::text(factors));
    let plot = Plot {
        title: word("growing"),
        subtitle: words.message(&subtitle),
        axes: [Axis::new(word("axis"), Scale::Log), Axis::new(words.word("bench-axis-frame"), Scale::Log)],
        series,
        guides: Vec::new(),
        frontier: None,
        foot: foot(machine, rounds, words),
    };
    Chart { plot, results }
}
