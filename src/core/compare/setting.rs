//! The one thing in which two sides differ.

use super::Choice;
use crate::{
    cull::{CullMode, FrontFace},
    depth::{CompareFunction, DepthFormat},
    math::Arithmetic,
    message::Value,
    raster::{FillRule, YAxis},
    scene::{Lab, Scene},
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
    /// An input of the lab that is a choice among a few values.
    Choice(Choice),
}

/// Everything that a scene's lab can be compared with: each alternative to what it has.
pub fn settings(scene: &Scene) -> Vec<Setting> {
    let other = |setting: &Setting| setting.of(scene) != Some(*setting);
    candidates(scene).into_iter().filter(other).collect()
}

/// Side B of a scene that compares; `None` if it does not.
pub fn side_b(scene: &Scene) -> Option<Scene> {
    let setting = scene.compared()?;
    let mut other = scene.clone();
    setting.apply(&mut other);
    Some(other)
}

/// Every value of every setting that the open lab reads and can have, its own included.
fn candidates(scene: &Scene) -> Vec<Setting> {
    let Some(Lab { input, .. }) = &scene.lab else { return Vec::new() };
    let algorithms = input.algorithms();
    let siblings = algorithms.iter().filter(|_| algorithms.len() > 1);
    let all = siblings.map(|name| Setting::Algorithm(name)).chain(input.settings(scene));
    // An algorithm may lack the arithmetic or the mistake that its sibling has: then more would differ.
    let possible = |setting: &Setting| {
        let mut other = scene.clone();
        setting.apply(&mut other);
        let checked = other.lab.as_ref().is_some_and(|lab| lab.input.check(&other).is_ok());
        setting.restore(&mut other, scene);
        checked && other == *scene
    };
    all.filter(possible).collect()
}

impl Setting {
    /// What a rasterizer of given vertices reads.
    pub(crate) fn of_scan() -> Vec<Self> {
        FillRule::ALL.map(Self::FillRule).into_iter().chain(YAxis::ALL.map(Self::YAxis)).collect()
    }

    /// What the way of a vertex to the screen reads.
    pub(crate) fn of_transform() -> Vec<Self> {
        [false, true].map(Self::Reversed).into_iter().chain(DepthRange::ALL.map(Self::DepthRange)).collect()
    }

    /// What decides which triangles of a scene are drawn; nothing if there are none.
    pub(crate) fn of_facing(scene: &Scene) -> Vec<Self> {
        let facing = CullMode::ALL.map(Self::Cull).into_iter().chain(FrontFace::ALL.map(Self::Front));
        facing.filter(|_| !scene.draws.is_empty()).collect()
    }

    /// What the depth test of a scene reads.
    pub(crate) fn of_depth(scene: &Scene) -> Vec<Self> {
        let compares = CompareFunction::ALL.map(Self::DepthCompare).into_iter();
        let compares = compares.filter(|_| !scene.draws.is_empty());
        DepthFormat::ALL.map(Self::DepthFormat).into_iter().chain(compares).collect()
    }

    /// Whether the open lab reads this setting and can have this value.
    pub fn applies(self, scene: &Scene) -> bool {
        candidates(scene).contains(&self)
    }

    /// The same setting as the scene has it: the value of side A.
    ///
    /// `None` if the scene has none: no lab, or no draws. Draws that disagree count as the first.
    pub fn of(self, scene: &Scene) -> Option<Self> {
        Some(match self {
            Self::FillRule(_) => Self::FillRule(scene.fill_rule),
            Self::YAxis(_) => Self::YAxis(scene.y_axis),
            Self::DepthFormat(_) => Self::DepthFormat(scene.depth_format),
            Self::DepthCompare(_) => Self::DepthCompare(scene.draws.first()?.depth.compare),
            Self::DepthRange(_) => Self::DepthRange(scene.depth_range),
            Self::Reversed(_) => Self::Reversed(scene.reversed),
            Self::Cull(_) => Self::Cull(scene.draws.first()?.cull),
            Self::Front(_) => Self::Front(scene.draws.first()?.front),
            Self::Algorithm(_) | Self::Arithmetic(_) | Self::Choice(_) => {
                return scene.lab.as_ref()?.input.setting(self);
            }
        })
    }

