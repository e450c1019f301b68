//! What the lab shows of a diamond-exit run.

use super::{
    super::{Pixel, Segment, picture},
    Event,
};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
    replay::State,
};

/// With more columns than this, the diamonds that are done are not drawn.
const MOST_DIAMONDS: usize = 64;

/// How a column, or a row if the walk is along y, ended.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    StartsBeyond,
    EndsBefore,
    OffImage,
    EndsInside,
    Leaves,
}

impl Verdict {
    fn word(self) -> &'static str {
        match self {
            Self::StartsBeyond => "diamond-exit-verdict-starts-beyond",
            Self::EndsBefore => "diamond-exit-verdict-ends-before",
            Self::OffImage => "diamond-exit-verdict-off-image",
            Self::EndsInside => "diamond-exit-verdict-ends-inside",
            Self::Leaves => "diamond-exit-verdict-leaves",
        }
    }
}

/// One column, or one row.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Column {
    at: u32,
    crossing: Option<f64>,
    pixel: Option<[u32; 2]>,
    verdict: Option<Verdict>,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    ends: Segment,
    size: [u32; 2],
    /// Whether the walk is along x, once known.
    along_x: Option<bool>,
    columns: Vec<Column>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(ends: Segment, size: [u32; 2]) -> Self {
        Self { ends, size, along_x: None, columns: Vec::new() }
    }

    /// The pixels drawn so far.
    pub fn pixels(&self) -> Vec<[u32; 2]> {
        let drawn = self.columns.iter().filter(|column| column.verdict == Some(Verdict::Leaves));
        drawn.filter_map(|column| column.pixel).collect()
    }

    fn is_along_x(&self) -> bool {
        self.along_x.unwrap_or(true)
    }

    /// The name of the axis across the walk.
    fn across(&self) -> &'static str {
        if self.is_along_x() { "y" } else { "x" }
    }

    fn last(&self) -> Option<&Column> {
        self.columns.last()
    }

    fn say_column(&self, id: [&'static str; 2]) -> Message {
        let message = Message::new(id[usize::from(!self.is_along_x())]);
        let at = self.last().map(|column| column.at);
        message.with("at", at).with("centre", at.map(|at| at as f32 + 0.5))
    }

    fn say_pixel(&self, id: &'static str) -> Message {
        let [x, y] = self.last().and_then(|column| column.pixel).unwrap_or_default();
        Message::new(id).with("x", x).with("y", y)
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Start { along_x } => self.along_x = Some(along_x),
            Event::Next { at } => {
                self.columns.push(Column { at, crossing: None, pixel: None, verdict: None });
            }
            _ => {}
        }
        let Some(column) = self.columns.last_mut() else { return };
        match *event {
            Event::Crossing { at } => column.crossing = Some(at),
            Event::Candidate { x, y, .. } => column.pixel = Some([x, y]),
            Event::StartsBeyond { in_diamond: false } => column.verdict = Some(Verdict::StartsBeyond),
            Event::EndsBefore => column.verdict = Some(Verdict::EndsBefore),
            Event::OffImage => column.verdict = Some(Verdict::OffImage),
            Event::EndsInside => column.verdict = Some(Verdict::EndsInside),
            Event::Leaves => column.verdict = Some(Verdict::Leaves),
            _ => {}
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.columns.len() * size_of::<Column>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "diamond-exit";

    const LISTING: &'static [&'static str] = &[
        "if |dx| ≥ |dy|: walk along x, by columns; else along y, by rows",
        "for each column that the line touches",
        "  starts beyond its centre line: the start's own diamond, if any",
        "  ends before its centre line: no diamond is left",
        "  else c ← where the line crosses the centre line",
        "  the pixel whose diamond holds c",
        "  off the image: nothing to draw",
        "  the line ends in this diamond: not drawn",
        "  the line leaves it: draw the pixel",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Start { .. } => 0,
            Event::Next { .. } | Event::Done => 1,
            Event::StartsBeyond { .. } => 2,
            Event::EndsBefore => 3,
            Event::Crossing { .. } => 4,
            Event::Candidate { .. } => 5,
            Event::OffImage => 6,
            Event::EndsInside => 7,
            Event::Leaves => 8,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // The slope, once.
            Event::Start { .. } => Operations::new(1, 0, 1),
            // Both ends against the centre line.
            Event::Next { .. } => Operations::new(2, 0, 0),
            Event::Crossing { .. } => Operations::new(0, 1, 0),
            Event::StartsBeyond { .. } | Event::EndsInside | Event::Leaves | Event::OffImage => {
                Operations::new(1, 0, 0)
            }
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::EndsBefore
            | Event::StartsBeyond { in_diamond: false }
            | Event::OffImage
            | Event::EndsInside
            | Event::Leaves => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let role = match event {
            Event::Leaves => Role::Neutral,
            Event::EndsInside | Event::EndsBefore | Event::StartsBeyond { in_diamond: false } => {
                Role::Rejected
            }
            _ => return None,
        };
        Some(Marker { role, label: None })
    }

    fn opening(&self) -> Message {
        Message::new("diamond-exit-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Start { along_x: true } => Message::new("diamond-exit-along-x"),
            Event::Start { along_x: false } => Message::new("diamond-exit-along-y"),
            Event::Next { .. } => self.say_column(["diamond-exit-column", "diamond-exit-row"]),
            Event::Crossing { at } => {
                Message::new("diamond-exit-crossing").with("axis", Value::text(self.across())).with("at", at)
            }
            Event::StartsBeyond { in_diamond: true } => Message::new("diamond-exit-starts-in-diamond"),
            Event::StartsBeyond { in_diamond: false } => Message::new("diamond-exit-starts-beyond"),
            Event::EndsBefore => Message::new("diamond-exit-ends-before"),
            Event::Candidate { corrected: true, .. } => self.say_pixel("diamond-exit-corrected"),
            Event::Candidate { .. } => self.say_pixel("diamond-exit-candidate"),
            Event::OffImage => Message::new("diamond-exit-off-image"),
            Event::EndsInside => self.say_pixel("diamond-exit-ends-inside"),
            Event::Leaves => self.say_pixel("diamond-exit-leaves"),
            Event::Done => Message::new("diamond-exit-done").with("count", self.pixels().len()),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let minor = usize::from(self.is_along_x());
        let major = 1 - minor;
        let [a, b] = self.ends;
        let number = |x: f32| Piece::Number(x.into());
        match *event {
            Event::Crossing { at } => {
                let centre = self.last().map(|column| column.at as f32 + 0.5);
                let slope = f64::from(b[minor]) - f64::from(a[minor]);
                let slope = slope / (f64::from(b[major]) - f64::from(a[major])) + 0.0;
                let numbers = vec![
                    Piece::Text("= "),
                    number(a[minor]),
                    Piece::Text(" + ("),
                    Piece::Number(centre.into()),
                    Piece::Text(" − "),
                    number(a[major]),
                    Piece::Text(") · "),
                    Piece::Number(slope.into()),
                    Piece::Text(" = "),
                    Piece::Result(at.into()),
                ];
                let general = match minor {
                    1 => "c = y1 + (x − x1) · dy/dx",
                    _ => "c = x1 + (y − y1) · dx/dy",
                };
                out.push(Formula { general, numbers });
            }
            Event::EndsInside | Event::Leaves => {
                let Some(pixel) = self.last().and_then(|column| column.pixel) else { return };
                let centre = pixel.map(|n| n as f32 + 0.5);
                let distance: f64 =
                    [0, 1].map(|axis| (f64::from(b[axis]) - f64::from(centre[axis])).abs()).iter().sum();
                let numbers = vec![
                    Piece::Text("= |"),
                    number(b[0]),
                    Piece::Text(" − "),
                    number(centre[0]),
                    Piece::Text("| + |"),
                    number(b[1]),
                    Piece::Text(" − "),
                    number(centre[1]),
                    Piece::Text("| = "),
                    Piece::Result(distance.into()),
                ];
                out.push(Formula { general: "distance = |x2 − cx| + |y2 − cy|", numbers });
            }
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let last = self.columns.len().checked_sub(1);
        let row = |(index, column): (usize, &Column)| {
            let [x, y] = [0, 1].map(|axis| Value::from(column.pixel.map(|pixel| pixel[axis])));
            let verdict = column.verdict.map_or(Value::BLANK, |verdict| Value::Word(verdict.word()));
            let role = column.verdict.map(|verdict| match verdict {
                Verdict::Leaves => Role::Accepted,
                _ => Role::Rejected,
            });
            Row::new(column.at.to_string(), vec![column.crossing.into(), x, y, verdict])
                .active(last == Some(index))
                .role(role)
        };
        let rows = self.columns.iter().enumerate().map(row).collect();
        let title = if self.is_along_x() { "diamond-exit-columns" } else { "diamond-exit-rows" };
        out.push(Table { title, columns: vec!["c", "x", "y", "column-verdict"], rows });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        let signed = |pixel: [u32; 2]| pixel.map(|n| n as i32);
        let drawn: Vec<Pixel> = self.pixels().into_iter().map(signed).collect();
        out.extend(drawn.iter().map(|&at| picture::pixel(at, Role::Accepted, Some(0))));
        if self.columns.len() <= MOST_DIAMONDS {
            let done = self.columns.iter().filter(|column| column.verdict.is_some());
            out.extend(done.filter_map(|column| column.pixel).map(|pixel| diamond(pixel, Role::Neutral)));
        }
        picture::line(self.ends, self.ends, out);
        let Some(column) = self.last().filter(|_| !matches!(event, None | Some(Event::Done))) else { return };
        let (axis, centre) = (u8::from(!self.is_along_x()), column.at as f32 + 0.5);
        out.push(Mark::Guide { axis, at: centre, role: Role::Active, label: None, note: None });
        if let Some(pixel) = column.pixel {
            let role = match column.verdict {
                None | Some(Verdict::Leaves) => Role::Active,
                Some(_) => Role::Rejected,
            };
            out.push(diamond(pixel, role));
        }
        if let Some(crossing) = column.crossing.map(|at| at as f32).filter(|at| at.is_finite()) {
            let at = if self.is_along_x() { [centre, crossing] } else { [crossing, centre] };
            out.push(Mark::Point { at, role: Role::Active, label: Some(Label::new("c", crossing)) });
        }
    }

    fn view(&self) -> View {
        picture::view(self.ends, self.size)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        out.extend(self.pixels().into_iter().map(|pixel| Fact::pixel(pixel, Vec::new())));
    }
}

/// The outline of a pixel's diamond.
fn diamond(pixel: [u32; 2], role: Role) -> Mark {
    let [x, y] = pixel.map(|n| n as f32);
    let points = vec![[x + 0.5, y], [x + 1.0, y + 0.5], [x + 0.5, y + 1.0], [x, y + 0.5]];
    Mark::Polygon { points, role, object: None, label: None }
}
