//! The six back-face tests: laws, golden logs, the exact oracle, and where they agree and do not.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    cull::{
        CullMode, Facing, FrontFace,
        back_face::{self as bf, EdgeOn, Event, Input, Outcome, Settings, Snapshot, Spaces, Test, Why},
        camera_normal,
        degenerate::{Degeneracy, degeneracy, is_collinear},
        facing,
    },
    math::{Arithmetic, Dyadic, Sign, Tally},
    raster::YAxis,
    transform::{
        Camera, DepthRange, Projection, Viewport,
        chain::Chain,
        matrices::{self, IDENTITY, Matrix},
    },
};

const TRIANGLE: [[f32; 3]; 3] = [[-1.0, -1.0, 0.0], [1.5, -0.5, 0.0], [0.0, 1.5, 0.0]];
const CULL_BACK: Settings = Settings {
    front: FrontFace::Ccw,
    cull: CullMode::Back,
    edge_on: EdgeOn::Neither,
    arithmetic: Arithmetic::Exact,
};

/// A camera at (0, 0, 5) whose projection and viewport are powers of two: products with small integers
/// are exact.
fn chain(model: Matrix, y_axis: YAxis) -> Chain {
    let camera = Camera { projection: Projection::Perspective { fovy_degrees: 90.0 }, ..Camera::default() };
    let viewport = Viewport { size: [32, 32], depth_range: DepthRange::ZeroToOne, y_axis };
    Chain {
        model,
        view: matrices::view(&camera),
        projection: matrices::projection(&camera, 1.0, viewport.depth_range, false),
        viewport,
    }
}

fn input(vertices: [[f32; 3]; 3], model: Matrix, settings: Settings) -> Input {
    Input::new(vertices, chain(model, YAxis::Down), [0.0, 0.0, 5.0, 1.0], settings)
}

fn run(input: &Input) -> (Outcome, Vec<Event>) {
    let mut events = Vec::new();
    let outcome = bf::run_traced(input, &mut Tally::default(), &mut events);
    (outcome, events)
}

fn mirror() -> Matrix {
    matrices::model([0.0; 3], [0.0; 3], [-1.0, 1.0, 1.0])
}

#[track_caller]
fn check(name: &str, input: &Input, expected: [Why; 6]) {
    let (outcome, events) = run(input);
    check_golden(&format!("back_face/{name}"), &log_text(&events));
    assert_eq!(outcome.compared, expected, "{name}");
}

#[test]
fn a_front_is_kept_by_all_six() {
    check("front", &input(TRIANGLE, IDENTITY, CULL_BACK), [Why::Same; 6]);
}

#[test]
fn a_back_is_culled_by_all_six() {
    let [a, b, c] = TRIANGLE;
    check("back", &input([a, c, b], IDENTITY, CULL_BACK), [Why::Same; 6]);
}

#[test]
fn object_space_does_not_know_of_a_mirror() {
    let mut expected = [Why::Same; 6];
    expected[1] = Why::Mirrored;
    check("mirrored", &input(TRIANGLE, mirror(), CULL_BACK), expected);
}

#[test]
fn one_vertex_behind_the_eye_turns_the_image_round() {
    let vertices = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 9.0]];
    let mut expected = [Why::Same; 6];
    (expected[3], expected[4]) = (Why::BehindEye, Why::BehindEye);
    check("one_behind", &input(vertices, IDENTITY, CULL_BACK), expected);
}

#[test]
fn two_vertices_behind_the_eye_turn_it_twice() {
    let vertices = [[-1.0, -1.0, 9.0], [1.0, -1.0, 7.0], [0.0, 1.0, 0.0]];
    check("two_behind", &input(vertices, IDENTITY, CULL_BACK), [Why::Same; 6]);
}

#[test]
fn a_vertex_beside_the_eye_has_no_image() {
    let vertices = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 5.0]];
    let mut expected = [Why::Same; 6];
    (expected[3], expected[4]) = (Why::NoAnswer, Why::NoAnswer);
    check("no_image", &input(vertices, IDENTITY, CULL_BACK), expected);
}

#[test]
fn edge_on_is_what_the_rule_says() {
    let vertices = [[0.0, -1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, -4.0]];
    let settings = Settings { edge_on: EdgeOn::AsTaught, ..CULL_BACK };
    let rule = Why::EdgeOnRule;
    let expected = [rule, rule, rule, rule, Why::Same, Why::Same];
    check("edge_on", &input(vertices, IDENTITY, settings), expected);
    for (edge_on, facing) in
        [(EdgeOn::Neither, Facing::Degenerate), (EdgeOn::Back, Facing::Back), (EdgeOn::Front, Facing::Front)]
    {
        let (outcome, _) = run(&input(vertices, IDENTITY, Settings { edge_on, ..CULL_BACK }));
        assert_eq!(outcome.answers, [Some(facing); 6]);
        assert!(outcome.culled, "it covers nothing, whatever it is called");
    }
}

