//! The drawing: three triangles around the point, each as large as what the opposite vertex weighs.

use super::{
    Event, Snapshot,
    explain::{share_name, vertex_name},
};
use crate::{
    explain::{Label, Mark, Role},
    interpolate::Mode,
};

/// Lines of equal value stand at so many parts of the attribute's range.
const LEVELS: u32 = 8;

impl Snapshot {
    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let points = self.points();
        let p = self.subject.at;
        if self.parts[0].is_none() {
            let role = if matches!(event, Some(Event::Whole { .. })) { Role::Active } else { Role::Neutral };
            out.push(Mark::Polygon { points: points.to_vec(), role, object: None, label: None });
        }
        for i in 0..3 {
            let Some(part) = self.parts[i] else { continue };
            let corners = vec![p, points[(i + 1) % 3], points[(i + 2) % 3]];
            let outside = self.whole.is_some_and(|whole| part * whole < 0.0);
            let (role, object) = if outside { (Role::Rejected, None) } else { (Role::Neutral, Some(i)) };
            let label = (part != 0.0).then(|| match self.l[i] {
                Some(l) => Label::new(share_name(i), l as f32).of(i),
                None => Label::new(vertex_name(i), (part / 2.0).abs() as f32).of(i),
            });
            out.push(Mark::Polygon { points: corners.clone(), role, object, label });
            if Self::is_about(event, i) {
                out.push(Mark::Polygon { points: corners, role: Role::Active, object: None, label: None });
            }
        }
        if let Some(Ok(_)) = self.outcome {
            self.levels(out);
        }
        for (i, &at) in points.iter().enumerate() {
            let label = match (self.over[i], self.reciprocal[i], self.outcome) {
                (Some(over), None, None) => Label::new(format!("{} a/w", vertex_name(i)), over as f32),
                (_, Some(reciprocal), None) => {
                    Label::new(format!("{} 1/w", vertex_name(i)), reciprocal as f32)
                }
                _ => Label::new(format!("{} a", vertex_name(i)), self.subject.attribute[i]),
            };
            let role = match event {
                Some(Event::Over { vertex, .. } | Event::Reciprocal { vertex, .. })
                    if usize::from(*vertex) == i =>
                {
                    Role::Active
                }
                _ => Role::Neutral,
            };
            out.push(Mark::Point { at, role, label: Some(label.of(i)) });
        }
        let label = match (self.outcome, self.sums) {
            (Some(Ok(value)), _) => Label::new("P a", value),
            (None, [Some(_), Some(reciprocal)]) => Label::new("P 1/w", reciprocal as f32),
            (None, [Some(over), None]) => Label::new("P a/w", over as f32),
            _ => Label::name("P"),
        };
        let role = match event {
            Some(Event::SumOver { .. } | Event::SumReciprocal { .. } | Event::Value { .. }) => Role::Active,
            Some(Event::Refused { .. }) => Role::Rejected,
            _ => Role::Candidate,
        };
        out.push(Mark::Point { at: p, role, label: Some(label) });
    }

    /// Whether a step is about the area opposite to a vertex.
    fn is_about(event: Option<&Event>, i: usize) -> bool {
        match event {
            Some(Event::Part { vertex, .. } | Event::Share { vertex, .. }) => usize::from(*vertex) == i,
            _ => false,
        }
    }

    /// Lines of equal value: evenly spaced if affine, closer where it is farther away if not.
    ///
    /// Where the value is c, `sum(l (a - c) / w)` is 0, so each is a straight line.
    fn levels(&self, out: &mut Vec<Mark>) {
        let points = self.points().map(|point| point.map(f64::from));
        let a = self.subject.attribute.map(f64::from);
        let least = a[0].min(a[1]).min(a[2]);
        let range = a[0].max(a[1]).max(a[2]) - least;
        let w = match self.mode {
            Mode::Affine => [1.0; 3],
            Mode::Perspective => self.subject.w().map(f64::from),
        };
        for level in 1..LEVELS {
            let c = least + range * f64::from(level) / f64::from(LEVELS);
            let off = [0, 1, 2].map(|i| (a[i] - c) / w[i]);
            let crossings = (0..3).filter_map(|i| {
                let j = (i + 1) % 3;
                let t = off[i] / (off[i] - off[j]);
                let crosses = (off[i] < 0.0) != (off[j] < 0.0);
                crosses.then(|| {
                    [0, 1].map(|axis| (points[i][axis] + t * (points[j][axis] - points[i][axis])) as f32)
                })
            });
            if let [from, to] = crossings.collect::<Vec<_>>()[..] {
                let label = (level * 2 == LEVELS).then(|| Label::new("a", c as f32));
                out.push(Mark::Segment { ends: [from, to], role: Role::Candidate, label });
            }
        }
    }
}
