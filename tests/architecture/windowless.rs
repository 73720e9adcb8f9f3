//! Tests of the pure half are compiled without the window as well.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::{GUI, PURE, modules_used, rust_files, src};

/// What a file of modules declares without asking for the window.
fn declared(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).unwrap();
    let mut is_gated = false;
    let mut found = Vec::new();
    for line in text.lines() {
        let name = line.trim_start_matches("pub ").strip_prefix("mod ");
        if let Some(name) = name.and_then(|name| name.strip_suffix(';'))
            && !is_gated
        {
            found.push(name.to_owned());
        }
        is_gated = line.starts_with("#[cfg(") && line.contains("\"gui\"");
    }
    found
}

fn files_under(folder: &Path, module: &str) -> Vec<PathBuf> {
    let (file, folder) = (folder.join(format!("{module}.rs")), folder.join(module));
    if file.is_file() {
        let rest = folder.is_dir().then(|| rust_files(&folder));
        return rest.into_iter().flatten().chain([file]).collect();
    }
    let inner = declared(&folder.join("mod.rs"));
    let inner = inner.iter().flat_map(|module| files_under(&folder, module));
    inner.chain([folder.join("mod.rs")]).collect()
}

#[test]
fn what_is_tested_without_the_window_names_nothing_of_it() {
    let tests = src().with_file_name("tests");
    let suites = declared(&tests.join("main.rs"));
    assert!(suites.len() > 10 && !suites.iter().any(|suite| suite == "figures"));
    let suites = suites.iter().filter(|suite| *suite != "architecture");
    let suites = suites.flat_map(|suite| files_under(&tests, suite));
    let own = PURE.iter().flat_map(|module| files_under(&src(), module));
    let mut n_files = 0;
    for file in suites.chain(own) {
        n_files += 1;
        let text = fs::read_to_string(&file).unwrap();
        let used = modules_used(&text.replace("clipscope::", "crate::"));
        let of_window = used.iter().find(|module| GUI.contains(module));
        assert_eq!(of_window, None, "{}", file.display());
        for word in ["use egui", "egui::", "eframe", "use resvg", "resvg::"] {
            assert!(!text.contains(word), "{}: {word}", file.display());
        }
    }
    assert!(n_files > 400, "{n_files}");
}
