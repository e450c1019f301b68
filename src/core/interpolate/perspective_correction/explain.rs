//! What the lab shows of a checkered parallelogram.

use super::{Event, Subject, Texel, draw};
use crate::{
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Table, View},
    interpolate::Mode,
    message::{Message, Value},
    raster::{Settings, YAxis},
    replay::State,
};
use std::sync::Arc;

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) mode: Mode,
    pub(super) subject: Subject,
    pub(super) settings: Settings,
    pub(super) texels: Vec<Texel>,
    /// The same pixels in the other mode.
    pub(super) others: Arc<[Texel]>,
    pub(super) triangle: Option<u8>,
    y: u32,
    /// The pixel in hand, not looked up yet.
    pub(super) pixel: Option<([u32; 2], [f32; 2])>,
    /// Whether the pixels are done.
    pub(super) in_line: bool,
    /// Depth and 1/w along the line, as far as it has come.
    pub(super) along: Vec<[f32; 2]>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(mode: Mode, subject: Subject, settings: Settings) -> Self {
        let other = if mode == Mode::Affine { Mode::Perspective } else { Mode::Affine };
        Self {
            mode,
            subject,
            settings,
            texels: Vec::new(),
            others: draw(other, &subject, &settings).into(),
            triangle: None,
            y: 0,
            pixel: None,
            in_line: false,
            along: Vec::new(),
        }
    }

    /// The pixels drawn so far.
    pub fn result(&self) -> Vec<Texel> {
        self.texels.clone()
    }

    /// How many pixels so far show another square than in the other mode.
    pub(super) fn differing(&self) -> usize {
        self.texels.iter().zip(&*self.others).filter(|(a, b)| a.light != b.light).count()
    }
}

