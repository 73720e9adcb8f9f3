//! One figure, drawn and packed: what `export` spends its time on.

use std::{hint::black_box, time::Instant};

use clipscope::{
    export::{Options, Picture, Steps, Studio},
    labs::Scene,
    lesson::{Course, LessonStep},
    paint::ThemeKind,
    text::Lang,
};

use crate::{export::SIZE_PX, harness::median};

/// Rounds over the whole course.
const N_ROUNDS: usize = 5;

/// Runs everything and prints the section.
pub fn run() {
    let course = Course::embedded();
    let steps: Vec<&LessonStep> = course.lessons.iter().flat_map(|l| &l.steps).collect();
    let [mut new, mut drawn, mut packed] = [const { Vec::new() }; 3];
    let mut n_bytes = Vec::new();
    for _ in 0..N_ROUNDS {
        let (secs, mut studio) = timed(|| Studio::new(ThemeKind::Light));
        new.push(secs);
        for step in &steps {
            let (secs, image) =
                timed(|| studio.draw(&picture(&step.scene, step.position().unwrap_or_default())));
            drawn.push(secs);
            let (secs, png) = timed(|| image.to_png());
            packed.push(secs);
            n_bytes.push(png.len() as f64);
        }
    }
    let [width, height] = SIZE_PX;
    println!("## A figure, painted on the CPU\n");
    println!(
        "{width} × {height}, light, one thread; medians over the {} steps of the course, {N_ROUNDS} times.\n",
        steps.len()
    );
    println!("| what | ms |\n|---|--:|");
    let row = |name: &str, secs: Vec<f64>| println!("| {name} | {:.1} |", 1e3 * median(secs));
    row("a new drawing table: fonts, theme, an empty picture", new);
    row("a figure, from trace to pixels", drawn);
    let kilobytes = 1e-3 * median(n_bytes);
    row(&format!("its PNG, {kilobytes:.0} kB"), packed);
    println!();
}

fn picture(scene: &Scene, step: usize) -> Picture<'_> {
    Picture {
        scene,
        lesson: None,
        step,
        before: None,
        foot: None,
        options: Options {
            lang: Lang::En,
            theme: ThemeKind::Light,
            size_px: SIZE_PX,
            steps: Steps::Figures,
            asks: false,
        },
        title: None,
    }
}

fn timed<T>(work: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let made = black_box(work());
    (start.elapsed().as_secs_f64(), made)
}
