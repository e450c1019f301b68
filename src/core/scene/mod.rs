//! The scene: what is drawn, how, and seen from where. The only place where bytes enter the core.
//!
//! [`Scene`] is the document. A scene file is read as JSON, then field by field, so that an error
//! names the path of the bad field; what no single field can tell is checked last. Models are OBJ
//! files. Reading files is the caller's: it hands over bytes.

mod assets;
mod document;
mod error;
mod file;
mod fit;
mod json;
mod layout;
mod obj;
mod path;
mod read;
mod validate;
mod wire;

pub use assets::{MODELS, PRESETS, Preset, model, preset};
pub use document::{Clear, DEFAULT_COLOR, Draw, Geometry, Lab, Mesh, Scene, Shade, Texture, Transform};
pub use error::{Kind, Problem, SceneError};
pub use file::MAX_SCENE_BYTES;
pub use fit::{MODEL_SIZE, scene_from_obj};
pub use json::{JsonError, JsonFault};
pub use obj::{ObjError, ObjProblem};
pub use validate::{MAX_PIXELS, MAX_SIDE};

pub(crate) use path::FieldError;
pub(crate) use read::read;
pub(crate) use validate::{
    Checked, check_bias, check_cut, each_finite, each_in_unit, each_row_finite, refuse_if,
};