#[test]
fn each_kind_of_degenerate_triangle_has_its_reason() {
    let flat = matrices::model([0.0; 3], [0.0; 3], [1.0, 0.0, 1.0]);
    let cases = [
        ("coincident", [TRIANGLE[0], TRIANGLE[1], TRIANGLE[0]], IDENTITY, Degeneracy::Coincident),
        ("collinear", [[-1.0; 3], [0.0; 3], [2.0; 3]], IDENTITY, Degeneracy::Collinear),
        ("flattened", TRIANGLE, flat, Degeneracy::Flattened),
        ("edge-on", [[0.0, -1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, -4.0]], IDENTITY, Degeneracy::EdgeOn),
    ];
    for (name, vertices, model, expected) in cases {
        let (_, events) = run(&input(vertices, model, CULL_BACK));
        let found = events.iter().find_map(|event| match event {
            Event::NoArea { why } => Some(*why),
            _ => None,
        });
        assert_eq!(found, Some(expected), "{name}");
    }
}

/// Rows in numbers of any size.
fn rows<const N: usize>(rows: [[f32; N]; 3]) -> [[Dyadic; N]; 3] {
    rows.map(|row| row.map(Dyadic::from))
}

/// `r0 . (r1 x r2)`.
fn determinant([[ax, ay, az], [bx, by, bz], [cx, cy, cz]]: [[Dyadic; 3]; 3]) -> Dyadic {
    ax * (&by * &cz - &bz * &cy) + ay * (&bz * &cx - &bx * &cz) + az * (&bx * &cy - &by * &cx)
}

/// The oracle of a test: another formula for the same sign, in numbers of any size.
fn oracle(spaces: &Spaces, test: Test) -> Sign {
    let flat = |points: [[f32; 2]; 3]| {
        let [[ax, ay], [bx, by], [cx, cy]] = rows(points);
        let one = Dyadic::one;
        determinant([[ax, ay, one()], [bx, by, one()], [cx, cy, one()]]).sign()
    };
    let (object, world, camera) = spaces.eyes;
    // The 4 x 4 determinant of the vertices with w = 1 and the eye, along the eye.
    let seen = |vertices: [[f32; 3]; 3], eye: [f32; 4]| {
        let [a, b, c] = rows(vertices);
        let eye = eye.map(Dyadic::from);
        let without = |skip: usize| {
            let pick = |v: &[Dyadic; 3]| {
                let full = [v[0].clone(), v[1].clone(), v[2].clone(), Dyadic::one()];
                let kept: Vec<_> = (0..4).filter(|i| *i != skip).map(|i| full[i].clone()).collect();
                <[Dyadic; 3]>::try_from(kept).expect("three of four are left")
            };
            determinant([pick(&a), pick(&b), pick(&c)])
        };
        let terms = [0, 1, 2, 3].map(|i| &eye[i] * &without(i));
        let [x, y, z, w] = terms;
        (x - y + z - w).sign()
    };
    match test {
        Test::Camera => seen(spaces.camera, camera),
        Test::Object => object.map_or(Sign::Zero, |eye| seen(spaces.object, eye)),
        Test::Plane => seen(spaces.world, world),
        Test::Ndc => flat(spaces.ndc),
        Test::Screen if spaces.y_axis == YAxis::Down => -flat(spaces.screen),
        Test::Screen => flat(spaces.screen),
        Test::Determinant => determinant(rows(spaces.clip.map(|[x, y, _, w]| [x, y, w]))).sign(),
    }
}

