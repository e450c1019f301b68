//! Two sides: what can be compared, how two runs stand beside each other, where they differ.

use crate::presets::scene;
use rasterscope_cli::figure::{FigureOptions, SIZE, figure};
use rasterscope_core::{
    clip::line::{Algorithm, Window, cohen_sutherland, liang_barsky},
    compare::{Changed, Fact, Pair, Setting, Side, Subject, difference, settings, side_b, sorted},
    explain::Level,
    labs::{self, LabInput},
    math::Arithmetic,
    message::Value,
    raster::FillRule,
    replay::{Budget, Playback},
    scene::{Lab, PRESETS, Scene},
};
use rasterscope_figure::{theme::ThemeName, words::Words};

/// Every preset in the lab that it opens, the overview's presets also in every other lab.
fn corpus() -> Vec<(String, Scene)> {
    let mut all = Vec::new();
    for preset in PRESETS {
        let scene = scene(preset.name);
        if scene.lab.is_some() {
            all.push((preset.name.to_owned(), scene));
            continue;
        }
        for lab in labs::ALL {
            let input = labs::default_input(lab.name).expect("every lab has a default");
            let scene = Scene { lab: Some(Lab::new(input)), ..scene.clone() };
            if scene.validate().is_ok() && labs::play(&scene, Budget::default()).is_ok() {
                all.push((format!("{} in {}", preset.name, lab.name), scene));
            }
        }
    }
    all
}

fn compared(scene: &Scene, setting: Setting) -> Scene {
    let mut scene = scene.clone();
    scene.lab.as_mut().expect("every scene of the corpus has a lab").compare = Some(setting);
    scene
}

fn pair(scene: &Scene, setting: Setting) -> Pair {
    let pair = Pair::play(&compared(scene, setting), Budget::default()).expect("it compares");
    pair.unwrap_or_else(|problem| panic!("{setting:?}: {}", problem.id))
}

#[test]
fn every_setting_of_every_preset_applies_and_is_kept_by_the_file() {
    let words = Words::default();
    for (name, scene) in corpus() {
        let all = settings(&scene);
        for setting in all {
            let wanted = compared(&scene, setting);
            assert_eq!(wanted.validate(), Ok(()), "{name}: {setting:?}");
            let read = Scene::from_json(wanted.to_json().as_bytes()).expect("what was written can be read");
            assert_eq!(read.lab, wanted.lab, "{name}");
            let other = side_b(&wanted).expect("it compares");
            assert_eq!(setting.of(&other), Some(setting), "{name}");
            assert_ne!(setting.of(&scene), Some(setting), "{name} offers what it has");
            assert_eq!(other.validate(), Ok(()), "{name}: {setting:?}");
            assert_eq!(side_b(&other), None, "side B has no side B");
            let mut back = other.clone();
            setting.restore(&mut back, &wanted);
            assert_eq!(back, wanted, "{name}: {setting:?} is taken back");
            let values = setting.values(&scene);
            assert!(values.contains(&setting) && setting.of(&scene).is_some_and(|own| values.contains(&own)));
            assert!(!words.word(setting.word()).starts_with('⟨'), "{setting:?}");
            assert!(!words.value(&setting.value()).starts_with('⟨'), "{setting:?}");
        }
    }
}

/// A lab that can be compared with nothing would offer an empty list.
#[test]
fn every_lab_can_be_compared() {
    let corpus = corpus();
    for lab in labs::ALL {
        let of_lab = |scene: &Scene| scene.lab.as_ref().is_some_and(|open| open.input.name() == lab.name);
        let some = corpus.iter().any(|(_, scene)| of_lab(scene) && !settings(scene).is_empty());
        assert!(some, "{} can be compared with nothing", lab.name);
    }
}

#[test]
fn equal_runs_have_no_difference() {
    for (name, scene) in corpus() {
        let Some(other) = settings(&scene).first().copied() else { continue };
        let own = other.of(&scene).expect("what has alternatives has a value");
        let pair = pair(&scene, own);
        let difference = pair.difference();
        assert_eq!((difference.count(), difference.ulps()), (0, None), "{name}");
        let mut run = labs::play(&scene, Budget::default()).expect("it was played before");
        run.seek(run.len());
        assert_eq!(difference.same, run.facts().len(), "{name}");
        assert_eq!(pair.len(), run.len(), "equal runs go step by step");
    }
}

