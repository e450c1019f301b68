//! One pass over an OBJ file that finds the first bad line.
//!
//! Cost: one look at each byte and one conversion of each number; a line of any length is refused
//! by its length, before its words are looked at.

use super::{
    super::error::beginning,
    error::{ObjError, ObjProblem},
    statements::{Statement, Statements},
};

/// Longest statement of a mesh, in bytes: a face of a hundred thousand corners.
const MAX_STATEMENT: usize = 1 << 20;

/// The lists that faces refer to.
const KEYWORDS: [&str; 3] = ["v", "vt", "vn"];

/// Statements that are OBJ but no part of a mesh of triangles.
const IGNORED: [&[u8]; 32] = [
    b"l",
    b"p",
    b"o",
    b"g",
    b"s",
    b"mg",
    b"vp",
    b"usemtl",
    b"mtllib",
    b"usemap",
    b"maplib",
    b"cstype",
    b"deg",
    b"bmat",
    b"step",
    b"curv",
    b"curv2",
    b"surf",
    b"parm",
    b"trim",
    b"hole",
    b"scrv",
    b"sp",
    b"end",
    b"con",
    b"bevel",
    b"c_interp",
    b"d_interp",
    b"lod",
    b"shadow_obj",
    b"trace_obj",
    b"ctech",
];

/// Whether the file holds a mesh; if not, the first bad line.
pub(super) fn check(bytes: &[u8]) -> Result<(), ObjError> {
    if bytes.trim_ascii().is_empty() {
        return Err(ObjError::whole(ObjProblem::Empty));
    }
    if let Some(zero) = bytes.iter().position(|byte| *byte == 0) {
        let line = 1 + bytes[..zero].iter().filter(|byte| **byte == b'\n').count();
        return Err(ObjError::line(line, ObjProblem::Binary));
    }
    let mut seen = Seen::default();
    for statement in Statements::new(bytes) {
        seen.statement(statement).map_err(|problem| ObjError::line(statement.line, problem))?;
    }
    seen.end()
}

/// What has been read so far.
#[derive(Default)]
struct Seen {
    /// Of positions, texture coordinates and normals.
    counts: [usize; 3],
    /// Positions with a colour.
    colored: usize,
    faces: usize,
    /// For each list, references beyond what has been read, each greater than all before: the
    /// first bad one, if any, is among them.
    ahead: [Vec<(usize, i64)>; 3],
    /// The first line that is no statement of the format.
    foreign: Option<(usize, String)>,
}

impl Seen {
    fn statement(&mut self, statement: Statement<'_>) -> Result<(), ObjProblem> {
        if statement.is_geometry() && statement.len() > MAX_STATEMENT {
            return Err(ObjProblem::LineTooLong { bytes: statement.len(), limit: MAX_STATEMENT });
        }
        let mut words = statement.words();
        match words.next() {
            Some(b"v") => self.position(&numbers(words)?),
            Some(b"vt") => {
                self.counts[1] += 1;
                count("vt", numbers(words)?.len(), &[2, 3])
            }
            Some(b"vn") => {
                self.counts[2] += 1;
                count("vn", numbers(words)?.len(), &[3])
            }
            Some(b"f") => self.face(statement.line, words),
            Some(word) if self.foreign.is_none() && !IGNORED.contains(&word) => {
                self.foreign = Some((statement.line, shortened(word)));
                Ok(())
            }
            _ => Ok(()),
        }
    }

    /// `v x y z`, `v x y z w` or `v x y z r g b`.
    fn position(&mut self, numbers: &[f32]) -> Result<(), ObjProblem> {
        count("v", numbers.len(), &[3, 4, 6])?;
        match *numbers {
            [.., 0.0] if numbers.len() == 4 => return Err(ObjProblem::ZeroWeight),
            [x, y, z, w] => {
                if let Some(huge) = [x, y, z].iter().find(|value| !(**value / w).is_finite()) {
                    return Err(ObjProblem::NotFinite { word: format!("{huge} / {w}") });
                }
            }
            [_, _, _, r, g, b] => {
                if let Some(wrong) = [r, g, b].iter().find(|value| !(0.0..=1.0).contains(*value)) {
                    return Err(ObjProblem::Color { word: wrong.to_string() });
                }
                self.colored += 1;
            }
            _ => {}
        }
        self.counts[0] += 1;
        if self.colored == 0 || self.colored == self.counts[0] { Ok(()) } else { Err(ObjProblem::SomeColors) }
    }

