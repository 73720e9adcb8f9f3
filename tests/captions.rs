//! Every sentence of every step: in all languages, with its own numbers, and with nothing missing.
#![allow(
    clippy::unwrap_used,
    reason = "a test that cannot be set up should stop where it stands"
)]

use clipscope::{
    geom::{Polygon, Segment, Window},
    labs::{
        Lab, Scene,
        lines::{self, Method},
        polygons,
    },
    lesson::Course,
    text::{Catalog, Lang},
};

/// Segments that make every method say everything it can say.
const SEGMENTS: [[f64; 4]; 14] = [
    [-2.0, -1.0, 2.0, 1.5],
    [-0.5, -0.5, 0.5, 0.25],
    [-2.0, 1.5, 2.0, 2.5],
    [-2.0, 0.0, 0.0, 2.0],
    [-2.5, 0.0, 0.0, 2.5],
    [0.25, -2.0, 0.25, 2.0],
    [0.25, 1.5, 0.25, 3.0],
    [2.0, -1.0, 2.0, 1.0],
    [-2.0, 0.5, 2.0, 0.5],
    [0.0, 0.0, 2.0, 0.5],
    [0.0, 0.0, 0.0, 0.0],
    [2.0, 2.0, -2.0, -2.0],
    [-2.0, -2.0, 0.75, 2.0],
    [1.0, 3.0, 1.0, 1.0],
];

/// Polygons that make every method say everything it can say.
const OUTLINES: [&[[f64; 2]]; 9] = [
    &[[-2.0, -0.5], [0.5, -1.5], [1.5, 0.5], [0.0, 2.0]],
    &[[-0.5, -0.5], [0.5, -0.5], [0.0, 0.25]],
    &[[2.0, 2.0], [3.0, 2.0], [2.0, 3.0]],
    // Touching with a vertex, along an edge, around a corner.
    &[[-1.0, 0.5], [-2.0, 1.0], [-2.0, 0.0]],
    &[[-1.0, 0.0], [-1.0, 0.5], [-2.0, 0.0]],
    &[
        [-2.0, -2.0],
        [1.0, -2.0],
        [1.0, -1.0],
        [-1.0, -1.0],
        [-1.0, 1.0],
        [-2.0, 1.0],
    ],
    // Leaving from a vertex on the border, and coming in at one.
    &[[0.0, 0.0], [-1.0, 0.0], [-2.0, 0.5], [0.0, 0.5]],
    &[[0.0, 0.5], [-2.0, 0.5], [-1.0, 0.0], [0.0, 0.0]],
    // Concave: two pieces, and a bridge.
    &[
        [-0.5, -2.0],
        [0.5, -2.0],
        [0.5, 0.0],
        [0.25, 0.0],
        [0.0, -1.5],
        [-0.25, 0.0],
        [-0.5, 0.0],
    ],
];

fn polygon_scenes() -> Vec<Scene> {
    let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
    let triangle = Polygon::new(&[[0.0, -1.0], [1.0, 1.0], [-1.0, 0.5]]).unwrap();
    let mut scenes = Vec::new();
    for method in polygons::Method::all() {
        for outline in OUTLINES {
            let subject = Polygon::new(outline).unwrap();
            let scene = polygons::Scene::new(method, window, subject);
            for texture in polygons::Texture::ALL {
                scenes.push(
                    polygons::Scene {
                        texture,
                        ..scene.clone()
                    }
                    .into(),
                );
            }
            let clip = Some(triangle.clone());
            scenes.push(polygons::Scene { clip, ..scene }.into());
        }
    }
    scenes
}

fn scenes() -> Vec<Scene> {
    let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
    let mut scenes: Vec<Scene> = Method::all()
        .flat_map(|method| {
            SEGMENTS.map(|s| {
                let segment = Segment::try_from(s).unwrap();
                lines::Scene::new(method, window, vec![segment])
                    .unwrap()
                    .into()
            })
        })
        .collect();
    scenes.extend(polygon_scenes());
    let course = Course::embedded();
    for step in course.lessons.iter().flat_map(|lesson| &lesson.steps) {
        scenes.push((*step.scene).clone());
    }
    scenes
}

#[test]
fn nothing_that_is_said_is_missing_from_a_catalogue() {
    for scene in scenes() {
        for (card, run) in scene.methods().into_iter().zip(scene.record()) {
            for step in 0..=run.n_steps() {
                let frame = run.frame(step);
                for lang in Lang::ALL {
                    let catalog = Catalog::of(lang);
                    let mut said = vec![catalog.message(&frame.caption.decision)];
                    let formulas = frame.caption.arithmetic.iter();
                    said.extend(formulas.map(|f| catalog.formula(f)));
                    for row in frame.watch.iter().flat_map(|section| &section.rows) {
                        let values = row.cells.iter().flatten().chain(&row.note);
                        said.extend(values.chain([&row.name]).map(|v| catalog.value(v)));
                    }
                    let labels = frame.marks().iter().filter_map(|mark| mark.label.as_ref());
                    said.extend(labels.map(|label| catalog.value(&label.text)));
                    for text in said {
                        assert!(
                            !text.contains('⟦'),
                            "{lang} lacks {text} at step {step} of {} on {scene:?}",
                            card.id
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn every_method_has_its_pseudocode_in_every_language() {
    let cards = Lab::ALL.into_iter().flat_map(Lab::methods);
    for (card, lang) in cards.flat_map(|card| Lang::ALL.map(|lang| (card, lang))) {
        let catalog = Catalog::of(lang);
        for line in card.code {
            for key in [line.code, line.words, card.name_key] {
                assert!(!catalog.term(key).contains('⟦'), "{lang} lacks {key}");
            }
        }
    }
}

#[test]
fn every_step_has_a_line_of_pseudocode() {
    for scene in scenes() {
        for (card, run) in scene.methods().into_iter().zip(scene.record()) {
            for step in 1..=run.n_steps() {
                let line = run.frame(step).code_line;
                assert!(
                    line.is_some_and(|line| line < card.code.len()),
                    "step {step} of {} points at line {line:?}",
                    card.id
                );
            }
        }
    }
}

#[test]
fn decisions_carry_numbers_or_names_of_the_step() {
    // A decision without an argument says the same at every step: its arithmetic must carry the numbers.
    for scene in scenes() {
        for (card, run) in scene.methods().into_iter().zip(scene.record()) {
            for step in 1..=run.n_steps() {
                let caption = run.frame(step).caption;
                assert!(
                    !caption.decision.args.is_empty() || !caption.arithmetic.is_empty(),
                    "{} says nothing of step {step} of {}",
                    caption.decision.key,
                    card.id
                );
            }
        }
    }
}
