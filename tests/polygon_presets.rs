//! The presets of polygon clipping are the special cases that their sentences claim.

use crate::presets::scene;
use rasterscope_core::{
    clip::{
        line::Window,
        polygon::{
            sutherland_hodgman::{self as sh, Settings, bridges},
            weiler_atherton as wa,
        },
    },
    labs::{ClipPolygon, LabInput},
    replay::{Budget, Playback},
};

fn input(name: &str) -> (ClipPolygon, Window) {
    let Some(LabInput::ClipPolygon(input)) = scene(name).lab.map(|lab| lab.input) else {
        panic!("{name} opens a lab that clips a polygon");
    };
    let window = Window::new(input.window).expect("the preset's window is right");
    (input, window)
}

/// The last state of Sutherland-Hodgman on a preset.
fn side_by_side(name: &str) -> (sh::Snapshot, Window) {
    let (input, window) = input(name);
    let ClipPolygon { arithmetic, order, mistake, .. } = input;
    let settings = Settings { arithmetic, order, mistake };
    let mut player = sh::play(&input.all(), window, settings, Budget::default());
    player.seek(player.len());
    (player.state().clone(), window)
}

#[test]
fn polygons_lose_and_gain_the_corners_that_are_claimed() {
    let cases = [
        ("polygon-triangle", 7, 0),
        ("polygon-e-shape", 12, 2),
        ("polygon-around", 4, 0),
        ("polygon-touches-a-corner", 0, 0),
    ];
    for (name, corners, bridged) in cases {
        let (state, window) = side_by_side(name);
        let result = &state.results()[0];
        assert_eq!((result.len(), bridges(result, &window).len()), (corners, bridged), "{name}");
    }
}

#[test]
fn neighbours_crack_and_forgotten_sides_show() {
    assert!(!side_by_side("polygon-crack").0.cracks().is_empty());
    let (state, window) = side_by_side("polygon-two-sides");
    assert!(state.results()[0].iter().any(|corner| corner.at[0] > window.xmax && corner.at[1] < window.ymax));
    assert!(state.results()[0].iter().any(|corner| corner.at[1] > window.ymax));
    assert!(
        state.results()[0].iter().all(|corner| corner.at[0] >= window.xmin && corner.at[1] >= window.ymin)
    );
}

#[test]
fn pieces_and_holes_are_as_many_as_claimed() {
    let cases: [(&str, &[usize]); 5] = [
        ("pieces-convex", &[0]),
        ("pieces-three", &[0, 0, 0]),
        ("pieces-holes", &[1]),
        ("pieces-star", &[0]),
        ("pieces-around", &[1]),
    ];
    for (name, holes) in cases {
        let (input, window) = input(name);
        let pieces = wa::clip(&input.all(), &window);
        assert_eq!(pieces.iter().map(|piece| piece.holes.len()).collect::<Vec<_>>(), holes, "{name}");
    }
}
