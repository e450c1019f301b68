//! Scan conversion: which pixels a triangle covers.
//!
//! Contract of every algorithm here: the pixels whose centre (x + 0.5, y + 0.5) lies inside the
//! triangle of the given binary32 vertices, exactly, in either winding; a centre exactly on an
//! edge is decided by the [`FillRule`]. Zero area covers nothing. So the answer depends on the
//! triangle alone: not on the order of its vertices, nor on the algorithm, nor on a skip.

pub mod aabb;
pub mod backtracking;
pub(crate) mod edge;
pub mod edge_table;
pub mod homogeneous;
pub mod line;
mod mistake;
pub mod msaa;
pub mod point;
mod report;
mod samples;
pub mod scanline;
mod scissor;
pub mod tiled;
pub mod traversal;
pub(crate) mod view;
pub mod zigzag;

pub use edge::{Edge, Edges};
pub use mistake::Mistake;
pub use samples::{NoPattern, Samples, cover_samples};
pub use scissor::Scissor;

use crate::math::{Arithmetic, Tally};
use serde::{Deserialize, Serialize};

/// Who draws a pixel whose centre lies exactly on an edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FillRule {
    /// Left edges and horizontal top edges draw it: every shared edge is drawn exactly once.
    #[default]
    TopLeft,
    /// Drawn if the triangle (closed) covers the point just right of the centre; both neighbours of a horizontal
    /// edge do.
    RightOfPoint,
    /// Every edge draws it: pixels on a shared edge are drawn twice.
    Inclusive,
    /// No edge draws it: pixels on a shared edge are holes.
    Strict,
}

impl FillRule {
    /// All rules, the default first.
    pub const ALL: [Self; 4] = [Self::TopLeft, Self::RightOfPoint, Self::Inclusive, Self::Strict];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::TopLeft => "top-left",
            Self::RightOfPoint => "right-of-point",
            Self::Inclusive => "inclusive",
            Self::Strict => "strict",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::TopLeft => "word-fill-top-left",
            Self::RightOfPoint => "word-fill-right-of-point",
            Self::Inclusive => "word-fill-inclusive",
            Self::Strict => "word-fill-strict",
        }
    }

    /// The rule called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|rule| rule.name() == name)
    }
}

/// Which way y grows in screen space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum YAxis {
    /// Row 0 is the highest.
    #[default]
    Down,
    /// Row 0 is the lowest.
    Up,
}

impl YAxis {
    /// Both, the default first.
    pub const ALL: [Self; 2] = [Self::Down, Self::Up];

    /// The name in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Down => "down",
            Self::Up => "up",
        }
    }

    /// Message id of its name.
    pub fn word(self) -> &'static str {
        match self {
            Self::Down => "word-y-down",
            Self::Up => "word-y-up",
        }
    }
}

/// The algorithms of this stage.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Algorithm {
    /// Three edge functions over the bounding box: [`aabb`].
    #[default]
    Aabb,
    /// Slopes, one span a row: [`scanline`].
    Scanline,
    /// Three edge functions, row by row from the left side: [`backtracking`].
    Backtracking,
    /// Three edge functions, row by row from the middle: [`zigzag`].
    Zigzag,
    /// Three edge functions over nested squares: [`tiled`].
    Tiled,
    /// Edges in homogeneous coordinates, without a division: [`homogeneous`].
    Homogeneous,
}

impl Algorithm {
    /// Every algorithm, the default first.
    pub const ALL: [Self; 6] =
        [Self::Aabb, Self::Scanline, Self::Backtracking, Self::Zigzag, Self::Tiled, Self::Homogeneous];

    /// The name on the command line and in scene files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Aabb => "aabb",
            Self::Scanline => "scanline",
            Self::Backtracking => "backtracking",
            Self::Zigzag => "zigzag",
            Self::Tiled => "tiled",
            Self::Homogeneous => "homogeneous",
        }
    }

    /// The algorithm called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|algorithm| algorithm.name() == name)
    }
}

/// The conventions of scan conversion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Settings {
    /// Width and height of the image in pixels, each in `1..=16384`; pixels outside are left out.
    pub size: [u32; 2],
    /// Who draws a centre on an edge.
    pub fill_rule: FillRule,
    /// Which way the vertices' y and the rows grow.
    pub y_axis: YAxis,
    /// What edges are computed in. Fixed point snaps the vertices, then is exact.
    pub arithmetic: Arithmetic,
    /// The skip `row`: leave a row after its last pixel. Changes nothing but the count.
    pub skip_row: bool,
    /// What is got wrong on purpose.
    pub mistake: Option<Mistake>,
}

