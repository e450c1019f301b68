//! Text files that a reviewer reads; `UPDATE_GOLDEN=1` rewrites them.

use std::{fmt::Debug, fs, path::PathBuf};

/// Compares `actual` with `tests/golden/NAME.txt`.
#[track_caller]
pub(crate) fn check_golden(name: &str, actual: &str) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("golden").join(format!("{name}.txt"));
    if std::env::var_os("UPDATE_GOLDEN").is_some() {
        fs::create_dir_all(path.parent().expect("it has a folder")).expect("the folder can be made");
        fs::write(&path, actual).expect("the golden file can be written");
        return;
    }
    let expected = fs::read_to_string(&path).unwrap_or_default();
    assert!(
        expected.replace("\r\n", "\n") == actual,
        "{name} differs; got:\n{actual}\nIf right, run with UPDATE_GOLDEN=1"
    );
}

/// One line per event.
pub(crate) fn log_text<E: Debug>(events: &[E]) -> String {
    events.iter().map(|event| format!("{event:?}\n")).collect()
}
