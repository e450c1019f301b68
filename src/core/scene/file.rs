//! Bytes to a scene and back.

use super::{
    document::{Geometry, Mesh, Scene},
    error::{Problem, SceneError},
    json::JsonError,
    layout::lay_out,
    path::FieldError,
    read::read,
    wire::SceneWire,
};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use serde_json::Value;
use std::sync::Arc;

/// Largest scene file in bytes: some hundred thousand vertices, and memory for them in reason.
pub const MAX_SCENE_BYTES: usize = 32 << 20;

impl Scene {
    /// Reads a scene file; models are named in it, not loaded (see [`resolve`](Self::resolve)).
    ///
    /// A byte-order mark is skipped. Nesting deeper than 128 is an error. Cost: linear.
    ///
    /// # Errors
    /// Anything malformed, with line and column or the path of the bad field.
    pub fn from_json(bytes: &[u8]) -> Result<Self, SceneError> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        if bytes.trim_ascii().is_empty() {
            return Err(SceneError::Empty);
        }
        if bytes.len() > MAX_SCENE_BYTES {
            return Err(SceneError::TooLarge { bytes: bytes.len(), limit: MAX_SCENE_BYTES });
        }
        let text = std::str::from_utf8(bytes).map_err(|error| not_text(bytes, error.valid_up_to()))?;
        if let Some(zero) = text.find('\0') {
            return Err(not_text(bytes, zero));
        }
        let value =
            serde_json::from_str(text).map_err(|error| SceneError::Json(JsonError::new(text, &error)))?;
        Self::from_value(value)
    }

    /// Reads a scene that is part of another JSON document.
    ///
    /// # Errors
    /// The path of the bad field.
    pub fn from_value(value: Value) -> Result<Self, SceneError> {
        let scene = check_version(&value)
            .and_then(|()| read::<SceneWire>(&value))
            .and_then(SceneWire::into_scene)
            .map_err(SceneError::from)?;
        scene.validate()?;
        Ok(scene)
    }

    /// The scene file: laid out for reading, the version first, the same text for equal scenes.
    pub fn to_json(&self) -> String {
        // A struct of numbers, texts and lists has no way to fail.
        lay_out(&serde_json::to_string(&SceneWire::from(self)).unwrap_or_default())
    }

    /// The scene with its models loaded: `load` gets each model's file name, once for each name.
    ///
    /// # Errors
    /// A model that cannot be read, with the words of `load`, or is no OBJ file.
    pub fn resolve(&self, load: &mut dyn FnMut(&str) -> Result<Vec<u8>, String>) -> Result<Self, SceneError> {
        let mut scene = self.clone();
        let mut loaded: Vec<(String, Arc<Mesh>)> = Vec::new();
        for (i, draw) in scene.draws.iter_mut().enumerate() {
            let Geometry::Model { file, color, mesh } = &mut draw.geometry else { continue };
            let path = || format!("draws[{i}].model");
            let known = loaded.iter().find(|(name, _)| name == file).map(|(_, mesh)| mesh.clone());
            let model = match known {
                Some(model) => model,
                None => {
                    let bytes = load(file).map_err(|reason| SceneError::Unreadable {
                        path: path(),
                        file: file.clone(),
                        reason,
                    })?;
                    let model = Mesh::from_obj(&bytes)
                        .map_err(|error| SceneError::Model { path: path(), error: error.named(file) })?;
                    loaded.push((file.clone(), Arc::new(model)));
                    loaded[loaded.len() - 1].1.clone()
                }
            };
            *mesh = Some(match *color {
                Some(color) => {
                    Arc::new(Mesh { colors: vec![color; model.positions.len()], ..Mesh::clone(&model) })
                }
                None => model,
            });
        }
        scene.validate()?;
        Ok(scene)
    }
}

impl Serialize for Scene {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        SceneWire::from(self).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Scene {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::from_value(Value::deserialize(deserializer)?).map_err(D::Error::custom)
    }
}

/// Before anything else, so that a newer file is called newer and not wrong.
fn check_version(value: &Value) -> Result<(), FieldError> {
    let Value::Object(fields) = value else { return Err(FieldError::here(Problem::NotAScene)) };
    match fields.get("rasterscope") {
        None => Err(FieldError::here(Problem::NotAScene)),
        Some(version) => match read::<u32>(version).map_err(|error| error.within("rasterscope"))? {
            Scene::VERSION => Ok(()),
            version if version > Scene::VERSION => {
                Err(FieldError::at("rasterscope", Problem::Newer { version, known: Scene::VERSION }))
            }
            _ => {
                let known = f64::from(Scene::VERSION);
                Err(FieldError::at("rasterscope", Problem::Range { min: known, max: known }))
            }
        },
    }
}

fn not_text(bytes: &[u8], at: usize) -> SceneError {
    SceneError::NotText { line: 1 + bytes[..at].iter().filter(|byte| **byte == b'\n').count() }
}
