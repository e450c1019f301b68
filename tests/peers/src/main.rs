//! Clipping against other crates: time and wrong answers, all in one run.
//!
//! The contenders take turns, round by round, so that a busy moment of the machine hits them all;
//! times are CPU time of this thread, and only ratios within one run count. Every answer is held
//! against an exact oracle in rational numbers, for everybody alike.
//!
//! `./run` builds and runs it; `./run lines` and `./run polygons` do half of it, `--rounds N` sets
//! how often each contender runs.

mod exact;
mod lines;
mod measure;
mod peers;
mod polygons;
mod random;

fn main() {
    let mut rounds = 41;
    let mut subjects = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "lines" | "polygons" => subjects.push(argument),
            "--rounds" => match arguments.next().and_then(|n| n.parse().ok()) {
                Some(n) if n > 0 => rounds = n,
                _ => usage(),
            },
            _ => usage(),
        }
    }
    let asked = |subject: &str| subjects.is_empty() || subjects.iter().any(|s| s == subject);
    if asked("lines") {
        lines::run(rounds);
    }
    if asked("polygons") {
        polygons::run(rounds);
    }
}

fn usage() -> ! {
    eprintln!("usage: run [lines] [polygons] [--rounds N]");
    std::process::exit(2)
}
