//! One vertex through all spaces, shown: the spaces in a row, the one at work large, and the row of the matrix written out.

mod formulas;
mod product;

use std::cmp::Ordering;

use crate::{
    algo::pipeline::{
        PipelineSpace::{self, Clip, View as ViewSpace, World},
        ViewingPipeline, ViewingPipelineEvent as Event, ViewingPipelineInput,
        ViewingPipelineOutput,
    },
    figure::{CellStage, SpaceCell, SpaceRow, Tick},
    labs::frustum::prelude::*,
};

use super::super::{
    screen::screen,
    stage::{Followed, PictureSpace, SpacePlaces},
};

use formulas::{BEHIND, DIVIDE, OPENING, SCREEN, TO_W};

const SPACE_VIEW: &str = "space";
const SPACES_VIEW: &str = "spaces";
const MATRIX_VIEW: &str = "matrix";

/// Rows of pixels on the screen of a scene; columns are as many as the camera's shape asks for.
const SCREEN_ROWS: u32 = 400;

impl AnswerAsItIs for ViewingPipelineOutput {}

impl SpaceTelling for ViewingPipeline {
    const SUBJECT: Subject = Subject::Vertex;

    fn input(scene: &Scene) -> ViewingPipelineInput {
        let object = scene.focused();
        ViewingPipelineInput {
            point: object.model().mesh().positions()[scene.vertex()].map(f64::from),
            world_from_model: object.world_from_model(),
            camera: *scene.camera.camera(),
            viewport: screen(scene.camera.aspect(), SCREEN_ROWS),
        }
    }
}

const fn of_row(tick: Tick, into: PipelineSpace, key: &'static str) -> Row {
    Row::new(tick, into as usize, key).so(&["{sum}"])
}

impl Telling for ViewingPipeline {
    type Scenery = Scenery;

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
    const WATCH: &'static [Watched] = &[
        Watched::ListSeen("spaces", SPACES_VIEW),
        Watched::Names(&["−w ≤ x, y, z ≤ w"]),
    ];
    const OPENING: Row = Row::new(Phase, 0, "pipeline-opening").so(&[OPENING]);

    table! { |event, step|
        world: Event::Row { space: World, row: 0, .. } => of_row(Phase, World, "pipeline-world-row");
        world_next: Event::Row { space: World, .. } => of_row(Test, World, "pipeline-world-row");
        left: Event::Row { space: ViewSpace, row: 0, value } if value < 0.0 =>
            of_row(Phase, ViewSpace, "pipeline-view-left");
        right: Event::Row { space: ViewSpace, row: 0, .. } =>
            of_row(Phase, ViewSpace, "pipeline-view-right");
        under: Event::Row { space: ViewSpace, row: 1, value } if value < 0.0 =>
            of_row(Test, ViewSpace, "pipeline-view-under");
        above: Event::Row { space: ViewSpace, row: 1, .. } =>
            of_row(Test, ViewSpace, "pipeline-view-above");
        ahead: Event::Row { space: ViewSpace, value, .. } if value < 0.0 =>
            of_row(Test, ViewSpace, "pipeline-view-ahead");
        back: Event::Row { space: ViewSpace, .. } => of_row(Test, ViewSpace, "pipeline-view-back");
        x: Event::Row { space: Clip, row: 0, .. } => of_row(Phase, Clip, "pipeline-clip-x");
        y: Event::Row { space: Clip, row: 1, .. } => of_row(Test, Clip, "pipeline-clip-y");
        z: Event::Row { space: Clip, row: 2, .. } => of_row(Test, Clip, "pipeline-clip-z");
        w_parallel: Event::Row { space: Clip, .. }
            if step.input.camera.volume().sight() == Sight::Parallel =>
            of_row(Test, Clip, "pipeline-clip-w-parallel");
        w: Event::Row { space: Clip, .. } => of_row(Test, Clip, "pipeline-clip-w");
        inside: Event::Test { inside: true } =>
            Row::new(Accept, 3, "pipeline-inside")
                .so(&TO_W).answers("inside");
        outside: Event::Test { inside: false } =>
            Row::new(Cut, 3, "pipeline-outside")
                .so(&["{x beyond w}", "{y beyond w}", "{z beyond w}"]).answers("inside");
        divide: Event::Divide { .. } =>
            Row::new(Test, 4, "pipeline-divide").so(&DIVIDE).answers("before the eye");
        screen: Event::Screen { .. } => Row::new(Accept, 5, "pipeline-screen").so(&SCREEN);
        behind: Event::Behind =>
            Row::new(Reject, 6, "pipeline-behind").so(&[BEHIND]).answers("before the eye");
    }

    fn named(at: &At<'_, Self>, name: &str) -> Option<Named> {
        formulas::named(at, name)
    }

    fn listed(at: &At<'_, Self>, _: &str) -> Vec<Named> {
        let spaces = PictureSpace::ALL.into_iter().filter_map(|space| {
            let name = Value::Term(space.name_key());
            Some(Named::from(place(at, space)?).labelled(name))
        });
        spaces.collect()
    }

    fn views(at: &At<'_, Self>) -> Vec<View> {
        let matrix = View::new(MATRIX_VIEW, Body::Matrix(product::product(at)));
        let Some(scenery) = at.scenery else {
            return vec![matrix];
        };
        let pictures = SpacePlaces::new(scenery, at.step.input.viewport.size());
        let active = active(at.step.event());
        let large = Followed {
            is_large: true,
            ..followed(at, active)
        };
        let large = pictures.draw(active, &large);
        vec![
            View::new(SPACE_VIEW, Body::Space(large)),
            matrix,
            View::new(SPACES_VIEW, Body::Spaces(row_of_spaces(at, &pictures))),
        ]
    }
}

