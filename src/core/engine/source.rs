//! Where triangles come from: a list of them with a colour each, or a mesh with a colour at each vertex.

use super::{
    Triangles,
    group::{Entry, Group},
    lanes::{LANES, larger},
};
use wide::f32x4;

/// Triangles by their numbers.
pub(super) trait Source: Sync {
    /// How many there are.
    fn count(&self) -> usize;

    /// The vertices of one: x and y in pixels, depth, and anything; not numbers if there is none.
    fn vertices(&self, triangle: usize) -> [f32x4; 3];

    /// What is kept of one for a tile.
    fn entry(&self, triangle: usize, numbered: bool) -> Entry;

    /// Which of a few triangles, from one on, are not drawn since they are seen from the wrong side.
    #[inline(always)]
    fn averted(&self, _first: usize, _group: &Group) -> [bool; LANES] {
        [false; LANES]
    }
}

impl Source for Triangles<'_> {
    fn count(&self) -> usize {
        self.len()
    }

    #[inline(always)]
    fn vertices(&self, triangle: usize) -> [f32x4; 3] {
        match self.indices {
            None => {
                let first = 3 * triangle;
                [self.vertex(first), self.vertex(first + 1), self.vertex(first + 2)]
            }
            Some(indices) => match indices.get(triangle) {
                Some(&[a, b, c]) => {
                    [self.vertex(a as usize), self.vertex(b as usize), self.vertex(c as usize)]
                }
                None => [NOWHERE; 3],
            },
        }
    }

    #[inline(always)]
    fn entry(&self, triangle: usize, numbered: bool) -> Entry {
        let position = |index: u32| self.positions.get(index as usize).copied().unwrap_or([f32::NAN; 3]);
        let corners = match self.indices {
            None => self.positions.as_chunks().0.get(triangle).copied().unwrap_or([[f32::NAN; 3]; 3]),
            Some(indices) => match indices.get(triangle) {
                Some(&[a, b, c]) => [position(a), position(b), position(c)],
                None => [[f32::NAN; 3]; 3],
            },
        };
        Entry::new(corners, if numbered { triangle as u32 + 1 } else { self.color(triangle) })
    }
}

/// A vertex that is not there.
const NOWHERE: f32x4 = f32x4::new([f32::NAN; 4]);

impl Triangles<'_> {
    #[inline(always)]
    fn vertex(&self, index: usize) -> f32x4 {
        // Four numbers at once, except of the last vertex.
        match self.positions.as_flattened().get(3 * index..).and_then(|numbers| numbers.first_chunk()) {
            Some(numbers) => f32x4::new(*numbers),
            None => self.last_vertex(index),
        }
    }

    #[cold]
    #[inline(never)]
    fn last_vertex(&self, index: usize) -> f32x4 {
        self.positions.get(index).map_or(NOWHERE, |[x, y, z]| f32x4::new([*x, *y, *z, 0.0]))
    }
}

/// Decides for a mesh where an error leaves two answers.
pub(crate) trait Arbiter: Sync {
    /// Whether a triangle is seen from the side that is drawn.
    fn faces(&self, triangle: u32) -> bool;

    /// The colour codes of a pixel of a triangle.
    fn color(&self, triangle: u32, pixel: [u32; 2]) -> [u8; 4];
}

/// A vertex on the screen. What belongs together is fetched together.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(32))]
pub(crate) struct Vertex {
    /// x and y in pixels, depth, 1/w.
    pub(crate) place: [f32; 4],
    /// Red, green, blue, alpha, from 0 to 1.
    pub(crate) color: [f32; 4],
}

/// Where the colours of a mesh lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Range {
    /// Whether all of them are from 0 to 1.
    pub(crate) unit: bool,
    /// Whether all alphas are 1.
    pub(crate) opaque: bool,
}

impl Range {
    /// That of some colours.
    pub(crate) fn of(colors: &[[f32; 4]]) -> Self {
        let unit = |color: &[f32; 4]| color.iter().all(|value| (0.0..=1.0).contains(value));
        Self { unit: colors.iter().all(unit), opaque: colors.iter().all(|color| color[3] == 1.0) }
    }
}