/// A camera, a model and a triangle of one of several nasty families.
fn any_input(random: &mut Random, arithmetic: Arithmetic) -> Input {
    let family = random.below(5);
    let mut coordinate = || match family {
        0 => random.grid(-3, 3),
        1 => random.below(5) as f32 - 2.0,
        2 => random.uniform(-4.0, 9.0),
        3 => random.any().clamp(-1e12, 1e12),
        _ => {
            let about = random.pick(&[0.0, 1.0, 5.0, -2.5]);
            random.near(about)
        }
    };
    let mut vertices = [0; 3].map(|_| [0; 3].map(|_| coordinate()));
    if random.below(4) == 0 {
        // Nearly or exactly on one line.
        let [a, b, _] = vertices;
        vertices[2] = [0, 1, 2].map(|i| a[i] / 2.0 + b[i] / 2.0);
    }
    let scale = [0; 3].map(|_| random.pick(&[1.0, -1.0, 2.0, 0.3, 0.0]));
    let turn = [0; 3].map(|_| random.pick(&[0.0, 90.0, 33.0]));
    let model = matrices::model([0; 3].map(|_| random.grid(-1, 1)), turn, scale);
    let projection = random
        .pick(&[Projection::Perspective { fovy_degrees: 60.0 }, Projection::Orthographic { height: 4.0 }]);
    let camera = Camera { eye: [random.grid(-1, 1), 0.5, 5.0], projection, ..Camera::default() };
    let viewport = Viewport {
        size: [36, 24],
        depth_range: DepthRange::ZeroToOne,
        y_axis: random.pick(&[YAxis::Down, YAxis::Up]),
    };
    let view = matrices::view(&camera);
    let chain = Chain {
        model,
        view,
        projection: matrices::projection(&camera, viewport.aspect(), viewport.depth_range, false),
        viewport,
    };
    let [x, y, z] = camera.eye;
    let eye = match projection {
        Projection::Perspective { .. } => [x, y, z, 1.0],
        Projection::Orthographic { .. } => [view[2], view[6], view[10], 0.0],
    };
    let settings = Settings {
        front: random.pick(&[FrontFace::Ccw, FrontFace::Cw]),
        cull: random.pick(&[CullMode::None, CullMode::Back, CullMode::Front]),
        edge_on: random.pick(&EdgeOn::ALL),
        arithmetic,
    };
    Input::new(vertices, chain, eye, settings)
}

#[test]
fn every_test_has_the_exact_sign_of_its_own_values() {
    let mut random = Random::new(41);
    let mut tally = Tally::default();
    let mut signs = [0; 3];
    for _ in 0..20_000 {
        let input = any_input(&mut random, Arithmetic::Exact);
        for test in Test::ALL {
            let Some(sign) = input.spaces.sign(test, &mut tally) else { continue };
            assert_eq!(sign, oracle(&input.spaces, test), "{test:?} of {:?}", input.spaces);
            let shown = input.spaces.numbers(test, Arithmetic::Exact).expect("it has a value").value;
            assert_eq!(Sign::of(shown), sign, "what is shown has the sign that decides");
            signs[sign as usize] += 1;
        }
        let reference = facing(input.spaces.clip, input.settings.front, &mut tally);
        assert_eq!(oracle(&input.spaces, Test::Determinant).is_zero(), reference == Facing::Degenerate);
    }
    assert!(signs.iter().all(|&count| count > 5_000), "lopsided: {signs:?}");
    assert!(tally.exact > 1_000 && tally.share() < 0.5, "{tally:?}");
}

/// A triangle whose way to the screen rounds nothing: small integers, turned by quarters, mirrored or not,
/// scaled by powers of two, at distances from the eye that are powers of two.
fn exact_input(random: &mut Random, in_front: bool) -> Input {
    let turns: [f32; 3] = [0; 3].map(|_| 90.0 * random.below(4) as f32);
    let scale = random.pick(&[1.0, 0.5, 2.0]);
    let signs = [0; 3].map(|_| random.pick(&[scale, -scale]));
    let model = matrices::model([0; 3].map(|_| random.below(7) as f32 - 3.0), turns, signs);
    // Chosen in world space, at distance w from the eye, and taken back: exact, too.
    let back = inverse(&model);
    let mut point = || {
        let ahead = random.pick(&[1.0, 2.0, 4.0, 8.0]);
        let w = if in_front { ahead } else { random.pick(&[ahead, -ahead]) };
        let [x, y] = [0; 2].map(|_| random.below(13) as f32 - 6.0);
        let [x, y, z, _] = rasterscope_core::transform::apply(&back, [x, y, 5.0 - w, 1.0]);
        [x, y, z]
    };
    let vertices = [0; 3].map(|_| point());
    let y_axis = random.pick(&[YAxis::Down, YAxis::Up]);
    let settings = Settings { front: random.pick(&[FrontFace::Ccw, FrontFace::Cw]), ..CULL_BACK };
    Input::new(vertices, chain(model, y_axis), [0.0, 0.0, 5.0, 1.0], settings)
}

/// The inverse of a matrix whose upper left part has orthogonal columns of powers of two.
fn inverse(m: &Matrix) -> Matrix {
    let mut out = IDENTITY;
    for i in 0..3 {
        let column = [m[4 * i], m[4 * i + 1], m[4 * i + 2]];
        let square: f32 = column.iter().map(|c| c * c).sum();
        for j in 0..3 {
            out[4 * j + i] = column[j] / square;
        }
    }
    let back = |i: usize| -(0..3).map(|j| out[4 * j + i] * m[12 + j]).sum::<f32>();
    let moved = [back(0), back(1), back(2)];
    out[12..15].copy_from_slice(&moved);
    out
}

