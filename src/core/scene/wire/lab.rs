//! The lab of a scene file: its name, the inputs of that lab's family, the step, and
//! what it is compared with.

use super::{
    super::{
        document::Lab,
        error::{Problem, shortened},
        path::FieldError,
        read::read,
    },
    compare::CompareWire,
};
use crate::{
    compare::{Choice, Setting},
    labs::{self, LabInput},
};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

/// Fields of every lab.
const COMMON: [&str; 4] = ["name", "algorithm", "step", "compare"];

/// A lab on its way in or out: which inputs it has, its name says.
pub(super) enum LabWire {
    Read(Value),
    Write(Lab),
}

impl<'a> Deserialize<'a> for LabWire {
    fn deserialize<D: Deserializer<'a>>(deserializer: D) -> Result<Self, D::Error> {
        Value::deserialize(deserializer).map(Self::Read)
    }
}

impl Serialize for LabWire {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        #[derive(Serialize)]
        struct Fields<'a> {
            name: &'static str,
            #[serde(flatten)]
            input: &'a LabInput,
            #[serde(skip_serializing_if = "Option::is_none")]
            step: Option<usize>,
            #[serde(skip_serializing_if = "Option::is_none")]
            compare: Option<Value>,
        }
        match self {
            Self::Read(value) => value.serialize(serializer),
            Self::Write(Lab { input, step, compare }) => {
                let compare = compare.map(wire);
                Fields { name: input.name(), input, step: *step, compare }.serialize(serializer)
            }
        }
    }
}

impl LabWire {
    pub(super) fn into_lab(self) -> Result<Lab, FieldError> {
        let value = match self {
            Self::Write(lab) => return Ok(lab),
            Self::Read(value) => value,
        };
        let mut fields: Map<String, Value> = read(&value)?;
        let mut take = |field: &'static str| fields.remove(field).filter(|value| !value.is_null());
        let [name, algorithm, step, compare] = COMMON.map(&mut take);

        let name = name.ok_or_else(|| FieldError::at("name", Problem::Missing))?;
        let name: String = read(&name).map_err(|e: FieldError| e.within("name"))?;
        let unknown = |field: &str, name: &str, known| {
            FieldError::at(field, Problem::UnknownName { name: shortened(name), known })
        };
        let lab = labs::find(&name)
            .ok_or_else(|| unknown("name", &name, labs::ALL.iter().map(|lab| lab.name).collect()))?;
        if let Some(algorithm) = algorithm {
            let algorithm: String = read(&algorithm).map_err(|e: FieldError| e.within("algorithm"))?;
            if algorithm != lab.name {
                return Err(unknown("algorithm", &algorithm, vec![lab.name]));
            }
        }
        let step = step.map(|step| read(&step)).transpose().map_err(|e: FieldError| e.within("step"))?;
        let input = lab.read(&Value::Object(fields)).map_err(|e| e.with_known(&COMMON))?;
        let setting = |compare: Value| match choice(&compare, &input)? {
            Some(choice) => Ok(Setting::Choice(choice)),
            None => read::<CompareWire>(&compare)?.into_setting(&input),
        };
        let compare = compare.map(setting).transpose().map_err(|e: FieldError| e.within("compare"))?;
        Ok(Lab { step, input, compare })
    }
}

/// A setting as the file has it: an object with one field.
fn wire(setting: Setting) -> Value {
    match setting {
        Setting::Choice(choice) => {
            Value::Object([(choice.field.to_owned(), choice.value())].into_iter().collect())
        }
        // A struct of names has no way to fail.
        other => serde_json::to_value(CompareWire::from(other)).unwrap_or(Value::Null),
    }
}

/// The choice of the lab's own inputs that stands there, if it is one.
fn choice(compare: &Value, input: &LabInput) -> Result<Option<Choice>, FieldError> {
    let fields: Vec<_> = compare.as_object().into_iter().flatten().collect();
    let [(field, value)] = fields[..] else { return Ok(None) };
    let all: Vec<_> = input.choices().into_iter().filter(|choice| choice.field == *field).collect();
    let Some(first) = all.first() else { return Ok(None) };
    let found = all.iter().find(|choice| choice.is(value));
    found.copied().map(Some).ok_or_else(|| {
        let known = all.iter().map(|choice| choice.json.trim_matches('"')).collect();
        FieldError::at(first.field, Problem::UnknownName { name: shortened(&value.to_string()), known })
    })
}

impl From<&Lab> for LabWire {
    fn from(lab: &Lab) -> Self {
        Self::Write(lab.clone())
    }
}
