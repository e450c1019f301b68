//! What the lab shows of a tree of boxes.

use super::{
    Aabb, Counts, Event, Found, Split, Tree,
    nodes::{Fate, node_name},
    picture, tests_without_tree,
};
use crate::{
    clip::polygon::Plane,
    compare::Fact,
    cull::{
        object_frustum::reach_formulas,
        planes::{Frustum, PlaneMask, Side, Volume},
    },
    explain::{Explain, Formula, Level, Mark, Marker, Operations, Role, Row, Table, Vantage, View},
    message::{Message, Value},
    replay::State,
};
use std::sync::Arc;

/// The boxes and the frustum of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Input {
    /// One box an object or a triangle, in world space.
    pub boxes: Arc<[Aabb]>,
    /// Their names.
    pub names: Arc<[String]>,
    /// The triangles that the boxes are around, to be drawn; empty if they are around objects.
    pub triangles: Arc<[[[f32; 3]; 3]]>,
    /// How the tree is built.
    pub split: Split,
    /// The frustum in world space.
    pub frustum: Frustum,
    /// Its corners, to be drawn.
    pub corners: Option<[[f32; 3]; 8]>,
}

/// What the user sees between two events: the fold of the events so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    pub(super) input: Input,
    /// The whole tree.
    pub(super) tree: Arc<Tree>,
    /// How many nodes are built.
    pub(super) built: usize,
    pub(super) fates: Vec<Fate>,
    /// For each box what is known: `Some(None)` it is kept.
    pub(super) known: Vec<Option<Option<Plane>>>,
    pub(super) now: Option<u32>,
    pub(super) item: Option<u32>,
    /// The planes that are still to be tested, and the last one that was.
    pub(super) mask: PlaneMask,
    plane: Option<(Plane, Side)>,
    counts: Counts,
    without: u32,
    pub(super) done: bool,
}

impl Snapshot {
    /// Before the first event.
    pub fn new(input: Input) -> Self {
        let tree = Tree::build(&input.boxes, input.split);
        Self {
            fates: vec![Fate::Unseen; tree.nodes().len()],
            known: vec![None; input.boxes.len()],
            without: tests_without_tree(&input.boxes, &input.frustum),
            built: usize::from(!tree.nodes().is_empty()),
            tree: Arc::new(tree),
            now: None,
            item: None,
            mask: PlaneMask::NONE,
            plane: None,
            counts: Counts::default(),
            done: false,
            input,
        }
    }

    /// The result that the events so far amount to.
    pub fn result(&self) -> Found {
        Found { outside: self.known.iter().map(|known| known.flatten()).collect(), counts: self.counts }
    }

    /// How many boxes lie below a node.
    pub(super) fn below(&self, node: u32) -> u32 {
        self.tree.nodes()[node as usize].range[1]
    }

    fn kept(&self) -> usize {
        self.known.iter().filter(|known| **known == Some(None)).count()
    }

    fn decide(&mut self, node: u32, outside: Option<Plane>) {
        for &item in self.tree.items(&self.tree.nodes()[node as usize]) {
            self.known[item as usize] = Some(outside);
        }
    }
}

impl State for Snapshot {
    type Event = Event;

    fn apply(&mut self, event: &Event) {
        self.item = None;
        self.plane = None;
        match *event {
            Event::Split { node, first, .. } => {
                self.now = Some(node);
                self.built = first as usize + 2;
            }
            Event::Leaf { node } => self.now = Some(node),
            Event::Visit { node, mask } => {
                (self.now, self.mask) = (Some(node), mask);
                self.fates[node as usize] = Fate::Visited;
                self.counts.visited += 1;
            }
            Event::Plane { plane, side, .. } => {
                self.counts.tests += 1;
                self.plane = Some((plane, side));
                if side == Side::Inside {
                    self.mask = self.mask.without(plane);
                }
            }
            Event::Reject { node, plane } => {
                self.fates[node as usize] = Fate::Rejected(plane);
                self.counts.rejected += 1;
                self.decide(node, Some(plane));
            }
            Event::Accept { node } => {
                self.fates[node as usize] = Fate::Accepted;
                self.counts.accepted += 1;
                self.decide(node, None);
            }
            Event::Descend { node } => self.fates[node as usize] = Fate::Crossed,
            Event::ItemPlane { item, plane, side } => {
                self.counts.tests += 1;
                self.plane = Some((plane, side));
                self.item = Some(item);
                self.cross();
            }
            Event::Item { item, outside } => {
                self.counts.items += 1;
                self.known[item as usize] = Some(outside);
                self.item = Some(item);
                self.cross();
            }
            Event::Done => (self.now, self.done) = (None, true),
        }
    }

    fn size_hint(&self) -> usize {
        size_of::<Self>() + 2 * self.fates.len() + 2 * self.known.len()
    }
}

impl Snapshot {
    /// A leaf whose boxes are tested crosses a plane.
    fn cross(&mut self) {
        if let Some(node) = self.now {
            self.fates[node as usize] = Fate::Crossed;
        }
    }
}

impl Explain for Snapshot {
    const NAME: &'static str = "bvh";

