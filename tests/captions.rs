//! Every sentence of every step: in all languages, with its own numbers, and with nothing missing.

use std::ops::ControlFlow;

use clipscope::{
    algo::surface::{DepthBits, DepthNumber, DepthSteps},
    figure::{Body, Graph, Products, Run, Story},
    geom::{Polygon, Segment, Window},
    labs::{
        Change, LABS, MethodCard, Scene, frustum,
        lines::{self, Method},
        polygons, space, surfaces,
    },
    lesson::Course,
    text::{Catalog, Lang, Value},
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

/// Every text of a view.
fn said_in(body: &Body, catalog: &Catalog) -> Vec<String> {
    let value = |value: &Value| catalog.value(value);
    match body {
        Body::Plane(marks) => {
            let labels = marks.iter().filter_map(|mark| mark.label.as_ref());
            labels.map(|label| value(&label.text)).collect()
        }
        Body::Space(space) => {
            let labels = space.marks.iter().filter_map(|mark| mark.label.as_ref());
            let labels = labels.map(|label| &label.text);
            labels.chain(&space.title).map(value).collect()
        }
        Body::Raster(raster) => {
            let stored = raster
                .pixels
                .iter()
                .filter_map(|pixel| pixel.value.as_ref());
            stored.chain([&raster.title]).map(value).collect()
        }
        Body::Bits(bits) => {
            let rows = bits.rows.iter().chain(&bits.result);
            let names = bits.columns.iter().chain(rows.map(|row| &row.name));
            let note = bits.note.iter().map(|note| catalog.message(note));
            names.map(value).chain(note).collect()
        }
        Body::Table(table) => {
            let header = table.header.iter().map(|head| catalog.formula(head));
            let values = table.rows.iter().flat_map(|row| {
                let cells = row.cells.iter().filter_map(|cell| cell.value.as_ref());
                std::iter::once(&row.name).chain(cells)
            });
            let notes = table.notes.iter().map(|note| catalog.message(&note.text));
            header.chain(values.map(value)).chain(notes).collect()
        }
        Body::Matrix(product) => {
            let names = product.notes.iter().chain(&product.into);
            let names = names.chain([&product.name, &product.from]).map(value);
            let sums = product.rows.iter().filter_map(|row| row.sum.as_ref());
            let sums = sums.chain(&product.operator);
            names.chain(sums.map(|sum| catalog.formula(sum))).collect()
        }
        Body::Spaces(row) => {
            let cells = row.cells.iter();
            let cells = cells.flat_map(|cell| [&cell.name].into_iter().chain(&cell.place));
            cells.chain(&row.arrows).map(value).collect()
        }
        Body::Costs(costs) => costs.names.iter().map(value).collect(),
        Body::Story(story) => said_in_story(story, catalog),
        Body::Graph(graph) => said_in_graph(graph, catalog),
        Body::Lists(lists) => {
            let entries = lists.lists.iter().flat_map(|list| &list.entries);
            let values = entries.flat_map(|entry| {
                let details = entry.details.iter().flatten();
                std::iter::once(&entry.name).chain(details)
            });
            let titles = lists.lists.iter();
            let titles = titles.flat_map(|list| std::iter::once(&list.title).chain(&list.columns));
            titles.chain(values).map(value).collect()
        }
        Body::Products(products) => said_in_products(products, catalog),
        Body::NumberLine(line) => line.ticks.iter().map(|tick| value(&tick.name)).collect(),
        Body::Gauges(gauges) => {
            let names = gauges.rows.iter().map(|row| value(&row.name));
            let verdicts = gauges.rows.iter().filter_map(|row| row.verdict.as_ref());
            let said = verdicts.chain(&gauges.sides).chain([&gauges.title]);
            names
                .chain(said.map(|said| catalog.message(said)))
                .collect()
        }
        Body::Ribbon(ribbon) => {
            let said = ribbon.stages.iter();
            let said = said.flat_map(|stage| [&stage.title, &stage.counts]);
            said.map(|said| catalog.message(said)).collect()
        }
        Body::Multiples(multiples) => {
            let said = multiples.drawings.iter().flat_map(|drawing| {
                let labels = drawing.marks.iter().filter_map(|mark| mark.label.as_ref());
                let note = drawing.note.iter().map(|(_, note)| note);
                let labels = labels.map(|label| &label.text).chain(note);
                labels.chain([&drawing.title])
            });
            said.map(value).collect()
        }
        Body::Clippers(row) => {
            let clippers = row.clippers.iter().map(|clipper| &clipper.name);
            let travellers = row.travellers.iter().map(|traveller| &traveller.name);
            let names = clippers.chain(travellers).chain([&row.output]);
            names.map(value).collect()
        }
    }
}

fn said_in_story(story: &Story, catalog: &Catalog) -> Vec<String> {
    let cards = story.cards.iter();
    let cards = cards.flat_map(|card| [&card.name, &card.new.1, &card.against, &card.word]);
    let around = [&story.title, &story.opening.1, &story.held, &story.down];
    let said = cards.chain(around);
    said.map(|value| catalog.value(value)).collect()
}

fn said_in_graph(graph: &Graph, catalog: &Catalog) -> Vec<String> {
    let nodes = graph.nodes.iter().flat_map(|node| {
        let beside = node.number.iter().chain(&node.note);
        std::iter::once(&node.name).chain(beside)
    });
    let reasons = graph.arrows.iter();
    let reasons = reasons.filter_map(|arrow| arrow.reason.as_ref());
    let names = nodes.chain(reasons).chain(&graph.ring);
    let said = names.chain([&graph.title]);
    said.map(|value| catalog.value(value)).collect()
}

fn said_in_products(products: &Products, catalog: &Catalog) -> Vec<String> {
    let value = |value: &Value| catalog.value(value);
    let mut said = Vec::new();
    for product in &products.products {
        said.push(value(&product.onto.name));
        said.push(value(&product.of.name));
        said.push(catalog.message(&product.decision));
        said.push(catalog.formula(&product.arithmetic));
    }
    if let Some(measured) = &products.measured {
        said.push(catalog.message(&measured.title));
        let ends = measured.ends.iter().map(|(name, _)| name);
        let spans = measured.spans.iter().map(|(_, text, _)| text);
        let names = std::iter::once(&measured.zero).chain(ends).chain(spans);
        said.extend(names.map(value));
    }
    said
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

#[test]
fn nothing_that_is_said_is_missing_from_a_catalogue() {
    for scene in scenes() {
        for (card, run) in record(&scene) {
            run.frames(
                [0, run.n_steps()],
                |_| true,
                |step, frame| {
                    for lang in Lang::ALL {
                        let catalog = Catalog::of(lang);
                        let mut said = vec![catalog.message(&frame.caption.decision)];
                        let formulas = frame.caption.arithmetic.iter();
                        said.extend(formulas.map(|f| catalog.formula(f)));
                        for row in frame.watch.iter().flat_map(|section| &section.rows) {
                            let values = row.cells.iter().flatten().chain(&row.note);
                            said.extend(values.chain([&row.name]).map(|v| catalog.value(v)));
                        }
                        for view in &frame.views {
                            said.extend(said_in(&view.body, catalog));
                        }
                        for text in said {
                            assert!(
                                !text.contains('⟦'),
                                "{lang} lacks {text} at step {step} of {} on {scene:?}",
                                card.id
                            );
                        }
                    }
                },
            );
        }
    }
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
