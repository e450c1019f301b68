//! The statements of an OBJ file with their line numbers, without a copy.

use std::io::{BufRead, Read, Result};

/// One statement: a keyword and its words.
#[derive(Clone, Copy)]
pub(super) struct Statement<'a> {
    /// The line that it begins in, counted from 1.
    pub(super) line: usize,
    /// Up to a comment; with `\` where it goes on in the next line.
    body: &'a [u8],
}

impl<'a> Statement<'a> {
    /// The pieces between the `\`s, without white space about them.
    fn pieces(self) -> impl Iterator<Item = &'a [u8]> {
        self.body.split(|byte| *byte == b'\\').map(<[u8]>::trim_ascii)
    }

    /// All words, the keyword first.
    pub(super) fn words(self) -> impl Iterator<Item = &'a [u8]> {
        let words = |piece: &'a [u8]| piece.split(u8::is_ascii_whitespace);
        self.pieces().flat_map(words).filter(|word| !word.is_empty())
    }

    /// Its length in bytes.
    pub(super) fn len(self) -> usize {
        self.body.len()
    }

    /// Whether it is one of the four that make up a mesh.
    pub(super) fn is_geometry(self) -> bool {
        is_geometry(self.body)
    }
}

fn is_geometry(line: &[u8]) -> bool {
    let line = line.trim_ascii_start();
    let end = line.iter().take(3).position(u8::is_ascii_whitespace).unwrap_or(line.len());
    matches!(&line[..end], b"v" | b"vt" | b"vn" | b"f")
}

/// Iterates over all lines that are not empty and not a comment.
///
/// A file with no line feed at all is split at carriage returns. Only statements of the mesh go on
/// behind a `\`: elsewhere it may be part of a name.
#[derive(Clone)]
pub(super) struct Statements<'a> {
    rest: &'a [u8],
    line: usize,
    line_end: u8,
}

impl<'a> Statements<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let rest = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let line_end = if rest.contains(&b'\n') { b'\n' } else { b'\r' };
        Self { rest, line: 1, line_end }
    }

    /// The length of the first line of `bytes`, without its end.
    fn line_length(&self, bytes: &[u8]) -> usize {
        bytes.iter().position(|byte| *byte == self.line_end).unwrap_or(bytes.len())
    }
}

impl<'a> Iterator for Statements<'a> {
    type Item = Statement<'a>;

    fn next(&mut self) -> Option<Statement<'a>> {
        while !self.rest.is_empty() {
            let line = self.line;
            let mut end = self.line_length(self.rest);
            self.line += 1;
            if is_geometry(&self.rest[..end]) {
                while self.rest[..end].trim_ascii_end().ends_with(b"\\") && end < self.rest.len() {
                    end += 1 + self.line_length(&self.rest[end + 1..]);
                    self.line += 1;
                }
            }
            let whole = &self.rest[..end];
            self.rest = self.rest.get(end + 1..).unwrap_or_default();
            let body = whole.split(|byte| *byte == b'#').next().unwrap_or_default().trim_ascii();
            if !body.is_empty() {
                return Some(Statement { line, body });
            }
        }
        None
    }
}

/// What tobj reads: the statements of the mesh, one a line.
pub(super) fn feed<'a>(bytes: &'a [u8]) -> impl BufRead + 'a {
    let joined =
        |statement: Statement<'a>| statement.pieces().flat_map(|piece| [piece, b" "]).chain([&b"\n"[..]]);
    let geometry = Statements::new(bytes).filter(|statement| statement.is_geometry());
    Feed { pieces: geometry.flat_map(joined), piece: b"" }
}

struct Feed<'a, I> {
    pieces: I,
    piece: &'a [u8],
}

impl<'a, I: Iterator<Item = &'a [u8]>> BufRead for Feed<'a, I> {
    fn fill_buf(&mut self) -> Result<&[u8]> {
        while self.piece.is_empty() {
            match self.pieces.next() {
                Some(piece) => self.piece = piece,
                None => break,
            }
        }
        Ok(self.piece)
    }

    fn consume(&mut self, amount: usize) {
        self.piece = self.piece.get(amount..).unwrap_or_default();
    }
}

impl<'a, I: Iterator<Item = &'a [u8]>> Read for Feed<'a, I> {
    fn read(&mut self, buffer: &mut [u8]) -> Result<usize> {
        let piece = self.fill_buf()?;
        let length = piece.len().min(buffer.len());
        buffer[..length].copy_from_slice(&piece[..length]);
        self.consume(length);
        Ok(length)
    }
}
