//! Hidden surfaces in object space: every pair of triangles is compared, and what one hides of the other is
//! cut away. k triangles make k (k - 1) / 2 pairs, however few pixels they cover.
//!
//! *Source:* Sutherland, Sproull and Schumacker, A Characterization of Ten Hidden-Surface Algorithms, ACM
//! Computing Surveys 1974 (object space); Weiler and Atherton, Hidden Surface Removal Using Polygon Area
//! Sorting, SIGGRAPH 1977 (what is left are polygons). Deviation: parts are kept convex by cutting along the
//! lines of the hiding polygon's sides, in binary64; where two triangles pass through each other, they are
//! first cut along the line of equal depth.

/// A triangle on the screen: x and y in pixels, and a depth, smaller nearer; finite.
pub type Triangle = [[f32; 3]; 3];

/// A convex polygon, turned so that its area is positive.
pub type Part = Vec<[f64; 2]>;

/// How the triangles of a pair lie to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The first hides the second.
    Hides,
    /// The second hides the first.
    IsHidden,
    /// Their projections have no area in common: both are seen.
    Apart,
    /// One hides a part of the other, or each of the other.
    Partly,
}

/// How many pairs had which relation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// One of them hides all of the other.
    pub hidden: u64,
    /// They hide nothing of each other.
    pub apart: u64,
    /// A part is hidden.
    pub partly: u64,
}

impl Counts {
    /// How many pairs were compared.
    pub fn pairs(&self) -> u64 {
        self.hidden + self.apart + self.partly
    }
}

/// What is seen of each triangle, as convex parts that do not overlap.
///
/// Either winding; of a triangle without area nothing is seen, and it hides nothing. In binary64, so that
/// corners are off by about 1e-13 of the coordinates' size. Cost: about 50 ns a pair that is apart, 1 us and
/// more, by the number of parts, where something is hidden.
pub fn visible_parts(triangles: &[Triangle]) -> (Vec<Vec<Part>>, Counts) {
    let outlines: Vec<Part> = triangles.iter().map(outline).collect();
    let mut seen: Vec<Vec<Part>> = outlines.iter().map(|outline| vec![outline.clone()]).collect();
    seen.iter_mut().for_each(|parts| parts.retain(|part| !part.is_empty()));
    let mut counts = Counts::default();
    for i in 0..triangles.len() {
        for j in i + 1..triangles.len() {
            let pair = compare([&outlines[i], &outlines[j]], [&triangles[i], &triangles[j]]);
            match pair.relation {
                Relation::Apart => counts.apart += 1,
                Relation::Partly => counts.partly += 1,
                Relation::Hides | Relation::IsHidden => counts.hidden += 1,
            }
            for (hidden, of) in pair.hidden.iter().zip([i, j]) {
                if !hidden.is_empty() {
                    seen[of] = seen[of].iter().flat_map(|part| without(part, hidden)).collect();
                }
            }
        }
    }
    (seen, counts)
}

/// The relation of two triangles on the screen.
pub fn relation(first: &Triangle, second: &Triangle) -> Relation {
    compare([&outline(first), &outline(second)], [first, second]).relation
}

/// A pair, and what is hidden of each by the other.
struct Pair {
    relation: Relation,
    hidden: [Part; 2],
}

fn compare(outlines: [&Part; 2], triangles: [&Triangle; 2]) -> Pair {
    let apart = Pair { relation: Relation::Apart, hidden: [Part::new(), Part::new()] };
    if !boxes_meet(outlines) {
        return apart;
    }
    let common = common(outlines[0], outlines[1]);
    if common.is_empty() {
        return apart;
    }
    let [first, second] = triangles.map(plane);
    // How much nearer the first one is; linear, so that where it is 0 is a line.
    let nearer =
        |[x, y]: [f64; 2]| (second[0] - first[0]) * x + (second[1] - first[1]) * y + (second[2] - first[2]);
    // Of equal depths the first one's is seen.
    let is_first = common.iter().all(|p| nearer(*p) >= 0.0);
    let behind = if is_first { Part::new() } else { cut(&common, |p| -nearer(p)) };
    let hidden = [behind, cut(&common, nearer)];
    let is_all = |hidden: &Part, outline: &Part| area(hidden) >= area(outline) * (1.0 - 1e-12);
    let relation = match [0, 1].map(|i| is_all(&hidden[i], outlines[i])) {
        [_, true] if hidden[0].is_empty() => Relation::Hides,
        [true, _] if hidden[1].is_empty() => Relation::IsHidden,
        _ => Relation::Partly,
    };
    Pair { relation, hidden }
}

