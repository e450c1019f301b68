//! What the lab shows of a z-buffer run.

use super::{Event, Image, Settings, Triangle};
use crate::{
    depth::{CompareFunction, DepthFormat},
    explain::{Explain, Formula, Label, Level, Mark, Marker, Piece, Role, Row, Table, View},
    message::{Message, Value},
    raster::view::view_of,
    replay::State,
};
use std::sync::Arc;

/// Images up to this many pixels show empty pixels with their clear value.
const SHOWS_CLEAR: usize = 1024;

/// A fragment on its way through the test.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fragment {
    x: u32,
    z: f32,
    code: u32,
    /// The code and the owner that its pixel held.
    stored: u32,
    owner: Option<u32>,
    /// The verdict.
    passed: Option<bool>,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Debug, PartialEq)]
pub struct Snapshot {
    triangles: Arc<[Triangle]>,
    settings: Settings,
    image: Image,
    /// The triangle being drawn, or the last one.
    triangle: Option<u32>,
    y: u32,
    fragment: Option<Fragment>,
    /// Pixels that the triangle was tested at, and the verdicts.
    verdicts: Vec<([u16; 2], bool)>,
    /// Passed and failed fragments of each triangle begun.
    counts: Vec<[u32; 2]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(triangles: &[Triangle], settings: Settings) -> Self {
        Self {
            triangles: triangles.into(),
            settings,
            image: settings.empty(),
            triangle: None,
            y: 0,
            fragment: None,
            verdicts: Vec::new(),
            counts: Vec::new(),
        }
    }

    /// What has been drawn so far.
    pub fn result(&self) -> &Image {
        &self.image
    }

    fn verdict(&mut self, passed: bool) {
        let Some(fragment) = &mut self.fragment else { return };
        fragment.passed = Some(passed);
        self.verdicts.push(([fragment.x as u16, self.y as u16], passed));
        if let Some([passes, fails]) = self.counts.last_mut() {
            *(if passed { passes } else { fails }) += 1;
        }
    }

    fn depth(&self, code: u32) -> Value {
        match self.settings.format {
            DepthFormat::F32 => f32::from_bits(code).into(),
            format => format.decode(code).into(),
        }
    }

    /// The letter of the triangle being drawn.
    fn name(&self) -> Value {
        object_name(self.triangle)
    }
}

/// A, B, C, ... as on the canvas; a number behind Z; a dash for what is empty.
fn object_name(triangle: Option<u32>) -> Value {
    match triangle {
        None => Value::None,
        Some(index @ 0..26) => Value::text(char::from(b'A' + index as u8)),
        Some(index) => Value::from(index),
    }
}

impl Clone for Snapshot {
    fn clone(&self) -> Self {
        Self {
            triangles: Arc::clone(&self.triangles),
            image: self.image.clone(),
            verdicts: self.verdicts.clone(),
            counts: self.counts.clone(),
            ..*self
        }
    }

