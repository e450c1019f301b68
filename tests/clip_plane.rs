//! A triangle against one plane: laws, golden logs, an exact oracle, and the sibling with six planes.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    clip::polygon::clip_plane::{self as cp, Corner, Event, HalfSpace, Outcome, Snapshot},
    math::{Arithmetic, Dyadic, Sign, Tally},
};

type Vertices = [[f32; 3]; 3];

const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64];
const TRIANGLE: Vertices = [[-1.5, -0.5, 1.0], [2.5, -1.0, 0.0], [0.5, 2.0, -1.0]];

fn at_x(x: f32, inwards: f32) -> HalfSpace {
    HalfSpace { point: [x, 0.0, 0.0], normal: [inwards, 0.0, 0.0] }
}

fn run(vertices: Vertices, plane: HalfSpace, arithmetic: Arithmetic) -> (Outcome, Vec<Event>) {
    let mut events = Vec::new();
    let outcome = cp::clip_traced(vertices, plane, arithmetic, &mut Tally::default(), &mut events);
    (outcome, events)
}

#[track_caller]
fn check(name: &str, vertices: Vertices, plane: HalfSpace) {
    let (_, events) = run(vertices, plane, Arithmetic::Exact);
    check_golden(&format!("clip_plane/{name}"), &log_text(&events));
}

#[test]
fn three_inside_stay() {
    check("three_in", TRIANGLE, at_x(3.0, -1.0));
}

#[test]
fn none_inside_leaves_nothing() {
    check("none_in", TRIANGLE, at_x(-2.0, -1.0));
}

#[test]
fn one_inside_leaves_one_triangle() {
    check("one_in", TRIANGLE, at_x(1.0, 1.0));
}

#[test]
fn two_inside_leave_two_triangles() {
    check("two_in", TRIANGLE, at_x(1.0, -1.0));
}

#[test]
fn a_vertex_on_the_plane_is_inside() {
    check("vertex_on_it", [[-1.5, -0.5, 1.0], [2.5, -1.0, 0.0], [1.0, 2.0, -1.0]], at_x(1.0, -1.0));
}

fn input(random: &mut Random) -> (Vertices, HalfSpace) {
    let family = random.below(4);
    let mut number = || match family {
        0 => random.below(5) as f32 - 2.0,
        1 => random.grid(-3, 3),
        2 => {
            let border = random.pick(&[1.0, 0.5, -1.0]);
            random.near(border)
        }
        _ => random.uniform(-5.0, 5.0),
    };
    let vertices = [0; 3].map(|_| [0; 3].map(|_| number()));
    let plane = HalfSpace { point: [0; 3].map(|_| number()), normal: [0; 3].map(|_| number()) };
    (vertices, plane)
}

/// The exact distance of a vertex.
fn distance(vertex: [f32; 3], plane: HalfSpace) -> Dyadic {
    let term = |axis: usize| {
        (Dyadic::from(vertex[axis]) - Dyadic::from(plane.point[axis])) * Dyadic::from(plane.normal[axis])
    };
    term(0) + term(1) + term(2)
}

/// Where the edge between two vertices on different sides crosses the plane, rounded once.
fn crossing(vertices: &Vertices, d: &[Dyadic; 3], a: usize, b: usize) -> [f32; 3] {
    [0, 1, 2].map(|axis| {
        let [va, vb] = [a, b].map(|i| Dyadic::from(vertices[i][axis]));
        Dyadic::ratio_to_f32(&(&d[b] * &va - &d[a] * &vb), &(&d[b] - &d[a]))
    })
}

