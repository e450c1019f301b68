//! Scene files, models and presets: what is read is what was written, and what is wrong is named.

use rasterscope_core::{
    labs::ClipLine,
    math::Arithmetic,
    scene::{Lab, MODELS, PRESETS, Scene, Shade, Texture, Transform, model, preset},
};
use std::collections::HashSet;

fn embedded(file: &str) -> Result<Vec<u8>, String> {
    model(file).map(<[u8]>::to_vec).ok_or_else(|| "no such model".into())
}

#[test]
fn every_preset_is_a_valid_scene_and_survives_the_round_trip() {
    for preset in PRESETS {
        let scene = Scene::from_json(preset.json.as_bytes());
        let scene = scene.unwrap_or_else(|error| panic!("{}: {error}", preset.name));
        let again = Scene::from_json(scene.to_json().as_bytes());
        assert_eq!(again.as_ref(), Ok(&scene), "{}", preset.name);
        assert_eq!(again.map(|scene| scene.to_json()), Ok(scene.to_json()), "{}", preset.name);

        let resolved = scene.resolve(&mut embedded);
        let resolved = resolved.unwrap_or_else(|error| panic!("{}: {error}", preset.name));
        assert!(resolved.draws.iter().all(|draw| draw.geometry.mesh().is_some()), "{}", preset.name);
        assert_eq!(resolved.to_json(), scene.to_json(), "{}: models stay models", preset.name);
    }
}

#[test]
fn every_preset_has_its_words_and_every_scene_file_is_a_preset() {
    let words = include_str!("../assets/i18n/en/scene.ftl");
    for preset in PRESETS {
        let name = preset.name;
        let scene = Scene::from_json(preset.json.as_bytes());
        let named = scene.map(|scene| (scene.name, scene.note));
        assert_eq!(named, Ok((format!("preset-{name}-name"), format!("preset-{name}"))));
        for id in [format!("\npreset-{name}-name = "), format!("\npreset-{name} = ")] {
            assert_eq!(words.matches(&id).count(), 1, "{id}");
        }
    }
    let names: HashSet<&str> = PRESETS.iter().map(|preset| preset.name).collect();
    assert_eq!(names.len(), PRESETS.len(), "each name once");
    for (folder, ending, known) in [
        ("scenes", ".json", names),
        ("models", "", MODELS.iter().map(|(file, _)| *file).collect::<HashSet<_>>()),
    ] {
        let folder = format!("{}/../assets/{folder}", env!("CARGO_MANIFEST_DIR"));
        for entry in std::fs::read_dir(folder).expect("the assets are beside the tests") {
            let file = entry.expect("the folder can be listed").file_name().to_string_lossy().into_owned();
            assert!(known.contains(file.trim_end_matches(ending)), "{file} is not part of the program");
        }
    }
}

#[test]
fn every_lab_has_at_least_five_presets() {
    let of = |lab: &str| {
        let opens = |json: &str| {
            Scene::from_json(json.as_bytes()).ok().and_then(|scene| scene.lab).map(|lab| lab.input.name())
        };
        PRESETS.iter().filter(|preset| opens(preset.json) == Some(lab)).count()
    };
    for lab in ["cohen-sutherland", "liang-barsky", "scanline", "z-buffer", "transform"] {
        assert!(of(lab) >= 5, "{lab}: {}", of(lab));
    }
    let scenes = PRESETS.iter().filter(|preset| !preset.json.contains("\"lab\"")).count();
    assert!(scenes >= 16, "{scenes}");
}

#[test]
fn the_default_scene_is_the_one_of_the_mock() {
    let scene = Scene::from_json(PRESETS[0].json.as_bytes()).expect("the default preset is valid");
    assert_eq!((PRESETS[0].name, scene.size), ("two-through-each-other", [36, 24]));
    let vertices: Vec<_> =
        scene.draws.iter().filter_map(|draw| draw.geometry.mesh()).flat_map(|mesh| &mesh.positions).collect();
    assert_eq!(
        vertices,
        [
            &[-3.4, -1.9, 0.9],
            &[6.4, -1.0, -1.6],
            &[0.2, 2.5, 0.1],
            &[2.6, -2.3, 0.9],
            &[1.9, 2.5, -1.0],
            &[-3.3, 0.9, -0.9],
            &[-3.6, -0.5, -0.9],
            &[-1.1, 2.3, -0.6],
            &[0.9, -2.1, 0.2],
        ]
    );
}

