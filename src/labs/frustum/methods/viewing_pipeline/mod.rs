//! One vertex through all spaces, shown: the spaces in a row, the one at work large, and the row of the matrix written out.

mod captions;
mod formulas;
mod product;

use serde_json::{Value as Json, json};

use crate::{
    algo::pipeline::{
        PipelineSpace, ViewingPipeline, ViewingPipelineEvent as Event, ViewingPipelineInput,
        ViewingPipelineOutput, ViewingPipelineState as State,
    },
    figure::{
        Body, Caption, CellStage, SpaceCell, SpaceRow, Tick, View, Watch, WatchRow, WatchSection,
    },
    labs::{Answer, CodeLine, Demo, Step, code_line, words::name},
    text::{Formula, Value},
};

use super::super::{
    OnScene, OnSceneInput, Scene, Subject,
    demo::SpaceDemo,
    screen::screen,
    stage::{Followed, PictureSpace, SpacePictures},
};

use product::PipelineStep;

type Input = OnSceneInput<ViewingPipelineInput>;
type Shown = OnScene<ViewingPipeline>;

const SPACE_VIEW: &str = "space";
const SPACES_VIEW: &str = "spaces";
const MATRIX_VIEW: &str = "matrix";

/// Rows of pixels on the screen of a scene; columns are as many as the camera's shape asks for.
const SCREEN_ROWS: u32 = 400;

impl Answer for ViewingPipelineOutput {
    fn json(&self) -> Json {
        json!(self)
    }
}

impl SpaceDemo for Shown {
    const SUBJECT: Subject = Subject::Vertex;

    fn input(scene: &Scene) -> Input {
        let object = scene.focused();
        let own = ViewingPipelineInput {
            point: object.model().mesh().positions()[scene.vertex()].map(f64::from),
            world_from_model: object.world_from_model(),
            camera: *scene.camera.camera(),
            viewport: screen(scene.camera.aspect(), SCREEN_ROWS),
        };
        OnSceneInput::of(scene, own)
    }
}

impl Demo for Shown {
    const ID: &'static str = "viewing-pipeline";
    const NAME_KEY: &'static str = "alg-viewing-pipeline";
    const SOURCE: &'static str = "Roberts, 1965; Blinn & Newell, 1978";
    const CODE: &'static [CodeLine] = &[
        code_line(0, "code-pipeline-world", "words-pipeline-world"),
        code_line(0, "code-pipeline-view", "words-pipeline-view"),
        code_line(0, "code-pipeline-clip", "words-pipeline-clip"),
        code_line(0, "code-pipeline-test", "words-pipeline-test"),
        code_line(0, "code-pipeline-divide", "words-pipeline-divide"),
        code_line(1, "code-pipeline-screen", "words-pipeline-screen"),
        code_line(0, "code-pipeline-behind", "words-pipeline-behind"),
    ];

    fn tick(event: &Event) -> Tick {
        match event {
            Event::Row { row: 0, .. } => Tick::Phase,
            Event::Row { .. } | Event::Divide { .. } => Tick::Test,
            Event::Test { inside: true } | Event::Screen { .. } => Tick::Accept,
            Event::Test { inside: false } => Tick::Cut,
            Event::Behind => Tick::Reject,
        }
    }

    fn code_line(event: &Event, _: &State) -> usize {
        match event {
            Event::Row { space, .. } => *space as usize,
            Event::Test { .. } => 3,
            Event::Divide { .. } => 4,
            Event::Screen { .. } => 5,
            Event::Behind => 6,
        }
    }

    fn caption(event: &Event, before: &State, input: &Input) -> Caption {
        captions::caption(event, before, &input.own)
    }

    fn opening(input: &Input) -> Caption {
        captions::opening(&input.own)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let product = product::product(&PipelineStep {
            input: &step.input.own,
            state: step.state,
            event: step.event,
        });
        let matrix = View::new(MATRIX_VIEW, Body::Matrix(product));
        let Some(scenery) = step.input.scenery.as_deref() else {
            return vec![matrix];
        };
        let pictures = SpacePictures::new(scenery, step.input.own.viewport.size());
        let active = active(step.event);
        let large = Followed {
            is_large: true,
            ..followed(step, active)
        };
        let large = pictures.draw(active, &large);
        vec![
            View::new(SPACE_VIEW, Body::Space(large)),
            matrix,
            View::new(SPACES_VIEW, Body::Spaces(row(step, &pictures))),
        ]
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let rows = PictureSpace::ALL.into_iter().filter_map(|space| {
            let at = place(step, space)?;
            Some(WatchRow::new(Value::Term(space.name_key()), Some(at)))
        });
        let inside = step.state.inside.map(|inside| {
            let key = if inside {
                "class-inside"
            } else {
                "class-outside"
            };
            WatchRow::new(name("−w ≤ x, y, z ≤ w"), Some(Value::Term(key)))
        });
        vec![
            WatchSection::list(rows.collect()).seen_in(SPACES_VIEW),
            WatchSection::list(inside.into_iter().collect()),
        ]
    }
}

