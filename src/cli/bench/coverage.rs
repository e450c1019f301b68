//! Scan conversion: every algorithm in every arithmetic.

use rasterscope_core::{
    math::{Arithmetic, Tally},
    raster::{Algorithm, Settings, Span, rows},
};

use super::{
    family::Family,
    race::{Answer, Contender, Errors, Heat, Row},
    random::Random,
};

pub(super) const STAGE: &str = "coverage";
pub(super) const FAMILIES: &[Family] =
    &[Family::Ordinary, Family::Beside, Family::Sliver, Family::Huge, Family::Denormal, Family::Long];

const COUNT: usize = 64;
const SIDE: u32 = 96;

pub(super) type Triangle = [[f32; 2]; 3];

/// The covered pixels, sorted by row.
pub(super) struct Pixels(Vec<Span>);

impl Answer for Pixels {
    /// Each pixel that either covers is a decision.
    fn judge(&self, exact: &Self, errors: &mut Errors) {
        let pixels = |spans: &[Span]| spans.iter().map(|span| u64::from(span.len())).sum::<u64>();
        let (found, right) = (pixels(&self.0), pixels(&exact.0));
        let mut common = 0;
        let mut others = exact.0.iter().peekable();
        for span in &self.0 {
            while others.next_if(|other| other.y < span.y).is_some() {}
            if let Some(other) = others.peek().filter(|other| other.y == span.y) {
                common += u64::from(span.end.min(other.end).saturating_sub(span.begin.max(other.begin)));
            }
        }
        errors.decisions(found + right - common, found + right - 2 * common);
    }
}

pub(super) fn size(family: Family) -> [u32; 2] {
    if family == Family::Long { [32, 4_096] } else { [SIDE; 2] }
}

pub(super) fn triangles(family: Family, count: usize) -> Vec<Triangle> {
    let mut random = Random::new(300 + family as u64);
    (0..count).map(|_| triangle(family, &mut random)).collect()
}

fn triangle(family: Family, random: &mut Random) -> Triangle {
    let [width, height] = size(family).map(f64::from);
    let mut vertices: Triangle =
        std::array::from_fn(|_| [random.uniform(0.0, width), random.uniform(0.0, height)]);
    match family {
        Family::Beside => {
            vertices = vertices.map(|vertex| vertex.map(|x| random.beside(x.floor() + 0.5)));
        }
        // Along a diagonal through centres: elsewhere hardly one covers a pixel.
        Family::Sliver => {
            let start = vertices[0].map(|x| x.floor() + 0.5);
            let length = random.uniform(8.0, 64.0).floor();
            let along = [length * random.pick(&[-1.0, 1.0]), length];
            let t = random.uniform(0.2, 0.8);
            vertices = [0.0, 1.0, t].map(|t| [0, 1].map(|i| start[i] + t * along[i]));
            vertices[2] = vertices[2].map(|x| random.beside(x));
        }
        // One vertex stays in the image.
        Family::Huge => {
            vertices[1] = [0, 1].map(|_| random.magnitude(20.0, 38.0));
            vertices[2] = [0, 1].map(|i| -vertices[1][i] * random.uniform(0.5, 2.0));
        }
        // Around the image's corner, but for next to nothing.
        Family::Denormal => {
            vertices[0] = [0, 1].map(|_| random.magnitude(-44.0, -38.0));
            let d = random.uniform(0.5, 1.0) * width as f32;
            vertices[1] = [d, d + random.magnitude(-44.0, -38.0)];
        }
        Family::Long => {
            vertices[0][1] = random.uniform(0.0, 8.0);
            vertices[2][1] = random.uniform(height - 8.0, height);
        }
        _ => {}
    }
    vertices
}

pub(super) fn run(family: Family, rounds: u32) -> Vec<Row> {
    let triangles = &triangles(family, COUNT);
    let settings = |arithmetic| Settings { arithmetic, ..Settings::new(size(family)) };
    let mut contenders = Vec::new();
    for algorithm in Algorithm::ALL {
        for arithmetic in Arithmetic::ALL {
            let settings = settings(arithmetic);
            contenders.push(Contender::text(
                algorithm.name(),
                arithmetic,
                triangles,
                move |vertices, tally| Pixels(rows(algorithm, *vertices, &settings, tally)),
            ));
        }
    }
    // Turned round: an exact answer does not depend on the winding.
    let exact = |[a, b, c]: &Triangle| {
        Pixels(rows(Algorithm::Scanline, [*c, *b, *a], &settings(Arithmetic::Exact), &mut Tally::default()))
    };
    let exact = triangles.iter().map(exact).collect();
    Heat { stage: STAGE, family, items: COUNT, item: "triangle", contenders, exact }.run(rounds)
}
