//! The drawing of a Weiler-Atherton run.

use super::{
    super::outline::{Corner, Source},
    Event, ROUND, Ring, Snapshot,
    crossings::corners_between,
};
use crate::{
    clip::line::{Border, Point, Segment},
    explain::{Label, Mark, Role},
    message::Value,
};

impl Snapshot {
    /// The window, the contours, the crossings, the rings, and the step.
    pub(super) fn picture(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let points = self.window.corners().to_vec();
        out.push(Mark::Polygon { points, role: Role::Neutral, object: None, label: None });
        for border in Border::ALL {
            let at = self.window.at(border);
            let label = Some(Label::new(border.name(), at));
            let (axis, role) = (border.axis() as u8, Role::Candidate);
            out.push(Mark::Guide { axis, at, role, label, note: None });
        }
        for (index, piece) in self.pieces().iter().enumerate() {
            // One outline that runs along every ring and back to its start: even-odd leaves the holes free.
            let mut points = closed(&piece.outer);
            for hole in &piece.holes {
                points.extend(closed(hole));
                points.push(piece.outer[0].at);
            }
            out.push(Mark::Polygon { points, role: Role::Skipped, object: Some(index), label: None });
        }
        let given = self.given();
        let role = if self.done { Role::Candidate } else { Role::Neutral };
        out.extend((0..given.points.len() as u32).map(|edge| mark(given.edge(edge), role)));
        self.border(out);
        for (ring, _) in &self.rings {
            out.extend(edges(ring).map(|ends| mark(ends, Role::Accepted)));
        }
        out.extend(self.ring.windows(2).map(|pair| mark([pair[0].at, pair[1].at], Role::Accepted)));
        self.step(event, out);
        self.points(event, out);
    }

    /// The stretches of the border that are inside the contours, as soon as they are known.
    fn border(&self, out: &mut Vec<Mark>) {
        if self.done || self.round.len() < self.crossings.len() {
            return;
        }
        for (place, (from, inside)) in self.round.iter().enumerate() {
            if !inside {
                continue;
            }
            let next = (place + 1) % self.round.len();
            let [from, to] = [*from, self.round[next].0].map(|crossing| &self.crossings[crossing]);
            let between = corners_between(from.border, to.border, place < next);
            let corners = between.map(|corner| self.window.corners()[corner % 4]);
            let path: Vec<Point> = std::iter::once(from.at).chain(corners).chain([to.at]).collect();
            out.extend(path.windows(2).map(|pair| mark([pair[0], pair[1]], Role::Tie)));
        }
    }

    /// The edge that is looked at, or the ring's newest stretch.
    fn step(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        if let (Some(edge), Some(Event::Edge { .. } | Event::Cross { .. })) = (self.edge, event) {
            out.push(mark(self.given().edge(edge), Role::Active));
        }
        let last = self.ring.len().saturating_sub(1);
        match event {
            Some(Event::Follow { .. } | Event::Reach { .. } | Event::Turn { .. } | Event::Arrive { .. })
                if last > 0 =>
            {
                out.push(mark([self.ring[last - 1].at, self.ring[last].at], Role::Active));
            }
            Some(Event::Close) => out.push(mark([self.ring[last].at, self.ring[0].at], Role::Active)),
            _ => {}
        }
    }

    fn points(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        for (index, &at) in self.given().points.iter().enumerate() {
            let label = Label::name(self.name(Source::Vertex(index as u32)));
            out.push(Mark::Point { at, role: Role::Neutral, label: Some(label) });
        }
        let now = match event {
            Some(Event::Cross { .. }) => self.crossings.len().checked_sub(1),
            Some(
                Event::Next { crossing, .. }
                | Event::Start { crossing }
                | Event::Reach { crossing }
                | Event::Arrive { crossing },
            ) => Some(*crossing as usize),
            _ => None,
        };
        for (index, crossing) in self.crossings.iter().enumerate() {
            let course = if crossing.enters { "weiler-atherton-enters" } else { "weiler-atherton-leaves" };
            let role = match (now == Some(index), self.used[index]) {
                (true, _) => Role::Active,
                (_, true) => Role::Accepted,
                (_, false) => Role::Candidate,
            };
            let name = format!("X{index}");
            let label =
                if self.done { Label::new(name, crossing.at) } else { Label::new(name, Value::Word(course)) };
            out.push(Mark::Point { at: crossing.at, role, label: Some(label) });
        }
        if let (Some(_), Some(Event::Origin { .. })) = (self.winding, event) {
            let label = Some(Label::name(self.name(Source::Window([ROUND[3], ROUND[0]]))));
            out.push(Mark::Point { at: self.window.corners()[0], role: Role::Active, label });
        }
    }
}

fn mark(ends: Segment, role: Role) -> Mark {
    Mark::Segment { ends, role, label: None }
}

fn edges(ring: &[Corner]) -> impl Iterator<Item = Segment> {
    ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| [a.at, b.at])
}

/// A ring's places, the first one again at the end.
fn closed(ring: &Ring) -> Vec<Point> {
    ring.iter().chain(ring.first()).map(|corner| corner.at).collect()
}
