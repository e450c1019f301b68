//! What the lab shows of a Sutherland-Hodgman run.

use super::{
    super::outline::{Carrier, Place, Source, Why},
    Event, Snapshot,
    bridges::bridges,
    formulas::distance,
};
use crate::{
    clip::line::{Border, view},
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, View},
    message::{Message, Value},
};

impl Explain for Snapshot {
    const NAME: &'static str = "sutherland-hodgman";

    const LISTING: &'static [&'static str] = &[
        "polygon ← the corners as given",
        "for each side of the window",
        "  out ← first corner if it is inside",
        "  for each edge s → e of the polygon",
        "    if s and e differ in side",
        "      emit s + t (e − s)",
        "    if e is inside: emit e",
        "  polygon ← out",
        "drop repeated and straight corners",
        "done",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Begin { .. } => 0,
            Event::Side { .. } => 1,
            Event::First { .. } => 2,
            Event::Edge { .. } => 3,
            Event::Touch => 4,
            Event::Cut { .. } => 5,
            Event::Keep => 6,
            Event::SideDone { .. } => 7,
            Event::Drop { .. } => 8,
            Event::Done { .. } => 9,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            Event::First { .. } | Event::Edge { .. } => Operations::new(1, 0, 0),
            Event::Cut { .. } => Operations::new(0, 1, 1),
            // Two equalities and a turn for every corner.
            Event::Drop { .. } => Operations::new(3, 2, 0),
            Event::Done { corners } => {
                let corners = u64::from(*corners);
                Operations::new(3 * corners, 2 * corners, 0)
            }
            Event::Begin { .. } | Event::Side { .. } => Operations::NONE,
            Event::Touch | Event::Keep | Event::SideDone { .. } => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done { .. } => Level::Primitive,
            Event::SideDone { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Side { border } => (Role::Neutral, Some(border.word())),
            Event::Cut { .. } | Event::Keep | Event::First { place: Place::In | Place::On } => {
                (Role::Accepted, None)
            }
            Event::Edge { from: Place::Out, to: Place::Out } => (Role::Rejected, None),
            Event::Done { corners: 0 } => (Role::Rejected, Some("sutherland-hodgman-marker-empty")),
            Event::Done { .. } => (Role::Neutral, Some("sutherland-hodgman-marker-done")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("sutherland-hodgman-opening").with("polygons", self.given.len())
    }

    fn sentence(&self, event: &Event) -> Message {
        match *event {
            Event::Begin { polygon } => Message::new("sutherland-hodgman-begin")
                .with("number", polygon + 1)
                .with("corners", self.polygon.len()),
            Event::Side { border } => Message::new("sutherland-hodgman-side")
                .with("side", Value::Word(border.word()))
                .with("inside", Value::text(inside(border))),
            Event::First { place } => {
                let id = match place {
                    Place::In => "sutherland-hodgman-first-in",
                    Place::On => "sutherland-hodgman-first-on",
                    Place::Out => "sutherland-hodgman-first-out",
                };
                let first = self.polygon.first().map(|corner| Value::text(self.name_here(corner.source)));
                Message::new(id).with("first", first)
            }
            Event::Edge { from, to } => {
                let id = match (from == Place::Out, to == Place::Out) {
                    (false, false) if self.is_closing() => "sutherland-hodgman-in-in-closing",
                    (false, false) => "sutherland-hodgman-in-in",
                    (false, true) => "sutherland-hodgman-in-out",
                    (true, false) if self.is_closing() => "sutherland-hodgman-out-in-closing",
                    (true, false) => "sutherland-hodgman-out-in",
                    (true, true) => "sutherland-hodgman-out-out",
                };
                self.about_edge(id)
            }
            Event::Touch => {
                let on_start = self.looked.last().is_some_and(|looked| looked.from == Place::On);
                let corner = self.edge().map(|[s, e]| if on_start { s } else { e });
                let corner = corner.map(|corner| Value::text(self.name_here(corner.source)));
                Message::new("sutherland-hodgman-touch").with("corner", corner)
            }
            Event::Cut { at, source } => {
                let name = Value::text(self.name_here(source));
                match source {
                    Source::Window(_) => self.about_edge("sutherland-hodgman-cut-corner"),
                    _ => self.about_edge("sutherland-hodgman-cut"),
                }
                .with("name", name)
                .with("to", at)
            }
            Event::Keep => self.about_edge("sutherland-hodgman-keep"),
            Event::SideDone { corners } => {
                let side = self.sides.last().map(|side| Value::Word(side.border.word()));
                Message::new("sutherland-hodgman-side-done").with("side", side).with("corners", corners)
            }
            Event::Drop { why, .. } => Message::new(match why {
                Why::Repeats => "sutherland-hodgman-drop-repeats",
                Why::Straight => "sutherland-hodgman-drop-straight",
                Why::NoArea => "sutherland-hodgman-drop-no-area",
            }),
            Event::Done { corners } => self.ending(corners),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        match *event {
            Event::Edge { .. } => out.extend(self.distances()),
            Event::Cut { at, source } => out.extend(self.cut_formulas(at, source)),
            _ => {}
        }
    }

    fn tables(&self, out: &mut Vec<Table>) {
        out.push(self.edges_table());
        out.push(self.corners_table());
        out.push(self.sides_table());
        let cracks = self.cracks();
        if self.given.len() > 1 {
            let rows = cracks.iter().map(|crack| {
                let free = 1 - crack.border.axis();
                let [a, b] = crack.ends.map(|end| Value::from(end[free]));
                let cells = vec![a, b, crack.ulps().try_into().map_or(Value::None, Value::Int)];
                Row::new(crack.border.name(), cells).role(Role::Rejected)
            });
            out.push(Table {
                title: "sutherland-hodgman-cracks",
                columns: vec!["column-sutherland-hodgman-ours", "column-sutherland-hodgman-theirs", "ULP"],
                rows: rows.collect(),
            });
        }
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.picture(event, out);
    }

    fn view(&self) -> View {
        view(self.given.iter().flatten().copied(), &self.window)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        if self.results.len() == self.given.len() {
            let nothing = self.results.iter().all(Vec::is_empty);
            out.push(Fact::answer(if nothing { "word-rejected" } else { "word-accepted" }));
        }
        out.extend(self.results.iter().flatten().map(|corner| Fact::corner(corner.at)));
    }
}

/// The inequality of the inner side.
fn inside(border: Border) -> &'static str {
    match border {
        Border::Left => "x ≥ xmin",
        Border::Right => "x ≤ xmax",
        Border::Bottom => "y ≥ ymin",
        Border::Top => "y ≤ ymax",
    }
}

impl Snapshot {
    /// A sentence about the edge that was looked at last.
    fn about_edge(&self, id: &'static str) -> Message {
        let [s, e] = self.edge().map_or([None; 2], |edge| edge.map(Some));
        let name =
            |corner: Option<&super::Corner>| corner.map(|corner| Value::text(self.name_here(corner.source)));
        Message::new(id)
            .with("start", name(s))
            .with("end", name(e))
            .with("side", self.side().map(|border| Value::Word(border.word())))
            .with("at", self.side().map(|border| Value::text(border.name())))
            .with("axis", self.side().map(|border| Value::text(["x", "y"][border.axis()])))
    }

    fn ending(&self, corners: u32) -> Message {
        if corners == 0 {
            return Message::new("sutherland-hodgman-empty");
        }
        let cracks = self.cracks().len();
        if cracks > 0 {
            return Message::new("sutherland-hodgman-done-cracks")
                .with("corners", corners)
                .with("cracks", cracks);
        }
        if self.settings.mistake == Some(super::Mistake::TwoSides) {
            return Message::new("sutherland-hodgman-done-two-sides").with("corners", corners);
        }
        let bridged = self.results.last().map_or(0, |result| bridges(result, &self.window).len());
        Message::new("sutherland-hodgman-done").with("corners", corners).with("bridges", bridged)
    }

    /// Each edge against the side at work: the mock's transition table.
    fn edges_table(&self) -> Table {
        let len = if self.side().is_some() { self.polygon.len() } else { 0 };
        let rows = (0..len).map(|i| {
            let ends = [self.polygon[i], self.polygon[(i + 1) % len]];
            let [s, e] = ends.map(|corner| self.name_here(corner.source));
            let [ds, de] =
                ends.map(|corner| self.side().map(|border| distance(&corner, border, &self.window)));
            let looked = self.looked.get(i);
            let transition = looked.map(|looked| {
                Value::Word(match (looked.from == Place::Out, looked.to == Place::Out) {
                    (false, false) => "sutherland-hodgman-word-in-in",
                    (false, true) => "sutherland-hodgman-word-in-out",
                    (true, false) => "sutherland-hodgman-word-out-in",
                    (true, true) => "sutherland-hodgman-word-out-out",
                })
            });
            let emitted = looked.map(|looked| {
                let until = self.looked.get(i + 1).map_or(self.out.len(), |next| next.emitted);
                let names =
                    self.out[looked.emitted..until].iter().map(|corner| self.name_here(corner.source));
                Value::text(names.collect::<Vec<_>>().join(", "))
            });
            let cells =
                vec![ds.into(), de.into(), transition.unwrap_or(Value::None), emitted.unwrap_or(Value::None)];
            Row::new(format!("{s} → {e}"), cells).active(i + 1 == self.looked.len())
        });
        Table {
            title: "sutherland-hodgman-edges",
            columns: vec![
                "d(s)",
                "d(e)",
                "column-sutherland-hodgman-transition",
                "column-sutherland-hodgman-emits",
            ],
            rows: rows.collect(),
        }
    }

    /// What has been emitted so far, or the polygon between two sides, or what is left of it.
    fn corners_table(&self) -> Table {
        let (corners, title) = match (self.side(), self.results.last()) {
            (Some(_), _) => (&self.out, "sutherland-hodgman-out"),
            (None, Some(result)) if self.polygon.is_empty() => (result, "sutherland-hodgman-polygon"),
            _ => (&self.polygon, "sutherland-hodgman-polygon"),
        };
        let rows = corners.iter().enumerate().map(|(i, corner)| {
            let [x, y] = corner.at;
            let along = match corner.next {
                Carrier::Edge(_) => Value::BLANK,
                Carrier::Border(border) => Value::text(border.name()),
            };
            let row = Row::new(self.name_here(corner.source), vec![x.into(), y.into(), along]);
            row.active(self.side().is_some() && i + 1 == corners.len())
        });
        let columns = vec!["x", "y", "column-sutherland-hodgman-along"];
        Table { title, columns, rows: rows.collect() }
    }

    fn sides_table(&self) -> Table {
        let sides = self.settings.sides();
        let rows = sides.into_iter().map(|border| {
            let done = self.sides.iter().find(|side| side.border == border);
            let cells = vec![done.map(|side| side.before).into(), done.and_then(|side| side.after).into()];
            Row::new(border.name(), cells).active(self.side() == Some(border))
        });
        Table {
            title: "sutherland-hodgman-sides",
            columns: vec!["column-sutherland-hodgman-before", "column-sutherland-hodgman-after"],
            rows: rows.collect(),
        }
    }
}
