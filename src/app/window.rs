//! The window, and why it cannot be opened.

use crate::desktop::Desktop;
use eframe::{
    CreationContext, NativeOptions, Renderer, Storage,
    egui::{Ui, ViewportBuilder},
};
use rasterscope_ui::App;
use std::{
    panic::{self, AssertUnwindSafe},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

const TITLE: &str = "Rasterscope";
const SETTINGS: &str = "settings";

struct Window {
    app: App,
    desktop: Desktop,
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.app.ui(ui, &mut self.desktop);
    }

    fn save(&mut self, storage: &mut dyn Storage) {
        storage.set_string(SETTINGS, self.app.settings());
    }

    fn persist_egui_memory(&self) -> bool {
        false
    }
}

/// Opens the window and returns when it is closed.
///
/// # Errors
/// One sentence why there is no window; then nothing was shown.
pub fn open(file: Option<String>) -> Result<(), String> {
    let options = NativeOptions {
        viewport: ViewportBuilder::default()
            .with_title(TITLE)
            .with_app_id("rasterscope")
            .with_inner_size([1280.0, 720.0])
            .with_min_inner_size([1024.0, 600.0])
            .with_drag_and_drop(true),
        renderer: Renderer::Glow,
        ..NativeOptions::default()
    };
    let started = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&started);
    let create = move |creation: &CreationContext<'_>| {
        flag.store(true, Ordering::Relaxed);
        let mut window =
            Window { app: App::new(&creation.egui_ctx), desktop: Desktop::new(creation.egui_ctx.clone()) };
        if let Some(settings) = creation.storage.and_then(|storage| storage.get_string(SETTINGS)) {
            window.app.restore(&creation.egui_ctx, &settings);
        }
        if let Some(file) = file {
            window.app.open(&file, &mut window.desktop);
        }
        Ok(Box::new(window) as Box<dyn eframe::App>)
    };
    // The libraries below panic when a system library is missing; before the window exists that
    // is an answer, afterwards it is a fault of ours.
    let report = panic::take_hook();
    let before = Arc::clone(&started);
    panic::set_hook(Box::new(move |info| {
        if before.load(Ordering::Relaxed) {
            report(info);
        }
    }));
    let outcome =
        panic::catch_unwind(AssertUnwindSafe(|| eframe::run_native(TITLE, options, Box::new(create))));
    match outcome {
        Ok(Ok(())) => Ok(()),
        Ok(Err(error)) => Err(sentence(&format!("{error} {error:?}"))),
        Err(payload) if started.load(Ordering::Relaxed) => panic::resume_unwind(payload),
        Err(payload) => {
            let text = payload.downcast_ref::<String>().cloned();
            Err(sentence(
                &text.or_else(|| payload.downcast_ref::<&str>().map(ToString::to_string)).unwrap_or_default(),
            ))
        }
    }
}

/// System libraries as errors name them, and the Debian packages that hold them. The longer name
/// comes before the one it contains.
const LIBRARIES: [(&str, &str); 8] = [
    ("xkbcommon-x11", "libxkbcommon-x11-0"),
    ("xkbcommon", "libxkbcommon0"),
    ("X11-xcb", "libx11-xcb1"),
    ("Xcursor", "libxcursor1"),
    ("libXi", "libxi6"),
    ("libX11", "libx11-6"),
    ("libEGL", "libegl1"),
    ("libGL", "libgl1"),
];

/// Why the window cannot be opened, in one sentence.
fn sentence(error: &str) -> String {
    let lower = error.to_lowercase();
    let missing = LIBRARIES.iter().find(|(library, _)| lower.contains(&library.to_lowercase()));
    let no_display = std::env::var_os("DISPLAY").is_none() && std::env::var_os("WAYLAND_DISPLAY").is_none();
    match missing {
        _ if no_display => {
            "The window cannot be opened: there is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)."
                .to_owned()
        }
        Some((_, package)) => format!(
            "The window cannot be opened: a system library is missing; on Debian and Ubuntu, `sudo apt install {package}` installs it."
        ),
        None => format!(
            "The window cannot be opened: {}.",
            error.lines().next().unwrap_or("the reason is unknown").trim_end_matches('.')
        ),
    }
}
