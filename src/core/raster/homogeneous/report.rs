//! Why a homogeneous triangle draws a pixel or not.

use super::{
    Snapshot, area,
    explain::NAMES,
    form::{NEAR, gradient},
};
use crate::{
    explain::{PixelReport, Role, Row, Table},
    message::{Message, Value},
    raster::{YAxis, edge::centre, report::verdict},
};

impl Snapshot {
    /// The verdict on a pixel, with the value of each edge; `None` outside the image.
    pub(super) fn report(&self, at @ [x, y]: [u32; 2]) -> Option<PixelReport> {
        if x >= self.settings.size[0] || y >= self.settings.size[1] {
            return None;
        }
        let about = |id| Message::new(id).with("x", x).with("y", y).with("centre", centre(x, y));
        let says = self.says(at);
        let area = area(self.vertices, &self.settings);
        let sentence = if says.is_empty() {
            about("pixel-zero-area")
        } else if !area.columns.contains(&x) || !area.rows.contains(&y) {
            about("pixel-outside-box")
        } else {
            let of = |id, edge: usize| {
                about(id)
                    .with("edge", Value::text(format!("{} ({})", NAMES[edge], Self::ends_of(edge))))
                    .with("value", says[edge].value)
                    .with("kind", Value::Word(self.kind(edge)))
                    .with("rule", Value::Word(self.settings.fill_rule.word()))
            };
            let out = says.iter().position(|says| !says.draws && !says.tie);
            let lost = says.iter().position(|says| !says.draws);
            match (out, lost, says[..3].iter().position(|says| says.tie)) {
                (Some(NEAR), ..) => about("homogeneous-pixel-near").with("near", self.near),
                (Some(edge), ..) => of("pixel-out", edge),
                (None, Some(edge), _) => of("pixel-tie-lost", edge),
                (None, None, Some(edge)) => of("pixel-tie-drawn", edge),
                (None, None, None) => about("pixel-in"),
            }
        };
        let rows = says.iter().zip(NAMES).map(|(says, name)| {
            let role = if says.tie {
                Role::Tie
            } else if says.draws {
                Role::Accepted
            } else {
                Role::Rejected
            };
            Row::new(name, vec![says.value.into(), verdict(*says)]).role(role)
        });
        let table = Table {
            title: "traversal-edges",
            columns: vec!["column-traversal-value", "column-traversal-verdict"],
            rows: rows.collect(),
        };
        Some(PixelReport { sentence, warning: None, tables: vec![table] })
    }

    fn kind(&self, edge: usize) -> &'static str {
        let [with_x, with_y] = gradient(self.vertices, edge.min(2), self.turned);
        let below = if self.settings.y_axis == YAxis::Down { with_y } else { -with_y };
        match (with_x.is_zero(), with_x.is_positive(), below.is_positive()) {
            (true, _, true) => "word-edge-top",
            (true, _, false) => "word-edge-bottom",
            (false, true, _) => "word-edge-left",
            (false, false, _) => "word-edge-right",
        }
    }
}
