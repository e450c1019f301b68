//! Why a request has no answer.

use rasterscope_core::message::Message;
use serde::Serialize;

use crate::words::say;

/// An error object: a code for programs and a sentence for people.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Refusal {
    /// One of the codes that [`super`] lists.
    pub(crate) code: &'static str,
    /// What, where, what to do.
    pub(crate) message: Message,
}

impl Refusal {
    pub(crate) fn new(code: &'static str, message: Message) -> Self {
        Self { code, message }
    }

    /// A name of the interface that this version has no algorithm for yet.
    pub(crate) fn unsupported(field: &'static str, name: &str) -> Self {
        let message = Message::new("error-unsupported");
        Self::new("unsupported", message.with("field", text(field)).with("name", text(name)))
    }

    /// An operation without steps.
    pub(super) fn no_lab(op: &str) -> Self {
        Self::new("no-lab", Message::new("error-request-without-steps").with("op", text(op)))
    }

    /// The answer in rounded arithmetic is no finite number.
    pub(crate) fn overflow(arithmetic: rasterscope_core::math::Arithmetic) -> Self {
        let message = Message::new("error-overflow").with("arithmetic", text(arithmetic.name()));
        Self::new("overflow", message)
    }
}

/// Text that is the same in every language.
pub(crate) fn text(text: impl std::fmt::Display) -> rasterscope_core::message::Value {
    rasterscope_core::message::Value::text(text)
}

/// As it goes over the wire: `{"error":{"code":"..","message":".."}}`.
#[derive(Serialize)]
pub(super) struct ErrorObject {
    error: ErrorBody,
}

#[derive(Serialize)]
struct ErrorBody {
    code: &'static str,
    message: String,
}

impl From<&Refusal> for ErrorObject {
    fn from(refusal: &Refusal) -> Self {
        Self { error: ErrorBody { code: refusal.code, message: say(&refusal.message) } }
    }
}
