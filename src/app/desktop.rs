//! The window's [`Platform`] on the desktop: real files, and the system's file dialog.

use eframe::egui::Context;
use rasterscope_cli::{bench, files::write_whole};
use rasterscope_measure::Machine;
use rasterscope_ui::{Clock, Platform, Purpose, Reader};
use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::mpsc::{self, Receiver, Sender},
    thread,
    time::Instant,
};

/// The name of the program's own folder.
pub(crate) const APP_ID: &str = "rasterscope";

/// Files and dialogs of the desktop.
pub(crate) struct Desktop {
    /// To wake the window when a file was chosen.
    ctx: Context,
    send: Sender<(Purpose, String)>,
    chosen: Receiver<(Purpose, String)>,
    /// The program's own folder, if there is a place for one.
    folder: Option<PathBuf>,
}

impl Desktop {
    /// The platform of the window that `ctx` paints.
    pub(crate) fn new(ctx: Context) -> Self {
        let (send, chosen) = mpsc::channel();
        Self { ctx, send, chosen, folder: eframe::storage_dir(APP_ID) }
    }
}

impl Platform for Desktop {
    fn reader(&mut self) -> Reader {
        Box::new(|path| fs::read(path))
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> io::Result<()> {
        write_whole(Path::new(path), bytes)
    }

    fn choose_file(&mut self, purpose: Purpose, proposed: &str) -> bool {
        let (send, ctx) = (self.send.clone(), self.ctx.clone());
        let proposed = proposed.to_owned();
        // The dialog blocks until it is answered: a thread of its own keeps the window alive.
        let started = thread::Builder::new().spawn(move || {
            let dialog = rfd::FileDialog::new();
            let path = match purpose {
                Purpose::Open => dialog.add_filter("Rasterscope, OBJ", &["json", "obj"]).pick_file(),
                Purpose::Save => {
                    dialog.add_filter("Rasterscope", &["json"]).set_file_name(proposed).save_file()
                }
                Purpose::Picture => dialog
                    .add_filter("SVG, PNG, CSV", &["svg", "png", "csv"])
                    .set_file_name(proposed)
                    .save_file(),
                Purpose::Film => {
                    dialog.add_filter("APNG", &["png", "apng"]).set_file_name(proposed).save_file()
                }
            };
            if let Some(path) = path {
                // Fails only if the window is gone.
                let _ = send.send((purpose, path.to_string_lossy().into_owned()));
                ctx.request_repaint();
            }
        });
        started.is_ok()
    }

    fn chosen(&mut self) -> Option<(Purpose, String)> {
        self.chosen.try_recv().ok()
    }

    fn kept(&mut self, name: &str) -> Option<Vec<u8>> {
        fs::read(self.folder.as_ref()?.join(name)).ok()
    }

    fn keep(&mut self, name: &str, bytes: &[u8]) -> io::Result<()> {
        let folder = self.folder.as_ref().ok_or(io::ErrorKind::NotFound)?;
        fs::create_dir_all(folder)?;
        write_whole(&folder.join(name), bytes)
    }

    fn spawn(&mut self, work: Box<dyn FnOnce() + Send>) {
        let ctx = self.ctx.clone();
        // Where no thread can be started, the work is lost, and the window says so.
        let _ = thread::Builder::new().spawn(move || {
            work();
            ctx.request_repaint();
        });
    }

    fn clock(&mut self) -> Clock {
        let start = Instant::now();
        Box::new(move || start.elapsed().as_secs_f64())
    }

    fn machine(&mut self) -> Machine {
        bench::machine()
    }
}
