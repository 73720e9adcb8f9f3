//! How much is left after each test.

use crate::{
    algo::cull::{CullRules, FunnelEvent as Event, FunnelLevels, Level},
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
    let at_work = match step.event {
        Some(Event::Object { .. }) => Some(0),
        Some(Event::Plane { .. } | Event::Sphere { .. }) => Some(1),
        Some(Event::Triangle { n_pieces: 0, .. }) => Some(2),
        Some(Event::Triangle { .. }) => Some(3),
        Some(Event::Face { .. }) => Some(4),
        Some(Event::Done) | None => None,
    };
    let stage = |i: usize| {
        let Level { objects, triangles } = levels[i];
        let before = i.checked_sub(1).map(|i| levels[i].triangles);
        RibbonStage {
            title: Message::new(TITLES[i]),
            counts: Message::new("level-counts")
                .with("objects", objects)
                .with("triangles", triangles),
            amount: triangles,
            change: before.map(|before| triangles as i64 - before as i64),
            is_to_come: levels[0].triangles == 0,
        }
    };
    let given = step.input.own.objects.iter();
    let given: usize = given.map(|object| object.triangles.len()).sum();
    Ribbon {
        stages: (0..5).map(stage).collect(),
        at_work,
        most: given.max(levels[3].triangles),
    }
}

/// The same as rows of an answer key.
pub fn level_rows(levels: &FunnelLevels) -> Vec<WatchRow> {
    let row = |(title, level): (&'static str, Level)| {
        WatchRow::new(Value::Term(title), Some(Value::Count(level.triangles)))
    };
    TITLES.into_iter().zip(levels_of(levels)).map(row).collect()
}
