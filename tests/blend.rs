//! Blending: every pair of codes at every alpha against integers, laws, golden logs, and rational
//! arithmetic for every factor and operation.

use crate::{
    presets::scene,
    support::{Coverage, Random, check_golden, check_laws, log_text},
};
use num_bigint::BigInt;
use num_traits::FromPrimitive;
use rasterscope_core::{
    blend::{
        BlendComponent, BlendFactor, BlendOperation, BlendState, ExactColor, Mode, blend,
        layers::{self, Blended, Event, Layer, Order, Settings, Snapshot},
    },
    labs::{self, Blend, LabInput},
    math::{Approx, Dyadic, Tally},
    message::Value,
    replay::{Budget, Playback},
};

/// All 65 536 pairs at each of 256 alphas: three pairs a call, one in each colour channel.
#[test]
fn over_is_exact_for_all_pairs_of_codes_at_every_alpha() {
    let state = Mode::Over.state();
    let mut tally = Tally::default();
    let codes: Vec<u32> = (0..=255).collect();
    for alpha in 0..=255 {
        for source in codes.chunks(3) {
            let channels = [0, 1, 2].map(|i| source.get(i).copied().unwrap_or(0));
            let [r, g, b] = channels;
            let near = [r, g, b, alpha].map(|code| Approx::exact(f64::from(code)) / Approx::exact(255.0));
            let exact = || ExactColor {
                channels: [r, g, b, alpha].map(Dyadic::from),
                denominator: Dyadic::from(255),
            };
            for stored in 0..=255 {
                let got = blend(&state, near, exact, [stored; 4], &mut tally);
                // floor(255 c + 1/2) of c = (a s + (255 - a) d) / 255^2.
                let over = |s: u32| (2 * (alpha * s + (255 - alpha) * u32::from(stored)) + 255) / 510;
                let expected = [over(r), over(g), over(b), over(255)];
                assert_eq!(got.map(u32::from), expected, "{source:?} alpha {alpha} over {stored}");
            }
        }
    }
    assert_eq!(tally.exact, 0, "no result lies between two codes: 255 is odd");
}

/// What all values are integer multiples of: one part in 255 * 2^149 is fine enough for every binary32
/// number and for every code.
fn unit() -> BigInt {
    BigInt::from(255) << 149
}

fn number(value: f32) -> BigInt {
    BigInt::from_f64(f64::from(value) * 2f64.powi(149)).expect("a whole number") * 255
}

/// WebGPU's factors.
fn factor(
    (factor, constant): (BlendFactor, &[BigInt; 4]),
    source: &[BigInt; 4],
    stored: &[BigInt; 4],
    channel: usize,
) -> BigInt {
    match factor.name() {
        "zero" => BigInt::from(0),
        "one" => unit(),
        "src" => source[channel].clone(),
        "one-minus-src" => unit() - &source[channel],
        "src-alpha" => source[3].clone(),
        "one-minus-src-alpha" => unit() - &source[3],
        "dst" => stored[channel].clone(),
        "one-minus-dst" => unit() - &stored[channel],
        "dst-alpha" => stored[3].clone(),
        "one-minus-dst-alpha" => unit() - &stored[3],
        "src-alpha-saturated" if channel == 3 => unit(),
        "src-alpha-saturated" => source[3].clone().min(unit() - &stored[3]),
        "constant" => constant[channel].clone(),
        "one-minus-constant" => unit() - &constant[channel],
        other => panic!("WebGPU has no {other}"),
    }
}

