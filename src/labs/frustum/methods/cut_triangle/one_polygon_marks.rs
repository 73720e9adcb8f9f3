//! The drawing of a triangle that is cut as one polygon, with a checkered texture where it has one.

use crate::algo::volume::IntersectionPolygonEvent as Event;

use super::{clip_space::on_screen, prelude::*, stages::stages};

pub fn rings<'a, L: Variant<OnePolygon>>(
    step: &Step<'a, IntersectionPolygon<L>>,
) -> RingStep<'a, SpaceVertex> {
    let is_turn = |event: &Event| matches!(event, Event::Plane { .. });
    RingStep::of(&step.held.lists, step.past, is_turn)
}

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

/// In the fan of more vertices the triangles are too narrow for names.
const MOST_NAMED: usize = 7;

/// Is the fan what is shown: once it has begun, of one method and without a texture?
pub fn is_fan_shown<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
    scenery: Option<&Scenery>,
) -> bool {
    let has_begun = !step.held.left.triangles.is_empty();
    has_begun && !L::IS_TEXTURED && scenery.is_none_or(is_alone)
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
        marks.extend(checkered(&fan(step)));
    }
    let is_fan_shown = is_fan_shown(step, Some(scenery));
    for (i, triangle) in step.held.left.triangles.iter().enumerate() {
        let outline = Mark3::new(Role::Accent, Shape3::Outline(places(triangle)));
        if is_fan_shown {
            let washes = (0..=2 * (i % 2)).map(|_| wash(places(triangle)));
            let label = (list.len() <= MOST_NAMED).then(|| triangle_label(i, triangle));
            marks.extend(washes.chain([outline]).chain(label));
        } else {
            marks.push(outline.fine());
        }
    }
    let is_measured = has_passed && !is_alone(scenery);
    if plane_idx.is_some() {
        marks.extend(parts.cuts_of(&rings.turn.crossings));
    }
    for (i, v) in list.iter().enumerate() {
        let inside = match plane_idx {
            Some(_) => rings.turn.sides.get(i).map(|&(_, inside)| inside),
            None => Some(true),
        };
        let mut mark = vertex(i, v, inside);
        if let Some((d, _)) = rings.turn.sides.get(i).filter(|_| is_measured) {
            mark = mark.labelled(measured(i, *d));
        }
        marks.push(parts.linked(mark, v));
    }
    marks
}

fn at_work_marks<L: Variant<OnePolygon>>(
    step: &Step<'_, IntersectionPolygon<L>>,
    list: &[SpaceVertex],
    plane: &Plane,
) -> Vec<Mark3> {
    let mut marks: Vec<Mark3> = lost(list, plane).into_iter().collect();
    if matches!(step.event(), Some(Event::Pass { .. })) {
        let left = step.held.lists.list();
        marks.extend(kept(places(left), Role::Accent));
        if left.len() == 2 {
            marks.push(label_amid(left, Value::Term("tri-none")));
        }
    } else {
        marks.push(Mark3::new(Role::Accent, Shape3::Outline(places(list))));
    }
    if let Some(asked) = step.event().and_then(|event| asked_now(&event)) {
        let label = sym("d").equals(asked.distance);
        marks.extend(perpendicular(label, plane, asked.at.at, asked.distance));
    }
    marks
}

