//! The engine for whole frames: the same bytes as the rasterizers and the z-buffer triangle by triangle, whatever
//! is left out and on every vector unit.

use crate::support::{Random, triangle};
use rasterscope_core::{
    depth::{CompareFunction, DepthFormat, DepthRows, DepthState, z_buffer},
    engine::{Canvas, Clear, Colors, Engine, Lanes, State, Stats, Stencil, Triangles},
    math::Tally,
    pipeline::{Skip, Skips},
    raster::{Algorithm, FillRule, Settings, YAxis, cover},
    stencil::{StencilOperation, StencilOutcome, StencilState},
};

/// Larger than a tile, and not a multiple of one.
const SIZE: [u32; 2] = [97, 70];

const CLEAR: Clear = Clear { color: [9, 9, 9, 255], depth: 1.0, stencil: 3 };

type Triangle = [[f32; 3]; 3];

fn color_of(index: usize) -> [u8; 4] {
    (index as u32 + 1).to_be_bytes()
}

fn drawn(triangles: &[Triangle], state: &State, clear: Clear) -> (Canvas, Stats) {
    let colors: Vec<_> = (0..triangles.len()).map(color_of).collect();
    let mut canvas = Canvas::new(SIZE, Clear::default(), Stencil::With);
    let input =
        Triangles { positions: triangles.as_flattened(), indices: None, colors: Colors::Each(&colors) };
    let stats = Engine::default().draw(&mut canvas, Some(clear), &input, state);
    (canvas, stats)
}

fn bits(depths: &[f32]) -> Vec<u32> {
    depths.iter().map(|z| z.to_bits()).collect()
}

/// The z-buffer one triangle after another, with the rasterizer for one triangle.
fn check(triangles: &[Triangle], state: &State) {
    let settings = z_buffer::Settings {
        algorithm: Algorithm::Scanline,
        raster: Settings { fill_rule: state.fill_rule, y_axis: state.y_axis, ..Settings::new(SIZE) },
        clear: CLEAR.depth,
        state: state.depth,
        ..z_buffer::Settings::new(SIZE)
    };
    let expected = z_buffer::draw(triangles, &settings);
    let pixels = (0..SIZE[1]).flat_map(|y| (0..SIZE[0]).map(move |x| [x, y]));
    let colors: Vec<_> = pixels
        .map(|pixel| expected.owner(pixel).map_or(CLEAR.color, |index| color_of(index as usize)))
        .collect();
    for lanes in Lanes::all() {
        let (canvas, _) = drawn(triangles, &State { lanes, ..*state }, CLEAR);
        assert!(canvas.color() == colors, "{} {state:?} {triangles:?}", lanes.name());
        assert!(bits(canvas.depth()) == expected.depth.codes(), "{} {state:?} {triangles:?}", lanes.name());
    }
}

/// A nasty triangle, moved to where four tiles meet, with nasty depths.
fn nasty(random: &mut Random) -> Triangle {
    let [dx, dy] = [random.pick(&[0.0, 60.0, 88.0]), random.pick(&[0.0, 60.0])];
    let flat = random.below(4) == 0;
    let constant = random.uniform(0.0, 1.0);
    triangle(random).map(|[x, y]| {
        let z = match random.below(6) {
            _ if flat => constant,
            0 => random.any(),
            1 => random.grid(-1, 2),
            2 => random.near(0.5),
            _ => random.uniform(0.0, 1.0),
        };
        [x + dx, y + dy, z]
    })
}

fn any_state(random: &mut Random) -> State {
    let mut state = State::default();
    if random.below(2) == 0 {
        state.fill_rule = random.pick(&FillRule::ALL);
    }
    if random.below(2) == 0 {
        state.y_axis = YAxis::Up;
    }
    if random.below(2) == 0 {
        let compare = random.pick(&CompareFunction::ALL);
        state.depth = DepthState { test: random.below(4) > 0, compare, write: random.below(3) > 0 };
    }
    state
}

#[test]
fn frames_are_what_the_z_buffer_draws() {
    let mut random = Random::new(1993);
    for _ in 0..250 {
        let count = 1 + random.below(24);
        let triangles: Vec<_> = (0..count).map(|_| nasty(&mut random)).collect();
        let finite = |triangle: &Triangle| triangle.as_flattened().iter().all(|number| number.is_finite());
        let triangles: Vec<_> = triangles.into_iter().filter(finite).collect();
        check(&triangles, &any_state(&mut random));
    }
}

