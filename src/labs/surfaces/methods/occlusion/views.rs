//! The scene by what becomes of its objects, the pixels that are asked over the picture so far, and the answers.

use crate::{
    algo::surface::OcclusionEvent as Event,
    figure::{
        Body, ListColumn, ListRow, Lists, Mark3, Raster, RasterMark, RasterShape, Role, Shape3,
        View,
    },
    geom::AlignedBox,
    labs::{
        Step,
        space::stage::{Fate, object_link},
        surfaces::methods::on_raster::{fitting, lettered, pixels, segment},
    },
    text::Value,
};

use super::{Shown, captions::name_of};

const RASTER_VIEW: &str = "raster";
const LIST_VIEW: &str = "objects";

pub fn views(step: &Step<'_, Shown>) -> Vec<View> {
    let Some(scenery) = step.input.scenery.as_deref() else {
        return Vec::new();
    };
    let state = step.state;
    let fate = |object_idx: usize| {
        if state.drawn.contains(&object_idx) {
            Fate::Kept
        } else if state.skipped.contains(&object_idx) {
            Fate::Culled
        } else {
            Fate::ToCome
        }
    };
    let camera = scenery.scene().camera.camera();
    let edges = asked_box(step).into_iter().flat_map(|it| it.edges());
    let marks = edges.map(|ends| {
        let ends = ends.map(|at| camera.world_from_view(at));
        Mark3::new(Role::Signal, Shape3::Segment(ends))
    });
    let views = vec![
        scenery.observer(fate, marks.collect()),
        View::new(RASTER_VIEW, Body::Raster(raster(step))),
        View::new(LIST_VIEW, Body::Lists(lists(step))),
    ];
    fitting(scenery, views)
}

/// The box that is asked, in view space.
fn asked_box(step: &Step<'_, Shown>) -> Option<AlignedBox> {
    let (bounds, _) = step.state.query?;
    let [[x, y, z], [right, top, front]] = bounds?;
    AlignedBox::new([x, y, z, right, top, front]).ok()
}

/// The picture so far by objects, the box over it, and where it would be seen.
fn raster(step: &Step<'_, Shown>) -> Raster {
    let own = &step.input.own;
    let [columns, rows] = own.surfaces.size().map(|side| side as usize);
    // Objects are in the order of their triangles.
    let object_of = |id: u32| own.objects.partition_point(|object| object.first <= id) as u32 - 1;
    let picture = step.state.so_far.picture.renamed(object_of);
    let drawn = match step.event {
        Some(Event::Draw { object_idx, .. }) => Some(object_idx as u32),
        Some(Event::Query { .. } | Event::Skip { .. } | Event::Done) | None => None,
    };
    let mut over: Vec<RasterMark> = asked_box(step)
        .into_iter()
        .flat_map(|it| it.edges())
        .filter_map(|ends| segment(&own.surfaces, ends, Role::Signal))
        .collect();
    let asked = step.state.asked.iter().filter(|_| drawn.is_none());
    over.extend(asked.map(|&(pixel, passes)| {
        let at = pixel.map(|x| f64::from(x) + 0.5);
        let (role, shape) = if passes {
            (Role::Signal, RasterShape::Cross(at))
        } else {
            (Role::Ink, RasterShape::Dot(at))
        };
        RasterMark { role, shape }
    }));
    let names = lettered(&picture, |object| name_of(step.input, object as usize));
    Raster {
        title: Value::Term("raster-so-far"),
        size: [columns, rows],
        // Where pixels are asked, their marks stand in place of letters.
        pixels: pixels(&picture, drawn, |place| {
            let here = [place % columns, place / columns].map(|x| x as u32);
            let is_asked = |_: &Value| step.state.asked.iter().any(|(pixel, _)| *pixel == here);
            names(place).filter(|name| !is_asked(name))
        }),
        scale: None,
        current: None,
        over,
    }
}

/// Each object with its pixels, those at which its box would be seen, and what becomes of it.
fn lists(step: &Step<'_, Shown>) -> Lists {
    let state = step.state;
    let objects = &step.input.own.objects;
    let row = |object_idx: usize| {
        let answer = state.answers.iter().find(|(of, _)| *of == object_idx);
        let result = answer.map(|(_, result)| result).filter(|it| !it.unasked);
        let fate = if state.skipped.contains(&object_idx) {
            Some(("occlusion-skipped", Role::Discarded))
        } else if !state.drawn.contains(&object_idx) {
            None
        } else if objects[object_idx].is_occluder {
            Some(("occlusion-is-occluder", Role::Accepted))
        } else {
            Some(("occlusion-drawn", Role::Accepted))
        };
        let is_current = state.object_idx == Some(object_idx);
        let role = fate.map_or(Role::Ink, |(_, role)| role);
        ListRow {
            details: vec![
                result.map(|it| Value::Count(it.asked as usize)),
                result.map(|it| Value::Count(it.passed as usize)),
                fate.map(|(key, _)| Value::Term(key)),
            ],
            role: if is_current { Role::Signal } else { role },
            link: Some(object_link(object_idx)),
            ..ListRow::new(name_of(step.input, object_idx))
        }
    };
    let focus = state.object_idx;
    let reach = ListColumn::reach(objects.len(), focus);
    let columns = ["occlusion-asked", "occlusion-passed", "story-fate"];
    let column = ListColumn {
        columns: columns.map(Value::Term).to_vec(),
        n_before: reach.start,
        n_after: objects.len() - reach.end,
        focus: focus.map(|at| at - reach.start),
        ..ListColumn::new(Value::Term("occlusion-objects"), reach.map(row).collect())
    };
    Lists {
        lists: vec![column],
        links: Vec::new(),
        legend: Vec::new(),
    }
}
