//! Reading a request: JSON first, then field by field, so that an error names the bad field.

use rasterscope_core::{
    clip::line::{Point, Window},
    math::Arithmetic,
    message::Message,
    scene::{JsonError, JsonFault},
};
use serde_json::{Map, Value};

use super::refusal::{Refusal, text};

/// The fields of one request. Fields that an operation does not know are ignored.
#[derive(Clone, Debug)]
pub(crate) struct Request(Map<String, Value>);

impl Request {
    /// Reads one JSON object. A byte order mark and white space around it are allowed.
    pub(crate) fn parse(bytes: &[u8]) -> Result<Self, Refusal> {
        let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let json = std::str::from_utf8(bytes).map_err(|error| {
            let message = Message::new("error-not-utf8").with("byte", error.valid_up_to());
            Refusal::new("not-utf8", message)
        })?;
        if json.trim().is_empty() {
            return Err(Refusal::new("malformed", Message::new("error-empty-request")));
        }
        match serde_json::from_str(json) {
            Ok(Value::Object(fields)) => Ok(Self(fields)),
            Ok(_) => Err(Refusal::new("malformed", Message::new("error-not-an-object"))),
            Err(error) => Err(not_json(json, &error)),
        }
    }

    /// A field that may be left out.
    pub(crate) fn optional(&self, name: &'static str) -> Option<Field<'_>> {
        Some(Field { value: self.0.get(name)?, path: name.to_owned() })
    }

    /// A field that must be there.
    pub(crate) fn required(&self, name: &'static str) -> Result<Field<'_>, Refusal> {
        self.optional(name).ok_or_else(|| {
            let message = Message::new("error-missing-field").with("field", text(name));
            Refusal::new("missing-field", message)
        })
    }

    /// One of `all` by its name, or the first of them if the field is left out. `later` are
    /// names of the interface that come in a later version.
    pub(crate) fn choice<T: Copy>(
        &self,
        (field, unknown): (&'static str, &'static str),
        all: &[T],
        name: impl Fn(T) -> &'static str,
        later: &[&str],
    ) -> Result<Option<T>, Refusal> {
        let Some(given) = self.optional(field) else { return Ok(None) };
        let given = given.text()?;
        if let Some(found) = all.iter().copied().find(|&choice| name(choice) == given) {
            return Ok(Some(found));
        }
        if later.contains(&given) {
            return Err(Refusal::unsupported(field, given));
        }
        let known: Vec<_> = all.iter().map(|&choice| name(choice)).collect();
        let message = Message::new("error-unknown-name")
            .with("field", text(field))
            .with("name", text(shortened(given)))
            .with("known", text(known.join(", ")));
        Err(Refusal::new(unknown, message))
    }

    /// What to compute in; exact if the field is left out.
    pub(crate) fn arithmetic(&self) -> Result<Arithmetic, Refusal> {
        let names = ("arithmetic", "unknown-arithmetic");
        Ok(self.choice(names, &Arithmetic::ALL, Arithmetic::name, &[])?.unwrap_or_default())
    }

    /// The same, of an operation that has only `these` arithmetics.
    pub(crate) fn arithmetic_of(&self, these: &[Arithmetic]) -> Result<Arithmetic, Refusal> {
        let arithmetic = self.arithmetic()?;
        if these.contains(&arithmetic) {
            Ok(arithmetic)
        } else {
            Err(Refusal::unsupported("arithmetic", arithmetic.name()))
        }
    }

    /// Width and height of an image: each in 1..=16384, together at most 2^28 pixels.
    pub(crate) fn size(&self) -> Result<[u32; 2], Refusal> {
        let field = self.required("size")?;
        let bad = || Refusal::new("bad-size", Message::new("error-bad-size").with("field", text("size")));
        let mut size = [0; 2];
        for (side, given) in size.iter_mut().zip(field.list::<2>()?) {
            let number = given.value.as_f64().ok_or_else(|| given.bad("error-not-a-number"))?;
            if number.fract() != 0.0 || !(1.0..=16384.0).contains(&number) {
                return Err(bad());
            }
            *side = number as u32;
        }
        if u64::from(size[0]) * u64::from(size[1]) > 1 << 28 { Err(bad()) } else { Ok(size) }
    }

    /// A window, whose maxima are not below its minima.
    pub(crate) fn window(&self) -> Result<Window, Refusal> {
        Window::new(self.required("window")?.numbers()?).ok_or_else(|| {
            let message = Message::new("error-empty-window").with("field", text("window"));
            Refusal::new("bad-window", message)
        })
    }

    /// The corners of a polygon: at least three.
    pub(crate) fn polygon(&self, name: &'static str) -> Result<Vec<Point>, Refusal> {
        self.required(name)?.polygon()
    }

    /// The corners of a triangle, `N` numbers each.
    pub(crate) fn vertices<const N: usize>(&self) -> Result<[[f32; N]; 3], Refusal> {
        let mut out = [[0.0; N]; 3];
        for (vertex, given) in out.iter_mut().zip(self.required("vertices")?.list::<3>()?) {
            *vertex = given.numbers()?;
        }
        Ok(out)
    }
}

/// One value of a request and where it stands, such as `vertices[2][0]`.
#[derive(Clone, Debug)]
pub(crate) struct Field<'a> {
    pub(crate) value: &'a Value,
    path: String,
}

impl<'a> Field<'a> {
    /// The value is not what it must be.
    pub(crate) fn bad(&self, id: &'static str) -> Refusal {
        Refusal::new("bad-field", Message::new(id).with("field", text(&self.path)))
    }

