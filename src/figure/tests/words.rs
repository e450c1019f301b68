//! Every sentence is there, is used, and is whole: the language files against the source code.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use rasterscope_core::{
    labs::{self, Stage},
    raster,
    scene::PRESETS,
};
use rasterscope_figure::{
    figure::Font,
    glossary, text,
    words::{LANGUAGES, Words},
};

/// Beginnings of ids that several files share; all others begin with the name of their file.
const SHARED: [&str; 9] =
    ["error-", "column-", "row-", "word-", "stage-", "preset-", "marker-", "mistake-", "pixel-"];

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// All files under `folder` with that extension.
fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|own| own == extension) {
            found.push(path);
        }
    }
    found
}

/// The string literals of the program's own code, tests and examples left out.
fn literals() -> BTreeMap<String, PathBuf> {
    let mut all = BTreeMap::new();
    for path in files(&root().join("src"), "rs") {
        let aside = path.components().any(|part| {
            ["tests", "tests.rs", "benches", "examples"].iter().any(|name| part.as_os_str() == *name)
        });
        if !aside {
            let source = fs::read_to_string(&path).unwrap();
            let path = path.strip_prefix(root()).unwrap_or(&path);
            all.extend(strings(&source).into_iter().map(|literal| (literal, path.to_owned())));
        }
    }
    all
}

/// Contents of the string literals before the module of tests; escapes stay as they are.
fn strings(source: &str) -> Vec<String> {
    let code = source.split("#[cfg(test)]\nmod tests {").next().unwrap_or(source);
    let mut found = Vec::new();
    for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
        let line = line.replace("'\"'", "").replace("\\\"", "");
        found.extend(line.split('"').skip(1).step_by(2).map(str::to_owned));
    }
    found
}

fn is_id(text: &str) -> bool {
    let part =
        |part: &str| !part.is_empty() && part.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
    text.contains('-') && text.split('-').all(part)
}

#[test]
fn every_file_is_embedded_whole() {
    for language in LANGUAGES {
        let folder = root().join("assets/i18n").join(language.tag);
        let on_disk: BTreeSet<_> = files(&folder, "ftl")
            .iter()
            .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
            .collect();
        let embedded: BTreeSet<_> = language.files.iter().map(|(name, _)| (*name).to_owned()).collect();
        assert_eq!(on_disk, embedded, "the list in words.rs and the folder of {}", language.tag);
        for (name, source) in language.files {
            if let Err((_, errors)) = fluent_syntax::parser::parse(*source) {
                panic!("{}/{name}.ftl: {errors:?}", language.tag);
            }
        }
    }
}

#[test]
fn ids_are_unique_and_begin_with_the_name_of_their_file() {
    for language in LANGUAGES {
        let mut seen = BTreeMap::new();
        for (file, id) in Words::new(language.tag).ids() {
            assert_eq!(seen.insert(id, file), None, "{id} stands twice in {}", language.tag);
            let own = id.strip_prefix(file).is_some_and(|rest| rest.is_empty() || rest.starts_with('-'));
            assert!(own || SHARED.iter().any(|shared| id.starts_with(shared)), "{id} in {file}.ftl");
        }
    }
}

#[test]
fn every_language_says_everything() {
    let ids = |tag: &str| Words::new(tag).ids().into_iter().map(|(_, id)| id).collect::<BTreeSet<_>>();
    for language in &LANGUAGES[1..] {
        assert_eq!(ids(LANGUAGES[0].tag), ids(language.tag), "{}", language.tag);
    }
}

