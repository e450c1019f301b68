//! Exact predicates and correctly rounded quotients.