/// The code of one channel without a rounding before the last: products are multiples of the unit squared.
fn oracle(state: &BlendState, color: [f32; 4], stored: [u8; 4], channel: usize) -> u8 {
    let (source, constant) = (color.map(number), state.constant.map(number));
    let stored = stored.map(|code| BigInt::from(code) << 149);
    let BlendComponent { src_factor, dst_factor, operation } = *state.component(channel);
    let (new, old) = (&source[channel], &stored[channel]);
    let [fs, fd] =
        [src_factor, dst_factor].map(|which| factor((which, &constant), &source, &stored, channel));
    let result = match operation.name() {
        "add" => new * fs + old * fd,
        "subtract" => new * fs - old * fd,
        "reverse-subtract" => old * fd - new * fs,
        "min" => new.min(old) * unit(),
        "max" => new.max(old) * unit(),
        other => panic!("WebGPU has no {other}"),
    };
    let square = unit() * unit();
    // Clamped from below first: division of big integers truncates.
    let code: BigInt = (result.max(BigInt::from(0)) * 510 + &square) / (&square * 2);
    u8::try_from(code.min(BigInt::from(255))).expect("clamped")
}

fn any_color(random: &mut Random) -> [f32; 4] {
    [0; 4].map(|_| match random.below(4) {
        0 => random.below(9) as f32 / 8.0,
        1 => random.below(256) as f32 / 255.0,
        _ => random.uniform(0.0, 1.0).clamp(0.0, 1.0),
    })
}

fn any_state(random: &mut Random) -> BlendState {
    if random.below(3) == 0 {
        return random.pick(&Mode::ALL).state();
    }
    let mut component = || BlendComponent {
        src_factor: random.pick(&BlendFactor::ALL),
        dst_factor: random.pick(&BlendFactor::ALL),
        operation: random.pick(&BlendOperation::ALL),
    };
    let [color, alpha] = [component(), component()];
    BlendState { color, alpha, constant: any_color(random) }
}

fn any_layers(random: &mut Random) -> (Vec<Layer>, Settings) {
    let layers = (0..random.below(6)).map(|_| Layer {
        color: any_color(random),
        depth: random.below(5) as f32 / 4.0,
        state: any_state(random),
    });
    let layers = layers.collect();
    let order = random.pick(&[Order::AsDrawn, Order::Reversed, Order::Sorted]);
    (layers, Settings { order, clear: any_color(random) })
}

fn run(layers: &[Layer], settings: &Settings) -> (Blended, Vec<Event>) {
    let mut events = Vec::new();
    let blended = layers::blend_layers_traced(layers, settings, &mut Tally::default(), &mut events);
    (blended, events)
}

#[test]
fn every_factor_and_operation_equals_rational_arithmetic() {
    let mut random = Random::new(61);
    for _ in 0..4_000 {
        let (layers, settings) = any_layers(&mut random);
        let blended = layers::blend_layers(&layers, &settings);
        let mut stored = settings.codes();
        for (index, after) in &blended.after {
            let Layer { color, state, .. } = layers[usize::from(*index)];
            let expected: [u8; 4] = std::array::from_fn(|channel| oracle(&state, color, stored, channel));
            assert_eq!(*after, expected, "{color:?} over {stored:?} by {state:?}");
            stored = *after;
        }
        assert_eq!(blended.color, stored);
    }
}

#[test]
fn keeps_the_laws() {
    let mut random = Random::new(62);
    let mut coverage = Coverage::default();
    for _ in 0..200 {
        let (layers, settings) = any_layers(&mut random);
        let fast = layers::blend_layers(&layers, &settings);
        let (traced, events) = run(&layers, &settings);
        check_laws(
            (&fast, &traced),
            &events,
            |budget| layers::play(&layers, &[], settings, budget),
            |state: &Snapshot| state.result().clone(),
            &mut coverage,
        );
    }
    coverage.check_every_line::<Snapshot>();
}

/// A preset's layers, in the order of its file.
fn layers_of(name: &str) -> (Vec<Layer>, Settings) {
    let Some(LabInput::Blend(input)) = scene(name).lab.map(|lab| lab.input) else {
        panic!("{name} opens the lab");
    };
    let state = input.blend_state();
    let layer = |&labs::Layer { color, depth, .. }: &labs::Layer| Layer { color, depth, state };
    (input.layers.iter().map(layer).collect(), Settings { order: input.order, clear: input.clear })
}

