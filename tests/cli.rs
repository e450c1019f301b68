//! `trace`, `figure`, `list` and what a FILE may be: in, out, and one sentence when it fails.

use rasterscope_cli::{
    Failure,
    compute::compute_file,
    figure::{AnimateOptions, FigureOptions, SIZE, animate, figure},
    files::open_scene,
    list::list,
    tour::{TourOptions, tour},
    trace::{TraceFormat, TraceOptions, trace},
};
use rasterscope_core::{explain::Level, labs, scene::PRESETS};
use rasterscope_figure::theme::ThemeName;
use serde_json::Value;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// An empty folder for one test.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("the old one can go");
    }
    fs::create_dir_all(&folder).expect("a folder can be made");
    folder
}

/// A file of its own with these contents.
pub(crate) fn file(folder: &Path, name: &str, contents: impl AsRef<[u8]>) -> PathBuf {
    fs::write(folder.join(name), contents).expect("a file can be written");
    folder.join(name)
}

fn traced(algorithm: &str, file: &Path, format: TraceFormat) -> Result<String, Failure> {
    let mut out = Vec::new();
    let options = TraceOptions { algorithm: algorithm.into(), file: file.into(), format };
    trace(&options, &mut out)?;
    Ok(String::from_utf8(out).expect("text"))
}

/// The one sentence of a failure.
#[track_caller]
pub(crate) fn sentence(failure: &Failure) -> String {
    let text = failure.to_string();
    assert!(!text.contains('⟨') && !text.contains('\n'), "{text}");
    assert!(text.ends_with('.'), "{text}");
    text
}

const LINE: &str = r#"{"op":"clip_line","window":[0,0,4,4],"segment":[-2,1,6,3]}"#;

#[test]
fn a_trace_is_one_line_an_event() {
    let folder = folder("trace");
    let request = file(&folder, "line.json", LINE);
    let text = traced("cohen-sutherland", &request, TraceFormat::Text).expect("it runs");
    crate::support::check_golden("cli/trace_cohen_sutherland", &text);

    let json = traced("cohen-sutherland", &request, TraceFormat::Json).expect("it runs");
    let lines: Vec<Value> = json.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    assert_eq!(lines.len(), text.lines().count());
    for (i, line) in lines.iter().enumerate() {
        assert_eq!(line["step"], i + 1);
        assert!(line["sentence"].as_str().is_some_and(|sentence| sentence.ends_with('.')));
        assert!(line["code"].as_str().is_some_and(|code| !code.is_empty()));
        assert!(!line["event"].is_null());
    }
    let last = &lines[lines.len() - 1];
    assert_eq!(last["values"][0]["rows"][0]["cells"], serde_json::json!([0.0, 1.5, "0000"]));
    assert_eq!(last["level"], "primitive");
}

#[test]
fn every_lab_can_be_traced_on_its_requests_and_on_the_default_scene() {
    let folder = folder("labs");
    let coverage = r#"{"op":"coverage","size":[8,8],"vertices":[[0.3,0.7],[7.8,1.6],[2.2,6.8]]}"#;
    let depth = r#"{"op":"depth","size":[8,8],"vertices":[[0.3,0.7,0.3],[7.8,1.6,0.8],[2.2,6.8,0.5]]}"#;
    for (lab, request) in [("cohen-sutherland", LINE), ("scanline", coverage), ("z-buffer", depth)] {
        let path = file(&folder, &format!("{lab}.json"), request);
        for format in TraceFormat::ALL {
            let text = traced(lab, &path, format).unwrap_or_else(|failure| panic!("{lab}: {failure}"));
            assert!(text.lines().count() > 3, "{lab}");
            assert!(!text.contains('⟨'), "{lab}: a message is missing in {text}");
        }
    }
    for lab in ["transform", "scanline", "z-buffer"] {
        let text = traced(lab, Path::new(PRESETS[0].name), TraceFormat::Text);
        assert!(text.unwrap_or_else(|failure| panic!("{lab}: {failure}")).lines().count() > 3);
    }
}

