//! What the lab shows of a Weiler-Atherton run.

use super::{
    super::outline::{Source, Why},
    Event, Snapshot,
};
use crate::{
    clip::line::view,
    compare::Fact,
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, View},
    message::{Message, Value},
};

impl Explain for Snapshot {
    const NAME: &'static str = "weiler-atherton";

    const LISTING: &'static [&'static str] = &[
        "for each edge of the polygon",
        "  note where it crosses the window",
        "is the window's corner C0 inside?",
        "round the window: label the border",
        "while an entering crossing is unused",
        "  ring ← start there; repeat",
        "    follow the polygon to a crossing",
        "    follow the border to the next",
        "  until back at the start",
        "keep contours inside as they are",
        "no crossing, C0 inside: the window",
        "drop repeated and straight corners",
        "give holes to the pieces around them",
        "done",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Edge { .. } => 0,
            Event::Cross { .. } => 1,
            Event::Origin { .. } => 2,
            Event::Next { .. } => 3,
            Event::RingDone { .. } => 4,
            Event::Start { .. } => 5,
            Event::Follow { .. } | Event::Reach { .. } => 6,
            Event::Turn { .. } | Event::Arrive { .. } => 7,
            Event::Close => 8,
            Event::Whole { .. } => 9,
            Event::Window => 10,
            Event::Drop { .. } => 11,
            Event::Hole { .. } => 12,
            Event::Done { .. } => 13,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // One end against four borders, and the ray from C0.
            Event::Edge { .. } => Operations::new(6, 0, 0),
            // Two corners of the window against the edge, and the crossing.
            Event::Cross { .. } => Operations::new(2, 5, 1),
            Event::Next { .. } => Operations::new(1, 0, 0),
            Event::Drop { .. } => Operations::new(3, 2, 0),
            Event::RingDone { corners } => {
                let corners = u64::from(*corners);
                Operations::new(3 * corners, 2 * corners, 0)
            }
            _ => Operations::NONE,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done { .. } => Level::Primitive,
            Event::Origin { .. } | Event::RingDone { .. } => Level::Row,
            _ => Level::Detail,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Cross { .. } => (Role::Tie, None),
            Event::Origin { .. } => (Role::Neutral, Some("weiler-atherton-marker-round")),
            Event::Start { .. } | Event::Whole { .. } | Event::Window => {
                (Role::Neutral, Some("weiler-atherton-marker-ring"))
            }
            Event::RingDone { corners: 0 } => (Role::Rejected, None),
            Event::RingDone { .. } => (Role::Accepted, None),
            // No piece of its own.
            Event::Hole { .. } => (Role::Changed, None),
            Event::Done { pieces: 0 } => (Role::Rejected, Some("weiler-atherton-marker-empty")),
            Event::Done { .. } => (Role::Neutral, Some("weiler-atherton-marker-done")),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("weiler-atherton-opening")
    }

    fn sentence(&self, event: &Event) -> Message {
        let crossing = |id, crossing: u32| {
            let at = self.crossings.get(crossing as usize).map(|crossing| crossing.at);
            Message::new(id).with("crossing", Value::text(format!("X{crossing}"))).with("at", at)
        };
        match *event {
            Event::Edge { edge } => {
                let ends = [edge, self.given().next(edge)].map(|i| Value::text(self.name(Source::Vertex(i))));
                let [start, end] = ends;
                Message::new("weiler-atherton-edge").with("start", start).with("end", end)
            }
            Event::Cross { at, border, enters, .. } => {
                let id = if enters { "weiler-atherton-cross-enters" } else { "weiler-atherton-cross-leaves" };
                let name = format!("X{}", self.crossings.len().saturating_sub(1));
                Message::new(id)
                    .with("crossing", Value::text(name))
                    .with("side", Value::Word(border.word()))
                    .with("at", at)
            }
            Event::Origin { winding } => {
                let id = match winding % 2 {
                    0 => "weiler-atherton-origin-outside",
                    _ => "weiler-atherton-origin-inside",
                };
                Message::new(id).with("winding", winding)
            }
            Event::Next { crossing: index, inside: true } => crossing("weiler-atherton-next-inside", index),
            Event::Next { crossing: index, inside: false } => crossing("weiler-atherton-next-outside", index),
            Event::Start { crossing: index } => crossing("weiler-atherton-start", index),
            Event::Follow { corner } => {
                let name = Value::text(self.name(Source::Vertex(corner)));
                Message::new("weiler-atherton-follow").with("corner", name)
            }
            Event::Reach { crossing: index } => crossing("weiler-atherton-reach", index),
            Event::Turn { corner } => {
                Message::new("weiler-atherton-turn").with("corner", Value::text(format!("C{corner}")))
            }
            Event::Arrive { crossing: index } => crossing("weiler-atherton-arrive", index),
            Event::Close => Message::new("weiler-atherton-close").with("corners", self.ring.len()),
            Event::Whole { hole: false, .. } => Message::new("weiler-atherton-whole"),
            Event::Whole { hole: true, .. } => Message::new("weiler-atherton-whole-hole"),
            Event::Window => Message::new("weiler-atherton-window"),
            Event::Drop { why, .. } => Message::new(match why {
                Why::Repeats => "weiler-atherton-drop-repeats",
                Why::Straight => "weiler-atherton-drop-straight",
                Why::NoArea => "weiler-atherton-drop-no-area",
            }),
            Event::RingDone { corners } => Message::new("weiler-atherton-ring-done").with("corners", corners),
            Event::Hole { .. } => Message::new("weiler-atherton-hole"),
            Event::Done { pieces } => {
                let holes = self.rings.len().saturating_sub(pieces as usize);
                Message::new("weiler-atherton-done").with("pieces", pieces).with("holes", holes)
            }
        }
    }

    fn formulas(&self, _: &Event, _: &mut Vec<Formula>) {}

    fn tables(&self, out: &mut Vec<Table>) {
        let course = |enters: bool| {
            Value::Word(if enters { "weiler-atherton-enters" } else { "weiler-atherton-leaves" })
        };
        let rows = self.crossings.iter().enumerate().map(|(i, crossing)| {
            let [x, y] = crossing.at;
            let row = Row::new(format!("X{i}"), vec![x.into(), y.into(), course(crossing.enters)]);
            row.active(self.edge.is_some() && i + 1 == self.crossings.len())
                .role(self.used[i].then_some(Role::Accepted))
        });
        out.push(Table {
            title: "weiler-atherton-polygon-list",
            columns: vec!["x", "y", "column-weiler-atherton-course"],
            rows: rows.collect(),
        });
        let rows = self.round.iter().map(|&(crossing, inside)| {
            let label = if inside { "weiler-atherton-inside" } else { "weiler-atherton-outside" };
            let border = Value::text(self.crossings[crossing].border.name());
            let row = Row::new(format!("X{crossing}"), vec![border, Value::Word(label)]);
            row.role(self.used[crossing].then_some(Role::Accepted))
        });
        out.push(Table {
            title: "weiler-atherton-window-list",
            columns: vec!["column-weiler-atherton-on", "column-weiler-atherton-behind"],
            rows: rows.collect(),
        });
        let rows = self.ring.iter().enumerate().map(|(i, corner)| {
            let [x, y] = corner.at;
            let row = Row::new(self.name(corner.source), vec![x.into(), y.into()]);
            row.active(i + 1 == self.ring.len())
        });
        out.push(Table { title: "weiler-atherton-ring", columns: vec!["x", "y"], rows: rows.collect() });
        let rows = self.pieces().into_iter().enumerate().map(|(i, piece)| {
            let cells = vec![piece.outer.len().into(), piece.holes.len().into()];
            Row::new((i + 1).to_string(), cells)
        });
        out.push(Table {
            title: "weiler-atherton-pieces",
            columns: vec!["column-weiler-atherton-corners", "column-weiler-atherton-holes"],
            rows: rows.collect(),
        });
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        self.picture(event, out);
    }

    fn view(&self) -> View {
        view(self.given().points.iter().copied(), &self.window)
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        if self.done {
            out.push(Fact::answer(if self.rings.is_empty() { "word-rejected" } else { "word-accepted" }));
        }
        let corners = self.rings.iter().flat_map(|(ring, _)| ring);
        out.extend(corners.map(|corner| Fact::corner(corner.at)));
    }
}
