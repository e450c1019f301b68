//! Stress: every family breaks binary32 somewhere and exact nowhere, and broken cases are made small.

use crate::{
    presets,
    support::{Coverage, check_golden, check_laws, log_text},
};
use rasterscope_core::{
    compare::{Pair, Setting, Side, difference},
    explain::Level,
    labs::{LabInput, Stress},
    math::Arithmetic,
    message::Value,
    raster::{Algorithm, Settings, Span, rows},
    replay::Budget,
    scene::Scene,
    stress::{
        Family,
        dial::{DRIVEN, MOST, Operation},
        judge::Verdict,
        shrink::{complexity, numbers, shrink},
        trial::{self, CASES, Event, Snapshot, Subject},
    },
};

fn scene() -> Scene {
    Scene::empty([16, 12])
}

fn subject(operation: Operation, family: Family, dial: u8) -> Subject {
    Subject { operation, family, dial, arithmetic: Arithmetic::F32, shrink: false, scene: scene() }
}

fn all(dials: impl Iterator<Item = u8> + Clone) -> impl Iterator<Item = Subject> {
    let pairs = Operation::ALL
        .into_iter()
        .flat_map(|operation| operation.families().iter().map(move |family| (operation, *family)));
    pairs.flat_map(move |(operation, family)| dials.clone().map(move |dial| subject(operation, family, dial)))
}

/// The exact answer in another way: by a sibling algorithm, or the same triangle turned round.
fn otherwise(case: &LabInput) -> Option<LabInput> {
    match case {
        LabInput::ClipLine(_) => case.carried("liang-barsky"),
        LabInput::FillTriangle(_) => case.carried("aabb"),
        _ => None,
    }
}

fn covered(case: &LabInput, algorithm: Algorithm) -> Vec<Span> {
    let LabInput::FillTriangle(fill) = case else { panic!("it fills a triangle") };
    let vertices = fill.vertices.expect("it has its own");
    rows(algorithm, vertices, &Settings::new(scene().size), &mut Default::default())
}

#[test]
fn every_family_breaks_binary32_at_the_end_of_the_dial_and_exact_nowhere() {
    let mut driven: Vec<Family> = Vec::new();
    for subject in all([5, MOST].into_iter()) {
        let mut broken = 0;
        for index in 0..CASES {
            let case = subject.case(index);
            assert_eq!(subject.verdict(&case, Arithmetic::Exact), Verdict::default());
            broken += usize::from(subject.verdict(&case, Arithmetic::F32).breaks());
            if let Some(LabInput::FillTriangle(_)) = otherwise(&case) {
                let [a, b] = [Algorithm::Scanline, Algorithm::Aabb].map(|each| covered(&case, each));
                assert_eq!(a, b, "{subject:?} case {index}");
            }
            if let Some(other @ LabInput::ClipLine(_)) = otherwise(&case) {
                let visible = |case: &LabInput| {
                    subject.answer(case, Arithmetic::Exact).iter().filter(|fact| fact.at.is_some()).count()
                };
                assert_eq!(visible(&case), visible(&other), "{subject:?} case {index}");
            }
        }
        driven.push(subject.family);
        let (operation, family) = (subject.operation, subject.family);
        assert!(subject.dial < MOST || broken > 0, "{operation:?} {family:?} breaks nothing");
    }
    for family in DRIVEN {
        assert!(driven.contains(&family), "no operation has {family:?}");
    }
}

#[test]
fn the_dial_goes_from_mild_to_extreme() {
    let broken = |dial: u8| {
        let totals = all([dial].into_iter()).map(|subject| {
            trial::run(&subject)
                .totals
                .iter()
                .find(|t| t.arithmetic == Arithmetic::F32)
                .map_or(0, |t| t.broken)
        });
        totals.sum::<usize>()
    };
    let (mild, extreme) = (broken(0), broken(MOST));
    let all = CASES * all([0].into_iter()).count();
    assert!(mild == 0 && 2 * extreme > all, "{mild} at the start, {extreme} of {all} at the end");
}

#[test]
fn cases_are_the_same_on_every_run_and_can_be_run() {
    for subject in all([0, 3, MOST].into_iter()) {
        for index in [0, 7, CASES - 1] {
            let case = subject.case(index);
            assert_eq!(case, subject.case(index));
            assert_eq!(case.name(), subject.operation.lab());
            assert!(numbers(&case).iter().all(|(_, number)| number.is_finite()), "{case:?}");
        }
        let answered =
            (0..CASES).filter(|i| !subject.answer(&subject.case(*i), Arithmetic::Exact).is_empty());
        assert!(answered.count() > CASES / 4, "{:?} {:?}", subject.operation, subject.family);
    }
}

#[test]
fn a_shrunk_case_still_breaks_is_simpler_and_shrinks_no_further() {
    let mut shrunk = 0;
    for subject in all([9].into_iter()) {
        let Some(first) = (0..CASES).map(|i| subject.case(i)).find(|case| subject.fails(case)) else {
            continue;
        };
        let small = subject.shrunk().expect("it breaks");
        assert!(subject.fails(&small), "{:?} {:?}", subject.operation, subject.family);
        let cost = |case: &LabInput| numbers(case).iter().map(|(_, x)| complexity(*x)).sum::<u32>();
        assert!(cost(&small) < cost(&first), "{:?} {:?}", subject.operation, subject.family);
        let again = shrink(&small, &mut |case| subject.fails(case), &mut |_| {});
        assert_eq!(again, small);
        shrunk += 1;
    }
    assert!(shrunk >= 15, "{shrunk}");
}

