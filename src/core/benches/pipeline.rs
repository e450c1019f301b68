//! How long an edit takes to reach the image. Run with `cargo bench -p rasterscope-core --bench pipeline
//! [-- MODEL.obj]`; without a model only the built-in rows are printed.
//!
//! The rows take turns, so that a busy moment of the machine hits them all. Each row checks its own
//! answer, so that nothing fast and wrong is timed.
#![expect(clippy::print_stdout, reason = "it prints a table")]

use rasterscope_core::{
    blend::Mode,
    engine::Threads,
    labs::Stage,
    pipeline::{Frame, Picture, Pipeline, Rasterizer, Skips, render},
    raster::Algorithm,
    scene::{Draw, Geometry, MODEL_SIZE, Mesh, Scene, Shade, preset, scene_from_obj},
    stencil::{StencilOperation, StencilState},
};
use std::{
    hint::black_box,
    sync::Arc,
    time::{Duration, Instant},
};

const ROUNDS: usize = 21;

/// One line of the table.
struct Row {
    name: String,
    run: Box<dyn FnMut() -> Duration>,
    times: Vec<Duration>,
}

impl Row {
    fn new(name: impl Into<String>, run: impl FnMut() -> Duration + 'static) -> Self {
        Self { name: name.into(), run: Box::new(run), times: Vec::new() }
    }
}

fn default_scene(size: [u32; 2]) -> Scene {
    let preset = preset("two-through-each-other").expect("it is built in");
    let scene = Scene::from_json(preset.json.as_bytes()).expect("presets are right");
    Scene { size, ..scene }
}

/// Re-evaluates after one vertex moved back and forth.
fn drag(size: [u32; 2], rasterizer: Rasterizer, name: &str) -> Row {
    let mut scene = default_scene(size);
    let places = [0.0, 0.125].map(|by| {
        let mut mesh = Mesh::clone(scene.draws[0].geometry.mesh().expect("it is a mesh"));
        mesh.positions[0][0] += by;
        Arc::new(mesh)
    });
    let expected = places.clone().map(|mesh| {
        scene.draws[0].geometry = Geometry::Mesh(mesh);
        render(&scene, &Skips::NONE)
    });
    assert!(!expected[0].same_image(&expected[1]), "the drag must show");
    let mut pipeline = Pipeline::new(rasterizer);
    let mut turn = 0;
    let name = format!("drag a vertex, {}x{}, {}", size[0], size[1], name);
    Row::new(name, move || {
        turn = 1 - turn;
        scene.draws[0].geometry = Geometry::Mesh(places[turn].clone());
        let start = Instant::now();
        black_box(pipeline.update(&scene, &Skips::ALL));
        let time = start.elapsed();
        assert!(pipeline.outputs().frame.same_image(&expected[turn]));
        time
    })
}

/// From the bytes of a model to its first image.
fn first_image(path: String) -> Row {
    let bytes = std::fs::read(&path).expect("the model can be read");
    let draw = move |skips: Skips| -> Frame {
        let mesh = Mesh::from_obj(&bytes).expect("the model is right");
        render(&scene_from_obj("model.obj", mesh, MODEL_SIZE), &skips)
    };
    let expected = draw(Skips::NONE);
    assert!(expected.stats.stage(Stage::Image).went > 10_000, "it must be seen");
    Row::new(format!("bytes to first image, 1280x720, {path}"), move || {
        let start = Instant::now();
        let frame = draw(Skips::ALL);
        let time = start.elapsed();
        assert!(frame.same_image(&expected));
        time
    })
}

/// What an image is drawn by.
enum By {
    /// With all stages' outputs and counts.
    Pipeline(Box<Pipeline>),
    /// The image alone.
    Picture(Box<Picture>),
}

