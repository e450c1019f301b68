//! Clipping, frames and meshes against other crates: time and wrong answers, all in one run.
//!
//! The contenders take turns, round by round, so that a busy moment of the machine hits them all;
//! times are CPU time of this thread, and only ratios within one run count. Every answer is held
//! against an exact oracle in rational numbers or integers, for everybody alike.
//!
//! `./run` builds and runs it; `./run lines`, `./run polygons`, `./run frames` and `./run meshes [FILE.obj ..]` do a
//! part of it, `--rounds N` sets how often each contender runs. Without files the mesh is a built-in torus.

mod coverage;
mod exact;
mod frames;
mod lines;
mod measure;
mod meshes;
mod painter;
mod peers;
mod polygons;
mod random;

fn main() {
    let mut rounds = 41;
    let mut subjects = Vec::new();
    let mut files = Vec::new();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "lines" | "polygons" | "frames" | "meshes" => subjects.push(argument),
            "--rounds" => match arguments.next().and_then(|n| n.parse().ok()) {
                Some(n) if n > 0 => rounds = n,
                _ => usage(),
            },
            file if file.ends_with(".obj") => files.push(argument),
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
    if asked("meshes")
        && let Err(error) = meshes::run(rounds, &files)
    {
        eprintln!("{error}");
        std::process::exit(1)
    }
}

fn usage() -> ! {
    eprintln!("usage: run [lines] [polygons] [frames] [meshes [FILE.obj ..]] [--rounds N]");
    std::process::exit(2)
}
