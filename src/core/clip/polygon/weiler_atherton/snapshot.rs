//! The state of a Weiler-Atherton run: the fold of its events.

use super::{
    super::outline::{Corner, Given, Source, drop_corner},
    Event, Piece, ROUND, Ring,
    crossings::Crossing,
    starts, whole_window, window_corner,
};
use crate::{
    clip::line::{Point, Window},
    replay::State,
};
use std::sync::Arc;

/// What the user sees between two events.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// The corners of all contours, and where each contour starts.
    points: Arc<[Point]>,
    pub(super) starts: Arc<[u32]>,
    pub(super) window: Window,
    /// The edge that was looked at last, while crossings are looked for.
    pub(super) edge: Option<u32>,
    pub(super) crossings: Vec<Crossing>,
    /// Which of them a ring has passed.
    pub(super) used: Vec<bool>,
    pub(super) winding: Option<i32>,
    /// Around the window: crossings, and whether the border behind each is inside.
    pub(super) round: Vec<(usize, bool)>,
    /// The ring at hand, and whether it is a hole.
    pub(super) ring: Ring,
    hole: bool,
    pub(super) rings: Vec<(Ring, bool)>,
    /// The outer ring that each hole was given to.
    owners: Vec<Option<usize>>,
    pub(super) done: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(contours: &[Vec<Point>], window: Window) -> Self {
        Self {
            points: contours.concat().into(),
            starts: starts(contours).into(),
            window,
            edge: None,
            crossings: Vec::new(),
            used: Vec::new(),
            winding: None,
            round: Vec::new(),
            ring: Vec::new(),
            hole: false,
            rings: Vec::new(),
            owners: Vec::new(),
            done: false,
        }
    }

    /// The pieces that the events so far amount to.
    pub fn pieces(&self) -> Vec<Piece> {
        let owner = |ring: usize| self.owners.get(ring).copied().flatten();
        let mut pieces = Vec::new();
        for (i, (outer, _)) in self.rings.iter().enumerate().filter(|(i, _)| owner(*i).is_none()) {
            let own = self.rings.iter().enumerate().filter(|(hole, _)| owner(*hole) == Some(i));
            let holes = own.map(|(_, (ring, _))| ring.clone()).collect();
            pieces.push(Piece { outer: outer.clone(), holes });
        }
        pieces
    }

    pub(super) fn given(&self) -> Given<'_> {
        Given { points: &self.points, starts: &self.starts, window: &self.window }
    }

    /// The name of a corner: `V3` is given, with a prime in the second contour; `X2` is a crossing, `C1`
    /// a corner of the window.
    pub(super) fn name(&self, source: Source) -> String {
        match source {
            Source::Vertex(index) => {
                let contour = self.starts.partition_point(|start| *start <= index) - 1;
                format!("V{}{}", index - self.starts[contour], "′".repeat(contour.min(3)))
            }
            Source::Crossing { edge, border } => {
                let same = |crossing: &Crossing| crossing.edge == edge && crossing.border == border;
                format!("X{}", self.crossings.iter().position(same).unwrap_or_default())
            }
            Source::Window(borders) => {
                let corner =
                    (0..4).find(|&i| borders.contains(&ROUND[i]) && borders.contains(&ROUND[(i + 3) % 4]));
                format!("C{}", corner.unwrap_or_default())
            }
        }
    }

    fn pass(&mut self, crossing: u32) {
        let crossing = crossing as usize;
        self.used[crossing] = true;
        let passed = self.crossings[crossing];
        self.ring.push(passed.corner(passed.border));
    }

    fn given_corner(&self, index: u32) -> Corner {
        Corner::given(index as usize, self.points[index as usize])
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Edge { edge } => self.edge = Some(edge),
            Event::Cross { at, edge, border, enters } => {
                let source = self.given().source_at(edge, border);
                self.crossings.push(Crossing { at, source, edge, border, enters });
                self.used.push(false);
            }
            Event::Origin { winding } => (self.edge, self.winding) = (None, Some(winding)),
            Event::Next { crossing, inside } => self.round.push((crossing as usize, inside)),
            Event::Start { crossing } | Event::Reach { crossing } | Event::Arrive { crossing } => {
                self.pass(crossing);
            }
            Event::Follow { corner } => self.ring.push(self.given_corner(corner)),
            Event::Turn { corner } => {
                let corner = window_corner(&self.given(), corner, ROUND[usize::from(corner) % 4]);
                self.ring.push(corner);
            }
            Event::Close => {}
            Event::Whole { contour, hole } => {
                let corners = self.given().contour(contour as usize);
                self.ring = corners.map(|index| self.given_corner(index)).collect();
                self.hole = hole;
            }
            Event::Window => self.ring = whole_window(&self.given(), self.winding.unwrap_or_default()),
            Event::Drop { corner, why } => drop_corner(&mut self.ring, corner as usize, why),
            Event::RingDone { corners } => {
                let ring = std::mem::take(&mut self.ring);
                let hole = std::mem::take(&mut self.hole);
                if corners > 0 {
                    self.rings.push((ring, hole));
                    self.owners.push(None);
                }
            }
            Event::Hole { ring, outer } => self.owners[ring as usize] = Some(outer as usize),
            Event::Done { .. } => self.done = true,
        }
    }

    fn size_hint(&self) -> usize {
        let corners = self.ring.len() + self.rings.iter().map(|(ring, _)| ring.len()).sum::<usize>();
        size_of::<Self>() + corners * size_of::<Corner>() + self.crossings.len() * size_of::<Crossing>()
    }
}