fn left_marks<L: Variant<OnePolygon>>(step: &Step<'_, IntersectionPolygon<L>>) -> Vec<Mark3> {
    let list = step.held.lists.list();
    let right = right_result::<L>(step);
    let is_wrong = right.is_some();
    let role = if is_wrong { Role::Signal } else { Role::Accent };
    let mut marks = if L::IS_TEXTURED {
        vec![Mark3::new(role, Shape3::Outline(places(list)))]
    } else {
        kept(places(list), role)
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

const FIELDS: usize = 6;

/// The dark fields, and a light ground under them: of triangles whose corners have places in the texture.
pub fn checkered(triangles: &[[SpaceVertex; 3]]) -> Vec<Mark3> {
    let mut marks = Vec::new();
    for triangle in triangles {
        let Some(corners) = placed(triangle) else {
            continue;
        };
        let dark = (0..FIELDS * FIELDS).map(|i| [i % FIELDS, i / FIELDS]);
        for field in dark.filter(|[i, j]| (i + j) % 2 == 0) {
            let part = part_in(&corners, field);
            // Tint over tint: dark enough to be told from the ground at a glance.
            for _ in 0..4 {
                marks.extend((part.len() > 2).then(|| wash(part.clone())));
            }
        }
        marks.push(wash(corners.iter().map(|(at, _)| *at).collect()));
    }
    marks
}

/// The same as the camera sees it where (u, v) is mixed evenly over the screen: as if all corners were at one depth.
pub fn checkered_on_screen(triangles: &[[SpaceVertex; 3]], camera: &Camera) -> Vec<Mark3> {
    checkered(&flattened(triangles, camera))
}

fn flattened(triangles: &[[SpaceVertex; 3]], camera: &Camera) -> Vec<[SpaceVertex; 3]> {
    let clip_from_world = camera.clip_from_world();
    let flat = triangles.iter().map(|triangle| {
        triangle.map(|SpaceVertex { at: [x, y, z], uv }| SpaceVertex {
            at: on_screen(camera, clip_from_world.times([x, y, z, 1.0])),
            uv,
        })
    });
    flat.collect()
}

/// What is looked for in both pictures: the fan's edges, the corners' names, and a field
/// that one of those edges runs through.
pub fn compared<L: Variant<OnePolygon>>(fan: &[[SpaceVertex; 3]], camera: &Camera) -> Vec<Mark3> {
    let flat = flattened(fan, camera);
    let shown = if L::IS_EVEN_ON_SCREEN { &flat } else { fan };
    let (field, edges) = if L::IS_EVEN_ON_SCREEN {
        (Role::Signal, Role::Signal)
    } else {
        (Role::Ink, Role::Soft)
    };
    let parts = |of: [usize; 2]| {
        let parts = shown
            .iter()
            .filter_map(placed)
            .map(move |corners| part_in(&corners, of));
        parts.filter(|part| part.len() > 2)
    };
    let fields = (0..FIELDS * FIELDS).map(|i| [i % FIELDS, i / FIELDS]);
    let mut dark = fields.filter(|[i, j]| (i + j) % 2 == 0);
    let shared = dark.rfind(|&of| parts(of).count() == 2);
    let mut marks: Vec<Mark3> = shared
        .into_iter()
        .flat_map(parts)
        .map(|part| Mark3::new(field, Shape3::Outline(part)))
        .collect();
    let edges = flat.iter().skip(1).map(|triangle| {
        let edge = Mark3::new(edges, Shape3::Segment([triangle[0].at, triangle[1].at]));
        edge.fine().dashed()
    });
    marks.extend(edges);
    let ring = flat.first().into_iter().flatten();
    let ring = ring.chain(flat.iter().skip(1).map(|triangle| &triangle[2]));
    marks.extend(ring.enumerate().map(|(i, v)| {
        let dot = Mark3::new(Role::Accent, Shape3::Dot(v.at));
        dot.labelled(name(vertex_symbol(i)))
    }));
    marks
}

fn wash(outline: Vec<[f64; 3]>) -> Mark3 {
    Mark3::new(Role::Accent, Shape3::Wash(outline))
}

type Placed = ([f64; 3], [f64; 2]);

fn placed(triangle: &[SpaceVertex; 3]) -> Option<[Placed; 3]> {
    let [a, b, c] = triangle.map(|v| Some((v.at, v.uv?)));
    Some([a?, b?, c?])
}

/// The part of a triangle that shows one field: clipped on the texture, where the field is a square, as the renderer clips; what
/// travels along is the place in space.
fn part_in(corners: &[Placed; 3], field: [usize; 2]) -> Vec<[f64; 3]> {
    let on_field = corners.map(|(place, uv)| {
        let [x, y] = [0, 1].map(|i| 2.0 * (uv[i] * FIELDS as f64 - field[i] as f64) - 1.0);
        ClipVertex {
            at: [x, y, 0.0, 1.0],
            attributes: place,
        }
    });
    let part = silent::<HomogeneousTriangle<[f64; 3]>>(&on_field);
    part.vertices().iter().map(|v| v.attributes).collect()
}
