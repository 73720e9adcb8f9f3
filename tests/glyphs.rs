//! Every character that can be shown has a glyph: no boxes.
//!
//! When this fails, run `assets/fonts/make.sh`; if it still fails, no font of ours has the
//! character.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use clipscope::paint::fonts::{definitions, semibold};
use egui::epaint::text::{Fonts, TextOptions};
use egui::{FontFamily, FontId};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Folders and the endings of the files that hold shown text, as `make.py` reads them.
const TEXTS: [(&str, &str); 5] = [
    ("assets/messages", "ftl"),
    ("assets/glossary", "toml"),
    ("lessons", "md"),
    ("lessons", "toml"),
    ("src", "rs"),
];

/// All files below a folder with an ending; none if there is no such folder.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    for path in entries.filter_map(Result::ok).map(|entry| entry.path()) {
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.extension().is_some_and(|e| e == ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The text of a file that can be shown: of source code, all but whole lines of comment.
fn shown_text(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a text file in UTF-8");
    let is_code = path.extension().is_some_and(|e| e == "rs");
    let lines = text.lines();
    let shown = lines.filter(|line| !(is_code && line.trim_start().starts_with("//")));
    shown.collect()
}

/// The characters of a text that at least one of our families cannot show.
fn missing(fonts: &mut Fonts, text: &str) -> BTreeSet<char> {
    let families = [FontFamily::Proportional, semibold(), FontFamily::Monospace];
    let ids = families.map(|family| FontId::new(13.0, family));
    let mut characters: BTreeSet<char> = text.chars().filter(|c| !c.is_control()).collect();
    characters.retain(|&c| !ids.iter().all(|id| fonts.has_glyph(id, c)));
    characters
}

#[test]
fn every_character_has_a_glyph() {
    let root = Path::new(ROOT);
    let mut fonts = Fonts::new(TextOptions::default(), definitions());
    let mut paths = vec![root.join("assets/fonts/extra-chars.txt")];
    for (folder, ending) in TEXTS {
        paths.extend(files(&root.join(folder), ending));
    }
    let mut faults = Vec::new();
    for path in paths {
        for c in missing(&mut fonts, &shown_text(&path)) {
            let name = path.strip_prefix(root).unwrap_or(&path).display();
            faults.push(format!("{name}: {c} U+{:04X}", u32::from(c)));
        }
    }
    assert!(
        faults.is_empty(),
        "without a glyph (run assets/fonts/make.sh):\n  {}",
        faults.join("\n  ")
    );
}

#[test]
fn western_languages_and_signs_are_complete() {
    let mut fonts = Fonts::new(TextOptions::default(), definitions());
    let latin: String = (' '..='~').chain('\u{a0}'..='ÿ').collect();
    assert_eq!(missing(&mut fonts, &latin), BTreeSet::new());
}

#[test]
fn a_missing_character_is_noticed() {
    let mut fonts = Fonts::new(TextOptions::default(), definitions());
    // Linear B will not be needed.
    assert_eq!(missing(&mut fonts, "a\u{10000}").len(), 1);
}
