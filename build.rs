//! `include_dir!` embeds the course but cannot tell cargo, on stable Rust, that a lesson was added or
//! removed: cargo watches the folder instead, and builds the library again when anything in it changes.

use std::{env, fs, io, path::Path};

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=lessons");
    match (env::var_os("CARGO_FEATURE_SLIM"), env::var_os("OUT_DIR")) {
        (Some(_), Some(out)) => slim(&Path::new(&out).join("lessons")),
        _ => Ok(()),
    }
}

/// The course without what a page fetches: other languages than English.
fn slim(to: &Path) -> io::Result<()> {
    if to.exists() {
        fs::remove_dir_all(to)?;
    }
    for lesson in fs::read_dir("lessons")? {
        let lesson = lesson?;
        let folder = to.join(lesson.file_name());
        if !lesson.file_type()?.is_dir() {
            continue;
        }
        fs::create_dir_all(&folder)?;
        for file in fs::read_dir(lesson.path())? {
            let file = file?.path();
            let name = file.file_name().unwrap_or_default();
            let is_text = file.extension().is_some_and(|it| it == "md");
            if name != "translated.toml" && (name == "en.md" || !is_text) {
                fs::copy(&file, folder.join(name))?;
            }
        }
    }
    Ok(())
}
