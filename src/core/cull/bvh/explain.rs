//! What the lab shows of a tree of boxes.

use super::{Aabb, Counts, Event, Found, Split, Tree, picture, tests_without_tree};
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
    /// How the tree is built.
    pub split: Split,
    /// The frustum in world space.
    pub frustum: Frustum,
    /// Its corners, to be drawn.
    pub corners: Option<[[f32; 3]; 8]>,
}

/// What is known of a node.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Fate {
    /// It was not looked at.
    #[default]
    Unseen,
    /// It is being tested.
    Visited,
    /// Outside this plane.
    Rejected(Plane),
    /// Inside all planes.
    Accepted,
    /// What is below it is looked at.
    Crossed,
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
    mask: PlaneMask,
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
    fn below(&self, node: u32) -> u32 {
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

/// The name of a node.
pub(super) fn node_name(node: u32) -> String {
    format!("#{node}")
}

fn bits(mask: PlaneMask) -> Value {
    // Left to right as the planes are tested.
    let bits = Plane::ALL.into_iter().fold(0, |bits, plane| bits << 1 | u32::from(mask.has(plane)));
    Value::Bits { bits, width: 6 }
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
        "build: a node of at most 2 boxes is a leaf",
        "  else split it; its children are the next two",
        "push the root, with all six planes",
        "repeat: pop a node and its planes",
        "  each of its planes: outside, inside, across?",
        "  outside one: reject all that is below",
        "  inside all: accept all that is below",
        "  across: push both children with those planes",
        "  a leaf: test its boxes against those planes",
        "    outside one: reject the box, else keep it",
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

impl Snapshot {
    /// From the root to the node of this step, and its children.
    fn path(&self) -> Table {
        let mut nodes: Vec<u32> = self.now.into_iter().collect();
        while let Some(parent) = nodes.last().and_then(|&node| self.parent(node)) {
            nodes.push(parent);
        }
        nodes.reverse();
        if let Some(children) = self.now.and_then(|node| self.tree.nodes()[node as usize].children) {
            nodes.extend(children.into_iter().filter(|&child| (child as usize) < self.built));
        }
        let rows = nodes.into_iter().map(|node| {
            let fate = self.fates[node as usize];
            let now = self.now == Some(node);
            let mask = if now && fate != Fate::Unseen { bits(self.mask) } else { Value::BLANK };
            let cells = vec![self.below(node).into(), mask, fate.word()];
            Row::new(node_name(node), cells).active(now).role(fate.role())
        });
        Table {
            title: "bvh-path",
            columns: vec!["column-bvh-boxes", "L R B T N F", "column-bvh-fate"],
            rows: rows.collect(),
        }
    }

    fn parent(&self, node: u32) -> Option<u32> {
        let is_parent = |of: &super::Node| of.children.is_some_and(|children| children.contains(&node));
        self.tree.nodes().iter().position(is_parent).map(|at| at as u32)
    }
}

impl Fate {
    fn word(self) -> Value {
        match self {
            Self::Unseen => Value::BLANK,
            Self::Visited => Value::Word("bvh-fate-visited"),
            Self::Rejected(plane) => Value::Word(plane.word()),
            Self::Accepted => Value::Word("bvh-fate-accepted"),
            Self::Crossed => Value::Word("bvh-fate-crossed"),
        }
    }

    /// What the node means in the picture.
    pub(super) fn role(self) -> Option<Role> {
        match self {
            Self::Unseen | Self::Visited => None,
            Self::Rejected(_) => Some(Role::Rejected),
            Self::Accepted => Some(Role::Accepted),
            Self::Crossed => Some(Role::Neutral),
        }
    }
}
