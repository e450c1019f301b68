//! The lab of a scene file: a name, and the inputs that this lab has.

use super::{
    super::{
        document::{Lab, LabInput},
        error::{Problem, shortened},
        path::FieldError,
    },
    compare::CompareWire,
};
use crate::{clip::line::Algorithm, math::Arithmetic};
use serde::{Deserialize, Serialize};

/// All fields of all labs; which of them belong together, the name says.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct LabWire {
    name: LabName,
    #[serde(skip_serializing_if = "Option::is_none")]
    algorithm: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    window: Option<[f32; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    segment: Option<[f32; 4]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    arithmetic: Option<Arithmetic>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<[[f32; 2]; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    triangle: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    triangles: Option<Vec<[[f32; 3]; 3]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    draw: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertex: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    step: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    compare: Option<CompareWire>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum LabName {
    CohenSutherland,
    LiangBarsky,
    Scanline,
    ZBuffer,
    Transform,
    Pipeline,
}

/// The inputs of every lab that clips a line.
const LINE: &[&str] = &["window", "segment", "arithmetic"];

impl LabName {
    /// The lab's own algorithm, and the inputs that it has beside those of all labs.
    fn contract(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::CohenSutherland => ("cohen-sutherland", LINE),
            Self::LiangBarsky => ("liang-barsky", LINE),
            Self::Scanline => ("scanline", &["vertices", "triangle"]),
            Self::ZBuffer => ("z-buffer", &["triangles"]),
            Self::Transform => ("transform", &["draw", "vertex"]),
            Self::Pipeline => ("pipeline", &[]),
        }
    }
}

impl LabWire {
    fn named(name: LabName, step: Option<usize>) -> Self {
        Self {
            name,
            algorithm: None,
            window: None,
            segment: None,
            arithmetic: None,
            vertices: None,
            triangle: None,
            triangles: None,
            draw: None,
            vertex: None,
            step,
            compare: None,
        }
    }

    /// Refuses inputs of other labs, and algorithms that the lab does not have.
    fn check(&self) -> Result<(), FieldError> {
        let (algorithm, inputs) = self.name.contract();
        let there = [
            ("window", self.window.is_some()),
            ("segment", self.segment.is_some()),
            ("arithmetic", self.arithmetic.is_some()),
            ("vertices", self.vertices.is_some()),
            ("triangle", self.triangle.is_some()),
            ("triangles", self.triangles.is_some()),
            ("draw", self.draw.is_some()),
            ("vertex", self.vertex.is_some()),
        ];
        if let Some((field, _)) = there.into_iter().find(|(field, there)| *there && !inputs.contains(field)) {
            let known = ["name", "algorithm", "step", "compare"].iter().chain(inputs).copied().collect();
            return Err(FieldError::at(field, Problem::UnknownField { known }));
        }
        match &self.algorithm {
            Some(name) if name != algorithm => {
                let known = vec![algorithm];
                Err(FieldError::at("algorithm", Problem::UnknownName { name: shortened(name), known }))
            }
            _ => Ok(()),
        }
    }

    fn clip_line(&self, algorithm: Algorithm) -> Result<LabInput, FieldError> {
        let missing = |field| FieldError::at(field, Problem::Missing);
        Ok(LabInput::ClipLine {
            algorithm,
            window: self.window.ok_or_else(|| missing("window"))?,
            segment: self.segment.ok_or_else(|| missing("segment"))?,
            arithmetic: self.arithmetic.unwrap_or_default(),
        })
    }

    pub(super) fn into_lab(mut self) -> Result<Lab, FieldError> {
        self.check()?;
        let input = match self.name {
            LabName::CohenSutherland => self.clip_line(Algorithm::CohenSutherland)?,
            LabName::LiangBarsky => self.clip_line(Algorithm::LiangBarsky)?,
            LabName::Scanline => {
                LabInput::Scanline { vertices: self.vertices, triangle: self.triangle.unwrap_or_default() }
            }
            LabName::ZBuffer => LabInput::ZBuffer { triangles: self.triangles },
            LabName::Transform => LabInput::Transform {
                draw: self.draw.unwrap_or_default(),
                vertex: self.vertex.unwrap_or_default(),
            },
            LabName::Pipeline => LabInput::Pipeline,
        };
        let compare = self.compare.take().map(|compare| compare.into_setting(&input)).transpose();
        Ok(Lab { step: self.step, compare: compare.map_err(|e| e.within("compare"))?, input })
    }
}

impl From<&Lab> for LabWire {
    fn from(lab: &Lab) -> Self {
        let mut wire = Self::of_input(lab);
        wire.compare = lab.compare.map(CompareWire::from);
        wire
    }
}

impl LabWire {
    fn of_input(lab: &Lab) -> Self {
        match &lab.input {
            LabInput::ClipLine { algorithm, window, segment, arithmetic } => {
                let name = match algorithm {
                    Algorithm::CohenSutherland => LabName::CohenSutherland,
                    Algorithm::LiangBarsky => LabName::LiangBarsky,
                };
                Self {
                    window: Some(*window),
                    segment: Some(*segment),
                    arithmetic: Some(*arithmetic),
                    ..Self::named(name, lab.step)
                }
            }
            LabInput::Scanline { vertices, triangle } => Self {
                vertices: *vertices,
                triangle: (*triangle > 0).then_some(*triangle),
                ..Self::named(LabName::Scanline, lab.step)
            },
            LabInput::ZBuffer { triangles } => {
                Self { triangles: triangles.clone(), ..Self::named(LabName::ZBuffer, lab.step) }
            }
            LabInput::Transform { draw, vertex } => {
                Self { draw: Some(*draw), vertex: Some(*vertex), ..Self::named(LabName::Transform, lab.step) }
            }
            LabInput::Pipeline => Self::named(LabName::Pipeline, lab.step),
        }
    }
}
