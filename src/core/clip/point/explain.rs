//! What the lab shows of clipping a point.

use super::Event;
use crate::{
    clip::line::{
        Border, Outcode, Point, Window,
        subject::{bits, draw_borders, draw_region_codes, draw_window, with_borders},
        view,
    },
    compare::Fact,
    explain::{Explain, Formula, Label, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
    replay::State,
};

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    window: Window,
    point: Point,
    /// The bit of each border, in the order of [`Border::ALL`], once known.
    beyond: [Option<bool>; 4],
    /// `Some(true)` visible, `Some(false)` not, `None` still running.
    visible: Option<bool>,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(point: Point, window: Window) -> Self {
        Self { window, point, beyond: [None; 4], visible: None }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Option<bool> {
        self.visible
    }

    /// The code, once all its bits are known.
    fn code(&self) -> Option<Outcode> {
        let known = self.beyond.iter().all(Option::is_some);
        known.then(|| Outcode::from_bits(self.beyond.map(Option::unwrap_or_default)))
    }

    fn coordinate(&self, border: Border) -> f32 {
        self.point[border.axis()]
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Compare { border, beyond } => self.beyond[border as usize] = Some(beyond),
            Event::Accept => self.visible = Some(true),
            Event::Reject => self.visible = Some(false),
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "point-clipping";

    const LISTING: &'static [&'static str] = &[
        "T ← y > ymax",
        "B ← y < ymin",
        "R ← x > xmax",
        "L ← x < xmin",
        "if T B R L = 0 0 0 0: visible",
        "else: not visible",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Compare { border, .. } => *border as usize,
            Event::Accept => 4,
            Event::Reject => 5,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::Compare { .. } => Operations::new(1, 0, 0),
            Event::Accept | Event::Reject => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Compare { .. } => Level::Detail,
            Event::Accept | Event::Reject => Level::Primitive,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Compare { border, .. } => (Role::Neutral, border.word()),
            Event::Accept => (Role::Accepted, "word-accept"),
            Event::Reject => (Role::Rejected, "word-reject"),
        };
        Some(Marker { role, label: Some(label) })
    }

    fn opening(&self) -> Message {
        Message::new("point-clipping-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Compare { border, beyond } => {
                let on = self.coordinate(border) == self.window.at(border);
                Message::new(match (beyond, on) {
                    (true, _) => "point-clipping-beyond",
                    (false, true) => "point-clipping-on",
                    (false, false) => "point-clipping-within",
                })
                .with("border", Value::Word(border.word()))
                .with("bit", Value::text(border.letter()))
            }
            Event::Accept => Message::new("point-clipping-accept"),
            Event::Reject => {
                with_borders(Message::new("point-clipping-reject"), self.code().unwrap_or_default())
            }
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let Event::Compare { border, beyond } = *event else { return };
        let (general, sign) = match border {
            Border::Top => ("T = y > ymax", " > "),
            Border::Bottom => ("B = y < ymin", " < "),
            Border::Right => ("R = x > xmax", " > "),
            Border::Left => ("L = x < xmin", " < "),
        };
        let numbers = vec![
            Piece::Text("= "),
            Piece::Number(self.coordinate(border).into()),
            Piece::Text(sign),
            Piece::Number(self.window.at(border).into()),
            Piece::Text(" = "),
            Piece::Result(i64::from(beyond).into()),
        ];
        out.push(Formula { general, numbers });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let now = self.beyond.iter().rposition(Option::is_some).filter(|_| self.visible.is_none());
        let rows = Border::ALL.into_iter().map(|border| {
            let bit = self.beyond[border as usize].map(i64::from);
            let cells = vec![self.coordinate(border).into(), self.window.at(border).into(), bit.into()];
            Row::new(border.letter(), cells).active(now == Some(border as usize))
        });
        out.push(Table {
            title: "point-clipping-bits",
            columns: vec!["P", "column-point-clipping-border", "column-point-clipping-bit"],
            rows: rows.collect(),
        });
        let [x, y] = self.point;
        let code = self.code().map_or(Value::None, bits);
        out.push(Table {
            title: "point-clipping-point",
            columns: vec!["x", "y", "T B R L"],
            rows: vec![Row::new("P", vec![x.into(), y.into(), code])],
        });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        draw_window(&self.window.corners(), out);
        let active = match event {
            Some(Event::Compare { border, .. }) => Some(*border),
            _ => None,
        };
        draw_borders(&self.window, active, None, out);
        draw_region_codes(self.view(), &self.window, &[("P", self.code())], out);
        let at = self.point;
        if let Some(border) = active {
            // From the point straight to the border that it is compared with.
            let mut foot = at;
            foot[border.axis()] = self.window.at(border);
            out.push(Mark::Segment { ends: [at, foot], role: Role::Candidate, label: None });
        }
        let role = match self.visible {
            None => Role::Neutral,
            Some(true) => Role::Accepted,
            Some(false) => Role::Rejected,
        };
        out.push(Mark::Point { at, role, label: Some(Label::new("P", at)) });
    }

    fn view(&self) -> View {
        view([self.point], &self.window)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        if let Some(visible) = self.visible {
            out.push(Fact::answer(if visible { "word-accepted" } else { "word-rejected" }));
        }
    }
}