#[test]
fn ordinary_frames_are_what_the_z_buffer_draws() {
    let mut random = Random::new(3);
    for size in [3.0, 12.0, 40.0, 150.0] {
        let mut corner = |around: [f32; 2]| {
            let [x, y] = around.map(|at| at + random.uniform(-size, size));
            [x, y, random.uniform(0.0, 1.0)]
        };
        let mut places = Random::new(size as u64);
        let triangles: Vec<_> = (0..200)
            .map(|_| {
                let around = [places.uniform(-5.0, 102.0), places.uniform(-5.0, 75.0)];
                [corner(around), corner(around), corner(around)]
            })
            .collect();
        check(&triangles, &State::default());
    }
}

/// Depths of any size, from below the least normal number to the greatest, some of them halfway between two numbers.
#[test]
fn depths_of_any_size_are_rounded_once() {
    let mut random = Random::new(1971);
    let always = DepthState { compare: CompareFunction::Always, ..DepthState::default() };
    for exponent in (-149..=127).step_by(4) {
        let unit = 2_f64.powi(exponent);
        let triangles: Vec<Triangle> = (0..6)
            .map(|round| {
                // Steps of half a unit of the last place across each pixel, or anything.
                let halves = f64::from(random.below(64)) / f64::from(1 << 25);
                nasty(&mut random).map(|[x, y, _]| {
                    let z = match round {
                        0..3 => 1.0 + halves * f64::from(x.floor()),
                        _ => f64::from(random.uniform(-2.0, 2.0)),
                    };
                    [x, y, (z * unit) as f32]
                })
            })
            .filter(|triangle: &Triangle| triangle.as_flattened().iter().all(|number| number.is_finite()))
            .collect();
        for depth in [DepthState::default(), always] {
            check(&triangles, &State { depth, ..State::default() });
        }
    }
}

/// A pile of squares over all tiles, most of them hidden by the first.
fn pile() -> Vec<Triangle> {
    let square = |z: f32, x0: f32, y0: f32, x1: f32, y1: f32| {
        [[[x0, y0, z], [x1, y0, z], [x1, y1, z + 0.01]], [[x0, y0, z], [x1, y1, z + 0.01], [x0, y1, z]]]
    };
    let front = square(0.2, -10.0, -10.0, 90.0, 80.0);
    let behind = (0..6).flat_map(|i| square(0.3 + i as f32 * 0.1, i as f32, 0.0, 97.0, 70.5));
    front.into_iter().chain(behind).collect()
}

#[test]
fn no_skip_changes_a_byte_and_each_is_counted() {
    let triangles = pile();
    let (expected, counted) = drawn(&triangles, &State::default(), CLEAR);
    assert!(counted.hidden > 100 && counted.beside > 0, "{counted:?}");
    for skip in [Skip::Tile, Skip::HierarchicalZ, Skip::Clear] {
        let state = State { skips: Skips::ALL.with(skip, false), ..State::default() };
        let (canvas, stats) = drawn(&triangles, &state, CLEAR);
        assert!(canvas.color() == expected.color() && bits(canvas.depth()) == bits(expected.depth()));
        match skip {
            Skip::Tile => assert_eq!(stats.beside, 0),
            Skip::HierarchicalZ => assert_eq!(stats.hidden, 0),
            _ => {}
        }
    }
}

/// Planes through each other, some of them the same: of equal depths the first drawn wins, in whatever order tiles draw.
#[test]
fn of_equal_depths_the_first_wins_front_to_back_too() {
    let mut random = Random::new(13);
    for _ in 0..40 {
        let planes: Vec<[f32; 3]> = (0..4)
            .map(|_| [random.grid(0, 3) / 4.0, random.grid(-1, 2) / 256.0, random.grid(-1, 2) / 256.0])
            .collect();
        let triangles: Vec<Triangle> = (0..60)
            .map(|_| {
                let [z, dx, dy] = planes[random.below(4) as usize];
                [(); 3].map(|()| {
                    let [x, y] = [random.grid(-20, 120), random.grid(-20, 90)];
                    [x, y, z + dx * x + dy * y]
                })
            })
            .collect();
        check(&triangles, &State::default());
        let (canvas, stats) = drawn(&triangles, &State::default(), CLEAR);
        assert_eq!(stats.sorted, 4);
        // Over what is there already: the second time nothing is nearer.
        let colors = vec![[1; 4]; triangles.len()];
        let again =
            Triangles { positions: triangles.as_flattened(), indices: None, colors: Colors::Each(&colors) };
        let mut twice = canvas.clone();
        let stats = Engine::default().draw(&mut twice, None, &again, &State::default());
        assert_eq!(stats.sorted, 4);
        assert!(twice.color() == canvas.color() && bits(twice.depth()) == bits(canvas.depth()));
    }
}

