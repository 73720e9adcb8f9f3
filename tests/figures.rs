//! Pixel snapshots of every lesson figure. They are exact: the painter gives the same bytes everywhere.
//!
//! When a picture is meant to change, look at both (`target/figures/` holds the new one), then run
//! `CLIPSCOPE_BLESS=1 cargo test --test figures` to accept.
#![cfg(feature = "gui")]
#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot be set up should stop where it stands"
)]

use std::{
    collections::BTreeSet,
    env, fs,
    path::{Path, PathBuf},
};

use clipscope::{
    export::{Options, Steps, jobs},
    lesson::Course,
    paint::{Headless, ThemeKind},
    text::Lang,
};

/// A quarter of a slide along each side keeps some forty pictures under half a megabyte.
const SIZE_PX: [u32; 2] = [480, 270];

const OPTIONS: Options = Options {
    size_px: SIZE_PX,
    theme: ThemeKind::Light,
    lang: Lang::En,
    steps: Steps::Figures,
};

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

#[test]
fn every_figure_is_as_accepted() {
    let course = Course::embedded();
    let bless = env::var_os("CLIPSCOPE_BLESS").is_some();
    let (accepted, drawn) = (folder("tests/figures"), folder("target/figures"));
    let mut table = Headless::new(OPTIONS.theme);
    let mut changed = Vec::new();
    let mut known = BTreeSet::new();
    for job in jobs(&course.lessons, OPTIONS.steps) {
        let png = job.png(&mut table, &OPTIONS);
        let path = accepted.join(&job.path);
        known.insert(path.clone());
        if fs::read(&path).is_ok_and(|old| old == png) {
            continue;
        }
        let target = if bless { path } else { drawn.join(&job.path) };
        fs::create_dir_all(target.parent().unwrap()).unwrap();
        fs::write(target, png).unwrap();
        changed.push(job.path.clone());
    }
    for path in pictures_below(&accepted) {
        if !known.contains(&path) {
            if bless {
                fs::remove_file(&path).unwrap();
            }
            changed.push(format!("{} is no figure of the course", path.display()));
        }
    }
    assert!(
        bless || changed.is_empty(),
        "these figures differ from tests/figures; the new ones lie in target/figures: {changed:#?}"
    );
}

fn pictures_below(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else {
        return Vec::new();
    };
    entries
        .map(|entry| entry.unwrap().path())
        .flat_map(|path| {
            if path.is_dir() {
                pictures_below(&path)
            } else {
                vec![path]
            }
        })
        .collect()
}

#[test]
fn a_figure_is_the_same_whatever_was_drawn_before() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    let (first, last) = (&jobs[0], &jobs[jobs.len() - 1]);
    let fresh = last.png(&mut Headless::new(OPTIONS.theme), &OPTIONS);
    let mut table = Headless::new(ThemeKind::Dark);
    for theme in ThemeKind::ALL {
        for lang in Lang::ALL {
            let options = Options {
                theme,
                lang,
                ..OPTIONS
            };
            assert!(!first.png(&mut table, &options).is_empty());
        }
    }
    assert!(
        last.png(&mut table, &OPTIONS) == fresh,
        "{} depends on what was drawn before it",
        last.path
    );
}
