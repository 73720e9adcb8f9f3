//! Pixel snapshots of every lesson figure. They are exact: the painter gives the same bytes everywhere.
//!
//! When a picture is meant to change, look at both (`target/figures/` holds the accepted one, the new one and their
//! difference), then run
//! `CLIPSCOPE_BLESS=1 cargo test --test all figures::` to accept.

use std::collections::BTreeMap;

use clipscope::{
    export::{Options, Steps, Studio, Way, jobs},
    lesson::Course,
    paint::ThemeKind,
    text::Lang,
};

use crate::shared::pictures::Pictures;

/// A quarter of a slide along each side keeps some forty pictures under half a megabyte.
const SIZE_PX: [u32; 2] = [480, 270];

const OPTIONS: Options = Options {
    size_px: SIZE_PX,
    theme: ThemeKind::Light,
    lang: Lang::En,
    steps: Steps::Figures,
    asks: false,
};

#[test]
fn every_figure_is_as_accepted() {
    let course = Course::embedded();
    let mut studio = Studio::new(OPTIONS.theme);
    let mut pictures = Pictures::of("figures");
    for job in jobs(&course.lessons, OPTIONS.steps) {
        pictures.check(&job.path, &job.bytes(&mut studio, Way::of(OPTIONS)));
    }
    pictures.finish();
}

#[test]
fn a_figure_is_the_same_whatever_was_drawn_before() {
    let course = Course::embedded();
    let jobs = jobs(&course.lessons, Steps::Figures);
    let (first, last) = (&jobs[0], &jobs[jobs.len() - 1]);
    let fresh = last.bytes(&mut Studio::new(OPTIONS.theme), Way::of(OPTIONS));
    let mut studio = Studio::new(ThemeKind::Dark);
    for theme in ThemeKind::ALL {
        for lang in Lang::ALL {
            let options = Options {
                theme,
                lang,
                ..OPTIONS
            };
            assert!(!first.bytes(&mut studio, Way::of(options)).is_empty());
        }
    }
    assert!(
        last.bytes(&mut studio, Way::of(OPTIONS)) == fresh,
        "{} depends on what was drawn before it",
        last.path
    );
}

/// Between the title and the sentence of a quarter-size figure, in rows of pixels.
const BODY: std::ops::Range<usize> = 34..212;

#[test]
fn no_two_figures_show_the_same() {
    let course = Course::embedded();
    let mut studio = Studio::new(OPTIONS.theme);
    let mut known: BTreeMap<Vec<u8>, String> = BTreeMap::new();
    let mut alike = Vec::new();
    for job in jobs(&course.lessons, OPTIONS.steps) {
        let image = studio.draw(&job.picture(OPTIONS));
        let row = 4 * SIZE_PX[0] as usize;
        let body = image.rgba[BODY.start * row..BODY.end * row].to_vec();
        if let Some(first) = known.insert(body, job.path.clone()) {
            alike.push([first, job.path]);
        }
    }
    assert!(alike.is_empty(), "{alike:#?}");
}
