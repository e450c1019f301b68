//! The stencil test: WebGPU's tables, laws, golden logs, an oracle that draws naively, and outlines as
//! differences of two coverages.

use crate::{
    presets::scene,
    support::{Coverage, Random, check_golden, check_laws, covered, log_text, plane_code},
};
use rasterscope_core::{
    blend::AlphaTest,
    compare::Subject,
    depth::{CompareFunction, Cutout, DepthFormat, DepthState, Rules, z_buffer::Triangle},
    labs::{self, LabInput, Stencil},
    math::Tally,
    message::Value,
    pipeline::{Skips, enlarged_triangles, render, screen_triangles},
    raster::{self, Algorithm, Scissor},
    replay::Budget,
    scene::{Lab, PRESETS, Scene},
    stencil::{
        StencilOperation, StencilOutcome, StencilState, Way,
        stencil_test::{self, Draw, Event, Image, Settings, Snapshot},
    },
};
use std::collections::{BTreeMap, BTreeSet};

/// WebGPU's compare functions: "a comparison test passes if the provided value is ... the sampled value".
fn compare_of_the_specification(name: &str, provided: u32, sampled: u32) -> bool {
    match name {
        "never" => false,
        "less" => provided < sampled,
        "equal" => provided == sampled,
        "less-equal" => provided <= sampled,
        "greater" => sampled < provided,
        "not-equal" => provided != sampled,
        "greater-equal" => sampled < provided || provided == sampled,
        "always" => true,
        _ => panic!("WebGPU has no {name}"),
    }
}

/// WebGPU's stencil operations, in integers without a width.
fn operation_of_the_specification(name: &str, current: i32, reference: i32) -> i32 {
    match name {
        "keep" => current,
        "zero" => 0,
        "replace" => reference,
        "invert" => 255 - current,
        "increment-clamp" => (current + 1).min(255),
        "decrement-clamp" => (current - 1).max(0),
        "increment-wrap" => (current + 1) % 256,
        "decrement-wrap" => (current + 255) % 256,
        _ => panic!("WebGPU has no {name}"),
    }
}

#[test]
fn compares_are_those_of_webgpu_for_all_pairs() {
    let names = ["never", "less", "equal", "less-equal", "greater", "not-equal", "greater-equal", "always"];
    for name in names {
        let json = serde_json::json!({"compare": name});
        let named: StencilState = serde_json::from_value(json).expect("WebGPU's name");
        let state = |reference| StencilState { reference, ..named };
        for reference in 0..=255 {
            for stored in 0..=255 {
                let expected = compare_of_the_specification(name, reference.into(), stored.into());
                assert_eq!(state(reference).passes(stored), expected, "{reference} {name} {stored}");
            }
        }
    }
    assert_eq!(CompareFunction::ALL.map(CompareFunction::name), names);
}

#[test]
fn operations_are_those_of_webgpu_for_all_pairs() {
    let names = [
        "keep",
        "zero",
        "replace",
        "invert",
        "increment-clamp",
        "decrement-clamp",
        "increment-wrap",
        "decrement-wrap",
    ];
    for name in names {
        let operation: StencilOperation = serde_json::from_value(name.into()).expect("WebGPU's name");
        for reference in 0..=255 {
            for stored in 0..=255 {
                let expected = operation_of_the_specification(name, stored.into(), reference.into());
                assert_eq!(i32::from(operation.apply(stored, reference)), expected, "{name} {stored}");
            }
        }
    }
    assert_eq!(StencilOperation::ALL.map(StencilOperation::name), names);
}

#[test]
fn masks_choose_bit_by_bit() {
    let mut random = Random::new(51);
    for _ in 0..20_000 {
        let state = any_state(&mut random);
        let stored = random.below(256) as u8;
        let masked = |value: u8| u32::from(value & state.read_mask);
        let passes =
            compare_of_the_specification(state.compare.name(), masked(state.reference), masked(stored));
        assert_eq!(state.passes(stored), passes, "{state:?} {stored}");
        for (outcome, operation) in [
            (StencilOutcome::Fail, state.fail_op),
            (StencilOutcome::DepthFail, state.depth_fail_op),
            (StencilOutcome::Pass, state.pass_op),
        ] {
            let new = operation_of_the_specification(operation.name(), stored.into(), state.reference.into());
            let after = state.after(outcome, stored);
            for bit in 0..8 {
                let from = if state.write_mask >> bit & 1 == 1 { new } else { stored.into() };
                assert_eq!(i32::from(after >> bit & 1), from >> bit & 1, "{state:?} {stored} bit {bit}");
            }
        }
    }
}

