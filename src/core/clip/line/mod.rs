//! Lines against a rectangular window.
