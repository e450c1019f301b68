//! The one binary: the window, and everything that works without one.

#[cfg(feature = "gui")]
mod desktop;
#[cfg(feature = "gui")]
mod window;

fn main() {
    let file = std::env::args().nth(1);
    #[cfg(feature = "gui")]
    if let Err(sentence) = window::open(file) {
        eprintln!("{sentence}");
    }
}
