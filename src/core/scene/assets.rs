//! The presets and models that are part of the program.

/// A scene file that is part of the program: a special case, and one sentence why it matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its name on the command line; the words for it are the messages `preset-NAME-name` and
    /// `preset-NAME`.
    pub name: &'static str,
    /// The scene file.
    pub json: &'static str,
}

macro_rules! presets {
    ($($name:literal)*) => {
        &[$(Preset { name: $name, json: include_str!(concat!("../../../assets/scenes/", $name, ".json")) }),*]
    };
}

macro_rules! models {
    ($($file:literal)*) => {
        &[$(($file, include_bytes!(concat!("../../../assets/models/", $file)))),*]
    };
}

/// All presets, in the order in which they are shown: scenes first, the default one at the
/// beginning, then lab by lab.
pub const PRESETS: &[Preset] = presets! {
    "two-through-each-other"
    "acceptance-square"
    "shared-edges-through-centres"
    "near-plane"
    "behind-the-eye"
    "sliver"
    "zero-area"
    "edge-on"
    "mirrored"
    "off-screen-huge"
    "cyclic-overlap"
    "z-fighting"
    "reversed-depth"
    "checkered-square"
    "order-of-blending"
    "stencil-mask"
    "outline"
    "tetrahedron"
    "cube"
    "pawn"
    "trefoil"
    "spheres"
    "two-sides-tie"
    "two-sides-depth-bits"
    "point-in-a-region"
    "point-inside"
    "point-beyond-two"
    "point-on-a-border"
    "point-on-a-corner"
    "point-one-step-outside"
    "line-three-cuts"
    "line-inside"
    "line-same-side"
    "line-looks-hidden"
    "line-passes-by"
    "line-touches-a-corner"
    "line-along-a-border"
    "line-or-for-and"
    "line-crack"
    "two-sides-corner"
    "two-sides-rounding"
    "order-kept"
    "order-rejected"
    "order-reversed"
    "order-parallel"
    "order-parallel-outside"
    "order-one-cut"
    "order-inside"
    "plane-two-in"
    "plane-one-in"
    "plane-three-in"
    "plane-none-in"
    "plane-vertex-on-it"
    "plane-slanted"
    "plane-near"
    "convex-pentagon"
    "convex-rectangle"
    "convex-clockwise"
    "convex-just-missed"
    "convex-along-an-edge"
    "convex-through-a-corner"
    "convex-inside"
    "halve-corner-to-corner"
    "halve-one-end"
    "halve-hits-a-border"
    "halve-until-rejected"
    "halve-touches-a-corner"
    "halve-misses-a-corner"
    "halve-inside"
    "regions-from-a-corner"
    "regions-from-an-edge"
    "regions-from-inside"
    "regions-just-missed"
    "regions-through-a-corner"
    "regions-same-side"
    "clip-behind-and-right"
    "clip-one-in"
    "clip-two-in"
    "clip-near-plane"
    "clip-divide-first"
    "clip-w-zero"
    "clip-no-near"
    "clip-frustum-corner"
    "clip-guard-band"
    "clip-crack"
    "clip-no-attributes"
    "clip-camera-space"
    "clip-many-planes"
    "polygon-triangle"
    "polygon-e-shape"
    "polygon-star"
    "polygon-around"
    "polygon-edge-on-border"
    "polygon-touches-a-corner"
    "polygon-crack"
    "polygon-two-sides"
    "two-sides-mistake"
    "pieces-convex"
    "pieces-three"
    "pieces-holes"
    "pieces-star"
    "pieces-touching"
    "pieces-around"
    "span-left-tie"
    "span-apex-on-a-row"
    "span-shared-diagonal"
    "span-needle"
    "span-flat-top"
    "span-flat-bottom"
    "fill-star"
    "fill-star-non-zero"
    "fill-ring"
    "fill-ring-same-way"
    "fill-comb"
    "fill-on-centres"
    "fill-crossing"
    "fill-sliver"
    "depth-two-triangles"
    "depth-equal"
    "depth-through"
    "depth-behind"
    "depth-order"
    "vertex-perspective"
    "vertex-orthographic"
    "vertex-behind-the-eye"
    "vertex-minus-one-to-one"
    "vertex-rotated-model"
    "facing-front"
    "facing-closed-surface"
    "facing-mirrored"
    "facing-behind-the-eye"
    "facing-edge-on"
    "facing-collinear"
    "facing-rounded"
    "frustum-beside"
    "frustum-straddles"
    "frustum-long-object"
    "frustum-corner"
    "frustum-all-inside"
    "frustum-behind-the-eye"
    "tree-of-eight"
    "tree-of-a-hundred"
    "tree-of-clusters"
    "tree-of-triangles"
    "tree-all-outside"
    "tree-all-inside"
    "two-sides-depth-range"
};

/// All models, by the file name that scenes use. Of our own making: see
/// `examples/make_models.rs`.
pub const MODELS: &[(&str, &[u8])] = models! {
    "cube.obj"
    "tetrahedron.obj"
    "icosphere.obj"
    "pawn.obj"
    "trefoil.obj"
};

/// The preset called `name`.
pub fn preset(name: &str) -> Option<&'static Preset> {
    PRESETS.iter().find(|preset| preset.name == name)
}

/// The bytes of the model called `name`.
pub fn model(name: &str) -> Option<&'static [u8]> {
    MODELS.iter().find(|(file, _)| *file == name).map(|(_, bytes)| *bytes)
}
