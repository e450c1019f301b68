//! The drawing of a case: what the lab of the operation draws, and on it what is not as the exact answer has it.

use super::Snapshot;
use crate::{
    compare::{Fact, Subject as Part},
    explain::{Grid, Label, Mark, Role, Sign, View},
    labs::{AreaRatios, LabInput},
    message::{Message, Value},
    stress::judge::Deviation,
};

impl Snapshot {
    /// What part of the plane is drawn: the same for all cases, so that only the case moves; one that is made small
    /// is drawn as its lab does.
    pub(super) fn frame(&self) -> View {
        let Some(run) = self.subject.played(&self.case, self.drawn) else { return View::SPACE };
        let view = run.view();
        if self.before.as_ref().is_some_and(|before| *before != self.case) || run.vantage().is_some() {
            return view;
        }
        let (min, max) = match &self.case {
            LabInput::ClipLine(line) => around(line.window),
            LabInput::ClipPolygon(polygon) => around(polygon.window),
            _ if view.grid == Grid::Pixels => ([0.0; 2], self.subject.scene.size.map(|side| side as f32)),
            _ => (view.min, view.max),
        };
        View { min, max, ..view }
    }

    /// The case as it is drawn in its lab, and every part that differs.
    pub(super) fn picture(&self, out: &mut Vec<Mark>) {
        let Some(run) = self.subject.played(&self.case, self.drawn) else { return };
        out.extend(run.marks());
        let deviations = self.deviations();
        for deviation in &deviations {
            self.mark(deviation, out);
        }
        if let Some(worst) = deviations.first() {
            self.mark_value(worst, out);
        }
        curve(&deviations, self.subject.scene.size, out);
        let mut key = |role, id, wanted: &dyn Fn(&Deviation) -> bool| {
            if deviations.iter().any(wanted) {
                out.push(Mark::Key { role, sign: Sign::Marker, meaning: Message::new(id) });
            }
        };
        let pixel =
            |side: &Option<Fact>| side.as_ref().is_some_and(|fact| matches!(fact.subject, Part::Pixel(_)));
        key(Role::Rejected, "stress-key-extra", &|each| pixel(&each.rounded) && each.exact.is_none());
        key(Role::Exact, "stress-key-lost", &|each| pixel(&each.exact) && each.rounded.is_none());
        key(Role::Rejected, "stress-key-far", &|each| {
            each.ulps.is_some() && each.breaks() && pixel(&each.exact)
        });
        // In space the lab draws both outlines.
        if run.vantage().is_some() && !deviations.is_empty() {
            for (role, id) in [(Role::Taught, "stress-key-taught"), (Role::Exact, "stress-key-exact")] {
                out.push(Mark::Key { role, sign: Sign::Line, meaning: Message::new(id) });
            }
        }
    }

    fn mark(&self, deviation: &Deviation, out: &mut Vec<Mark>) {
        let Some(fact) = deviation.either() else { return };
        let Deviation { rounded, exact, ulps } = deviation;
        match fact.subject {
            Part::Pixel(at) => pixel(at, deviation, out),
            _ if fact.at.is_some() => {
                let place = |side: &Option<Fact>| side.as_ref().and_then(|fact| fact.at);
                let ends = [place(rounded), place(exact)];
                if let [Some(a), Some(b)] = ends {
                    out.push(Mark::Segment { ends: [a, b], role: Role::Changed, label: None });
                }
                let off = ulps.map(|ulps| Label::name(format!("{ulps} ULP")));
                let role = if deviation.breaks() { Role::Rejected } else { Role::Taught };
                // The labs of lines name the exact ends.
                let named = matches!(self.case, LabInput::ClipLine(_));
                let exact = (!named).then(|| Label::new("", Value::Word("row-exact")));
                let points = ends.into_iter().zip([(role, off), (Role::Exact, exact)]);
                out.extend(
                    points.filter_map(|(at, (role, label))| Some(Mark::Point { at: at?, role, label })),
                );
            }
            _ => {}
        }
    }

    /// The worst value at a point of a triangle: as it is, and with a star as it should be.
    fn mark_value(&self, deviation: &Deviation, out: &mut Vec<Mark>) {
        let LabInput::AreaRatios(AreaRatios(input)) = &self.case else { return };
        for (star, role, side) in
            [("", Role::Rejected, &deviation.rounded), ("*", Role::Exact, &deviation.exact)]
        {
            let Some(Fact { subject: Part::Named(name), values, .. }) = side else { continue };
            // The lab names the value that it comes to.
            let named = name == "a" && star.is_empty();
            let value = values.first().filter(|_| !named);
            let label = value.map(|(_, value)| Label::new(format!("{name}{star}"), value.clone()));
            out.push(Mark::Point { at: input.at, role, label });
        }
    }
}

/// A window with most of its size around it.
fn around([xmin, ymin, xmax, ymax]: [f32; 4]) -> ([f32; 2], [f32; 2]) {
    let [wide, high] = [xmax - xmin, ymax - ymin].map(|side| 0.75 * side);
    ([xmin - wide, ymin - high], [xmax + wide, ymax + high])
}

/// A pixel that is drawn wrongly, lost, or has another value.
fn pixel(at: [u32; 2], deviation: &Deviation, out: &mut Vec<Mark>) {
    let at = at.map(|c| c as i32);
    let object = deviation.rounded.is_some().then_some(0);
    let role = if deviation.rounded.is_none() { Role::Exact } else { Role::Rejected };
    let mark = |role, object| Mark::Pixel { at, role, object, value: Value::None };
    if deviation.breaks() {
        out.extend([mark(Role::Changed, object), mark(role, object)]);
    }
}

/// How far the values of a row are off, from pixel to pixel: a curve over the row, the farthest highest.
fn curve(deviations: &[Deviation], [_, height]: [u32; 2], out: &mut Vec<Mark>) {
    let off = deviations.iter().filter_map(|each| match each.either()?.subject {
        Part::Pixel(at) => Some((at, each.ulps?)),
        _ => None,
    });
    let mut off: Vec<_> = off.collect();
    off.sort();
    let Some(worst) = off.iter().map(|(_, ulps)| *ulps).max().filter(|_| off.len() > 1) else { return };
    let [_, row] = off[0].0;
    // It stands on the side of the row that has more room.
    let (up, down) = (row as f32, height as f32 - row as f32 - 1.0);
    let (foot, room) = if up > down { (row as f32, -0.8 * up) } else { (row as f32 + 1.0, 0.8 * down) };
    let point = |([x, _], ulps): &([u32; 2], u32)| {
        // By its digits, that is by the logarithm: one bit is as high as the other.
        let share = libm::log2(1.0 + f64::from(*ulps)) / libm::log2(1.0 + f64::from(worst));
        [*x as f32 + 0.5, foot + room * share as f32]
    };
    out.push(Mark::Curve {
        points: off.iter().map(point).collect(),
        role: Role::Rejected,
        label: Some(Label::name(format!("≤ {worst} ULP"))),
    });
    out.push(Mark::Key { role: Role::Rejected, sign: Sign::Line, meaning: Message::new("stress-key-curve") });
}