const fn active(event: Option<Event>) -> PictureSpace {
    match event {
        None => PictureSpace::Model,
        Some(Event::Row { space, .. }) => PictureSpace::reached(space),
        Some(Event::Test { .. } | Event::Behind) => PictureSpace::Clip,
        Some(Event::Divide { .. }) => PictureSpace::Ndc,
        Some(Event::Screen { .. }) => PictureSpace::Screen,
    }
}

const fn arrow(event: Option<Event>) -> Option<usize> {
    match event {
        None | Some(Event::Test { .. } | Event::Behind) => None,
        Some(Event::Row { space, .. }) => Some(space as usize),
        Some(Event::Divide { .. }) => Some(3),
        Some(Event::Screen { .. }) => Some(4),
    }
}

fn known<'a>(at: &At<'a, ViewingPipeline>, space: PictureSpace) -> &'a [f64] {
    let held = at.step.held;
    match space {
        PictureSpace::Model => &at.step.input.point,
        PictureSpace::World => reached(at, World),
        PictureSpace::View => reached(at, ViewSpace),
        PictureSpace::Clip => reached(at, Clip),
        PictureSpace::Ndc => held.ndc.as_ref().map_or(&[], |at| &at[..]),
        PictureSpace::Screen => held.screen.as_ref().map_or(&[], |at| &at[..]),
    }
}

fn reached<'a>(at: &At<'a, ViewingPipeline>, into: PipelineSpace) -> &'a [f64] {
    let n_rows = match at.step.event() {
        None => 0,
        Some(Event::Row { space, row, .. }) => match (into as usize).cmp(&(space as usize)) {
            Ordering::Less => into.n_rows(),
            Ordering::Equal => row + 1,
            Ordering::Greater => 0,
        },
        Some(Event::Test { .. } | Event::Divide { .. } | Event::Screen { .. } | Event::Behind) => {
            into.n_rows()
        }
    };
    &at.step.held.at(into)[..n_rows]
}

fn followed(at: &At<'_, ViewingPipeline>, space: PictureSpace) -> Followed {
    let (known, event) = (known(at, space), at.step.event());
    let is_active = active(event) == space;
    let current = match event {
        Some(Event::Row { row, .. }) if is_active => Some(row),
        _ => None,
    };
    Followed {
        at: std::array::from_fn(|i| known.get(i).copied().unwrap_or_default()),
        n_known: known.len(),
        current,
        is_tested: is_active && matches!(event, Some(Event::Test { .. })),
        arrives: is_active && matches!(event, Some(Event::Divide { .. } | Event::Screen { .. })),
        is_large: false,
    }
}

/// Where the vertex is in a space, as far as it is known: `(3.5, …)`.
fn place(at: &At<'_, ViewingPipeline>, space: PictureSpace) -> Option<Value> {
    let known = known(at, space);
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

fn row_of_spaces(at: &At<'_, ViewingPipeline>, pictures: &SpacePlaces<'_>) -> SpaceRow {
    let active = active(at.step.event());
    let cell = |space: PictureSpace| SpaceCell {
        name: Value::Term(space.name_key()),
        space: pictures.draw(space, &followed(at, space)),
        place: place(at, space),
        stage: match (space as usize).cmp(&(active as usize)) {
            Ordering::Less => CellStage::Done,
            Ordering::Equal => CellStage::Current,
            Ordering::Greater => CellStage::ToCome,
        },
        link: None,
    };
    SpaceRow {
        cells: PictureSpace::ALL.map(cell).to_vec(),
        arrows: product::ARROWS.map(name).to_vec(),
        at_work: arrow(at.step.event()),
    }
}
