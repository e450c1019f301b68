//! Meshes against exact coverage: vertices are projected in binary64, once for all painters, and a pixel so near an
//! edge that this rounding could matter counts for nobody. So what a painter rounds on the way to the screen counts
//! as wrong, too.

use super::{SIZE, Sight};
use crate::{
    coverage::{Facet, PIXEL, Wrong, apart},
    painter::Painter,
};
use rasterscope_core::scene::Mesh;
use std::sync::Arc;

/// What is wrong with a painter's images.
#[derive(Default)]
pub struct Found {
    wrong: Wrong,
    pixels: usize,
    off: usize,
}

/// More than so many codes away, a colour is another one.
const FAR: i32 = 4;

impl Found {
    pub const HEADINGS: [&str; 4] = ["wrong ppm", "holes", "doubles", "off ppm"];

    /// In the order of the headings.
    pub fn counts(&self) -> Vec<String> {
        let off = self.off as f64 * 1e6 / self.pixels as f64;
        let Wrong { holes, doubles, .. } = self.wrong;
        vec![format!("{:.0}", self.wrong.ppm()), holes.to_string(), doubles.to_string(), format!("{off:.0}")]
    }

    /// Lets a painter draw, for each eye, parts of the mesh in which no two triangles touch; then all of it.
    pub fn examine(&mut self, painter: &mut dyn Painter<Sight>, sight: &Sight) {
        for (camera, matrix) in sight.cameras.iter().zip(sight.matrices()) {
            let one = Sight { mesh: Arc::clone(&sight.mesh), cameras: vec![*camera] };
            let screen = Screen::new(&one.mesh, &matrix);
            self.examine_parts(painter, &one, &screen);
            let drawn = draw(painter, &one);
            for (drawn, exact) in drawn.into_iter().zip(screen.picture(&one.mesh)) {
                let [drawn_codes, exact_codes] = [drawn, exact].map(u32::to_ne_bytes);
                let differences = drawn_codes.into_iter().zip(exact_codes);
                let far = differences.map(|(a, b)| (i32::from(a) - i32::from(b)).abs()).any(|d| d > FAR);
                self.pixels += usize::from(exact != 0);
                self.off += usize::from(far);
            }
        }
    }

    fn examine_parts(&mut self, painter: &mut dyn Painter<Sight>, sight: &Sight, screen: &Screen) {
        let [width, height] = SIZE;
        let mut hits = vec![[0_u16; 2]; width * height];
        for group in apart(&screen.facets, SIZE, usize::MAX) {
            let triangles = group.iter().map(|&i| sight.mesh.triangles[i]).collect();
            let mesh = Arc::new(Mesh { triangles, ..Mesh::clone(&sight.mesh) });
            let drawn = draw(painter, &Sight { mesh, cameras: sight.cameras.clone() });
            for &i in &group {
                self.wrong.compare(&screen.facets[i], SIZE, &drawn, |at, covered, drawn| {
                    hits[at][0] += u16::from(covered);
                    hits[at][1] += u16::from(drawn);
                });
            }
        }
        // Along an outline, how often a pixel is drawn depends on where the outline was rounded to.
        for y in 1..height - 1 {
            for x in 1..width - 1 {
                let [exact, drawn] = hits[y * width + x];
                let mut around = (y - 1..y + 2).flat_map(|y| (x - 1..x + 2).map(move |x| y * width + x));
                if around.all(|at| hits[at][0] == exact) {
                    self.wrong.holes += usize::from(drawn < exact);
                    self.wrong.doubles += usize::from(drawn > exact);
                }
            }
        }
    }
}

fn draw(painter: &mut dyn Painter<Sight>, sight: &Sight) -> Vec<u32> {
    painter.take(sight);
    painter.draw();
    painter.colors()
}

/// The mesh as an eye sees it.
struct Screen {
    /// x and y in pixels, y down; depth; 1/w.
    vertices: Vec<[f64; 4]>,
    facets: Vec<Facet>,
}

impl Screen {
    fn new(mesh: &Mesh, matrix: &[[f64; 4]; 4]) -> Self {
        let project = |p: &[f32; 3]| {
            let [x, y, z] = p.map(f64::from);
            let [x, y, z, w] = matrix.map(|[a, b, c, d]| a * x + b * y + c * z + d);
            let [width, height] = SIZE.map(|n| n as f64);
            [(x / w + 1.0) / 2.0 * width, (1.0 - y / w) / 2.0 * height, z / w, 1.0 / w]
        };
        let vertices: Vec<_> = mesh.positions.iter().map(project).collect();
        let units = |i: u32| [0, 1].map(|axis| (vertices[i as usize][axis] * PIXEL).round() as i128);
        // Some ten roundings of numbers below 2^11, and one to a whole unit: less than a hundred units of 2^-34.
        let facet = |triangle: &[u32; 3]| Facet { corners: triangle.map(units), slack: 128, culled: true };
        let facets = mesh.triangles.iter().map(facet).collect();
        Self { vertices, facets }
    }

    /// The colours that are seen, to within a code; 0 where there is nothing.
    fn picture(&self, mesh: &Mesh) -> Vec<u32> {
        let mut seen = vec![(f64::INFINITY, 0); SIZE[0] * SIZE[1]];
        for (facet, triangle) in self.facets.iter().zip(&mesh.triangles) {
            let corners = triangle.map(|i| self.vertices[i as usize]);
            let colors = triangle.map(|i| mesh.colors[i as usize].map(f64::from));
            let [columns, rows] = facet.around(SIZE);
            for [x, y] in rows.flat_map(|y| columns.clone().map(move |x| [x, y])) {
                if facet.covers([x, y]) != Some(true) {
                    continue;
                }
                let weights = weights(&corners, [x, y].map(|n| n as f64 + 0.5));
                let mean = |values: [f64; 3], weights: [f64; 3]| {
                    let sum: f64 = values.iter().zip(weights).map(|(value, weight)| value * weight).sum();
                    sum / weights.iter().sum::<f64>()
                };
                let depth = mean(corners.map(|corner| corner[2]), weights);
                let at = &mut seen[y * SIZE[0] + x];
                if depth < at.0 {
                    let weights = [0, 1, 2].map(|i| weights[i] * corners[i][3]);
                    let code = |channel: usize| {
                        (255.0 * mean(colors.map(|color| color[channel]), weights) + 0.5) as u8
                    };
                    *at = (depth, u32::from_ne_bytes([0, 1, 2, 3].map(code)));
                }
            }
        }
        seen.into_iter().map(|(_, color)| color).collect()
    }
}

/// The areas opposite to each corner.
fn weights(corners: &[[f64; 4]; 3], [x, y]: [f64; 2]) -> [f64; 3] {
    [[1, 2], [2, 0], [0, 1]].map(|[i, j]| {
        let ([ax, ay, ..], [bx, by, ..]) = (corners[i], corners[j]);
        (bx - ax) * (y - ay) - (by - ay) * (x - ax)
    })
}
