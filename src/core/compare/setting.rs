//! The one thing in which two sides differ.

use crate::{
    cull::{CullMode, FrontFace},
    depth::{CompareFunction, DepthFormat},
    math::Arithmetic,
    message::Value,
    raster::{FillRule, YAxis},
    scene::{Lab, LabInput, Scene},
    transform::DepthRange,
};

/// A setting with the value that it has on side B; the rest of B is as A has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Setting {
    /// Another algorithm of the same contract: the name of its lab.
    Algorithm(&'static str),
    /// What the lab computes in.
    Arithmetic(Arithmetic),
    /// Who draws a centre on an edge.
    FillRule(FillRule),
    /// Which way y grows on the screen.
    YAxis(YAxis),
    /// How depths are stored.
    DepthFormat(DepthFormat),
    /// What passes the depth test, for all draws.
    DepthCompare(CompareFunction),
    /// Which depths in NDC are visible.
    DepthRange(DepthRange),
    /// Whether the near plane has depth 1.
    Reversed(bool),
    /// Which facing is thrown away, for all draws.
    Cull(CullMode),
    /// Which turning sense is the front, for all draws.
    Front(FrontFace),
}

/// Everything that a scene's lab can be compared with: each alternative to what it has.
pub fn settings(scene: &Scene) -> Vec<Setting> {
    let other = |setting: &Setting| setting.of(scene) != Some(*setting);
    candidates(scene).into_iter().filter(other).collect()
}

/// Side B of a scene that compares; `None` if it does not.
pub fn side_b(scene: &Scene) -> Option<Scene> {
    let setting = scene.lab.as_ref()?.compare?;
    let mut other = scene.clone();
    setting.apply(&mut other);
    Some(other)
}

/// Every value of every setting that the open lab reads, its own included.
fn candidates(scene: &Scene) -> Vec<Setting> {
    let mut all = Vec::new();
    let Some(Lab { input, .. }) = &scene.lab else { return all };
    all.extend(input.algorithms().iter().map(|name| Setting::Algorithm(name)));
    if let LabInput::ClipLine { .. } = input {
        // Fixed point is for scan conversion.
        all.extend([Arithmetic::Exact, Arithmetic::F32, Arithmetic::F64].map(Setting::Arithmetic));
    }
    let scans = matches!(input, LabInput::Scanline { .. } | LabInput::ZBuffer { .. } | LabInput::Pipeline);
    let tests = matches!(input, LabInput::ZBuffer { .. } | LabInput::Pipeline);
    // A lab's own triangles know nothing of cameras, draws and facings.
    let own = matches!(
        input,
        LabInput::Scanline { vertices: Some(_), .. } | LabInput::ZBuffer { triangles: Some(_) }
    );
    let places = matches!(input, LabInput::Transform { .. }) || scans && !own;
    if scans {
        all.extend(FillRule::ALL.map(Setting::FillRule));
    }
    if tests {
        all.extend(DepthFormat::ALL.map(Setting::DepthFormat));
    }
    if tests && !own && !scene.draws.is_empty() {
        all.extend(CompareFunction::ALL.map(Setting::DepthCompare));
    }
    if places {
        all.extend([false, true].map(Setting::Reversed));
        all.extend(DepthRange::ALL.map(Setting::DepthRange));
    }
    if scans && !own && !scene.draws.is_empty() {
        all.extend(CullMode::ALL.map(Setting::Cull));
        all.extend(FrontFace::ALL.map(Setting::Front));
    }
    if scans || places {
        all.extend(YAxis::ALL.map(Setting::YAxis));
    }
    all
}

impl Setting {
    /// Whether the open lab reads this setting and can have this value.
    pub fn applies(self, scene: &Scene) -> bool {
        candidates(scene).contains(&self)
    }