/// The word for a square.
pub(super) fn word(light: bool) -> &'static str {
    if light { "word-light" } else { "word-dark" }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Triangle { index } => (self.triangle, self.pixel) = (Some(index), None),
            Event::Row { y, .. } => (self.y, self.pixel) = (y, None),
            Event::Pixel { x, u, v, .. } => self.pixel = Some(([x.into(), self.y], [u, v])),
            Event::Texel { light } => {
                if let Some((pixel, uv)) = self.pixel {
                    self.texels.push(Texel { pixel, uv, light });
                }
            }
            Event::Line => (self.in_line, self.pixel, self.triangle) = (true, None, None),
            Event::Along { z, r, .. } => self.along.push([z, r]),
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + self.others.len() * size_of::<Texel>()
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "perspective-correction";

    const LISTING: &'static [&'static str] = &[
        "for each triangle of the square",
        "  for each row of its pixels",
        "    affine: u ← l0 u0 + l1 u1 + l2 u2; v likewise",
        "    perspective: u ← (u/w) / (1/w); v likewise",
        "    light if ⌊n u⌋ + ⌊n v⌋ is even",
        "along the line from L0 to L1, t from 0 to 1",
        "  z ← (1 − t) z0 + t z1, 1/w likewise; d ← 1 / (1/w)",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Triangle { .. } => 0,
            Event::Row { .. } => 1,
            Event::Pixel { mode: Mode::Affine, .. } => 2,
            Event::Pixel { mode: Mode::Perspective, .. } => 3,
            Event::Texel { .. } => 4,
            Event::Line => 5,
            Event::Along { .. } => 6,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Pixel { mode: Mode::Affine, .. } => Operations::new(0, 6, 0),
            // Three sums, one division, and the quotients by its result.
            Event::Pixel { mode: Mode::Perspective, .. } => Operations::new(0, 11, 1),
            Event::Texel { .. } => Operations::new(0, 2, 0),
            Event::Along { .. } => Operations::new(0, 4, 1),
            Event::Triangle { .. } | Event::Row { .. } | Event::Line => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Triangle { .. } | Event::Line => Level::Primitive,
            Event::Row { .. } | Event::Along { .. } => Level::Row,
            Event::Pixel { .. } | Event::Texel { .. } => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let label = match event {
            Event::Triangle { index: 0 } => "perspective-correction-marker-first",
            Event::Triangle { .. } => "perspective-correction-marker-second",
            Event::Line => "perspective-correction-marker-line",
            Event::Texel { .. } => return Some(Marker { role: Role::Accepted, label: None }),
            _ => return None,
        };
        Some(Marker { role: Role::Neutral, label: Some(label) })
    }

    fn opening(&self) -> Message {
        Message::new(match self.mode {
            Mode::Affine => "perspective-correction-opening-affine",
            Mode::Perspective => "perspective-correction-opening-perspective",
        })
    }

    fn sentence(&self, event: &Event) -> Message {
        let pixel = |id| {
            let ([x, y], uv) = self.pixel.unwrap_or_default();
            Message::new(id).with("x", x).with("y", y).with("uv", uv)
        };
        match *event {
            Event::Triangle { index } => {
                Message::new("perspective-correction-triangle").with("number", u32::from(index) + 1)
            }
            Event::Row { y, begin, end } => {
                Message::new("perspective-correction-row").with("y", y).with("count", end - begin)
            }
            Event::Pixel { mode, .. } => pixel(match mode {
                Mode::Affine => "perspective-correction-affine",
                Mode::Perspective => "perspective-correction-perspective",
            }),
            Event::Texel { light } => {
                let other = self.others.get(self.texels.len().wrapping_sub(1));
                let same = other.is_none_or(|other| other.light == light);
                let id = if same { "perspective-correction-texel" } else { "perspective-correction-differs" };
                pixel(id).with("square", Value::Word(word(light)))
            }
            Event::Line => Message::new("perspective-correction-line").with("count", self.differing()),
            Event::Along { z, r, .. } => {
                let t = (self.along.len() as f64 - 1.0) / f64::from(super::STEPS);
                Message::new("perspective-correction-along")
                    .with("t", t)
                    .with("z", z)
                    .with("r", r)
                    .with("d", 1.0 / f64::from(r))
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let (text, number) = (Piece::Text, |value: f32| Piece::Number(value.into()));
        match *event {
            Event::Texel { light } => {
                let Some((_, [u, v])) = self.pixel else { return };
                let n = f64::from(self.subject.squares);
                let [column, row] = [u, v].map(|value| (n * f64::from(value)).floor());
                out.push(Formula {
                    general: "light if ⌊n u⌋ + ⌊n v⌋ is even",
                    numbers: vec![
                        text("⌊"),
                        Piece::Number(self.subject.squares.into()),
                        text(" · "),
                        number(u),
                        text("⌋ + ⌊"),
                        Piece::Number(self.subject.squares.into()),
                        text(" · "),
                        number(v),
                        text("⌋ = "),
                        Piece::Number((column + row).into()),
                        text(": "),
                        Piece::Result(Value::Word(word(light))),
                    ],
                });
            }
            Event::Along { r, .. } => out.push(Formula {
                general: "d = 1 / (1/w)",
                numbers: vec![
                    text("= 1 / "),
                    number(r),
                    text(" = "),
                    Piece::Result((1.0 / f64::from(r)).into()),
                ],
            }),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        self.list(out);
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.draw(event, out);
    }

    fn view(&self) -> View {
        let [width, height] = self.settings.size.map(|n| n as f32);
        let y_up = self.settings.y_axis == YAxis::Up;
        let plot = height * super::picture::PLOT;
        let [low, high] = if y_up { [-plot, height] } else { [0.0, height + plot] };
        View { min: [0.0, low], max: [width, high], y_up, grid: crate::explain::Grid::None }
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        let square = |light: bool| vec![("column-square", Value::Word(word(light)))];
        out.extend(self.texels.iter().map(|texel| Fact::pixel(texel.pixel, square(texel.light))));
    }
}