    /// Makes side B's scene from side A's; it no longer compares then. What the lab does not read
    /// changes nothing that it shows.
    pub fn apply(self, scene: &mut Scene) {
        if let Some(Lab { input, compare, .. }) = &mut scene.lab {
            *compare = None;
            input.set(self);
        }
        let draws = scene.draws.iter_mut();
        match self {
            Self::FillRule(rule) => scene.fill_rule = rule,
            Self::YAxis(axis) => scene.y_axis = axis,
            Self::DepthFormat(format) => scene.depth_format = format,
            Self::DepthCompare(compare) => draws.for_each(|draw| draw.depth.compare = compare),
            Self::DepthRange(range) => scene.depth_range = range,
            Self::Reversed(reversed) => scene.reversed = reversed,
            Self::Cull(cull) => draws.for_each(|draw| draw.cull = cull),
            Self::Front(front) => draws.for_each(|draw| draw.front = front),
            // Inputs of the lab.
            Self::Algorithm(_) | Self::Arithmetic(_) | Self::Choice(_) => {}
        }
    }

    /// Takes back what [`apply`](Self::apply) changed: `scene` has the values of `original` again, from
    /// which it was made. What was edited besides stays.
    pub fn restore(self, scene: &mut Scene, original: &Scene) {
        if let (Some(lab), Some(old)) = (&mut scene.lab, &original.lab) {
            lab.compare = old.compare;
            if let Some(own) = old.input.setting(self) {
                lab.input.set(own);
            }
        }
        for (draw, old) in scene.draws.iter_mut().zip(&original.draws) {
            match self {
                Self::DepthCompare(_) => draw.depth.compare = old.depth.compare,
                Self::Cull(_) => draw.cull = old.cull,
                Self::Front(_) => draw.front = old.front,
                _ => {}
            }
        }
        match self {
            Self::FillRule(_) => scene.fill_rule = original.fill_rule,
            Self::YAxis(_) => scene.y_axis = original.y_axis,
            Self::DepthFormat(_) => scene.depth_format = original.depth_format,
            Self::DepthRange(_) => scene.depth_range = original.depth_range,
            Self::Reversed(_) => scene.reversed = original.reversed,
            _ => {}
        }
    }

    /// Every value that this setting can have in the open lab, its own included.
    pub fn values(self, scene: &Scene) -> Vec<Self> {
        candidates(scene).into_iter().filter(|other| other.field() == self.field()).collect()
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
            Self::Choice(choice) => choice.heading,
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
            Self::Choice(choice) => Value::Word(choice.word),
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
            Self::Choice(choice) => choice.field,
        }
    }

    /// Its value as the scene file names it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Algorithm(name) => name,
            Self::Arithmetic(arithmetic) => arithmetic.name(),
            Self::FillRule(rule) => rule.name(),
            Self::YAxis(axis) => axis.name(),
            Self::DepthFormat(format) => format.name(),
            Self::DepthCompare(compare) => compare.name(),
            Self::DepthRange(range) => range.name(),
            Self::Reversed(reversed) => ["false", "true"][usize::from(reversed)],
            Self::Cull(cull) => cull.name(),
            Self::Front(front) => front.name(),
            Self::Choice(choice) => choice.json,
        }
    }

    /// What could stand in its place: the values of its field, none if the lab does not read it,
    /// and the fields that the lab reads.
    pub(crate) fn known(self, scene: &Scene) -> (Vec<&'static str>, Vec<&'static str>) {
        let all = candidates(scene);
        let values = all.iter().filter(|other| other.field() == self.field()).map(|other| other.name());
        let mut fields: Vec<_> = all.iter().map(|other| other.field()).collect();
        fields.dedup();
        (values.collect(), fields)
    }
}
