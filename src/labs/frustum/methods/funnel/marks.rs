//! The funnel's two views: each object by its fate, and of the one in hand each triangle.

use crate::{
    algo::cull::{Containment, CullRules, FunnelEvent as Event, TriangleFate},
    figure::{Mark3, Role, Shape3, View},
    labs::Step,
};

use super::{
    super::{
        super::stage::{Fate, Scenery},
        planes::fate_of,
        sphere_cull::sphere_marks,
    },
    Shown, captions, side_idx,
};

/// What is known of each object.
fn fate<L: CullRules>(step: &Step<'_, Shown<L>>, object_idx: usize) -> Fate {
    fate_of(step.state.classes.get(object_idx).copied())
}

/// Of the object in hand what is known of each triangle; of the current one that it is.
fn face_role<L: CullRules>(step: &Step<'_, Shown<L>>, object: usize, face: usize) -> Option<Role> {
    if step.state.object_idx != Some(object) {
        return None;
    }
    if current_face(step) == Some(face) {
        return Some(Role::Signal);
    }
    let faces = step.state.faces.iter();
    let is_back = faces.rev().any(|&(known, front)| known == face && !front);
    let triangles = step.state.triangles.iter();
    let is_outside = triangles
        .rev()
        .any(|&(known, fate)| known == face && fate == TriangleFate::Outside);
    (is_back || is_outside).then_some(Role::Discarded)
}

fn current_face<L: CullRules>(step: &Step<'_, Shown<L>>) -> Option<usize> {
    match step.event {
        Some(Event::Triangle { triangle_idx, .. } | Event::Face { triangle_idx, .. }) => {
            Some(triangle_idx)
        }
        Some(Event::Object { .. } | Event::Plane { .. } | Event::Sphere { .. } | Event::Done)
        | None => None,
    }
}

/// The triangle of this step.
fn triangle<L: CullRules>(step: &Step<'_, Shown<L>>) -> Option<[[f64; 3]; 3]> {
    let object = step.input.own.objects.get(step.state.object_idx?)?;
    object.triangles.get(current_face(step)?).copied()
}

pub fn observer<L: CullRules>(step: &Step<'_, Shown<L>>, scenery: &Scenery) -> View {
    let mut marks = Vec::new();
    let object = step
        .state
        .object_idx
        .and_then(|i| step.input.own.objects.get(i));
    match (object, step.event) {
        (Some(object), Some(Event::Object { .. } | Event::Plane { .. } | Event::Sphere { .. })) => {
            let known = side_idx(step).zip(step.state.sphere.asked.last());
            let current: Option<(usize, f64, Containment)> =
                known.map(|(idx, &(d, class))| (idx, d, class));
            let sphere = captions::sphere::<L>(object);
            marks.extend(sphere_marks(scenery, &sphere, current));
        }
        _ => marks.extend(
            triangle(step)
                .map(|corners| Mark3::new(Role::Signal, Shape3::Outline(corners.to_vec()))),
        ),
    }
    let role = |object, face| face_role(step, object, face);
    scenery.observer_with(|i| fate(step, i), role, marks)
}

pub fn camera<L: CullRules>(step: &Step<'_, Shown<L>>, scenery: &Scenery) -> View {
    let outline =
        triangle(step).map(|corners| Mark3::new(Role::Signal, Shape3::Outline(corners.to_vec())));
    let role = |object, face| face_role(step, object, face);
    scenery.camera(|i| fate(step, i), role, outline.into_iter().collect())
}
