/// Colours and font sizes stand in one file, so that a theme is one file.
#[test]
fn no_other_file_makes_a_colour_or_names_a_font_size() {
    let mut folders = vec![std::path::PathBuf::from(env!("CARGO_MANIFEST_DIR"))];
    let mut seen = 0;
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).expect("the folder is there") {
            let path = entry.expect("it can be listed").path();
            if path.is_dir() {
                if !path.ends_with("tests") {
                    folders.push(path);
                }
                continue;
            }
            if path.extension().is_none_or(|ending| ending != "rs") || path.ends_with("theme.rs") {
                continue;
            }
            seen += 1;
            let text = std::fs::read_to_string(&path).expect("it is text");
            for word in [
                "Color32::from_",
                "from_rgb(",
                "FontId::proportional",
                "FontId::monospace",
                ".size(1",
                ".size(2",
            ] {
                assert!(!text.contains(word), "{}: {word}", path.display());
            }
        }
    }
    assert!(seen > 15, "only {seen} files were looked at");
}
