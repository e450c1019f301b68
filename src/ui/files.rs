//! From the bytes of a file to a scene with its models.

use rasterscope_core::{
    message::Message,
    scene::{MODEL_SIZE, Mesh, Scene, model, scene_from_obj},
};

/// What reads another file that a scene names.
pub(crate) type Load<'a> = &'a mut dyn FnMut(&str) -> Option<Vec<u8>>;

/// Reads an OBJ model or a scene. Models that a scene names are looked for beside it, then among
/// the built-in ones.
pub(crate) fn open(path: &str, bytes: &[u8], load: Load<'_>) -> Result<Scene, Message> {
    let [folder, file] = split(path);
    if file.to_ascii_lowercase().ends_with(".obj") {
        let mesh = Mesh::from_obj(bytes).map_err(|error| error.named(file).message())?;
        return Ok(scene_from_obj(file, mesh, MODEL_SIZE));
    }
    scene(bytes, folder, load)
}

/// A path's folder, with the separator at its end, and its file.
pub(crate) fn split(path: &str) -> [&str; 2] {
    let (folder, file) = path.rfind(['/', '\\']).map_or(("", path), |at| path.split_at(at + 1));
    [folder, file]
}

/// Reads a scene whose models stand in `folder` or are built in.
pub(crate) fn scene(bytes: &[u8], folder: &str, load: Load<'_>) -> Result<Scene, Message> {
    let scene = Scene::from_json(bytes).map_err(|error| error.message())?;
    resolve(&scene, folder, load)
}

/// The scene with its models, which stand in `folder` or are built in.
pub(crate) fn resolve(scene: &Scene, folder: &str, load: Load<'_>) -> Result<Scene, Message> {
    let mut find = |file: &str| {
        let beside = load(&format!("{folder}{file}"));
        beside.or_else(|| model(file).map(<[u8]>::to_vec)).ok_or_else(|| file.to_owned())
    };
    scene.resolve(&mut find).map_err(|error| error.message())
}
