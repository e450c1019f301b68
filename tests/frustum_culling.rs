//! Bodies against the frustum: never wrong for what the pipeline's products round, seldom too careful.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    clip::polygon::{Plane, distance_is_negative},
    cull::{
        bvh::union,
        frustum::triangle_outside,
        object_frustum::{self as of, Body, Event, Input, Snapshot, Verdict},
        planes::{Frustum, PlaneMask, Side, Volume},
        sphere::Sphere,
    },
    math::Dyadic,
    scene::{Draw, Geometry, Mesh, Scene, Transform},
    transform::{Camera, DepthRange, Matrix, Projection, apply, chain::Chain, matrices},
};
use std::sync::Arc;

const TETRAHEDRON: [[f32; 3]; 4] = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];

fn draw(name: &str, positions: &[[f32; 3]], translate: [f32; 3], turn: f32) -> Draw {
    let mesh = Mesh {
        positions: positions.to_vec(),
        triangles: vec![[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
        colors: vec![[1.0; 4]; positions.len()],
        ..Mesh::default()
    };
    let mut draw = Draw::new(name, Geometry::Mesh(Arc::new(mesh)));
    draw.transform = Transform::Parts { translate, rotate_degrees: [0.0, turn, 0.0], scale: [1.0; 3] };
    draw
}

/// Beside, inside and across the right plane.
fn three() -> Scene {
    let mut scene = Scene::empty([36, 24]);
    scene.draws = [("A", 9.0), ("B", 0.0), ("C", 4.5)]
        .map(|(name, x)| draw(name, &TETRAHEDRON, [x, 0.0, 0.0], 20.0))
        .to_vec();
    scene
}

fn run(input: &Input) -> (Vec<Verdict>, Vec<Event>) {
    let mut events = Vec::new();
    let verdicts = of::cull_traced(input, &mut events);
    (verdicts, events)
}

#[test]
fn a_sphere_rejects_accepts_and_crosses() {
    let (verdicts, events) = run(&Input::of(&three(), Body::Sphere));
    check_golden("frustum_culling/sphere", &log_text(&events));
    assert_eq!(verdicts[..2], [Verdict::Outside(Plane::Right), Verdict::Inside]);
    assert!(matches!(&verdicts[2], Verdict::Crosses(_)));
}

#[test]
fn a_box_rejects_accepts_and_crosses() {
    let (verdicts, events) = run(&Input::of(&three(), Body::Box));
    check_golden("frustum_culling/box", &log_text(&events));
    let Verdict::Crosses(triangles) = &verdicts[2] else { panic!("{:?}", verdicts[2]) };
    assert_eq!(triangles.len(), 4);
}

/// A point cloud of one of several nasty families.
fn cloud(random: &mut Random) -> Vec<[f32; 3]> {
    let family = random.below(6);
    let count = 1 + random.below(20);
    let coordinate = |random: &mut Random| match family {
        0 => random.grid(-2, 2),
        1 => random.uniform(-1e3, 1e3),
        2 => random.any().clamp(-1e30, 1e30),
        3 => random.any(),
        4 => random.near(4.330_127),
        _ => random.pick(&[0.0, -0.0, 1.0, 1e-45, -1e-30]),
    };
    (0..count).map(|_| [0; 3].map(|_| coordinate(random))).collect()
}

#[test]
fn no_point_lies_outside_its_sphere_and_the_sphere_is_small() {
    let mut random = Random::new(51);
    let square = |a: [f32; 3], b: [f32; 3]| {
        let [x, y, z] = [0, 1, 2].map(|i| Dyadic::from(a[i]) - Dyadic::from(b[i]));
        &x * &x + &y * &y + &z * &z
    };
    let mut finite = 0;
    for _ in 0..4_000 {
        let points = cloud(&mut random);
        let Sphere { center, radius } = Sphere::around(&points).expect("there are points");
        if radius.is_infinite() {
            continue;
        }
        let most = Dyadic::from(radius) * Dyadic::from(radius);
        let far = points.iter().map(|&point| square(center, point)).max().expect("there are points");
        assert!(far <= most, "{points:?}: {center:?} {radius}");
        // Jung: the smallest sphere has at most sqrt(3/8) of the diameter; ours a fiftieth more at most.
        let diameter = points.iter().flat_map(|&a| points.iter().map(move |&b| square(a, b)));
        let diameter = diameter.max().expect("there are points").to_f64_nearest().sqrt();
        let allowed = diameter * (3.0_f64 / 8.0).sqrt() * 1.02;
        // Where the middle is rounded away from the points, half its last digit more.
        let rounding = center.iter().map(|c| f64::from(c.abs())).fold(0.0, f64::max) * 2e-7;
        assert!(f64::from(radius) <= allowed + rounding + 1e-44, "{points:?}: {radius} for {diameter}");
        finite += 1;
    }
    assert!(finite > 3_000, "lopsided: {finite}");
    assert_eq!(Sphere::around(&[]), None);
}

/// A chain of matrices as the pipeline has it, ordinary or extreme.
fn chain(random: &mut Random) -> ([Matrix; 3], DepthRange) {
    let range = random.pick(&DepthRange::ALL);
    let projection = random.pick(&[
        Projection::Perspective { fovy_degrees: 60.0 },
        Projection::Perspective { fovy_degrees: 170.0 },
        Projection::Orthographic { height: 3.0 },
    ]);
    let near = random.pick(&[1.0, 0.1, 1e-3]);
    let far = random.pick(&[10.0, 1e3, 1e6]);
    let camera =
        Camera { eye: [0; 3].map(|_| random.grid(-6, 6)), near, far, projection, ..Camera::default() };
    let scale = [0; 3].map(|_| random.pick(&[1.0, -1.0, 0.01, 40.0, 0.0]));
    let turn = [0; 3].map(|_| random.pick(&[0.0, 90.0, 33.0, -71.5]));
    let mut model = matrices::model([0; 3].map(|_| random.grid(-9, 9)), turn, scale);
    if random.below(8) == 0 {
        // Any matrix, a projective one too.
        model = model.map(|entry| if random.below(4) == 0 { random.uniform(-3.0, 3.0) } else { entry });
    }
    let reversed = random.below(2) == 0;
    ([model, matrices::view(&camera), matrices::projection(&camera, 1.5, range, reversed)], range)
}

fn to_clip(matrices: &[Matrix; 3], [x, y, z]: [f32; 3]) -> [f32; 4] {
    matrices.iter().fold([x, y, z, 1.0], |point, matrix| apply(matrix, point))
}

/// Nothing that the pipeline sees is culled, nothing that it cuts is called inside: for every rounded
/// vertex, by its exact distance.
#[test]
fn what_is_said_of_a_body_holds_for_every_vertex_as_the_pipeline_rounds_it() {
    let mut random = Random::new(52);
    let mut sides = [0; 3];
    let mut found = [0, 0];
    for _ in 0..6_000 {
        let (matrices, range) = chain(&mut random);
        let frustum = Frustum::before(&[&matrices[0], &matrices[1], &matrices[2]], range);
        let points = cloud(&mut random);
        let clip: Vec<_> = points.iter().map(|&point| to_clip(&matrices, point)).collect();
        for body in Body::ALL {
            let volume = body.around(&points).expect("there are points");
            for plane in Plane::ALL {
                let side = frustum.reach(plane, &volume).side();
                let outside = clip.iter().filter(|&&p| distance_is_negative(plane, p, range)).count();
                match side {
                    Side::Outside => assert_eq!(outside, clip.len(), "{plane:?} {points:?} {matrices:?}"),
                    Side::Inside => assert_eq!(outside, 0, "{plane:?} {points:?} {matrices:?}"),
                    Side::Crosses => {}
                }
                sides[side as usize] += 1;
                if clip.len() == 1 {
                    found[usize::from(side == Side::Crosses)] += 1;
                }
            }
        }
    }
    assert!(sides.iter().all(|&count| count > 5_000), "lopsided: {sides:?}");
    // One point is on one side: only where rounding could tell otherwise, or overflow, is that left open.
    assert!(found[0] > 2 * found[1], "too careful: {found:?}");
}

/// The slack is for rounding alone: where the corners of a box are far from a plane, it is decided.
#[test]
fn ordinary_boxes_are_decided_as_their_corners_are() {
    let mut random = Random::new(53);
    let mut open = 0;
    let mut decided = 0;
    for _ in 0..20_000 {
        let camera = Camera::default();
        let model = matrices::model([0; 3].map(|_| random.grid(-9, 9)), [20.0, 45.0, 0.0], [0.5; 3]);
        let range = DepthRange::ZeroToOne;
        let all = [model, matrices::view(&camera), matrices::projection(&camera, 1.5, range, false)];
        let frustum = Frustum::before(&[&all[0], &all[1], &all[2]], range);
        let corners = (0..8).map(|i| [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -1.0 } else { 1.0 }));
        let clip: Vec<_> = corners.map(|corner| to_clip(&all, corner)).collect();
        let expected =
            Plane::ALL.into_iter().find(|&p| clip.iter().all(|&c| distance_is_negative(p, c, range)));
        let found = frustum.test(&Volume::Box([[-1.0; 3], [1.0; 3]]), PlaneMask::ALL, |_, _| {}).err();
        assert!(found.is_none() || expected.is_some());
        open += u32::from(found != expected);
        decided += u32::from(expected.is_some());
    }
    assert!(open <= 2 && decided > 8_000, "{open} of {decided} left open");
}

#[test]
fn objects_against_the_frustum_keep_the_laws() {
    let mut random = Random::new(54);
    let mut coverage = Coverage::default();
    for _ in 0..150 {
        let mut scene = Scene::empty([36, 24]);
        for i in 0..1 + random.below(4) {
            let at = [random.grid(-9, 9), random.grid(-4, 4), random.grid(-7, 6)];
            scene.draws.push(draw(&i.to_string(), &TETRAHEDRON, at, random.uniform(0.0, 90.0)));
        }
        let input = Input::of(&scene, random.pick(&Body::ALL));
        let (traced, events) = run(&input);
        check_laws(
            (&of::cull(&input), &traced),
            &events,
            |budget| of::play(input.clone(), budget),
            Snapshot::result,
            &mut coverage,
        );
        // What crosses has each triangle tested as the pipeline does.
        for (verdict, draw) in traced.iter().zip(&scene.draws) {
            let Verdict::Crosses(outside) = verdict else { continue };
            let chain = Chain::of(&scene, draw);
            let all = [chain.model, chain.view, chain.projection];
            for (found, triangle) in outside.iter().zip([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]]) {
                let clip = triangle.map(|i: usize| to_clip(&all, TETRAHEDRON[i]));
                assert_eq!(*found, triangle_outside(clip, scene.depth_range));
            }
        }
    }
    coverage.check_every_line::<Snapshot>();
}

#[test]
fn an_object_without_vertices_has_no_body() {
    assert_eq!(Body::ALL.map(|body| body.around(&[])), [None, None]);
    let point = [[1.0, -2.0, 3.0]];
    assert_eq!(Body::Box.around(&point), Some(Volume::Box(union(point.into_iter().map(|p| [p, p])))));
    let Some(Volume::Sphere(sphere)) = Body::Sphere.around(&point) else { panic!("a point has a sphere") };
    assert_eq!((sphere.center, sphere.radius), (point[0], 0.0));
}
