//! Lines of one pixel's width: laws, golden logs, and the exact line as the judge.

use crate::{
    presets::scene,
    support::{Coverage, Random, Ratio, check_golden, check_laws, log_text, triangle},
};
use rasterscope_core::{
    compare::Pair,
    math::{Arithmetic, Dyadic, Sign, Tally},
    raster::line::{Algorithm, Pixel, Segment, bresenham, dda, diamond_exit, pixel_of, pixels},
    replay::{Budget, Playback},
};
use std::fmt::Debug;

const SIZE: [u32; 2] = [12, 9];

fn on_image(pixels: Vec<Pixel>, size: [u32; 2]) -> Vec<[u32; 2]> {
    let inside = |&[x, y]: &[u32; 2]| x < size[0] && y < size[1];
    pixels.into_iter().map(|pixel| pixel.map(|n| n as u32)).filter(inside).collect()
}

/// The centre of a pixel.
fn centre(pixel: Pixel) -> [f32; 2] {
    pixel.map(|n| n as f32 + 0.5)
}

#[track_caller]
fn check<E: Debug>(name: &str, drawn: &[[u32; 2]], events: &[E]) {
    let [width, height] = SIZE;
    let place = |x, y| drawn.iter().position(|pixel| *pixel == [x, y]);
    let digit = |place: Option<usize>| place.map_or('.', |n| char::from(b'a' + (n % 26) as u8));
    let row = |y| (0..width).map(|x| digit(place(x, y))).collect::<String>() + "\n";
    let picture: String = (0..height).map(row).collect();
    check_golden(name, &format!("{picture}\n{}", log_text(events)));
}

fn run_dda(ends: [Pixel; 2], arithmetic: Arithmetic) -> (Vec<[u32; 2]>, Vec<dda::Event>) {
    let (mut events, mut drawn) = (Vec::new(), Vec::new());
    dda::draw_traced(ends, SIZE, arithmetic, &mut events, &mut |pixel| drawn.push(pixel));
    (drawn, events)
}

fn run_bresenham(ends: [Pixel; 2]) -> (Vec<[u32; 2]>, Vec<bresenham::Event>) {
    let (mut events, mut drawn) = (Vec::new(), Vec::new());
    bresenham::draw_traced(ends, SIZE, &mut events, &mut |pixel| drawn.push(pixel));
    (drawn, events)
}

fn run_diamonds(ends: Segment) -> (Vec<[u32; 2]>, Vec<diamond_exit::Event>) {
    let (mut events, mut drawn) = (Vec::new(), Vec::new());
    let mut tally = Tally::default();
    diamond_exit::draw_traced(ends, SIZE, &mut tally, &mut events, &mut |pixel| drawn.push(pixel));
    (drawn, events)
}

#[test]
fn dda_adds_and_rounds() {
    let cases = [
        ("gentle", [[1, 1], [10, 5]], Arithmetic::Exact),
        ("steep_up", [[4, 8], [2, 0]], Arithmetic::Exact),
        ("tie_exact", [[0, 1], [12, 3]], Arithmetic::Exact),
        ("tie_f32", [[0, 1], [12, 3]], Arithmetic::F32),
        ("one_pixel", [[3, 3], [3, 3]], Arithmetic::F64),
    ];
    for (name, ends, arithmetic) in cases {
        let (drawn, events) = run_dda(ends, arithmetic);
        check(&format!("dda/{name}"), &drawn, &events);
    }
}

#[test]
fn bresenham_decides_by_a_whole_number() {
    let cases = [
        ("gentle", [[1, 1], [10, 4]]),
        ("steep_up_left", [[7, 8], [4, 0]]),
        ("ties", [[1, 2], [9, 6]]),
        ("ties_backwards", [[9, 6], [1, 2]]),
        ("over_the_border", [[-3, 2], [14, 10]]),
        ("one_pixel", [[3, 3], [3, 3]]),
    ];
    for (name, ends) in cases {
        let (drawn, events) = run_bresenham(ends);
        check(&format!("bresenham/{name}"), &drawn, &events);
    }
}