#[test]
fn only_tiles_that_were_drawn_to_are_cleared_again() {
    let positions = [[70.0, 5.0, 0.5], [90.0, 5.0, 0.5], [70.0, 30.0, 0.5]];
    let one = Triangles { positions: &positions, indices: None, colors: Colors::One([1; 4]) };
    let none = Triangles { positions: &[], ..one };
    let mut engine = Engine::default();
    let mut canvas = Canvas::new(SIZE, CLEAR, Stencil::With);
    let fresh = canvas.clone();
    let state = State::default();
    // Of four tiles one is drawn to.
    assert_eq!(engine.draw(&mut canvas, Some(CLEAR), &one, &state).clean, 3);
    assert_eq!(engine.draw(&mut canvas, Some(CLEAR), &none, &state).clean, 3);
    assert!(canvas.color() == fresh.color() && canvas.depth() == fresh.depth());
    assert!(canvas.stencil() == fresh.stencil());
    assert_eq!(engine.draw(&mut canvas, Some(CLEAR), &none, &state).clean, 4);
    // To other values all are.
    let other = Clear { depth: 0.5, ..CLEAR };
    assert_eq!(engine.draw(&mut canvas, Some(other), &none, &state).clean, 0);
    assert!(canvas.depth().iter().all(|z| *z == 0.5));
}

#[test]
fn later_draws_go_over_what_is_there() {
    let triangles = pile();
    let colors: Vec<_> = (0..triangles.len()).map(color_of).collect();
    let (expected, _) = drawn(&triangles, &State::default(), CLEAR);
    let (mut engine, mut canvas) = (Engine::default(), Canvas::new(SIZE, CLEAR, Stencil::Without));
    for (triangle, color) in triangles.iter().zip(&colors) {
        let one = Triangles { positions: triangle, indices: None, colors: Colors::One(*color) };
        engine.draw(&mut canvas, None, &one, &State::default());
    }
    assert!(canvas.color() == expected.color() && bits(canvas.depth()) == bits(expected.depth()));
    let (color, depth, stencil) = canvas.into_parts();
    assert!(Canvas::from_parts([97, 71], color.clone(), depth.clone(), stencil.clone()).is_none());
    assert!(Canvas::from_parts(SIZE, color, depth, stencil).is_some());
}

#[test]
fn a_mesh_is_covered_exactly_once() {
    let count = StencilState { pass_op: StencilOperation::IncrementWrap, ..StencilState::default() };
    let depth = DepthState { test: false, ..DepthState::default() };
    let mut random = Random::new(88);
    for round in 0..20 {
        // A grid whose inner vertices are moved about: on centres, beside them, anywhere.
        let (columns, rows) = (7_u32, 5);
        let mut positions = Vec::new();
        for row in 0..=rows {
            for column in 0..=columns {
                let mut move_by = |inner: bool| match round % 3 {
                    _ if !inner => 0.0,
                    0 => random.below(5) as f32 - 2.0,
                    1 => random.near(random_centre(round)) - random_centre(round),
                    _ => random.uniform(-2.0, 2.0),
                };
                let x = column as f32 * 13.0 + 1.5 + move_by(column > 0 && column < columns);
                let y = row as f32 * 12.0 + 2.5 + move_by(row > 0 && row < rows);
                positions.push([x, y, 0.5]);
            }
        }
        let mut indices = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                let at = row * (columns + 1) + column;
                let [a, b, c, d] = [at, at + 1, at + columns + 1, at + columns + 2];
                indices.extend([[a, b, d], [a, c, d]]);
            }
        }
        let mesh = Triangles { positions: &positions, indices: Some(&indices), colors: Colors::One([5; 4]) };
        let state = State { stencil: Some(count), depth, ..State::default() };
        let mut canvas = Canvas::new(SIZE, Clear::default(), Stencil::With);
        Engine::default().draw(&mut canvas, Some(Clear::default()), &mesh, &state);
        for (at, hits) in canvas.stencil().iter().enumerate() {
            let (x, y) = (at as u32 % SIZE[0], at as u32 / SIZE[0]);
            let inside = (1..1 + 91).contains(&x) && (2..2 + 60).contains(&y);
            assert_eq!(*hits, u8::from(inside), "round {round}, pixel {x} {y}");
        }
    }
}

