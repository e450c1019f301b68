//! OBJ models: what is read, and how a broken file is named.

use rasterscope_core::{
    cull::CullMode,
    message::{Message, Value},
    scene::{Geometry, MODEL_SIZE, MODELS, Mesh, Scene, Shade, scene_from_obj},
    transform::{DepthRange, Viewport, apply, matrices},
};

fn line(message: &Message) -> Option<Value> {
    message.args.iter().find(|(name, _)| *name == "line").map(|(_, value)| value.clone())
}

#[test]
fn obj_files_of_every_kind_are_read() {
    // What it is, the file, vertices, triangles.
    let cases: [(&str, &str, usize, &[[u32; 3]]); 14] = [
        ("a triangle", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 3, &[[0, 1, 2]]),
        ("no line feed at the end", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", 3, &[[0, 1, 2]]),
        ("carriage returns", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", 3, &[[0, 1, 2]]),
        ("only carriage returns", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", 3, &[[0, 1, 2]]),
        ("a byte-order mark", "\u{FEFF}v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", 3, &[[0, 1, 2]]),
        (
            "a pentagon",
            "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5",
            5,
            &[[0, 1, 2], [0, 2, 3], [0, 3, 4]],
        ),
        (
            "negative indices",
            "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -1 -2 1",
            4,
            &[[0, 1, 2], [3, 2, 0]],
        ),
        ("faces before vertices", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0", 3, &[[0, 1, 2]]),
        (
            "groups share their vertices",
            "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\ng b\nf 1 2 3\ng c\nusemtl m\nf 3 2 1\no d\nf 4 2 1\nv 3 3 3",
            4,
            &[[0, 1, 2], [2, 1, 0], [3, 1, 0]],
        ),
        (
            "materials that are not there",
            "mtllib no\\such\\file.mtl\nusemtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl x\nf 1 2 3",
            3,
            &[[0, 1, 2]],
        ),
        (
            "comments, lines and curves",
            "# a \\\nv 0 0 0 # b\nv 1 0 0\nv 0 1 0\nl 1 2\np 1\nvp 1\ncstype bezier\nf 1 2 3#c",
            3,
            &[[0, 1, 2]],
        ),
        ("a statement that goes on", "v 0 0 \\\n 0\nv 1 0 0\nv 0 1 0\nf 1 \\\r\n 2 \\\n3", 3, &[[0, 1, 2]]),
        ("a degenerate face is kept", "v 0 0 0\nv 1 0 0\nf 1 2 2", 2, &[[0, 1, 1]]),
        ("a position divided by w", "v 0 0 0 1\nv 2 0 0 2\nv 0 1 0 1\nf 1 2 3", 3, &[[0, 1, 2]]),
    ];
    for (what, text, vertices, triangles) in cases {
        let mesh = Mesh::from_obj(text.as_bytes()).unwrap_or_else(|error| panic!("{what}: {error}"));
        assert_eq!((mesh.positions.len(), mesh.triangles.as_slice()), (vertices, triangles), "{what}");
        assert_eq!((mesh.colors.len(), mesh.uvs.len(), mesh.normals.len()), (vertices, 0, 0), "{what}");
        assert!(mesh.positions[..2] == [[0.0; 3], [1.0, 0.0, 0.0]] || what == "faces before vertices");
    }
}

#[test]
fn obj_vertices_differ_by_position_texture_and_normal() {
    let positions = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0.5 0\nvn 0 0 1\nvn 0 1 0\n";
    let read = |faces: &str| Mesh::from_obj(format!("{positions}{faces}").as_bytes()).expect("it is OBJ");
    let both = read("f 1/1/1 2/2/1 3/1/1\nf 1/2/1 3/1/1 2/2/1");
    assert_eq!(both.triangles, [[0, 1, 2], [3, 2, 1]]);
    assert_eq!(both.uvs, [[0.0, 0.0], [1.0, 0.5], [0.0, 0.0], [1.0, 0.5]]);
    assert_eq!(both.normals, vec![[0.0, 0.0, 1.0]; 4]);
    let normals = read("f 1//1 2//2 3//-1");
    assert_eq!((normals.uvs.len(), normals.normals.len()), (0, 3));
    let some = read("f 1/1 2/2 3/1\nf 1 2 3");
    assert_eq!((some.uvs.len(), some.triangles.len()), (0, 2), "not every corner has one: none is kept");
}

#[test]
fn obj_colours_are_kept_and_their_absence_is_white() {
    let colored = Mesh::from_obj(b"v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 0.5\nf 1 2 3");
    let colors = colored.map(|mesh| mesh.colors);
    assert_eq!(colors, Ok(vec![[1.0, 0.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 0.5, 1.0]]));
    let plain = Mesh::from_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3").map(|mesh| mesh.colors);
    assert_eq!(plain, Ok(vec![[1.0; 4]; 3]));
}

#[test]
fn a_broken_obj_names_the_line_and_what_is_wrong() {
    let tri = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    let cases = [
        ("", "empty", None),
        ("\n \n", "empty", None),
        ("# nothing\n", "no-faces", None),
        (tri, "no-faces", None),
        ("<html>\n<p>\n", "not-obj", Some(1)),
        ("{\"rasterscope\":1}", "not-obj", Some(1)),
        ("v 0 0 0\nv 1 0 x\n", "number", Some(2)),
        ("v 0 0 0\nv 1,0 0 0\n", "number", Some(2)),
        ("v 0 0 0\n\nv 1 NaN 0\n", "not-finite", Some(3)),
        ("v inf 0 0\n", "not-finite", Some(1)),
        ("v 0 0 1e39\n", "not-finite", Some(1)),
        ("v 0 0 1e30 1e-30\n", "not-finite", Some(1)),
        ("v 0 0\n", "count", Some(1)),
        ("v 0 0 0 1 1\n", "count", Some(1)),
        ("v 0 0 0 1 1 1 1\n", "count", Some(1)),
        ("v 0 0 0 0\n", "zero-weight", Some(1)),
        ("v 0 0 0 1 1 255\n", "color", Some(1)),
        ("v 0 0 0 1 1 1\nv 0 0 0\n", "some-colors", Some(2)),
        ("v 0 0 0\nv 0 0 0 1 1 1\n", "some-colors", Some(2)),
        ("vt 0\n", "count", Some(1)),
        ("vn 0 0\n", "count", Some(1)),
        ("vn 0 0 nan\n", "not-finite", Some(1)),
    ];
    let faces = [
        ("f 1 2", "corners", Some(4)),
        ("f", "corners", Some(4)),
        ("f 1 2 3\nf 1 2 3 \\\n x", "corner", Some(5)),
        ("f 1 2 3/", "", None),
        ("f 1 2 /3", "corner", Some(4)),
        ("f 1/1/1/1 2 3", "corner", Some(4)),
        ("f 1 2 3.5", "corner", Some(4)),
        ("f 1 2 \u{FF13}", "corner", Some(4)),
        ("f 1 2 99999999999999999999", "corner", Some(4)),
        ("f 0 1 2", "index-zero", Some(4)),
        ("f 1 2 4", "no-such-index", Some(4)),
        ("f 1 2 -4", "no-such-index", Some(4)),
        ("f 1 2 -9223372036854775808", "no-such-index", Some(4)),
        ("f 1 2 9223372036854775807", "no-such-index", Some(4)),
        ("f 1/1 2/1 3/1", "no-such-index", Some(4)),
        ("f 1//-1 2 3", "no-such-index", Some(4)),
        ("vt 0 0\nf 1/1 2/9223372036854775807 3/1", "no-such-index", Some(5)),
        ("vt 0 0\nf 1/1 2/-2 3/1", "no-such-index", Some(5)),
        // Indices may point ahead, but not beyond the end; the first bad one counts.
        ("f 1 2 4\nf 1 2 6\nf 1 2 9\nf 1 2 7\nv 1 1 1", "no-such-index", Some(5)),
        ("f 1 2 4\nf 1 2 6\nvt 0 0\nf 1/3 2 3\nv 1 1 1", "no-such-index", Some(5)),
    ];
    let faces = faces.map(|(face, problem, at)| (format!("{tri}{face}"), problem, at));
    let cases = cases.map(|(text, problem, at)| (text.to_owned(), problem, at));
    for (text, problem, at) in cases.into_iter().chain(faces) {
        let found = Mesh::from_obj(text.as_bytes());
        if problem.is_empty() {
            assert!(found.is_ok(), "{text}");
            continue;
        }
        let message = found.expect_err(&text).message();
        assert_eq!(
            (message.id, line(&message)),
            (format!("error-obj-{problem}").as_str(), at.map(Value::Int)),
            "{text}"
        );
    }
}

#[test]
fn bytes_that_are_no_text_are_no_obj() {
    let binary = Mesh::from_obj(b"v 0 0 0\nv 1 \0 0\n").expect_err("a zero byte").message();
    assert_eq!((binary.id, line(&binary)), ("error-obj-binary", Some(Value::Int(2))));
    let latin = Mesh::from_obj(b"# \xE9\no \xE9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    assert_eq!(latin.map(|mesh| mesh.triangles.len()), Ok(1), "names and comments may be in any encoding");
    let broken = Mesh::from_obj(b"v 0 0 \xFF\xFE\n").expect_err("no number").message();
    assert_eq!((broken.id, line(&broken)), ("error-obj-number", Some(Value::Int(1))));
}

#[test]
fn every_beginning_of_a_model_gets_an_answer() {
    for (file, bytes) in MODELS.iter().filter(|(_, bytes)| bytes.len() < 1000) {
        for end in 0..bytes.len() {
            if let Ok(mesh) = Mesh::from_obj(&bytes[..end]) {
                let in_range = |i: &u32| usize::try_from(*i).is_ok_and(|i| i < mesh.positions.len());
                assert!(mesh.triangles.iter().flatten().all(in_range), "{file} cut at {end}");
            }
        }
    }
}

#[test]
fn a_line_of_a_hundred_megabytes_is_refused_by_its_length() {
    let mut huge = b"v 0 0 0\nf 1 1 1".to_vec();
    while huge.len() < 100_000_000 {
        huge.extend_from_within(8..);
        huge.extend_from_slice(b" 1");
    }
    let spaced: Vec<u8> = huge.iter().map(|byte| if *byte == b'f' { b' ' } else { *byte }).collect();
    for (what, bytes, id) in [
        ("a face", huge, "error-obj-line-too-long"),
        ("no statement", vec![b'x'; 100_000_000], "error-obj-not-obj"),
        ("numbers", spaced, "error-obj-not-obj"),
    ] {
        let message = Mesh::from_obj(&bytes).expect_err(what).message();
        assert_eq!(message.id, id, "{what}");
        // The message carries a beginning of the line, not the line.
        assert!(message.args.iter().all(|(_, value)| format!("{value:?}").len() < 200), "{what}");
    }
}

#[test]
fn a_scene_around_a_model_shows_all_of_it() {
    for (file, bytes) in MODELS {
        let mesh = Mesh::from_obj(bytes).unwrap_or_else(|error| panic!("{file}: {error}"));
        let scene = scene_from_obj(file, mesh, MODEL_SIZE);
        assert_eq!(scene.validate(), Ok(()), "{file}");
        assert_eq!(scene.draws[0].cull, CullMode::Back, "{file} is closed and turns outwards");
        let colored = *file == "tetrahedron.obj";
        assert_eq!(scene.draws[0].shade, if colored { Shade::None } else { Shade::Flat }, "{file}");
        assert!(matches!(&scene.draws[0].geometry, Geometry::Model { file: named, .. } if named == file));
        let again = Scene::from_json(scene.to_json().as_bytes())
            .and_then(|scene| scene.resolve(&mut |_| Ok(bytes.to_vec())));
        assert_eq!(again, Ok(scene), "{file}: saved and opened again");
    }
}

#[test]
fn the_camera_sees_every_vertex_of_a_model() {
    for (file, bytes) in MODELS {
        let mesh = Mesh::from_obj(bytes).unwrap_or_else(|error| panic!("{file}: {error}"));
        for size in [MODEL_SIZE, [300, 400]] {
            let camera = scene_from_obj(file, mesh.clone(), size).camera;
            let viewport = Viewport { size, ..Viewport::default() };
            let view = matrices::view(&camera);
            let projection = matrices::projection(&camera, viewport.aspect(), DepthRange::ZeroToOne, false);
            let most = mesh.positions.iter().fold([0.0_f32; 2], |most, [x, y, z]| {
                let [x, y, z, w] = apply(&projection, apply(&view, [*x, *y, *z, 1.0]));
                assert!(0.0 <= z && z <= w, "{file}: between near and far");
                [most[0].max(x.abs() / w), most[1].max(y.abs() / w)]
            });
            let filled = most[0].max(most[1]);
            assert!((0.85..0.95).contains(&filled), "{file} fills {filled} of {size:?}");
        }
    }
}

#[test]
fn only_a_closed_model_that_turns_outwards_is_culled() {
    let tetrahedron = "v 1 1 1\nv -1 -1 1\nv -1 1 -1\nv 1 -1 -1\n";
    let cull = |text: String| {
        let mesh = Mesh::from_obj(text.as_bytes()).expect("it is OBJ");
        scene_from_obj("x.obj", mesh, MODEL_SIZE).draws[0].cull
    };
    for (faces, expected) in [
        ("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4", CullMode::Back),
        ("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\nf 1 1 2", CullMode::Back),
        ("f 1 3 2\nf 1 2 4\nf 1 4 3", CullMode::None),
        ("f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3", CullMode::None),
        ("f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 4 3", CullMode::None),
    ] {
        assert_eq!(cull(format!("{tetrahedron}{faces}")), expected, "{faces}");
    }
}

#[test]
fn a_camera_fits_models_of_any_size_and_place() {
    for [x, y, z] in [
        ["1 0 0", "0 1 0", "0 0 1"],
        ["0 0 0", "0 0 0", "0 0 0"],
        ["5 5 5", "5 5 5", "5 5 5"],
        ["1e8 1e8 1e8", "1e8 1e8 1e8", "1e8 1e8 1e8"],
        ["1e-30 0 0", "0 1e-30 0", "0 0 1e-30"],
        ["1e30 0 0", "0 1e30 0", "0 0 1e30"],
        ["1e-45 0 0", "0 1e-45 0", "0 0 0"],
        ["3e38 3e38 0", "-3e38 0 3e38", "0 -3e38 -3e38"],
    ] {
        let mesh = Mesh::from_obj(format!("v {x}\nv {y}\nv {z}\nf 1 2 3").as_bytes()).expect("it is OBJ");
        for size in [MODEL_SIZE, [1, 1], [1, 16384], [16384, 1]] {
            let scene = scene_from_obj("x.obj", mesh.clone(), size);
            assert_eq!(scene.validate(), Ok(()), "{x}, {y}, {z}: {:?}", scene.camera);
        }
    }
}

/// Two real models, where they are at hand: beside the repository, not in it.
#[test]
fn real_models_are_read_whole() {
    for (file, vertices, triangles) in [("teapot.obj", 3644, 6320), ("bunny.obj", 34834, 69451)] {
        let path = format!("{}/../../shared/models/{file}", env!("CARGO_MANIFEST_DIR"));
        let Ok(bytes) = std::fs::read(path) else { continue };
        let mesh = Mesh::from_obj(&bytes).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert_eq!((mesh.positions.len(), mesh.triangles.len()), (vertices, triangles), "{file}");
    }
}
