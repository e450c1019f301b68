//! Light through the vertex and the fragment stage: laws, golden logs, and the picture of the pipeline.

use crate::{
    presets::scene,
    support::{Coverage, Random, check_golden, check_laws, log_text},
};
use rasterscope_core::{
    interpolate::{Mode, interpolate},
    labs::{ShadeMode, Shading},
    math::{Arithmetic, Tally},
    pipeline::{Skips, render, screen_triangles},
    scene::{Scene, Shade, Transform},
    shade::{
        Light, Material, Mistake, Model, Place, Surface, brightness,
        shading::{self, Event, Image, Snapshot, Subject},
        smooth_normals,
    },
};
use std::sync::Arc;

/// The presets of the lab, and what they show.
const PRESETS: [&str; 7] = [
    "shade-lost-highlight",
    "shade-mach-band",
    "shade-facets",
    "shade-too-short",
    "shade-leaning-normals",
    "shade-all-varyings",
    "shade-hidden",
];

fn shaded(scene: &Scene, shading: ShadeMode) -> Scene {
    Shading { shading, ..Shading::default() }.apply(scene)
}

/// The brightest channel of every pixel; 0 where nothing is.
fn values(image: &Image) -> Vec<f32> {
    image.pixels.iter().map(|shown| shown.map_or(0.0, |shown| shown.value)).collect()
}

fn drawn(scene: &Scene) -> Image {
    shading::draw(&Subject::new(scene))
}

/// A triangle of three pixels with three normals.
fn small(shading: ShadeMode, mistake: Mistake) -> Scene {
    let mut scene = scene("shade-lost-highlight");
    scene.size = [6, 4];
    Shading { shading, mistake, ..Shading::default() }.apply(&scene)
}

#[track_caller]
fn check(name: &str, scene: &Scene) {
    let (subject, mut events) = (Subject::new(scene), Vec::new());
    let image = shading::draw_traced(&subject, &mut Tally::default(), &mut events);
    assert_eq!(image, shading::draw(&subject));
    let rows = values(&image);
    let rows = rows.chunks(scene.size[0] as usize);
    let picture: String =
        rows.map(|row| row.iter().map(|value| format!(" {value:.3}")).collect::<String>() + "\n").collect();
    check_golden(&format!("shading/{name}"), &(picture + &log_text(&events)));
}

#[test]
fn a_face_is_lit_once() {
    check("flat", &small(ShadeMode::Flat, Mistake::None));
}

#[test]
fn vertices_are_lit_and_colours_interpolated() {
    check("gouraud", &small(ShadeMode::Gouraud, Mistake::None));
}

#[test]
fn each_pixel_is_lit_by_its_normal() {
    check("phong", &small(ShadeMode::Phong, Mistake::None));
}

#[test]
fn short_normals_are_too_dark() {
    check("not_renormalised", &small(ShadeMode::Phong, Mistake::NotRenormalised));
}

#[test]
fn without_shading_nothing_is_lit() {
    let mut scene = scene("shade-all-varyings");
    scene.size = [4, 3];
    check("none", &shaded(&scene, ShadeMode::Scene));
}

/// What the lab steps through is what the pipeline draws, code by code.
#[test]
fn the_image_is_that_of_the_pipeline() {
    for name in PRESETS.into_iter().chain(["lit-spheres", "near-plane", "spheres", "checkered-square"]) {
        for mode in ShadeMode::ALL {
            for mistake in [Mistake::None, Mistake::ModelNormals, Mistake::NotRenormalised] {
                let scene = Shading { shading: mode, mistake, model: None }.apply(&scene(name));
                let (image, frame) = (drawn(&scene), render(&scene, &Skips::ALL));
                for (index, shown) in image.pixels.iter().enumerate() {
                    let pixel = [index as u32 % scene.size[0], index as u32 / scene.size[0]];
                    let clear = [0; 4];
                    assert_eq!(
                        shown.map_or(clear, |shown| shown.code),
                        frame.pixel(pixel),
                        "{name} {mode:?} {mistake:?} {pixel:?}"
                    );
                }
            }
        }
    }
}

