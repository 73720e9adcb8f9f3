//! The funnel's two views: each object by its fate, and each of its triangles.

use crate::{
    algo::cull::{Funnel, FunnelEvent as Event, FunnelObject, TriangleFate, asked_camera},
    labs::frustum::prelude::*,
};

use super::{
    super::{asked::fate_of, back_face},
    Now, sphere,
    variant::Variant,
};

/// Of scenes with more triangles the faces of objects that are done with are not asked again for the picture.
const MOST_ASKED_AGAIN: usize = 2_000;

struct Known {
    classes: Vec<Containment>,
    /// Of each object that is done with, which of its faces show their front.
    fronts: Vec<Vec<bool>>,
    now: Now,
    /// Of the triangles of the object whose turn it is, which have been left out.
    dropped: Vec<bool>,
}

impl Known {
    fn of<L: Variant>(at: &At<'_, Funnel<L>>) -> Self {
        let (input, held) = (at.step.input, at.step.held);
        let n_triangles: usize = input.objects.iter().map(|o| o.triangles.len()).sum();
        let n_done = if n_triangles > MOST_ASKED_AGAIN {
            0
        } else {
            held.object_idx
        };
        let viewer = asked_viewer::<L>(&input.camera);
        let fronts = |object: &FunnelObject| {
            let faces = object.triangles.iter();
            let asked = faces.map(|&triangle| BackFaceInput { triangle, viewer });
            asked
                .map(|input| silent::<BackFace<L>>(&input).front)
                .collect()
        };
        let class = |event: &Event| match *event {
            Event::Sphere { class, .. } => Some(class),
            _ => None,
        };
        let object = input.objects.get(held.object_idx);
        let n_faces = object.map_or(0, |object| object.triangles.len());
        Self {
            classes: at.step.past.iter().filter_map(class).collect(),
            fronts: input.objects[..n_done].iter().map(fronts).collect(),
            now: Now::of(at),
            dropped: dropped(at.step.past, n_faces),
        }
    }

    fn fate(&self, object_idx: usize) -> Fate {
        fate_of(self.classes.get(object_idx).copied())
    }

    fn is_dropped(&self, object_idx: usize, face_idx: usize) -> bool {
        if let Some(fronts) = self.fronts.get(object_idx) {
            return fronts.get(face_idx) == Some(&false);
        }
        self.now.object_idx == Some(object_idx) && self.dropped.get(face_idx) == Some(&true)
    }

    /// In the observer's view what is dropped is pale, in the camera's it is not there.
    fn look(&self, object_idx: usize, face_idx: usize, dropped: FaceLook) -> FaceLook {
        if self.now.object_idx == Some(object_idx) && self.now.face_idx == Some(face_idx) {
            FaceLook::Own(Role::Signal)
        } else if self.is_dropped(object_idx, face_idx) {
            dropped
        } else {
            FaceLook::Whole
        }
    }
}

fn dropped(past: &[Event], n_faces: usize) -> Vec<bool> {
    let mut dropped = vec![false; n_faces];
    for event in past.iter().rev() {
        match *event {
            Event::Triangle {
                triangle_idx,
                fate: TriangleFate::Outside,
                ..
            }
            | Event::Face {
                triangle_idx,
                front: false,
                ..
            } => dropped[triangle_idx] = true,
            Event::Triangle { .. } | Event::Face { .. } => {}
            Event::Object { .. } | Event::Plane { .. } | Event::Sphere { .. } | Event::Done => {
                break;
            }
        }
    }
    dropped
}

fn asked_face<L: Variant>(at: &At<'_, Funnel<L>>) -> Option<[[f64; 3]; 3]> {
    let now = Now::of(at);
    let object = at.step.input.objects.get(now.object_idx?)?;
    object.triangles.get(now.face_idx?).copied()
}

/// Into what the clipper cuts the triangle that is asked.
fn pieces<L: Variant>(at: &At<'_, Funnel<L>>) -> Vec<Mark3> {
    let Some(Event::Triangle {
        fate: TriangleFate::Cut,
        ..
    }) = at.step.event()
    else {
        return Vec::new();
    };
    let corners = asked_face(at).map(|face| face.map(SpaceVertex::new));
    let planes = at.step.input.camera.planes_in_world().to_vec();
    let cut =
        corners.map(|triangle| silent::<IntersectionPolygon>(&TrianglePlanes { planes, triangle }));
    let pieces = cut.into_iter().flat_map(|cut| cut.triangles).enumerate();
    let mark = |(i, piece): (usize, [SpaceVertex; 3])| {
        let corners = piece.map(|vertex| vertex.at).to_vec();
        let outline = Mark3::new(Role::Accent, Shape3::Outline(corners));
        outline.labelled(name(numbered('T', i)))
    };
    pieces.map(mark).collect()
}

/// n and e of the face that is asked, as these rules compute them.
fn arrows<L: Variant>(at: &At<'_, Funnel<L>>) -> Vec<Mark3> {
    let Some(Event::Face { .. }) = at.step.event() else {
        return Vec::new();
    };
    asked_face(at).map_or_else(Vec::new, |triangle| {
        let viewer = asked_viewer::<L>(&at.step.input.camera);
        let asked = Recording::<BackFace<L>>::new(BackFaceInput { triangle, viewer });
        back_face::arrows(asked.input(), asked.events())
    })
}

pub fn both<L: Variant>(at: &At<'_, Funnel<L>>, scenery: &Scenery) -> [View; 2] {
    let known = Known::of(at);
    let camera = asked_camera::<L>(&at.step.input.camera);
    let fate = |i| known.fate(i);
    let outline = |face: [[f64; 3]; 3]| {
        let corners = face.to_vec();
        Mark3::new(Role::Signal, Shape3::Outline(corners))
    };
    let triangle = asked_face(at).map(outline);
    let mut marks = match &triangle {
        Some(triangle) => [vec![triangle.clone()], pieces(at), arrows(at)].concat(),
        None => sphere(at).map_or(Vec::new(), |sphere| sphere.marks(&camera)),
    };
    if camera != at.step.input.camera {
        // What is asked is not what is drawn.
        let asked = volume(&camera).into_iter();
        marks.extend(
            asked.filter(|mark| matches!(mark.shape, Shape3::Segment(_) | Shape3::Outline(_))),
        );
    }
    let pale = |object, face| known.look(object, face, FaceLook::Own(Role::Discarded));
    let gone = |object, face| known.look(object, face, FaceLook::Hidden);
    [
        scenery.observer_with(fate, pale, marks),
        scenery.camera(fate, gone, triangle.into_iter().collect()),
    ]
}
