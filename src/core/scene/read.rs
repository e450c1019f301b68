//! Reads typed values from a JSON value and says exactly where and why it cannot.
//!
//! serde_json's own reader describes an error in one English sentence without a path. This one
//! hands over the path and the facts, so that the sentence can be said in any language. Numbers
//! that round to an infinite binary32 are refused here, where their path is known.

use super::{
    error::{Kind, Problem, shortened},
    path::FieldError,
};
use serde::{
    Deserialize,
    de::{self, DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, SeqAccess, Unexpected, Visitor},
    forward_to_deserialize_any,
};
use serde_json::{Map, Value, map};
use std::{fmt::Display, iter::Enumerate, slice};

/// Reads a `T`.
pub(crate) fn read<'a, T: Deserialize<'a>>(value: &'a Value) -> Result<T, FieldError> {
    T::deserialize(Reader(value))
}

fn kind(value: &Value) -> Kind {
    match value {
        Value::Null => Kind::Null,
        Value::Bool(_) => Kind::Bool,
        Value::Number(_) => Kind::Number,
        Value::String(_) => Kind::Text,
        Value::Array(_) => Kind::List,
        Value::Object(_) => Kind::Object,
    }
}

struct Reader<'a>(&'a Value);

impl<'a> Reader<'a> {
    fn wrong<T>(&self, wanted: Kind) -> Result<T, FieldError> {
        Err(FieldError::here(Problem::Kind { wanted, found: kind(self.0) }))
    }

    /// A whole number, also if it is written `3.0`.
    fn whole(&self, max: u64) -> Result<u64, FieldError> {
        let Value::Number(number) = self.0 else { return self.wrong(Kind::WholeNumber) };
        #[expect(clippy::cast_precision_loss, reason = "every limit is exact")]
        match number.as_f64() {
            Some(x) if x.fract() != 0.0 => {
                Err(FieldError::here(Problem::Kind { wanted: Kind::WholeNumber, found: Kind::Fraction }))
            }
            Some(x) if x < 0.0 => Err(FieldError::here(Problem::Negative)),
            Some(x) if x <= max as f64 => Ok(x as u64),
            _ => Err(FieldError::here(Problem::Range { min: 0.0, max: max as f64 })),
        }
    }

    /// A whole number of 32 bits, of either sign.
    fn signed(&self) -> Result<i32, FieldError> {
        match self.0.as_f64() {
            Some(x) if x < 0.0 && x.fract() == 0.0 => {
                let problem = Problem::Range { min: i32::MIN.into(), max: i32::MAX.into() };
                if x < i32::MIN.into() { Err(FieldError::here(problem)) } else { Ok(x as i32) }
            }
            _ => self.whole(i32::MAX as u64).map(|x| x as i32),
        }
    }

    fn list(&self) -> Result<&'a [Value], FieldError> {
        match self.0 {
            Value::Array(items) => Ok(items),
            _ => self.wrong(Kind::List),
        }
    }

    fn object(&self) -> Result<&'a Map<String, Value>, FieldError> {
        match self.0 {
            Value::Object(fields) => Ok(fields),
            _ => self.wrong(Kind::Object),
        }
    }
}