#[test]
fn what_cannot_be_traced_is_said_in_a_sentence() {
    let folder = folder("untraceable");
    let line = file(&folder, "line.json", LINE);
    let point = r#"{"op":"interpolate","vertices":[[0,0,1],[4,0,1],[0,4,1]],"attribute":[0,1,2],"at":[1,1]}"#;
    let point = file(&folder, "point.json", point);
    for (lab, path, code, part) in [
        ("fly", line.as_path(), 2, "cohen-sutherland"),
        ("homogeneous", line.as_path(), 1, "line.json"),
        ("scanline", line.as_path(), 1, "line.json"),
        ("scanline", point.as_path(), 1, "interpolate"),
        ("cohen-sutherland", Path::new(PRESETS[0].name), 1, "cohen-sutherland"),
        ("scanline", Path::new("nowhere.json"), 1, "nowhere.json"),
    ] {
        let failure = traced(lab, path, TraceFormat::Text).expect_err("it cannot run");
        assert_eq!(failure.exit_code(), code, "{failure}");
        assert!(sentence(&failure).contains(part), "{failure}");
    }
}

fn picture(lab: &str, file: &Path, step: Option<usize>, output: &Path) -> Result<(), Failure> {
    figure(&options(lab, file, step, output), &mut Vec::new())
}

fn options(lab: &str, file: &Path, step: Option<usize>, output: &Path) -> FigureOptions {
    let (lab, file, output) = (lab.to_owned(), file.to_owned(), output.to_owned());
    FigureOptions {
        lab,
        file,
        step,
        size: SIZE,
        overlay: Default::default(),
        theme: ThemeName::Light,
        output,
    }
}

#[test]
fn a_figure_is_the_picture_of_a_step_as_svg_or_png() {
    let folder = folder("figure");
    let line = file(&folder, "line.json", LINE);
    let [start, end, last] = ["start.svg", "end.svg", "last.svg"].map(|name| folder.join(name));
    picture("cohen-sutherland", &line, Some(0), &start).expect("it is drawn");
    picture("cohen-sutherland", &line, None, &end).expect("it is drawn");
    picture("cohen-sutherland", &line, Some(1_000_000), &last).expect("it is drawn");
    let [start, end, last] = [start, end, last].map(|path| fs::read_to_string(path).expect("it was written"));
    assert!(start.starts_with("<svg ") && end.ends_with("</svg>\n"));
    assert!(start != end && end == last);
    assert!(end.contains("P1′ (0, 1.5)") && !start.contains("P1′"));

    let image = folder.join("image.PNG");
    picture("pipeline", Path::new(PRESETS[0].name), None, &image).expect("it is drawn");
    let bytes = fs::read(&image).expect("it was written");
    let reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("it is a PNG");
    assert_eq!([reader.info().width, reader.info().height], SIZE.map(|side| 2 * side));
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 5, "only what was asked for is left");
}

/// The number of frames, and the first one's pixels.
fn animated(lab: &str, file: &Path, level: Option<Level>, output: &Path) -> Result<(u32, Vec<u8>), Failure> {
    let (lab, file, output) = (lab.to_owned(), file.to_owned(), output.to_owned());
    let options = FigureOptions {
        lab,
        file,
        step: None,
        size: [160, 120],
        overlay: Default::default(),
        theme: ThemeName::Light,
        output,
    };
    let mut progress = Vec::new();
    animate(&options, AnimateOptions { level, delay: 100 }, Some(&mut progress))?;
    assert!(String::from_utf8_lossy(&progress).contains("Frame 1 of "));
    let (info, first) = pixels(&fs::read(&options.output).expect("it was written"));
    let frames = info.animation_control.expect("it is animated").num_frames;
    figure(&FigureOptions { step: Some(0), ..options.clone() }, &mut Vec::new())?;
    let (_, start) = pixels(&fs::read(&options.output).expect("it was written"));
    let rgb: Vec<u8> = start.chunks_exact(4).flat_map(|pixel| pixel[..3].to_vec()).collect();
    assert!(rgb == first, "the first frame is the figure of the start");
    Ok((frames, first))
}

