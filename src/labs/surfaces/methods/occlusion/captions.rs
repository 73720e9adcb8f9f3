//! What is said at each step.

use crate::{
    algo::surface::{
        OcclusionEvent as Event, OcclusionInput, OcclusionState as State, QueryResult,
    },
    figure::Caption,
    labs::space::OnSceneInput,
    text::{Message, Value},
};

pub type Input = OnSceneInput<OcclusionInput>;

/// `A`; without a scene, its number.
pub fn name_of(input: &Input, object_idx: usize) -> Value {
    match input.scenery.as_deref() {
        Some(scenery) => scenery.scene().object_name(object_idx),
        None => Value::Count(object_idx + 1),
    }
}

/// As many triangles as these objects have.
pub fn n_triangles(input: &Input, objects: &[usize]) -> usize {
    let of = |&object_idx: &usize| input.own.objects.get(object_idx);
    let objects = objects.iter().filter_map(of);
    objects.map(|object| object.n_triangles as usize).sum()
}

pub fn opening(input: &Input) -> Caption {
    let [columns, rows] = input.own.surfaces.size().map(|side| side as usize);
    let message = Message::new("occlusion-opening")
        .with("objects", input.own.objects.len())
        .with("columns", columns)
        .with("rows", rows);
    Caption::new(message.with("occluders", occluders(input)))
}

/// `A, C`
fn occluders(input: &Input) -> Value {
    /// More names are no sentence.
    const MOST: usize = 8;
    let numbered = input.own.objects.iter().enumerate();
    let idxs = numbered.filter(|(_, object)| object.is_occluder);
    let mut names: Vec<String> = idxs
        .map(|(object_idx, _)| {
            if let Value::Name(name) = name_of(input, object_idx) {
                name
            } else {
                (object_idx + 1).to_string()
            }
        })
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

pub fn caption(event: &Event, before: &State, input: &Input) -> Caption {
    let named = |key, idx: usize| {
        let message = Message::new(key).with("object", name_of(input, idx));
        message.with("triangles", n_triangles(input, &[idx]))
    };
    Caption::new(match *event {
        Event::Query {
            object_idx, result, ..
        } => query(named(query_key(&result), object_idx), &result),
        Event::Skip { object_idx } => named("occlusion-skip", object_idx),
        Event::Draw {
            object_idx,
            writes: [from, to],
        } => {
            let asked = before
                .query
                .filter(|_| before.object_idx == Some(object_idx));
            match asked {
                None => named("occlusion-occluder", object_idx).with("writes", to - from),
                Some((_, result)) if to == from && !result.unasked => {
                    let message = named("occlusion-in-vain", object_idx);
                    message.with("passed", result.passed as usize)
                }
                Some(_) => named("occlusion-draw", object_idx).with("writes", to - from),
            }
        }
        Event::Done => Message::new("occlusion-done")
            .with("drawn", before.drawn.len())
            .with("skipped", before.skipped.len())
            .with("spared", n_triangles(input, &before.skipped))
            .with("triangles", input.own.surfaces.triangles().len()),
    })
}

const fn query_key(result: &QueryResult) -> &'static str {
    match result {
        QueryResult { unasked: true, .. } => "occlusion-unasked",
        QueryResult { asked: 0, .. } => "occlusion-beside",
        QueryResult { passed: 0, .. } => "occlusion-hidden",
        QueryResult { .. } => "occlusion-seen",
    }
}

fn query(message: Message, result: &QueryResult) -> Message {
    message
        .with("asked", result.asked as usize)
        .with("passed", result.passed as usize)
}
