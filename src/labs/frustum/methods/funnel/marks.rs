//! The funnel's two views: each object by its fate, and each of its triangles.

use crate::{
    algo::cull::{Funnel, FunnelEvent as Event, FunnelObject, TriangleFate, Viewer, asked_camera},
    labs::frustum::prelude::*,
};

use super::{
    super::{asked::fate_of, back_face, cut_triangle::vertex},
    Now, is_compared, n_inside, sphere,
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
        // The plane beyond which a sphere lies decides, before the object is said to be culled.
        let outside = Containment::Outside;
        let is_beyond =
            |event: &&Event| matches!(**event, Event::Plane { class, .. } if class == outside);
        let last = at.step.past.last().filter(is_beyond);
        let classes = at.step.past.iter().filter_map(class);
        let object = input.objects.get(held.object_idx);
        let n_faces = object.map_or(0, |object| object.triangles.len());
        Self {
            classes: classes.chain(last.map(|_| outside)).collect(),
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

/// Of the triangle that is asked: into what the clipper cuts it, and n and e as these rules compute them.
fn of_face<L: Variant>(at: &At<'_, Funnel<L>>, face: [[f64; 3]; 3]) -> Vec<Mark3> {
    let now = Now::of(at);
    let camera = &at.step.input.camera;
    match at.step.event() {
        Some(Event::Triangle {
            codes,
            fate: TriangleFate::Cut,
            ..
        }) => {
            let cut = silent::<IntersectionPolygon>(&TrianglePlanes {
                planes: camera.planes_in_world().to_vec(),
                triangle: face.map(SpaceVertex::new),
            });
            // What is seen of a triangle without a vertex inside stands out.
            let is_across = n_inside(codes) == 0 && !is_compared(at);
            let marks = |(i, piece): (usize, &[SpaceVertex; 3])| {
                let piece = piece.map(|vertex| vertex.at).to_vec();
                let wash = Mark3::new(Role::Accent, Shape3::Wash(piece.clone()));
                let outline = Mark3::new(Role::Accent, Shape3::Outline(piece));
                let outline = outline.labelled(name(numbered('T', i)));
                std::iter::once(outline).chain(is_across.then_some(wash))
            };
            let corners = face.iter().enumerate().filter(|_| is_across);
            let corners = corners.map(|(i, &at)| vertex(i, &SpaceVertex::new(at), Some(false)));
            let pieces = cut.triangles.iter().enumerate().flat_map(marks);
            pieces.chain(corners.map(Mark3::strong)).collect()
        }
        Some(Event::Face { .. }) => {
            let (triangle, viewer) = (face, asked_viewer::<L>(camera));
            let asked = Recording::<BackFace<L>>::new(BackFaceInput { triangle, viewer });
            let mut marks = back_face::arrows(asked.input(), asked.events());
            if matches!(viewer, Viewer::Direction(_)) {
                let others = at.step.input.objects.iter();
                let others = others.filter_map(|it| Some(it.triangles.get(now.face_idx?)?[0]));
                let others = others.filter(|&corner| corner != face[0]);
                let others = others.chain([camera.position()]);
                marks.extend(others.map(|corner| back_face::to_viewer(corner.into(), viewer).1));
            }
            marks
        }
        Some(
            Event::Object { .. }
            | Event::Plane { .. }
            | Event::Sphere { .. }
            | Event::Triangle { .. }
            | Event::Done,
        )
        | None => Vec::new(),
    }
}

pub fn both<L: Variant>(at: &At<'_, Funnel<L>>, scenery: &Scenery) -> [View; 2] {
    let known = Known::of(at);
    let camera = asked_camera::<L>(&at.step.input.camera);
    let fate = |i| known.fate(i);
    let face = asked_face(at);
    let outline = |face: [[f64; 3]; 3]| Shape3::Outline(face.to_vec());
    let triangle = face.map(|face| Mark3::new(Role::Signal, outline(face)));
    let mut marks: Vec<Mark3> = triangle.iter().cloned().collect();
    match face {
        Some(face) => marks.extend(of_face(at, face)),
        None => marks.extend(
            sphere(at)
                .into_iter()
                .flat_map(|sphere| sphere.marks(&camera)),
        ),
    }
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
