//! What a lab shows of a run: listing, sentence, formulas, tables, marks.
//!
//! Each algorithm file implements [`Explain`] for its state, so that the algorithm and its
//! explanation change together. Nothing here knows a colour, a font or a language: a [`Role`] says
//! what a mark means, a [`Message`] names a sentence.

mod cells;
mod field;
mod label;
mod operations;
mod pixel;
mod space;
mod table;

pub(crate) use cells::Cells;
pub use cells::MOST_PIXELS;
pub use field::{Field, Numbers, Tone};
pub use label::Label;
pub use operations::Operations;
pub use pixel::PixelReport;
pub use space::{Solid, Vantage, box_corners};
pub use table::{Formula, Piece, Row, Table};

use crate::{
    compare::Fact,
    message::{Message, Value},
    replay::State,
};

/// How big a step an event ends; the user chooses at which level to step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// A whole triangle, polygon or segment is done.
    Primitive,
    /// One row, border, matrix or tree node is done.
    Row,
    /// One pixel, test or assignment.
    Detail,
}

impl Level {
    /// From coarse to fine.
    pub const ALL: [Self; 3] = [Self::Primitive, Self::Row, Self::Detail];

    /// The name on the command line and in traces.
    pub fn name(self) -> &'static str {
        match self {
            Self::Primitive => "primitive",
            Self::Row => "row",
            Self::Detail => "detail",
        }
    }
}

/// What a mark means. The theme maps a role to a colour AND a marker AND a dash.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// The current step.
    Active,
    /// Inside, passed, kept, drawn.
    Accepted,
    /// Outside, failed, culled, removed.
    Rejected,
    /// Tested next, not decided.
    Candidate,
    /// Differs from the step before, or between two runs.
    Changed,
    /// Exactly on an edge.
    Tie,
    /// Not looked at, and why.
    Skipped,
    /// The correctly rounded reference.
    Exact,
    /// As the lecture prints it, in rounded arithmetic.
    Taught,
    /// Construction and input: outlines, windows, axes; wears the text colour.
    Neutral,
}

impl Role {
    /// All roles, in the order of the theme's table.
    pub const ALL: [Self; 10] = [
        Self::Active,
        Self::Accepted,
        Self::Rejected,
        Self::Candidate,
        Self::Changed,
        Self::Tie,
        Self::Skipped,
        Self::Exact,
        Self::Taught,
        Self::Neutral,
    ];
}

/// A, B, C, ..., Z; a number from 27 on: the name of object `index` (from 0) if it has no other.
pub fn letter(index: usize) -> String {
    match u8::try_from(index) {
        Ok(index @ 0..26) => char::from(b'A' + index).to_string(),
        _ => (index + 1).to_string(),
    }
}

/// Geometry to draw, in the scene units of the algorithm's [`View`].
#[derive(Clone, Debug, PartialEq)]
pub enum Mark {
    /// A point; its marker is the role's.
    Point {
        /// Where.
        at: [f32; 2],
        /// What it means.
        role: Role,
        /// Plate beside it.
        label: Option<Label>,
    },
    /// A segment, dashed and coloured by its role.
    Segment {
        /// Both ends.
        ends: [[f32; 2]; 2],
        /// What it means.
        role: Role,
        /// Plate at its middle.
        label: Option<Label>,
    },
    /// A line through points that is not closed, dashed and coloured by its role as one line.
    Curve {
        /// In order.
        points: Vec<[f32; 2]>,
        /// What it means.
        role: Role,
        /// Plate at its middle.
        label: Option<Label>,
    },
    /// A line right through the picture, parallel to an axis.
    Guide {
        /// 0: `x = at`, 1: `y = at`.
        axis: u8,
        /// The constant coordinate.
        at: f32,
        /// What it means.
        role: Role,
        /// Plate at the picture's border.
        label: Option<Label>,
        /// A few words at the other border, when the step is about this line.
        note: Option<Message>,
    },
    /// A closed polygon; `object` fills it with the colour of object A, B, C, D, ...
    Polygon {
        /// Corners in order.
        points: Vec<[f32; 2]>,
        /// What its outline means.
        role: Role,
        /// Index of the object whose fill it wears; `None`: the role's own fill.
        object: Option<usize>,
        /// Plate inside it, where it is clear what it names.
        label: Option<Label>,
    },
    /// One pixel (cell `x..x+1`, `y..y+1`).
    Pixel {
        /// Column and row.
        at: [i32; 2],
        /// What it means; `Accepted` cells are filled, `Active` outlined, `Tie` with a diamond.
        role: Role,
        /// Index of the object whose fill it wears.
        object: Option<usize>,
        /// Value at its centre, when there is room.
        value: Value,
    },
    /// How late in the run one pixel came: the later, the stronger the shade over its fill.
    Shade {
        /// Column and row.
        at: [i32; 2],
        /// More than 0, the last is 1.
        share: f32,
    },
    /// A half-open span on the centre line of row `y`: filled end closed, ring end open.
    Span {
        /// Row.
        y: i32,
        /// Exact crossings with the left and right edge.
        ends: [f32; 2],
        /// What it means.
        role: Role,
    },
    /// A free text, such as a region code; `big` is the style of region codes. A big text with a
    /// name and a value has the value beside it, small. A text whose place is taken by another
    /// stands below that.
    Text {
        /// Where its top left corner is.
        at: [f32; 2],
        /// What is written.
        label: Label,
        /// What it means.
        role: Role,
        /// In the size of region codes.
        big: bool,
    },
    /// What a sign means in this drawing: an entry of the legend at its foot.
    Key {
        /// The role whose sign it is.
        role: Role,
        /// The role's line or its marker.
        sign: Sign,
        /// What it means here.
        meaning: Message,
    },
    /// What the readout says when the pointer is at a place; nothing is drawn.
    Hint {
        /// Where.
        at: [f32; 2],
        /// What is known there.
        text: Message,
    },
    /// Equal pixels of a row, where there are more than [`MOST_PIXELS`] for a mark each.
    Run {
        /// The row.
        y: i32,
        /// First column, and one past the last.
        columns: [i32; 2],
        /// What they mean.
        role: Role,
        /// Index of the object that they belong to.
        object: Option<usize>,
    },
    /// A picture whose pixel (0, 0) covers the cell `0..1`, `0..1`.
    Image {
        /// Width and height in pixels.
        size: [usize; 2],
        /// RGBA8, row by row from the top; its length is `4 * width * height`.
        rgba: std::sync::Arc<Vec<u8>>,
    },
    /// The numbers of a picture in its cells, where there is room for them; its shades are not drawn.
    Numbers(std::sync::Arc<Field>),
    /// What the shades of a picture mean: an entry of the legend at its foot.
    Ramp {
        /// How they look.
        tone: Tone,
        /// The numbers of the weakest and of the strongest.
        ends: [Value; 2],
        /// What they count.
        meaning: Message,
    },
    /// Thin lines, all alike: the wires of a mesh.
    Wires(std::sync::Arc<Vec<[[f32; 2]; 2]>>),
    /// Geometry in space, for a lab that has a [`Vantage`]: seen through the camera outside.
    Space(Solid),
}

