//! What the labs of this stage share: the segment while it is being cut, and its picture.

use super::{Border, End, Outcode, Point, Segment, Window};
use crate::{
    compare::Fact,
    explain::{Formula, Grid, Label, Mark, Piece, Role, Row, Table, View},
    math::{Arithmetic, ulps_between},
    message::{Message, Value},
};

/// The segment while it is being cut: the part of the fold that all algorithms of this stage have.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Subject {
    pub(super) arithmetic: Arithmetic,
    /// As it was given.
    pub(super) original: Segment,
    /// The ends as they stand.
    pub(super) ends: Segment,
    /// Which ends have moved.
    moved: [bool; 2],
    /// `Some(true)` accepted, `Some(false)` rejected, `None` still running.
    pub(super) accepted: Option<bool>,
}

impl Subject {
    pub(super) fn new(original: Segment, arithmetic: Arithmetic) -> Self {
        Self { arithmetic, original, ends: original, moved: [false; 2], accepted: None }
    }

    /// Whether the run answers exactly.
    pub(super) fn is_exact(&self) -> bool {
        self.arithmetic.is_exact()
    }

    /// Moves an end; returns where it was.
    pub(super) fn move_end(&mut self, end: End, to: Point) -> Point {
        self.moved[end as usize] = true;
        std::mem::replace(&mut self.ends[end as usize], to)
    }

    pub(super) fn has_moved(&self, end: End) -> bool {
        self.moved[end as usize]
    }

    /// The name of an end as it stands.
    pub(super) fn name(&self, end: End) -> &'static str {
        if self.has_moved(end) { ["P1′", "P2′"][end as usize] } else { end.name() }
    }

    /// The result that the events so far amount to.
    pub(super) fn result(&self) -> Option<Segment> {
        (self.accepted == Some(true)).then_some(self.ends)
    }

    /// Whether it is decided, and otherwise than in `right`.
    fn differs(&self, right: Option<Segment>) -> bool {
        let bits = |ends: Option<Segment>| ends.map(|ends| ends.map(|p| p.map(f32::to_bits)));
        self.accepted.is_some() && bits(self.result()) != bits(right)
    }

    /// What is cut off, in one piece at each end.
    pub(super) fn draw_removed(&self, out: &mut Vec<Mark>) {
        for end in End::ALL.into_iter().filter(|end| self.has_moved(*end)) {
            let ends = [self.original[end as usize], self.ends[end as usize]];
            out.push(Mark::Segment { ends, role: Role::Rejected, label: None });
        }
    }

    /// What is left; if it is not what is `right`, that beside it.
    pub(super) fn draw_rest(&self, right: Option<Segment>, out: &mut Vec<Mark>) {
        out.push(Mark::Segment { ends: self.ends, role: self.role(right), label: None });
        if let (true, Some(ends)) = (self.differs(right), right) {
            out.push(Mark::Segment { ends, role: Role::Exact, label: None });
            for (end, at) in End::ALL.into_iter().zip(ends) {
                if self.accepted == Some(false) || self.ends[end as usize] != at {
                    let label = (at != self.original[end as usize])
                        .then(|| Label::new(["P1*", "P2*"][end as usize], at));
                    out.push(Mark::Point { at, role: Role::Exact, label });
                }
            }
        }
    }

    /// The given ends, and where they were moved; `now` is the one that the step moved.
    pub(super) fn draw_ends(&self, now: Option<End>, right: Option<Segment>, out: &mut Vec<Mark>) {
        for end in End::ALL {
            let at = self.original[end as usize];
            out.push(Mark::Point { at, role: Role::Neutral, label: Some(Label::new(end.name(), at)) });
            if self.has_moved(end) {
                let at = self.ends[end as usize];
                let role = match self.accepted {
                    _ if now == Some(end) => Role::Active,
                    None => Role::Neutral,
                    Some(_) => self.role(right),
                };
                out.push(Mark::Point { at, role, label: Some(Label::new(self.name(end), at)) });
            }
        }
    }

    /// What is left of the segment: being looked at, kept, lost, or kept in the wrong place.
    fn role(&self, right: Option<Segment>) -> Role {
        match self.accepted {
            None => Role::Active,
            Some(true) if self.differs(right) => Role::Taught,
            Some(true) => Role::Accepted,
            Some(false) => Role::Rejected,
        }
    }

    /// The answer, and where the ends are if something is visible.
    pub(super) fn facts(&self, out: &mut Vec<Fact>) {
        let Some(accepted) = self.accepted else { return };
        out.push(Fact::answer(if accepted { "word-accepted" } else { "word-rejected" }));
        if accepted {
            out.extend(End::ALL.map(|end| Fact::point(end.name(), self.ends[end as usize])));
        }
    }

    /// The result beside what is `right`, coordinate by coordinate.
    pub(super) fn comparison(&self, right: Option<Segment>) -> Table {
        let mut rows = Vec::new();
        for end in End::ALL {
            for (axis, name) in ["x", "y"].into_iter().enumerate() {
                let of = |ends: Option<Segment>| ends.map(|ends| ends[end as usize][axis]);
                let (here, there) = (of(self.result()), of(right));
                let apart = here.zip(there).map(|(a, b)| ulps_between(a, b));
                let wrong = self.accepted.is_some() && (here.is_some() != there.is_some() || apart > Some(0));
                let apart = apart.map_or(Value::None, |n| Value::Int(i64::try_from(n).unwrap_or(i64::MAX)));
                let row = Row::new(format!("{} {name}", end.name()), vec![here.into(), there.into(), apart]);
                rows.push(row.role(wrong.then_some(Role::Taught)));
            }
        }
        Table {
            title: "clip-line-comparison",
            columns: vec!["column-clip-line-here", "column-clip-line-right", "ULP"],
            rows,
        }
    }
}

