//! Clipping and frames against other crates: time and wrong answers, all in one run.
//!
//! The contenders take turns, round by round, so that a busy moment of the machine hits them all;
//! times are CPU time of this thread, and only ratios within one run count. Every answer is held
//! against an exact oracle in rational numbers or integers, for everybody alike.
//!
//! `./run` builds and runs it; `./run lines`, `./run polygons` and `./run frames` do a part of it, `--rounds N` sets
//! how often each contender runs.

mod exact;
mod frames;
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
            "lines" | "polygons" | "frames" => subjects.push(argument),
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
    if asked("frames") {
        frames::run(rounds);
    }
}

fn usage() -> ! {
    eprintln!("usage: run [lines] [polygons] [frames] [--rounds N]");
    std::process::exit(2)
}