fn random_centre(round: u32) -> f32 {
    round as f32 / 4.0 + 0.5
}

#[test]
fn stencil_and_depth_work_as_one_after_another() {
    let mut random = Random::new(23);
    for _ in 0..40 {
        let triangles: Vec<_> = (0..12)
            .map(|_| [(); 3].map(|()| [random.grid(0, 97), random.grid(0, 70), random.grid(0, 1)]))
            .collect();
        let stencil = StencilState {
            compare: random.pick(&CompareFunction::ALL),
            fail_op: random.pick(&StencilOperation::ALL),
            depth_fail_op: random.pick(&StencilOperation::ALL),
            pass_op: random.pick(&StencilOperation::ALL),
            read_mask: 7,
            write_mask: random.bits() as u8,
            reference: random.below(8) as u8,
        };
        let state = State { stencil: Some(stencil), ..any_state(&mut random) };
        let (canvas, _) = drawn(&triangles, &state, CLEAR);
        let settings = Settings { fill_rule: state.fill_rule, y_axis: state.y_axis, ..Settings::new(SIZE) };
        let pixels = (SIZE[0] * SIZE[1]) as usize;
        let mut stencils = vec![CLEAR.stencil; pixels];
        let mut depths = vec![CLEAR.depth.to_bits(); pixels];
        let tally = &mut Tally::default();
        for triangle in &triangles {
            let plane = DepthRows::new(*triangle, DepthFormat::F32, tally);
            let points = triangle.map(|[x, y, _]| [x, y]);
            cover(Algorithm::Aabb, points, &settings, &mut Tally::default(), &mut |span| {
                for x in span.begin..span.end {
                    let at = (span.y * SIZE[0] + x) as usize;
                    let code = plane.row(span.y).code(x, tally);
                    let outcome = if !stencil.passes(stencils[at]) {
                        StencilOutcome::Fail
                    } else if DepthFormat::F32.test(state.depth, code, &mut depths[at]) {
                        StencilOutcome::Pass
                    } else {
                        StencilOutcome::DepthFail
                    };
                    stencils[at] = stencil.after(outcome, stencils[at]);
                }
            });
        }
        assert!(canvas.stencil() == stencils, "{state:?} {triangles:?}");
        // Without stencil values of its own, too.
        let mut bare = Canvas::new(SIZE, Clear::default(), Stencil::Without);
        let input = Triangles {
            positions: triangles.as_flattened(),
            indices: None,
            colors: Colors::Each(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11].map(color_of)),
        };
        Engine::default().draw(&mut bare, Some(CLEAR), &input, &state);
        assert!(bare.color() == canvas.color(), "{state:?} {triangles:?}");
        assert!(bits(canvas.depth()) == depths, "{state:?} {triangles:?}");
    }
}

#[test]
fn what_is_no_triangle_is_not_drawn() {
    let (inf, nan) = (f32::INFINITY, f32::NAN);
    let [a, b, c] = [[10.0, 10.0, 0.5], [50.0, 10.0, 0.5], [10.0, 50.0, 0.5]];
    let positions = [a, b, c, [nan, 0.0, 0.5], [0.0, inf, 0.5], [0.0, 0.0, nan], [0.0, 0.0, -inf], [30.0; 3]];
    let indices =
        [[0, 1, 3], [4, 1, 2], [0, 5, 2], [6, 1, 2], [0, 1, 8], [u32::MAX, 1, 2], [0, 7, 7], [2, 7, 7]];
    let mut canvas = Canvas::new(SIZE, CLEAR, Stencil::Without);
    let input = Triangles { positions: &positions, indices: Some(&indices), colors: Colors::One([1; 4]) };
    let stats = Engine::default().draw(&mut canvas, None, &input, &State::default());
    assert_eq!((stats.triangles, stats.culled), (8, 6));
    assert!(canvas.color().iter().all(|codes| *codes == CLEAR.color));
    // Without a whole number of triangles the rest is left out, and so are those without a colour.
    let four = Triangles { positions: &positions[..5], indices: None, colors: Colors::Each(&[[2; 4]; 7]) };
    assert_eq!(four.len(), 1);
    assert!(Triangles { colors: Colors::Each(&[]), ..four }.is_empty());
}