/// The window's outline.
pub(in crate::clip) fn draw_window(corners: &[Point], out: &mut Vec<Mark>) {
    let points = corners.to_vec();
    out.push(Mark::Polygon { points, role: Role::Neutral, object: None, label: None });
}

/// The lines of the four borders; one of them is what the step is about, with a few words.
pub(in crate::clip) fn draw_borders(
    window: &Window,
    active: Option<Border>,
    note: Option<Message>,
    out: &mut Vec<Mark>,
) {
    for border in Border::ALL {
        let now = active == Some(border);
        let at = window.at(border);
        out.push(Mark::Guide {
            axis: border.axis() as u8,
            at,
            role: if now { Role::Active } else { Role::Candidate },
            label: Some(Label::new(border.name(), at)),
            note: note.clone().filter(|_| now),
        });
    }
}

/// The code of each of the nine regions, at its upper left corner; those that hold one of the
/// named points stand out.
pub(in crate::clip) fn draw_region_codes(
    view: View,
    window: &Window,
    points: &[(&'static str, Option<Outcode>)],
    out: &mut Vec<Mark>,
) {
    let View { min, max, .. } = view;
    let Window { xmin, ymin, xmax, ymax } = *window;
    for (y, vertical) in [(max[1], 0b1000), (ymax, 0), (ymin, 0b0100)] {
        for (x, horizontal) in [(min[0], 0b0001), (xmin, 0), (xmax, 0b0010)] {
            let code = Outcode(vertical | horizontal);
            let here: Vec<_> =
                points.iter().filter(|(_, at)| *at == Some(code)).map(|(name, _)| *name).collect();
            out.push(Mark::Text {
                at: [x, y],
                role: if here.is_empty() { Role::Candidate } else { Role::Neutral },
                label: Label::new(code.to_string(), (!here.is_empty()).then(|| Value::text(here.join(", ")))),
                big: true,
            });
        }
    }
    // What the four bits mean, under the first code.
    let label = Label::new("", Value::Word("clip-line-legend"));
    out.push(Mark::Text { at: [min[0], max[1]], label, role: Role::Candidate, big: false });
}

/// What the labs of this stage show: the given points, the window's corners, and some room around.
pub(super) fn view(points: impl IntoIterator<Item = Point>) -> View {
    let (mut min, mut max) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
    for p in points {
        for axis in 0..2 {
            min[axis] = min[axis].min(p[axis]);
            max[axis] = max[axis].max(p[axis]);
        }
    }
    for axis in 0..2 {
        // Room for what stands in the outer regions; capped so that huge inputs stay finite.
        let margin = ((max[axis] / 2.0 - min[axis] / 2.0) * 0.4).max(0.5);
        min[axis] = (min[axis] - margin).max(f32::MIN / 4.0);
        max[axis] = (max[axis] + margin).min(f32::MAX / 4.0);
    }
    View { min, max, y_up: true, grid: Grid::Units }
}

/// The bits of a code as a value to be shown.
pub(in crate::clip) fn bits(code: Outcode) -> Value {
    Value::Bits { bits: code.0.into(), width: 4 }
}

/// The borders that a code names, one or two of them, as arguments of a message.
pub(in crate::clip) fn with_borders(message: Message, code: Outcode) -> Message {
    let mut beyond = Border::ALL.into_iter().filter(|&border| code.has(border)).map(Border::word);
    let [first, second] = [beyond.next(), beyond.next()].map(|id| id.map(Value::Word));
    message
        .with("borders", 1 + usize::from(second.is_some()))
        .with("first", first)
        .with("second", second)
        .with("code", bits(code))
}

/// Two codes joined to a third.
pub(super) fn joined(general: &'static str, sign: &'static str, [c1, c2, result]: [Outcode; 3]) -> Formula {
    let numbers = vec![
        Piece::Number(bits(c1)),
        Piece::Text(sign),
        Piece::Number(bits(c2)),
        Piece::Text(" = "),
        Piece::Result(bits(result)),
    ];
    Formula { general, numbers }
}