/// The inputs of the fragment stage are those of the lab of area ratios, and its light that of the lab of
/// one point.
#[test]
fn a_pixel_is_lit_by_its_interpolated_place_and_normal() {
    let scene = shaded(&scene("shade-lost-highlight"), ShadeMode::Phong);
    let [triangle] = screen_triangles(&scene)[..] else { panic!("it is one triangle") };
    let mesh = scene.draws[0].geometry.mesh().expect("it stands in the file");
    let eye = Place::Position(scene.camera.eye);
    let image = drawn(&scene);
    let mut seen = 0;
    for (index, shown) in image.pixels.iter().enumerate() {
        let Some(shown) = shown else { continue };
        let at = [(index % 18) as f32 + 0.5, (index / 18) as f32 + 0.5];
        let vertices = [0, 1, 2].map(|i| {
            let [x, y, _] = triangle.vertices[i];
            // 1/w is the same for all, so any w is.
            assert_eq!(triangle.r[i], triangle.r[0]);
            [x, y, 1.0]
        });
        let vector = |of: &[[f32; 3]]| {
            [0, 1, 2].map(|axis| {
                let values = [0, 1, 2].map(|i| of[i][axis]);
                let exact = Arithmetic::Exact;
                interpolate(Mode::Affine, vertices, values, at, exact, &mut Tally::default())
                    .expect("the centre lies inside")
            })
        };
        let surface = Surface { position: vector(&mesh.positions), normal: vector(&mesh.normals) };
        let material = scene.draws[0].material;
        let light = brightness(surface, eye, &[Light::new(eye)], &material);
        assert_eq!(shown.value, light.of_white(), "{at:?}");
        seen += 1;
    }
    assert!(seen > 40, "{seen}");
}

#[test]
fn gouraud_loses_the_highlight_between_vertices() {
    let scene = scene("shade-lost-highlight");
    let most = |mode| values(&drawn(&shaded(&scene, mode))).into_iter().fold(0.0, f32::max);
    // ka + kd = 0.625 facing the eye; only a highlight is brighter.
    assert!(most(ShadeMode::Phong) > 0.8, "{}", most(ShadeMode::Phong));
    assert!(most(ShadeMode::Gouraud) < 0.625, "{}", most(ShadeMode::Gouraud));
}

#[test]
fn the_band_is_at_the_shared_edge_and_only_there() {
    let scene = scene("shade-mach-band");
    let row = |mode| values(&drawn(&shaded(&scene, mode)))[6 * 24 + 3..6 * 24 + 21].to_vec();
    let bends = |row: &[f32]| -> Vec<f32> { row.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]).collect() };
    let gouraud = bends(&row(ShadeMode::Gouraud));
    let sharp: Vec<usize> = (0..gouraud.len()).filter(|i| gouraud[*i].abs() > 1e-5).collect();
    assert_eq!(sharp, [7, 8], "straight but for the two pixels beside the edge");
    let phong = bends(&row(ShadeMode::Phong));
    assert!(phong.iter().all(|bend| *bend < -1e-4), "round throughout: {phong:?}");
}

/// One normal, one distant light and no highlight: then all that differs is where it is computed.
#[test]
fn a_plane_in_a_distant_light_is_the_same_in_all_modes() {
    let mut random = Random::new(81);
    for _ in 0..40 {
        let mut scene = scene("shade-lost-highlight");
        let turn = [0; 3].map(|_| random.grid(-40, 40));
        scene.draws[0].transform =
            Transform::Parts { translate: [0.0; 3], rotate_degrees: turn, scale: [1.0; 3] };
        scene.draws[0].material = Material { specular: 0.0, ..Material::default() };
        let direction = [random.grid(-2, 2), random.grid(-2, 2), 2.0];
        scene.lights = vec![Light::new(Place::Direction(direction))];
        let mut mesh = (**scene.draws[0].geometry.mesh().expect("it is there")).clone();
        mesh.normals = vec![[0.0, 0.0, 1.0]; 3];
        scene.draws[0].geometry = rasterscope_core::scene::Geometry::Mesh(Arc::new(mesh));
        let [flat, gouraud, phong] = [ShadeMode::Flat, ShadeMode::Gouraud, ShadeMode::Phong]
            .map(|mode| values(&drawn(&shaded(&scene, mode))));
        for ((flat, gouraud), phong) in flat.iter().zip(&gouraud).zip(&phong) {
            assert!(
                (flat - phong).abs() < 1e-6 && (gouraud - phong).abs() < 1e-6,
                "{flat} {gouraud} {phong}"
            );
        }
    }
}

