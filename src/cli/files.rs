//! Where files are read and written, and what a FILE may hold.
//!
//! A FILE is a scene, an OBJ model, a `compute` request where that makes sense, or the name of a
//! preset. Output is written whole or not at all: beside its place first, then renamed.

use rasterscope_core::{
    labs,
    message::{Message, Value},
    pipeline::out_of_range,
    scene::{
        Lab, MODEL_SIZE, Mesh, PRESETS, Preset, Scene, SceneError, model as built_in_model, preset,
        scene_from_obj,
    },
};
use std::{
    fs::{self, File},
    io::{self, Read},
    path::{Path, PathBuf},
};

use crate::{
    Failure,
    compute::{self, Request},
    failure::reason,
    words::{WORDS, say},
};

/// Files beyond this many bytes are not read.
const MOST_BYTES: u64 = 1 << 30;

/// Reads a file of any kind.
pub(crate) fn read(path: &Path) -> Result<Vec<u8>, Failure> {
    try_read(path).map_err(|error| about("error-cannot-read", path, &error))
}

fn try_read(path: &Path) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MOST_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MOST_BYTES { Err(io::ErrorKind::FileTooLarge.into()) } else { Ok(bytes) }
}

/// What went wrong with a file, as a sentence that names it.
pub(crate) fn about(id: &'static str, path: &Path, error: &io::Error) -> Failure {
    Failure::work(&Message::new(id).with("file", name(path)).with("why", reason(error)))
}

fn name(path: &Path) -> Value {
    Value::text(path.display())
}

/// [`write_whole`], with a sentence that says what is wrong.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    write_whole(path, bytes).map_err(|error| {
        let target = followed(path);
        let message = |id, why| Message::new(id).with("file", name(path)).with("why", why);
        Failure::work(&match target.parent().filter(|folder| !folder.as_os_str().is_empty()) {
            Some(folder) if !folder.exists() => {
                Message::new("error-no-folder").with("file", name(path)).with("folder", name(folder))
            }
            _ if is_read_only(&target) => message("error-cannot-write", Value::Word("word-file-read-only")),
            _ => message("error-cannot-write", reason(&error)),
        })
    })
}

/// Writes a file whole or not at all; what stood there before stays until the new one is whole.
///
/// A symbolic link stays one: what it points to is written. A file keeps its permissions, and one
/// that may not be written is refused, though its folder would let it be replaced.
pub fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let target = followed(path);
    let old = fs::metadata(&target).ok().map(|old| old.permissions());
    if old.is_some() {
        if is_read_only(&target) {
            return Err(io::ErrorKind::PermissionDenied.into());
        }
        File::options().write(true).open(&target)?;
    }
    let mut part = target.clone().into_os_string();
    part.push(format!(".{}.part", std::process::id()));
    let written = fs::write(&part, bytes)
        .and_then(|()| old.map_or(Ok(()), |old| fs::set_permissions(&part, old)))
        .and_then(|()| fs::rename(&part, &target));
    written.inspect_err(|_| {
        // What cannot be removed was not written either; the first error is the one to report.
        let _ = fs::remove_file(&part);
    })
}

fn is_read_only(path: &Path) -> bool {
    fs::metadata(path).is_ok_and(|file| file.permissions().readonly())
}

/// Where a chain of symbolic links leads, also if nothing is there yet.
fn followed(path: &Path) -> PathBuf {
    const MOST_LINKS: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let Ok(next) = fs::read_link(&path) else { break };
        path = path.parent().unwrap_or(Path::new("")).join(next);
    }
    path
}

/// Makes a folder, and those that it stands in.
pub(crate) fn make_folder(path: &Path) -> Result<(), Failure> {
    fs::create_dir_all(path).map_err(|error| about("error-cannot-write", path, &error))
}

/// What a FILE holds.
#[derive(Debug)]
enum Content {
    Scene(Box<Scene>),
    Request(Request),
}

impl Content {
    fn scene(scene: Scene) -> Self {
        Self::Scene(Box::new(scene))
    }
}

/// The scene of a FILE with its models loaded; the default preset without a FILE.
pub fn open_scene(path: Option<&Path>) -> Result<Scene, Failure> {
    let Some(path) = path else { return open_preset(&PRESETS[0]) };
    match open(path)? {
        Content::Scene(scene) => Ok(*scene),
        Content::Request(_) => {
            Err(Failure::work(&Message::new("error-request-is-no-scene").with("file", name(path))))
        }
    }
}

