//! A pixel both ways, the count of differences, and the points of the line.

use super::{STEPS, Snapshot, explain::word};
use crate::{
    explain::{Role, Row, Table},
    interpolate::Mode,
    message::Value,
};

impl Snapshot {
    pub(super) fn list(&self, out: &mut Vec<Table>) {
        if !self.in_line {
            out.push(self.both_ways());
        }
        let counts = vec![self.texels.len().into(), self.differing().into()];
        out.push(Table {
            title: "perspective-correction-counts",
            columns: vec!["column-drawn", "column-differ"],
            rows: vec![Row::new("row-pixels", counts)],
        });
        let last = self.along.len().checked_sub(1);
        let rows = self.along.iter().enumerate().map(|(step, &[z, r])| {
            let t = step as f64 / f64::from(STEPS);
            let name = format!("t = {t}");
            Row::new(name, vec![z.into(), r.into(), (1.0 / r).into()]).active(last == Some(step))
        });
        let columns = vec!["z", "1/w", "d"];
        out.push(Table { title: "perspective-correction-curves", columns, rows: rows.collect() });
    }

    /// The pixel in hand in both modes.
    fn both_ways(&self) -> Table {
        let index = match self.pixel {
            // Looked up already, or about to be.
            Some((pixel, _)) => match self.texels.last() {
                Some(texel) if texel.pixel == pixel => Some(self.texels.len() - 1),
                _ => Some(self.texels.len()),
            },
            None => None,
        };
        let other = index.and_then(|index| self.others.get(index));
        let mine = self.pixel.map(|(_, uv)| uv);
        let square = index.and_then(|index| self.texels.get(index)).map(|texel| texel.light);
        let row = |name: &str, uv: Option<[f32; 2]>, light: Option<bool>| {
            let [u, v] = uv.map_or([Value::None, Value::None], |uv| uv.map(Value::from));
            Row::new(name, vec![u, v, light.map_or(Value::None, |light| Value::Word(word(light)))])
        };
        let mine = row(mode_row(self.mode), mine, square).active(true);
        let theirs = if self.mode == Mode::Affine { Mode::Perspective } else { Mode::Affine };
        let differs = matches!((square, other), (Some(light), Some(other)) if light != other.light);
        let other = row(mode_row(theirs), other.map(|other| other.uv), other.map(|other| other.light));
        let other = other.role(differs.then_some(Role::Changed));
        Table {
            title: "perspective-correction-pixel",
            columns: vec!["u", "v", "column-square"],
            rows: vec![mine, other],
        }
    }
}

fn mode_row(mode: Mode) -> &'static str {
    match mode {
        Mode::Affine => "row-affine",
        Mode::Perspective => "row-perspective",
    }
}