#[test]
fn agrees_with_the_exact_oracle() {
    let mut random = Random::new(21);
    let mut counts = [0; 4];
    for _ in 0..30_000 {
        let (vertices, plane) = input(&mut random);
        let d = vertices.map(|vertex| distance(vertex, plane));
        let inside = [0, 1, 2].map(|i| d[i].sign() != Sign::Negative);
        let count = inside.iter().filter(|inside| **inside).count();
        counts[count] += 1;
        let Outcome { new, triangles } = cp::clip(vertices, plane, Arithmetic::Exact);
        let mut expected: Vec<[u32; 3]> = Vec::new();
        for i in 0..3 {
            let j = (i + 1) % 3;
            if inside[i] != inside[j] {
                let (a, b) = if inside[i] { (i, j) } else { (j, i) };
                expected.push(crossing(&vertices, &d, a, b).map(f32::to_bits));
            }
        }
        let mut found: Vec<_> = new.iter().map(|at| at.map(|c| (c + 0.0).to_bits())).collect();
        expected.sort_unstable();
        found.sort_unstable();
        assert_eq!(found, expected, "{vertices:?} {plane:?}");
        // A triangle for the one inside, two for two, less those that a vertex on the plane makes flat.
        let on_plane = (0..3).filter(|&i| d[i].is_zero()).count();
        let made = if count == 3 { 1 } else { count - on_plane };
        assert_eq!(triangles.len(), made, "{vertices:?} {plane:?}");
    }
    assert!(counts.iter().all(|&count| count > 1_000), "{counts:?}");
}

/// The triangles, corner by corner.
fn places(vertices: &Vertices, outcome: &Outcome) -> Vec<[[f32; 3]; 3]> {
    let at = |corner: Corner| match corner {
        Corner::Vertex(i) => vertices[usize::from(i)],
        Corner::New(i) => outcome.new[usize::from(i)],
    };
    outcome.triangles.iter().map(|corners| corners.map(at)).collect()
}

fn area(triangle: &[[f32; 3]; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|p| p.map(f64::from));
    let [u, v] = [b, c].map(|p| [0, 1, 2].map(|axis| p[axis] - a[axis]));
    [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
}

#[test]
fn both_sides_of_a_plane_make_up_the_triangle() {
    let mut random = Random::new(22);
    for _ in 0..5_000 {
        let vertices = [0; 3].map(|_| [0; 3].map(|_| random.uniform(-5.0, 5.0)));
        let plane = HalfSpace { point: [0.0; 3], normal: [0; 3].map(|_| random.uniform(-1.0, 1.0)) };
        let other = HalfSpace { normal: plane.normal.map(|n| -n), ..plane };
        let mut sum = [0.0; 3];
        for plane in [plane, other] {
            let outcome = cp::clip(vertices, plane, Arithmetic::Exact);
            for triangle in places(&vertices, &outcome) {
                for (sum, part) in sum.iter_mut().zip(area(&triangle)) {
                    *sum += part;
                }
            }
        }
        for (sum, whole) in sum.into_iter().zip(area(&vertices)) {
            assert!((sum - whole).abs() < 1e-3, "{vertices:?} {plane:?}");
        }
    }
}

#[test]
fn neighbours_meet_in_the_same_bits_in_every_arithmetic() {
    let mut random = Random::new(23);
    let mut met = 0;
    for _ in 0..5_000 {
        let (vertices, plane) = input(&mut random);
        let [a, b, c] = vertices;
        for arithmetic in ARITHMETICS {
            let ours = cp::clip([a, b, c], plane, arithmetic);
            let theirs = cp::clip([b, a, c], plane, arithmetic);
            let bits = |outcome: &Outcome| {
                let mut bits: Vec<_> = outcome.new.iter().map(|at| at.map(f32::to_bits)).collect();
                bits.sort_unstable();
                bits
            };
            assert_eq!(bits(&ours), bits(&theirs), "{vertices:?} {plane:?} {arithmetic:?}");
            met += usize::from(!ours.new.is_empty());
        }
    }
    assert!(met > 3_000, "{met}");
}

#[test]
fn keeps_the_laws_in_every_arithmetic() {
    let mut random = Random::new(24);
    let mut coverage = Coverage::default();
    for _ in 0..400 {
        let (vertices, plane) = input(&mut random);
        for arithmetic in ARITHMETICS {
            let (traced, events) = run(vertices, plane, arithmetic);
            check_laws(
                (&cp::clip(vertices, plane, arithmetic), &traced),
                &events,
                |budget| cp::play(vertices, plane, arithmetic, budget),
                Snapshot::result,
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
}
