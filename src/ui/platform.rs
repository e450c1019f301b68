//! What the window needs from the machine it runs on.
//!
//! The ui crate itself never touches a file: the app implements this for the desktop, the window
//! tests with a map of names to bytes. Time comes with egui's input, but for measuring.

use rasterscope_measure::Machine;
use std::io;

/// The bytes of a file, by its path.
pub type Reader = Box<dyn FnMut(&str) -> io::Result<Vec<u8>> + Send>;

/// Seconds since any moment, to measure with.
pub type Clock = Box<dyn Fn() -> f64 + Send>;

/// Files, as far as the window reads and writes them.
pub trait Platform {
    /// Gives the bytes of files, also to work beside the window.
    fn reader(&mut self) -> Reader;

    /// Writes a file whole or not at all.
    fn write(&mut self, path: &str, bytes: &[u8]) -> io::Result<()>;

    /// Lets the user choose a file, a new one of the name `proposed` perhaps; the answer comes later,
    /// by [`Self::chosen`]. `false` if there is no such dialog here: a path can still be typed.
    fn choose_file(&mut self, purpose: Purpose, proposed: &str) -> bool;

    /// The file chosen since the last call, and for what.
    fn chosen(&mut self) -> Option<(Purpose, String)>;

    /// What was kept in the program's own folder under that name; `None` if nothing was.
    fn kept(&mut self, name: &str) -> Option<Vec<u8>>;

    /// Keeps bytes in the program's own folder, whole or not at all.
    fn keep(&mut self, name: &str, bytes: &[u8]) -> io::Result<()>;

    /// Does work beside the window, and has a frame painted when it is done. Where nothing can be
    /// beside the window, it is done before this returns.
    fn spawn(&mut self, work: Box<dyn FnOnce() + Send>);

    /// Gives a clock, also to work beside the window.
    fn clock(&mut self) -> Clock;

    /// What the numbers of measurements are of.
    fn machine(&mut self) -> Machine;
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
    /// An animated picture to write.
    Film,
}
