//! Why a triangle draws a pixel or not: what each edge says of its centre.

use super::{
    Edge, Edges, FillRule, Settings, YAxis,
    traversal::probe::{Says, exactly, says},
};
use crate::{
    explain::{PixelReport, Role, Row, Table},
    math::Tally,
    message::{Message, Value},
};

/// Names of the vertices.
const VERTICES: [&str; 3] = ["V0", "V1", "V2"];

/// What decides about one pixel.
#[derive(Clone, Debug)]
pub(crate) struct Subject<'a> {
    /// As given.
    pub(crate) given: [[f32; 2]; 3],
    /// As rasterized.
    pub(crate) vertices: [[f32; 2]; 3],
    /// `None` if the area is zero.
    pub(crate) edges: Option<&'a Edges>,
    pub(crate) settings: &'a Settings,
    /// What the algorithm does with it besides asking the edges.
    pub(crate) fate: Fate,
}

/// What an algorithm does with a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Fate {
    /// It does what the edges say.
    Asked,
    /// It lies outside the bounding box: nobody looks at it.
    OutsideBox,
    /// It is drawn or not by other means.
    Known(bool),
}

impl Subject<'_> {
    /// The verdict on a pixel, the values of the edges, and whether a tie rule decided.
    ///
    /// `None` for a pixel outside the image.
    pub(crate) fn report(&self, pixel: [u32; 2]) -> Option<PixelReport> {
        if pixel.iter().zip(self.settings.size).any(|(place, size)| *place >= size) {
            return None;
        }
        let Some(edges) = self.edges else {
            let sentence = about("pixel-zero-area", pixel);
            return Some(PixelReport { sentence, warning: None, tables: Vec::new() });
        };
        let says = says(edges, self.settings, pixel);
        let in_truth = Edges::new(self.given, self.settings, &mut Tally::default())
            .is_some_and(|edges| exactly(&edges, pixel).iter().all(|edge| edge.draws));
        let drawn = match self.fate {
            Fate::Asked => says.iter().all(|edge| edge.draws),
            Fate::OutsideBox => false,
            Fate::Known(drawn) => drawn,
        };
        let warning = (drawn != in_truth)
            .then(|| Message::new(if in_truth { "pixel-wrongly-lost" } else { "pixel-wrongly-drawn" }));
        let rows = edges.0.iter().zip(says).map(|(edge, says)| {
            let role = if says.tie {
                Role::Tie
            } else if says.draws {
                Role::Accepted
            } else {
                Role::Rejected
            };
            let cells = vec![Value::Word(kind(edge, self.settings.y_axis)), says.value.into(), verdict(says)];
            Row::new(self.name(edge), cells).role(role)
        });
        let table = Table {
            title: "traversal-edges",
            columns: vec!["column-edge-kind", "column-traversal-value", "column-traversal-verdict"],
            rows: rows.collect(),
        };
        let sentence = self.sentence(edges, says, pixel);
        Some(PixelReport { sentence, warning, tables: vec![table] })
    }

    fn sentence(&self, edges: &Edges, says: [Says; 3], pixel: [u32; 2]) -> Message {
        if self.fate == Fate::OutsideBox {
            return about("pixel-outside-box", pixel);
        }
        let outside = |says: &Says| !says.draws && !says.tie;
        let out = says.iter().position(outside);
        let Some(edge) = out.or_else(|| says.iter().position(|says| says.tie && !says.draws)) else {
            let Some(tie) = says.iter().position(|says| says.tie) else {
                return about("pixel-in", pixel);
            };
            return self.of_edge("pixel-tie-drawn", pixel, &edges.0[tie]);
        };
        let id = if out.is_some() { "pixel-out" } else { "pixel-tie-lost" };
        self.of_edge(id, pixel, &edges.0[edge]).with("value", says[edge].value)
    }

    fn of_edge(&self, id: &'static str, pixel: [u32; 2], edge: &Edge) -> Message {
        about(id, pixel)
            .with("edge", Value::text(self.name(edge)))
            .with("kind", Value::Word(kind(edge, self.settings.y_axis)))
            .with("rule", Value::Word(self.settings.fill_rule.word()))
    }

    /// An edge by its ends, such as `V0V1`.
    fn name(&self, edge: &Edge) -> String {
        ends_of(edge, self.vertices)
    }
}

/// An edge by its ends, such as `V0V1`.
pub(crate) fn ends_of(edge: &Edge, vertices: [[f32; 2]; 3]) -> String {
    let name =
        |end: [f32; 2]| VERTICES[vertices.iter().position(|vertex| *vertex == end).unwrap_or_default()];
    edge.ends.map(name).concat()
}

fn about(id: &'static str, pixel @ [x, y]: [u32; 2]) -> Message {
    let centre = super::edge::centre(pixel[0], pixel[1]);
    Message::new(id).with("x", x).with("y", y).with("centre", centre)
}

/// Whether an edge is a left, right, top or bottom one.
fn kind(edge: &Edge, y_axis: YAxis) -> &'static str {
    let [[_, ay], [_, by]] = edge.ends;
    if ay == by {
        // Under the top-left rule a horizontal edge draws its ties if it is a top one.
        let top = Edge::new(edge.ends[0], edge.ends[1], FillRule::TopLeft, y_axis).draws_ties;
        return if top { "word-edge-top" } else { "word-edge-bottom" };
    }
    if edge.is_left() { "word-edge-left" } else { "word-edge-right" }
}

/// What an edge says, in a word.
pub(crate) fn verdict(says: Says) -> Value {
    Value::Word(match (says.tie, says.draws) {
        (true, true) => "traversal-tie-drawn",
        (true, false) => "traversal-tie-lost",
        (false, true) => "traversal-lets-in",
        (false, false) => "traversal-keeps-out",
    })
}
