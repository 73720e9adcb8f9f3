//! The drawing of a triangle that is cut as one polygon.

use crate::{
    algo::{
        ring::{Crossing, Right},
        volume::{IntersectionPolygon, IntersectionPolygonEvent as Event, SpaceVertex},
    },
    figure::{Mark3, Role, Shape3},
    geom::Plane,
    labs::rings::{RingStep, asked_vertex},
    trace::Step,
};

use super::{
    super::super::stage::Scenery,
    marks::{
        cut, cut_edge, distance_mark, given, kept, lost, places, plane_mark, vertex, with_texel,
    },
    parts::{Parts, of_polygon},
    stages::stages,
    symbols::{cut_symbol, vertex_symbol},
    texture::checkered,
    variant::{OnePolygon, Variant},
};

/// Both lists, and what has been told of the plane at work.
pub fn rings<'a, L: Variant<OnePolygon>>(
    step: &Step<'a, IntersectionPolygon<L>>,
) -> RingStep<'a, SpaceVertex> {
    let is_turn = |event: &Event| matches!(event, Event::Plane { .. });
    RingStep::of(&step.held.lists, step.past, is_turn)
}

/// The plane whose turn it is.
pub fn plane_idx<L: Variant<OnePolygon>>(step: &Step<'_, IntersectionPolygon<L>>) -> Option<usize> {
    match step.event()? {
        Event::Plane { plane_idx } | Event::Pass { plane_idx, .. } => Some(plane_idx),
        Event::Fan { .. } | Event::Done { .. } => None,
        Event::First { .. } | Event::Test { .. } | Event::Cross { .. } | Event::Output { .. } => {
            Some(step.held.lists.n_passed())
        }
    }
}

pub fn parts<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
) -> Parts<SpaceVertex> {
    of_polygon(step.input.triangle, step.past)
}

/// The polygon as it stands, as triangles with a texture: what has been put out of it, once it is done with.
pub fn fan<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
) -> Vec<[SpaceVertex; 3]> {
    let ring = step.held.lists.list();
    (2..ring.len())
        .map(|i| [ring[0], ring[i - 1], ring[i]])
        .collect()
}

pub fn marks<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
    scenery: &Scenery,
) -> Vec<Mark3> {
    let (own, parts, rings) = (step.input, parts(step), rings(step));
    let mut marks = given(&own.triangle.map(|v| v.at));
    let has_passed = matches!(step.event(), Some(Event::Pass { .. }));
    let list = if has_passed { rings.passed } else { rings.list };
    let plane_idx = plane_idx(step);
    match plane_idx {
        Some(plane_idx) => {
            marks.extend(plane_mark(scenery, plane_idx));
            marks.extend(at_work_marks(step, list, &own.planes[plane_idx]));
        }
        None => marks.extend(left_marks(step)),
    }
    if own.triangle[0].uv.is_some() {
        marks.extend(checkered(&fan(step), Role::Accent));
    }
    for triangle in &step.held.left.triangles {
        marks.push(Mark3::new(Role::Accent, Shape3::Outline(places(triangle))).fine());
    }
    if plane_idx.is_some() {
        let cuts = || {
            rings
                .turn
                .crossings
                .iter()
                .map(|(_, Crossing { at, .. })| at)
        };
        marks.extend(cut_edge(&cuts().map(|v| v.at).collect::<Vec<_>>()));
        marks.extend(cuts().enumerate().map(|(i, v)| {
            let mark = with_texel(cut(i, v.at), &cut_symbol(i), v.uv);
            parts.linked(mark, v)
        }));
    }
    for (i, v) in list.iter().enumerate() {
        let inside = match plane_idx {
            Some(_) => rings.turn.sides.get(i).map(|&(_, inside)| inside),
            None => Some(true),
        };
        let mark = with_texel(vertex(i, v.at, inside), &vertex_symbol(i), v.uv);
        marks.push(parts.linked(mark, v));
    }
    marks
}

/// While a plane is at work: the polygon that it takes, what it loses of that, and the distance that is measured.
fn at_work_marks<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
    list: &[SpaceVertex],
    plane: &Plane,
) -> Vec<Mark3> {
    let mut marks: Vec<Mark3> = lost(list, plane).into_iter().collect();
    if matches!(step.event(), Some(Event::Pass { .. })) {
        marks.extend(kept(step.held.lists.list(), Role::Accent));
    } else {
        marks.push(Mark3::new(Role::Accent, Shape3::Outline(places(list))));
    }
    let d = match step.event() {
        Some(Event::First { distance, .. }) => Some(distance),
        Some(Event::Test { distances, .. }) => Some(distances[1]),
        Some(
            Event::Plane { .. }
            | Event::Cross { .. }
            | Event::Output { .. }
            | Event::Pass { .. }
            | Event::Fan { .. }
            | Event::Done { .. },
        )
        | None => None,
    };
    let asked = step.event().and_then(|event| asked_vertex(&event));
    if let Some((v, d)) = asked.zip(d) {
        marks.extend(distance_mark(plane, v.at, d));
    }
    marks
}

/// Before the first plane and after the last one: the polygon, and the right one where it is another.
fn left_marks<L: Variant<OnePolygon>>(step: &Step<'_, IntersectionPolygon<L>>) -> Vec<Mark3> {
    let list = step.held.lists.list();
    let right = right_result::<L>(step);
    let role = if right.is_some() {
        Role::Signal
    } else {
        Role::Accent
    };
    let mut marks = if L::IS_TEXTURED {
        vec![Mark3::new(role, Shape3::Outline(places(list)))]
    } else {
        kept(list, role)
    };
    let outline = |ring: Vec<_>| Mark3::new(Role::Accent, Shape3::Outline(places(&ring)));
    marks.extend(right.map(outline));
    marks
}

/// Once a wrong run is over: the polygon that the right rules leave, where it is another.
fn right_result<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
) -> Option<Vec<SpaceVertex>> {
    if L::DIFFERS_KEY.is_none() || !matches!(step.event(), Some(Event::Done { .. })) {
        return None;
    }
    let right = stages::<IntersectionPolygon<Right>>(step.input);
    let ring = right.last()?.after.first()?.clone();
    (places(&ring) != places(step.held.lists.list())).then_some(ring)
}