/// By what a role is recognised.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// Its marker.
    Marker,
    /// Its line.
    Line,
}

/// What part of the plane an algorithm is about, and how it is laid out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Smallest coordinates that must be visible.
    pub min: [f32; 2],
    /// Largest coordinates that must be visible.
    pub max: [f32; 2],
    /// Whether larger y is higher on the screen.
    pub y_up: bool,
    /// What lines lie under the drawing.
    pub grid: Grid,
}

impl View {
    /// What the camera outside shows of a drawing in space.
    pub const SPACE: Self = Self { min: [-1.0, -1.0], max: [1.0, 1.0], y_up: true, grid: Grid::None };
}

/// Lines under a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grid {
    /// None.
    None,
    /// Unit lines of the plane.
    Units,
    /// Pixel cells with rulers.
    Pixels,
}

/// A mark on the timeline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Marker {
    /// What happened there.
    pub role: Role,
    /// Message id of a name below it; markers of small steps have none.
    pub label: Option<&'static str>,
}

/// What the window, the tour and the trace say about a run. It lives beside the algorithm.
pub trait Explain: State {
    /// The algorithm's name as on the command line.
    const NAME: &'static str;
    /// How the ids of its sentences begin; algorithms of one family share theirs.
    const PREFIX: &'static str = Self::NAME;
    /// Pseudocode, one line each, indented by two spaces a level.
    const LISTING: &'static [&'static str];
    /// The listing line (from 0) that `event` executes.
    fn line(event: &Self::Event) -> usize;
    /// How big a step `event` ends.
    fn level(event: &Self::Event) -> Level;
    /// What the event costs, with the tests before it that report nothing, as the listing states it.
    fn operations(event: &Self::Event) -> Operations;
    /// Its mark on the timeline, if it deserves one.
    fn marker(event: &Self::Event) -> Option<Marker>;
    /// The name below `event`'s marker. It may name something of the run's input, which every state
    /// of the run knows; `self` is any of them.
    fn caption(&self, event: &Self::Event) -> Option<Message> {
        Self::marker(event)?.label.map(Message::new)
    }
    /// What is about to happen: the sentence of step 0.
    fn opening(&self) -> Message;
    /// What `event` did; `self` is the state after it.
    fn sentence(&self, event: &Self::Event) -> Message;
    /// The formulas of `event`; `self` is the state after it.
    fn formulas(&self, event: &Self::Event, out: &mut Vec<Formula>);
    /// Current values, under the listing's names.
    fn tables(&self, out: &mut Vec<Table>);
    /// The drawing: input, what was done so far, and `event`, the step just taken, as active.
    fn marks(&self, event: Option<&Self::Event>, out: &mut Vec<Mark>);
    /// What part of the plane the drawing shows, always; [`View::SPACE`] if it has a vantage.
    fn view(&self) -> View;
    /// From where a drawing in space is seen first; `None` if all marks lie in the plane.
    fn vantage(&self) -> Option<Vantage> {
        None
    }
    /// Why a pixel, as column and row, is drawn in the end or not; `None` if the lab decides about none.
    fn pixel(&self, _at: [u32; 2]) -> Option<PixelReport> {
        None
    }
    /// The pixel whose fragment `event` brings; the next event is its verdict. `row`: that in hand.
    fn fragment(_event: &Self::Event, _row: &mut u32) -> Option<[u32; 2]> {
        None
    }
    /// The result so far as facts, as computed and in any order: what a comparison of two runs
    /// looks at. Every registered lab has some (tested).
    fn facts(&self, _out: &mut Vec<Fact>) {}
}