#[test]
fn diamonds_are_left_or_not() {
    let cases = [
        ("unrounded", [[1.625, 1.25], [10.375, 5.5]]),
        ("steep_up", [[6.25, 8.5], [3.0, 0.75]]),
        ("starts_beyond_and_ends_before", [[1.875, 2.125], [9.125, 5.75]]),
        ("along_lower_edges", [[1.0, 0.5], [8.0, 7.5]]),
        ("from_a_lower_corner", [[3.5, 4.0], [5.5, 8.5]]),
        ("inside_one", [[5.375, 4.5], [5.625, 4.625]]),
        ("no_length", [[5.5, 4.5], [5.5, 4.5]]),
        ("off_the_image", [[-3.0, -4.0], [5.0, 3.5]]),
        ("huge", [[-3e38, -3e38], [3e38, 3e38]]),
    ];
    for (name, ends) in cases {
        let (drawn, events) = run_diamonds(ends);
        check(&format!("diamond_exit/{name}"), &drawn, &events);
    }
}

/// Ends on and around the image.
fn ends(random: &mut Random) -> [Pixel; 2] {
    [0; 2].map(|_| [random.below(20) as i32 - 4, random.below(16) as i32 - 4])
}

#[test]
fn dda_and_bresenham_keep_the_laws() {
    let mut random = Random::new(51);
    let [mut of_dda, mut of_bresenham] = [(); 2].map(|()| Coverage::default());
    for _ in 0..400 {
        let ends = ends(&mut random);
        let given = ends.map(|pixel| pixel.map(|n| n as f32 + random.below(64) as f32 / 64.0));
        assert_eq!(given.map(pixel_of), ends);
        let arithmetic = random.pick(Algorithm::Dda.arithmetics());
        let fast = pixels(Algorithm::Dda, given, SIZE, arithmetic, &mut Tally::default());
        let (traced, events) = run_dda(ends, arithmetic);
        let play = |budget| dda::play(given, SIZE, arithmetic, budget);
        let result = |state: &dda::Snapshot| on_image(state.pixels(), SIZE);
        check_laws((&fast, &traced), &events, play, result, &mut of_dda);

        let fast = pixels(Algorithm::Bresenham, given, SIZE, Arithmetic::Exact, &mut Tally::default());
        let (traced, events) = run_bresenham(ends);
        let play = |budget| bresenham::play(given, SIZE, budget);
        let result = |state: &bresenham::Snapshot| on_image(state.pixels(), SIZE);
        check_laws((&fast, &traced), &events, play, result, &mut of_bresenham);
    }
    of_dda.check_every_line::<dda::Snapshot>();
    of_bresenham.check_every_line::<bresenham::Snapshot>();
}

#[test]
fn diamond_exit_keeps_the_laws() {
    let mut random = Random::new(52);
    let mut coverage = Coverage::default();
    for _ in 0..400 {
        let [a, b, _] = triangle(&mut random);
        let fast = pixels(Algorithm::DiamondExit, [a, b], SIZE, Arithmetic::Exact, &mut Tally::default());
        let (traced, events) = run_diamonds([a, b]);
        let play = |budget| diamond_exit::play([a, b], SIZE, budget);
        check_laws((&fast, &traced), &events, play, diamond_exit::Snapshot::pixels, &mut coverage);
    }
    coverage.check_every_line::<diamond_exit::Snapshot>();
}

/// All pixels of a line in a window that holds it.
fn all(algorithm: Algorithm, ends: [Pixel; 2]) -> Vec<[u32; 2]> {
    pixels(algorithm, ends.map(centre), [300, 300], Arithmetic::Exact, &mut Tally::default())
}

/// Both ends in a window of 300 x 300 pixels.
fn far(random: &mut Random) -> [Pixel; 2] {
    let reach = random.pick(&[4, 12, 60, 300]);
    [0; 2].map(|_| [0; 2].map(|_| random.below(reach) as i32))
}

/// The judge: of each column (or row) the pixel whose centre is nearest to the exact line, the greater one of
/// two that are equally near.
#[test]
fn nearest_pixels_are_drawn_in_order() {
    let mut random = Random::new(53);
    for _ in 0..4_000 {
        let ends = far(&mut random);
        let [from, to] = ends.map(|end| end.map(i64::from));
        let length = |axis: usize| (to[axis] - from[axis]).abs();
        let major = usize::from(length(1) > length(0));
        let (minor, steps) = (1 - major, length(major));
        for algorithm in [Algorithm::Dda, Algorithm::Bresenham] {
            let drawn = all(algorithm, ends);
            assert_eq!(drawn.len() as i64, steps + 1, "{algorithm:?} {ends:?}");
            for (made, pixel) in (0..).zip(drawn) {
                let pixel = pixel.map(i64::from);
                assert_eq!(pixel[major] - from[major], made * (to[major] - from[major]).signum());
                // Twice the distance from the line, times the number of steps.
                let line = from[minor] * steps + made * (to[minor] - from[minor]);
                let off = 2 * (pixel[minor] * steps - line);
                assert!(-steps < off && off <= steps || steps == 0, "{algorithm:?} {ends:?}: {pixel:?}");
            }
        }
    }
}