/// The space that a step is in.
const fn active(event: Option<Event>) -> PictureSpace {
    match event {
        None => PictureSpace::Model,
        Some(Event::Row { space, .. }) => PictureSpace::reached(space),
        Some(Event::Test { .. } | Event::Behind) => PictureSpace::Clip,
        Some(Event::Divide { .. }) => PictureSpace::Ndc,
        Some(Event::Screen { .. }) => PictureSpace::Screen,
    }
}

/// Which of the arrows between the spaces is at work.
const fn arrow(event: Option<Event>) -> Option<usize> {
    match event {
        None | Some(Event::Test { .. } | Event::Behind) => None,
        Some(Event::Row { space, .. }) => Some(space as usize),
        Some(Event::Divide { .. }) => Some(3),
        Some(Event::Screen { .. }) => Some(4),
    }
}

/// What is known of the vertex in a space.
fn known<'a>(step: &'a Step<'_, Shown>, space: PictureSpace) -> &'a [f64] {
    let reached = |space: PipelineSpace| &step.state.known[space as usize][..];
    match space {
        PictureSpace::Model => &step.input.own.point,
        PictureSpace::World => reached(PipelineSpace::World),
        PictureSpace::View => reached(PipelineSpace::View),
        PictureSpace::Clip => reached(PipelineSpace::Clip),
        PictureSpace::Ndc => step.state.ndc.as_ref().map_or(&[], |at| &at[..]),
        PictureSpace::Screen => step.state.screen.as_ref().map_or(&[], |at| &at[..]),
    }
}

fn followed(step: &Step<'_, Shown>, space: PictureSpace) -> Followed {
    let known = known(step, space);
    let is_active = active(step.event) == space;
    let current = match step.event {
        Some(Event::Row { row, .. }) if is_active => Some(row),
        None
        | Some(
            Event::Row { .. }
            | Event::Test { .. }
            | Event::Divide { .. }
            | Event::Screen { .. }
            | Event::Behind,
        ) => None,
    };
    Followed {
        at: std::array::from_fn(|i| known.get(i).copied().unwrap_or_default()),
        n_known: known.len(),
        current,
        is_tested: is_active && matches!(step.event, Some(Event::Test { .. })),
        arrives: is_active
            && matches!(
                step.event,
                Some(Event::Divide { .. } | Event::Screen { .. })
            ),
        is_large: false,
    }
}

/// Where the vertex is in a space, as far as it is known: `(3.5, …)`.
fn place(step: &Step<'_, Shown>, space: PictureSpace) -> Option<Value> {
    let known = known(step, space);
    if known.is_empty() {
        return None;
    }
    let rest = if known.len() < space.n_coordinates() {
        " …)"
    } else {
        ")"
    };
    let formula = Formula::decimals().sym("(").list(known).sym(rest);
    Some(Value::Formula(formula))
}

/// All six, small.
fn row(step: &Step<'_, Shown>, pictures: &SpacePictures<'_>) -> SpaceRow {
    let active = active(step.event);
    let cell = |space: PictureSpace| SpaceCell {
        name: Value::Term(space.name_key()),
        space: pictures.draw(space, &followed(step, space)),
        place: place(step, space),
        stage: match (space as usize).cmp(&(active as usize)) {
            std::cmp::Ordering::Less => CellStage::Done,
            std::cmp::Ordering::Equal => CellStage::Current,
            std::cmp::Ordering::Greater => CellStage::ToCome,
        },
        link: None,
    };
    SpaceRow {
        cells: PictureSpace::ALL.map(cell).to_vec(),
        arrows: product::ARROWS.map(name).to_vec(),
        at_work: arrow(step.event),
    }
}
