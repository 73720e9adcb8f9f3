//! The scene by what becomes of its objects, the pixels that are asked over the picture so far, and the answers.

use std::collections::BTreeSet;

use crate::{
    algo::surface::{Occlusion, OcclusionEvent as Event},
    figure::Multiples,
    geom::AlignedBox,
};

use super::super::{
    bars::{Bar, bars},
    prelude::*,
};

use super::names::{answer, answers, current, name_of};

const LIST_VIEW: &str = "objects";
const TRIANGLES_VIEW: &str = "triangles";

pub fn views(at: &At<'_, Occlusion>) -> Vec<View> {
    let held = at.step.held;
    let fate = |object_idx: usize| {
        if held.drawn.contains(&object_idx) {
            Fate::Kept
        } else if held.skipped.contains(&object_idx) {
            Fate::Culled
        } else {
            Fate::ToCome
        }
    };
    on_raster::views(at, |scenery| {
        let camera = scenery.scene().camera.camera();
        let edges = asked_box(at).into_iter().flat_map(|it| it.edges());
        let marks = edges.map(|ends| {
            let ends = ends.map(|at| camera.world_from_view(at));
            Mark3::new(Role::Signal, Shape3::Segment(ends))
        });
        let counts = triangles(at).map(|it| View::new(TRIANGLES_VIEW, Body::Multiples(it)));
        let views = [
            scenery.observer(fate, marks.collect()),
            View::new(RASTER_VIEW, Body::Raster(raster(at))),
            View::new(LIST_VIEW, Body::Lists(lists(at))),
        ];
        views.into_iter().chain(counts).collect()
    })
}

/// How many triangles each object has: those that are drawn, and those that are spared.
fn triangles(at: &At<'_, Occlusion>) -> Option<Multiples> {
    /// Of fewer it does not matter how many are spared.
    const MANY: usize = 100;
    let (objects, focus) = (&at.step.input.objects, current(at.step.past));
    let bar = |object_idx: usize| {
        let n = objects[object_idx].n_triangles;
        let role = fate_of(at, object_idx).map_or(Role::Soft, |(_, role)| role);
        let is_current = focus == Some(object_idx) && role != Role::Discarded;
        Bar {
            name: name_of(at.scenery, object_idx),
            reach: [0.0, n.into()],
            ends: [None, Some(Value::Count(n as usize))],
            role: if is_current { Role::Signal } else { role },
        }
    };
    let rows: Vec<Bar> = (0..objects.len()).map(bar).collect();
    let is_much = at.step.input.surfaces.triangles().len() > MANY;
    bars("occlusion-triangles", &rows, focus).filter(|_| is_much)
}

/// In a word what has become of an object, and how that is drawn.
fn fate_of(at: &At<'_, Occlusion>, object_idx: usize) -> Option<(&'static str, Role)> {
    let held = at.step.held;
    if held.skipped.contains(&object_idx) {
        Some(("occlusion-skipped", Role::Discarded))
    } else if !held.drawn.contains(&object_idx) {
        None
    } else if at.step.input.objects[object_idx].is_occluder {
        Some(("occlusion-is-occluder", Role::Accent))
    } else {
        Some(("occlusion-drawn", Role::Accent))
    }
}

/// The box that is asked, in view space.
fn asked_box(at: &At<'_, Occlusion>) -> Option<AlignedBox> {
    let (bounds, _) = answer(at.step.past)?;
    let [[x, y, z], [right, top, front]] = bounds?;
    AlignedBox::new([x, y, z, right, top, front]).ok()
}

fn raster(at: &At<'_, Occlusion>) -> Raster {
    let (input, event) = (at.step.input, at.step.event());
    // Objects are in the order of their triangles.
    let object_of = |id: u32| input.objects.partition_point(|object| object.first <= id) as u32 - 1;
    let picture = at.step.held.drawing.so_far.picture.renamed(object_of);
    let drawn = match event {
        Some(Event::Draw { object_idx, .. }) => Some(object_idx as u32),
        _ => None,
    };
    let edges = asked_box(at).into_iter().flat_map(|it| it.edges());
    let mut over: Vec<RasterMark> = edges
        .filter_map(|ends| segment(&input.surfaces, ends, Role::Signal))
        .collect();
    let asked: &[([u32; 2], bool)] = if event == Some(Event::Done) {
        &[]
    } else {
        &at.step.held.asked
    };
    let columns = input.surfaces.size()[0] as usize;
    let id_at = |[x, y]: [u32; 2]| picture.ids()[y as usize * columns + x as usize];
    let hidden = asked.iter().filter(|(_, passes)| !passes);
    let hiding: BTreeSet<i32> = hidden.map(|&(pixel, _)| id_at(pixel)).collect();
    // Of several that hide it each pixel says which one does so there.
    let is_shared = drawn.is_none() && hiding.len() > 1;
    let marked = asked.iter().filter(|(_, passes)| *passes || !is_shared);
    over.extend(marked.filter(|_| drawn.is_none()).map(answer_mark));
    let named = |id: i32| Some(name_of(at.scenery, usize::try_from(id).ok()?));
    let names = lettered(&picture, |object| name_of(at.scenery, object as usize));
    // Where pixels are asked, their marks stand in place of letters.
    let pixels = pixels(&picture, drawn, |place| {
        let here = [place % columns, place / columns].map(|x| x as u32);
        match asked.iter().find(|(pixel, _)| *pixel == here) {
            Some((_, false)) if is_shared => named(id_at(here)),
            Some(_) => None,
            None => names(place),
        }
    });
    raster_so_far(&input.surfaces, pixels, over)
}

fn answer_mark(&(pixel, passes): &([u32; 2], bool)) -> RasterMark {
    let at = pixel.map(|x| f64::from(x) + 0.5);
    if passes {
        mark(Role::Accent, RasterShape::Ring(at))
    } else {
        mark(Role::Ink, RasterShape::Dot(at))
    }
}

fn lists(at: &At<'_, Occlusion>) -> Lists {
    let objects = &at.step.input.objects;
    let focus = current(at.step.past);
    let row = |object_idx: usize| {
        let answer = answers(at.step.past).find(|(of, _)| *of == object_idx);
        let result = answer.map(|(_, result)| result).filter(|it| !it.unasked);
        let fate = fate_of(at, object_idx);
        let is_current = focus == Some(object_idx);
        let role = fate.map_or(Role::Ink, |(_, role)| role);
        ListRow {
            details: vec![
                result.map(|it| Value::Count(it.asked as usize)),
                result.map(|it| Value::Count(it.passed as usize)),
                fate.map(|(key, _)| Value::Term(key)),
            ],
            role: if is_current { Role::Signal } else { role },
            link: Some(object_link(object_idx)),
            ..ListRow::new(name_of(at.scenery, object_idx))
        }
    };
    let columns = ["occlusion-asked", "occlusion-passed", "story-fate"];
    let title = Value::Term("occlusion-objects");
    let column = ListColumn {
        columns: columns.map(Value::Term).to_vec(),
        ..ListColumn::about(title, objects.len(), focus, row)
    };
    Lists {
        lists: vec![column],
        links: Vec::new(),
        legend: Vec::new(),
    }
}
