//! The presets are the special cases that their sentences claim.

use rasterscope_core::{
    clip::line::{
        Algorithm, Window, cohen_sutherland,
        liang_barsky::{self, Parameter},
    },
    cull::{Facing, facing},
    labs::{ClipLine, FillTriangle, LabInput, ZBuffer},
    math::Tally,
    raster::{Settings, aabb},
    replay::{Budget, Playback},
    scene::{Scene, Transform, model, preset},
    transform::{
        Viewport,
        chain::{self, Chain, Path},
        matrices,
    },
};

/// A preset with its models.
pub(crate) fn scene(name: &str) -> Scene {
    let preset = preset(name).unwrap_or_else(|| panic!("no preset {name}"));
    let mut load = |file: &str| model(file).map(<[u8]>::to_vec).ok_or_else(|| "no such model".into());
    Scene::from_json(preset.json.as_bytes())
        .and_then(|scene| scene.resolve(&mut load))
        .unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The triangles of one draw, each vertex in all spaces.
fn triangles(scene: &Scene, draw: usize) -> Vec<[Path; 3]> {
    let drawn = &scene.draws[draw];
    let viewport = Viewport { size: scene.size, depth_range: scene.depth_range, y_axis: scene.y_axis };
    let model = match drawn.transform {
        Transform::Parts { translate, rotate_degrees, scale } => {
            matrices::model(translate, rotate_degrees, scale)
        }
        Transform::Matrix(_) => panic!("no preset has a matrix of its own"),
    };
    let projection =
        matrices::projection(&scene.camera, viewport.aspect(), scene.depth_range, scene.reversed);
    let chain = Chain { model, view: matrices::view(&scene.camera), projection, viewport };
    let mesh = drawn.geometry.mesh().expect("resolved");
    let paths = chain::run(&mesh.positions, &chain);
    let at = |i: u32| paths[usize::try_from(i).expect("small")];
    mesh.triangles.iter().map(|triangle| triangle.map(at)).collect()
}

fn clip(triangle: [Path; 3]) -> [[f32; 4]; 3] {
    triangle.map(|[_, _, _, clip, _, _]| clip)
}

fn screen(triangle: [Path; 3]) -> [[f32; 2]; 3] {
    triangle.map(|[_, _, _, _, _, [x, y, ..]]| [x, y])
}

/// Front-facing, back-facing and degenerate triangles of each draw.
fn facings(name: &str) -> Vec<[usize; 3]> {
    let scene = scene(name);
    let count = |draw: usize| {
        let mut counts = [0; 3];
        for triangle in triangles(&scene, draw) {
            let facing = facing(clip(triangle), scene.draws[draw].front, &mut Tally::default());
            counts[match facing {
                Facing::Front => 0,
                Facing::Back => 1,
                Facing::Degenerate => 2,
            }] += 1;
        }
        counts
    };
    (0..scene.draws.len()).map(count).collect()
}

/// How often each pixel is covered by all triangles, row by row; nothing is clipped.
fn coverage(name: &str) -> Vec<Vec<u32>> {
    let scene = scene(name);
    let [width, height] = scene.size.map(|n| usize::try_from(n).expect("small"));
    let mut covered = vec![vec![0; width]; height];
    let settings = Settings { fill_rule: scene.fill_rule, ..Settings::new(scene.size) };
    for draw in 0..scene.draws.len() {
        for triangle in triangles(&scene, draw) {
            aabb::fill(screen(triangle), &settings, &mut Tally::default(), &mut |span| {
                for x in span.begin..span.end {
                    covered[usize::try_from(span.y).expect("small")][usize::try_from(x).expect("small")] += 1;
                }
            });
        }
    }
    covered
}

#[test]
fn triangles_face_as_the_sentences_say() {
    for (name, expected) in [
        ("two-through-each-other", &[[1, 0, 0], [1, 0, 0], [0, 1, 0]][..]),
        ("edge-on", &[[0, 0, 1], [1, 0, 0]]),
        ("zero-area", &[[0, 0, 1], [0, 0, 1], [1, 0, 0]]),
        ("mirrored", &[[1, 0, 0], [0, 1, 0], [1, 0, 0]]),
        ("near-plane", &[[1, 0, 0], [1, 0, 0]]),
        ("behind-the-eye", &[[1, 0, 0]]),
        ("off-screen-huge", &[[1, 0, 0], [1, 0, 0]]),
        ("cyclic-overlap", &[[2, 0, 0], [2, 0, 0], [2, 0, 0]]),
        ("cube", &[[6, 6, 0]]),
    ] {
        assert_eq!(facings(name), expected, "{name}");
    }
}

#[test]
fn the_acceptance_square_stands_exactly_on_pixel_centres() {
    for name in ["acceptance-square", "span-shared-diagonal"] {
        let scene = scene(name);
        let corners: Vec<_> = (0..2).flat_map(|draw| triangles(&scene, draw)).map(screen).collect();
        assert_eq!(
            corners,
            [[[1.5, 1.5], [7.5, 7.5], [7.5, 1.5]], [[1.5, 1.5], [1.5, 7.5], [7.5, 7.5]]],
            "{name}"
        );
    }
}

#[test]
fn shared_edges_through_centres_are_drawn_once() {
    for name in ["acceptance-square", "shared-edges-through-centres"] {
        let covered = coverage(name);
        let once = covered.iter().flatten().filter(|times| **times == 1).count();
        let never = covered.iter().flatten().filter(|times| **times == 0).count();
        assert_eq!((once, once + never), (36, covered.iter().map(Vec::len).sum()), "{name}");
    }
}

#[test]
fn vertices_lie_where_the_sentences_say() {
    let first = |name: &str, vertex: usize| clip(triangles(&scene(name), 0)[0])[vertex];
    let [.., z, w] = first("near-plane", 0);
    assert!(z < 0.0 && w > 0.0, "between eye and near plane");
    assert!(first("behind-the-eye", 2)[3] < 0.0);
    assert!(first("vertex-behind-the-eye", 2)[3] < 0.0);
    assert_eq!(first("vertex-orthographic", 0)[3], 1.0);
    let ndc: Vec<f32> =
        triangles(&scene("vertex-minus-one-to-one"), 0)[0].iter().map(|path| path[4][2]).collect();
    assert_eq!(ndc[..2], [-1.0, 1.0]);
    let outside = |[x, y]: [f32; 2]| !(0.0..=36.0).contains(&x) && !(0.0..=24.0).contains(&y);
    let huge = triangles(&scene("off-screen-huge"), 0)[0];
    assert!(screen(huge).into_iter().all(outside));
}

#[test]
fn lines_are_what_their_names_say() {
    for (name, codes, visible) in [
        ("line-three-cuts", ["0101", "1010"], Some([[3.5, 2.9], [8.0, 6.5]])),
        ("line-inside", ["0000", "0000"], Some([[4.5, 3.0], [8.0, 5.5]])),
        ("line-same-side", ["1001", "1010"], None),
        ("line-looks-hidden", ["0001", "1000"], Some([[3.5, 5.5], [4.5, 6.5]])),
        ("line-passes-by", ["0001", "1000"], None),
        ("line-touches-a-corner", ["0001", "1000"], Some([[3.5, 6.5], [3.5, 6.5]])),
        ("line-along-a-border", ["0001", "0010"], Some([[3.5, 6.5], [9.0, 6.5]])),
    ] {
        let Some(LabInput::ClipLine(ClipLine { window, segment: [x1, y1, x2, y2], .. })) =
            scene(name).lab.map(|lab| lab.input)
        else {
            panic!("{name} opens the lab");
        };
        let [xmin, ymin, xmax, ymax] = window;
        let code =
            |x: f32, y: f32| [y > ymax, y < ymin, x > xmax, x < xmin].map(|bit| if bit { '1' } else { '0' });
        assert_eq!([code(x1, y1), code(x2, y2)].map(|code| code.iter().collect::<String>()), codes, "{name}");
        let window = Window::new(window).expect("a window");
        assert_eq!(cohen_sutherland::clip([[x1, y1], [x2, y2]], &window), visible, "{name}");
    }
}

#[test]
fn parameters_have_the_order_that_their_names_say() {
    for (name, order, visible) in [
        ("order-kept", "0 bottom left top right 1", true),
        ("order-rejected", "0 bottom top left right 1", false),
        ("order-reversed", "0 right top left bottom 1", true),
        ("order-parallel", "0 left right 1", true),
        ("order-parallel-outside", "0 1", false),
        ("order-one-cut", "bottom left 0 right 1 top", true),
        ("order-inside", "bottom left 0 1 right top", true),
    ] {
        let Some(LabInput::ClipLine(input)) = scene(name).lab.map(|lab| lab.input) else {
            panic!("{name} opens the lab");
        };
        let ClipLine { algorithm, window, segment: [x1, y1, x2, y2], arithmetic, .. } = input;
        assert_eq!(algorithm, Algorithm::LiangBarsky, "{name}");
        let window = Window::new(window).expect("a window");
        let mut run = liang_barsky::play([[x1, y1], [x2, y2]], window, arithmetic, Budget::default());
        run.seek(run.len());
        let found = run.state().ordered().into_iter().map(|parameter| match parameter {
            Parameter::Of(end) => ["0", "1"][end as usize],
            Parameter::At(border) => border.word().trim_start_matches("word-"),
        });
        assert_eq!(found.collect::<Vec<_>>().join(" "), order, "{name}");
        assert_eq!(run.state().result().is_some(), visible, "{name}");
    }
}

#[test]
fn spans_are_what_their_names_say() {
    // Pixels in each row that has any.
    for (name, expected) in [
        ("span-left-tie", &[(1, 1), (2, 3), (3, 4), (4, 6), (5, 7), (6, 5), (7, 2)][..]),
        ("span-apex-on-a-row", &[(2, 2), (3, 2), (4, 4), (5, 6), (6, 7), (7, 4)]),
        ("span-needle", &[]),
        ("span-flat-top", &[(1, 8), (2, 6), (3, 5), (4, 3), (5, 3), (6, 2)]),
        ("span-flat-bottom", &[(2, 2), (3, 3), (4, 4), (5, 5), (6, 7)]),
    ] {
        let scene = scene(name);
        let Some(LabInput::FillTriangle(FillTriangle { vertices: Some(vertices), .. })) =
            scene.lab.map(|lab| lab.input)
        else {
            panic!("{name} opens the lab");
        };
        let mut rows = Vec::new();
        aabb::fill(vertices, &Settings::new(scene.size), &mut Tally::default(), &mut |span| {
            rows.push((span.y, span.len()));
        });
        assert_eq!(rows, expected, "{name}");
    }
}

#[test]
fn fragments_are_as_many_as_in_the_mock() {
    let scene = scene("depth-two-triangles");
    let Some(LabInput::ZBuffer(ZBuffer { triangles: Some(triangles), .. })) = scene.lab.map(|lab| lab.input)
    else {
        panic!("it opens the lab");
    };
    let pixels = |triangle: &[[f32; 3]; 3]| {
        let mut count = 0;
        let flat = triangle.map(|[x, y, _]| [x, y]);
        aabb::fill(flat, &Settings::new(scene.size), &mut Tally::default(), &mut |span| count += span.len());
        count
    };
    assert_eq!(triangles.iter().map(pixels).collect::<Vec<_>>(), [24, 19]);
}