impl Settings {
    /// Exact, top-left, y down, with every skip on.
    pub fn new(size: [u32; 2]) -> Self {
        Self {
            size,
            fill_rule: FillRule::default(),
            y_axis: YAxis::default(),
            arithmetic: Arithmetic::default(),
            skip_row: true,
            mistake: None,
        }
    }

    /// The vertices that are rasterized: as given, snapped by fixed point, or whole by mistake.
    pub fn vertices(&self, vertices: [[f32; 2]; 3]) -> [[f32; 2]; 3] {
        vertices.map(|vertex| {
            vertex.map(|coordinate| match self.mistake {
                Some(Mistake::WholeVertices) => coordinate.trunc() + 0.0,
                _ => self.arithmetic.snap(coordinate),
            })
        })
    }

    /// How far from zero an edge function counts as zero, by mistake.
    pub(crate) fn epsilon(&self) -> Option<f64> {
        self.mistake.and_then(Mistake::epsilon)
    }

    /// Whether the scan line adds slopes up from row to row.
    pub(crate) fn accumulates(&self) -> bool {
        !self.arithmetic.is_exact() || self.mistake == Some(Mistake::AccumulatedSlopes)
    }
}

/// Pixels `begin..end` of a row; never empty.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Span {
    /// Row, counted along the y axis of the [`Settings`].
    pub y: u32,
    /// First column.
    pub begin: u32,
    /// One past the last column.
    pub end: u32,
}

impl Span {
    /// Number of pixels.
    #[inline]
    pub fn len(&self) -> u32 {
        self.end - self.begin
    }

    /// Whether there is no pixel; no algorithm here emits such a span.
    #[inline]
    pub fn is_empty(&self) -> bool {
        self.end == self.begin
    }
}

/// What a rasterizer did for its answer, in pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Centres compared with an edge.
    pub tested: u64,
    /// Pixels covered.
    pub covered: u64,
    /// Pixels of the bounding box that the skip `row` left untested.
    pub skipped: u64,
}

impl std::ops::AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.tested += other.tested;
        self.covered += other.covered;
        self.skipped += other.skipped;
    }
}

/// Finds the pixels that a triangle covers, as spans, at most one a row, in no particular order.
///
/// Vertices are in pixels, centres at + 0.5; any finite coordinates, either winding, on or off
/// the image. Zero area covers nothing. `tally` counts the signs asked for. Cost: see the
/// algorithms' own files; about 10 ns a row at best.
pub fn cover(
    algorithm: Algorithm,
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
    emit: &mut impl FnMut(Span),
) -> Counts {
    match algorithm {
        Algorithm::Aabb => aabb::fill(vertices, settings, tally, emit),
        Algorithm::Scanline => scanline::fill(vertices, settings, tally, emit),
        Algorithm::Backtracking => {
            traversal::fill::<backtracking::Backtracking>(vertices, settings, tally, emit)
        }
        Algorithm::Zigzag => traversal::fill::<zigzag::Zigzag>(vertices, settings, tally, emit),
        Algorithm::Tiled => traversal::fill::<tiled::Tiled>(vertices, settings, tally, emit),
        Algorithm::Homogeneous => {
            let vertices = settings.vertices(vertices).map(|[x, y]| [x, y, 1.0]);
            homogeneous::fill(vertices, None, settings, tally, emit)
        }
    }
}

/// The spans of [`cover`], sorted by row.
pub fn rows(
    algorithm: Algorithm,
    vertices: [[f32; 2]; 3],
    settings: &Settings,
    tally: &mut Tally,
) -> Vec<Span> {
    let mut spans = Vec::new();
    cover(algorithm, vertices, settings, tally, &mut |span| spans.push(span));
    spans.sort_unstable_by_key(|span| span.y);
    spans
}

/// The first integer `n >= at` whose centre `n + 0.5` lies at or beyond `coordinate`, or only
/// beyond it if `open`; kept within `0..=limit`.
///
/// Exact for every f32, infinities included; a NaN gives 0.
#[inline]
pub(crate) fn first_centre(coordinate: f64, open: bool, limit: u32) -> u32 {
    let limit = i64::from(limit);
    // Without a call where the processor has no instruction for floor and ceil.
    let shifted = (coordinate - 0.5).clamp(-1.0, limit as f64 + 1.0);
    let toward_zero = shifted as i64;
    let back = toward_zero as f64;
    let first =
        if open { toward_zero + i64::from(back <= shifted) } else { toward_zero + i64::from(back < shifted) };
    first.clamp(0, limit) as u32
}
