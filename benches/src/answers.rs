//! What answers back: a question answered, goals looked at while a handle is dragged, a scene that shows a mistake made smaller.

use std::time::Instant;

use clipscope::{
    app::Command,
    labs::{Edit, Scene, polygons},
    lesson::{Course, SceneFormats},
};
use egui::{Event, Key, vec2};

use crate::{
    desk::{Desk, strike},
    harness::{Target, median, quantile},
};

/// Milliseconds: what a screen with 60 pictures a second leaves.
const FRAME: Target = Target::AtMost(16.0);
/// Milliseconds.
const SMALLER: Target = Target::AtMost(2_000.0);
const MOST_ASKED: usize = 60;
const N_DRAGGED: usize = 240;
/// The pointer goes round in this many frames.
const ROUND: f32 = 97.0;
/// Of a polygon that is made smaller.
const N_VERTICES: usize = 20;

/// Runs everything and prints the section.
pub fn run() {
    println!("## What answers back\n");
    println!("The app at 1280 × 720, layout and tessellation, milliseconds.\n");
    println!("| what | n | median | 95 % under | slowest | target | |");
    println!("|---|--:|--:|--:|--:|---|---|");
    for lab in ["lines", "polygons", "frustum", "surfaces"] {
        row(&format!("a question answered: {lab}"), &answered(lab), FRAME);
    }
    for (lesson, step) in goals() {
        for is_with_goal in [true, false] {
            let with = if is_with_goal { "with" } else { "without" };
            let took = dragged((&lesson, &step), is_with_goal);
            row(&format!("{lesson} {step}, dragged {with} its goal"), &took, FRAME);
        }
    }
    for mistake in ["faulty-on-border", "faulty-open", "faulty-end-first", "faulty-twice"] {
        row(&format!("{mistake}: {N_VERTICES} vertices made smaller"), &smaller(mistake), SMALLER);
    }
    println!();
}

fn row(name: &str, took: &[f64], target: Target) {
    let slowest = quantile(took.iter().copied(), 0.999_999);
    println!(
        "| {name} | {} | {:.2} | {:.2} | {slowest:.2} | {} |",
        took.len(),
        median(took.iter().copied()),
        quantile(took.iter().copied(), 0.95),
        target.cells(slowest),
    );
}

/// From the digit that answers to the picture of what comes.
fn answered(lab: &'static str) -> Vec<f64> {
    let mut desk = Desk::at("04-cutting-with-outcodes", "which-end-which-edge");
    desk.apply(Command::Lab(lab));
    desk.apply(Command::FIRST);
    desk.apply(Command::Practise);
    let mut took = Vec::new();
    while took.len() < MOST_ASKED && desk.app.is_asking() {
        let start = Instant::now();
        desk.frame(strike(Key::Num1));
        // The frame that takes the key may draw the old step.
        desk.frame(Vec::new());
        took.push(1e3 * start.elapsed().as_secs_f64());
        desk.apply(Command::Play);
    }
    assert!(!took.is_empty(), "{lab} asks nothing");
    took
}

/// Steps of the course that have a goal, one a lab of the plane.
fn goals() -> Vec<(String, String)> {
    let mut labs: Vec<&str> = Vec::new();
    let mut found = Vec::new();
    for lesson in Course::embedded().lessons {
        for step in lesson.steps.iter().filter(|step| step.goal.is_some()) {
            let lab = step.scene.document().lab().id;
            if ["lines", "polygons"].contains(&lab) && !labs.contains(&lab) {
                labs.push(lab);
                found.push((lesson.id.clone(), step.id.clone()));
            }
        }
    }
    found
}

/// Frames of a drag at a step, or of its scene where nothing is asked of it.
fn dragged((lesson, step): (&str, &str), is_with_goal: bool) -> Vec<f64> {
    let mut desk = Desk::at(lesson, step);
    if !is_with_goal {
        let scene: Scene = desk.app.scene().clone();
        desk.apply(Command::Lab(scene.document().lab().id));
        desk.apply(Command::Free);
        desk.apply(Command::Edit(Edit::Replace(scene), None));
    }
    let start = desk.first_handle();
    desk.grip(start);
    let took = (0..N_DRAGGED).map(|i| {
        let round = i as f32 / ROUND * std::f32::consts::TAU;
        let at = start + vec2(round.cos() - 1.0, round.sin()) * 40.0;
        1e3 * desk.frame(vec![Event::PointerMoved(at)]).both()
    });
    let took = took.collect();
    let at = desk.first_handle();
    desk.let_go(at);
    took
}

/// A polygon of many vertices on which a mistake shows, until nothing smaller is found.
fn smaller(mistake: &'static str) -> Vec<f64> {
    let ring = (0..N_VERTICES).map(|i| {
        let angle = i as f64 / N_VERTICES as f64 * std::f64::consts::TAU;
        let reach = if i % 2 == 0 { 5.37 } else { 3.71 };
        format!("[{:.3}, {:.3}]", reach * angle.cos(), reach * angle.sin())
    });
    // One on the border, so that a mistake about that shows.
    let ring: Vec<String> = ring.skip(1).chain(["[4, 0.25]".to_owned()]).collect();
    let text = format!(
        "method = \"{mistake}\"\ncompare = \"sutherland-hodgman\"\nwindow = [-4, -3, 4, 3]\npolygon = [{}]\n",
        ring.join(", ")
    );
    let read = SceneFormats::standard().read("", text.as_bytes());
    let scene: Scene = read.ok().expect("a scene of the polygons lab").scene;
    let mut desk = Desk::at("04-cutting-with-outcodes", "which-end-which-edge");
    desk.apply(Command::Lab(polygons::LAB.id));
    desk.apply(Command::Free);
    desk.apply(Command::Edit(Edit::Replace(scene), None));
    let before = desk.app.scene().document().size();
    let start = Instant::now();
    desk.change(Command::Smaller);
    while desk.app.is_making_smaller() {
        desk.frame(Vec::new());
    }
    let took = 1e3 * start.elapsed().as_secs_f64();
    assert!(desk.app.scene().document().size() < before, "{mistake} is not made smaller");
    vec![took]
}