fn pixels(png: &[u8]) -> (png::Info<'static>, Vec<u8>) {
    let mut reader = png::Decoder::new(std::io::Cursor::new(png)).read_info().expect("it is a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("it is small")];
    reader.next_frame(&mut pixels).expect("it is whole");
    (reader.info().clone(), pixels)
}

#[test]
fn a_run_is_an_animated_picture_of_its_steps() {
    let folder = folder("animate");
    let line = file(&folder, "line.json", LINE);
    let output = folder.join("run.png");
    let [primitive, detail] = [Level::Primitive, Level::Detail]
        .map(|level| animated("cohen-sutherland", &line, Some(level), &output).expect("it is drawn").0);
    let steps = traced("cohen-sutherland", &line, TraceFormat::Text).expect("it runs").lines().count();
    assert_eq!((primitive, detail as usize), (2, steps + 1));
    let finest = animated("cohen-sutherland", &line, None, &output).expect("it is drawn").0;
    assert_eq!(finest, detail, "a short run is shown in its finest steps");

    let deep = r#"{"op":"depth","size":[64,64],"vertices":[[0,0,0],[64,0,0],[0,64,1]]}"#;
    let deep = file(&folder, "deep.json", deep);
    let failure = animated("z-buffer", &deep, Some(Level::Detail), &output).expect_err("too many frames");
    assert!(sentence(&failure).contains("600") && failure.exit_code() == 1);
    let (rows, _) = animated("z-buffer", &deep, None, &output).expect("rows are few enough");
    assert!((60..=70).contains(&rows), "{rows}");
    let failure = animated("z-buffer", &deep, None, &folder.join("run.svg")).expect_err("SVG stands still");
    assert_eq!(failure.exit_code(), 2, "{}", sentence(&failure));
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 3, "only what was asked for is left");
}

#[test]
fn wrong_use_of_figure_is_told_from_work_that_fails() {
    let folder = folder("figure-failures");
    let line = file(&folder, "line.json", LINE);
    for (lab, output, code) in [
        ("fly", "a.svg", 2),
        ("cohen-sutherland", "a.gif", 2),
        ("cohen-sutherland", "a", 2),
        ("cohen-sutherland", "missing/a.svg", 1),
        ("cohen-sutherland", "line.json/a.svg", 1),
        ("scanline", "a.svg", 1),
    ] {
        let failure = picture(lab, &line, None, &folder.join(output)).expect_err("it fails");
        assert_eq!(failure.exit_code(), code, "{failure}");
        sentence(&failure);
    }
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 1, "nothing was left behind");
}

#[test]
fn what_was_there_stays_if_the_new_file_cannot_be_written() {
    let folder = folder("whole-or-not");
    let line = file(&folder, "line.json", LINE);
    let taken = folder.join("taken.svg");
    fs::create_dir_all(taken.join("inside")).expect("a folder can be made");
    let failure = picture("cohen-sutherland", &line, None, &taken).expect_err("a folder is in the way");
    assert!(sentence(&failure).contains("taken.svg"));
    assert!(taken.join("inside").is_dir());
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 2, "no part is left behind");
}

#[test]
fn a_file_is_a_scene_a_model_or_the_name_of_a_preset() {
    let folder = folder("kinds");
    let triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    file(&folder, "own.obj", triangle);
    let scene = r#"{"rasterscope":1,"size":[4,4],"draws":[{"model":"own.obj"},{"model":"cube.obj"}]}"#;
    for (name, contents, triangles) in [
        ("model.obj", triangle, 1),
        ("model.OBJ", triangle, 1),
        ("model.txt", triangle, 1),
        ("scene.json", scene, 13),
    ] {
        let scene = open_scene(Some(&file(&folder, name, contents))).expect("it opens");
        let meshes = scene.draws.iter().filter_map(|draw| draw.geometry.mesh());
        assert_eq!(meshes.map(|mesh| mesh.triangles.len()).sum::<usize>(), triangles, "{name}");
    }
    for preset in PRESETS {
        open_scene(Some(Path::new(preset.name))).expect("a preset opens");
    }
    assert_eq!(open_scene(None), open_scene(Some(Path::new(PRESETS[0].name))));
}

