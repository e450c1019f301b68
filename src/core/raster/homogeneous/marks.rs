//! The drawing of a homogeneous triangle: the part of each edge in front of the eye, and the near line.

use super::{
    Event, Snapshot, Vertex,
    explain::{NAMES, NEAR_ROW},
    form::{NEAR, ends},
};
use crate::{
    explain::{Explain, Label, MOST_PIXELS, Mark, Role, View},
    message::Value,
    raster::{Span, traversal},
};

/// Where a vertex is seen, if w is not 0 and the quotients are finite: behind the eye turned over.
pub(super) fn projected([x, y, w]: Vertex) -> Option<[f32; 2]> {
    let at = [x / w, y / w];
    at.iter().all(|value| value.is_finite()).then_some(at)
}

impl Snapshot {
    /// The drawing of a step.
    pub(super) fn draw(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw_pixels(out);
        let keeping = match event {
            Some(Event::Walk { event: traversal::Event::Test { keeps_out, .. }, .. }) => *keeps_out,
            _ => 0,
        };
        let lit = match event {
            Some(Event::Coefficient { edge, .. }) => Some(usize::from(*edge)),
            _ => None,
        };
        for edge in 0..3 {
            let role = match lit {
                Some(now) if now == edge => Role::Active,
                _ if keeping & 1 << edge != 0 => Role::Rejected,
                _ => Role::Neutral,
            };
            if let Some(seen) = self.in_front(ends(self.vertices, edge)) {
                out.push(Mark::Segment { ends: seen, role, label: Some(Label::name(NAMES[edge])) });
            }
        }
        if let Some(seen) = self.near_line() {
            let role = match event {
                Some(Event::Near { .. }) => Role::Active,
                _ if keeping & 1 << NEAR != 0 => Role::Rejected,
                _ => Role::Exact,
            };
            out.push(Mark::Segment { ends: seen, role, label: Some(Label::new("near", self.near)) });
        }
        if let Some([x, y]) = self.now {
            let drawn = self.cells.at(x, y).is_some_and(traversal::cells::Cell::is_drawn);
            let tie = self.says([x.into(), y.into()]).iter().any(|says| says.tie);
            let role = if tie { Role::Tie } else { Role::Active };
            let at = [x.into(), y.into()];
            out.push(Mark::Pixel { at, role, object: drawn.then_some(0), value: Value::BLANK });
        }
        for (index, vertex) in self.given.into_iter().enumerate() {
            let label = Label::new(["V0", "V1", "V2"][index], vertex);
            let role = if vertex[2] > 0.0 { Role::Neutral } else { Role::Rejected };
            out.push(match projected(vertex) {
                Some(at) => Mark::Point { at, role, label: Some(label) },
                // A direction has no place: it stands in the corner.
                None => {
                    let View { min, max, y_up, .. } = self.view();
                    let at = [min[0], if y_up { max[1] } else { min[1] }];
                    Mark::Text { at, label, role, big: false }
                }
            });
        }
    }

    fn draw_pixels(&self, out: &mut Vec<Mark>) {
        if self.cells.len() > MOST_PIXELS {
            out.extend(self.result().into_iter().map(|Span { y, begin, end }| Mark::Run {
                y: y as i32,
                columns: [begin as i32, end as i32],
                role: Role::Accepted,
                object: Some(0),
            }));
            return;
        }
        for (at, cell) in self.cells.all().filter(|(_, cell)| cell.is_drawn() || cell.tests() > 0) {
            let (role, object) =
                if cell.is_drawn() { (Role::Accepted, Some(0)) } else { (Role::Skipped, None) };
            out.push(Mark::Pixel { at: at.map(i32::from), role, object, value: Value::None });
        }
    }

    /// The part of an edge that lies in front of the eye; one that comes from behind it runs on far
    /// beyond the picture.
    fn in_front(&self, [p, q]: [Vertex; 2]) -> Option<[[f32; 2]; 2]> {
        /// Of the distance of the nearer end.
        const NEARLY: f32 = 1.0 / 256.0;
        let (p, q) = if p[2] >= q[2] { (p, q) } else { (q, p) };
        if p[2] <= 0.0 {
            return None;
        }
        let w = p[2] * NEARLY;
        if q[2] > w {
            return Some([projected(p)?, projected(q)?]);
        }
        let share = (p[2] - w) / (p[2] - q[2]);
        let at = [0, 1].map(|axis| p[axis] + share * (q[axis] - p[axis]));
        Some([projected(p)?, projected([at[0], at[1], w])?])
    }

    /// Where the near plane meets the picture, once its coefficients are known.
    fn near_line(&self) -> Option<[[f32; 2]; 2]> {
        let [Some(a), Some(b), Some(c)] = self.rows[NEAR_ROW] else { return None };
        let view = self.view();
        let [[left, top], [right, bottom]] = [view.min, view.max].map(|corner| corner.map(f64::from));
        let mut points = Vec::new();
        for y in [top, bottom] {
            let x = -(b * y + c) / a;
            points.extend((x >= left && x <= right).then_some([x as f32, y as f32]));
        }
        for x in [left, right] {
            let y = -(a * x + c) / b;
            points.extend((y >= top && y <= bottom).then_some([x as f32, y as f32]));
        }
        let first = *points.first()?;
        let far = |p: &&[f32; 2]| (p[0] - first[0]).abs() + (p[1] - first[1]).abs() > 1e-3;
        Some([first, *points.iter().find(far)?])
    }
}