fn any_state(random: &mut Random) -> StencilState {
    let mask = |random: &mut Random| random.pick(&[0xFF, 0xFF, 0x01, 0x0F, 0xF0, 0x00]);
    StencilState {
        compare: random.pick(&CompareFunction::ALL),
        fail_op: random.pick(&StencilOperation::ALL),
        depth_fail_op: random.pick(&StencilOperation::ALL),
        pass_op: random.pick(&StencilOperation::ALL),
        read_mask: mask(random),
        write_mask: mask(random),
        reference: random.below(256) as u8,
    }
}

fn run(draws: &[Draw], settings: &Settings) -> (Image, Vec<Event>) {
    let mut events = Vec::new();
    let image = stencil_test::draw_traced(draws, settings, &mut Tally::default(), &mut events);
    (image, events)
}

fn plain(name: &str, triangles: Vec<Triangle>, stencil: Option<StencilState>) -> Draw {
    Draw {
        name: name.into(),
        triangles,
        rules: Vec::new(),
        enlarged: None,
        depth: DepthState::default(),
        stencil,
        visible: true,
    }
}

/// Three draws: one writes 1, one fails in part by depth, one is drawn where 1 is not.
fn three_draws() -> Vec<Draw> {
    let replace = StencilOperation::Replace;
    let write = StencilState { pass_op: replace, reference: 1, ..StencilState::default() };
    let count = StencilState {
        compare: CompareFunction::Equal,
        reference: 1,
        fail_op: StencilOperation::Invert,
        depth_fail_op: StencilOperation::IncrementClamp,
        pass_op: StencilOperation::DecrementWrap,
        write_mask: 0x0F,
        ..StencilState::default()
    };
    let outside =
        StencilState { compare: CompareFunction::NotEqual, reference: 1, ..StencilState::default() };
    vec![
        plain("A", vec![[[0.0, 0.0, 0.5], [4.0, 0.0, 0.5], [0.0, 4.0, 0.5]]], Some(write)),
        plain("B", vec![[[0.0, 0.0, 0.25], [5.0, 1.0, 0.75], [1.0, 5.0, 0.75]]], Some(count)),
        plain("C", vec![[[0.0, 0.0, 0.0], [6.0, 0.0, 0.0], [0.0, 3.0, 0.0]]], Some(outside)),
    ]
}

#[test]
fn three_draws_step_by_step() {
    let (_, events) = run(&three_draws(), &Settings::new([6, 5]));
    check_golden("stencil/three_draws", &log_text(&events));
}

#[test]
fn an_outline_step_by_step() {
    let mut scene = Scene::empty([8, 6]);
    scene.draws = self::scene("stencil-outline-scale").draws;
    scene.camera = self::scene("stencil-outline-scale").camera;
    scene.lab = Some(Lab::new(Stencil { outline: Some(Way::Normals), distance: 3.0, ..Stencil::default() }));
    let mut run = labs::play(&scene, Budget::default()).expect("it runs");
    let mut log = String::new();
    while run.cursor() < run.len() {
        run.seek(run.cursor() + 1);
        log += &run.event_text().expect("a step has an event");
        log.push('\n');
    }
    check_golden("stencil/outline", &log);
}

/// Every triangle at every pixel, by the tables of the specification.
fn naive(draws: &[Draw], settings: &Settings) -> (Vec<u8>, Vec<u32>) {
    let [width, height] = settings.raster.size;
    let pixels = (width * height) as usize;
    let mut stencil = vec![settings.clear; pixels];
    let mut depth = vec![settings.format.encode(settings.clear_depth); pixels];
    for draw in draws {
        for triangle in &draw.triangles {
            for span in covered(triangle.map(|[x, y, _]| [x, y]), &settings.raster) {
                for x in span.begin..span.end {
                    let at = (span.y * width + x) as usize;
                    let new = plane_code(triangle, [x, span.y], settings.format);
                    let [new_depth, old_depth] = [new, depth[at]].map(|code| settings.format.decode(code));
                    let nearer = !draw.depth.test || draw.depth.compare.passes(new_depth, old_depth);
                    let state = draw.stencil.unwrap_or_default();
                    let [reference, stored] =
                        [state.reference, stencil[at]].map(|v| u32::from(v & state.read_mask));
                    let passes = compare_of_the_specification(state.compare.name(), reference, stored);
                    let operation = match (passes, nearer) {
                        (false, _) => state.fail_op,
                        (true, false) => state.depth_fail_op,
                        (true, true) => state.pass_op,
                    };
                    let value = operation_of_the_specification(
                        operation.name(),
                        stencil[at].into(),
                        state.reference.into(),
                    ) as u8;
                    stencil[at] = stencil[at] & !state.write_mask | value & state.write_mask;
                    if passes && nearer && draw.depth.test && draw.depth.write {
                        depth[at] = new;
                    }
                }
            }
        }
    }
    (stencil, depth)
}