/// What a comparison looks at: a lab without facts would never differ.
#[test]
fn every_lab_has_facts() {
    let corpus = corpus();
    for lab in labs::ALL {
        let of_lab = |scene: &Scene| scene.lab.as_ref().is_some_and(|open| open.input.name() == lab.name);
        let some = corpus.iter().filter(|(_, scene)| of_lab(scene)).any(|(_, scene)| {
            let mut run = labs::play(scene, Budget::default()).expect("it was played before");
            run.seek(run.len());
            !run.facts().is_empty()
        });
        assert!(some, "{} has no facts", lab.name);
    }
}

#[test]
fn both_sides_take_every_step_and_end_together() {
    for (name, scene) in corpus().into_iter().step_by(3) {
        for setting in settings(&scene).into_iter().step_by(2) {
            let wanted = compared(&scene, setting);
            let Some(Ok(mut pair)) = Pair::play(&wanted, Budget::default()) else { continue };
            let name = format!("{name}, {setting:?}");
            check_steps(&mut pair, &name);
        }
    }
}

fn check_steps(pair: &mut Pair, name: &str) {
    let cursors = |pair: &Pair| Side::ALL.map(|side| pair.run(side).cursor());
    let ends = Side::ALL.map(|side| pair.run(side).len());
    assert!(pair.len() >= ends[0].max(ends[1]) && pair.len() <= ends[0] + ends[1], "{name}");
    assert_eq!((pair.cursor(), cursors(pair)), (0, [0, 0]), "{name}");
    if pair.len() < 3000 {
        let mut before = [0, 0];
        while pair.cursor() < pair.len() {
            pair.next(Level::Detail);
            let now = cursors(pair);
            assert!((0..2).all(|side| now[side] - before[side] <= 1), "{name}: {before:?} to {now:?}");
            assert_ne!(now, before, "{name}: nobody moves");
            before = now;
        }
    }
    pair.seek(usize::MAX);
    assert_eq!(cursors(pair), ends, "{name}: both end together");
    for level in [Level::Primitive, Level::Row] {
        pair.seek(0);
        let mut stops = vec![0];
        while pair.cursor() < pair.len() {
            pair.next(level);
            stops.push(pair.cursor());
        }
        while pair.cursor() > 0 {
            assert_eq!(stops.pop(), Some(pair.cursor()), "{name}: back and forth stop at other places");
            pair.back(level);
        }
    }
    for side in Side::ALL {
        let own = pair.run(side).markers();
        for ((step, marker), (own_step, own)) in pair.markers(side).into_iter().zip(own) {
            pair.seek(step);
            assert_eq!((pair.run(side).cursor(), marker), (own_step, own), "{name}: a mark moved");
        }
    }
}

#[test]
fn rows_stay_side_by_side_when_one_side_has_more_pixels() {
    let scene = scene("acceptance-square");
    let lab = Lab::new(labs::default_input("z-buffer").expect("a lab"));
    let scene = Scene { lab: Some(lab), ..scene };
    let mut pair = pair(&scene, Setting::FillRule(FillRule::Inclusive));
    for _ in 0..4 {
        pair.next(Level::Row);
        let said = Side::ALL.map(|side| {
            let run = pair.run(side);
            let row = run.sentence().args.into_iter().find(|(name, _)| *name == "y");
            row.map(|(_, y)| y)
        });
        assert_eq!(said[0], said[1]);
    }
}

