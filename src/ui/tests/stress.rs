//! The stress lab: its dial is a slider, and a broken case opens small in its lab, with exact beside it.

use super::*;
use egui::{Key, Modifiers};
use rasterscope_core::{labs::LabInput, math::Arithmetic};

fn dial(window: &Window) -> u8 {
    match window.state().app().document.input() {
        LabInput::Stress(input) => input.dial,
        other => panic!("{} is open", other.name()),
    }
}

#[test]
fn the_dial_is_dragged_and_one_undo_takes_it_back() {
    let mut window = window_with("stress");
    let (before, runs) = (dial(&window), window.state().app().run.runs());
    let rail = place(&window, "Dial");
    drag(&mut window, rail.center(), rail.left_center() + vec2(2.0, 0.0));
    assert_eq!(dial(&window), 0);
    assert!(window.state().app().run.runs() > runs, "it answers at once");
    window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    window.run();
    assert_eq!(dial(&window), before);
}

#[test]
fn a_broken_case_opens_small_in_its_lab_with_exact_beside_it() {
    for (preset, lab) in [
        ("stress-beside", "scanline"),
        ("stress-nearly-parallel", "cohen-sutherland"),
        ("stress-long", "plane-equation"),
        ("stress-sliver", "area-ratios"),
    ] {
        let mut window = window(1280.0, 720.0);
        window.state_mut().app_mut().open_preset(preset);
        window.run();
        click(&mut window, "Open it in its lab");
        let app = window.state().app();
        assert_eq!(app.document.input().name(), lab);
        assert_eq!(app.problem(), None, "{preset}");
        let pair = app.run.pair().expect("two sides");
        assert!(pair.difference().count() > 0, "{preset}: they differ");
        window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        window.run();
        assert_eq!(window.state().app().document.input().name(), "stress");
    }
}

#[test]
fn a_case_that_holds_opens_nothing_and_says_so() {
    let mut window = window_with("stress");
    let LabInput::Stress(mut input) = *window.state().app().document.input() else { panic!("it is open") };
    (input.dial, input.arithmetic) = (0, Arithmetic::F64);
    *window.state_mut().app_mut().document.input_mut() = input.into();
    window.run();
    click(&mut window, "Open it in its lab");
    assert_eq!(window.state().app().document.input().name(), "stress");
    assert!(window.state().app().notice.is_some());
}