/// The projection, turned so that its area is positive; empty if it has none.
fn outline(triangle: &Triangle) -> Part {
    let mut points: Part = triangle.iter().map(|[x, y, _]| [f64::from(*x), f64::from(*y)]).collect();
    match area(&points) {
        0.0 => return Part::new(),
        area if area < 0.0 => points.reverse(),
        _ => {}
    }
    points
}

/// A, B and C of the depth A x + B y + C.
fn plane(triangle: &Triangle) -> [f64; 3] {
    let [[x0, y0, z0], [x1, y1, z1], [x2, y2, z2]] = triangle.map(|vertex| vertex.map(f64::from));
    let area = (x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0);
    let a = ((z1 - z0) * (y2 - y0) - (z2 - z0) * (y1 - y0)) / area;
    let b = ((z2 - z0) * (x1 - x0) - (z1 - z0) * (x2 - x0)) / area;
    [a, b, z0 - a * x0 - b * y0]
}

/// Twice the area; negative if the polygon is turned the other way.
fn area(points: &[[f64; 2]]) -> f64 {
    let Some(&[ox, oy]) = points.first() else { return 0.0 };
    let pairs = points.iter().zip(points.iter().skip(1));
    pairs.map(|([ax, ay], [bx, by])| (ax - ox) * (by - oy) - (ay - oy) * (bx - ox)).sum()
}

fn boxes_meet([first, second]: [&Part; 2]) -> bool {
    let range = |part: &Part, axis: usize| {
        part.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[axis]), high.max(point[axis])]
        })
    };
    [0, 1].into_iter().all(|axis| {
        let ([a, b], [c, d]) = (range(first, axis), range(second, axis));
        a < d && c < b
    })
}

/// On which side of a line a point lies: positive is to the left of it from `a` to `b`.
fn side([ax, ay]: [f64; 2], [bx, by]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    (bx - ax) * (y - ay) - (by - ay) * (x - ax)
}

/// The part of a convex polygon where a linear function is not negative; empty if it has no area.
fn cut(part: &[[f64; 2]], value: impl Fn([f64; 2]) -> f64) -> Part {
    let mut kept = Part::with_capacity(part.len() + 1);
    for (i, &to) in part.iter().enumerate() {
        let from = part[(i + part.len() - 1) % part.len()];
        let (at_from, at_to) = (value(from), value(to));
        if (at_from < 0.0) != (at_to < 0.0) {
            let t = at_from / (at_from - at_to);
            kept.push([0, 1].map(|axis| from[axis] + t * (to[axis] - from[axis])));
        }
        if at_to >= 0.0 {
            kept.push(to);
        }
    }
    if area(&kept) > 0.0 { kept } else { Part::new() }
}

/// What two convex polygons have in common.
fn common(first: &[[f64; 2]], second: &[[f64; 2]]) -> Part {
    sides(second).fold(first.to_vec(), |part, [a, b]| cut(&part, |p| side(a, b, p)))
}

/// What is left of a convex polygon outside another one, in convex parts.
fn without(part: &Part, hidden: &Part) -> Vec<Part> {
    if !boxes_meet([part, hidden]) || common(part, hidden).is_empty() {
        return vec![part.clone()];
    }
    let mut left = Vec::new();
    let mut rest = part.clone();
    for [a, b] in sides(hidden) {
        left.push(cut(&rest, |p| -side(a, b, p)));
        rest = cut(&rest, |p| side(a, b, p));
    }
    left.retain(|part| !part.is_empty());
    left
}

fn sides(part: &[[f64; 2]]) -> impl Iterator<Item = [[f64; 2]; 2]> {
    part.iter().zip(part.iter().cycle().skip(1)).map(|(a, b)| [*a, *b])
}