#[test]
fn a_mesh_without_normals_gets_the_mean_of_its_faces() {
    let scene = scene("shade-facets");
    let mesh = scene.draws[0].geometry.mesh().expect("it is there");
    let normals = smooth_normals(mesh);
    // An octahedron's vertex lies in the direction of its normal.
    for (position, normal) in mesh.positions.iter().zip(normals) {
        assert_eq!(position.map(|c| c / 1.7), normal);
    }
}

#[test]
fn lights_and_materials_survive_the_file() {
    let text = r#"{"rasterscope":1,"size":[4,3],
        "lights":[{"position":[1,2,3],"intensity":0.5,"attenuation":[1,0.5,0.25]},{"direction":[0,0,1]}],
        "draws":[{"vertices":[[0,0,0],[1,0,0],[0,1,0]],"shade":"phong",
            "material":{"ambient":0.5,"exponent":7,"model":"blinn-phong","two_sided":true}}]}"#;
    let scene = Scene::from_json(text.as_bytes()).expect("it is a scene");
    assert_eq!(scene.lights[1], Light::new(Place::Direction([0.0, 0.0, 1.0])));
    let material = scene.draws[0].material;
    let expected = Material {
        ambient: 0.5,
        exponent: 7,
        model: Model::BlinnPhong,
        two_sided: true,
        ..Material::default()
    };
    assert_eq!((scene.draws[0].shade, material), (Shade::Phong, expected));
    assert_eq!(Scene::from_json(scene.to_json().as_bytes()), Ok(scene));
    let path = |from: &str, to: &str| {
        let wrong = text.replace(from, to);
        format!("{:?}", Scene::from_json(wrong.as_bytes()).expect_err("it is wrong"))
    };
    for (from, to, at) in [
        ("\"ambient\":0.5", "\"ambient\":1.5", "ambient"),
        ("\"exponent\":7", "\"exponent\":0", "exponent"),
        ("\"direction\":[0,0,1]", "\"direction\":[0,0,0]", "direction"),
        ("\"direction\":[0,0,1]", "\"intensity\":1", "position"),
        ("\"intensity\":0.5", "\"intensity\":-1", "intensity"),
        ("[1,0.5,0.25]", "[0,0,0]", "attenuation"),
    ] {
        assert!(path(from, to).contains(at), "{to}: {}", path(from, to));
    }
}

#[test]
fn keeps_the_laws() {
    let mut coverage = Coverage::default();
    for name in PRESETS {
        let mut scene = scene(name);
        scene.size = [7, 5];
        for shading in ShadeMode::ALL {
            for (model, mistake) in
                [(None, Mistake::None), (Some(Model::BlinnPhong), Mistake::NotRenormalised)]
            {
                let scene = Shading { shading, model, mistake }.apply(&scene);
                let subject = Arc::new(Subject::new(&scene));
                let mut events: Vec<Event> = Vec::new();
                let traced = shading::draw_traced(&subject, &mut Tally::default(), &mut events);
                check_laws(
                    (&shading::draw(&subject), &traced),
                    &events,
                    |budget| shading::play(Arc::clone(&subject), budget),
                    Snapshot::result,
                    &mut coverage,
                );
            }
        }
    }
    coverage.check_every_line::<Snapshot>();
}
