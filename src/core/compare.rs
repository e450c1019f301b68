//! Two runs of one input side by side, differing in one setting.
//!
//! A [`Setting`] makes the scene of side B from the scene of side A, so an edit of the input moves
//! both. What the runs come to is said as [`Fact`]s, by each algorithm's own
//! [`Explain::facts`](crate::explain::Explain::facts), and compared by [`difference()`]: never by
//! looking at what is drawn. [`Pair`] steps both with one cursor.

mod alignment;
mod choice;
mod difference;
mod fact;
mod pair;
mod setting;

pub use alignment::Alignment;
pub use choice::Choice;
pub use difference::{Changed, Difference, Part, difference, equal, sorted, ulps};
pub use fact::{Fact, Subject, totals};
pub use pair::{Pair, Side};
pub use setting::{Setting, settings, side_b};
