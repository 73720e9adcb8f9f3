//! Occlusion queries, shown: the box that is asked, its pixels over the picture so far, and every object's answer.

mod names;
mod occluders;
mod views;

use crate::algo::surface::{
    Occlusion, OcclusionEvent as Event, OcclusionInput, OcclusionOutput, QueryResult,
};

use super::prelude::*;

pub use occluders::with_occluders;

pseudocode! {
    OCCLUDERS: 0, "code-occlusion-occluders", "words-occlusion-occluders";
    OTHERS: 0, "code-occlusion-others", "words-occlusion-others";
    ASK: 1, "code-occlusion-ask", "words-occlusion-ask";
    SKIP: 1, "code-occlusion-skip", "words-occlusion-skip";
    DRAW: 1, "code-occlusion-draw", "words-occlusion-draw";
}

impl AnswerAsItIs for OcclusionOutput {}

impl SpaceTelling for Occlusion {
    const SUBJECT: Subject = Subject::Surfaces;

    fn shown(step: &Step<'_, Self>, place: usize) -> Option<i32> {
        step.held.drawing.so_far.picture.ids().get(place).copied()
    }

    const MOST_FACES: usize = MOST_ASKED;

    fn input(scene: &Scene) -> OcclusionInput {
        let surfaces = surfaces_on_raster(scene);
        let objects = occluders::objects_of(scene, &surfaces);
        OcclusionInput { surfaces, objects }
    }
}

impl Telling for Occlusion {
    type Scenery = Scenery;

    const ID: &'static str = "occlusion";
    const NAME_KEY: &'static str = "alg-occlusion";
    const SOURCE: &'static str = "Bartz, Meißner & Hüttner, 1999";
    const CODE: &'static [CodeLine] = &LINES;
    const WATCH: &'static [Watched] = &[Watched::Names(&[
        "watch-objects-drawn",
        "watch-objects-skipped",
        "watch-pixels-asked",
        "watch-triangles-spared",
    ])];
    const OPENING: Row = Row::new(Phase, OCCLUDERS, "occlusion-opening");

    table! { |event, step|
        unasked: Event::Query { result: QueryResult { unasked: true, .. }, .. } =>
            Row::new(Test, OTHERS, "occlusion-unasked").answers("seen").keeps("object");
        beside: Event::Query { result: QueryResult { asked: 0, .. }, .. } =>
            Row::new(Test, ASK, "occlusion-beside").answers("seen").drops("object");
        hidden: Event::Query { result: QueryResult { passed: 0, .. }, .. } =>
            Row::new(Test, ASK, "occlusion-hidden")
                .answers_as("seen", "occlusion-answer-hidden").drops("object");
        seen: Event::Query { .. } =>
            Row::new(Test, ASK, "occlusion-seen")
                .answers_as("seen", "occlusion-answer-seen").keeps("object");
        skip: Event::Skip { .. } => Row::new(Reject, SKIP, "occlusion-skip").about("object");
        occluder: Event::Draw { .. } if names::answer(step.past).is_none() =>
            Row::new(Cut, OCCLUDERS, "occlusion-occluder").about("object");
        in_vain: Event::Draw { writes: 0, .. }
            if names::answer(step.past).is_some_and(|(_, result)| !result.unasked) =>
            Row::new(Cut, DRAW, "occlusion-in-vain").about("object");
        draw: Event::Draw { .. } => Row::new(Cut, DRAW, "occlusion-draw").about("object");
        done: Event::Done => Row::new(Accept, DRAW, "occlusion-done");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        names::named(at, name)
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        views::views(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        algo::surface::{DepthBuffer, DepthBufferInput},
        geom::Solid,
        labs::{
            space::{Model, Object, street},
            surfaces::first_scene,
        },
        trace::silent,
    };

    fn cube(at: [f64; 3], size: f64) -> Object {
        Object::new(Model::Solid(Solid::Cube), at, [0.0; 3], size).unwrap()
    }

    /// A large cube, a small one behind it, one beside it, and one beside that.
    fn hiding() -> Scene {
        let mut scene = first_scene();
        scene
            .set_objects(vec![
                cube([0.0, 0.0, -2.0], 0.2),
                cube([0.0, 0.0, 1.5], 0.9),
                cube([2.0, 0.0, -1.0], 0.4),
                cube([-2.0, 0.0, -1.0], 0.3),
            ])
            .unwrap();
        scene
    }

    #[test]
    fn the_largest_hide_and_what_they_hide_is_skipped() {
        let input = Occlusion::input(&hiding());
        let occluders: Vec<bool> = input.objects.iter().map(|it| it.is_occluder).collect();
        assert_eq!(occluders.len(), 4);
        assert!(
            occluders[1] && !occluders[0] && !occluders[3],
            "{occluders:?}"
        );
        let output = silent::<Occlusion>(&input);
        assert_eq!((output.drawn.len(), output.skipped.len()), (3, 1));
    }

    #[test]
    fn the_picture_is_the_depth_buffers() {
        let mut on_a_street = first_scene();
        on_a_street.set_objects(street(60, 1)).unwrap();
        on_a_street.raster = on_a_street.raster.with_rows(48);
        let mut n_skipped = 0;
        for scene in [first_scene(), hiding(), on_a_street] {
            let input = Occlusion::input(&scene);
            let all = DepthBufferInput::new(input.surfaces.clone());
            let (some, all) = (silent::<Occlusion>(&input), silent::<DepthBuffer>(&all));
            assert_eq!(some.picture, all.picture);
            assert_eq!(some.depth, all.depth);
            n_skipped += some.skipped.len();
        }
        assert!(n_skipped > 10, "{n_skipped}");
    }
}
