//! How much is left after each test.

use crate::{
    algo::cull::{Containment, CullRules, FunnelEvent as Event, FunnelLevels, Level},
    figure::{Ribbon, RibbonStage, WatchRow},
    labs::Step,
    text::{Message, Value},
};

use super::Shown;

const TITLES: [&str; 5] = [
    "level-scene",
    "level-spheres",
    "level-vertices",
    "level-cuts",
    "level-facing",
];

const fn levels_of(levels: &FunnelLevels) -> [Level; 5] {
    let FunnelLevels {
        scene,
        spheres,
        vertices,
        cuts,
        facing,
    } = *levels;
    [scene, spheres, vertices, cuts, facing]
}

/// What has come through each gate so far.
pub fn ribbon<L: CullRules>(step: &Step<'_, Shown<L>>) -> Ribbon {
    let levels = levels_of(&step.state.levels);
    let to_come = to_come(step);
    let at_work = match step.event {
        Some(Event::Object { .. }) => Some(0),
        Some(Event::Plane { .. } | Event::Sphere { .. }) => Some(1),
        Some(Event::Triangle { n_pieces: 0, .. }) => Some(2),
        Some(Event::Triangle { .. }) => Some(3),
        Some(Event::Face { .. }) => Some(4),
        Some(Event::Done) | None => None,
    };
    let given = step.input.own.objects.iter();
    let given = Level {
        objects: given.len(),
        triangles: given.map(|object| object.triangles.len()).sum(),
    };
    let has_begun = step.event.is_some();
    let stage = |i: usize| {
        let is_so_far = i == 0 && has_begun;
        let Level { objects, triangles } = if i == 0 && !has_begun {
            given
        } else {
            levels[i]
        };
        let before = i.checked_sub(1).map(|i| levels[i].triangles);
        let known = (triangles + to_come[i]) as i64;
        let change = before.map(|before| known - before as i64);
        RibbonStage {
            title: Message::new(if is_so_far { "level-so-far" } else { TITLES[i] }),
            counts: Message::new("level-counts")
                .with("objects", objects)
                .with("triangles", triangles),
            amount: triangles,
            change: change.filter(|change| *change != 0 || to_come[i] == 0),
            is_to_come: triangles == 0 && levels[0].triangles == 0,
        }
    };
    Ribbon {
        stages: (0..5).map(stage).collect(),
        at_work,
        most: given.triangles.max(levels[3].triangles),
    }
}

/// Of the object whose turn it is: triangles, or their pieces, that stand before each gate and have not been asked there.
fn to_come<L: CullRules>(step: &Step<'_, Shown<L>>) -> [usize; 5] {
    let state = step.state;
    let mut to_come = [0; 5];
    let Some(object_idx) = state.object_idx else {
        return to_come;
    };
    let n = step.input.own.objects[object_idx].triangles.len();
    match state.sphere.class {
        None => to_come[1] = n,
        Some(Containment::Outside) => {}
        Some(Containment::Inside) => to_come[4] = n - state.faces.len(),
        Some(Containment::Straddles) => {
            to_come[2] = n - state.triangles.len();
            if let Some(Event::Triangle { n_pieces, .. }) = step.event {
                to_come[4] = n_pieces;
            }
        }
    }
    to_come
}

/// The same as rows of an answer key.
pub fn level_rows(levels: &FunnelLevels) -> Vec<WatchRow> {
    let row = |(title, level): (&'static str, Level)| {
        WatchRow::new(Value::Term(title), Some(Value::Count(level.triangles)))
    };
    TITLES.into_iter().zip(levels_of(levels)).map(row).collect()
}