    fn face<'a>(&mut self, line: usize, words: impl Iterator<Item = &'a [u8]>) -> Result<(), ObjProblem> {
        let mut found = 0;
        for word in words {
            self.corner(line, word)?;
            found += 1;
        }
        self.faces += 1;
        if found < 3 { Err(ObjProblem::Corners { found }) } else { Ok(()) }
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`, each counted from 1, or from -1 backwards.
    fn corner(&mut self, line: usize, word: &[u8]) -> Result<(), ObjProblem> {
        let wrong = || ObjProblem::Corner { word: shortened(word) };
        for (list, part) in word.split(|byte| *byte == b'/').enumerate() {
            let (Some(&count), Some(&keyword)) = (self.counts.get(list), KEYWORDS.get(list)) else {
                return Err(wrong());
            };
            if part.is_empty() && list > 0 {
                continue;
            }
            let index: i64 =
                std::str::from_utf8(part).ok().and_then(|text| text.parse().ok()).ok_or_else(wrong)?;
            match (index, usize::try_from(index.unsigned_abs())) {
                (0, _) => return Err(ObjProblem::IndexZero),
                (1.., Ok(distance)) if distance <= count => {}
                (..0, Ok(distance)) if distance <= count => {}
                (1.., _) => {
                    let ahead = &mut self.ahead[list];
                    if ahead.last().is_none_or(|(_, most)| index > *most) {
                        ahead.push((line, index));
                    }
                }
                _ => return Err(ObjProblem::NoSuchIndex { index, keyword, count }),
            }
        }
        Ok(())
    }

    /// What only the end of the file can tell.
    fn end(self) -> Result<(), ObjError> {
        let bad = self.ahead.iter().zip(self.counts).zip(KEYWORDS).filter_map(|((ahead, count), keyword)| {
            let beyond = |index: i64| usize::try_from(index).map_or(true, |index| index > count);
            let (line, index) = *ahead.iter().find(|(_, index)| beyond(*index))?;
            Some((line, ObjProblem::NoSuchIndex { index, keyword, count }))
        });
        if let Some((line, problem)) = bad.min_by_key(|(line, _)| *line) {
            return Err(ObjError::line(line, problem));
        }
        match (self.faces, self.foreign) {
            (0, Some((line, word))) => Err(ObjError::line(line, ObjProblem::NotObj { word })),
            (0, None) => Err(ObjError::whole(ObjProblem::NoFaces)),
            _ => Ok(()),
        }
    }
}

fn numbers<'a>(words: impl Iterator<Item = &'a [u8]>) -> Result<Vec<f32>, ObjProblem> {
    // One more than any statement takes, so that too many are seen and not all are read.
    words.take(8).map(number).collect()
}

fn number(word: &[u8]) -> Result<f32, ObjProblem> {
    match std::str::from_utf8(word).ok().and_then(|text| text.parse::<f32>().ok()) {
        Some(value) if value.is_finite() => Ok(value),
        Some(_) => Err(ObjProblem::NotFinite { word: shortened(word) }),
        None => Err(ObjProblem::Number { word: shortened(word) }),
    }
}

fn count(keyword: &'static str, found: usize, allowed: &[usize]) -> Result<(), ObjProblem> {
    if allowed.contains(&found) { Ok(()) } else { Err(ObjProblem::Count { keyword, found }) }
}

/// The beginning of a word, for a message: enough to find it, and no more of a file that is perhaps
/// no model at all and none of the reader's business.
fn shortened(word: &[u8]) -> String {
    beginning(&String::from_utf8_lossy(&word[..word.len().min(256)]), 20)
}
