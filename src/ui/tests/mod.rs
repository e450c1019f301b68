//! The window driven without a window: every lab, keys, files, pictures.

mod aids;
mod editing;
mod export;
mod files;
mod fits;
mod heavy;
mod keeping;
mod keys;
mod labs;
mod measure;
mod overlay;
mod painter;
mod pictures;
mod pixel;
mod reach;
mod skips;
mod source;
mod split;
mod stress;

use crate::{App, Clock, Platform, Purpose, Reader, theme};
use egui::{Rect, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};
use painter::CpuPainter;
use rasterscope_measure::Machine;
use std::{cell::Cell, collections::BTreeMap, io};

/// Files in memory.
#[derive(Default)]
struct Memory {
    files: BTreeMap<String, Vec<u8>>,
    /// The program's own folder, and how often it was written to.
    kept: BTreeMap<String, Vec<u8>>,
    writes: usize,
    full: bool,
    /// Whether the hints of a first start are wanted.
    hints: bool,
    /// Whether work waits for [`Memory::work`]; else it is done at once.
    lazy: bool,
    /// The file that the program is started with; it is read before the first frame.
    named: Option<&'static str>,
    waiting: Vec<Box<dyn FnOnce() + Send>>,
}

impl Memory {
    /// Does the work that waits.
    fn work(&mut self) {
        self.waiting.drain(..).for_each(|work| work());
    }
}

impl Platform for Memory {
    fn reader(&mut self) -> Reader {
        let files = self.files.clone();
        Box::new(move |path| files.get(path).cloned().ok_or_else(|| io::ErrorKind::NotFound.into()))
    }

    fn write(&mut self, path: &str, bytes: &[u8]) -> io::Result<()> {
        if path.starts_with("/read-only/") {
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, "the folder is read-only"));
        }
        if self.full {
            return Err(io::ErrorKind::StorageFull.into());
        }
        self.files.insert(path.to_owned(), bytes.to_owned());
        Ok(())
    }

    fn choose_file(&mut self, _: Purpose, _: &str) -> bool {
        false
    }

    fn chosen(&mut self) -> Option<(Purpose, String)> {
        None
    }

    fn kept(&mut self, name: &str) -> Option<Vec<u8>> {
        self.kept.get(name).cloned()
    }

    fn keep(&mut self, name: &str, bytes: &[u8]) -> io::Result<()> {
        if self.full {
            return Err(io::Error::new(io::ErrorKind::StorageFull, "the disk is full"));
        }
        self.kept.insert(name.to_owned(), bytes.to_owned());
        self.writes += 1;
        Ok(())
    }

    fn spawn(&mut self, work: Box<dyn FnOnce() + Send>) {
        self.waiting.push(work);
        if !self.lazy {
            self.work();
        }
    }

    /// Each look at it is a microsecond later: measurements are the same every time.
    fn clock(&mut self) -> Clock {
        let looks = Cell::new(0);
        Box::new(move || {
            looks.set(looks.get() + 1);
            f64::from(looks.get()) * 1e-6
        })
    }

    fn machine(&mut self) -> Machine {
        Machine {
            processor: "A test".to_owned(),
            processors: 1,
            system: "memory",
            architecture: "none",
            version: "1",
            build: "debug",
            vectors: "none",
        }
    }
}

/// A window and its files.
struct Desk {
    app: Option<App>,
    platform: Memory,
}

impl Desk {
    fn app(&self) -> &App {
        self.app.as_ref().expect("made in the first frame")
    }

    fn app_mut(&mut self) -> &mut App {
        self.app.as_mut().expect("made in the first frame")
    }
}

type Window = Harness<'static, Desk>;

/// A window of this size, settled.
fn window(width: f32, height: f32) -> Window {
    window_on(width, height, Memory::default())
}

/// A window of this size on a machine with these files, settled.
fn window_on(width: f32, height: f32, platform: Memory) -> Window {
    let mut window = Harness::builder()
        .with_size(vec2(width, height))
        .with_max_steps(16)
        .with_step_dt(1.0 / 60.0)
        .renderer(CpuPainter::default())
        .with_context_setup(|ctx| {
            // As in a real window, the first frame already wears the look.
            ctx.set_fonts(theme::fonts());
            theme::Look::new(Default::default()).apply(ctx);
        })
        .build_ui_state(
            |ui, desk: &mut Desk| {
                // As in a real window: no margin round the app.
                let rect = ui.ctx().content_rect();
                let mut whole = ui.new_child(egui::UiBuilder::new().max_rect(rect));
                whole.set_clip_rect(rect);
                let Desk { app, platform } = desk;
                let app = app.get_or_insert_with(|| {
                    let mut app = App::new(ui.ctx());
                    app.start(ui.ctx(), platform.named, platform);
                    if platform.named.is_some() {
                        platform.work();
                    }
                    app.view.aids.hints &= platform.hints;
                    app
                });
                app.ui(&mut whole, platform);
            },
            Desk { app: None, platform },
        );
    window.run();
    window
}

/// A window with a lab open, at its end.
fn window_with(lab: &'static str) -> Window {
    let mut window = window(1280.0, 720.0);
    window.state_mut().app_mut().open_lab(lab);
    window.run();
    window
}

fn cursor(window: &Window) -> usize {
    window.state().app().run.shown().expect("something runs").cursor
}

fn len(window: &Window) -> usize {
    window.state().app().run.shown().expect("something runs").len
}

/// Where a control is, by its accessible name.
fn place(window: &Window, label: &str) -> Rect {
    window.get_by_label(label).rect()
}

fn click(window: &mut Window, label: &str) {
    window.get_by_label(label).click();
    window.run();
}

/// Drags from one point to another in small steps, as a hand does.
fn drag(window: &mut Window, from: egui::Pos2, to: egui::Pos2) {
    window.hover_at(from);
    window.run();
    window.drag_at(from);
    window.step();
    for i in 1..=4 {
        window.hover_at(from + (to - from) * (i as f32 / 4.0));
        window.step();
    }
    window.drop_at(to);
    window.run();
}