    /// The same setting as the scene has it: the value of side A.
    ///
    /// `None` if the scene has none: no lab, or no draws. Draws that disagree count as the first.
    pub fn of(self, scene: &Scene) -> Option<Self> {
        let input = &scene.lab.as_ref()?.input;
        Some(match self {
            Self::Algorithm(_) => Self::Algorithm(input.name()),
            Self::Arithmetic(_) => match input {
                LabInput::ClipLine { arithmetic, .. } => Self::Arithmetic(*arithmetic),
                _ => return None,
            },
            Self::FillRule(_) => Self::FillRule(scene.fill_rule),
            Self::YAxis(_) => Self::YAxis(scene.y_axis),
            Self::DepthFormat(_) => Self::DepthFormat(scene.depth_format),
            Self::DepthCompare(_) => Self::DepthCompare(scene.draws.first()?.depth.compare),
            Self::DepthRange(_) => Self::DepthRange(scene.depth_range),
            Self::Reversed(_) => Self::Reversed(scene.reversed),
            Self::Cull(_) => Self::Cull(scene.draws.first()?.cull),
            Self::Front(_) => Self::Front(scene.draws.first()?.front),
        })
    }

    /// Makes side B's scene from side A's. The scene no longer compares then; one that the setting
    /// does not apply to stays as it is otherwise.
    pub fn apply(self, scene: &mut Scene) {
        if let Some(Lab { input, compare, .. }) = &mut scene.lab {
            *compare = None;
            match (self, input) {
                (Self::Algorithm(name), input) => input.set_algorithm(name),
                (Self::Arithmetic(value), LabInput::ClipLine { arithmetic, .. }) => *arithmetic = value,
                _ => {}
            }
        }
        match self {
            Self::Algorithm(_) | Self::Arithmetic(_) => {}
            Self::FillRule(rule) => scene.fill_rule = rule,
            Self::YAxis(axis) => scene.y_axis = axis,
            Self::DepthFormat(format) => scene.depth_format = format,
            Self::DepthCompare(compare) => {
                scene.draws.iter_mut().for_each(|draw| draw.depth.compare = compare)
            }
            Self::DepthRange(range) => scene.depth_range = range,
            Self::Reversed(reversed) => scene.reversed = reversed,
            Self::Cull(cull) => scene.draws.iter_mut().for_each(|draw| draw.cull = cull),
            Self::Front(front) => scene.draws.iter_mut().for_each(|draw| draw.front = front),
        }
    }

    /// Message id of what differs.
    pub fn word(self) -> &'static str {
        match self {
            Self::Algorithm(_) => "compare-algorithm",
            Self::Arithmetic(_) => "compare-arithmetic",
            Self::FillRule(_) => "compare-fill-rule",
            Self::YAxis(_) => "compare-y-axis",
            Self::DepthFormat(_) => "compare-depth-format",
            Self::DepthCompare(_) => "compare-depth-compare",
            Self::DepthRange(_) => "compare-depth-range",
            Self::Reversed(_) => "compare-reversed",
            Self::Cull(_) => "compare-cull",
            Self::Front(_) => "compare-front",
        }
    }

    /// Its value, in words.
    pub fn value(self) -> Value {
        match self {
            Self::Algorithm(name) => Value::Word(name),
            Self::Arithmetic(arithmetic) => Value::Word(arithmetic.word()),
            Self::FillRule(rule) => Value::Word(rule.word()),
            Self::YAxis(axis) => Value::Word(axis.word()),
            Self::DepthFormat(format) => Value::text(format.name()),
            Self::DepthCompare(compare) => Value::text(compare.name()),
            Self::DepthRange(range) => Value::Word(range.word()),
            Self::Reversed(false) => Value::Word("compare-not-reversed"),
            Self::Reversed(true) => Value::Word("compare-is-reversed"),
            Self::Cull(cull) => Value::Word(cull.word()),
            Self::Front(front) => Value::Word(front.word()),
        }
    }

    /// The field of the scene file that keeps it.
    pub fn field(self) -> &'static str {
        match self {
            Self::Algorithm(_) => "algorithm",
            Self::Arithmetic(_) => "arithmetic",
            Self::FillRule(_) => "fill_rule",
            Self::YAxis(_) => "y_axis",
            Self::DepthFormat(_) => "depth_format",
            Self::DepthCompare(_) => "depth_compare",
            Self::DepthRange(_) => "depth_range",
            Self::Reversed(_) => "reversed",
            Self::Cull(_) => "cull",
            Self::Front(_) => "front",
        }
    }

    /// The names of all fields of settings that the open lab reads.
    pub fn fields(scene: &Scene) -> Vec<&'static str> {
        let mut fields: Vec<_> = candidates(scene).into_iter().map(Self::field).collect();
        fields.dedup();
        fields
    }
}
