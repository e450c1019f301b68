//! The window, and why it cannot be opened.

use crate::desktop::{APP_ID, Desktop};
use eframe::{
    CreationContext, NativeOptions, Renderer,
    egui::{Context, Ui, ViewportBuilder},
};
use rasterscope_core::message::{Message, Value};
use rasterscope_ui::App;
use std::{
    panic::{self, AssertUnwindSafe},
    path::PathBuf,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

const TITLE: &str = "Rasterscope";

struct Window {
    app: App,
    desktop: Desktop,
    ctx: Context,
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        self.app.ui(ui, &mut self.desktop);
    }

    fn on_exit(&mut self, _: Option<&eframe::glow::Context>) {
        self.app.keep(&self.ctx, &mut self.desktop);
    }

    fn persist_egui_memory(&self) -> bool {
        false
    }
}

/// Opens the window and returns when it is closed.
///
/// # Errors
/// Why there is no window; then nothing was shown.
pub(crate) fn open(file: Option<PathBuf>) -> Result<(), Message> {
    let options = NativeOptions {
        viewport: ViewportBuilder::default()
            .with_title(TITLE)
            .with_app_id(APP_ID)
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
        let ctx = creation.egui_ctx.clone();
        let mut window = Window { app: App::new(&ctx), desktop: Desktop::new(ctx.clone()), ctx: ctx.clone() };
        let file = file.as_ref().map(|file| file.to_string_lossy());
        window.app.start(&ctx, file.as_deref(), &mut window.desktop);
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
        Ok(Err(error)) => Err(why(&error.to_string(), &format!("{error:?}"))),
        Err(payload) if started.load(Ordering::Relaxed) => panic::resume_unwind(payload),
        Err(payload) => {
            let text = payload.downcast_ref::<String>().map(String::as_str);
            Err(why(text.or_else(|| payload.downcast_ref::<&str>().copied()).unwrap_or_default(), ""))
        }
    }
}

/// System libraries as errors name them, and the Debian packages that hold them. A longer name
/// comes before the one it contains.
const LIBRARIES: [(&str, &str); 8] = [
    ("xkbcommon-x11", "libxkbcommon-x11-0"),
    ("xkbcommon", "libxkbcommon0"),
    ("x11-xcb", "libx11-xcb1"),
    ("xcursor", "libxcursor1"),
    ("libxi", "libxi6"),
    ("libx11", "libx11-6"),
    ("libegl", "libegl1"),
    ("libgl", "libgl1"),
];

/// Why the window cannot be opened; `details` may name what `error` does not.
fn why(error: &str, details: &str) -> Message {
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let no_server = error.contains("connection to X server");
    if no_server || !is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY") {
        return Message::new("app-no-display");
    }
    if let Some(package) = package(error).or_else(|| package(details)) {
        return Message::new("app-missing-library").with("package", Value::text(package));
    }
    // The lines before say where in the source; the last part says what.
    let what = error.lines().next().and_then(|line| line.rsplit(": ").next()).unwrap_or_default();
    Message::new("app-no-window").with("reason", Value::text(what.trim_end_matches('.')))
}

/// The package that holds the library that an error names.
fn package(error: &str) -> Option<&'static str> {
    let error = error.to_lowercase();
    LIBRARIES.iter().find(|(library, _)| error.contains(library)).map(|(_, package)| *package)
}

#[cfg(test)]
mod tests {
    use super::package;

    #[test]
    fn a_missing_library_names_its_package() {
        for (error, expected) in [
            ("Library libxkbcommon-x11.so could not be loaded.", "libxkbcommon-x11-0"),
            ("Library libxkbcommon.so could not be loaded.", "libxkbcommon0"),
            ("failed to load one of xlib's shared libraries: libX11-xcb.so.1", "libx11-xcb1"),
            ("Failed to load libX11.so.6", "libx11-6"),
            ("libXcursor.so.1: cannot open shared object file", "libxcursor1"),
            ("libXi.so.6: cannot open shared object file", "libxi6"),
            ("Failed to find libGL.so.1", "libgl1"),
        ] {
            assert_eq!(package(error), Some(expected), "{error}");
        }
    }
}
