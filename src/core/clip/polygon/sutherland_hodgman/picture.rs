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
            let cut = standing != *given;
            if cut {
                out.extend(segments(given).map(|ends| mark(ends, Role::Rejected)));
            }
            let role = if done.is_some() { Role::Accepted } else { Role::Neutral };
            out.push(Mark::Polygon { points: standing, role, object: Some(index), label: None });
        }
        for result in &self.results {
            out.extend(bridges(result, &self.window).into_iter().map(|ends| Mark::Segment {
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
        for corner in self.polygon.iter().filter(made) {
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

fn segments(points: &[Point]) -> impl Iterator<Item = Segment> {
    points.iter().zip(points.iter().cycle().skip(1)).map(|(&a, &b)| [a, b])
}