impl By {
    fn name(&self) -> &'static str {
        match self {
            Self::Pipeline(pipeline) if pipeline.rasterizer == Rasterizer::Engine => "engine",
            Self::Pipeline(_) => "scan line",
            Self::Picture(_) => "image alone",
        }
    }

    fn draw(&mut self, scene: &Scene) {
        match self {
            Self::Pipeline(pipeline) => {
                black_box(pipeline.update(scene, &Skips::ALL));
            }
            Self::Picture(picture) => {
                black_box(picture.draw(scene));
            }
        }
    }

    fn frame(&self) -> &Frame {
        match self {
            Self::Pipeline(pipeline) => &pipeline.outputs().frame,
            Self::Picture(picture) => picture.frame(),
        }
    }
}

/// One step of an orbit around a model, as dragging the camera asks for it.
fn orbit(path: &str, mut by: By, what: &str, change: impl Fn(&mut Draw)) -> Row {
    let bytes = std::fs::read(path).expect("the model can be read");
    let mesh = Mesh::from_obj(&bytes).expect("the model is right");
    let mut scene = scene_from_obj("model.obj", mesh, MODEL_SIZE);
    scene.draws.iter_mut().for_each(change);
    let [x, y, z] = scene.camera.eye;
    let eyes = [[x, y, z], [x + 0.02 * z, y, z]];
    let expected = eyes.map(|eye| {
        scene.camera.eye = eye;
        let mut pipeline = Pipeline::new(Algorithm::Scanline);
        pipeline.update(&scene, &Skips::NONE);
        pipeline.into_frame()
    });
    assert!(!expected[0].same_image(&expected[1]), "the orbit must show");
    let mut turn = 0;
    let name = std::path::Path::new(path).file_stem().unwrap_or_default().to_string_lossy();
    Row::new(format!("orbit {name}, {what}, 1280x720, {}", by.name()), move || {
        turn = 1 - turn;
        scene.camera.eye = eyes[turn];
        let start = Instant::now();
        by.draw(&scene);
        let time = start.elapsed();
        assert!(by.frame().same_image(&expected[turn]));
        time
    })
}

/// Every pixel drawn counts one.
fn counting() -> StencilState {
    StencilState { pass_op: StencilOperation::IncrementClamp, ..StencilState::default() }
}

fn main() {
    let mut rows = Vec::new();
    for size in [[36, 24], MODEL_SIZE] {
        for algorithm in Algorithm::ALL {
            rows.push(drag(size, algorithm.into(), algorithm.name()));
        }
        rows.push(drag(size, Rasterizer::Engine, "engine"));
    }
    // Cargo passes `--bench`; everything else names a model.
    rows.extend(std::env::args().skip(1).filter(|arg| !arg.starts_with('-')).map(first_image));
    for path in std::env::args().skip(1).filter(|arg| !arg.starts_with('-')) {
        for rasterizer in [Rasterizer::Each(Algorithm::Scanline), Rasterizer::Engine] {
            let by = || By::Pipeline(Box::new(Pipeline::new(rasterizer)));
            rows.push(orbit(&path, by(), "depth", |_| ()));
            rows.push(orbit(&path, by(), "stencil", |draw| draw.stencil = Some(counting())));
            rows.push(orbit(&path, by(), "blending", |draw| draw.blend = Some(Mode::Over.state())));
        }
        let mut picture = Picture::default();
        picture.set_threads(Threads::available());
        // Without the light that a model is opened with.
        rows.push(orbit(&path, By::Picture(Box::new(picture)), "depth, unlit", |draw| {
            draw.shade = Shade::None;
        }));
        let pipeline = By::Pipeline(Box::default());
        rows.push(orbit(&path, pipeline, "depth, unlit", |draw| draw.shade = Shade::None));
    }
    for _ in 0..ROUNDS {
        for row in &mut rows {
            row.times.push((row.run)());
        }
    }
    println!("{:<60} {:>10} {:>10}", "", "best ms", "median ms");
    for Row { name, times, .. } in &mut rows {
        times.sort_unstable();
        let [best, median] = [times[0], times[times.len() / 2]].map(|time| time.as_secs_f64() * 1e3);
        println!("{name:<60} {best:>10.3} {median:>10.3}");
    }
}
