//! Requests of bounded length from a stream.

use rasterscope_core::message::Message;
use std::io::{self, BufRead, ErrorKind};

use super::Refusal;

/// The longest request, in bytes: room for a scene of half a million vertices.
pub const MOST_BYTES: usize = 32 << 20;

/// What [`next`] found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Read {
    /// A request of at most [`MOST_BYTES`].
    Request,
    /// One that is longer; it was passed over.
    TooLong,
    /// Nothing more.
    End,
}

/// Reads up to the next `end` byte, which is dropped, or to the end of the input. Keeps at most
/// [`MOST_BYTES`], however long the line is.
pub(super) fn next(input: &mut dyn BufRead, end: Option<u8>, line: &mut Vec<u8>) -> io::Result<Read> {
    line.clear();
    let (mut any, mut too_long) = (false, false);
    loop {
        let bytes = match input.fill_buf() {
            Err(error) if error.kind() == ErrorKind::Interrupted => continue,
            bytes => bytes?,
        };
        let stop = end.and_then(|end| bytes.iter().position(|&byte| byte == end));
        let piece = &bytes[..stop.unwrap_or(bytes.len())];
        let at_end = bytes.is_empty();
        any |= !at_end;
        too_long |= line.len() + piece.len() > MOST_BYTES;
        if too_long {
            line.clear();
        } else {
            line.extend_from_slice(piece);
        }
        let used = piece.len() + usize::from(stop.is_some());
        input.consume(used);
        if stop.is_some() || at_end {
            return Ok(match (any, too_long) {
                (false, _) => Read::End,
                (true, true) => Read::TooLong,
                (true, false) => Read::Request,
            });
        }
    }
}

/// The answer to a request that is too long.
pub(super) fn too_long() -> Refusal {
    let message = Message::new("error-too-long").with("megabytes", MOST_BYTES >> 20);
    Refusal::new("too-long", message)
}
