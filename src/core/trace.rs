//! How an algorithm reports what it does, at no cost when nobody listens.
//!
//! An algorithm is written once, generic over `T: Tracer<Event>`, and calls
//! `t.emit(|| Event::...)` where something worth showing has happened. With [`NoTrace`] the
//! closures are dead code: the optimised function is the untraced one (`tests/check-trace-cost`
//! compares the machine code).
//!
//! Two laws, tested for every algorithm: the result never depends on the tracer, and folding the
//! events gives the result (see [`crate::replay::State`]).

/// Receives the events of one algorithm run, in order.
pub trait Tracer<E> {
    /// `false` lets an algorithm skip work that exists only for the trace, such as a loop that
    /// reports each pixel of a span that the fast path fills at once.
    const ENABLED: bool = true;

    /// Takes one event. `make` runs only if the tracer wants the event, so building the payload
    /// is free otherwise. It must not change what the algorithm computes, and must compute
    /// nothing that the algorithm lacks.
    fn emit(&mut self, make: impl FnOnce() -> E);
}

/// The tracer of fast runs: compiles to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoTrace;

impl<E> Tracer<E> for NoTrace {
    const ENABLED: bool = false;

    #[inline(always)]
    fn emit(&mut self, _make: impl FnOnce() -> E) {}
}

/// Keeps every event: for tests and for short traces.
impl<E> Tracer<E> for Vec<E> {
    #[inline]
    fn emit(&mut self, make: impl FnOnce() -> E) {
        self.push(make());
    }
}

/// Counts events without keeping any.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count(pub usize);

impl<E> Tracer<E> for Count {
    #[inline]
    fn emit(&mut self, _make: impl FnOnce() -> E) {
        self.0 += 1;
    }
}

/// Lets the trace of an algorithm hold the events of the stages inside it:
/// `fill_traced(triangle, &mut Lift(t, Event::Fill))`.
#[derive(Debug)]
pub struct Lift<'t, T, F>(pub &'t mut T, pub F);

impl<Inner, Outer, T, F> Tracer<Inner> for Lift<'_, T, F>
where
    T: Tracer<Outer>,
    F: Fn(Inner) -> Outer,
{
    const ENABLED: bool = T::ENABLED;

    #[inline(always)]
    fn emit(&mut self, make: impl FnOnce() -> Inner) {
        let Self(outer, wrap) = self;
        outer.emit(|| wrap(make()));
    }
}