/// The law: where the way to the screen is exact, no w is negative and nothing is mirrored, six tests
/// give one answer, zero included.
#[test]
fn all_six_agree_where_nothing_is_rounded_mirrored_or_behind_the_eye() {
    let mut random = Random::new(42);
    let mut seen = [0; 3];
    let mut mirrored = 0;
    for _ in 0..120_000 {
        let input = exact_input(&mut random, true);
        let (outcome, _) = run(&input);
        let mut expected = [Why::Same; 6];
        if input.spaces.mirrored && outcome.answers[5] != Some(Facing::Degenerate) {
            expected[1] = Why::Mirrored;
        }
        mirrored += u32::from(input.spaces.mirrored);
        assert_eq!(outcome.compared, expected, "{:?}", input.spaces);
        seen[outcome.answers[5].expect("it always answers") as usize] += 1;
    }
    assert!(seen.iter().all(|&count| count > 1_000) && mirrored > 50_000, "lopsided: {seen:?} {mirrored}");
}

/// The same with vertices behind the eye: after the divide an odd number of them turns the answer.
#[test]
fn an_odd_number_of_vertices_behind_the_eye_turns_the_image() {
    let mut random = Random::new(43);
    let mut turned = 0;
    for _ in 0..60_000 {
        let input = exact_input(&mut random, false);
        let (outcome, _) = run(&input);
        let behind = input.spaces.clip.iter().filter(|vertex| vertex[3] < 0.0).count();
        let area = outcome.answers[5] != Some(Facing::Degenerate);
        let expected = if behind % 2 == 1 && area { Why::BehindEye } else { Why::Same };
        assert_eq!(outcome.compared[3..], [expected, expected, Why::Same], "{:?}", input.spaces);
        turned += u32::from(expected == Why::BehindEye);
    }
    assert!(turned > 20_000, "lopsided: {turned}");
}

#[test]
fn the_six_tests_keep_the_laws() {
    let mut random = Random::new(44);
    let mut coverage = Coverage::default();
    let mut reasons = Vec::new();
    for _ in 0..1_500 {
        for arithmetic in [Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64] {
            let input = any_input(&mut random, arithmetic);
            let (traced, events) = run(&input);
            let fast = bf::run(&input, &mut Tally::default());
            for why in traced.compared {
                if !reasons.contains(&why) {
                    reasons.push(why);
                }
            }
            check_laws(
                (&Some(fast), &Some(traced)),
                &events,
                |budget| bf::play(input.clone(), budget),
                Snapshot::result,
                &mut coverage,
            );
        }
    }
    coverage.check_every_line::<Snapshot>();
    assert_eq!(reasons.len(), 6, "only {reasons:?} occur");
}

#[test]
fn rounded_arithmetic_sees_the_wrong_side_of_slivers() {
    let mut random = Random::new(45);
    let mut wrong = [0, 0];
    for _ in 0..20_000 {
        let exact = any_input(&mut random, Arithmetic::Exact);
        let right = bf::run(&exact, &mut Tally::default()).answers;
        for (count, arithmetic) in wrong.iter_mut().zip([Arithmetic::F32, Arithmetic::F64]) {
            let settings = Settings { arithmetic, ..exact.settings };
            let rounded = bf::run(&Input { settings, ..exact.clone() }, &mut Tally::default()).answers;
            *count += rounded.iter().zip(right).filter(|(rounded, right)| *rounded != right).count();
        }
    }
    assert!(wrong[0] > wrong[1] && wrong[1] > 0, "f32 {} wrong, f64 {} wrong", wrong[0], wrong[1]);
}

#[test]
fn a_line_in_space_is_found_exactly() {
    let mut random = Random::new(46);
    let mut found = 0;
    for _ in 0..20_000 {
        let a = [0; 3].map(|_| random.below(9) as f32 - 4.0);
        let along = [0; 3].map(|_| random.below(3) as f32 - 1.0);
        let at = |t: f32| [0, 1, 2].map(|i| a[i] + t * along[i]);
        let mut line = [a, at(random.below(5) as f32), at(random.below(9) as f32 - 4.0)];
        if random.below(2) == 0 {
            line[2][random.below(3) as usize] += 1.0;
        }
        let normal = camera_normal::formula::<Dyadic>(line, [0.0, 0.0, 0.0, 1.0]).normal;
        let expected = normal.iter().all(Dyadic::is_zero);
        assert_eq!(is_collinear(line, &mut Tally::default()), expected, "{line:?}");
        found += u32::from(expected);
    }
    assert!((5_000..15_000).contains(&found), "lopsided: {found}");
    let one_point = [[1.0, 2.0, 3.0]; 3];
    assert_eq!(degeneracy(one_point, one_point, &mut Tally::default()), Degeneracy::Coincident);
}
