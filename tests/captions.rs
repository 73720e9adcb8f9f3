//! Every sentence of every step: in all languages, with its own numbers, and with nothing missing.

use std::{collections::HashSet, ops::ControlFlow};

use clipscope::{
    algo::surface::{DepthBits, DepthNumber, DepthSteps},
    figure::{Frame, Run, notation, said},
    geom::{Polygon, Segment, Window},
    labs::{
        Change, LABS, MethodCard, Scene, frustum,
        lines::{self, Method},
        polygons, space, surfaces,
    },
    lesson::Course,
    text::{Catalog, Lang, Notation},
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

/// What stands everywhere that something can stand, for every method and both kinds of cameras.
fn frustum_scenes() -> Vec<Scene> {
    let mut scenes = Vec::new();
    for method in frustum::FRUSTUM.all() {
        for is_parallel in [false, true] {
            for point in [[0.0, 1.0, 0.0], [0.0, 2.0, 6.0], [9.0, 9.0, 9.0]] {
                let mut scene = frustum::first_scene();
                scene.method = method;
                let places = scene.places();
                scene.set_places(space::Places { point, ..places }).unwrap();
                scene.look_at(space::Part::Object, 2).unwrap();
                let mut scene: Scene = scene.into();
                let turned = space::SpaceChange::Parallel(is_parallel);
                Change::apply(&turned, &mut scene).unwrap();
                scenes.push(scene);
            }
        }
    }
    scenes
}

/// Every method, both kinds of cameras; depths rounded, reversed, one pixel looked at; coarse, so that runs are short.
fn surface_scenes() -> Vec<Scene> {
    let bits = DepthBits::new(8).map(DepthNumber::Fixed).unwrap();
    let mut scenes = Vec::new();
    for method in surfaces::SURFACES.all() {
        for (i, is_parallel) in [false, true].into_iter().enumerate() {
            for steps in [
                DepthSteps::Fragments,
                DepthSteps::Spans,
                DepthSteps::Triangles,
            ] {
                let mut scene = surfaces::first_scene();
                scene.method = method;
                scene.raster = scene.raster.with_rows(4);
                scene.raster.steps = steps;
                scene.raster.format.is_reversed = is_parallel;
                if steps != DepthSteps::Fragments {
                    scene.raster.format.number = bits;
                    scene.raster.pixel = Some([3, 2 - i as u32]);
                }
                let mut scene: Scene = scene.into();
                let turned = space::SpaceChange::Parallel(is_parallel);
                Change::apply(&turned, &mut scene).unwrap();
                scenes.push(scene);
            }
        }
    }
    scenes
}

/// Scenes that make every method say everything it can say, and those of the course.
pub fn scenes() -> Vec<Scene> {
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
    scenes.extend(frustum_scenes());
    scenes.extend(surface_scenes());
    let course = Course::embedded();
    for step in course.lessons.iter().flat_map(|lesson| &lesson.steps) {
        scenes.push((*step.scene).clone());
    }
    scenes
}

/// The runs of the methods on stage.
pub fn record(scene: &Scene) -> Vec<(&'static MethodCard, Box<dyn Run>)> {
    let document = scene.document();
    document
        .methods()
        .into_iter()
        .zip(document.record())
        .collect()
}

/// A sentence that differs from another in its numbers alone is said in English only: the others have the same variables.
#[test]
fn nothing_that_is_said_is_missing_from_a_catalogue() {
    let mut known = HashSet::new();
    for scene in scenes() {
        for (card, run) in record(&scene) {
            let look = |step: usize, frame: Frame| {
                let is_whole = |lang: Lang, texts: &[String]| {
                    let lacks = texts.iter().find(|text| text.contains('⟦'));
                    let card = card.id;
                    assert_eq!(lacks, None, "{lang}, step {step} of {card} on {scene:?}");
                };
                let english = texts(&frame, Catalog::of(Lang::En));
                is_whole(Lang::En, &english);
                let before = known.len();
                known.extend(english.iter().map(|text| words(text)));
                let others = Lang::ALL.into_iter().filter(|lang| *lang != Lang::En);
                for lang in others.filter(|_| known.len() > before) {
                    is_whole(lang, &texts(&frame, Catalog::of(lang)));
                }
            };
            run.frames([0, run.n_steps()], |_| true, look);
        }
    }
    assert!(known.len() > 1000, "{}", known.len());
}

/// A text without its numbers and signs.
fn words(text: &str) -> String {
    text.chars().filter(|c| c.is_alphabetic()).collect()
}

/// All that a frame says.
fn texts(frame: &Frame, catalog: &Catalog) -> Vec<String> {
    let mut said = vec![catalog.message(&frame.caption.decision)];
    let formulas = frame.caption.arithmetic.iter();
    said.extend(formulas.map(|f| catalog.formula(f)));
    for row in frame.watch.iter().flat_map(|section| &section.rows) {
        let values = row.cells.iter().flatten().chain(&row.note);
        said.extend(values.chain([&row.name]).map(|v| catalog.value(v)));
    }
    let of_views = frame.views.iter().flat_map(|view| view.body.said());
    said.extend(of_views.map(|it| it.text(catalog)));
    said
}

/// A reader compares the numbers of a picture: 3/4 and 1.25 do not stand beside each other.
#[test]
fn numbers_of_one_picture_are_all_fractions_or_all_decimals() {
    let [mut n_fractions, mut n_decimals] = [0, 0];
    let steps = Course::embedded().lessons.into_iter();
    for step in steps.flat_map(|lesson| lesson.steps) {
        for (card, run) in record(&step.scene) {
            let every = (run.n_steps() / 40).max(1);
            for k in (0..=run.n_steps()).step_by(every) {
                let frame = run.frame(k);
                let catalog = Catalog::of(Lang::En).alike(notation(Notation::Own, [&frame]));
                let all = said(&frame.views, &frame.caption);
                let texts: Vec<String> = all.into_iter().map(|it| it.text(catalog)).collect();
                let with = |mark| texts.iter().find(|text| has_between_digits(text, mark));
                let [fraction, decimal] = ['/', '.'].map(with);
                n_fractions += usize::from(fraction.is_some());
                n_decimals += usize::from(decimal.is_some());
                let mixed = fraction.zip(decimal);
                assert!(
                    mixed.is_none(),
                    "{}, {k} of {}: {mixed:?}",
                    step.id,
                    card.id
                );
            }
        }
    }
    assert!(
        n_fractions > 100 && n_decimals > 100,
        "{n_fractions}, {n_decimals}"
    );
}

fn has_between_digits(text: &str, mark: char) -> bool {
    let characters: Vec<char> = text.chars().collect();
    let is_one = |around: &[char]| {
        around[1] == mark && around[0].is_ascii_digit() && around[2].is_ascii_digit()
    };
    characters.windows(3).any(is_one)
}

#[test]
fn every_method_has_its_pseudocode_in_every_language() {
    let cards = LABS.into_iter().flat_map(|lab| (lab.methods)());
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
        for (card, run) in record(&scene) {
            for step in 1..=run.n_steps() {
                let line = run.code_line(step);
                assert!(
                    line.is_some_and(|line| line < card.code.len()),
                    "step {step} of {} points at line {line:?}",
                    card.id
                );
            }
        }
    }
}

/// Ends of a run that name both polygons, and of which there is no number to say.
const POLYGONS_NAMED: [&str; 5] = [
    "wa-done-disjoint",
    "wa-done-touching",
    "wa-done-subject",
    "wa-done-clip",
    "wa-done-equal",
];

#[test]
fn decisions_carry_numbers_or_names_of_the_step() {
    // A decision without an argument says the same at every step: its arithmetic must carry the numbers.
    for scene in scenes() {
        for (card, run) in record(&scene) {
            run.visit([1, run.n_steps()], &mut |step, shown| {
                let caption = shown.caption();
                let names_both = POLYGONS_NAMED.contains(&caption.decision.key);
                assert!(
                    names_both
                        || !caption.decision.args.is_empty()
                        || !caption.arithmetic.is_empty(),
                    "{} says nothing of step {step} of {}",
                    caption.decision.key,
                    card.id
                );
                ControlFlow::Continue(())
            });
        }
    }
}
