//! What the lab shows of homogeneous rasterization.

use super::{Adjugate, Event, Vertex, area, form::Form, is_exact, rasterized};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, PixelReport, Role, Row, Table, View},
    math::{Arithmetic, Sign, Tally, orient3d_homogeneous},
    message::{Message, Value},
    raster::{
        Settings, Span,
        report::verdict,
        traversal::{self, cells::Cells, probe::Says},
        view::view_of,
    },
    replay::State,
};

/// The edges by name; the near plane is the fourth.
pub(super) const NAMES: [&str; 4] = ["E0", "E1", "E2", "N"];

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) given: [Vertex; 3],
    /// As rasterized.
    pub(super) vertices: [Vertex; 3],
    pub(super) near: Option<f32>,
    pub(super) settings: Settings,
    /// Exact, whatever the arithmetic.
    pub(super) turned: Sign,
    /// Coefficients of the edges, the sum and the near plane, once computed.
    pub(super) rows: [[Option<f64>; 3]; 5],
    pub(super) determinant: Option<f64>,
    pub(super) cells: Cells,
    /// Centres tested, drawn, and left out behind the triangle.
    counts: [u32; 3],
    pub(super) now: Option<[u16; 2]>,
}

/// Rows of the coefficients behind the three edges.
pub(super) const SUM: usize = 3;
pub(super) const NEAR_ROW: usize = 4;

impl Snapshot {
    /// Before the first event.
    pub fn new(given: [Vertex; 3], near: Option<f32>, settings: Settings) -> Self {
        let vertices = rasterized(given, &settings);
        let [a, b, c] = vertices;
        Self {
            given,
            vertices,
            near,
            settings,
            turned: orient3d_homogeneous(a, b, c, &mut Tally::default()),
            rows: [[None; 3]; 5],
            determinant: None,
            cells: Cells::default(),
            counts: [0; 3],
            now: None,
        }
    }

    /// The spans found so far, sorted by row.
    pub fn result(&self) -> Vec<Span> {
        self.cells.spans()
    }

    /// What each edge says of a centre, the near plane last; nothing of a triangle without area.
    pub(super) fn says(&self, at: [u32; 2]) -> Vec<Says> {
        let Self { vertices, near, turned, ref settings, .. } = *self;
        if turned.is_zero() {
            return Vec::new();
        }
        if settings.arithmetic == Arithmetic::F32 {
            let adjugate = Adjugate::<f32>::new(vertices).turned(turned);
            super::form::says(&Form::new((vertices, near), turned, adjugate, settings), false, at)
        } else {
            let adjugate = Adjugate::<f64>::new(vertices).turned(turned);
            let form = Form::new((vertices, near), turned, adjugate, settings);
            super::form::says(&form, is_exact(settings), at)
        }
    }

