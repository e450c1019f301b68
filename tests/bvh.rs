//! The tree of boxes: laws, golden logs, and the same answers as without it, by fewer tests.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    clip::polygon::distance_is_negative,
    cull::{
        bvh::{self, Aabb, Event, Found, Input, Snapshot, Split, Tree, union},
        planes::{Frustum, PlaneMask, Volume},
    },
    transform::{Camera, DepthRange, Matrix, apply, matrices},
};

const RANGE: DepthRange = DepthRange::ZeroToOne;

fn camera() -> [Matrix; 2] {
    let camera = Camera { eye: [0.0, 2.5, 7.0], target: [0.0, 0.0, -6.0], far: 26.0, ..Camera::default() };
    [matrices::view(&camera), matrices::projection(&camera, 1.5, RANGE, false)]
}

fn frustum() -> Frustum {
    let [view, projection] = camera();
    Frustum::before(&[&view, &projection], RANGE)
}

fn cube([x, y, z]: [f32; 3], half: f32) -> Aabb {
    [[x - half, y - half, z - half], [x + half, y + half, z + half]]
}

/// A field of ten by ten boxes.
fn field() -> Vec<Aabb> {
    let at = |i: u16| [3.0 * f32::from(i % 10) - 13.5, 0.0, 3.0 - 3.0 * f32::from(i / 10)];
    (0..100).map(|i| cube(at(i), 0.7)).collect()
}

fn input(boxes: &[Aabb], split: Split) -> Input {
    let names = (0..boxes.len()).map(|i| i.to_string()).collect();
    let triangles = [].into();
    Input { boxes: boxes.into(), names, triangles, split, frustum: frustum(), corners: None }
}

fn run(boxes: &[Aabb], split: Split) -> (Found, Vec<Event>) {
    let mut events = Vec::new();
    let tree = Tree::build_traced(boxes, split, &mut events);
    let found = bvh::cull_traced(&tree, &frustum(), &mut events);
    (found, events)
}

#[test]
fn two_groups_and_one_beside() {
    let places = [[0.0, 0.0, -4.0], [1.0, 0.5, -5.0], [-1.0, 0.0, -6.0], [14.0, 0.0, 0.0], [15.0, 1.0, 1.0]];
    let boxes: Vec<_> = places.iter().map(|&at| cube(at, 0.5)).collect();
    for split in Split::ALL {
        let (found, events) = run(&boxes, split);
        let name = match split {
            Split::Median => "median",
            Split::SurfaceArea => "surface_area",
        };
        check_golden(&format!("bvh/{name}"), &log_text(&events));
        let outside: Vec<_> = found.outside.iter().map(Option::is_some).collect();
        assert_eq!(outside, [false, false, false, true, true], "{split:?}");
    }
}

/// Boxes of one of several families; the last with extreme coordinates.
fn boxes(random: &mut Random) -> Vec<Aabb> {
    let family = random.below(5);
    let count = random.below(60);
    let place = |random: &mut Random| match family {
        0 => [0; 3].map(|_| random.grid(-20, 20)),
        1 => [random.grid(-20, 20), 0.0, 0.0],
        2 => [1.0, 2.0, -3.0],
        3 => [random.pick(&[-9.0, 0.0, 9.0]), random.uniform(-1.0, 1.0), random.pick(&[-20.0, -5.0])],
        _ => [0; 3].map(|_| random.any()),
    };
    (0..count)
        .map(|_| {
            let corners = [place(random), place(random)];
            let small = corners[0].map(|c| c + random.grid(0, 2));
            let other = if random.below(3) == 0 { corners[1] } else { small };
            union([corners[0], other].into_iter().map(|corner| [corner, corner]))
        })
        .collect()
}

#[test]
fn every_box_lies_in_one_leaf_and_every_node_is_the_union_of_its_boxes() {
    let mut random = Random::new(61);
    for _ in 0..400 {
        let boxes = boxes(&mut random);
        for split in Split::ALL {
            let tree = Tree::build(&boxes, split);
            let mut leaves = vec![0; boxes.len()];
            for (index, node) in tree.nodes().iter().enumerate() {
                let items = tree.items(node);
                assert_eq!(node.bounds, union(items.iter().map(|&item| boxes[item as usize])));
                match node.children {
                    Some([left, right]) => {
                        assert!(left as usize > index && right == left + 1);
                        let [left, right] = [left, right].map(|child| &tree.nodes()[child as usize]);
                        let together = [tree.items(left), tree.items(right)].concat();
                        assert_eq!(together, items);
                        assert!(!tree.items(left).is_empty() && !tree.items(right).is_empty());
                    }
                    None => items.iter().for_each(|&item| leaves[item as usize] += 1),
                }
            }
            assert!(leaves.iter().all(|&count| count == 1));
            let depth = tree.nodes().iter().map(|node| node.depth).max().unwrap_or_default();
            if split == Split::Median {
                assert!(depth <= 5, "halves of at most 60 boxes");
            }
        }
    }
}

#[test]
fn a_tree_rejects_what_the_boxes_alone_would_and_nothing_that_is_seen() {
    let mut random = Random::new(62);
    let frustum = frustum();
    let [view, projection] = camera();
    let (mut outside, mut kept) = (0, 0);
    for _ in 0..1_500 {
        let boxes = boxes(&mut random);
        for split in Split::ALL {
            let found = bvh::cull(&Tree::build(&boxes, split), &frustum);
            for (&bounds, plane) in boxes.iter().zip(&found.outside) {
                let alone = frustum.test(&Volume::Box(bounds), PlaneMask::ALL, |_, _| {});
                assert_eq!(plane.is_some(), alone.is_err(), "{bounds:?}");
                let Some(plane) = *plane else {
                    kept += 1;
                    continue;
                };
                outside += 1;
                for i in 0..8 {
                    let [x, y, z] = [0, 1, 2].map(|axis| bounds[i >> axis & 1][axis]);
                    let clip = apply(&projection, apply(&view, [x, y, z, 1.0]));
                    assert!(distance_is_negative(plane, clip, RANGE), "{bounds:?} {plane:?}");
                }
            }
        }
    }
    assert!(outside > 5_000 && kept > 5_000, "lopsided: {outside} {kept}");
}

#[test]
fn a_tree_needs_fewer_tests_than_a_hundred_boxes() {
    let boxes = field();
    let without = bvh::tests_without_tree(&boxes, &frustum());
    for split in Split::ALL {
        let Found { outside, counts } = bvh::cull(&Tree::build(&boxes, split), &frustum());
        let kept = outside.iter().filter(|plane| plane.is_none()).count();
        assert!(counts.tests * 3 < without * 2, "{split:?}: {counts:?}, without {without}");
        assert!(counts.rejected > 3 && counts.accepted > 3 && (20..60).contains(&kept), "{counts:?} {kept}");
    }
}

#[test]
fn trees_of_boxes_keep_the_laws() {
    let mut random = Random::new(63);
    let mut coverage = Coverage::default();
    for _ in 0..60 {
        let boxes = boxes(&mut random);
        let split = random.pick(&Split::ALL);
        let (traced, events) = run(&boxes, split);
        check_laws(
            (&bvh::cull(&Tree::build(&boxes, split), &frustum()), &traced),
            &events,
            |budget| bvh::play(input(&boxes, split), budget),
            Snapshot::result,
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}
