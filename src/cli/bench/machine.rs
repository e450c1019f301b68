//! Where the numbers are made.

use rasterscope_measure::Machine;
use std::{path::Path, thread};

use crate::files;

/// This machine and this build.
pub fn machine() -> Machine {
    Machine {
        processor: processor().unwrap_or_default(),
        processors: thread::available_parallelism().map_or(1, usize::from),
        system: std::env::consts::OS,
        architecture: std::env::consts::ARCH,
        version: env!("CARGO_PKG_VERSION"),
        build: if cfg!(debug_assertions) { "debug" } else { "release" },
        vectors: vectors(),
    }
}

/// Its name, where the system tells it in a file.
fn processor() -> Option<String> {
    let bytes = files::read(Path::new("/proc/cpuinfo")).ok()?;
    let all = String::from_utf8_lossy(&bytes);
    let line = all.lines().find(|line| line.starts_with("model name"))?;
    Some(line.split_once(':')?.1.trim().to_string())
}

fn vectors() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "avx512"
    } else if cfg!(target_feature = "avx2") {
        "avx2"
    } else if cfg!(target_feature = "sse2") {
        "sse2"
    } else if cfg!(target_feature = "neon") {
        "neon"
    } else {
        ""
    }
}