#[test]
fn inclusive_edges_draw_the_shared_diagonal_twice() {
    let lab = Lab::new(labs::default_input("pipeline").expect("a lab"));
    let scene = Scene { lab: Some(lab), ..scene("acceptance-square") };
    let pair = pair(&scene, Setting::FillRule(FillRule::Inclusive));
    let difference = pair.difference();
    assert_eq!(difference.only_a, []);
    assert_eq!(difference.only_b.len(), 13, "the right column and the bottom row");
    let twice = |Changed { a, b }: &Changed| {
        let count = |fact: &Fact| fact.values.iter().find(|(name, _)| *name == "column-fragments").cloned();
        let [a, b] = [a, b].map(|fact| count(fact).map(|(_, value)| value));
        (a, b) == (Some(Value::Int(1)), Some(Value::Int(2)))
    };
    assert_eq!(difference.changed.len(), 6);
    assert!(difference.changed.iter().all(twice));
    let diagonal: Vec<_> = difference.changed.iter().map(|changed| changed.a.subject.clone()).collect();
    assert_eq!(diagonal, (1..7).map(|i| Subject::Pixel([i, i])).collect::<Vec<_>>());
    assert_eq!((difference.count(), difference.same, difference.ulps()), (19, 30, None));
}

/// Of the algorithms for polygons this holds for what they cover, not for their corners.
#[test]
fn algorithms_for_lines_agree_in_exact_arithmetic() {
    let exact = Setting::Arithmetic(Arithmetic::Exact);
    let mut compared = 0;
    for (name, scene) in corpus() {
        let line = scene.lab.as_ref().is_some_and(|lab| matches!(lab.input, LabInput::ClipLine(_)));
        let mistaken = scene.to_json().contains("\"mistake");
        if !line || mistaken || exact.of(&scene) != Some(exact) {
            continue;
        }
        for setting in settings(&scene) {
            if let Setting::Algorithm(other) = setting {
                let pair = pair(&scene, setting);
                let difference = pair.difference();
                if [other, scene.lab.as_ref().map_or("", |lab| lab.input.name())].contains(&"midpoint") {
                    // It stops where neighbouring numbers have no middle.
                    assert!(difference.only_a.is_empty() && difference.only_b.is_empty(), "{name}: {other}");
                    assert!(difference.ulps() <= Some(1), "{name}: {other}");
                } else {
                    assert_eq!(difference.count(), 0, "{name}: {other}");
                }
                compared += 1;
            }
        }
    }
    assert!(compared > 10, "{compared} pairs");
}

#[test]
fn rounding_is_counted_in_ulps() {
    let window = Window::new([3.5, 2.0, 9.0, 6.5]).expect("a window");
    let mut farthest = 0;
    for i in 0_u8..40 {
        let segment = [[0.3, 0.7 + f32::from(i) * 0.1], [10.7, 6.1]];
        let [exact, rounded] = [Arithmetic::Exact, Arithmetic::F32].map(|arithmetic| {
            let mut run = cohen_sutherland::play(segment, window, arithmetic, Budget::default());
            run.seek(run.len());
            run.facts()
        });
        let found = difference(&sorted(exact), &sorted(rounded));
        assert_eq!(found.ulps().is_some(), !found.changed.is_empty(), "{segment:?}");
        farthest = farthest.max(found.ulps().unwrap_or(0));
    }
    assert!((1..100).contains(&farthest), "f32 is off by {farthest} ULP");
}

/// The presets of two sides show what their notes claim.
#[test]
fn presets_of_two_sides_differ_as_they_say() {
    let play = |name| Pair::play(&scene(name), Budget::default()).expect("it compares").expect("it runs");
    let counts = |pair: &Pair| {
        let found = pair.difference();
        [found.only_a.len(), found.only_b.len(), found.changed.len(), found.same]
    };
    let divisions = |pair: &Pair| Side::ALL.map(|side| pair.run(side).operations()[1].divisions);
    let corner = play("two-sides-corner");
    assert_eq!((counts(&corner), divisions(&corner)), ([0, 0, 0, 1], [1, 0]));
    let rounding = play("two-sides-rounding");
    assert_eq!(counts(&rounding), [0, 2, 1, 0], "rejected exactly, kept with two ends in f32");
    assert_eq!(counts(&play("two-sides-tie")), [0, 13, 6, 30]);
    let bits = play("two-sides-depth-bits");
    let owners = bits.difference().changed.iter().filter(|changed| {
        let owner = |fact: &Fact| fact.values.first().cloned();
        owner(&changed.a) != owner(&changed.b)
    });
    assert!(owners.count() > 20, "stripes of the farther triangle");
    // Of the six spaces the vertex differs in clip space and in NDC only.
    assert_eq!(counts(&play("two-sides-depth-range")), [0, 0, 2, 4]);
}

