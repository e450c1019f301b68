//! What the user sees between two steps of clipping a triangle: the fold of the events so far.

use super::{Event, Outcome, Settings, Space, Subject, run};
use crate::{
    clip::polygon::{
        Plane,
        clip_space::{self, Corner, Crossing, Origin, TaughtCorner},
    },
    math::Sign,
    replay::State,
    transform::divide,
};

/// A corner with its name: `v0` to `v2`, then `i0`, `i1` for the first plane that cuts, `j0`, ...
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Named {
    pub(super) name: String,
    pub(super) origin: Origin,
    pub(super) at: [f64; 4],
    /// What the end inside weighs; a vertex has none.
    pub(super) t: Option<f64>,
}

/// An edge that was walked.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Walked {
    pub(super) from: usize,
    pub(super) kept: bool,
    /// The new corner's name.
    pub(super) emitted: Option<String>,
}

/// What the user sees between two events.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) subject: Subject,
    /// The vertices where they are clipped.
    pub(super) vertices: [[f32; 4]; 3],
    /// How many of them were divided first.
    pub(super) divided: usize,
    pub(super) plane: Option<Plane>,
    /// Which of the vertices, or of the corners, were found outside the plane.
    pub(super) outside: (u16, u8),
    /// The planes that are done, with the corners before and after.
    pub(super) done: Vec<(Plane, [usize; 2])>,
    /// How many planes have cut.
    cuts: usize,
    /// The polygon as it stands.
    pub(super) corners: Vec<Named>,
    /// The corners' sides of the current plane, as far as they are known.
    pub(super) sides: Vec<(Sign, f64)>,
    pub(super) walked: Vec<Walked>,
    /// What was kept and emitted at the current plane.
    pub(super) next: Vec<Named>,
    /// What the planes have cut off; the last one while it is being cut.
    pub(super) removed: Vec<Vec<[f64; 4]>>,
    removing: Vec<[f64; 4]>,
    /// Every new corner so far.
    pub(super) made: Vec<Named>,
    /// The corners of the result, and the attributes that are known.
    pub(super) rounded: Vec<[f32; 4]>,
    /// How many corners were merged with others.
    merged: usize,
    pub(super) attributes: Vec<f32>,
    pub(super) triangles: Vec<[u8; 3]>,
    pub(super) lost: Option<usize>,
    pub(super) over: bool,
    /// What comes out without mistake and error; divided, if that comes first.
    pub(super) correct: Outcome,
    /// What a triangle that walks round the same corners the other way computes, as the neighbour at
    /// each edge does.
    pub(super) neighbour: Outcome,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(subject: Subject) -> Self {
        let vertices = subject.entering();
        Self {
            subject,
            vertices,
            divided: 0,
            plane: None,
            outside: (0, 0),
            done: Vec::new(),
            cuts: 0,
            corners: named(vertices),
            sides: Vec::new(),
            walked: Vec::new(),
            next: Vec::new(),
            removed: Vec::new(),
            removing: Vec::new(),
            made: Vec::new(),
            rounded: Vec::new(),
            merged: 0,
            attributes: Vec::new(),
            triangles: Vec::new(),
            lost: None,
            over: false,
            correct: corrected(&subject),
            neighbour: neighbour(&subject),
        }
    }

    /// The result that the events so far amount to; empty before the end.
    pub fn result(&self) -> Outcome {
        if !self.over {
            return Outcome::default();
        }
        let corners = self.corners.iter().zip(&self.rounded).zip(&self.attributes);
        let corners = corners.map(|((named, &position), &attribute)| TaughtCorner {
            corner: Corner { position, origin: named.origin },
            attribute,
        });
        Outcome { corners: corners.collect(), triangles: self.triangles.clone() }
    }

    /// Whether the run differs from the correct one in what it does.
    pub(super) fn is_taught(&self) -> bool {
        self.subject != self.subject.corrected()
    }

    /// The correct corner of the same origin.
    pub(super) fn correct_at(&self, origin: Origin) -> Option<&TaughtCorner> {
        self.correct.corners.iter().find(|there| same(there.corner.origin, origin))
    }

    /// The name of a corner: as it was made, else after its edge or its planes.
    pub(super) fn name(&self, origin: Origin) -> String {
        let made = self.made.iter().find(|made| same(made.origin, origin));
        match (made, origin) {
            (Some(made), _) => made.name.clone(),
            (None, Origin::Vertex(i)) => format!("v{i}"),
            (None, Origin::Edge { edge, .. }) => format!("v{}v{}", (edge + 1) % 3, (edge + 2) % 3),
            (None, Origin::Interior { .. }) => "◆".to_owned(),
        }
    }

    /// The corner of the neighbour at the same place of the shared edge.
    pub(super) fn neighbour_at(&self, origin: Origin) -> Option<&TaughtCorner> {
        let Origin::Edge { edge, plane } = origin else { return None };
        let edge = [0, 2, 1][usize::from(edge % 3)];
        let there = Origin::Edge { edge, plane };
        self.neighbour.corners.iter().find(|corner| corner.corner.origin == there)
    }

    /// Begins a plane.
    fn take(&mut self, plane: Plane, outside: (u16, u8)) {
        self.plane = Some(plane);
        self.outside = outside;
        self.sides.clear();
        self.walked.clear();
    }

    fn finish_plane(&mut self, before: usize) {
        if let Some(plane) = self.plane {
            self.done.push((plane, [before, self.corners.len()]));
        }
    }

    fn reject(&mut self) {
        let before = self.corners.len();
        self.removed.push(self.corners.iter().map(|corner| corner.at).collect());
        self.corners.clear();
        self.finish_plane(before);
    }

    /// One edge was walked: its kept part goes to the new polygon, the other part is cut off.
    fn walk(&mut self, from: usize, kept: bool, crossing: Option<Crossing>) {
        let Some(start) = self.corners.get(from).cloned() else { return };
        let at = start.at;
        let on_plane = self.sides.get(from).is_some_and(|(side, _)| *side == Sign::Zero);
        if !kept || on_plane {
            self.removing.push(at);
        }
        if kept {
            self.next.push(start);
        }
        let emitted = crossing.map(|Crossing { origin, t, at }| {
            let count = self.walked.iter().filter(|walked| walked.emitted.is_some()).count();
            let letter = char::from(b'i' + (self.cuts as u8).min(16));
            let name = format!("{letter}{count}");
            let new = Named { name: name.clone(), origin, at, t: Some(t) };
            self.removing.push(at);
            self.next.push(new.clone());
            self.made.push(new);
            name
        });
        self.walked.push(Walked { from, kept, emitted });
    }

    fn replace(&mut self, corners: usize) {
        let before = self.corners.len();
        self.corners = std::mem::take(&mut self.next);
        self.corners.truncate(corners);
        self.cuts += usize::from(self.walked.iter().any(|walked| walked.emitted.is_some()));
        self.removed.push(std::mem::take(&mut self.removing));
        self.sides.clear();
        self.finish_plane(before);
    }

    fn apply_clip(&mut self, event: &clip_space::Event) {
        use clip_space::Event as E;
        match *event {
            E::Plane { plane, outside, of } => self.take(plane, (outside, of)),
            E::Keep => self.finish_plane(self.corners.len()),
            E::Reject => self.reject(),
            E::Side { side, distance, .. } => self.sides.push((side, distance)),
            E::Edge { from, kept, crossing } => self.walk(usize::from(from), kept, crossing),
            E::Next { corners } => self.replace(usize::from(corners)),
            E::Round { at, .. } => {
                self.plane = None;
                self.walked.clear();
                self.rounded.push(at);
            }
            E::Merge { corner } => self.merge(usize::from(corner)),
        }
    }

    /// A corner goes; its number is that before any went.
    fn merge(&mut self, corner: usize) {
        let index = corner.saturating_sub(self.merged);
        if index < self.rounded.len() {
            self.merged += 1;
            self.corners.remove(index);
            self.rounded.remove(index);
        }
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        match *event {
            Event::Divide { vertex, at } => {
                self.vertices[usize::from(vertex)] = at;
                self.divided = usize::from(vertex) + 1;
                self.corners = named(self.vertices);
            }
            Event::Lost { vertex } => {
                self.lost = Some(usize::from(vertex));
                self.corners.clear();
            }
            Event::Clip(_, step) => self.apply_clip(&step),
            Event::Attribute { value, .. } => self.attributes.push(value),
            Event::Triangle { corners } => self.triangles.push(corners),
            Event::Done { corners } => {
                self.over = true;
                self.corners.truncate(usize::from(corners));
            }
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + 64 * size_of::<Named>()
    }
}