    /// Into the memory that is there: a seek starts with this.
    fn clone_from(&mut self, from: &Self) {
        self.image.clone_from(&from.image);
        self.verdicts.clone_from(&from.verdicts);
        self.counts.clone_from(&from.counts);
        let Self { settings, triangle, y, fragment, .. } = *from;
        (self.settings, self.triangle, self.y, self.fragment) = (settings, triangle, y, fragment);
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Triangle { index } => {
                self.triangle = Some(index);
                self.fragment = None;
                self.verdicts.clear();
                self.counts.push([0, 0]);
            }
            Event::Row { y, .. } => (self.y, self.fragment) = (y, None),
            Event::Fragment { x, z, code, stored } => {
                let x = u32::from(x);
                let owner = self.image.owner([x, self.y]);
                self.fragment = Some(Fragment { x, z, code, stored, owner, passed: None });
            }
            Event::Pass => {
                self.verdict(true);
                if let (Some(Fragment { x, code, .. }), Some(triangle)) = (self.fragment, self.triangle) {
                    let state = self.settings.state;
                    if state.test && state.write {
                        self.image.depth.set([x, self.y], code);
                    }
                    self.image.show([x, self.y], triangle);
                }
            }
            Event::Fail => self.verdict(false),
            Event::Done { .. } => self.fragment = None,
        }
    }

    fn size_hint(&self) -> usize {
        let pixel = 2 * size_of::<u32>() + size_of::<([u16; 2], bool)>();
        size_of::<Self>()
            + self.image.depth.codes().len() * pixel
            + self.triangles.len() * size_of::<[u32; 2]>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "z-buffer";

    const LISTING: &'static [&'static str] = &[
        "for each triangle T",
        "  for each row of its pixels",
        "    for each pixel: new ← code of T's depth there",
        "      if new passes against stored: stored ← new, colour ← T",
        "      else: keep what is there",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Triangle { .. } | Event::Done { .. } => 0,
            Event::Row { .. } => 1,
            Event::Fragment { .. } => 2,
            Event::Pass => 3,
            Event::Fail => 4,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done { .. } => Level::Primitive,
            Event::Row { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Triangle { .. } => (Role::Neutral, Some("z-buffer-marker-triangle")),
            Event::Pass => (Role::Accepted, None),
            Event::Fail => (Role::Rejected, None),
            _ => return None,
        };
        Some(Marker { role, label })
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
            Event::Fragment { .. } | Event::Pass | Event::Fail => {
                let Some(fragment) = self.fragment else { return message("z-buffer-triangle") };
                message(self.sentence_id(event, &fragment))
                    .with("x", fragment.x)
                    .with("y", self.y)
                    .with("new", self.depth(fragment.code))
                    .with("stored", self.depth(fragment.stored))
                    .with("sign", Value::text(self.settings.state.compare.sign()))
                    .with("before", object_name(fragment.owner))
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
            Event::Fragment { .. } => out.extend(self.code_formula(&fragment)),
            Event::Pass | Event::Fail if self.settings.state.test => {
                let Some((general, sign)) = comparison(self.settings.state.compare) else { return };
                let [new, stored] = [fragment.code, fragment.stored].map(|code| self.depth(code));
                let numbers = vec![Piece::Result(new), Piece::Text(sign), Piece::Number(stored)];
                out.push(Formula { general, numbers });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.test_table());
        if let (Some(_), Some(fragment)) = (self.settings.format.max_code(), self.fragment) {
            let width = self.settings.format.bits();
            let bits = |code| vec![Value::Bits { bits: code, width }];
            let rows = vec![
                Row::new("stored", bits(fragment.stored)),
                Row::new("stored′", bits(self.image.depth.code([fragment.x, self.y]))),
            ];
            out.push(Table { title: "z-buffer-bits", columns: vec!["column-bits"], rows });
        }
        let rows = self.counts.iter().zip(0..).map(|([passed, failed], index)| {
            let name = match object_name(Some(index)) {
                Value::Text(name) => name,
                _ => index.to_string(),
            };
            Row::new(name, vec![(passed + failed).into(), (*passed).into(), (*failed).into()])
                .active(self.triangle == Some(index))
        });
        out.push(Table {
            title: "z-buffer-counts",
            columns: vec!["column-fragments", "column-passed", "column-failed"],
            rows: rows.collect(),
        });
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        self.mark_cells(out);
        for (triangle, index) in self.triangles.iter().zip(0..) {
            let points = triangle.map(|[x, y, _]| [x, y]);
            let role = if self.triangle == Some(index) { Role::Neutral } else { Role::Candidate };
            out.push(Mark::Polygon { points: points.to_vec(), role, object: None, label: None });
            let label = Some(Label::new("", object_name(Some(index))));
            out.push(Mark::Point { at: points[0], role: Role::Neutral, label });
        }
        if let Some(fragment) = self.fragment {
            out.push(self.cell([fragment.x, self.y], Role::Active));
        }
    }

    fn view(&self) -> View {
        let points: Vec<_> = self.triangles.iter().map(|triangle| triangle.map(|[x, y, _]| [x, y])).collect();
        view_of(&points, &self.settings.raster)
    }
}

impl Snapshot {
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
            Piece::Result(fragment.code.into()),
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
        let Some(fragment) = self.fragment else {
            return Table { title: "z-buffer-test", columns, rows: Vec::new() };
        };
        let pixel = [fragment.x, self.y];
        let row = |name: &str, owner: Option<u32>, code: u32| {
            let mut cells = vec![object_name(owner), self.depth(code)];
            if unorm {
                cells.push(code.into());
            }
            cells.push(Value::Code { code, width: format.bits() });
            Row::new(name, cells)
        };
        let verdict = match fragment.passed {
            None => Role::Candidate,
            Some(true) => Role::Accepted,
            Some(false) => Role::Rejected,
        };
        let rows = vec![
            row("stored", fragment.owner, fragment.stored),
            row("new", self.triangle, fragment.code).role(verdict),
            row("stored′", self.image.owner(pixel), self.image.depth.code(pixel)).active(true),
        ];
        Table { title: "z-buffer-test", columns, rows }
    }

    fn cell(&self, pixel: [u32; 2], role: Role) -> Mark {
        let value = match self.depth(self.image.depth.code(pixel)) {
            Value::F64(depth) => Value::F32(depth as f32),
            other => other,
        };
        let object = self.image.owner(pixel).map(|owner| owner as usize);
        Mark::Pixel { at: pixel.map(|n| n as i32), role, object, value }
    }

    /// What every pixel holds; a tick or a cross where the triangle was tested.
    fn mark_cells(&self, out: &mut Vec<Mark>) {
        let [width, height] = self.settings.raster.size;
        let shows_clear = self.image.depth.codes().len() <= SHOWS_CLEAR;
        for y in 0..height {
            for x in 0..width {
                let owned = self.image.owner([x, y]).is_some();
                if owned || shows_clear {
                    out.push(self.cell([x, y], if owned { Role::Neutral } else { Role::Candidate }));
                }
            }
        }
        for &([x, y], passed) in &self.verdicts {
            let role = if passed { Role::Accepted } else { Role::Rejected };
            out.push(self.cell([x, y].map(u32::from), role));
        }
    }
}

/// The test in the listing's names, and its sign between two numbers.
fn comparison(compare: CompareFunction) -> Option<(&'static str, &'static str)> {
    Some(match compare {
        CompareFunction::Less => ("new < stored", " < "),
        CompareFunction::Equal => ("new = stored", " = "),
        CompareFunction::LessEqual => ("new ≤ stored", " ≤ "),
        CompareFunction::Greater => ("new > stored", " > "),
        CompareFunction::NotEqual => ("new ≠ stored", " ≠ "),
        CompareFunction::GreaterEqual => ("new ≥ stored", " ≥ "),
        CompareFunction::Never | CompareFunction::Always => return None,
    })
}
