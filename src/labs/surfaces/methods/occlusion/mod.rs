//! Occlusion queries, shown: the box that is asked, its pixels over the picture so far, and every object's answer.

mod captions;
mod occluders;
mod views;

use serde_json::{Value as Json, json};

use crate::{
    algo::surface::{
        Occlusion, OcclusionEvent as Event, OcclusionInput, OcclusionOutput,
        OcclusionState as State,
    },
    figure::{Caption, Tick, View, Watch, WatchRow, WatchSection},
    labs::{
        Answer, CodeLine, Demo, Step, code_line,
        space::soup::surfaces_on_raster,
        space::{OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo},
    },
    text::Value,
};

use super::on_raster::depth_list;

use captions::Input;

pub use occluders::with_occluders;

type Shown = OnScene<Occlusion>;

const OCCLUDERS: usize = 0;
const OTHERS: usize = 1;
const ASK: usize = 2;
const SKIP: usize = 3;
const DRAW: usize = 4;

impl Answer for OcclusionOutput {
    fn json(&self) -> Json {
        json!({
            "ids": self.picture,
            "depth": depth_list(&self.depth),
            "n_drawn": self.n_drawn,
            "n_skipped": self.n_skipped,
        })
    }
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Surfaces;

    fn input(scene: &Scene) -> Input {
        let surfaces = surfaces_on_raster(scene);
        let objects = occluders::objects_of(scene, &surfaces);
        OnSceneInput::of(scene, OcclusionInput { surfaces, objects })
    }
}

impl Demo for Shown {
    const ID: &'static str = "occlusion";
    const NAME_KEY: &'static str = "alg-occlusion";
    const SOURCE: &'static str = "Bartz, Meißner & Hüttner, 1999";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-occlusion-occluders", "words-occlusion-occluders"),
        code_line(0, "code-occlusion-others", "words-occlusion-others"),
        code_line(1, "code-occlusion-ask", "words-occlusion-ask"),
        code_line(1, "code-occlusion-skip", "words-occlusion-skip"),
        code_line(1, "code-occlusion-draw", "words-occlusion-draw"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Query { .. } => Tick::Test,
            Event::Skip { .. } => Tick::Reject,
            Event::Draw { .. } => Tick::Cut,
            Event::Done => Tick::Accept,
        }
    }

    fn code_line(event: &Event, before: &State) -> usize {
        match *event {
            Event::Query { result, .. } if result.unasked => OTHERS,
            Event::Query { .. } => ASK,
            Event::Skip { .. } => SKIP,
            Event::Draw { object_idx, .. } if before.object_idx != Some(object_idx) => OCCLUDERS,
            Event::Draw { .. } | Event::Done => DRAW,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption(event, before, input)
    }

    fn opening(input: &Input) -> Caption {
        captions::opening(input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        views::views(step)
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let state = step.state;
        let row = |key, n| WatchRow::new(Value::Term(key), Some(Value::Count(n)));
        let asked: u64 = state.answers.iter().map(|(_, result)| result.asked).sum();
        let spared = captions::n_triangles(step.input, &state.skipped);
        let rows = vec![
            row("watch-objects-drawn", state.drawn.len()),
            row("watch-objects-skipped", state.skipped.len()),
            row("watch-pixels-asked", asked as usize),
            row("watch-triangles-spared", spared),
        ];
        vec![WatchSection::list(rows)]
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
        let input = Shown::input(&hiding()).own;
        let occluders: Vec<bool> = input.objects.iter().map(|it| it.is_occluder).collect();
        assert_eq!(occluders.len(), 4);
        assert!(
            occluders[1] && !occluders[0] && !occluders[3],
            "{occluders:?}"
        );
        let output = silent::<Occlusion>(&input);
        assert_eq!((output.n_drawn, output.n_skipped), (3, 1));
    }

    #[test]
    fn the_picture_is_the_depth_buffers() {
        let mut on_a_street = first_scene();
        on_a_street.set_objects(street(60, 1)).unwrap();
        on_a_street.raster = on_a_street.raster.with_rows(48);
        let mut n_skipped = 0;
        for scene in [first_scene(), hiding(), on_a_street] {
            let input = Shown::input(&scene).own;
            let all = DepthBufferInput::new(input.surfaces.clone());
            let (some, all) = (silent::<Occlusion>(&input), silent::<DepthBuffer>(&all));
            assert_eq!(some.picture, all.picture);
            assert_eq!(some.depth, all.depth);
            n_skipped += some.n_skipped;
        }
        assert!(n_skipped > 10, "{n_skipped}");
    }
}