#[test]
fn octants_mirror_each_other_and_a_line_is_the_same_backwards() {
    let mut random = Random::new(54);
    for _ in 0..2_000 {
        let [a, b] = far(&mut random);
        let drawn = all(Algorithm::Bresenham, [a, b]);
        let mut backwards = all(Algorithm::Bresenham, [b, a]);
        backwards.reverse();
        assert_eq!(drawn, backwards, "{a:?} {b:?}");
        let [dx, dy] = [0, 1].map(|axis| a[axis].abs_diff(b[axis]));
        if dx != dy {
            let swapped = all(Algorithm::Bresenham, [[a[1], a[0]], [b[1], b[0]]]);
            assert_eq!(drawn, swapped.into_iter().map(|[y, x]| [x, y]).collect::<Vec<_>>());
        }
        // An even number of steps can pass between two pixels, and then the mirror takes the other.
        if dx.max(dy) % 2 == 1 {
            let mirrored = all(Algorithm::Bresenham, [a, b].map(|[x, y]| [x, 299 - y]));
            assert_eq!(drawn, mirrored.into_iter().map(|[x, y]| [x, 299 - y]).collect::<Vec<_>>());
        }
    }
}

/// Between centres and without ties, diamonds and nearest pixels are the same, but for the last pixel.
#[test]
fn diamond_exit_between_centres_is_bresenham_without_the_last_pixel() {
    let mut random = Random::new(55);
    for _ in 0..2_000 {
        let ends = far(&mut random);
        let steps = [0, 1].map(|axis| ends[0][axis].abs_diff(ends[1][axis]));
        if steps[0].max(steps[1]) % 2 == 1 {
            let mut nearest = all(Algorithm::Bresenham, ends);
            nearest.pop();
            assert_eq!(all(Algorithm::DiamondExit, ends), nearest, "{ends:?}");
        }
    }
}

/// Whether a point of the closed diamond around a centre belongs to it, as Direct3D says.
fn belongs([u, v]: [&Ratio; 2], steep: bool) -> bool {
    let zero = Ratio::from(0.0);
    let abs = |x: &Ratio| if x.sign().is_negative() { &zero - x } else { x - &zero };
    let outline = &(&abs(u) + &abs(v)) - &Ratio::from(0.5);
    match outline.sign() {
        Sign::Negative => true,
        Sign::Zero => v.sign().is_positive() || steep && v.sign().is_zero() && u.sign().is_positive(),
        Sign::Positive => false,
    }
}

/// The judge: the part of the segment in the closed diamond in rational numbers. A pixel is drawn if an end or
/// the middle of that part belongs to the diamond, and the end of the segment does not.
fn is_left(ends: Segment, pixel: [u32; 2]) -> bool {
    let [[ax, ay], [bx, by]] = ends.map(|end| end.map(Dyadic::from));
    let [cx, cy] = pixel.map(|n| Dyadic::from(n as f32 + 0.5));
    let (dx, dy) = (&bx - &ax, &by - &ay);
    let (u, v) = (&ax - &cx, &ay - &cy);
    let steep = (dy.abs() - dx.abs()).sign().is_positive();
    let (mut t0, mut t1) = (Ratio::from(0.0), Ratio::from(1.0));
    for [su, sv] in [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]] {
        let [su, sv] = [su, sv].map(|sign: f32| Dyadic::from(sign));
        let room = Dyadic::from(0.5_f32) - (&su * &u + &sv * &v);
        let loss = &su * &dx + &sv * &dy;
        match loss.sign() {
            Sign::Zero if room.sign().is_negative() => return false,
            Sign::Zero => {}
            Sign::Positive => t1 = t1.min(Ratio::new(room, loss)),
            Sign::Negative => t0 = t0.max(Ratio::new(room, loss)),
        }
    }
    if t0 > t1 {
        return false;
    }
    let ratio = |x: &Dyadic| Ratio::new(x.clone(), Dyadic::one());
    let at = |t: &Ratio| [&ratio(&u) + &(t * &ratio(&dx)), &ratio(&v) + &(t * &ratio(&dy))];
    let holds = |[u, v]: [Ratio; 2]| belongs([&u, &v], steep);
    let middle = &(&t0 + &t1) * &Ratio::from(0.5);
    [&t0, &middle, &t1].into_iter().any(|t| holds(at(t))) && !holds(at(&Ratio::from(1.0)))
}

