//! How much is left after each test.

use crate::{
    algo::cull::{Funnel, FunnelEvent as Event, FunnelLevels, Level},
    figure::{Ribbon, RibbonStage},
    labs::frustum::prelude::*,
};

use super::{Now, variant::Variant};

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

pub fn ribbon<L: Variant>(at: &At<'_, Funnel<L>>) -> Ribbon {
    let levels = levels_of(&at.step.held.levels);
    let to_come = to_come(at);
    let at_work = match at.step.event() {
        Some(Event::Object { .. }) => Some(0),
        Some(Event::Plane { .. } | Event::Sphere { .. }) => Some(1),
        Some(Event::Triangle { n_pieces: 0, .. }) => Some(2),
        Some(Event::Triangle { .. }) => Some(3),
        Some(Event::Face { .. }) => Some(4),
        Some(Event::Done) | None => None,
    };
    let given = at.step.input.objects.iter();
    let given = Level {
        objects: given.len(),
        triangles: given.map(|object| object.triangles.len()).sum(),
    };
    let has_begun = !at.step.past.is_empty();
    let is_done = matches!(at.step.event(), Some(Event::Done));
    // Nothing is said of a gate before the first comes there.
    let has_arrived = |i: usize| {
        let is_asked = i == 0 || is_done || at_work >= Some(i);
        is_asked || levels[i..].iter().any(|level| level.triangles > 0)
    };
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
            is_to_come: !has_arrived(i),
        }
    };
    Ribbon {
        stages: (0..5).map(stage).collect(),
        at_work,
        most: given.triangles.max(levels[3].triangles),
    }
}

/// Of the object whose turn it is: triangles, or their pieces, that stand before each gate and have not been asked there.
fn to_come<L: Variant>(at: &At<'_, Funnel<L>>) -> [usize; 5] {
    let mut to_come = [0; 5];
    let now = Now::of(at);
    let Some((object_idx, event)) = now.object_idx.zip(at.step.event()) else {
        return to_come;
    };
    let n = at.step.input.objects[object_idx].triangles.len();
    let n_left = n - now.face_idx.map_or(0, |face_idx| face_idx + 1);
    match (event, at.step.held.sphere.class) {
        (Event::Object { .. } | Event::Plane { .. }, _) => to_come[1] = n,
        (_, Containment::Outside) => {}
        (_, Containment::Inside) => to_come[4] = n_left,
        (Event::Triangle { n_pieces, .. }, Containment::Straddles) => {
            (to_come[2], to_come[4]) = (n_left, n_pieces);
        }
        (_, Containment::Straddles) => to_come[2] = n_left,
    }
    to_come
}

pub fn levels(levels: &FunnelLevels) -> Vec<Named> {
    let levels = TITLES.into_iter().zip(levels_of(levels));
    levels
        .map(|(title, level)| Named::from(level.triangles).labelled(Value::Term(title)))
        .collect()
}