    /// The name of an edge by its ends, such as `V1V2`; none for the near plane.
    pub(super) fn ends_of(edge: usize) -> &'static str {
        ["V1V2", "V2V0", "V0V1", "w"][edge]
    }

    fn test_sentence(&self, at: [u16; 2], keeps_out: u8) -> Message {
        let [x, y] = at.map(u32::from);
        let about = |id| Message::new(id).with("x", x).with("y", y);
        let named = |id, edge: usize| {
            about(id).with("edge", Value::text(NAMES[edge])).with("ends", Value::text(Self::ends_of(edge)))
        };
        let says = self.says([x, y]);
        let out = says.iter().position(|says| !says.draws && !says.tie);
        match (out, says.iter().position(|says| says.tie)) {
            (Some(super::form::NEAR), _) => about("homogeneous-test-near"),
            (Some(edge), _) => named("traversal-test-out", edge),
            (None, Some(edge)) if keeps_out != 0 => named("traversal-test-tie-lost", edge),
            (None, Some(edge)) => named("traversal-test-tie-drawn", edge),
            (None, None) => about("homogeneous-test-in"),
        }
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Coefficient { edge, term, value } => {
                self.rows[usize::from(edge)][usize::from(term)] = Some(value);
            }
            Event::Determinant { value } => self.determinant = Some(value),
            Event::Turned => {
                let edges = self.rows.iter_mut().flatten().flatten();
                edges.chain(&mut self.determinant).for_each(|value| *value = 0.0 - *value);
            }
            Event::InverseW { term, value } => self.rows[SUM][usize::from(term)] = Some(value),
            Event::Near { term, value } => self.rows[NEAR_ROW][usize::from(term)] = Some(value),
            Event::Box { columns, rows, .. } => self.cells.apply(&traversal::Event::Box { columns, rows }),
            Event::Walk { event, .. } => {
                match event {
                    traversal::Event::Test { x, y, keeps_out } => {
                        self.counts[0] += 1;
                        self.counts[1] += u32::from(keeps_out == 0);
                        self.now = Some([x, y]);
                    }
                    traversal::Event::Skip { centres } => self.counts[2] += u32::from(centres),
                    _ => self.now = None,
                }
                self.cells.apply(&event);
            }
            Event::Done => self.now = None,
            Event::ZeroArea => {}
        }
    }

    fn size_hint(&self) -> usize {
        let area = area(self.vertices, &self.settings);
        size_of::<Self>() + Cells::size_hint(area.columns.len() as f64, area.rows.len() as f64)
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "homogeneous";

    const PREFIX: &'static str = "";

    const LISTING: &'static [&'static str] = &[
        "for each edge: a, b, c ← cross product of its two ends (x, y, w)",
        "det ← V0 · (a, b, c) of E0",
        "if det is 0: draw nothing; stop",
        "if det < 0: turn every sign",
        "a, b, c of det/w ← sums over E0, E1, E2",
        "a, b, c of N ← (0, 0, det) − near · those of det/w",
        "box ← around x/w, y/w; a w ≤ 0: the whole image",
        "for each row y of the box",
        "  for each column x: draw it if E0, E1, E2, N let it in",
        "  behind the last pixel: skip the rest of the row",
        "no row is left: stop",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Coefficient { .. } => 0,
            Event::Determinant { .. } => 1,
            Event::ZeroArea => 2,
            Event::Turned => 3,
            Event::InverseW { .. } => 4,
            Event::Near { .. } => 5,
            Event::Box { .. } => 6,
            Event::Walk { event: traversal::Event::Test { .. }, .. } => 8,
            Event::Walk { event: traversal::Event::Skip { .. }, .. } => 9,
            Event::Walk { .. } => 7,
            Event::Done => 10,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done | Event::ZeroArea => Level::Primitive,
            Event::Walk { event: traversal::Event::Row { .. }, .. }
            | Event::Coefficient { term: 2, .. }
            | Event::InverseW { term: 2, .. }
            | Event::Near { term: 2, .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Coefficient { .. } => Operations::new(0, 2, 0),
            Event::Determinant { .. } => Operations::new(1, 3, 0),
            Event::Near { .. } => Operations::new(0, 1, 0),
            Event::Box { whole: true, .. } => Operations::new(3, 0, 0),
            // The signs of w, six quotients, and the least and greatest of them.
            Event::Box { whole: false, .. } => Operations::new(11, 0, 6),
            Event::Walk { event: traversal::Event::Test { .. }, near: false } => Operations::new(3, 6, 0),
            Event::Walk { event: traversal::Event::Test { .. }, near: true } => Operations::new(4, 8, 0),
            _ => Operations::NONE,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::ZeroArea => (Role::Skipped, Some("traversal-marker-zero-area")),
            Event::Determinant { .. } => (Role::Accepted, Some("homogeneous-marker-adjugate")),
            Event::Walk { event: traversal::Event::Row { .. }, .. } => (Role::Neutral, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("homogeneous-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let term = |term: u8| Value::text(["a", "b", "c"][usize::from(term)]);
        match *event {
            Event::Coefficient { edge, term: which, value } => Message::new("homogeneous-coefficient")
                .with("edge", Value::text(NAMES[usize::from(edge)]))
                .with("ends", Value::text(Self::ends_of(usize::from(edge))))
                .with("term", term(which))
                .with("value", value),
            Event::Determinant { value } => Message::new("homogeneous-determinant").with("value", value),
            Event::ZeroArea => Message::new("homogeneous-zero-area"),
            Event::Turned => Message::new("homogeneous-turned"),
            Event::InverseW { term: which, value } => {
                Message::new("homogeneous-inverse-w").with("term", term(which)).with("value", value)
            }
            Event::Near { term: which, value } => Message::new("homogeneous-near")
                .with("term", term(which))
                .with("value", value)
                .with("near", self.near),
            Event::Box { columns: [left, right], rows: [top, bottom], whole } => {
                let id = if whole { "homogeneous-box-whole" } else { "traversal-box" };
                Message::new(id)
                    .with("count", self.cells.len())
                    .with("left", u32::from(left))
                    .with("right", u32::from(right.saturating_sub(1)))
                    .with("top", u32::from(top))
                    .with("bottom", u32::from(bottom.saturating_sub(1)))
            }
            Event::Walk { event: traversal::Event::Test { x, y, keeps_out }, .. } => {
                self.test_sentence([x, y], keeps_out)
            }
            Event::Walk { event: traversal::Event::Skip { centres }, .. } => {
                Message::new("traversal-skip").with("count", u32::from(centres))
            }
            Event::Walk { event: traversal::Event::Row { y }, .. } => {
                Message::new("traversal-row").with("y", u32::from(y))
            }
            Event::Walk { .. } | Event::Done => {
                let [tested, drawn, _] = self.counts;
                Message::new("traversal-done").with("tested", tested).with("count", drawn)
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        self.formulas_of(event, out);
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let names = NAMES[..3].iter().chain(&["det/w", "N"]);
        let mut rows: Vec<Row> =
            names.zip(self.rows).map(|(name, row)| Row::new(*name, row.map(Value::from).to_vec())).collect();
        rows.truncate(if self.near.is_some() { 5 } else { 4 });
        rows.push(Row::new("det", vec![Value::BLANK, Value::BLANK, self.determinant.into()]));
        out.push(Table { title: "homogeneous-coefficients", columns: vec!["a", "b", "c"], rows });
        let says = self.now.map_or_else(Vec::new, |at| self.says(at.map(u32::from)));
        let mut rows: Vec<Row> = says
            .iter()
            .zip(NAMES)
            .map(|(says, name)| {
                let role = match (says.tie, says.draws) {
                    (true, _) => Some(Role::Tie),
                    (false, true) => None,
                    (false, false) => Some(Role::Rejected),
                };
                Row::new(name, vec![says.value.into(), verdict(*says)]).role(role)
            })
            .collect();
        if let [e0, e1, e2, ..] = says[..] {
            let sum = e0.value + e1.value + e2.value;
            let determinant = self.determinant.unwrap_or(1.0);
            rows.push(Row::new("1/w", vec![(sum / determinant).into(), Value::BLANK]));
        }
        out.push(Table {
            title: "homogeneous-at",
            columns: vec!["column-traversal-value", "column-traversal-verdict"],
            rows,
        });
        let [tested, drawn, skipped] = self.counts;
        let count = |name: &str, count: u32| Row::new(name, vec![count.into()]);
        let rows = vec![
            count("row-traversal-box", self.cells.len() as u32),
            count("row-traversal-tested", tested),
            count("row-traversal-drawn", drawn),
            count("row-traversal-wasted", tested - drawn),
            count("row-traversal-skipped", skipped),
        ];
        out.push(Table { title: "traversal-counts", columns: vec!["column-traversal-centres"], rows });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        let on_screen = self.vertices.map(super::marks::projected);
        match on_screen {
            [Some(a), Some(b), Some(c)] if super::all_in_front(self.vertices) => {
                view_of(&[[a, b, c]], &self.settings)
            }
            _ => {
                let [width, height] = self.settings.size.map(|n| n as f32);
                view_of(&[[[0.0, 0.0], [width, 0.0], [0.0, height]]], &self.settings)
            }
        }
    }

    fn pixel(&self, at: [u32; 2]) -> Option<PixelReport> {
        self.report(at)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for Span { y, begin, end } in self.result() {
            out.extend((begin..end).map(|x| Fact::pixel([x, y], Vec::new())));
        }
    }
}
