//! The planes, and the pixels of the row against the exact values.

use super::Snapshot;
use crate::{
    explain::{Role, Row, Table},
    math::ulps_between,
    message::Value,
};

/// Of a longer row only the last pixels are listed.
const MOST_ROWS: usize = 64;

impl Snapshot {
    pub(super) fn list(&self, out: &mut Vec<Table>) {
        let planes = self.planes.iter().map(|plane| {
            let mut cells: Vec<Value> = plane.normal.map(Value::from).to_vec();
            cells.push(plane.d.into());
            Row::new(plane.name(), cells).active(plane.slopes[0].is_none())
        });
        let columns = vec!["A", "B", "C", "D"];
        out.push(Table { title: "plane-equation-planes", columns, rows: planes.collect() });
        let slopes = self.planes.iter().map(|plane| {
            let cells = vec![plane.slopes[0].into(), plane.slopes[1].into(), plane.value.into()];
            let now = plane.slopes[0].is_some() && (plane.value.is_none() || self.x.is_some());
            Row::new(plane.name(), cells).active(now)
        });
        let columns = vec!["dq/dx", "dq/dy", "q"];
        out.push(Table { title: "plane-equation-slopes", columns, rows: slopes.collect() });
        let first = self.pixels.len().saturating_sub(MOST_ROWS);
        let pixels = self.pixels[first..].iter().map(|&(x, value)| {
            let exact = self.exact_at(x);
            let off = exact.map(|exact| ulps_between(value, exact));
            let ulps = off.map(|off| Value::Int(i64::try_from(off).unwrap_or(i64::MAX)));
            let role = if off == Some(0) { Role::Accepted } else { Role::Changed };
            let cells = vec![value.into(), exact.into(), ulps.unwrap_or(Value::None)];
            Row::new(format!("x = {x}"), cells).role(role).active(self.x == Some(x))
        });
        let columns = vec!["a", "column-exact", "ULP"];
        out.push(Table { title: "plane-equation-pixels", columns, rows: pixels.collect() });
    }
}
