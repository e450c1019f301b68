//! The setting in which side B differs: an object with one field.

use super::super::{
    error::{Problem, shortened},
    path::FieldError,
};
use crate::{
    compare::Setting,
    cull::{CullMode, FrontFace},
    depth::{CompareFunction, DepthFormat},
    labs::LabInput,
    math::Arithmetic,
    raster::{FillRule, YAxis},
    transform::DepthRange,
};
use serde::{Deserialize, Serialize};

/// All settings; which of them a lab has, the check of the whole scene says.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct CompareWire {
    #[serde(skip_serializing_if = "Option::is_none")]
    algorithm: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    arithmetic: Option<Arithmetic>,
    #[serde(skip_serializing_if = "Option::is_none")]
    fill_rule: Option<FillRule>,
    #[serde(skip_serializing_if = "Option::is_none")]
    y_axis: Option<YAxis>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_format: Option<DepthFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_compare: Option<CompareFunction>,
    #[serde(skip_serializing_if = "Option::is_none")]
    depth_range: Option<DepthRange>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reversed: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cull: Option<CullMode>,
    #[serde(skip_serializing_if = "Option::is_none")]
    front: Option<FrontFace>,
}

impl CompareWire {
    /// The one setting that stands here, for a lab with these inputs.
    pub(super) fn into_setting(self, input: &LabInput) -> Result<Setting, FieldError> {
        let algorithm = self.algorithm.map(|name| {
            let known = input.algorithms();
            let unknown = || Problem::UnknownName { name: shortened(&name), known: known.clone() };
            let found = known.iter().find(|known| **known == name);
            found.map(|name| Setting::Algorithm(name)).ok_or_else(|| FieldError::at("algorithm", unknown()))
        });
        let mut settings = [
            algorithm.transpose()?,
            self.arithmetic.map(Setting::Arithmetic),
            self.fill_rule.map(Setting::FillRule),
            self.y_axis.map(Setting::YAxis),
            self.depth_format.map(Setting::DepthFormat),
            self.depth_compare.map(Setting::DepthCompare),
            self.depth_range.map(Setting::DepthRange),
            self.reversed.map(Setting::Reversed),
            self.cull.map(Setting::Cull),
            self.front.map(Setting::Front),
        ]
        .into_iter()
        .flatten();
        match (settings.next(), settings.next()) {
            (Some(setting), None) => Ok(setting),
            (Some(first), Some(second)) => {
                Err(FieldError::at(second.field(), Problem::Both { other: first.field() }))
            }
            (None, _) => Err(FieldError::here(Problem::NoSetting)),
        }
    }
}

/// Choices of the lab's own inputs are written by the lab: here they have no field.
impl From<Setting> for CompareWire {
    fn from(setting: Setting) -> Self {
        let none = Self::default();
        match setting {
            Setting::Algorithm(name) => Self { algorithm: Some(name.to_owned()), ..none },
            Setting::Arithmetic(arithmetic) => Self { arithmetic: Some(arithmetic), ..none },
            Setting::FillRule(rule) => Self { fill_rule: Some(rule), ..none },
            Setting::YAxis(axis) => Self { y_axis: Some(axis), ..none },
            Setting::DepthFormat(format) => Self { depth_format: Some(format), ..none },
            Setting::DepthCompare(compare) => Self { depth_compare: Some(compare), ..none },
            Setting::DepthRange(range) => Self { depth_range: Some(range), ..none },
            Setting::Reversed(reversed) => Self { reversed: Some(reversed), ..none },
            Setting::Cull(cull) => Self { cull: Some(cull), ..none },
            Setting::Front(front) => Self { front: Some(front), ..none },
            Setting::Choice(_) => none,
        }
    }
}
