//! The funnel's two views: each object by its fate, and each of its triangles.

use crate::{
    algo::cull::{
        BackFace, BackFaceInput, CullRules, FunnelEvent as Event, FunnelObject, TriangleFate,
        asked_camera, asked_sphere, asked_viewer,
    },
    figure::{Mark3, Role, Shape3, View},
    labs::Step,
    trace::silent,
};

use super::{
    super::{
        super::stage::{FaceLook, Fate, Scenery},
        planes::fate_of,
        sphere_cull::{Asked, sphere_marks},
    },
    Shown, side_idx,
};

/// Of scenes with more triangles the faces of objects that are done with are not asked again for the picture.
const MOST_ASKED_AGAIN: usize = 2_000;

/// What is known of all objects and faces at a step.
struct Known<'a, L: CullRules> {
    step: &'a Step<'a, Shown<L>>,
    /// Of each object that is done with, which of its faces show their front.
    fronts: Vec<Vec<bool>>,
}

impl<'a, L: CullRules> Known<'a, L> {
    fn of(step: &'a Step<'a, Shown<L>>) -> Self {
        let input = &step.input.own;
        let n_triangles: usize = input.objects.iter().map(|o| o.triangles.len()).sum();
        let n_done = match step.state.object_idx {
            _ if n_triangles > MOST_ASKED_AGAIN => 0,
            Some(object_idx) => object_idx,
            None => step.state.classes.len(),
        };
        let viewer = asked_viewer::<L>(&input.camera);
        let fronts = |object: &FunnelObject| {
            let faces = object.triangles.iter();
            let asked = faces.map(|&triangle| BackFaceInput { triangle, viewer });
            asked
                .map(|input| silent::<BackFace<L>>(&input).front)
                .collect()
        };
        Self {
            step,
            fronts: input.objects[..n_done].iter().map(fronts).collect(),
        }
    }

    fn fate(&self, object_idx: usize) -> Fate {
        fate_of(self.step.state.classes.get(object_idx).copied())
    }

    /// Is it known that nothing of a face is drawn?
    fn is_dropped(&self, object_idx: usize, face_idx: usize) -> bool {
        if let Some(fronts) = self.fronts.get(object_idx) {
            return fronts.get(face_idx) == Some(&false);
        }
        let state = self.step.state;
        if state.object_idx != Some(object_idx) {
            return false;
        }
        let mut faces = state.faces.iter();
        let mut triangles = state.triangles.iter();
        faces.any(|&known| known == (face_idx, false))
            || triangles.any(|&known| known == (face_idx, TriangleFate::Outside))
    }

    fn is_current(&self, object_idx: usize, face_idx: usize) -> bool {
        self.step.state.object_idx == Some(object_idx) && current_face(self.step) == Some(face_idx)
    }

    /// In the observer's view what is dropped is pale, in the camera's it is not there.
    fn look(&self, object_idx: usize, face_idx: usize, dropped: FaceLook) -> FaceLook {
        if self.is_current(object_idx, face_idx) {
            FaceLook::Own(Role::Signal)
        } else if self.is_dropped(object_idx, face_idx) {
            dropped
        } else {
            FaceLook::Whole
        }
    }
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
fn triangle<L: CullRules>(step: &Step<'_, Shown<L>>) -> Option<Mark3> {
    let object = step.input.own.objects.get(step.state.object_idx?)?;
    let corners = object.triangles.get(current_face(step)?)?.to_vec();
    Some(Mark3::new(Role::Signal, Shape3::Outline(corners)))
}

/// The sphere of this step, and the plane that is asked of it.
fn sphere<L: CullRules>(step: &Step<'_, Shown<L>>) -> Vec<Mark3> {
    let input = &step.input.own;
    let object = step.state.object_idx.and_then(|i| input.objects.get(i));
    let is_asked = current_face(step).is_none();
    let Some(object) = object.filter(|_| is_asked) else {
        return Vec::new();
    };
    let known = side_idx(step).zip(step.state.sphere.asked.last());
    let asked = known.map(|(plane_idx, &(distance, _))| Asked {
        camera: asked_camera::<L>(&input.camera),
        plane_idx,
        distance,
    });
    sphere_marks(&asked_sphere::<L>(object), asked.as_ref())
}

/// The observer's view and the camera's.
pub fn both<L: CullRules>(step: &Step<'_, Shown<L>>, scenery: &Scenery) -> [View; 2] {
    let known = Known::of(step);
    let fate = |i| known.fate(i);
    let mut marks = sphere(step);
    marks.extend(triangle(step));
    let pale = |object, face| known.look(object, face, FaceLook::Own(Role::Discarded));
    let gone = |object, face| known.look(object, face, FaceLook::Hidden);
    [
        scenery.observer_with(fate, pale, marks),
        scenery.camera(fate, gone, triangle(step).into_iter().collect()),
    ]
}
