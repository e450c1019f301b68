//! What the lab shows of a z-buffer run.

use super::{Event, Snapshot, rules, snapshot::Fragment};
use crate::{
    compare::Fact,
    depth::{CompareFunction, DepthFormat, scissor_sentence},
    explain::{
        Cells, Explain, Formula, Label, Level, Mark, Marker, Operations, Piece, Role, Row, Sign, Table, View,
    },
    message::{Message, Value},
    raster::view::view_of,
};

/// What a pixel held, what comes to it, what it holds then: message ids.
const ROWS: [&str; 3] = ["row-before", "row-arrives", "row-after"];

/// Of more triangles only the last ones are counted one by one.
const MOST_COUNTS: usize = 4096;
/// Of more triangles only the one being drawn has an outline: the others would hide the image.
const MOST_OUTLINES: usize = 64;

impl Explain for Snapshot {
    const NAME: &'static str = "z-buffer";

    const LISTING: &'static [&'static str] = &[
        "for each triangle T",
        "  for each row in its scissor",
        "    for each pixel: new ← T's code",
        "      if T's alpha fails: discard",
        "      if new passes against stored: stored ← new, colour ← T",
        "      else: keep what is there",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Triangle { .. } | Event::Done { .. } => 0,
            Event::Row { .. } | Event::Scissor { .. } => 1,
            Event::Fragment { .. } => 2,
            Event::Early { .. } | Event::Alpha { .. } => 3,
            Event::Pass => 4,
            Event::Fail => 5,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // The plane's value at a centre, and what scales it to the format.
            Event::Fragment { .. } => Operations::new(0, 3, 0),
            Event::Pass | Event::Fail => Operations::new(1, 0, 0),
            // A weighted mean of three, and the comparison.
            Event::Alpha { .. } => Operations::new(1, 3, 1),
            // Two ends of a span, and the row itself.
            Event::Scissor { .. } => Operations::new(4, 0, 0),
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done { .. } => Level::Primitive,
            Event::Row { .. } | Event::Scissor { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Triangle { .. } => (Role::Neutral, Some("z-buffer-marker-triangle")),
            Event::Pass => (Role::Accepted, None),
            Event::Fail => (Role::Rejected, None),
            Event::Alpha { kept: false, .. } => (Role::Skipped, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn caption(&self, event: &Event) -> Option<Message> {
        let label = Self::marker(event)?.label?;
        let Event::Triangle { index } = *event else { return None };
        Some(Message::new(label).with("object", self.name_of(Some(index))))
    }

    fn opening(&self) -> Message {
        Message::new("z-buffer-opening").with("clear", self.settings.clear)
    }

    fn sentence(&self, event: &Event) -> Message {
        let message = |id| Message::new(id).with("object", self.name());
        match *event {
            Event::Triangle { .. } => message("z-buffer-triangle"),
            Event::Row { y, begin, end } => message("z-buffer-row")
                .with("y", y)
                .with("first", begin)
                .with("end", end)
                .with("count", end - begin),
            Event::Early { when, on } => message(rules::early_id(when, on)),
            Event::Scissor { y, whole, kept } => {
                let id = if kept[0] == kept[1] { "z-buffer-scissor-row" } else { "z-buffer-scissor" };
                scissor_sentence(message(id), y, [whole, kept])
            }
            Event::Alpha { alpha, kept } => {
                let x = self.fragment.map_or(0, |fragment| fragment.x);
                rules::alpha_sentence(message, (alpha, kept), self).with("x", x).with("y", self.y)
            }
            Event::Fragment { .. } | Event::Pass | Event::Fail => {
                let Some(fragment) = self.fragment else { return message("z-buffer-triangle") };
                message(self.sentence_id(event, &fragment))
                    .with("x", fragment.x)
                    .with("y", self.y)
                    .with("new", self.depth(fragment.code))
                    .with("stored", self.depth(fragment.stored))
                    .with("sign", Value::text(self.relation(&fragment)))
                    .with("before", self.name_of(fragment.owner))
            }
            Event::Done { passed: 0, failed: 0 } => message("z-buffer-done-empty"),
            Event::Done { passed, failed } => {
                message("z-buffer-done").with("passed", passed).with("count", passed + failed)
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let Some(fragment) = self.fragment else { return };
        match event {
            Event::Fragment { .. } => {
                out.extend(self.bias_formula(&fragment));
                out.extend(self.code_formula(&fragment));
            }
            Event::Alpha { alpha, .. } => out.extend(self.alpha_formula(*alpha)),
            Event::Pass | Event::Fail if self.settings.state.test => {
                let Some(general) = test(self.settings.state.compare) else { return };
                let [new, stored] = [fragment.code, fragment.stored].map(|code| self.depth(code));
                let sign = Piece::Text(self.relation(&fragment));
                let space = || Piece::Text(" ");
                let numbers = vec![Piece::Result(new), space(), sign, space(), Piece::Number(stored)];
                out.push(Formula { general, numbers });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.test_table());
        if let (Some(_), Some(fragment)) = (self.settings.format.max_code(), self.fragment) {
            let width = self.settings.format.bits();
            let bits = |code: Option<u32>| vec![code.map_or(Value::None, |bits| Value::Bits { bits, width })];
            let after = fragment.is_decided().then(|| self.image.depth.code([fragment.x, self.y]));
            let rows =
                vec![Row::new("row-before", bits(Some(fragment.stored))), Row::new("row-after", bits(after))];
            out.push(Table { title: "z-buffer-bits", columns: vec!["column-bits"], rows });
        }
        out.extend(self.bias_table());
        let first = self.counts.len().saturating_sub(MOST_COUNTS);
        let columns = self.count_columns();
        let rows = self.counts.iter().zip(0..).skip(first).map(|(counts, index)| {
            let name = &self.names[index as usize].text;
            let of = columns.iter().map(|(_, what)| counts[*what].into());
            let all = std::iter::once(counts[..4].iter().sum::<u32>().into()).chain(of);
            Row::new(name, all.collect()).active(self.triangle == Some(index))
        });
        let names = std::iter::once("column-fragments").chain(columns.iter().map(|(name, _)| *name));
        out.push(Table { title: "z-buffer-counts", columns: names.collect(), rows: rows.collect() });
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        self.mark_cells(self.view(), out);
        let few = self.triangles.len() <= MOST_OUTLINES;
        let outlined = |index| few || self.triangle == Some(index);
        for (triangle, index) in self.triangles.iter().zip(0..).filter(|(_, index)| outlined(*index)) {
            let points = triangle.map(|[x, y, _]| [x, y]);
            let role = if self.triangle == Some(index) { Role::Neutral } else { Role::Candidate };
            let name = &self.names[index as usize];
            let label = Some(Label::name(&name.text).of(name.object));
            out.push(Mark::Polygon { points: points.to_vec(), role, object: None, label });
        }
        if let Some(fragment) = self.fragment {
            out.push(self.cell([fragment.x, self.y], Role::Active));
        }
        self.legend(out);
    }

    fn view(&self) -> View {
        let points: Vec<_> = self.triangles.iter().map(|triangle| triangle.map(|[x, y, _]| [x, y])).collect();
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
            let values = vec![
                ("column-object", self.name_of(self.image.owner(pixel))),
                ("column-depth", self.depth(self.image.depth.code(pixel))),
                ("column-fragments", u32::from(arrived).into()),
            ];
            out.push(Fact::pixel(pixel, values));
        }
    }
}

impl Snapshot {
    pub(super) fn depth(&self, code: u32) -> Value {
        match self.settings.format {
            DepthFormat::F32 => f32::from_bits(code).into(),
            format => format.decode(code).into(),
        }
    }

    /// The name of the triangle being drawn.
    fn name(&self) -> Value {
        self.name_of(self.triangle)
    }

    /// A triangle's name; none for what is empty.
    fn name_of(&self, triangle: Option<u32>) -> Value {
        triangle.map(|index| Value::text(&self.names[index as usize].text)).into()
    }

    fn sentence_id(&self, event: &Event, fragment: &Fragment) -> &'static str {
        let state = self.settings.state;
        let empty = fragment.owner.is_none();
        match event {
            Event::Pass if !state.test => "z-buffer-pass-untested",
            Event::Pass => match state.compare {
                CompareFunction::Always => "z-buffer-pass-always",
                _ if !state.write => "z-buffer-pass-unwritten",
                CompareFunction::Less if !empty => "z-buffer-pass-nearer",
                _ => "z-buffer-pass",
            },
            Event::Fail => match state.compare {
                CompareFunction::Never => "z-buffer-fail-never",
                _ if empty => "z-buffer-fail-empty",
                _ => "z-buffer-fail",
            },
            _ if empty => "z-buffer-fragment-empty",
            _ => "z-buffer-fragment",
        }
    }

    /// How the fragment's depth stands to the stored one, as the verdict says.
    fn relation(&self, fragment: &Fragment) -> &'static str {
        let compare = self.settings.state.compare;
        if fragment.passed == Some(false) { compare.opposite().sign() } else { compare.sign() }
    }

    /// The code of the fragment's depth in a unorm format.
    fn code_formula(&self, fragment: &Fragment) -> Option<Formula> {
        let (general, scale) = match self.settings.format {
            DepthFormat::F32 => return None,
            DepthFormat::Unorm16 => ("code = ⌊z · 65535 + ½⌋", " · 65535 + ½⌋ = "),
            DepthFormat::Unorm24 => ("code = ⌊z · 16777215 + ½⌋", " · 16777215 + ½⌋ = "),
            DepthFormat::Unorm32 => ("code = ⌊z · 4294967295 + ½⌋", " · 4294967295 + ½⌋ = "),
        };
        let numbers = vec![
            Piece::Text("= ⌊"),
            Piece::Number(fragment.z.into()),
            Piece::Text(scale),
            Piece::Result(Value::text(fragment.code)),
        ];
        Some(Formula { general, numbers })
    }

    /// What was stored, what arrives, and what is stored now.
    fn test_table(&self) -> Table {
        let format = self.settings.format;
        let unorm = format.max_code().is_some();
        let columns = if unorm {
            vec!["column-object", "column-depth", "column-code", "column-hex"]
        } else {
            vec!["column-object", "column-depth", "column-hex"]
        };
        let unknown = |name: &str| Row::new(name, vec![Value::None; columns.len()]);
        let Some(fragment) = self.fragment else {
            let rows = ROWS.map(unknown).to_vec();
            return Table { title: "z-buffer-test", columns, rows };
        };
        let pixel = [fragment.x, self.y];
        let row = |name: &str, owner: Option<u32>, code: u32| {
            let mut cells = vec![self.name_of(owner), self.depth(code)];
            if unorm {
                cells.push(Value::text(code)); // a code, not a count: digits in one group
            }
            cells.push(Value::Code { code, width: format.bits() });
            Row::new(name, cells)
        };
        let verdict = match fragment.passed {
            None => Role::Candidate,
            Some(true) => Role::Accepted,
            Some(false) => Role::Rejected,
        };
        let [before, arrives, after] = ROWS;
        let decided = fragment.is_decided();
        let after = if decided {
            row(after, self.image.owner(pixel), self.image.depth.code(pixel)).active(true)
        } else {
            unknown(after)
        };
        let rows = vec![
            row(before, fragment.owner, fragment.stored),
            row(arrives, self.triangle, fragment.code).role(verdict).active(!decided),
            after,
        ];
        Table { title: "z-buffer-test", columns, rows }
    }

    /// What ticks, crosses and outlines mean.
    fn legend(&self, out: &mut Vec<Mark>) {
        if self.triangle.is_none() {
            return;
        }
        let mut key = |role, sign, id, name: Value| {
            out.push(Mark::Key { role, sign, meaning: Message::new(id).with("object", name) });
        };
        key(Role::Accepted, Sign::Marker, "z-buffer-key-passed", self.name());
        key(Role::Rejected, Sign::Marker, "z-buffer-key-failed", self.name());
        if self.verdicts.iter().any(|(_, role)| *role == Role::Tie) {
            key(Role::Tie, Sign::Marker, "z-buffer-key-equal", self.name());
        }
        key(Role::Neutral, Sign::Line, "z-buffer-key-object", self.name());
        let others: Vec<u32> = (0..)
            .zip(self.names.iter())
            .map(|(index, _)| index)
            .filter(|i| Some(*i) != self.triangle)
            .collect();
        match others[..] {
            [] => {}
            [other] => key(Role::Candidate, Sign::Line, "z-buffer-key-object", self.name_of(Some(other))),
            _ => key(Role::Candidate, Sign::Line, "z-buffer-key-others", Value::None),
        }
    }
}

impl Cells for Snapshot {
    fn size(&self) -> [u32; 2] {
        self.settings.raster.size
    }

    fn object(&self, pixel: [u32; 2]) -> Option<usize> {
        self.image.owner(pixel).map(|owner| self.names[owner as usize].object)
    }

    fn cell(&self, pixel: [u32; 2], role: Role) -> Mark {
        let value = match self.depth(self.image.depth.code(pixel)) {
            Value::F64(depth) => Value::F32(depth as f32),
            other => other,
        };
        Mark::Pixel { at: pixel.map(|n| n as i32), role, object: self.object(pixel), value }
    }

    fn verdicts(&self) -> &[([u16; 2], Role)] {
        &self.verdicts
    }

    fn row(&self) -> u32 {
        self.y
    }
}

/// The test in the listing's names, if it compares at all.
fn test(compare: CompareFunction) -> Option<&'static str> {
    Some(match compare {
        CompareFunction::Less => "new < stored",
        CompareFunction::Equal => "new = stored",
        CompareFunction::LessEqual => "new ≤ stored",
        CompareFunction::Greater => "new > stored",
        CompareFunction::NotEqual => "new ≠ stored",
        CompareFunction::GreaterEqual => "new ≥ stored",
        CompareFunction::Never | CompareFunction::Always => return None,
    })
}
