//! What the lab says of scissor, alpha test and bias.

use super::{Early, Snapshot, snapshot::Fragment};
use crate::{
    depth::{DepthBias, DepthPlane},
    explain::{Formula, Piece, Row, Table},
    math::Tally,
    message::{Message, Value},
};

/// Why early z is possible, or not.
pub(super) fn early_id(when: Early, on: bool) -> &'static str {
    match (when, on) {
        (Early::Whole, _) => "z-buffer-early-whole",
        (_, false) => "z-buffer-early-off",
        (Early::TestOnly, true) => "z-buffer-early-test",
        (Early::Never, true) => "z-buffer-early-never",
    }
}

/// What the alpha test decided, and what that means for the depth.
pub(super) fn alpha_sentence(
    message: impl Fn(&'static str) -> Message,
    (alpha, kept): (f32, bool),
    state: &Snapshot,
) -> Message {
    let test = state.current_rules().cutout.map(|cutout| cutout.test).unwrap_or_default();
    let id = match (kept, state.settings.early_z) {
        (true, true) => "z-buffer-alpha-kept-early",
        (true, false) => "z-buffer-alpha-kept",
        (false, true) => "z-buffer-alpha-discarded-early",
        (false, false) => "z-buffer-alpha-discarded",
    };
    let sign = if kept { test.compare.sign() } else { test.compare.opposite_sign() };
    let sign = if sign.is_empty() { test.compare.name() } else { sign };
    message(id).with("alpha", alpha).with("sign", Value::text(sign)).with("reference", test.reference)
}

impl Snapshot {
    /// The columns of the counts that are needed, and which count each shows.
    pub(super) fn count_columns(&self) -> Vec<(&'static str, usize)> {
        let mut columns = vec![("column-passed", 0), ("column-failed", 1)];
        if self.triangles.len() > 1 {
            columns.push(("column-equal-codes", 4));
        }
        if self.rules.iter().any(|rules| rules.cutout.is_some()) {
            columns.push(("column-discarded", 2));
        }
        if self.rules.iter().any(|rules| rules.scissor.is_some()) {
            columns.push(("column-scissored", 3));
        }
        columns
    }

    /// The plane of the triangle in hand without and with its bias, if it has one.
    fn planes(&self) -> Option<[DepthPlane; 2]> {
        let placement = self.current_rules().placement;
        let triangle = self.triangles[self.triangle? as usize];
        let bare = DepthPlane::new(triangle, self.settings.raster.arithmetic, &mut Tally::default());
        (!placement.is_plain()).then(|| [bare, bare.placed(&placement, self.settings.format)])
    }

    /// A depth as the sum of the plane's and the bias.
    pub(super) fn bias_formula(&self, fragment: &Fragment) -> Option<Formula> {
        let [bare, placed] = self.planes()?;
        let depth = bare.depth([fragment.x, self.y], &mut Tally::default());
        let number = |value: f64| Piece::Number(value.into());
        let text = Piece::Text;
        let numbers =
            vec![text("= "), number(depth.into()), text(" + "), number(placed.bias()), text(", = ")];
        let kept = Piece::Result(fragment.z.into());
        Some(Formula {
            general: "z = plane + bias, kept in 0 … 1",
            numbers: numbers.into_iter().chain([kept]).collect(),
        })
    }

    /// The alpha test in numbers.
    pub(super) fn alpha_formula(&self, alpha: f32) -> Option<Formula> {
        let test = self.current_rules().cutout?.test;
        let kept = self.fragment?.alpha?.1;
        let sign = if kept { test.compare.sign() } else { test.compare.opposite_sign() };
        if sign.is_empty() {
            return None;
        }
        let space = || Piece::Text(" ");
        let numbers = vec![
            Piece::Result(alpha.into()),
            space(),
            Piece::Text(sign),
            space(),
            Piece::Number(test.reference.into()),
        ];
        Some(Formula { general: "alpha compare reference", numbers })
    }

    /// What the bias of the triangle in hand is made of.
    pub(super) fn bias_table(&self) -> Option<Table> {
        let [bare, placed] = self.planes()?;
        let DepthBias { constant, slope, clamp } = self.current_rules().placement.bias;
        let step = DepthBias::step(self.settings.format, bare.greatest());
        let row = |name: &str, value: Value| Row::new(name, vec![value]);
        let rows = vec![
            row("row-bias-constant", Value::Int(constant.into())),
            row("r", step.into()),
            row("row-bias-slope", slope.into()),
            row("max |dz/dx|, |dz/dy|", bare.steepest().into()),
            row("row-bias-clamp", if clamp == 0.0 { Value::None } else { clamp.into() }),
            row("row-bias", placed.bias().into()),
        ];
        Some(Table { title: "z-buffer-bias", columns: vec!["column-value"], rows })
    }
}