#[test]
fn diamonds_that_are_left_are_drawn() {
    let size = [7, 5];
    let mut random = Random::new(56);
    let mut drawn = 0;
    for round in 0..1_500 {
        let [a, b, _] = triangle(&mut random);
        // On corners and edges of diamonds, too.
        let quarters = [0; 2].map(|_| [0; 2].map(|_| random.below(32) as f32 / 4.0 - 0.5));
        let ends = if round % 2 == 0 { quarters } else { [a, b] };
        let mut found = pixels(Algorithm::DiamondExit, ends, size, Arithmetic::Exact, &mut Tally::default());
        drawn += found.len();
        found.sort_unstable();
        let image = (0..size[0]).flat_map(|x| (0..size[1]).map(move |y| [x, y]));
        let expected: Vec<_> = image.filter(|&pixel| is_left(ends, pixel)).collect();
        assert_eq!(found, expected, "{ends:?}");
    }
    assert!(drawn > 2_000, "{drawn}");
}

#[test]
fn pieces_of_a_straight_line_draw_each_of_its_pixels_once() {
    let mut random = Random::new(57);
    let draw =
        |ends| pixels(Algorithm::DiamondExit, ends, [40, 40], Arithmetic::Exact, &mut Tally::default());
    for _ in 0..3_000 {
        let start = [0; 2].map(|_| random.below(32) as f32 / 4.0 + 8.0);
        let step = [0; 2].map(|_| random.below(17) as f32 / 4.0 - 2.0);
        let corners: Vec<[f32; 2]> =
            (0..=4).map(|n| [0, 1].map(|axis| start[axis] + n as f32 * step[axis])).collect();
        let pieces: Vec<_> = corners.windows(2).flat_map(|pair| draw([pair[0], pair[1]])).collect();
        assert_eq!(pieces, draw([corners[0], corners[4]]), "{start:?} {step:?}");
    }
}

/// The diamond that holds a corner of a polyline is drawn by the line that starts there, not by the other.
#[test]
fn a_corner_of_a_polyline_is_drawn_once() {
    let mut random = Random::new(58);
    let mut corner = || [random.below(10) as f32 + 0.5, random.below(7) as f32 + 0.5];
    for _ in 0..1_000 {
        let (a, b, c) = (corner(), corner(), corner());
        let pixel = b.map(|x| x as u32);
        let [before, after] = [[a, b], [b, c]].map(|ends| {
            let drawn = run_diamonds(ends).0;
            drawn.iter().filter(|other| **other == pixel).count()
        });
        assert_eq!((before, after), (0, usize::from(b != c)), "{a:?} {b:?} {c:?}");
    }
}

#[test]
fn a_step_shows_the_decision_variable_before_and_after() {
    let mut player = bresenham::play([[1.5, 1.5], [10.5, 4.5]], SIZE, Budget::default());
    let aside = player.markers().into_iter().find(|(_, marker)| marker.role != player_role());
    player.seek(aside.expect("the line goes down").0);
    let sentence = player.sentence();
    assert_eq!(
        (sentence.id, format!("{:?}", sentence.args[0])),
        ("bresenham-aside", r#"("d", Int(3))"#.into())
    );
    let formula = format!("{:?}", player.formulas()[0].numbers.last());
    assert_eq!(formula, "Some(Result(Int(-9)))");
}

/// The role of a plain pixel on the timeline.
fn player_role() -> rasterscope_core::explain::Role {
    rasterscope_core::explain::Role::Neutral
}

#[test]
fn presets_of_two_sides_differ_as_their_notes_say() {
    let differ = |name: &str| {
        let pair = Pair::play(&scene(name), Budget::default()).expect("it compares").expect("it runs");
        let found = pair.difference();
        [found.only_a.len(), found.only_b.len(), found.changed.len()]
    };
    assert_eq!(differ("fill-star-non-zero"), [0, 7, 0]);
    for name in ["steps-f32-tie", "steps-f64-tie"] {
        let [only_a, only_b, _] = differ(name);
        assert!(only_a > 0 && only_a == only_b, "{name}: another pixel of the column");
    }
    let [moved, unmoved, _] = differ("two-sides-line");
    assert!(moved > unmoved, "the last pixel and those that the rounded ends move");
}