    /// A name.
    pub(crate) fn text(&self) -> Result<&'a str, Refusal> {
        self.value.as_str().ok_or_else(|| self.bad("error-not-a-text"))
    }

    /// A list of any length.
    pub(crate) fn items(&self) -> Result<impl Iterator<Item = Self> + use<'a, '_>, Refusal> {
        let values = self.value.as_array().ok_or_else(|| self.bad("error-not-a-list"))?;
        let item = |(i, value)| Self { value, path: format!("{}[{i}]", self.path) };
        Ok(values.iter().enumerate().map(item))
    }

    /// A list of exactly `N` values.
    pub(crate) fn list<const N: usize>(&self) -> Result<[Self; N], Refusal> {
        let count = self.value.as_array().map_or(0, Vec::len);
        if self.value.is_array() && count != N {
            let message = Message::new("error-list-length").with("field", text(&self.path));
            return Err(Refusal::new("bad-field", message.with("wanted", N).with("count", count)));
        }
        let items: Vec<_> = self.items()?.collect();
        items.try_into().map_err(|_| self.bad("error-not-a-list"))
    }

    /// `N` coordinates.
    pub(crate) fn numbers<const N: usize>(&self) -> Result<[f32; N], Refusal> {
        let mut out = [0.0; N];
        for (number, given) in out.iter_mut().zip(self.list::<N>()?) {
            *number = given.number()?;
        }
        Ok(out)
    }

    /// The corners of a polygon: at least three.
    pub(crate) fn polygon(&self) -> Result<Vec<Point>, Refusal> {
        let corners = self.items()?.map(|corner| corner.numbers()).collect::<Result<Vec<Point>, _>>()?;
        if corners.len() >= 3 {
            return Ok(corners);
        }
        let message = Message::new("error-too-few-corners").with("field", text(&self.path));
        Err(Refusal::new("bad-field", message.with("count", corners.len())))
    }

    /// A coordinate: rounded to binary32, finite.
    pub(crate) fn number(&self) -> Result<f32, Refusal> {
        let number = self.value.as_f64().ok_or_else(|| self.bad("error-not-a-number"))? as f32;
        if number.is_finite() {
            return Ok(number);
        }
        Err(Refusal::new("not-finite", Message::new("error-too-large").with("field", text(&self.path))))
    }
}

/// The start of a user's text: enough to recognise it in a sentence.
pub(super) fn shortened(name: &str) -> String {
    const MOST: usize = 40;
    match name.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}…", &name[..end]),
        None => name.to_owned(),
    }
}

/// What is wrong with a text that is not JSON, and where.
fn not_json(json: &str, error: &serde_json::Error) -> Refusal {
    let problem = JsonError::new(json, error);
    let code = match problem.fault {
        JsonFault::TooDeep => "too-deep",
        JsonFault::TooLarge | JsonFault::NotANumber => "not-finite",
        JsonFault::BareFraction | JsonFault::Ends | JsonFault::Syntax(_) => "malformed",
    };
    let message = match problem.fault {
        JsonFault::Ends => problem.at("error-json-ends"),
        JsonFault::Syntax(_) => problem.at("error-json"),
        _ => problem.message(),
    };
    Refusal::new(code, message)
}
