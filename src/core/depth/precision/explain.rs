//! What the lab shows of the step of depth.

use super::{Event, Line, Snapshot, picture};
use crate::{
    compare::Fact,
    depth::DepthFormat,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Piece, Role, Row, Table, View},
    message::{Message, Value},
};

/// Distances of the table: so many parts of the way from near to far, in equal ratios.
const SAMPLES: u32 = 6;

impl Explain for Snapshot {
    const NAME: &'static str = "depth-precision";

    const LISTING: &'static [&'static str] = &[
        "for each range where steps only grow",
        "  if its last step > gap: search it",
        "  halve: if the middle's step > gap, go nearer",
        "  one code is left: here planes merge first",
        "no step > gap: they never merge",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Range { merges: false, .. } => 0,
            Event::Range { merges: true, .. } => 1,
            Event::Halve { .. } => 2,
            Event::Found { .. } => 3,
            Event::Never => 4,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // The two factors of the denominator, the product with the gap and the numerator's four.
            Event::Range { .. } | Event::Halve { .. } => Operations::new(1, 8, 0),
            Event::Found { .. } | Event::Never => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Found { .. } | Event::Never => Level::Primitive,
            Event::Range { .. } => Level::Row,
            Event::Halve { .. } => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        match event {
            Event::Range { merges: true, .. } => Some(Marker { role: Role::Neutral, label: None }),
            Event::Found { .. } => {
                Some(Marker { role: Role::Accepted, label: Some("depth-precision-marker-found") })
            }
            Event::Never => {
                Some(Marker { role: Role::Rejected, label: Some("depth-precision-marker-never") })
            }
            _ => None,
        }
    }

    fn opening(&self) -> Message {
        let [near, far] = self.line.planes;
        Message::new("depth-precision-opening")
            .with("near", near)
            .with("far", far)
            .with("gap", self.gap)
            .with("format", Value::text(self.line.format.name()))
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, place| {
            let cell = self.line.cell(place);
            let [begin, _] = cell.distances();
            Message::new(id)
                .with("code", Value::text(self.line.code(place)))
                .with("distance", begin)
                .with("step", cell.length())
                .with("gap", self.gap)
        };
        match *event {
            Event::Range { place, merges: true } => about("depth-precision-range", place),
            Event::Range { place, merges: false } => about("depth-precision-range-fine", place),
            Event::Halve { place, merges: true } => about("depth-precision-nearer", place),
            Event::Halve { place, merges: false } => about("depth-precision-farther", place),
            Event::Found { place } => about("depth-precision-found", place),
            Event::Never => Message::new("depth-precision-never").with("gap", self.gap),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let (Event::Range { place, .. } | Event::Halve { place, .. } | Event::Found { place }) = *event
        else {
            return;
        };
        let cell = self.line.cell(place);
        let [begin, end] = cell.distances();
        let number = |x: f64| Piece::Number(x.into());
        let numbers = vec![
            Piece::Text("= "),
            number(end),
            Piece::Text(" − "),
            number(begin),
            Piece::Text(" = "),
            Piece::Result(cell.length().into()),
        ];
        out.push(Formula { general: "step = end − begin of one code", numbers });
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.codes());
        out.push(self.steps());
    }

    fn marks(&self, _event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::mark(self, out);
    }

    fn view(&self) -> View {
        picture::view(self)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        if !self.done {
            return;
        }
        let found = self.found.map(|place| self.line.cell(place));
        let [begin, length] = match &found {
            None => [Value::None, Value::None],
            Some(cell) => [cell.distances()[0].into(), cell.length().into()],
        };
        let values = vec![("column-distance", begin), ("column-step", length)];
        out.push(Fact { values, ..Fact::answer("depth-precision") });
    }
}

impl Snapshot {
    /// The codes between which the search goes on.
    fn codes(&self) -> Table {
        let row = |name: &str, place: Option<u32>| {
            let cell = place.map(|place| self.line.cell(place));
            let code = Value::from(place.map(|place| Value::text(self.line.code(place))));
            let begin = Value::from(cell.as_ref().map(|cell| cell.distances()[0]));
            let step = Value::from(cell.as_ref().map(super::Cell::length));
            Row::new(name, vec![code, begin, step])
        };
        let verdict = self.look.map(|look| if look.merges { Role::Accepted } else { Role::Rejected });
        let rows = vec![
            row("row-first", self.left.map(|[first, _]| first)),
            row("row-looked-at", self.look.map(|look| look.place)).active(self.look.is_some()).role(verdict),
            row("row-last", self.left.map(|[_, last]| last)),
        ];
        let columns = vec!["column-code", "column-distance", "column-step"];
        Table { title: "depth-precision-codes", columns, rows }
    }

    /// The step at some distances, in every format.
    fn steps(&self) -> Table {
        let [near, far] = self.line.planes.map(f64::from);
        let rows = (0..=SAMPLES).map(|i| {
            let part = f64::from(i) / f64::from(SAMPLES);
            let distance = (libm::log(near) * (1.0 - part) + libm::log(far) * part).clamp(-700.0, 700.0);
            let distance = libm::exp(distance).clamp(near, far);
            let step = |format| {
                let line = Line { format, ..self.line };
                Value::from(line.cell(line.place_of(distance)).length())
            };
            let name = format!("{}", (distance * 1000.0).round() / 1000.0);
            Row::new(name, DepthFormat::ALL.map(step).to_vec())
        });
        let columns = DepthFormat::ALL.map(DepthFormat::name).to_vec();
        Table { title: "depth-precision-steps", columns, rows: rows.collect() }
    }
}
