//! A number that counts what is done with it.

use rasterscope_core::{explain::Operations, math::Real};
use std::{
    cell::Cell,
    cmp::Ordering,
    ops::{Add, Div, Mul, Neg, Sub},
};

thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

/// An f32 whose comparisons, products and quotients are counted.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counted(f32);

fn count(operations: Operations) {
    DONE.set(DONE.get() + operations);
}

/// Runs something and tells what was done with [`Counted`] numbers meanwhile.
pub(crate) fn counted<R>(run: impl FnOnce() -> R) -> (R, Operations) {
    DONE.set(Operations::NONE);
    let result = run();
    (result, DONE.get())
}

impl PartialEq for Counted {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        count(Operations::new(1, 0, 0));
        self.0.partial_cmp(&other.0)
    }
}

impl Add for Counted {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        count(Operations::new(0, 1, 0));
        Self(self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        count(Operations::new(0, 0, 1));
        Self(self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Self;

    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Real for Counted {
    const ZERO: Self = Self(0.0);
    const ONE: Self = Self(1.0);

    fn half(self) -> Self {
        Self(self.0 / 2.0)
    }

    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    fn from_f32(value: f32) -> Self {
        Self(value)
    }

    fn to_f32(self) -> f32 {
        self.0
    }

    fn to_f64(self) -> f64 {
        self.0.into()
    }
}
