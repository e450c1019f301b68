//! The whole pipeline: one known image, image laws, run counts.

use rasterscope_core::{
    depth::DepthFormat,
    labs::Stage,
    pipeline::{Reason, Skips, render},
    scene::{Draw, Geometry, Mesh, Scene},
};
use std::sync::Arc;

/// Draws of one triangle each, in one colour.
fn scene(triangles: &[([[f32; 3]; 3], [f32; 4])]) -> Scene {
    let draw = |(i, (positions, color)): (usize, &([[f32; 3]; 3], [f32; 4]))| {
        let name = char::from(b'A' + (i % 26) as u8);
        Draw::new(name, Geometry::Mesh(Arc::new(Mesh::soup(positions.to_vec(), *color))))
    };
    Scene { draws: triangles.iter().enumerate().map(draw).collect(), ..Scene::empty([36, 24]) }
}

/// Two triangles through each other, a third shows its back.
fn two_through_each_other() -> Scene {
    let mut scene = scene(&[
        ([[-3.4, -1.9, 0.9], [6.4, -1.0, -1.6], [0.2, 2.5, 0.1]], [1.0, 0.0, 0.0, 1.0]),
        ([[2.6, -2.3, 0.9], [1.9, 2.5, -1.0], [-3.3, 0.9, -0.9]], [0.0, 1.0, 0.0, 1.0]),
        ([[-3.6, -0.5, -0.9], [-1.1, 2.3, -0.6], [0.9, -2.1, 0.2]], [0.0, 0.0, 1.0, 1.0]),
    ]);
    scene.depth_format = DepthFormat::Unorm16;
    scene
}

/// The numbers that the design's mock of this scene was computed with, independently.
#[test]
fn known_scene_has_its_known_counts() {
    let frame = render(&two_through_each_other(), &Skips::ALL);
    let went = |stage| frame.stats.stage(stage).went;
    assert_eq!([went(Stage::Scene), went(Stage::Model), went(Stage::Cull), went(Stage::Clip)], [3, 9, 2, 3]);
    assert_eq!([went(Stage::Divide), went(Stage::Viewport)], [7, 7]);
    assert_eq!(frame.stats.stage(Stage::Cull).dropped(Reason::BackFace), 1);
    assert_eq!([went(Stage::Fragments), went(Stage::Depth)], [522, 422]);
    assert_eq!(frame.stats.stage(Stage::Depth).dropped(Reason::Depth), 100);
    assert_eq!(went(Stage::Image), 360);
    assert_eq!(frame.stats.stage(Stage::Image).dropped(Reason::Redrawn), 62);
    let at = frame.index([13, 11]);
    assert_eq!(frame.pixel([13, 11]), [255, 0, 0, 255]);
    assert_eq!(frame.depth_codes.as_ref().map(|codes| codes[at]), Some(0xDF60));
}
