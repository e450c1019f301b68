//! The drawing of a Sutherland-Hodgman run.

use super::{
    super::outline::{Corner, Place, Source},
    Event, Snapshot,
    bridges::bridges,
};
use crate::{
    clip::line::{Border, Point, Segment},
    explain::{Label, Mark, Role},
    message::{Message, Value},
};

impl Snapshot {
    /// The window, what is gone, what is left, and the step.
    pub(super) fn picture(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.borders(event, out);
        for (index, given) in self.given.iter().enumerate() {
            let done = self.results.get(index);
            let at_hand = self.current == Some(index) && done.is_none();
            let standing: Vec<Point> = match done {
                Some(result) => places(result),
                None if at_hand => places(&self.polygon),
                None => given.clone(),
            };
            let role = if done.is_some() { Role::Skipped } else { Role::Neutral };
            out.push(Mark::Polygon { points: standing, role, object: Some(index), label: None });
            if let Some(corners) = done.or(at_hand.then_some(&self.polygon)) {
                out.extend(removed(given, corners).map(|ends| mark(ends, Role::Rejected)));
            }
        }
        for result in &self.results {
            let bridges = bridges(result, &self.window);
            let edges = result.iter().zip(result.iter().cycle().skip(1)).map(|(a, b)| [a.at, b.at]);
            let kept = edges.flat_map(|ends| without(ends, &bridges));
            out.extend(kept.map(|ends| mark(ends, Role::Accepted)));
            out.extend(bridges.into_iter().map(|ends| Mark::Segment {
                ends,
                role: Role::Tie,
                label: Some(Label::new("", Value::Word("sutherland-hodgman-bridge"))),
            }));
        }
        self.step(out);
        self.points_and_names(event, out);
        for crack in self.cracks() {
            let free = 1 - crack.border.axis();
            let label = Label::new(["Δx", "Δy"][free], crack.ends[1][free] - crack.ends[0][free]);
            out.push(Mark::Point { at: crack.ends[0], role: Role::Rejected, label: Some(label) });
        }
    }

    fn borders(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let points = self.window.corners().to_vec();
        out.push(Mark::Polygon { points, role: Role::Neutral, object: None, label: None });
        for border in Border::ALL {
            let active = self.side() == Some(border);
            let at = self.window.at(border);
            let note = (active && event.is_some()).then(|| {
                Message::new("sutherland-hodgman-cutting")
                    .with("axis", Value::text(["x", "y"][border.axis()]))
                    .with("at", Value::text(border.name()))
            });
            let role = if active { Role::Active } else { Role::Candidate };
            let label = Some(Label::new(border.name(), at));
            out.push(Mark::Guide { axis: border.axis() as u8, at, role, label, note });
        }
    }

    /// What the side has emitted, and the edge it looks at.
    fn step(&self, out: &mut Vec<Mark>) {
        out.extend(self.out.windows(2).map(|pair| mark([pair[0].at, pair[1].at], Role::Accepted)));
        if let (Some(_), Some([s, e])) = (self.side(), self.edge()) {
            out.push(mark([s.at, e.at], Role::Active));
        }
    }

    fn points_and_names(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let named = |corner: &Corner, polygon: usize| {
            let name = self.name(corner.source, polygon);
            Some(match corner.source {
                Source::Vertex(_) => Label::name(name),
                _ => Label::new(name, corner.at),
            })
        };
        // Given corners are always there to be dragged.
        for (polygon, given) in self.given.iter().enumerate() {
            for (i, &at) in given.iter().enumerate() {
                let label = Label::name(self.name(Source::Vertex(i as u32), polygon));
                out.push(Mark::Point { at, role: Role::Neutral, label: Some(label) });
            }
        }
        let made = |corner: &&Corner| !matches!(corner.source, Source::Vertex(_));
        for (polygon, result) in self.results.iter().enumerate() {
            for corner in result.iter().filter(made) {
                let label = named(corner, polygon);
                out.push(Mark::Point { at: corner.at, role: Role::Accepted, label });
            }
        }
        let here = self.current.unwrap_or_default();
        let pending = |corner: &&Corner| !self.out.iter().any(|emitted| emitted.source == corner.source);
        for corner in self.polygon.iter().filter(made).filter(pending) {
            out.push(Mark::Point { at: corner.at, role: Role::Neutral, label: named(corner, here) });
        }
        for corner in &self.out {
            let label = made(&corner).then(|| named(corner, here)).flatten();
            out.push(Mark::Point { at: corner.at, role: Role::Accepted, label });
        }
        match event {
            Some(Event::Cut { at, source }) => {
                let label = Some(Label::new(self.name_here(*source), *at));
                out.push(Mark::Point { at: *at, role: Role::Active, label });
            }
            Some(Event::Keep | Event::First { place: Place::In | Place::On }) => {
                let at = self.out.last().map(|corner| corner.at);
                out.extend(at.map(|at| Mark::Point { at, role: Role::Active, label: None }));
            }
            _ => {}
        }
    }
}

fn mark(ends: Segment, role: Role) -> Mark {
    Mark::Segment { ends, role, label: None }
}

fn places(corners: &[Corner]) -> Vec<Point> {
    corners.iter().map(|corner| corner.at).collect()
}

/// What an outline has lost of each given edge: up to its first corner on that edge, and from its last.
fn removed<'a>(given: &'a [Point], corners: &'a [Corner]) -> impl Iterator<Item = Segment> + use<'a> {
    (0..given.len()).flat_map(move |i| {
        let next = (i + 1) % given.len();
        let [p, q] = [given[i], given[next]];
        let here = |index: usize| corners.iter().any(|c| c.source == Source::Vertex(index as u32));
        let mut cuts: Vec<Point> = corners
            .iter()
            .filter(|c| matches!(c.source, Source::Crossing { edge, .. } if edge as usize == i))
            .map(|c| c.at)
            .collect();
        let along = |cut: &Point| {
            let run = |axis: usize| (f64::from(cut[axis]) - f64::from(p[axis])).abs();
            run(0) + run(1)
        };
        cuts.sort_by(|a, b| along(a).total_cmp(&along(b)));
        let before = (!here(i)).then(|| [p, cuts.first().copied().unwrap_or(q)]);
        let after = (!here(next)).then(|| cuts.last().map(|&cut| [cut, q])).flatten();
        before.into_iter().chain(after)
    })
}

/// What is left of an edge without the bridges on it, which are in order along their border.
fn without([a, b]: Segment, bridges: &[Segment]) -> Vec<Segment> {
    let Some(level) = (0..2).find(|&axis| a[axis] == b[axis]) else { return vec![[a, b]] };
    let free = 1 - level;
    let (mut from, to) = if a[free] < b[free] { (a, b) } else { (b, a) };
    let mut kept = Vec::new();
    for [start, end] in bridges {
        let on_it = start[level] == a[level] && end[level] == a[level];
        if on_it && from[free] <= start[free] && end[free] <= to[free] {
            kept.push([from, *start]);
            from = *end;
        }
    }
    kept.push([from, to]);
    kept.retain(|[a, b]| a != b);
    kept
}
