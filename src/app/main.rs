//! The one binary: the window, and everything that works without one.
//!
//! Each command is one call of the cli crate; see its documentation for what they do.

mod arguments;
#[cfg(feature = "gui")]
mod desktop;
#[cfg(feature = "gui")]
mod window;

use arguments::Request;
use rasterscope_cli::{
    Failure, bench, compute, figure, files, list,
    tour::{self, TourOptions},
    trace,
};
use rasterscope_core::message::{Message, Value};
use rasterscope_figure::words::Words;
use std::{
    io::{self, IsTerminal as _, Write},
    path::{Path, PathBuf},
    process::ExitCode,
};

/// Where the tour goes when there is no window.
const TOUR: &str = "rasterscope-tour";

fn main() -> ExitCode {
    let words = Words::default();
    let request = arguments::read(&words);
    let output = &mut io::stdout().lock();
    let done = match request {
        Request::Window(file) => return open_window(file, &words),
        Request::ComputeFile(file) => compute::compute_file(&file, output),
        Request::Compute(lines) => compute::compute(&mut io::stdin().lock(), lines, output),
        Request::Trace(options) => trace::trace(&options, output),
        Request::Figure(options) => figure::figure(&options, &mut io::stderr()),
        Request::Animate(options, film) => {
            with_progress(|progress| figure::animate(&options, film, progress))
        }
        Request::Tour(options) => write_tour(&options).map(|_| ()),
        Request::Skips(options) => with_progress(|progress| bench::skips::skips(&options, output, progress)),
        Request::Bench(options) => with_progress(|progress| bench::bench(&options, output, progress)),
        Request::List => list::list(output),
    };
    finish(done)
}

fn finish(done: Result<(), Failure>) -> ExitCode {
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            tell(&failure.to_string());
            ExitCode::from(failure.exit_code())
        }
    }
}

fn write_tour(options: &TourOptions) -> Result<PathBuf, Failure> {
    with_progress(|progress| tour::tour(options, progress))
}

/// Does long work that tells its progress where someone can see it.
fn with_progress<T>(work: impl FnOnce(Option<&mut dyn Write>) -> T) -> T {
    let mut terminal = io::stderr();
    work(terminal.is_terminal().then_some(&mut terminal as &mut dyn Write))
}

/// Opens the window; without one it says why, and writes the tour instead.
fn open_window(file: Option<PathBuf>, words: &Words) -> ExitCode {
    if let Some(name) = file.as_deref().filter(|path| looks_like_a_command(path) && !files::exists(path)) {
        let message = Message::new("app-no-such-command").with("name", Value::text(name.display()));
        return finish(Err(Failure::usage(&message)));
    }
    #[cfg(feature = "gui")]
    let opened = window::open(file.clone());
    #[cfg(not(feature = "gui"))]
    let opened = Err::<(), _>(Message::new("app-no-gui"));
    let Err(why) = opened else { return ExitCode::SUCCESS };
    tell(&words.message(&why));
    finish(write_tour(&TourOptions { file, output: TOUR.into() }).map(|path| {
        tell(&words.message(&Message::new("app-tour-instead").with("path", Value::text(path.display()))));
    }))
}

/// Whether a FILE has neither an ending nor a folder, as no scene and no model does.
fn looks_like_a_command(path: &Path) -> bool {
    path.extension().is_none() && path.components().count() == 1
}

fn tell(sentence: &str) {
    // Nobody is left to tell if standard error is closed.
    let _ = writeln!(io::stderr(), "{sentence}");
}
