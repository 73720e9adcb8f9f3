//! The scene by what becomes of its objects, the pixels that are asked over the picture so far, and the answers.

use crate::{
    algo::surface::{Occlusion, OcclusionEvent as Event},
    geom::AlignedBox,
};

use super::super::prelude::*;

use super::names::{answer, answers, current, name_of};

const LIST_VIEW: &str = "objects";

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
        vec![
            scenery.observer(fate, marks.collect()),
            View::new(RASTER_VIEW, Body::Raster(raster(at))),
            View::new(LIST_VIEW, Body::Lists(lists(at))),
        ]
    })
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
    over.extend(asked.iter().filter(|_| drawn.is_none()).map(answer_mark));
    let names = lettered(&picture, |object| name_of(at.scenery, object as usize));
    let columns = input.surfaces.size()[0] as usize;
    // Where pixels are asked, their marks stand in place of letters.
    let pixels = pixels(&picture, drawn, |place| {
        let here = [place % columns, place / columns].map(|x| x as u32);
        let is_asked = |_: &Value| asked.iter().any(|(pixel, _)| *pixel == here);
        names(place).filter(|name| !is_asked(name))
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
    let held = at.step.held;
    let objects = &at.step.input.objects;
    let focus = current(at.step.past);
    let row = |object_idx: usize| {
        let answer = answers(at.step.past).find(|(of, _)| *of == object_idx);
        let result = answer.map(|(_, result)| result).filter(|it| !it.unasked);
        let fate = if held.skipped.contains(&object_idx) {
            Some(("occlusion-skipped", Role::Discarded))
        } else if !held.drawn.contains(&object_idx) {
            None
        } else if objects[object_idx].is_occluder {
            Some(("occlusion-is-occluder", Role::Accent))
        } else {
            Some(("occlusion-drawn", Role::Accent))
        };
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
