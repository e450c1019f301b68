//! What a term of the field means: the glossary of the language files, found by the term itself.
//!
//! A term is a heading, a name of a listing or the id of a word. Its entry is `glossary-` and the
//! term without what only says where it stands: `column-depth` is `glossary-depth`, `T B R L` is
//! `glossary-t-b-r-l`, `dx/dy` is `glossary-dx-dy`.

use crate::words::Words;

/// What ids begin with that name a place, not a thing.
const PLACES: [&str; 3] = ["column-", "ui-", "row-"];

/// The id of a term's entry.
pub fn id(term: &str) -> String {
    let name = PLACES.iter().find_map(|place| term.strip_prefix(place)).unwrap_or(term).to_ascii_lowercase();
    let words = name.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty());
    words.fold("glossary".to_owned(), |id, word| id + "-" + word)
}

impl Words {
    /// What a term means, in a sentence; `None` if the glossary does not have it.
    pub fn meaning(&self, term: &str) -> Option<String> {
        let id = id(term);
        self.has(&id).then(|| self.word(&id))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_term_is_found_wherever_it_stands() {
        for (term, expected) in [
            ("column-depth", "glossary-depth"),
            ("ui-fill-rule", "glossary-fill-rule"),
            ("T B R L", "glossary-t-b-r-l"),
            ("dx/dy", "glossary-dx-dy"),
            ("x left", "glossary-x-left"),
            ("stage-cull", "glossary-stage-cull"),
            ("C⁻¹", "glossary-c"),
            ("", "glossary"),
        ] {
            assert_eq!(id(term), expected);
        }
        let words = Words::default();
        assert!(words.meaning("T B R L").is_some_and(|text| text.contains("border")));
        assert_eq!(words.meaning(""), None);
        assert_eq!(words.meaning("no such term"), None);
    }
}