#[test]
fn the_smallest_scene_has_the_documented_defaults() {
    let scene = Scene::from_json(br#"{"rasterscope":1,"size":[4,3],"draws":[]}"#);
    assert_eq!(scene, Ok(Scene::empty([4, 3])));
    let with_mark = b"\xEF\xBB\xBF{\"rasterscope\":1,\"size\":[4,3],\"draws\":[]}";
    assert_eq!(Scene::from_json(with_mark), Ok(Scene::empty([4, 3])));
}

#[test]
fn every_field_survives_the_round_trip() {
    let json = r#"{"rasterscope":1,"name":"n \"q\" \\ {[,:","note":"Ärger.0","size":[7,5],
        "clear":{"color":[0.1,0.2,0.3,0.4],"depth":0.25,"stencil":7},
        "camera":{"eye":[1,2,3.5],"target":[0.1,1e-30,-1e30],"up":[0,0,1],"near":-2,"far":1e20,
                  "projection":{"kind":"orthographic","height":0.3}},
        "depth_range":"minus-one-to-one","depth_format":"unorm24","reversed":true,"fill_rule":"strict",
        "samples":1,"y_axis":"up",
        "draws":[
         {"name":"A","vertices":[[0.1,0.2,0.3],[1,0,0],[0,1,16777216],[1e-45,3.4028235e38,-0.0]],
          "indices":[[0,1,2],[3,3,3]],"colors":[[0,0,0,0],[1,1,1,1],[0.5,0.5,0.5,0.5],[0.1,0.2,0.3,0.4]],
          "uvs":[[0,0],[1,0],[0,1],[-3,7]],"normals":[[0,0,1],[0,0,1],[0,0,2],[0,0,0]],
          "transform":{"translate":[1,2,3],"rotate_degrees":[10,20,30],"scale":[-1,1,2]},
          "cull":"front","front":"cw","depth":{"test":false,"compare":"greater-equal","write":false},
          "stencil":{"compare":"not-equal","failOp":"zero","depthFailOp":"increment-wrap","passOp":"invert",
                     "readMask":1,"writeMask":2,"reference":3},
          "blend":{"color":{"srcFactor":"src-alpha","dstFactor":"one-minus-src-alpha","operation":"max"},
                   "alpha":{"srcFactor":"dst","dstFactor":"src-alpha-saturated","operation":"reverse-subtract"}},
          "texture":{"kind":"checker","squares":3},"shade":"flat"},
         {"vertices":[],"stencil":null,"blend":null,"texture":null},
         {"model":"cube.obj","color":[0.25,0.5,0.75,1],
          "transform":{"matrix":[1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,0.1]}}],
        "lab":{"name":"cohen-sutherland","algorithm":"cohen-sutherland","window":[0,0,0,1],
               "segment":[0.1,0.2,0.3,0.4],"arithmetic":"f64","step":3}}"#;
    let scene = Scene::from_json(json.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
    let text = scene.to_json();
    assert_eq!(Scene::from_json(text.as_bytes()), Ok(scene.clone()), "{text}");
    assert!(text.starts_with("{\n  \"rasterscope\": 1,\n"), "{text}");
    assert!(text.contains("\"target\": [0.1, 1e-30, -1e+30]"), "shortest numbers: {text}");

    let [a, b, c] = scene.draws.as_slice() else { panic!("three draws") };
    let mesh = a.geometry.mesh().expect("a mesh in the file");
    assert_eq!(mesh.triangles, [[0, 1, 2], [3, 3, 3]]);
    assert_eq!(mesh.positions[3].map(f32::to_bits), [1e-45_f32, f32::MAX, -0.0].map(f32::to_bits));
    assert_eq!((a.texture, a.shade), (Some(Texture::Checker { squares: 3 }), Shade::Flat));
    assert_eq!((b.stencil, b.blend, b.texture), (None, None, None));
    assert_eq!(
        c.transform,
        Transform::Matrix([
            1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 0.1
        ])
    );
    let lab = ClipLine {
        algorithm: rasterscope_core::clip::line::Algorithm::CohenSutherland,
        window: [0.0, 0.0, 0.0, 1.0],
        segment: [0.1, 0.2, 0.3, 0.4],
        arithmetic: Arithmetic::F64,
        mistakes: rasterscope_core::clip::line::Mistakes::NONE,
    };
    assert_eq!(scene.lab, Some(Lab { step: Some(3), ..Lab::new(lab) }));
}

#[test]
fn a_scene_inside_another_document_reads_the_same() {
    let json = preset("outline").expect("it is a preset").json;
    let value = serde_json::from_str(json).expect("it is JSON");
    assert_eq!(Scene::from_value(value), Scene::from_json(json.as_bytes()));
    let by_serde: Result<Scene, _> = serde_json::from_str(json);
    assert_eq!(by_serde.ok(), Scene::from_json(json.as_bytes()).ok());
    let wrong: Result<Scene, _> = serde_json::from_str(r#"{"rasterscope":1,"size":[0,1],"draws":[]}"#);
    assert!(wrong.is_err());
}

#[test]
fn a_models_colour_can_be_replaced() {
    let json = br#"{"rasterscope":1,"size":[1,1],
        "draws":[{"model":"tetrahedron.obj"},{"model":"tetrahedron.obj","color":[1,0,0,0.5]}]}"#;
    let scene = Scene::from_json(json).and_then(|scene| scene.resolve(&mut embedded)).expect("valid");
    let colors = |i: usize| scene.draws[i].geometry.mesh().map(|mesh| mesh.colors.clone());
    assert_eq!(colors(1), Some(vec![[1.0, 0.0, 0.0, 0.5]; 4]));
    assert_ne!(colors(0), colors(1));
    // A texture needs texture coordinates: known only when the model is.
    let json = br#"{"rasterscope":1,"size":[1,1],
        "draws":[{"model":"pawn.obj","texture":{"kind":"checker","squares":2}}]}"#;
    let scene = Scene::from_json(json).expect("valid until it is resolved");
    let message = scene.resolve(&mut embedded).expect_err("no texture coordinates").message();
    assert_eq!(message.id, "error-scene-no-texture-coordinates");
}