#[test]
fn a_side_may_give_up_what_the_other_keeps() {
    let window = Window::new([0.0, 0.0, 1.0, 1.0]).expect("a window");
    let play = |segment| -> [Vec<Fact>; 2] {
        let mut a = cohen_sutherland::play(segment, window, Arithmetic::Exact, Budget::default());
        let mut b = liang_barsky::play(segment, window, Arithmetic::Exact, Budget::default());
        [&mut a as &mut dyn Playback, &mut b].map(|run| {
            assert_eq!(run.facts(), [], "nothing is known at the start");
            run.seek(run.len());
            run.facts()
        })
    };
    let [kept, also_kept] = play([[0.5, 0.5], [2.0, 0.5]]);
    assert_eq!(kept, also_kept, "siblings say the same in the same words");
    let [rejected, _] = play([[2.0, 0.0], [2.0, 1.0]]);
    let found = difference(&sorted(kept), &sorted(rejected));
    assert_eq!((found.only_a.len(), found.only_b.len(), found.changed.len()), (2, 0, 1));
    assert_eq!(Algorithm::ALL[0].name(), "cohen-sutherland");
}

#[test]
fn corners_are_compared_by_their_place_not_by_their_order() {
    let corners = |points: &[[f32; 2]]| points.iter().map(|p| Fact::corner(*p)).collect::<Vec<_>>();
    let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let turned = [[1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [1.0, 0.0]];
    assert_eq!(difference(&corners(&square), &corners(&turned)).count(), 0);
    let next = f32::from_bits(1.0_f32.to_bits() + 3);
    let moved = [[1.0, 1.0], [0.0, 1.0], [0.0, 0.0], [next, 0.0]];
    let found = difference(&corners(&square), &corners(&moved));
    assert_eq!((found.changed.len(), found.same, found.ulps()), (1, 3, Some(3)));
    let found = difference(&corners(&square), &corners(&moved[..2]));
    assert_eq!((found.only_a.len(), found.only_b.len(), found.same), (2, 0, 2));
}

#[test]
fn nothing_differs_from_nan_but_a_number() {
    let fact = |x: f32| vec![Fact::corner([x, 0.0])];
    assert_eq!(difference(&fact(f32::NAN), &fact(f32::NAN)).count(), 0);
    assert_eq!(difference(&fact(0.0), &fact(-0.0)).count(), 0);
    assert!(difference(&fact(f32::NAN), &fact(1.0)).ulps() > Some(1 << 20));
}

/// `figure` draws both halves of a file that compares.
#[test]
fn a_figure_of_two_sides_has_both() {
    let output = std::env::temp_dir().join(format!("rasterscope-two-sides-{}.svg", std::process::id()));
    let mut options = FigureOptions {
        lab: "cohen-sutherland".to_owned(),
        file: "two-sides-rounding".into(),
        step: None,
        size: SIZE,
        overlay: Default::default(),
        theme: ThemeName::Light,
        output: output.clone(),
    };
    let mut drawn = |step| {
        options.step = step;
        figure(&options, &mut Vec::new()).expect("it is drawn");
        std::fs::read_to_string(&output).expect("it was written")
    };
    let (start, end) = (drawn(Some(0)), drawn(None));
    std::fs::remove_file(&output).expect("it was there");
    for svg in [&start, &end] {
        assert!(svg.contains("aria-label=\"exact\"") && svg.contains("aria-label=\"f32, as taught\""));
        assert_eq!(svg.matches("overflow=\"hidden\"").count(), 2, "two drawings");
    }
    let rings = |svg: &str| svg.matches("stroke-dasharray=\"5 4\"").count();
    assert_eq!([rings(&start), rings(&end)], [0, 2], "two ends that only f32 keeps");
}
