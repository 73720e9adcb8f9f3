//! What the names stand for at a step.

use crate::algo::surface::{Occlusion, OcclusionEvent as Event, QueryResult};

use super::super::prelude::*;

/// `A`; without a scene, its number.
pub fn name_of(scenery: Option<&Scenery>, object_idx: usize) -> Value {
    match scenery {
        Some(scenery) => scenery.scene().object_name(object_idx),
        None => Value::Count(object_idx + 1),
    }
}

pub fn named(at: &At<'_, Occlusion>, name: &str) -> Option<Named> {
    let (input, held) = (at.step.input, at.step.held);
    let result = answer(at.step.past).map(|(_, result)| result);
    let count = |n: u64| Named::from(n as usize);
    Some(match (name, at.step.event()) {
        ("object", _) => {
            let object_idx = current(at.step.past)?;
            Named::from(name_of(at.scenery, object_idx)).linked(object_link(object_idx))
        }
        ("objects", _) => input.objects.len().into(),
        ("occluders", _) => occluders(at).into(),
        ("triangles", Some(Event::Query { .. } | Event::Skip { .. } | Event::Draw { .. })) => {
            n_triangles(at, &[current(at.step.past)?]).into()
        }
        ("asked", _) => count(result?.asked),
        ("passed", _) => count(result?.passed),
        ("writes", Some(Event::Draw { writes, .. })) => count(writes),
        ("drawn" | "watch-objects-drawn", _) => held.drawn.len().into(),
        ("skipped" | "watch-objects-skipped", _) => held.skipped.len().into(),
        ("spared" | "watch-triangles-spared", _) => n_triangles(at, &held.skipped).into(),
        ("watch-pixels-asked", _) => {
            count(answers(at.step.past).map(|(_, result)| result.asked).sum())
        }
        _ => return on_raster::named(&input.surfaces, at.scenery, name),
    })
}

pub fn current(past: &[Event]) -> Option<usize> {
    match past.last()? {
        Event::Query { object_idx, .. }
        | Event::Skip { object_idx }
        | Event::Draw { object_idx, .. } => Some(*object_idx),
        Event::Done => None,
    }
}

/// The lowest and the highest corner of a box.
pub type Corners = [[f64; 3]; 2];

pub fn answer(past: &[Event]) -> Option<(Option<Corners>, QueryResult)> {
    let current = current(past)?;
    let (object_idx, bounds, result) = past.iter().rev().take(2).find_map(query)?;
    (object_idx == current).then_some((bounds, result))
}

pub fn answers(past: &[Event]) -> impl Iterator<Item = (usize, QueryResult)> {
    let queries = past.iter().filter_map(query);
    queries.map(|(object_idx, _, result)| (object_idx, result))
}

const fn query(event: &Event) -> Option<(usize, Option<Corners>, QueryResult)> {
    match *event {
        Event::Query {
            object_idx,
            bounds,
            result,
        } => Some((object_idx, bounds, result)),
        _ => None,
    }
}

fn n_triangles(at: &At<'_, Occlusion>, objects: &[usize]) -> usize {
    let of = |&object_idx: &usize| at.step.input.objects.get(object_idx);
    let objects = objects.iter().filter_map(of);
    objects.map(|object| object.n_triangles as usize).sum()
}

/// `A, C`
fn occluders(at: &At<'_, Occlusion>) -> Value {
    /// More names are no sentence.
    const MOST: usize = 8;
    let numbered = at.step.input.objects.iter().enumerate();
    let idxs = numbered.filter(|(_, object)| object.is_occluder);
    let mut names: Vec<String> = idxs
        .map(|(object_idx, _)| text_of(name_of(at.scenery, object_idx), object_idx + 1))
        .collect();
    if names.is_empty() {
        return Value::Term("occlusion-none");
    }
    if names.len() > MOST {
        names.truncate(MOST);
        names.push("…".to_owned());
    }
    Value::Name(names.join(", "))
}