/// The right result; divided, if the run divides first, so that both can be held side by side.
fn corrected(subject: &Subject) -> Outcome {
    let mut outcome = run(&subject.corrected());
    if subject.divides_first() {
        // The right run was in the space that was chosen; what is divided first was in clip space.
        let before = Settings { space: Space::Clip, ..subject.corrected().settings };
        outcome = run(&Subject { settings: before, ..*subject });
        for there in &mut outcome.corners {
            let [x, y, z, _] = divide(there.corner.position);
            there.corner.position = [x, y, z, 1.0];
        }
    }
    outcome
}

/// The result of the triangle that is walked round the other way.
fn neighbour(subject: &Subject) -> Outcome {
    let ([a, b, c], [u, v, w]) = (subject.vertices, subject.attribute);
    run(&Subject { vertices: [a, c, b], attribute: [u, w, v], ..*subject })
}

/// The triangle's own corners.
fn named(vertices: [[f32; 4]; 3]) -> Vec<Named> {
    (0_u8..)
        .zip(vertices)
        .map(|(i, at)| Named {
            name: format!("v{i}"),
            origin: Origin::Vertex(i),
            at: at.map(f64::from),
            t: None,
        })
        .collect()
}

/// The same corner, whichever of two planes came first.
fn same(a: Origin, b: Origin) -> bool {
    match (a, b) {
        (Origin::Interior { planes: [p, q] }, Origin::Interior { planes }) => {
            planes == [p, q] || planes == [q, p]
        }
        _ => a == b,
    }
}