    const LISTING: &'static [&'static str] = &[
        "build: 2 boxes or 1 are a leaf",
        "  else split the node in two",
        "push the root with all six planes",
        "repeat: pop a node and its planes",
        "  test its box against its planes",
        "  outside one: reject all below it",
        "  inside all: accept all below it",
        "  across: push both, with those planes",
        "  a leaf: test each of its boxes",
        "    outside one: reject it; else keep",
        "until the stack is empty",
    ];

    fn line(event: &Event) -> usize {
        match event {
            Event::Leaf { .. } => 0,
            Event::Split { .. } => 1,
            Event::Visit { node: 0, .. } => 2,
            Event::Visit { .. } => 3,
            Event::Plane { .. } => 4,
            Event::Reject { .. } => 5,
            Event::Accept { .. } => 6,
            Event::Descend { .. } => 7,
            Event::ItemPlane { .. } => 8,
            Event::Item { .. } => 9,
            Event::Done => 10,
        }
    }

    fn level(event: &Event) -> Level {
        match event {
            Event::Done => Level::Primitive,
            Event::Plane { .. } | Event::ItemPlane { .. } | Event::Visit { .. } | Event::Leaf { .. } => {
                Level::Detail
            }
            _ => Level::Row,
        }
    }

    fn operations(event: &Event) -> Operations {
        match event {
            // n . middle and |n| . half, then one or two comparisons with zero.
            Event::Plane { side, .. } | Event::ItemPlane { side, .. } => {
                Operations::new(1 + u64::from(*side != Side::Outside), 6, 0)
            }
            _ => Operations::NONE,
        }
    }

    fn marker(event: &Event) -> Option<Marker> {
        let (role, label) = match event {
            Event::Visit { node: 0, .. } => (Role::Neutral, Some("bvh-marker-traverse")),
            Event::Reject { .. } => (Role::Rejected, None),
            Event::Accept { .. } => (Role::Accepted, None),
            Event::Item { outside: Some(_), .. } => (Role::Rejected, None),
            Event::Item { outside: None, .. } => (Role::Accepted, None),
            _ => return None,
        };
        Some(Marker { role, label })
    }

    fn opening(&self) -> Message {
        Message::new("bvh-opening")
            .with("count", self.input.boxes.len())
            .with("split", Value::Word(self.input.split.word()))
    }

    fn sentence(&self, event: &Event) -> Message {
        let about = |id, node: u32| {
            Message::new(id).with("node", Value::text(node_name(node))).with("count", self.below(node))
        };
        let name = |item: u32| Value::text(&self.input.names[item as usize]);
        let plane_word = |plane: Plane| Value::Word(plane.word());
        match *event {
            Event::Split { node, axis, first } => about("bvh-split", node)
                .with("axis", Value::text(["x", "y", "z"][usize::from(axis)]))
                .with("left", self.below(first))
                .with("right", self.below(first + 1)),
            Event::Leaf { node } => about("bvh-leaf", node),
            Event::Visit { node: 0, .. } => about("bvh-visit-root", 0),
            Event::Visit { node, mask } => about("bvh-visit", node).with("planes", mask.planes().count()),
            Event::Plane { node, plane, side } => about(
                match side {
                    Side::Outside => "bvh-plane-outside",
                    Side::Inside => "bvh-plane-inside",
                    Side::Crosses => "bvh-plane-crosses",
                },
                node,
            )
            .with("plane", plane_word(plane)),
            Event::Reject { node, plane } => about("bvh-reject", node).with("plane", plane_word(plane)),
            Event::Accept { node } => about("bvh-accept", node),
            Event::Descend { node } => about("bvh-descend", node).with("planes", self.mask.planes().count()),
            Event::ItemPlane { item, plane, side } => Message::new(match side {
                Side::Outside => "bvh-item-outside",
                Side::Inside => "bvh-item-inside",
                Side::Crosses => "bvh-item-crosses",
            })
            .with("item", name(item))
            .with("plane", plane_word(plane)),
            Event::Item { item, outside: Some(plane) } => {
                Message::new("bvh-item-rejected").with("item", name(item)).with("plane", plane_word(plane))
            }
            Event::Item { item, outside: None } => Message::new("bvh-item-kept").with("item", name(item)),
            Event::Done => Message::new("bvh-done")
                .with("kept", self.kept())
                .with("count", self.input.boxes.len())
                .with("tests", self.counts.tests)
                .with("without", self.without),
        }
    }

    fn formulas(&self, event: &Event, out: &mut Vec<Formula>) {
        let (bounds, plane) = match *event {
            Event::Plane { node, plane, .. } => (self.tree.nodes()[node as usize].bounds, plane),
            Event::ItemPlane { item, plane, .. } => (self.input.boxes[item as usize], plane),
            _ => return,
        };
        out.extend(reach_formulas(self.input.frustum.reach(plane, &Volume::Box(bounds))));
    }

    fn tables(&self, out: &mut Vec<Table>) {
        let counts = &self.counts;
        let row = |name, value: u32| Row::new(name, vec![value.into()]);
        out.push(Table {
            title: "bvh-counts",
            columns: vec!["column-bvh-count"],
            rows: vec![
                row("row-bvh-visited", counts.visited),
                row("row-bvh-rejected", counts.rejected),
                row("row-bvh-accepted", counts.accepted),
                row("row-bvh-items", counts.items),
                row("row-bvh-tests", counts.tests),
                row("row-bvh-without", self.without).role(Role::Candidate),
            ],
        });
        out.push(self.path());
    }

    fn marks(&self, event: Option<&Event>, out: &mut Vec<Mark>) {
        picture::marks(self, event, out);
    }

    fn view(&self) -> View {
        View::SPACE
    }

    fn vantage(&self) -> Option<Vantage> {
        Some(picture::vantage(self))
    }

    fn facts(&self, out: &mut Vec<Fact>) {
        for (name, known) in self.input.names.iter().zip(&self.known) {
            out.extend(known.map(|outside| {
                let word = outside.map_or("bvh-kept", |plane| plane.word());
                Fact::named(name.clone(), vec![("column-bvh-fate", Value::Word(word))])
            }));
        }
    }
}