impl<'de> Deserializer<'de> for Reader<'de> {
    type Error = FieldError;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        match self.0 {
            Value::Null => visitor.visit_unit(),
            Value::Bool(b) => visitor.visit_bool(*b),
            Value::Number(n) => match n.as_f64() {
                Some(x) => visitor.visit_f64(x),
                None => self.wrong(Kind::Number),
            },
            Value::String(text) => visitor.visit_borrowed_str(text),
            Value::Array(items) => visitor.visit_seq(Items(items.iter().enumerate())),
            Value::Object(fields) => visitor.visit_map(Fields { rest: fields.iter(), value: None }),
        }
    }

    fn deserialize_bool<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        match self.0 {
            Value::Bool(b) => visitor.visit_bool(*b),
            _ => self.wrong(Kind::Bool),
        }
    }

    fn deserialize_f32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        #[expect(clippy::cast_possible_truncation, reason = "a number that is no binary32 value is rounded")]
        match self.0.as_f64().map(|x| x as f32) {
            Some(x) if x.is_finite() => visitor.visit_f32(x),
            Some(_) => Err(FieldError::here(Problem::NotFinite)),
            None => self.wrong(Kind::Number),
        }
    }

    fn deserialize_i32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        visitor.visit_i32(self.signed()?)
    }

    fn deserialize_u8<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        visitor.visit_u64(self.whole(u8::MAX.into())?)
    }

    fn deserialize_u32<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        visitor.visit_u64(self.whole(u32::MAX.into())?)
    }

    /// Also every `usize`; limited so that it is one on any machine.
    fn deserialize_u64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        visitor.visit_u64(self.whole(u32::MAX.into())?)
    }

    fn deserialize_str<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        match self.0 {
            Value::String(text) => visitor.visit_borrowed_str(text),
            _ => self.wrong(Kind::Text),
        }
    }

    fn deserialize_string<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        self.deserialize_str(visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            _ => visitor.visit_some(self),
        }
    }

    fn deserialize_seq<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, FieldError> {
        visitor.visit_seq(Items(self.list()?.iter().enumerate()))
    }

    fn deserialize_tuple<V: Visitor<'de>>(self, wanted: usize, visitor: V) -> Result<V::Value, FieldError> {
        match self.list()?.len() {
            found if found != wanted => Err(FieldError::here(Problem::Length { wanted, found })),
            _ => self.deserialize_seq(visitor),
        }
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, FieldError> {
        visitor.visit_map(Fields { rest: self.object()?.iter(), value: None })
    }

    /// Only names: no enum of a scene file carries values.
    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _name: &'static str,
        _variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, FieldError> {
        match self.0 {
            Value::String(name) => visitor.visit_enum(name.as_str().into_deserializer()),
            _ => self.wrong(Kind::Text),
        }
    }

    forward_to_deserialize_any! {
        i8 i16 i64 i128 u16 u128 f64 char bytes byte_buf unit unit_struct newtype_struct
        tuple_struct map identifier ignored_any
    }
}

struct Items<'a>(Enumerate<slice::Iter<'a, Value>>);

impl<'de> SeqAccess<'de> for Items<'de> {
    type Error = FieldError;

    fn next_element_seed<T: DeserializeSeed<'de>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, FieldError> {
        let Some((i, item)) = self.0.next() else { return Ok(None) };
        seed.deserialize(Reader(item)).map(Some).map_err(|error| error.within(i))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

struct Fields<'a> {
    rest: map::Iter<'a>,
    value: Option<(&'a str, &'a Value)>,
}

impl<'de> MapAccess<'de> for Fields<'de> {
    type Error = FieldError;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, FieldError> {
        let Some((name, value)) = self.rest.next() else { return Ok(None) };
        self.value = Some((name, value));
        seed.deserialize(name.as_str().into_deserializer()).map(Some)
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, FieldError> {
        let Some((name, value)) = self.value.take() else {
            return Err(de::Error::custom("a value was asked for before its field"));
        };
        seed.deserialize(Reader(value)).map_err(|error| error.within(name))
    }
}

impl de::Error for FieldError {
    fn custom<T: Display>(what: T) -> Self {
        Self::here(Problem::Other(what.to_string()))
    }

    fn invalid_type(unexpected: Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        Self::custom(format_args!("{unexpected}, {expected}"))
    }

    fn invalid_length(found: usize, expected: &dyn de::Expected) -> Self {
        Self::custom(format_args!("{found}, {expected}"))
    }

    fn unknown_variant(name: &str, known: &'static [&'static str]) -> Self {
        Self::here(Problem::UnknownName { name: shortened(name), known: known.to_vec() })
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        Self::at(field, Problem::UnknownField { known: known.to_vec() })
    }

    fn missing_field(field: &'static str) -> Self {
        Self::at(field, Problem::Missing)
    }
}

impl Display for FieldError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for FieldError {}
