//! What the lab shows of a stencil run.

use super::{Event, Snapshot, StencilOutcome, StencilState, snapshot::Fragment};
use crate::{
    compare::Fact,
    depth::{CompareFunction, Early, scissor_sentence},
    explain::{Cells, Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
    raster::view::view_of,
    stencil::Way,
};

/// Each outcome with the name of the operation that runs then.
const OUTCOMES: [(StencilOutcome, &str); 3] = [
    (StencilOutcome::Fail, "failOp"),
    (StencilOutcome::DepthFail, "depthFailOp"),
    (StencilOutcome::Pass, "passOp"),
];

impl Explain for Snapshot {
    const NAME: &'static str = "stencil";

    const LISTING: &'static [&'static str] = &[
        "for each draw D",
        "  if D is an outline: enlarge it",
        "  for each row in its scissor",
        "    for each pixel: s ← stored value",
        "      if D's alpha fails: discard",
        "      if not (ref & mask) compare (s & mask): s ← failOp(s)",
        "      else if D's depth fails: s ← depthFailOp(s)",
        "      else: s ← passOp(s), colour ← D",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Draw { .. } | Event::Done { .. } => 0,
            Event::Enlarge { .. } => 1,
            Event::Row { .. } | Event::Scissor { .. } => 2,
            Event::Fragment { .. } => 3,
            Event::Early { .. } | Event::Discard { .. } => 4,
            Event::Fail { .. } => 5,
            Event::DepthFail { .. } => 6,
            Event::Pass { .. } => 7,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // Three coordinates a corner.
            Event::Enlarge { corners } => Operations::new(0, 3 * u64::from(*corners), 0),
            Event::Fail { .. } => Operations::new(1, 0, 0),
            // A weighted mean of three, and the comparison.
            Event::Discard { .. } => Operations::new(1, 3, 1),
            // Two ends of a span, and the row itself.
            Event::Scissor { .. } => Operations::new(4, 0, 0),
            Event::DepthFail { .. } | Event::Pass { .. } => Operations::new(2, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Enlarge { .. } | Event::Done { .. } => Level::Primitive,
            Event::Row { .. } | Event::Scissor { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Draw { .. } => (Role::Neutral, Some("stencil-marker-draw")),
            Event::Pass { .. } => (Role::Accepted, None),
            Event::Fail { .. } | Event::DepthFail { .. } => (Role::Rejected, None),
            Event::Discard { .. } => (Role::Skipped, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn caption(&self, event: &Event) -> Option<Message> {
        let label = Self::marker(event)?.label?;
        let Event::Draw { index } = *event else { return None };
        Some(Message::new(label).with("object", Value::text(&self.draws[index as usize].name)))
    }

    fn opening(&self) -> Message {
        Message::new("stencil-opening").with("clear", u32::from(self.settings.clear))
    }

    fn sentence(&self, event: &Event) -> Message {
        let Some((draw, _)) = self.current() else { return self.opening() };
        let message = |id| Message::new(id).with("object", Value::text(&draw.name));
        match *event {
            Event::Draw { .. } => match draw.stencil {
                _ if draw.enlarged.is_some() => message("stencil-outline"),
                None => message("stencil-draw-without"),
                Some(state) => message("stencil-draw")
                    .with("reference", u32::from(state.reference))
                    .with("compare", Value::text(state.compare.name())),
            },
            Event::Enlarge { .. } => {
                let Some((enlarge, _)) = &draw.enlarged else { return message("stencil-outline") };
                let id = match enlarge.way {
                    Way::Scale => "stencil-enlarge-scale",
                    Way::Normals => "stencil-enlarge-normals",
                    Way::Pixels => "stencil-enlarge-pixels",
                };
                message(id).with("amount", enlarge.amount)
            }
            Event::Early { when } => message(match when {
                Early::Whole => "stencil-early-whole",
                Early::TestOnly => "stencil-early-test",
                Early::Never => "stencil-early-never",
            }),
            Event::Scissor { y, whole, kept } => {
                let id = if kept[0] == kept[1] { "stencil-scissor-row" } else { "stencil-scissor" };
                scissor_sentence(message(id), y, [whole, kept])
            }
            Event::Discard { alpha } => message("stencil-discard")
                .with("x", self.fragment.map_or(0, |fragment| fragment.x))
                .with("y", self.y)
                .with("alpha", alpha),
            Event::Row { y, begin, end } => message("stencil-row")
                .with("y", y)
                .with("first", begin)
                .with("end", end)
                .with("count", end - begin),
            Event::Fragment { x, stored, .. } => message("stencil-fragment")
                .with("x", u32::from(x))
                .with("y", self.y)
                .with("stored", u32::from(stored)),
            Event::Fail { after } | Event::DepthFail { after } | Event::Pass { after } => {
                let Some(fragment) = self.fragment else { return message("stencil-done-empty") };
                self.verdict_sentence(&fragment, after)
            }
            Event::Done { failed: 0, depth_failed: 0, passed: 0 } => message("stencil-done-empty"),
            Event::Done { failed, depth_failed, passed } => message("stencil-done")
                .with("passed", passed)
                .with("count", failed + depth_failed + passed)
                .with("failed", failed)
                .with("depth", depth_failed),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let (Event::Fail { after } | Event::DepthFail { after } | Event::Pass { after }) = *event else {
            return;
        };
        let (Some(fragment), Some(state)) = (self.fragment, self.state()) else { return };
        let code = |code: u8| Piece::Number(Value::Code { code: code.into(), width: 8 });
        let number = |n: u8| Piece::Number(u32::from(n).into());
        let Fragment { stored, outcome: Some(outcome), .. } = fragment else { return };
        if let Some(general) = test(state.compare) {
            let mask = || code(state.read_mask);
            let text = Piece::Text;
            let sign = text(relation(state.compare, outcome));
            let reference = [text("("), number(state.reference), text(" & "), mask(), text(") ")];
            let value = [text(" ("), number(stored), text(" & "), mask(), text(")")];
            out.push(Formula {
                general,
                numbers: reference.into_iter().chain([sign]).chain(value).collect(),
            });
        }
        let new = state.operation(outcome).apply(stored, state.reference);
        let numbers = vec![
            Piece::Text("= ("),
            number(stored),
            Piece::Text(" & "),
            code(!state.write_mask),
            Piece::Text(") | ("),
            number(new),
            Piece::Text(" & "),
            code(state.write_mask),
            Piece::Text(") = "),
            Piece::Result(u32::from(after).into()),
        ];
        out.push(Formula { general: "s′ = (s & ¬mask) | (op(s) & mask)", numbers });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.value_table());
        out.push(self.operation_table());
        let rows = self.counts.iter().zip(self.draws.iter()).enumerate().map(|(i, (counts, draw))| {
            let all = std::iter::once(counts.iter().sum()).chain(*counts);
            Row::new(&draw.name, all.map(Value::from).collect()).active(self.draw == Some(i as u32))
        });
        out.push(Table {
            title: "stencil-counts",
            columns: vec![
                "column-fragments",
                "column-stencil-failed",
                "column-depth-failed",
                "column-passed",
            ],
            rows: rows.collect(),
        });
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        self.mark_cells(self.view(), out);
        self.mark_shapes(out);
        if let Some(fragment) = self.fragment {
            out.push(self.cell([fragment.x, self.y], Role::Active));
        }
        self.legend(out);
    }

    fn view(&self) -> View {
        let triangles = self.draws.iter().flat_map(|draw| &draw.triangles);
        let points: Vec<_> = triangles.map(|triangle| triangle.map(|[x, y, _]| [x, y])).collect();
        view_of(&points, &self.settings.raster)
    }

    fn fragment(event: &Event, row: &mut u32) -> Option<[u32; 2]> {
        match *event {
            Event::Row { y, .. } => {
                *row = y;
                None
            }
            Event::Fragment { x, .. } => Some([x.into(), *row]),
            _ => None,
        }
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let [width, height] = self.settings.raster.size;
        let pixels = (0..height).flat_map(|y| (0..width).map(move |x| [x, y]));
        for (pixel, &arrived) in pixels.zip(&self.arrived).filter(|(_, arrived)| **arrived > 0) {
            let owner = self.image.owner(pixel).map(|owner| &self.draws[owner as usize].name);
            let values = vec![
                ("column-object", owner.map(Value::text).into()),
                ("column-stencil", Value::text(self.image.value(pixel))),
                ("column-fragments", u32::from(arrived).into()),
            ];
            out.push(Fact::pixel(pixel, values));
        }
    }
}

impl Snapshot {
    /// The state of the draw in hand.
    fn state(&self) -> Option<StencilState> {
        self.current().and_then(|(draw, _)| draw.stencil)
    }

    /// What became of a fragment, why, and what that did to the stored value.
    fn verdict_sentence(&self, fragment: &Fragment, after: u8) -> Message {
        let (Some((draw, _)), Some(outcome)) = (self.current(), fragment.outcome) else {
            return self.opening();
        };
        let kept = after == fragment.stored;
        let id = match (outcome, draw.stencil.is_some(), kept) {
            (StencilOutcome::Fail, _, true) => "stencil-fail-kept",
            (StencilOutcome::Fail, _, false) => "stencil-fail",
            (StencilOutcome::DepthFail, true, true) => "stencil-depth-fail-kept",
            (StencilOutcome::DepthFail, true, false) => "stencil-depth-fail",
            (StencilOutcome::DepthFail, false, _) => "stencil-depth-fail-untested",
            (StencilOutcome::Pass, true, true) => "stencil-pass-kept",
            (StencilOutcome::Pass, true, false) => "stencil-pass",
            (StencilOutcome::Pass, false, _) => "stencil-pass-untested",
        };
        let [new, depth] = fragment.codes.map(|code| Value::F64(self.settings.format.decode(code)));
        let state = draw.stencil.unwrap_or_default();
        Message::new(id)
            .with("object", Value::text(&draw.name))
            .with("x", fragment.x)
            .with("y", self.y)
            .with("test", Value::text(in_numbers(&state, fragment.stored, outcome)))
            .with("operation", Value::text(state.operation(outcome).name()))
            .with("stored", u32::from(fragment.stored))
            .with("after", u32::from(after))
            .with("new", new)
            .with("sign", Value::text(draw.depth.compare.opposite_sign()))
            .with("depth", depth)
    }

    /// The numbers of the test, bit by bit.
    fn value_table(&self) -> Table {
        let state = self.state().unwrap_or_default();
        let decided = self.fragment.filter(|fragment| fragment.outcome.is_some() || fragment.discarded);
        let after = decided.map(|fragment| self.image.value([fragment.x, self.y]));
        let row = |name: &str, value: Option<u8>| {
            let number = Value::from(value.map(u32::from));
            let bits = value.map(|bits| Value::Bits { bits: bits.into(), width: 8 });
            Row::new(name, vec![number, bits.into()])
        };
        let rows = vec![
            row("reference", Some(state.reference)),
            row("readMask", Some(state.read_mask)),
            row("writeMask", Some(state.write_mask)),
            row("row-before", self.fragment.map(|fragment| fragment.stored))
                .active(self.fragment.is_some() && after.is_none()),
            row("row-after", after).active(after.is_some()),
        ];
        Table { title: "stencil-values", columns: vec!["column-stencil", "column-bits"], rows }
    }

    /// The three operations, and which of them runs.
    fn operation_table(&self) -> Table {
        let state = self.state().unwrap_or_default();
        let rows = OUTCOMES.map(|(outcome, name)| {
            let after = self.fragment.map(|fragment| u32::from(state.after(outcome, fragment.stored)));
            let cells = vec![Value::text(state.operation(outcome).name()), after.into()];
            let runs = self.fragment.is_some_and(|fragment| fragment.outcome == Some(outcome));
            Row::new(name, cells).active(runs)
        });
        let columns = vec!["column-operation", "column-after"];
        Table { title: "stencil-operations", columns, rows: rows.to_vec() }
    }
}

/// The sign of the test, as the verdict says; empty for never and always.
fn relation(compare: CompareFunction, outcome: StencilOutcome) -> &'static str {
    if outcome == StencilOutcome::Fail { compare.opposite_sign() } else { compare.sign() }
}

/// The test with its numbers, or the name of one that does not compare.
fn in_numbers(state: &StencilState, stored: u8, outcome: StencilOutcome) -> String {
    let sign = relation(state.compare, outcome);
    if sign.is_empty() {
        return state.compare.name().to_owned();
    }
    format!("{} {sign} {}", state.reference & state.read_mask, stored & state.read_mask)
}

/// The test in the listing's names, if it compares at all.
fn test(compare: CompareFunction) -> Option<&'static str> {
    Some(match compare {
        CompareFunction::Less => "(ref & mask) < (s & mask)",
        CompareFunction::Equal => "(ref & mask) = (s & mask)",
        CompareFunction::LessEqual => "(ref & mask) ≤ (s & mask)",
        CompareFunction::Greater => "(ref & mask) > (s & mask)",
        CompareFunction::NotEqual => "(ref & mask) ≠ (s & mask)",
        CompareFunction::GreaterEqual => "(ref & mask) ≥ (s & mask)",
        CompareFunction::Never | CompareFunction::Always => return None,
    })
}
