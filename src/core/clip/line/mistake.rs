//! What learners get wrong in clipping a line, to be switched on and seen beside the right answer.

use serde::{Deserialize, Serialize};

/// A common mistake.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Mistake {
    /// A line is rejected if the codes joined by OR, not AND, are not 0: so are lines that cross.
    OrForAnd,
    /// The cut is computed from the second end, as a neighbour does that walks the shared edge the
    /// other way: in rounded arithmetic the two differ, and a crack opens.
    OtherOrder,
}

impl Mistake {
    /// Every mistake, in the order in which they are shown.
    pub const ALL: [Self; 2] = [Self::OrForAnd, Self::OtherOrder];

    /// The name in scene files; `mistake-NAME` and `mistake-NAME-effect` are its words.
    pub fn name(self) -> &'static str {
        match self {
            Self::OrForAnd => "or-for-and",
            Self::OtherOrder => "other-order",
        }
    }
}

/// Which mistakes are made; the default is none. In scene files a list of names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(from = "Vec<Mistake>", into = "Vec<Mistake>")]
pub struct Mistakes(u8);

impl Mistakes {
    /// The right algorithm.
    pub const NONE: Self = Self(0);

    /// Whether none is made.
    pub fn is_empty(&self) -> bool {
        *self == Self::NONE
    }

    /// Whether `mistake` is made.
    #[inline]
    pub fn has(self, mistake: Mistake) -> bool {
        self.0 & 1 << mistake as u8 != 0
    }

    /// The same with `mistake` made.
    #[must_use]
    pub fn with(self, mistake: Mistake) -> Self {
        Self(self.0 | 1 << mistake as u8)
    }

    /// The same with `mistake` not made.
    #[must_use]
    pub fn without(self, mistake: Mistake) -> Self {
        Self(self.0 & !(1 << mistake as u8))
    }

    /// The mistakes that are made, in the order of [`Mistake::ALL`].
    pub fn iter(self) -> impl Iterator<Item = Mistake> {
        Mistake::ALL.into_iter().filter(move |mistake| self.has(*mistake))
    }
}

impl FromIterator<Mistake> for Mistakes {
    fn from_iter<I: IntoIterator<Item = Mistake>>(mistakes: I) -> Self {
        mistakes.into_iter().fold(Self::NONE, Self::with)
    }
}

impl From<Vec<Mistake>> for Mistakes {
    fn from(mistakes: Vec<Mistake>) -> Self {
        mistakes.into_iter().collect()
    }
}

impl From<Mistakes> for Vec<Mistake> {
    fn from(mistakes: Mistakes) -> Self {
        mistakes.iter().collect()
    }
}
