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

    /// Lets the user choose a file; the answer comes later, by [`Self::chosen`].
    /// `false` if there is no such dialog here: a path can still be typed.
    fn choose_file(&mut self, purpose: Purpose) -> bool;

    /// The file chosen since the last call, and for what.
    fn chosen(&mut self) -> Option<(Purpose, String)>;

    /// What was kept in the program's own folder under that name; `None` if nothing was.
    fn kept(&mut self, name: &str) -> Option<Vec<u8>>;

    /// Keeps bytes in the program's own folder, whole or not at all.
    fn keep(&mut self, name: &str, bytes: &[u8]) -> io::Result<()>;
}

/// What a file is chosen for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// A scene or a model to open.
    Open,
    /// A scene to write.
    Save,
    /// A picture to write.
    Picture,
}