/// A mesh on the screen, all of it before the eye; colours are interpolated perspectively.
pub(crate) struct Mesh<'m, A: Arbiter> {
    pub(crate) vertices: &'m [Vertex],
    /// Indices of vertices.
    pub(crate) triangles: &'m [[u32; 3]],
    /// Which turning sense is drawn, that of rows of positive x into positive y or the other; `None` is both.
    pub(crate) turn: Option<f32>,
    /// How far off a coordinate is at most, in pixels, of where the vertex is seen exactly.
    pub(crate) blur: f32,
    pub(crate) range: Range,
    pub(crate) arbiter: &'m A,
}

impl<A: Arbiter> Mesh<'_, A> {
    /// The corners of a triangle: their 1/w, and their colours.
    #[inline(always)]
    pub(super) fn corners(&self, triangle: usize) -> ([f32; 3], [f32x4; 3]) {
        let Some(&[a, b, c]) = self.triangles.get(triangle) else { return ([0.0; 3], [f32x4::ZERO; 3]) };
        let (a, b, c) = (self.vertex(a), self.vertex(b), self.vertex(c));
        let colors = [f32x4::new(a.color), f32x4::new(b.color), f32x4::new(c.color)];
        ([a.place[3], b.place[3], c.place[3]], colors)
    }

    #[inline(always)]
    fn vertex(&self, index: u32) -> &Vertex {
        self.vertices.get(index as usize).unwrap_or(&NO_VERTEX)
    }

    /// Asks for the corners of a triangle that will be needed soon, and for the indices of one that is needed later.
    #[inline(always)]
    pub(super) fn fetch(&self, soon: usize, later: usize) {
        #[cfg(target_arch = "x86_64")]
        {
            for index in self.triangles.get(soon).into_iter().flatten() {
                self.vertices.get(*index as usize).into_iter().for_each(safe_arch::prefetch_t0);
            }
            self.triangles.get(later).into_iter().for_each(safe_arch::prefetch_t0);
        }
    }
}

/// A vertex that is not there.
static NO_VERTEX: Vertex = Vertex { place: [f32::NAN; 4], color: [0.0; 4] };

impl<A: Arbiter> Source for Mesh<'_, A> {
    fn count(&self) -> usize {
        self.triangles.len()
    }

    #[inline(always)]
    fn vertices(&self, triangle: usize) -> [f32x4; 3] {
        let Some(&[a, b, c]) = self.triangles.get(triangle) else { return [NOWHERE; 3] };
        let (a, b, c) = (self.vertex(a), self.vertex(b), self.vertex(c));
        [f32x4::new(a.place), f32x4::new(b.place), f32x4::new(c.place)]
    }

    #[inline(always)]
    fn entry(&self, triangle: usize, _: bool) -> Entry {
        let corner = |vertex: f32x4| {
            let [x, y, z, _] = vertex.to_array();
            [x, y, z]
        };
        let [a, b, c] = self.vertices(triangle);
        Entry::new([corner(a), corner(b), corner(c)], triangle as u32 + 1)
    }

    /// A determinant `l - r` of differences is off by at most `4u (|l| + |r|)`, and by what its coordinates are.
    #[inline(always)]
    fn averted(&self, first: usize, group: &Group) -> [bool; LANES] {
        const U: f32 = f32::EPSILON / 2.0;
        let mut averted = [false; LANES];
        let (turn, sided) = (self.turn.unwrap_or(1.0), self.turn.is_some());
        let [[ax, ay, _], [bx, by, _], [cx, cy, _]] = &group.corners;
        let mut open = [false; LANES];
        for i in 0..LANES {
            let (bx, by, cx, cy) = (bx[i] - ax[i], by[i] - ay[i], cx[i] - ax[i], cy[i] - ay[i]);
            let (l, r) = (bx * cy, by * cx);
            let widest = larger(larger(bx.abs(), by.abs()), larger(cx.abs(), cy.abs()));
            let error = 5.0 * U * (l.abs() + r.abs()) + 9.0 * self.blur * (widest + self.blur);
            let area = (l - r) * turn;
            averted[i] = sided & (area < -error);
            open[i] = area.abs() <= error;
        }
        if open.iter().any(|&open| open) {
            for i in 0..LANES {
                if open[i] && first + i < self.triangles.len() {
                    averted[i] = !self.arbiter.faces((first + i) as u32);
                }
            }
        }
        averted
    }
}
