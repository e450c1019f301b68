//! What the window needs from the machine it runs on.
//!
//! The ui crate itself never touches a file: the app implements this for the desktop, the window
//! tests with a map of names to bytes. Time comes with egui's input, so no clock is needed.

use std::io;

/// Files, as far as the window reads and writes them.
pub trait Platform {
    /// The bytes of a file.
    fn read(&mut self, path: &str) -> io::Result<Vec<u8>>;

    /// Writes a file whole or not at all.
    fn write(&mut self, path: &str, bytes: &[u8]) -> io::Result<()>;

    /// Lets the user choose a file to open; the answer comes later, by [`Self::chosen`].
    /// `false` if there is no such dialog here: a path can still be typed.
    fn choose_file(&mut self) -> bool;

    /// The file chosen since the last call.
    fn chosen(&mut self) -> Option<String>;
}
