//! The scene: what is drawn, how, and seen from where. The only place where bytes enter the core.
//!
//! [`Scene`] is the document. A scene file is read as JSON, then field by field, so that an error
//! names the path of the bad field; what no single field can tell is checked last. Models are OBJ
//! files. Reading files is the caller's: it hands over bytes.

mod document;

pub use document::{
    Clear, DEFAULT_COLOR, Draw, Geometry, Lab, LabInput, Mesh, Scene, Shade, Texture, Transform,
};
