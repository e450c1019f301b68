//! The step of depth: every code against the definition, laws, golden logs.

use crate::support::{Coverage, Random, check_golden, check_laws, log_text};
use rasterscope_core::{
    depth::{
        DepthFormat,
        precision::{self, Event, Line, Snapshot},
    },
    math::Dyadic,
};

fn line(planes: [f32; 2], format: DepthFormat, reversed: bool) -> Line {
    Line { planes, perspective: true, format, reversed }
}

fn run(line: &Line, gap: f32) -> (Option<u32>, Vec<Event>) {
    let mut events = Vec::new();
    let found = precision::first_merge_traced(line, gap, &mut events);
    (found, events)
}

#[test]
fn searches_step_by_step() {
    for (name, line, gap) in [
        ("unorm16", line([0.1, 1000.0], DepthFormat::Unorm16, false), 0.5),
        ("f32_reversed", line([0.1, 1000.0], DepthFormat::F32, true), 1e-5),
        ("never", line([1.0, 10.0], DepthFormat::Unorm24, false), 0.01),
    ] {
        check_golden(&format!("depth_precision/{name}"), &log_text(&run(&line, gap).1));
    }
}

/// Whether two planes `gap` apart, the nearer at the very beginning of a code's stretch, lie in it; straight
/// from the definition of the depth: z(d) = f (d - n) / ((f - n) d) at d + gap is still below the upper end.
fn both_in(line: &Line, place: u32, gap: f32) -> bool {
    let max = f64::from(line.format.max_code().expect("unorm"));
    let [n, f] = line.planes.map(Dyadic::from);
    let gap = Dyadic::from(gap);
    let code = f64::from(line.code(place));
    let two = Dyadic::from(2.0 * max);
    // Half-way to the neighbouring codes, over 2 max.
    let ends = [2.0 * code - 1.0, 2.0 * code + 1.0].map(|end| Dyadic::from(end.clamp(0.0, 2.0 * max)));
    let [near_z, far_z] = if line.reversed { [&ends[1], &ends[0]] } else { [&ends[0], &ends[1]] };
    // Depth counted from the near plane.
    let from_near = |z: &Dyadic| if line.reversed { &two - z } else { z.clone() };
    let [begin, end] = [from_near(near_z), from_near(far_z)];
    // d = n f / (f - z (f - n)), over two: d = n f two / (f two - z (f - n)).
    let bottom = &f * &two - &begin * (&f - &n);
    let d = &n * &f * &two;
    // z(d + gap) < end, multiplied out.
    let later = &d + &gap * &bottom;
    &f * (&later - &n * &bottom) * &two < &end * (&f - &n) * &later
}

#[test]
fn the_first_code_is_that_of_a_search_through_all() {
    for reversed in [false, true] {
        for (planes, gap) in
            [([0.1, 1000.0], 0.5), ([0.1, 1000.0], 100.0), ([1.0, 10.0], 0.001), ([2.0, 3.0], 1e-4)]
        {
            let line = line(planes, DepthFormat::Unorm16, reversed);
            let all = (0..=line.last()).find(|place| both_in(&line, *place, gap));
            assert_eq!(precision::first_merge(&line, gap), all, "{line:?} {gap}");
        }
    }
}

/// Whatever is found merges and its predecessors do not, sampled over all ranges; floats included.
#[test]
fn steps_before_the_first_are_shorter() {
    let mut random = Random::new(71);
    for round in 0..300 {
        let near = random.uniform(0.01, 4.0);
        let planes = [near, near * random.uniform(1.5, 5000.0)];
        let perspective = random.below(5) > 0;
        let line = Line {
            planes,
            perspective,
            format: random.pick(&DepthFormat::ALL),
            reversed: random.below(2) == 0,
        };
        let gap = planes[1] * 2f32.powi(-(random.below(28) as i32)) * random.uniform(0.5, 1.0);
        let found = precision::first_merge(&line, gap);
        if let Some(place) = found {
            assert!(line.cell(place).exceeds(gap), "round {round}: {line:?} {gap}");
        }
        let end = found.map_or(u64::from(line.last()) + 1, u64::from);
        let near_end = (1..=20).filter_map(|back| end.checked_sub(back));
        let spread: Vec<_> = (0..200).map(|_| (u64::from(random.bits()) * end) >> 32).collect();
        for place in near_end.chain(spread).filter(|place| *place < end) {
            let place = u32::try_from(place).expect("a code");
            assert!(
                !line.cell(place).exceeds(gap),
                "round {round}: {place} before {found:?}, {line:?} {gap}"
            );
        }
    }
}

#[test]
fn stretches_follow_each_other_without_a_gap() {
    let mut random = Random::new(72);
    for format in DepthFormat::ALL {
        for reversed in [false, true] {
            let line = line([0.1, 1000.0], format, reversed);
            for _ in 0..200 {
                let place = ((u64::from(random.bits()) * u64::from(line.last())) >> 32) as u32;
                let [[begin, end], [next, _]] = [place, place + 1].map(|place| line.cell(place).distances());
                assert!(begin <= end && (end - next).abs() <= 1e-9 * end, "{line:?} {place}");
                let length = line.cell(place).length();
                assert!((length - (end - begin)).abs() <= 1e-9 * end, "{line:?} {place}");
            }
            assert!((line.cell(0).distances()[0] - f64::from(0.1f32)).abs() < 1e-9);
            assert!((line.cell(line.last()).distances()[1] - 1000.0).abs() < 1e-6);
        }
    }
}

/// The sentence of the lectures, measured: near 0.1 and far 1000.
#[test]
fn reversed_floats_are_far_finer_than_all_others() {
    let first = |format, reversed, gap| {
        let line = line([0.1, 1000.0], format, reversed);
        precision::first_merge(&line, gap).map(|place| line.cell(place).distances()[0].round())
    };
    assert_eq!(first(DepthFormat::Unorm16, false, 0.01), Some(8.0));
    assert_eq!(first(DepthFormat::Unorm24, false, 0.01), Some(130.0));
    assert_eq!(first(DepthFormat::F32, true, 0.01), None);
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(73);
    let mut coverage = Coverage::default();
    for _ in 0..40 {
        let near = random.uniform(0.01, 4.0);
        let line = Line {
            planes: [near, near * random.uniform(1.5, 5000.0)],
            perspective: random.below(4) > 0,
            format: random.pick(&DepthFormat::ALL),
            reversed: random.below(2) == 0,
        };
        let gap = random.pick(&[1e-6, 1e-3, 0.1, 1.0, 1000.0]);
        let fast = precision::first_merge(&line, gap);
        let (traced, events) = run(&line, gap);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| precision::play(line, gap, budget),
            Snapshot::result,
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}
