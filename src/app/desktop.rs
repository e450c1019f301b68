//! The window's [`Platform`] on the desktop: real files, and the system's file dialog.

use eframe::egui::Context;
use rasterscope_ui::Platform;
use std::{
    ffi::OsString,
    fs, io,
    path::{Path, PathBuf},
    sync::mpsc::{self, Receiver, Sender},
    thread,
};

/// Files and dialogs of the desktop.
pub(crate) struct Desktop {
    /// To wake the window when a file was chosen.
    ctx: Context,
    send: Sender<String>,
    chosen: Receiver<String>,
}

impl Desktop {
    /// The platform of the window that `ctx` paints.
    pub(crate) fn new(ctx: Context) -> Self {
        let (send, chosen) = mpsc::channel();
        Self { ctx, send, chosen }
    }
}

impl Platform for Desktop {
    fn read(&mut self, path: &str) -> io::Result<Vec<u8>> {
        fs::read(path)
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> io::Result<()> {
        write_whole(Path::new(path), bytes)
    }

    fn choose_file(&mut self) -> bool {
        let (send, ctx) = (self.send.clone(), self.ctx.clone());
        // The dialog blocks until it is answered: a thread of its own keeps the window alive.
        let started = thread::Builder::new().spawn(move || {
            let dialog = rfd::FileDialog::new().add_filter("Rasterscope, OBJ", &["json", "obj"]);
            if let Some(path) = dialog.pick_file() {
                // Fails only if the window is gone.
                let _ = send.send(path.to_string_lossy().into_owned());
                ctx.request_repaint();
            }
        });
        started.is_ok()
    }

    fn chosen(&mut self) -> Option<String> {
        self.chosen.try_recv().ok()
    }
}

/// Writes beside the file first, then puts the new one in its place: whole or not at all.
fn write_whole(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut beside = OsString::from(path);
    beside.push(".part");
    let beside = PathBuf::from(beside);
    fs::write(&beside, bytes).and_then(|()| fs::rename(&beside, path)).inspect_err(|_| {
        // The first error is the one to report.
        let _ = fs::remove_file(&beside);
    })
}