#[test]
fn presets_step_by_step() {
    for name in ["blend-over", "blend-list"] {
        let (layers, mut settings) = layers_of(name);
        if name == "blend-list" {
            settings.order = Order::Sorted;
        }
        let (_, events) = run(&layers, &settings);
        check_golden(&format!("blend/{}", name.trim_start_matches("blend-")), &log_text(&events));
    }
}

/// Every order in which three layers can come, and a list of all of them.
#[test]
fn a_sorted_list_does_not_depend_on_the_order() {
    let (layers, settings) = layers_of("blend-list");
    let orders = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];
    let results = |order| {
        let settings = Settings { order, ..settings };
        let mut colors =
            orders.map(|order| layers::blend_layers(&order.map(|i: usize| layers[i]), &settings).color);
        colors.sort_unstable();
        colors
    };
    let drawn = results(Order::AsDrawn);
    assert!(drawn.windows(2).all(|pair| pair[0] != pair[1]), "as drawn every order has its own colour");
    let sorted = results(Order::Sorted);
    assert!(sorted.iter().all(|color| *color == sorted[0]));
    let farthest_first = [1, 2, 0].map(|i| layers[i]);
    assert_eq!(layers::blend_layers(&farthest_first, &settings).color, sorted[0]);
}

#[test]
fn alpha_is_seven_tenths_by_the_formula_and_less_by_the_factors_of_the_colour() {
    let (mut layers, settings) = layers_of("blend-alpha-factors");
    let alpha = |layers: &[Layer]| layers::blend_layers(layers, &settings).color[3];
    assert_eq!(alpha(&layers), 179, "0.7, half-way between two codes");
    layers[0].state = Mode::ColorFactors.state();
    assert_eq!(alpha(&layers), 115, "0.45");
}

#[test]
fn presets_are_what_they_say() {
    let end = |name: &str| {
        let (layers, settings) = layers_of(name);
        let both = [Order::AsDrawn, Order::Reversed];
        both.map(|order| layers::blend_layers(&layers, &Settings { order, ..settings }).color)
    };
    for name in ["blend-two-orders", "blend-three-orders", "blend-over"] {
        let [drawn, reversed] = end(name);
        assert_ne!(drawn, reversed, "{name}");
    }
    for name in ["blend-min", "blend-max", "blend-multiply"] {
        let [drawn, reversed] = end(name);
        assert_eq!(drawn, reversed, "{name}");
    }
    let [color, _] = end("blend-constant");
    assert_eq!(color, [77, 115, 178, 255], "a quarter of the way from the first picture to the second");
    let [color, _] = end("blend-additive");
    assert_eq!(color[0], 255, "red is clamped");
    let [color, _] = end("blend-premultiplied");
    assert!(color[0] > 127, "a layer of alpha 0 added light");
}

#[test]
fn a_channel_says_its_numbers() {
    let (layers, settings) = layers_of("blend-over");
    let mut run = layers::play(&layers, &[], settings, Budget::default());
    run.seek(2);
    let sentence = run.sentence();
    assert_eq!(sentence.id, "blend-channel");
    let argument =
        |name: &str| sentence.args.iter().find(|(key, _)| *key == name).map(|(_, value)| value.clone());
    assert_eq!(argument("code"), Some(Value::text(230)), "0.8 half over white");
    assert_eq!(run.formulas().len(), 2);
}

#[test]
fn too_many_layers_are_refused() {
    let Some(LabInput::Blend(input)) = labs::default_input("blend") else { panic!("there is one") };
    let mut scene = scene("blend-over");
    let many = vec![input.layers[0].clone(); layers::MOST + 1];
    scene.lab = Some(rasterscope_core::scene::Lab::new(Blend { layers: many, ..input }));
    assert!(scene.validate().is_err());
}
