//! What is wrong with a scene file is named: by its path, or by line and column.

use rasterscope_core::{
    labs,
    message::{Message, Value},
    scene::{MAX_SCENE_BYTES, Scene, SceneError, preset},
};

fn arg(message: &Message, name: &str) -> Option<Value> {
    message.args.iter().find(|(known, _)| *known == name).map(|(_, value)| value.clone())
}

/// The message of a refused scene: its id, and the path as text.
fn refusal(json: &[u8]) -> (&'static str, String) {
    match Scene::from_json(json) {
        Ok(_) => ("", "accepted".into()),
        Err(error) => {
            let message = error.message();
            let path = match arg(&message, "path") {
                Some(Value::Text(path)) => path,
                _ => String::new(),
            };
            (message.id, path)
        }
    }
}

#[test]
fn a_bad_field_is_named_by_its_path() {
    // Top-level fields, draw fields (with vertices), what is wrong, and where.
    let tri = "[[0,0,0],[1,0,0],[0,1,0]]";
    let scene = |fields: &str| format!(r#"{{"rasterscope":1,{fields}}}"#);
    let top = |fields: &str| scene(&format!(r#""size":[4,4],"draws":[],{fields}"#));
    let draw = |fields: &str| {
        scene(&format!(r#""size":[4,4],"draws":[{{"vertices":{tri}}},{{"vertices":{tri},{fields}}}]"#))
    };
    let bare = |fields: &str| scene(&format!(r#""size":[4,4],"draws":[{{"vertices":[]}},{{{fields}}}]"#));
    let line = |compare: &str| {
        let input = r#""window":[0,0,1,1],"segment":[0,0,1,1]"#;
        top(&format!(r#""lab":{{"name":"cohen-sutherland",{input},"compare":{compare}}}"#))
    };
    let polygon = |corners: &str| {
        top(&format!(r#""lab":{{"name":"cyrus-beck","polygon":[{corners}],"segment":[0,0,1,1]}}"#))
    };
    let mistaken = |mistake: &str| {
        let input = r#""window":[0,0,1,1],"segment":[0,0,1,1]"#;
        top(&format!(r#""lab":{{"name":"cohen-sutherland",{input},"mistakes":["{mistake}"]}}"#))
    };
    let cases = [
        // Missing and unknown.
        (scene(r#""draws":[]"#), "missing", "size"),
        (scene(r#""size":[4,4]"#), "missing", "draws"),
        (bare(r#""name":"A""#), "missing", "draws[1].vertices"),
        (top(r#""colour":1"#), "unknown-field", "colour"),
        (draw(r#""colour":1"#), "unknown-field", "draws[1].colour"),
        (draw(r#""depth":{"tset":true}"#), "unknown-field", "draws[1].depth.tset"),
        (draw(r#""stencil":{"fail_op":"zero"}"#), "unknown-field", "draws[1].stencil.fail_op"),
        (top(r#""camera":{"eye":[0,0,5],"zoom":1}"#), "unknown-field", "camera.zoom"),
        (top(r#""fill_rule":"topleft""#), "unknown-name", "fill_rule"),
        (draw(r#""cull":"both""#), "unknown-name", "draws[1].cull"),
        (draw(r#""blend":{"alpha":{"srcFactor":"two"}}"#), "unknown-name", "draws[1].blend.alpha.srcFactor"),
        (top(r#""rasterscope":2"#), "newer", "rasterscope"),
        (top(r#""rasterscope":0"#), "must-be", "rasterscope"),
        (top(r#""rasterscope":"1""#), "kind", "rasterscope"),
        // Another kind of value.
        (bare(r#""vertices":[[0,"1",0],[1,0,0],[0,1,0]]"#), "kind", "draws[1].vertices[0][1]"),
        (bare(r#""vertices":[[0,null,0],[1,0,0],[0,1,0]]"#), "kind", "draws[1].vertices[0][1]"),
        (bare(r#""vertices":[[0,0,0],[1,0],[0,1,0]]"#), "length", "draws[1].vertices[1]"),
        (bare(r#""vertices":{}"#), "kind", "draws[1].vertices"),
        (scene(r#""size":[4,4],"draws":{}"#), "kind", "draws"),
        (scene(r#""size":[4,4],"draws":[7]"#), "kind", "draws[0]"),
        (scene(r#""size":[4,4.5],"draws":[]"#), "kind", "size[1]"),
        (top(r#""reversed":1"#), "kind", "reversed"),
        (top(r#""name":1"#), "kind", "name"),
        (top(r#""fill_rule":null"#), "kind", "fill_rule"),
        (draw(r#""transform":{"matrix":[1]}"#), "length", "draws[1].transform.matrix"),
        // Numbers.
        (bare(r#""vertices":[[0,0,0],[1,0,0],[0,1,1e39]]"#), "not-finite", "draws[1].vertices[2][2]"),
        (top(r#""camera":{"far":-1e300}"#), "not-finite", "camera.far"),
        (scene(r#""size":[0,4],"draws":[]"#), "range", "size[0]"),
        (scene(r#""size":[4,16385],"draws":[]"#), "range", "size[1]"),
        (scene(r#""size":[4,-1],"draws":[]"#), "negative", "size[1]"),
        (scene(r#""size":[16384,16385],"draws":[]"#), "range", "size[1]"),
        (top(r#""clear":{"color":[0,0,1.5,1]}"#), "range", "clear.color[2]"),
        (top(r#""clear":{"depth":-0.25}"#), "range", "clear.depth"),
        (top(r#""clear":{"stencil":256}"#), "range", "clear.stencil"),
        (draw(r#""color":[0,0,0,2]"#), "range", "draws[1].color[3]"),
        (draw(r#""colors":[[0,0,0,0],[0,9,0,0],[0,0,0,0]]"#), "range", "draws[1].colors[1][1]"),
        (bare(r#""model":"cube.obj","color":[-1,0,0,0]"#), "range", "draws[1].color[0]"),
        (draw(r#""stencil":{"readMask":4294967296}"#), "range", "draws[1].stencil.readMask"),
        (draw(r#""depth":{"bias":{"constant":0.5}}"#), "kind", "draws[1].depth.bias.constant"),
        (draw(r#""depth":{"bias":{"constant":-2147483649}}"#), "range", "draws[1].depth.bias.constant"),
        (draw(r#""depth":{"bias":{"slope":1e39}}"#), "not-finite", "draws[1].depth.bias.slope"),
        (draw(r#""depth":{"bias":{"slopeScale":1}}"#), "unknown-field", "draws[1].depth.bias.slopeScale"),
        (draw(r#""depth":{"unclipped":1}"#), "kind", "draws[1].depth.unclipped"),
        (draw(r#""scissor":[0,0,4]"#), "length", "draws[1].scissor"),
        (draw(r#""scissor":[0,-1,4,4]"#), "negative", "draws[1].scissor[1]"),
        (draw(r#""scissor":[0,0,16385,4]"#), "range", "draws[1].scissor[2]"),
        (draw(r#""blend":{"constant":[0,0,2,0]}"#), "range", "draws[1].blend.constant[2]"),
        (draw(r#""alpha_test":{"reference":1.5}"#), "range", "draws[1].alpha_test.reference"),
        (draw(r#""alpha_test":{"compare":"more"}"#), "unknown-name", "draws[1].alpha_test.compare"),
        (draw(r#""indices":[[0,1,-1]]"#), "negative", "draws[1].indices[0][2]"),
        (draw(r#""indices":[[0,1,0.5]]"#), "kind", "draws[1].indices[0][2]"),
        (bare(r#""model":"""#), "no-file-name", "draws[1].model"),
        (bare(r#""model":"a\u0000b""#), "no-file-name", "draws[1].model"),
        (draw(r#""indices":[[0,1,4294967296]]"#), "range", "draws[1].indices[0][2]"),
        (draw(r#""texture":{"kind":"checker","squares":0}"#), "not-positive", "draws[1].texture.squares"),
        (top(r#""samples":3"#), "samples", "samples"),
        // The camera.
        (top(r#""camera":{"near":0}"#), "not-positive", "camera.near"),
        (top(r#""camera":{"near":10}"#), "far-before-near", "camera.far"),
        (top(r#""camera":{"eye":[0,0,0]}"#), "eye-is-target", "camera.target"),
        (top(r#""camera":{"up":[0,0,-2]}"#), "up-parallel", "camera.up"),
        (top(r#""camera":{"up":[0,0,0]}"#), "up-parallel", "camera.up"),
        (top(r#""camera":{"projection":{"kind":"fisheye"}}"#), "unknown-name", "camera.projection.kind"),
        (
            top(r#""camera":{"projection":{"kind":"perspective"}}"#),
            "missing",
            "camera.projection.fovy_degrees",
        ),
        (
            top(r#""camera":{"projection":{"kind":"perspective","fovy_degrees":180}}"#),
            "field-of-view",
            "camera.projection.fovy_degrees",
        ),
        (
            top(r#""camera":{"projection":{"kind":"perspective","fovy_degrees":60,"height":2}}"#),
            "unknown-field",
            "camera.projection.height",
        ),
        (
            top(r#""camera":{"projection":{"kind":"orthographic","height":0}}"#),
            "not-positive",
            "camera.projection.height",
        ),
        (
            top(r#""camera":{"projection":{"kind":"orthographic","height":"2"}}"#),
            "kind",
            "camera.projection.height",
        ),
        // Meshes.
        (bare(r#""vertices":[[0,0,0],[1,0,0]]"#), "not-triples", "draws[1].vertices"),
        (draw(r#""indices":[[0,1,2],[0,1,3]]"#), "no-such-vertex", "draws[1].indices[1][2]"),
        (draw(r#""colors":[[0,0,0,0]]"#), "not-one-each", "draws[1].colors"),
        (draw(r#""uvs":[[0,0]]"#), "not-one-each", "draws[1].uvs"),
        (draw(r#""normals":[[0,0,1]]"#), "not-one-each", "draws[1].normals"),
        (draw(r#""color":[0,0,0,0],"colors":[[0,0,0,0]]"#), "both", "draws[1].colors"),
        (draw(r#""model":"cube.obj""#), "both", "draws[1].vertices"),
        (bare(r#""model":"cube.obj","uvs":[[0,0]]"#), "both", "draws[1].uvs"),
        (draw(r#""texture":{"kind":"checker","squares":2}"#), "no-texture-coordinates", "draws[1].texture"),
        (draw(r#""transform":{"matrix":[1],"scale":[1,1,1]}"#), "length", "draws[1].transform.matrix"),
        (
            draw(r#""transform":{"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"scale":[1,1,1]}"#),
            "both",
            "draws[1].transform.matrix",
        ),
        // Labs.
        (top(r#""lab":{"name":"warnock"}"#), "unknown-name", "lab.name"),
        (top(r#""lab":{"name":"scanline","window":[0,0,1,1]}"#), "unknown-field", "lab.window"),
        (top(r#""lab":{"name":"cohen-sutherland","segment":[0,0,1,1]}"#), "missing", "lab.window"),
        (top(r#""lab":{"name":"z-buffer","step":-1}"#), "negative", "lab.step"),
        (top(r#""lab":{"name":"scanline","algorithm":"tiled"}"#), "unknown-name", "lab.algorithm"),
        (top(r#""lab":{"name":"transform"}"#), "none-there", "lab.draw"),
        // A comparison names one setting that the lab reads.
        (top(r#""lab":{"name":"pipeline","compare":{}}"#), "no-setting", "lab.compare"),
        (top(r#""lab":{"name":"pipeline","compare":{"fill":1}}"#), "unknown-field", "lab.compare.fill"),
        (
            top(r#""lab":{"name":"pipeline","compare":{"fill_rule":"x"}}"#),
            "unknown-name",
            "lab.compare.fill_rule",
        ),
        (
            top(r#""lab":{"name":"z-buffer","compare":{"arithmetic":"f32"}}"#),
            "unknown-field",
            "lab.compare.arithmetic",
        ),
        (
            top(r#""lab":{"name":"pipeline","compare":{"fill_rule":"strict","y_axis":"up"}}"#),
            "both",
            "lab.compare.y_axis",
        ),
        (line(r#"{"algorithm":"scanline"}"#), "unknown-name", "lab.compare.algorithm"),
        (line(r#"{"arithmetic":"fixed-8"}"#), "unknown-name", "lab.compare.arithmetic"),
        (
            top(r#""lab":{"name":"clip-triangle","compare":{"mistake":"forgotten"}}"#),
            "unknown-name",
            "lab.compare.mistake",
        ),
        (line(r#"{"order":"left-right-bottom-top"}"#), "unknown-field", "lab.compare.order"),
        (
            top(r#""lab":{"name":"cohen-sutherland","window":[1,0,0,1],"segment":[0,0,1,1]}"#),
            "window-reversed",
            "lab.window",
        ),
        (polygon("[0,0],[4,0],[1,1],[0,4]"), "polygon-not-convex", "lab.polygon"),
        (polygon("[0,0],[1,1],[3,3]"), "polygon-no-area", "lab.polygon"),
        (polygon("[0,0],[1,1]"), "polygon-corners", "lab.polygon"),
        (polygon("[0,0],[1,0],[1e99,1]"), "not-finite", "lab.polygon[2][0]"),
        (mistaken("oops"), "unknown-name", "lab.mistakes[0]"),
        (
            top(r#""lab":{"name":"z-buffer","triangles":[[[0,0,0],[1,0,0],[0,1,1e99]]]}"#),
            "not-finite",
            "lab.triangles[0][2][2]",
        ),
        (
            top(
                r#""lab":{"name":"cohen-sutherland","window":[0,0,1,1],"segment":[0,0,1,1],"arithmetic":"fixed-8"}"#,
            ),
            "unknown-name",
            "lab.arithmetic",
        ),
    ];
    for (json, problem, path) in cases {
        // A repeated field: the last one counts.
        let found = refusal(json.as_bytes());
        assert_eq!((found.0, found.1.as_str()), (format!("error-scene-{problem}").as_str(), path), "{json}");
    }
}

#[test]
fn an_image_of_too_many_pixels_is_refused_at_the_limit() {
    let of = |size: &str| refusal(format!(r#"{{"rasterscope":1,"size":{size},"draws":[]}}"#).as_bytes()).1;
    assert_eq!(of("[16384,16384]"), "accepted", "exactly 2^28");
    assert_eq!(of("[16384,16385]"), "size[1]");
}

#[test]
fn an_unknown_lab_is_told_the_known_ones() {
    let error = Scene::from_json(br#"{"rasterscope":1,"size":[1,1],"draws":[],"lab":{"name":"x"}}"#);
    let message = error.expect_err("there is no such lab").message();
    let known = Value::text(labs::ALL.iter().map(|lab| lab.name).collect::<Vec<_>>().join(", "));
    assert_eq!((arg(&message, "name"), arg(&message, "known")), (Some(Value::text("x")), Some(known)));
}

#[test]
fn what_is_no_json_is_named_by_line_and_column() {
    let deep = "[".repeat(100_000);
    type Place = Option<(i32, i32)>;
    let cases: [(&[u8], &str, Place); 14] = [
        (b"", "scene-empty", None),
        (b" \n\t ", "scene-empty", None),
        (b"{\"rasterscope\":1,\n \"size\":[1,1],\n \"draws\":[}", "scene-json", Some((3, 11))),
        (b"{\"rasterscope\":1,}", "scene-json", Some((1, 18))),
        (b"{\"rasterscope\":1,\"size\":[NaN,1]}", "json-nan", Some((1, 26))),
        (b"{\"rasterscope\":1,\"size\":[.5,1]}", "json-fraction", Some((1, 26))),
        (b"{\"rasterscope\":1,\"size\":[1e999,1]}", "json-number", Some((1, 30))),
        (b"{\"rasterscope\":1,\"siz", "scene-json-ends", Some((1, 21))),
        (b"{\"rasterscope\":1} x", "scene-json", Some((1, 19))),
        (deep.as_bytes(), "json-too-deep", Some((1, 128))),
        (b"{\"name\":\"\xC3\x28\"}", "scene-not-text", None),
        (b"\x89PNG\r\n\x1A\n\0\0\0\rIHDR", "scene-not-text", None),
        (b"{\"a\":1}\0", "scene-not-text", None),
        (b"\xFF\xFE{\0}\0", "scene-not-text", None),
    ];
    for (json, problem, place) in cases {
        let message = Scene::from_json(json).expect_err("it is no JSON").message();
        let text = String::from_utf8_lossy(&json[..json.len().min(60)]);
        assert_eq!(message.id, format!("error-{problem}"), "{text}");
        if let Some((line, column)) = place {
            let found = (arg(&message, "line"), arg(&message, "column"));
            assert_eq!(found, (Some(line.into()), Some(column.into())), "{text}");
        }
    }
    for json in [&b"[]"[..], b"7", b"{}", b"null", b"{\"name\":\"package\",\"version\":\"1\"}"] {
        assert_eq!(refusal(json).0, "error-scene-not-a-scene");
    }
}

#[test]
fn a_scene_of_a_hundred_megabytes_in_one_line_is_refused_by_its_size() {
    let huge = vec![b'1'; 100_000_000];
    assert_eq!(
        Scene::from_json(&huge),
        Err(SceneError::TooLarge { bytes: 100_000_000, limit: MAX_SCENE_BYTES })
    );
}

#[test]
fn a_message_quotes_only_the_beginning_of_what_is_long() {
    let long = "x".repeat(1_000_000);
    for fields in [
        format!(r#""{long}":1"#),
        format!(r#""fill_rule":"{long}""#),
        format!(r#""lab":{{"name":"pipeline","algorithm":"{long}"}}"#),
        format!(r#""camera":{{"{long}":{{"{long}":1}}}}"#),
    ] {
        let json = format!(r#"{{"rasterscope":1,"size":[1,1],"draws":[],{fields}}}"#);
        let message = Scene::from_json(json.as_bytes()).expect_err("unknown").message();
        assert!(format!("{message:?}").len() < 1000, "{}", message.id);
    }
}

#[test]
fn a_model_that_cannot_be_loaded_is_named_with_its_file() {
    let scene = Scene::from_json(
        br#"{"rasterscope":1,"size":[1,1],"draws":[{"vertices":[]},{"model":"x.obj"},{"model":"x.obj"}]}"#,
    )
    .expect("a valid scene");
    let missing = scene.resolve(&mut |_| Err("not found".into())).expect_err("no such file");
    assert_eq!(
        missing,
        SceneError::Unreadable {
            path: "draws[1].model".into(),
            file: "x.obj".into(),
            reason: "not found".into()
        }
    );
    let broken = scene.resolve(&mut |_| Ok(b"v 0 0 0\nf 1 2 3\n".to_vec())).expect_err("a broken file");
    let message = broken.message();
    assert_eq!(
        (message.id, arg(&message, "file"), arg(&message, "line")),
        ("error-obj-no-such-index", Some(Value::text("draws[1].model: x.obj")), Some(Value::Int(2)))
    );
    let mut loads = 0;
    let resolved = scene.resolve(&mut |_| {
        loads += 1;
        Ok(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".to_vec())
    });
    assert_eq!((resolved.map(|scene| scene.draws.len()), loads), (Ok(3), 1), "each file is loaded once");
}

#[test]
fn every_beginning_of_a_scene_file_gets_an_answer() {
    let json = preset("stencil-mask").expect("it is a preset").json.trim_end().as_bytes();
    for end in 0..json.len() {
        let (id, _) = refusal(&json[..end]);
        assert!(["error-scene-empty", "error-scene-json-ends"].contains(&id), "cut at {end}: {id}");
    }
}