#[test]
fn a_shrunk_case_opens_in_its_lab_with_the_arithmetic() {
    let stress = Stress {
        operation: Operation::Coverage,
        family: Family::Beside,
        dial: MOST,
        arithmetic: Arithmetic::F32,
        shrink: true,
    };
    let case = stress.shrunk(&scene()).expect("binary32 breaks");
    let LabInput::FillTriangle(fill) = &case else { panic!("it fills a triangle") };
    assert_eq!((case.name(), fill.arithmetic), ("scanline", Arithmetic::F32));
    let subject = stress.subject(&scene());
    let [f32, exact] = [Arithmetic::F32, Arithmetic::Exact].map(|each| subject.answer(&case, each));
    assert!(difference(&f32, &exact).count() > 0);
    let opened = subject.opened(&case, Arithmetic::F32);
    assert!(rasterscope_core::compare::settings(&opened).contains(&Setting::Arithmetic(Arithmetic::Exact)));
}

#[test]
fn keeps_the_laws() {
    let mut coverage = Coverage::default();
    for (operation, family, dial) in [
        (Operation::Coverage, Family::Beside, MOST),
        (Operation::LineClipping, Family::Huge, 0),
        (Operation::PolygonClipping, Family::Beside, MOST),
        (Operation::TriangleClipping, Family::NearlyParallel, MOST),
        (Operation::Attributes, Family::Sliver, 9),
        (Operation::Depth, Family::Long, 2),
    ] {
        let subject = Subject { shrink: true, ..subject(operation, family, dial) };
        let mut events: Vec<Event> = Vec::new();
        let traced = trial::run_traced(&subject, &mut events);
        check_laws(
            (&trial::run(&subject), &traced),
            &events,
            |budget| trial::play(subject.clone(), budget),
            |state: &Snapshot| state.result(),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

/// Beside each other two arithmetics go through the same cases together, and differ where one of them breaks.
#[test]
fn two_arithmetics_beside_each_other_show_the_same_case() {
    let [rounded, wide] = [Arithmetic::F32, Arithmetic::F64].map(|arithmetic| {
        let subject = Subject { arithmetic, ..subject(Operation::Depth, Family::Long, MOST) };
        trial::play(subject, Budget::default())
    });
    let mut pair = Pair::new([Box::new(rounded), Box::new(wide)]);
    let difference = pair.difference();
    assert_eq!(difference.changed.len() + difference.same, CASES);
    assert!(difference.changed.len() > CASES / 2, "{} cases differ", difference.changed.len());
    for case in 1..=CASES {
        pair.next(Level::Primitive);
        for side in Side::ALL {
            let sentence = pair.run(side).sentence();
            let number = sentence.args.iter().find(|(name, _)| *name == "number").map(|(_, number)| number);
            assert_eq!(number, Some(&Value::count(case)), "{side:?}: {sentence:?}");
        }
    }
}

#[test]
fn logs_are_those_of_the_golden_files() {
    for (name, operation, family, dial) in [
        ("beside", Operation::Coverage, Family::Beside, MOST),
        ("huge", Operation::LineClipping, Family::Huge, 3),
    ] {
        let subject = Subject { shrink: true, ..subject(operation, family, dial) };
        let mut events: Vec<Event> = Vec::new();
        trial::run_traced(&subject, &mut events);
        check_golden(&format!("stress/{name}"), &log_text(&events));
    }
}

#[test]
fn presets_show_what_they_say() {
    let stress = |name: &str| {
        let scene = presets::scene(name);
        match scene.lab.as_ref().map(|lab| lab.input.clone()) {
            Some(LabInput::Stress(stress)) => (stress, scene),
            other => panic!("{name}: {other:?}"),
        }
    };
    // Cases that break binary32 and binary64.
    let broken = |name: &str, dial: Option<u8>| {
        let (mut stress, scene) = stress(name);
        stress.dial = dial.unwrap_or(stress.dial);
        let totals = trial::run(&stress.subject(&scene)).totals;
        [Arithmetic::F32, Arithmetic::F64]
            .map(|each| totals.iter().find(|total| total.arithmetic == each).map_or(0, |total| total.broken))
    };
    let [f32, f64] = broken("stress-nearly-parallel", None);
    assert!(f32.abs_diff(CASES / 2) <= 2 && f64 == 0, "half of {CASES}: {f32}, {f64}");
    for name in ["stress-beside", "stress-huge", "stress-near-w-zero", "stress-long", "stress-frustum-edge"] {
        let [f32, f64] = broken(name, None);
        assert!(f32 > 5 && f64 == 0, "{name}: {f32}, {f64}");
        assert_eq!(broken(name, Some(0)), [0, 0], "{name}");
    }
    assert!(broken("stress-huge", Some(MOST))[1] > 5, "binary64 breaks as well");
    let [f32, f64] = broken("stress-denormal", None);
    assert!(f32 > 5 && f64 > 5, "{f32}, {f64}");
    let (sliver, scene) = stress("stress-sliver");
    assert!(sliver.shrink);
    let small = trial::run(&sliver.subject(&scene)).shrunk.expect("it breaks");
    assert!(numbers(&small).iter().filter(|(_, number)| complexity(*number) == 0).count() > 3, "{small:?}");
}