/// The scene of a FILE, or of the request that it holds, with `lab` opened on it.
pub(crate) fn open_lab(lab: &str, path: &Path) -> Result<Scene, Failure> {
    let (mut scene, from_request) = match open(path)? {
        Content::Scene(scene) => (*scene, false),
        Content::Request(request) => {
            let scene = compute::lab(&request).map_err(|refusal| inside(path, &refusal.message))?;
            (in_range(path, scene)?, true)
        }
    };
    let input = scene.lab.as_ref().map(|lab| &lab.input);
    if input.is_some_and(|input| input.name() == lab) {
        return Ok(scene);
    }
    // The algorithms of a family take the same inputs.
    let carried = labs::find(lab).and_then(|lab| input?.carried(lab.name));
    if let Some(input) = carried {
        scene.lab = Some(Lab::new(input));
        return Ok(scene);
    }
    // What needs no input beyond the scene's triangles starts on any scene that has some.
    match labs::default_input(lab) {
        Some(input) if !from_request && input.is_of_scene() => {
            scene.lab = Some(Lab::new(input));
            Ok(scene)
        }
        _ => {
            let message = Message::new("error-no-input-for-lab");
            Err(Failure::work(&message.with("file", name(path)).with("lab", Value::text(lab))))
        }
    }
}

fn open(path: &Path) -> Result<Content, Failure> {
    let bytes = match try_read(path) {
        Ok(bytes) => bytes,
        Err(error) if error.kind() == io::ErrorKind::NotFound => match built_in(path) {
            Some(found) => return found,
            None => return Err(about("error-file-not-found", path, &error)),
        },
        Err(error) => return Err(about("error-cannot-read", path, &error)),
    };
    content(path, &bytes)
}

/// The preset or model of that name.
fn built_in(path: &Path) -> Option<Result<Content, Failure>> {
    let name = path.to_str()?;
    if let Some(preset) = preset(name.strip_suffix(".json").unwrap_or(name)) {
        return Some(open_preset(preset).map(Content::scene));
    }
    built_in_model(name).map(|bytes| model(path, bytes))
}

/// A scene that is part of the program.
pub(crate) fn open_preset(preset: &Preset) -> Result<Scene, Failure> {
    scene(Path::new(preset.name), Scene::from_json(preset.json.as_bytes()), None)
}

fn content(path: &Path, bytes: &[u8]) -> Result<Content, Failure> {
    let text = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes).trim_ascii_start();
    let named_obj = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("obj"));
    if named_obj || !text.starts_with(b"{") && looks_like_obj(text) {
        return model(path, bytes);
    }
    if bytes.len() <= compute::MOST_BYTES
        && let Ok(request) = Request::parse(bytes)
        && request.optional("op").is_some()
    {
        return Ok(Content::Request(request));
    }
    scene(path, Scene::from_json(bytes), path.parent()).map(Content::scene)
}

/// Whether one of the first lines is a vertex.
fn looks_like_obj(text: &[u8]) -> bool {
    const LINES: usize = 1000;
    const BYTES: usize = 1 << 16;
    let start = &text[..text.len().min(BYTES)];
    start.split(|&byte| byte == b'\n').take(LINES).any(|line| line.trim_ascii_start().starts_with(b"v "))
}

fn model(path: &Path, bytes: &[u8]) -> Result<Content, Failure> {
    let file = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let mesh = Mesh::from_obj(bytes).map_err(|error| Failure::work(&error.named(&file).message()))?;
    in_range(path, scene_from_obj(&file, mesh, MODEL_SIZE)).map(Content::scene)
}

fn scene(path: &Path, scene: Result<Scene, SceneError>, folder: Option<&Path>) -> Result<Scene, Failure> {
    let scene = scene
        .and_then(|scene| scene.resolve(&mut |file| load_model(file, folder)))
        .map_err(|error| inside(path, &error.message()))?;
    in_range(path, scene)
}

/// Refuses a scene whose picture would be that of another one.
fn in_range(path: &Path, scene: Scene) -> Result<Scene, Failure> {
    match out_of_range(&scene) {
        Some(problem) => Err(inside(path, &problem)),
        None => Ok(scene),
    }
}

/// Whether a FILE is there: on the disk, or built in.
pub fn exists(path: &Path) -> bool {
    let name = path.to_str().unwrap_or_default();
    path.exists()
        || preset(name.strip_suffix(".json").unwrap_or(name)).is_some()
        || built_in_model(name).is_some()
}

/// A sentence about what stands in a file, with the file's name before it.
fn inside(path: &Path, problem: &Message) -> Failure {
    let message = Message::new("error-in-file").with("file", name(path));
    Failure::work(&message.with("problem", Value::text(say(problem))))
}

/// The bytes of a model that a scene names: from the scene's folder, the current directory, or
/// among the built-in ones.
///
/// An absolute path and `..` are allowed, as they are on the command line: whoever runs a scene can
/// read the file anyway. Of a file that is no model, an error shows its line and 20 characters at most.
pub(crate) fn load_model(file: &str, folder: Option<&Path>) -> Result<Vec<u8>, String> {
    let mut problem = io::Error::from(io::ErrorKind::NotFound);
    for folder in folder.into_iter().chain([Path::new("")]) {
        match try_read(&folder.join(file)) {
            Ok(bytes) => return Ok(bytes),
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => problem = error,
        }
    }
    match built_in_model(file) {
        Some(bytes) => Ok(bytes.to_vec()),
        None => Err(WORDS.value(&reason(&problem))),
    }
}