#[test]
fn bad_files_give_one_sentence_that_names_the_place() {
    let folder = folder("bad-files");
    let scene = |inside: &str| format!(r#"{{"rasterscope":1,"size":[4,4],"draws":[{inside}]}}"#);
    let long_line = format!("{{\"rasterscope\":1,\"note\":\"{}\"}}", "a".repeat(100 << 20));
    file(&folder, "short.obj", "v 0 0\n");
    for (name, contents, part) in [
        ("empty.json", Vec::new(), "empty.json"),
        ("binary.bin", vec![0, 159, 146, 150, 0], "binary.bin"),
        ("binary.obj", vec![0, 159, 146, 150, 0], "binary.obj"),
        ("nan.json", scene(r#"{"vertices":[[0,0,NaN],[1,0,0],[0,1,0]]}"#).into_bytes(), "NaN"),
        (
            "huge.json",
            scene(r#"{"vertices":[[0,0,1e39],[1,0,0],[0,1,0]]}"#).into_bytes(),
            "draws[0].vertices[0][2]",
        ),
        ("cut.json", scene(r#"{"vertices":[[0,0,0],[1,0"#).into_bytes()[..60].to_vec(), "line 1"),
        ("missing.json", scene(r#"{"model":"nowhere.obj"}"#).into_bytes(), "nowhere.obj"),
        ("outside.obj", b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n".to_vec(), "line 4"),
        ("truncated.obj", b"v 0 0 0\nv 1 0 0\nv 0 1".to_vec(), "line 3"),
        ("letters.obj", b"v 0 0 0\nv 1 x 0\n".to_vec(), "line 2"),
        ("deep.json", b"[".repeat(100_000), "127 levels"),
        ("fraction.json", scene(r#"{"vertices":[],"indices":[[0,.5,1]]}"#).into_bytes(), "0.5"),
        ("inside.json", scene(r#"{"model":"short.obj"}"#).into_bytes(), "draws[0].model: short.obj, line 1"),
        ("long.json", long_line.into_bytes(), "long.json"),
        ("request.json", LINE.into(), "compute"),
    ] {
        let failure = open_scene(Some(&file(&folder, name, contents))).expect_err(name);
        assert_eq!(failure.exit_code(), 1);
        let sentence = sentence(&failure);
        assert!(sentence.contains(part) && sentence.len() < 400, "{name}: {sentence}");
    }
    for (path, part) in [(folder.as_path(), "folder"), (&folder.join("nowhere.json"), "nowhere.json")] {
        let failure = open_scene(Some(path)).expect_err("there is no file");
        assert!(sentence(&failure).contains(part), "{failure}");
        let failure = compute_file(path, &mut Vec::new()).expect_err("there is no file");
        assert!(sentence(&failure).contains(part), "{failure}");
    }
}

#[test]
fn the_list_names_everything_with_a_sentence() {
    let mut out = Vec::new();
    list(&mut out).expect("it is written");
    let text = String::from_utf8(out).expect("text");
    let names = labs::ALL.iter().map(|lab| lab.name).chain(PRESETS.iter().map(|preset| preset.name));
    for name in names.chain(["aabb"]) {
        let line = text.lines().find(|line| line.trim_start().starts_with(&format!("{name} ")));
        let line = line.unwrap_or_else(|| panic!("{name} is missing"));
        assert!(line.ends_with('.'), "{name} has no sentence: {line}");
    }
}

#[test]
fn the_list_tells_what_can_be_stepped() {
    let mut out = Vec::new();
    list(&mut out).expect("it is written");
    let text = String::from_utf8(out).expect("text");
    let sections: Vec<&str> = text.split("\n\n").collect();
    for lab in labs::ALL {
        assert!(sections[0].contains(&format!("  {} ", lab.name)), "{}", lab.name);
    }
}

#[test]
fn a_step_past_the_end_is_the_end_and_is_noted() {
    let folder = folder("past-the-end");
    let line = file(&folder, "line.json", LINE);
    for (step, noted) in [(Some(99_999), true), (Some(12), false), (None, false)] {
        let mut notes = Vec::new();
        let output = folder.join("a.svg");
        figure(&options("cohen-sutherland", &line, step, &output), &mut notes).expect("it is drawn");
        let notes = String::from_utf8(notes).expect("text");
        assert_eq!((notes.contains("12 steps"), notes.is_empty()), (noted, !noted), "{notes}");
    }
}

#[cfg(unix)]
#[test]
fn a_file_is_replaced_as_its_owner_wants() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let folder = folder("replaced");
    let line = file(&folder, "line.json", LINE);
    let mode = |path: &Path| fs::metadata(path).expect("it is there").permissions().mode() & 0o777;
    let set = |path: &Path, mode| {
        fs::set_permissions(path, fs::Permissions::from_mode(mode)).expect("it is ours");
    };

    let locked = file(&folder, "locked.svg", "old");
    set(&locked, 0o444);
    let failure = picture("cohen-sutherland", &line, None, &locked).expect_err("it may not be written");
    assert!(sentence(&failure).contains("read-only"), "{failure}");
    assert_eq!(fs::read_to_string(&locked).expect("it is there"), "old");

    let private = file(&folder, "private.svg", "old");
    set(&private, 0o600);
    let [link, dangling] = ["link.svg", "dangling.svg"].map(|name| folder.join(name));
    symlink("private.svg", &link).expect("a link can be made");
    symlink("new.svg", &dangling).expect("a link can be made");
    for path in [&link, &dangling] {
        picture("cohen-sutherland", &line, None, path).expect("it is drawn");
        assert!(path.is_symlink(), "{path:?}");
        assert!(fs::read_to_string(path).expect("it is there").starts_with("<svg "));
    }
    assert_eq!(mode(&private), 0o600);
    assert_eq!(fs::read_dir(&folder).expect("it is there").count(), 6, "no part is left behind");
}

#[test]
fn what_is_in_the_way_of_output_is_named() {
    let folder = folder("in-the-way");
    let line = file(&folder, "line.json", LINE);
    let missing = folder.join("missing/a.svg");
    let failure = picture("cohen-sutherland", &line, None, &missing).expect_err("no folder");
    assert!(sentence(&failure).contains("missing does not exist"), "{failure}");
    let failure = tour(&TourOptions { file: None, output: line }, None).expect_err("a file is no folder");
    assert!(sentence(&failure).contains("in the way"), "{failure}");
}

#[test]
fn a_scene_that_leaves_the_range_of_binary32_is_refused_by_name() {
    let folder = folder("out-of-range");
    let huge = r#"{"vertices":[[1e20,0,0],[0,1e20,0],[0,0,1e20]],"transform":{"scale":[1,1e30,1]}}"#;
    let scene = |inside: &str| format!(r#"{{"rasterscope":1,"size":[4,4],{inside}}}"#);
    for (contents, place) in [
        (scene(&format!(r#""draws":[{{"vertices":[]}},{huge}]"#)), "draws[1]"),
        (scene(r#""camera":{"eye":[3e38,3e38,3e38]},"draws":[]"#), "camera"),
        (scene(r#""camera":{"near":1e-42},"draws":[]"#), "camera"),
    ] {
        let failure = open_scene(Some(&file(&folder, "scene.json", contents))).expect_err("out of range");
        assert!(sentence(&failure).contains(&format!("scene.json: {place}: ")), "{failure}");
    }
    PRESETS
        .iter()
        .for_each(|preset| drop(open_scene(Some(Path::new(preset.name))).expect("it stays in range")));
}