#[test]
fn no_message_is_missing() {
    let words = Words::default();
    let is_preset = |name: &str| PRESETS.iter().any(|preset| preset.name == name);
    let of_bench: BTreeSet<_> = words.ids().into_iter().filter_map(|(_, id)| name_in_bench(id)).collect();
    let files: BTreeSet<_> = words.ids().into_iter().map(|(file, _)| format!("{file}-")).collect();
    let missing: Vec<_> = literals()
        .into_iter()
        .filter(|(literal, _)| is_id(literal) && !words.has(literal) && !is_preset(literal))
        .filter(|(literal, _)| !of_bench.contains(literal.as_str()))
        .filter(|(literal, _)| {
            let begins = |prefix: &str| literal.starts_with(prefix);
            SHARED.iter().any(|prefix| begins(prefix)) || files.iter().any(|prefix| begins(prefix))
        })
        .collect();
    assert!(missing.is_empty(), "used in code, but in no language file: {missing:#?}");
}

/// The name in an id that the benchmark puts together from a kind and a name.
fn name_in_bench(id: &str) -> Option<&str> {
    let kinds = [
        "stage",
        "family",
        "item",
        "call",
        "column",
        "verdict",
        "claim",
        "short-claim",
        "series",
        "curve",
        "guide",
        "algorithm",
        "error",
        "short-error",
        "growing",
        "method",
        "axis",
        "x",
        "y",
    ];
    let name = kinds.iter().find_map(|kind| id.strip_prefix(&format!("bench-{kind}-")))?;
    Some(name.strip_suffix("-here").unwrap_or(name))
}

/// Everything whose title is its name and whose sentence is `NAME-about`.
fn named() -> Vec<&'static str> {
    let labs = labs::ALL.iter().map(|lab| lab.name);
    labs.chain(raster::Algorithm::ALL.map(raster::Algorithm::name)).collect()
}

#[test]
fn presets_and_labs_have_their_words() {
    let words = Words::default();
    for name in named() {
        assert!(words.has(name) && words.has(&format!("{name}-about")), "{name}");
    }
    for path in files(&root().join("assets/scenes"), "json") {
        let scene = fs::read_to_string(&path).unwrap();
        for id in scene.split('"').filter(|text| is_id(text) && text.starts_with("preset-")) {
            assert!(words.has(id), "{id} in {}", path.display());
        }
    }
}

#[test]
fn no_message_is_unused() {
    let literals = literals();
    let scenes: String = files(&root().join("assets/scenes"), "json")
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect();
    let sources: String = LANGUAGES[0].files.iter().map(|(_, source)| *source).collect();
    let of_lab = |id: &str| named().contains(&id.strip_suffix("-about").unwrap_or(id));
    // The tour puts these together from the stage's name.
    let of_stage = |id: &str| {
        let stage = id.strip_prefix("tour-about-").or_else(|| id.strip_prefix("tour-off-"));
        stage.is_some_and(|name| Stage::ALL.iter().any(|stage| stage.word().ends_with(name)))
    };
    let terms: BTreeSet<_> = literals.keys().map(|literal| glossary::id(literal)).collect();
    let unused: Vec<_> = Words::default()
        .ids()
        .into_iter()
        .filter(|(_, id)| {
            !literals.contains_key(*id)
                && !of_lab(id)
                && !of_stage(id)
                && !name_in_bench(id).is_some_and(|name| literals.contains_key(name))
                && !terms.contains(*id)
                && !scenes.contains(&format!("\"{id}\""))
                && !sources.contains(&format!("{{ {id} }}"))
        })
        .collect();
    assert!(unused.is_empty(), "in a language file, but used nowhere: {unused:#?}");
}

#[test]
fn no_sentence_lacks_a_glyph() {
    for language in LANGUAGES {
        for (name, source) in language.files {
            let text: String = source.chars().filter(|c| !c.is_control()).collect();
            assert_eq!(text::layout(Font::Sans, 14.0, &text).missing, [], "{}/{name}.ftl", language.tag);
        }
    }
}

#[test]
fn literals_are_found_as_they_stand() {
    let source =
        "// \"not-this\"\nf(\"a-b\", '\"', \"c \\\" d\"); /// x\n#[cfg(test)]\nmod tests {\n\"nor-this\"";
    assert_eq!(strings(source), ["a-b", "c  d"]);
    assert!(is_id("error-no-lab") && !is_id("error") && !is_id("a--b") && !is_id("Top-left"));
}
