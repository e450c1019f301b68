//! `render`: a scene to its image. `"bounding": "box" | "sphere" | "tree"` says what stands for an object
//! in the skip `object-frustum`; it changes counters, never the image.

use base64::{Engine, engine::general_purpose::STANDARD};
use rasterscope_core::{
    math::Arithmetic,
    message::Message,
    pipeline::{self, Bounding, Frame, Pipeline, Skip, Skips, Stats},
    scene::{Scene, SceneError},
};
use serde::{Serialize, Serializer};

use super::{Refusal, Request, refusal::text};
use crate::files::load_model;

/// The image. `depth_codes` is there when depths are stored as codes.
#[derive(Debug, Serialize)]
pub(super) struct Answer {
    size: [u32; 2],
    color: Base64,
    depth: Base64,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_codes: Option<Base64>,
    stencil: Base64,
    stats: Box<Stats>,
}

/// Bytes that go over the wire as base64.
#[derive(Debug)]
struct Base64(Vec<u8>);

impl Serialize for Base64 {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(&STANDARD.encode(&self.0))
    }
}

pub(super) fn answer(request: &Request) -> Result<Answer, Refusal> {
    let skips = skips(request)?;
    request.arithmetic_of(&[Arithmetic::Exact])?;
    let scene = scene(request)?;
    if let Some(message) = pipeline::out_of_range(&scene) {
        return Err(Refusal::new("overflow", message));
    }
    let mut pipeline = Pipeline::default();
    let names = ("bounding", "unknown-bounding");
    pipeline.bounding = request.choice(names, &Bounding::ALL, Bounding::name, &[])?.unwrap_or_default();
    pipeline.update(&scene, &skips);
    let Frame { size, color, depth, depth_codes, stencil, stats } = pipeline.into_frame();
    Ok(Answer {
        size,
        color: Base64(color),
        depth: Base64(depth.into_iter().flat_map(f32::to_le_bytes).collect()),
        depth_codes: depth_codes.map(|codes| Base64(codes.into_iter().flat_map(u32::to_le_bytes).collect())),
        stencil: Base64(stencil),
        stats: Box::new(stats),
    })
}

/// The scene of the request with its models loaded.
pub(super) fn scene(request: &Request) -> Result<Scene, Refusal> {
    let refuse = |error: SceneError| {
        let code = if matches!(error, SceneError::Unreadable { .. }) { "missing-model" } else { "bad-scene" };
        Refusal::new(code, error.message())
    };
    let scene = Scene::from_value(request.required("scene")?.value.clone()).map_err(refuse)?;
    scene.resolve(&mut |file| load_model(file, None)).map_err(refuse)
}

/// `"all"` (also if left out), `"none"` or a list of names.
fn skips(request: &Request) -> Result<Skips, Refusal> {
    let Some(field) = request.optional("skips") else { return Ok(Skips::ALL) };
    let unknown = |name: &str| {
        let known: Vec<_> = Skip::ALL.into_iter().map(Skip::name).collect();
        let message = Message::new("error-unknown-name").with("field", text("skips"));
        let message = message.with("name", text(super::request::shortened(name)));
        Refusal::new("unknown-skip", message.with("known", text(format!("all, none, {}", known.join(", ")))))
    };
    match field.value.as_str() {
        Some("all") => return Ok(Skips::ALL),
        Some("none") => return Ok(Skips::NONE),
        Some(name) => return Err(unknown(name)),
        None => {}
    }
    if !field.value.is_array() {
        return Err(field.bad("error-not-skips"));
    }
    let names = field.items()?.map(|item| item.text()).collect::<Result<Vec<_>, _>>()?;
    Skips::from_names(names).map_err(unknown)
}
