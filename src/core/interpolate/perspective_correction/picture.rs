//! The checker as it is drawn, and below it depth, 1/w and distance along the line.

use super::{Event, STEPS, Snapshot, ends};
use crate::{
    explain::{Label, Mark, Role},
    message::Value,
    raster::YAxis,
};

/// The height of the plot, as a part of the image's.
pub(super) const PLOT: f32 = 0.62;
/// Pieces of a curve.
const PIECES: u32 = 48;

/// A value along the line, as the plot shows it.
struct Curve<'a> {
    name: &'static str,
    role: Role,
    /// What it is at a share of the line.
    at: &'a dyn Fn(f64) -> f64,
    /// At which share its name stands, and whether above it.
    named: (f64, bool),
}

impl Snapshot {
    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let [width, height] = self.settings.size.map(|n| n as f32);
        let frame = vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]];
        out.push(Mark::Polygon { points: frame, role: Role::Skipped, object: None, label: None });
        for (texel, other) in self.texels.iter().zip(&*self.others) {
            // What differs is marked when all pixels are there.
            let differs = self.in_line && texel.light != other.light;
            let role = if differs { Role::Changed } else { Role::Neutral };
            out.push(Mark::Pixel {
                at: texel.pixel.map(|n| n as i32),
                role,
                object: Some(if texel.light { 1 } else { 2 }),
                value: Value::None,
            });
        }
        if let Some((pixel, _)) = self.pixel {
            let at = pixel.map(|n| n as i32);
            out.push(Mark::Pixel { at, role: Role::Active, object: None, value: Value::None });
        }
        let corners = self.subject.corners.map(|[x, y, ..]| [x, y]);
        out.push(Mark::Polygon { points: corners.to_vec(), role: Role::Neutral, object: None, label: None });
        if let Some(index) = self.triangle {
            let points = super::TRIANGLES[usize::from(index)].map(|i| corners[i]).to_vec();
            out.push(Mark::Polygon { points, role: Role::Candidate, object: None, label: None });
        }
        let [from, to] = self.subject.line;
        let line_role = if matches!(event, Some(Event::Line)) { Role::Active } else { Role::Neutral };
        out.push(Mark::Segment { ends: [from, to], role: line_role, label: None });
        for (at, name) in [(from, "L0"), (to, "L1")] {
            out.push(Mark::Point { at, role: Role::Neutral, label: Some(Label::name(name)) });
        }
        if let Some(ends) = ends(&self.subject) {
            self.plot(ends, event, out);
        }
    }

    /// Where a share of the line and a height in 0..1 are in the plot.
    fn place(&self, share: f64, height: f64) -> [f32; 2] {
        let [width, rows] = self.settings.size.map(f64::from);
        let (low, high) = (rows * (1.0 + f64::from(PLOT) * 0.93), rows * (1.0 + f64::from(PLOT) * 0.12));
        let y = low + height * (high - low);
        let y = if self.settings.y_axis == YAxis::Up { rows - y } else { y };
        [(width * (0.06 + 0.84 * share)) as f32, y as f32]
    }

    /// Each curve fills the height of the plot: what counts is whether it is straight.
    fn plot(&self, [from, to]: [[f64; 2]; 2], event: Option<&Event>, out: &mut Vec<Mark>) {
        let mix = |a: f64, b: f64, t: f64| a + t * (b - a);
        let z = |t: f64| mix(from[0], to[0], t);
        let r = |t: f64| mix(from[1], to[1], t);
        let d = |t: f64| 1.0 / r(t);
        // As if depth were an attribute like others.
        let corrected = |t: f64| mix(from[0] * from[1], to[0] * to[1], t) / r(t);
        let [origin, right, up] = [self.place(0.0, 0.0), self.place(1.0, 0.0), self.place(0.0, 1.0)];
        for end in [right, up] {
            out.push(Mark::Segment { ends: [origin, end], role: Role::Candidate, label: None });
        }
        let curves = [
            Curve { name: "z", role: Role::Accepted, at: &z, named: (0.68, true) },
            Curve { name: "1/w", role: Role::Exact, at: &r, named: (0.2, true) },
            Curve { name: "d", role: Role::Neutral, at: &d, named: (0.78, false) },
            Curve { name: "(z/w) / (1/w)", role: Role::Rejected, at: &corrected, named: (0.44, false) },
        ];
        for curve in curves {
            self.curve(&curve, out);
        }
        let known = self.along.len().checked_sub(1);
        if let (Some(step), Some(Event::Along { .. })) = (known, event) {
            let share = step as f64 / f64::from(STEPS);
            let [a, b] = self.subject.line.map(|p| p.map(f64::from));
            let at = [0, 1].map(|axis| mix(a[axis], b[axis], share) as f32);
            out.push(Mark::Point { at, role: Role::Active, label: None });
            let ends = [self.place(share, 0.0), self.place(share, 1.0)];
            out.push(Mark::Segment { ends, role: Role::Active, label: None });
        }
    }

    fn curve(&self, &Curve { name, role, at, named: (share, above) }: &Curve<'_>, out: &mut Vec<Mark>) {
        let ends = [at(0.0), at(1.0)];
        let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let height = |share: f64| if high > low { (at(share) - low) / (high - low) } else { 0.5 };
        let shares = (0..=PIECES).map(|i| f64::from(i) / f64::from(PIECES));
        let points: Vec<_> = shares.map(|share| self.place(share, height(share))).collect();
        if points.iter().flatten().all(|value| value.is_finite()) {
            out.push(Mark::Curve { points, role, label: None });
            // A text hangs from its corner.
            let [x, y] = self.place(share, height(share) + if above { 0.24 } else { -0.06 });
            out.push(Mark::Text { at: [x + 0.2, y], label: Label::name(name), role, big: false });
        }
    }
}
