//! One thing in several places: a table row, a listing line and a mark on the canvas that bear the
//! same name light each other while the pointer is on one of them.

use std::cell::RefCell;

/// Something the pointer can be on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Thing {
    /// What bears a name: a vertex, a border, an edge, a column.
    Name(String),
    /// A line of the listing: everything that it names.
    Line(String),
    /// A row of pixels.
    Row(i64),
}

/// What the pointer is on, from frame to frame.
#[derive(Debug, Default)]
pub(crate) struct Links {
    now: Option<Thing>,
    next: RefCell<Option<Thing>>,
}

impl Links {
    /// Says that the pointer is on a thing.
    pub(crate) fn point_at(&self, thing: Thing) {
        *self.next.borrow_mut() = Some(thing);
    }

    /// What the pointer was on in the last frame.
    pub(crate) fn now(&self) -> Option<&Thing> {
        self.now.as_ref()
    }

    /// Ends a frame; `true` if something else is lit in the next one.
    pub(crate) fn end_frame(&mut self) -> bool {
        let next = self.next.take();
        std::mem::replace(&mut self.now, next) != self.now
    }

    /// Whether what bears a name is lit.
    pub(crate) fn name(&self, name: &str) -> bool {
        match &self.now {
            Some(Thing::Name(now)) => bare(now) == bare(name),
            Some(Thing::Line(line)) => mentions(line, name),
            Some(Thing::Row(row)) => name.parse() == Ok(*row),
            None => false,
        }
    }

    /// Whether a line of the listing is lit.
    pub(crate) fn line(&self, line: &str) -> bool {
        matches!(&self.now, Some(Thing::Name(now)) if mentions(line, now))
    }
}

/// A name without what says which of its places is meant: `P1′` is P1.
fn bare(name: &str) -> &str {
    name.trim_end_matches(['′', '″', '‴'])
}

/// Whether a line names something, as a word of its own.
fn mentions(line: &str, name: &str) -> bool {
    let part = |c: char| c.is_alphanumeric() || matches!(c, '′' | '″' | '‴');
    let whole = |at: usize| {
        let (before, behind) = (&line[..at], &line[at + name.len()..]);
        !before.chars().next_back().is_some_and(part) && !behind.chars().next().is_some_and(part)
    };
    // Numbers are everywhere.
    name.chars().any(char::is_alphabetic) && line.match_indices(name).any(|(at, _)| whole(at))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_names_whole_words() {
        for (line, name, expected) in [
            ("c1 ← code(P1)", "P1", true),
            ("c1 ← code(P1)", "P", false),
            ("x left ← where the centre line meets the left edge", "x left", true),
            ("x′, y′ ← rows of M · v", "x′", true),
            ("x′, y′ ← rows of M · v", "x", false),
            ("first ← ⌈x left − 0.5⌉", "0", false),
            ("", "P1", false),
        ] {
            assert_eq!(mentions(line, name), expected, "{name} in {line}");
        }
    }

    #[test]
    fn what_bears_one_name_is_lit_together_in_the_next_frame() {
        let mut links = Links::default();
        links.point_at(Thing::Name("P1".into()));
        assert!(!links.name("P1"));
        assert!(links.end_frame());
        assert!(links.name("P1") && links.name("P1′") && !links.name("P2"));
        assert!(links.line("c1 ← code(P1)") && !links.line("c2 ← code(P2)"));
        links.point_at(Thing::Name("P1".into()));
        assert!(!links.end_frame(), "nothing new");
        links.point_at(Thing::Row(4));
        assert!(links.end_frame() && links.name("4") && !links.name("P1"));
        assert!(links.end_frame() && links.now().is_none());
    }
}