fn any_draws(random: &mut Random) -> (Vec<Draw>, Settings) {
    let coordinate = |random: &mut Random, high: u32| random.below(2 * high) as f32 / 2.0;
    let mut settings = Settings {
        algorithm: random.pick(&Algorithm::ALL),
        format: random.pick(&DepthFormat::ALL),
        clear: random.pick(&[0, 1, 255]),
        ..Settings::new([8, 6])
    };
    settings.raster = raster::Settings::new([8, 6]);
    let draws = (0..3).map(|i| {
        let mut corner = || [coordinate(random, 9), coordinate(random, 7), coordinate(random, 8) / 8.0];
        let triangles = vec![[corner(), corner(), corner()], [corner(), corner(), corner()]];
        let depth = DepthState {
            test: random.below(4) > 0,
            compare: random.pick(&[CompareFunction::Less, CompareFunction::GreaterEqual]),
            write: random.below(3) > 0,
        };
        let stencil = (random.below(4) > 0).then(|| any_state(random));
        let visible = random.below(5) > 0;
        Draw { depth, visible, ..plain(["A", "B", "C"][i], triangles, stencil) }
    });
    (draws.collect(), settings)
}

#[test]
fn equals_a_naive_run_of_the_specification() {
    let mut random = Random::new(52);
    for round in 0..300 {
        let (draws, settings) = any_draws(&mut random);
        let image = stencil_test::draw(&draws, &settings);
        let (stencil, depth) = naive(&draws, &settings);
        assert_eq!(image.stencil, stencil, "round {round}: {draws:?} {settings:?}");
        assert_eq!(image.depth.codes(), depth, "round {round}: {draws:?} {settings:?}");
    }
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(53);
    let mut coverage = Coverage::default();
    for round in 0..60 {
        let (mut draws, settings) = any_draws(&mut random);
        if round % 3 == 0 {
            let before = draws[0].triangles.clone();
            let enlarge = rasterscope_core::stencil::Enlarge { way: random.pick(&Way::ALL), amount: 2.0 };
            draws[2].enlarged = Some((enlarge, before));
        }
        if round % 2 == 0 {
            let test = AlphaTest { compare: random.pick(&CompareFunction::ALL), reference: 0.5 };
            let cutout = Some(Cutout { test, alpha: [0.0, 1.0, random.pick(&[0.0, 1.0])], r: [1.0; 3] });
            let scissor = Some(Scissor::from([1, 1, 4, 3]));
            draws[1].rules = vec![Rules { cutout, scissor, ..Rules::default() }; 2];
        }
        let fast = stencil_test::draw(&draws, &settings);
        let (traced, events) = run(&draws, &settings);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| stencil_test::play(draws.clone(), settings, budget),
            |state: &Snapshot| state.result().clone(),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

/// What the lab shows at the end: object and stencil value of each pixel that a fragment came to.
fn shown(scene: &Scene) -> BTreeMap<[u32; 2], (Value, Value)> {
    let mut run = labs::play(scene, Budget::default()).expect("it runs");
    run.seek(run.len());
    let pixel = |fact: rasterscope_core::compare::Fact| match fact.subject {
        Subject::Pixel(at) => (at, (fact.values[0].1.clone(), fact.values[1].1.clone())),
        other => panic!("{other:?} is no pixel"),
    };
    run.facts().into_iter().map(pixel).collect()
}

/// The pixels that triangles cover, by another rasterizer than the lab's.
fn pixels(triangles: impl Iterator<Item = Triangle>, scene: &Scene) -> BTreeSet<[u32; 2]> {
    let settings = raster::Settings { fill_rule: scene.fill_rule, ..raster::Settings::new(scene.size) };
    let rows = |t: Triangle| {
        raster::rows(Algorithm::Aabb, t.map(|[x, y, _]| [x, y]), &settings, &mut Tally::default())
    };
    let spans = triangles.flat_map(rows);
    spans.flat_map(|span| (span.begin..span.end).map(move |x| [x, span.y])).collect()
}

#[test]
fn an_outline_is_the_difference_of_two_coverages() {
    for (name, distance) in
        [("stencil-outline-scale", 2.0), ("stencil-outline-normals", 1.5), ("pawn", 0.125)]
    {
        for way in Way::ALL {
            let mut scene = scene(name);
            let input = Stencil { outline: Some(way), distance, ..Stencil::default() };
            scene.lab = Some(Lab::new(input));
            let enlarge = input.enlarge(&scene).expect("it is given");
            let object = pixels(screen_triangles(&scene).iter().map(|t| t.vertices), &scene);
            let larger = pixels(enlarged_triangles(&scene, 0, enlarge).iter().map(|t| t.vertices), &scene);
            let outline = shown(&scene).into_iter().filter(|(_, (object, _))| *object == Value::text("A′"));
            let outline: BTreeSet<_> = outline.map(|(at, _)| at).collect();
            assert!(!outline.is_empty(), "{name} {way:?}");
            assert!(outline.iter().eq(larger.difference(&object)), "{name} {way:?}");
        }
    }
}

#[test]
fn outlines_in_pixels_are_as_wide_as_they_say() {
    let mut scene = scene("stencil-outline-pixels");
    let enlarge = rasterscope_core::stencil::Enlarge { way: Way::Pixels, amount: 2.0 };
    for distance in [9.0, 9.75] {
        scene.camera.eye[2] = distance;
        scene.camera.projection = rasterscope_core::transform::Projection::Perspective { fovy_degrees: 90.0 };
        let [before, after] = [screen_triangles(&scene), enlarged_triangles(&scene, 0, enlarge)];
        assert_eq!(before.len(), after.len());
        for (a, b) in before.iter().zip(&after) {
            for (a, b) in a.vertices.iter().zip(&b.vertices) {
                let moved = [0, 1].map(|axis| f64::from(b[axis]) - f64::from(a[axis]));
                assert!((moved[0].hypot(moved[1]) - 2.0).abs() < 1e-5, "{moved:?}");
            }
        }
    }
}

/// What the pipeline draws is what the lab steps, for every preset with a stencil state.
#[test]
fn the_lab_ends_with_the_stencil_of_the_image() {
    let mut seen = 0;
    for preset in PRESETS {
        let mut scene = scene(preset.name);
        let stenciled = scene.draws.iter().any(|draw| draw.stencil.is_some());
        if !stenciled || scene.size[0] > 100 {
            continue;
        }
        scene.lab = Some(Lab::new(LabInput::Stencil(Stencil::default())));
        let frame = render(&scene, &Skips::ALL);
        for (at, (_, value)) in shown(&scene) {
            let stored = frame.stencil[frame.index(at)];
            assert_eq!(value, Value::text(stored), "{} {at:?}", preset.name);
        }
        seen += 1;
    }
    assert!(seen >= 5, "{seen} presets have a stencil test");
}

/// What the presets' sentences claim.
#[test]
fn presets_show_what_they_say() {
    let count = |name: &str, value: u32| {
        let frame = render(&scene(name), &Skips::ALL);
        frame.stencil.iter().filter(|stored| u32::from(**stored) == value).count()
    };
    assert!(count("stencil-shadow-volume", 1) > 10, "some pixels of the floor lie in shadow");
    assert!(count("stencil-shadow-volume", 255) == 0, "nothing was counted down alone");
    assert!(count("stencil-mirror", 1) > 50);
    let objects = |name: &str| {
        let shown = shown(&scene(name)).into_values().map(|(object, _)| object);
        shown.map(|value| format!("{value:?}")).collect::<BTreeSet<_>>().len()
    };
    assert_eq!(objects("stencil-keyhole"), 4, "three draws, and pixels that none of them got");
    assert_eq!(objects("stencil-outlines-overlap"), 4);
}
