//! The values of a traversal.

use super::{Snapshot, Traversal, explain::NAMES, visits::Visits};
use crate::{
    explain::{Role, Row, Table},
    message::Value,
    raster::{
        Algorithm,
        report::verdict,
        tiled::{SIZES, Tiled},
    },
};

impl<A: Traversal> Snapshot<A> {
    /// Edges at the centre in hand, counts, tiles, and all ways beside each other.
    pub(super) fn list(&self, out: &mut Vec<Table>) {
        let says = self.now.and_then(|at| self.says(at));
        let rows = NAMES.into_iter().enumerate().map(|(edge, name)| {
            let said = says.map(|says| says[edge]);
            let role = said.and_then(|says| match (says.tie, says.draws) {
                (true, _) => Some(Role::Tie),
                (false, true) => None,
                (false, false) => Some(Role::Rejected),
            });
            let value = said.map(|says| says.value).into();
            let cells = vec![Value::text(self.ends_of(edge)), value, said.map_or(Value::None, verdict)];
            Row::new(name, cells).role(role)
        });
        out.push(Table {
            title: "traversal-edges",
            columns: vec!["column-traversal-edge", "column-traversal-value", "column-traversal-verdict"],
            rows: rows.collect(),
        });
        let [tested, drawn, skipped] = self.counts;
        let count = |name: &str, count: u32| Row::new(name, vec![count.into()]);
        let mut rows = vec![
            count("row-traversal-box", self.cells.len() as u32),
            count("row-traversal-tested", tested),
            count("row-traversal-drawn", drawn),
            count("row-traversal-wasted", self.wasted()),
            count("row-traversal-skipped", skipped),
        ];
        rows.retain(|row| row.name != "row-traversal-skipped" || skipped > 0);
        out.push(Table { title: "traversal-counts", columns: vec!["column-traversal-centres"], rows });
        if A::NAME == Tiled::NAME {
            let rows = SIZES.into_iter().zip(self.tiles).map(|(size, counts)| {
                let active = self.nested.last().is_some_and(|tile| u32::from(tile.2) == size);
                Row::new(format!("{size} × {size}"), counts.map(Value::from).to_vec()).active(active)
            });
            out.push(Table {
                title: "traversal-tiles",
                columns: vec![
                    "column-traversal-outside",
                    "column-traversal-inside",
                    "column-traversal-split",
                ],
                rows: rows.collect(),
            });
        }
        let ways = self.ways.iter().map(|(way, visits)| {
            let name = match way {
                Algorithm::Backtracking => "row-traversal-backtracking",
                Algorithm::Zigzag => "row-traversal-zigzag",
                Algorithm::Tiled => "row-traversal-tiled",
                _ => "row-traversal-aabb",
            };
            let Visits { visited, tested, drawn, wasted, .. } = *visits;
            let cells = [visited, tested, drawn, wasted].map(Value::from).to_vec();
            Row::new(name, cells)
        });
        out.push(Table {
            title: "traversal-ways",
            columns: vec![
                "column-traversal-visited",
                "column-traversal-tested",
                "column-traversal-drawn",
                "column-traversal-wasted",
            ],
            rows: ways.collect(),
        });
    }

    /// Tests that drew nothing new.
    fn wasted(&self) -> u32 {
        let drawing = self.cells.all().filter(|(_, cell)| cell.is_drawn() && cell.tests() > 0).count();
        self.counts[0].saturating_sub(drawing as u32)
    }
}
