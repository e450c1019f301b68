//! The rules of the house that a compiler does not check.

use rasterscope_core::labs;
use std::{
    fs,
    path::{Path, PathBuf},
};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests stands in the workspace").to_path_buf()
}

/// Every file below `folder` with this ending: its path in the repository, and its text.
fn files(folder: &str, ending: &str) -> Vec<(String, String)> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("the folder is there") {
            let path = entry.expect("it can be listed").path();
            if path.is_dir() {
                if !path.ends_with("target") {
                    folders.push(path);
                }
            } else if path.to_string_lossy().ends_with(ending) {
                let name =
                    path.strip_prefix(root()).expect("it is below").to_string_lossy().replace('\\', "/");
                found.push((name, fs::read_to_string(&path).expect("it is text")));
            }
        }
    }
    found.sort();
    assert!(!found.is_empty(), "nothing in {folder}");
    found
}

fn all_rust() -> Vec<(String, String)> {
    files("src", ".rs").into_iter().chain(files("tests", ".rs")).collect()
}

#[test]
fn no_file_is_longer_than_400_lines() {
    let long: Vec<_> = all_rust()
        .into_iter()
        .map(|(name, text)| (text.lines().count(), name))
        .filter(|(lines, _)| *lines > 400)
        .collect();
    assert!(long.is_empty(), "split by meaning: {long:?}");
}

#[test]
fn every_algorithm_names_its_source() {
    let missing: Vec<_> = files("src/core", ".rs")
        .into_iter()
        .filter(|(_, text)| text.contains("pub enum Event {") && !text.contains("*Source:*"))
        .map(|(name, _)| name)
        .collect();
    assert!(missing.is_empty(), "no *Source:* in {missing:?}");
}

/// The README's sentences of absence.
#[test]
fn nothing_stands_where_it_must_be_absent() {
    let rules: [(&str, &[&str]); 4] = [
        (
            "src/core",
            &[
                "std::fs",
                "std::thread",
                "std::time",
                "println!",
                "static mut",
                "thread_local",
                "mul_add",
                "egui",
            ],
        ),
        ("src/figure", &["std::fs", "std::thread", "std::time", "println!", "egui"]),
        ("src/measure", &["std::fs", "std::thread", "std::time", "println!", "egui"]),
        ("src/ui", &["std::fs", "std::thread", "Instant", "SystemTime", "println!", "eframe::"]),
    ];
    for (folder, words) in rules {
        for (name, text) in files(folder, ".rs") {
            // The one exception, and only with the feature `parallel`.
            let threads = name == "src/core/engine/threads.rs";
            if threads || ["/examples/", "/benches/", "/tests/"].iter().any(|part| name.contains(part)) {
                continue;
            }
            for (number, line) in text.lines().enumerate() {
                let code = line.split("//").next().unwrap_or_default();
                for word in words {
                    assert!(!code.contains(word), "{name}:{}: {word}", number + 1);
                }
            }
        }
    }
}

#[test]
fn no_test_is_switched_off_and_nothing_is_left_undone() {
    for (name, text) in all_rust() {
        for word in ["#[ignore", "should_panic", "todo!(", "unimplemented!(", "dbg!("] {
            assert!(name.ends_with("house.rs") || !text.contains(word), "{name}: {word}");
        }
    }
}

/// Law 7: a registered lab has words, presets, golden logs and a file in the window.
#[test]
fn every_lab_is_whole() {
    let words: String = files("assets/i18n/en", ".ftl").into_iter().map(|(_, text)| text + "\n").collect();
    let presets = files("assets/scenes", ".json");
    for lab in labs::ALL {
        let name = lab.name;
        for id in [name.to_string(), format!("{name}-about")] {
            assert!(words.lines().any(|line| line.starts_with(&format!("{id} ="))), "no words for {id}");
        }
        let file = name.replace('-', "_");
        assert!(root().join(format!("src/ui/labs/{file}.rs")).exists(), "{name} has no lab in the window");
        if name == "pipeline" {
            continue; // every preset is one of its own; its steps are the z-buffer's
        }
        let tagged = format!("\"name\": \"{name}\"");
        let own = presets.iter().filter(|(_, text)| text.contains(&tagged)).count();
        assert!(own >= 5, "{name} has {own} presets");
        assert!(!files(&format!("tests/golden/{file}"), ".txt").is_empty());
    }
}
