//! The lab that drives an operation to where arithmetic breaks.

use super::{Family, LabInput};
use crate::{
    compare::Setting,
    math::Arithmetic,
    message::Message,
    replay::{Budget, Playback},
    scene::{Checked, Problem, Scene, refuse_if},
    stress::{
        self,
        dial::{MOST, Operation},
        trial::{self, ROUNDED, Subject},
    },
};
use serde::{Deserialize, Serialize};

/// Cases of a family, more or less extreme.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Stress {
    /// What is put under stress.
    #[serde(default)]
    pub operation: Operation,
    /// What its cases are driven to.
    #[serde(default = "beside")]
    pub family: stress::Family,
    /// How far, 0 to 10.
    #[serde(default = "far")]
    pub dial: u8,
    /// What is drawn, and whose first broken case is made small; not the exact one.
    #[serde(default = "taught")]
    pub arithmetic: Arithmetic,
    /// Whether that is done.
    #[serde(default)]
    pub shrink: bool,
}

fn beside() -> stress::Family {
    stress::Family::Beside
}

fn far() -> u8 {
    8
}

fn taught() -> Arithmetic {
    Arithmetic::F32
}

impl Stress {
    /// What is run in a scene.
    pub fn subject(&self, scene: &Scene) -> Subject {
        let Self { operation, family, dial, arithmetic, shrink } = *self;
        let scene = Scene { draws: Vec::new(), lab: None, ..scene.clone() };
        Subject { operation, family, dial, arithmetic, shrink, scene }
    }

    /// The first broken case made small, as an input of the lab that teaches the operation; `None` if no case
    /// breaks.
    pub fn shrunk(&self, scene: &Scene) -> Option<LabInput> {
        let subject = self.subject(scene);
        let case = subject.shrunk()?;
        subject.opened(&case, self.arithmetic).lab.map(|lab| lab.input)
    }
}

impl Family for Stress {
    fn first() -> Self {
        let (family, dial, arithmetic) = (beside(), far(), taught());
        Self { operation: Operation::default(), family, dial, arithmetic, shrink: false }
    }

    fn name(&self) -> &'static str {
        "stress"
    }

    fn is_of_scene(&self) -> bool {
        false
    }

    fn check(&self, scene: &Scene) -> Checked {
        let range = Problem::Range { min: 0.0, max: f64::from(MOST) };
        refuse_if(self.dial > MOST, "dial", range)?;
        let unknown =
            |name: &str, known: Vec<&'static str>| Problem::UnknownName { name: name.into(), known };
        let families = self.operation.families();
        let problem = unknown(self.family.name(), families.iter().map(|family| family.name()).collect());
        refuse_if(!families.contains(&self.family), "family", problem)?;
        let known: Vec<_> = self.subject(scene).rounded().collect();
        let problem = unknown(self.arithmetic.name(), known.iter().map(|each| each.name()).collect());
        refuse_if(!known.contains(&self.arithmetic), "arithmetic", problem)
    }

    fn play(&self, scene: &Scene, budget: Budget) -> Result<Box<dyn Playback>, Message> {
        super::refuse_large(scene)?;
        Ok(Box::new(trial::play(self.subject(scene), budget)))
    }

    fn settings(&self, _: &Scene) -> Vec<Setting> {
        ROUNDED.map(Setting::Arithmetic).to_vec()
    }

    fn setting(&self, like: Setting) -> Option<Setting> {
        matches!(like, Setting::Arithmetic(_)).then_some(Setting::Arithmetic(self.arithmetic))
    }

    fn set(&mut self, setting: Setting) {
        if let Setting::Arithmetic(arithmetic) = setting {
            self.arithmetic = arithmetic;
        }
    }
}
