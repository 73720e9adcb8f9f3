//! What can be taken hold of in a scene.

use glam::DVec3;

use crate::{
    figure::Link,
    geom::VolumeSide,
    labs::{Draggable, Handle, HandleKind, Motion, words::subscript},
    text::{Diagnostic, Message, Value},
};

use super::{
    Opening, Places, Scene, Subject,
    stage::{object_link, side_link},
};

/// Corners of the view volume, by their numbers: the ends of the edges that near, far and the opening are taken hold of by. None of
/// these handles lies on the axis, where camera and target are.
const NEAR_EDGE: [usize; 2] = [1, 3];
const FAR_EDGE: [usize; 2] = [5, 7];
const TOP_EDGE: [usize; 2] = [6, 7];

const fn kind(
    id: &'static str,
    group: &'static str,
    name: fn([usize; 2]) -> Message,
) -> HandleKind {
    HandleKind {
        motion: Motion::FacingEye,
        ..HandleKind::new(id, group, name)
    }
}

const fn marked(
    id: &'static str,
    group: &'static str,
    name: fn([usize; 2]) -> Message,
) -> HandleKind {
    HandleKind {
        is_marked: true,
        ..kind(id, group, name)
    }
}

static POSITION: HandleKind = kind("camera", "camera", |_| Message::new("handle-camera"));
static TARGET: HandleKind = kind("target", "camera", |_| Message::new("handle-target"));
static NEAR: HandleKind = kind("near", "volume", |_| Message::new("handle-near"));
static FAR: HandleKind = kind("far", "volume", |_| Message::new("handle-far"));
static TOP: HandleKind = kind("top", "volume", |_| Message::new("handle-top"));
static POINT: HandleKind = marked("point", "point", |_| Message::new("handle-point"));
static END: HandleKind = marked("end", "segment", |[i, _]| {
    Message::new("handle-space-end").with("number", i + 1)
});
static CORNER: HandleKind = marked("corner", "triangle", |[i, _]| {
    let vertex = format!("V{}", subscript(i));
    Message::new("handle-space-corner").with("vertex", Value::Name(vertex))
});
static OBJECT: HandleKind = HandleKind {
    is_vertex: true,
    is_whole: true,
    link: Some(|[i, _]| object_link(i)),
    ..kind("object", "object", |[i, _]| {
        Message::new("handle-object").with("number", i + 1)
    })
};

static OBJECT_CORNER: HandleKind = HandleKind {
    link: Some(|[i, _]| object_link(i)),
    ..kind("object-corner", "object", |[i, corner]| {
        Message::new("handle-object-corner")
            .with("number", i + 1)
            .with("corner", corner + 1)
    })
};

/// In a scene of more objects corners cannot be taken hold of by themselves.
const MOST_WITH_CORNERS: usize = 12;

pub fn object(object_idx: usize) -> Handle {
    OBJECT.at([object_idx, 0])
}

impl Draggable for Scene {
    fn handles(&self) -> Vec<Handle> {
        let mut handles: Vec<Handle> = Vec::new();
        if self.asks(Subject::Point) {
            handles.push(POINT.at([0, 0]));
        }
        if self.asks(Subject::Segment) || self.asks(Subject::BoxedSegment) {
            handles.extend([0, 1].map(|i| END.at([i, 0])));
        }
        if self.asks(Subject::Triangle) {
            handles.extend([0, 1, 2].map(|i| CORNER.at([i, 0])));
        }
        if self.shows_camera() {
            let camera = [&POSITION, &TARGET, &NEAR, &FAR, &TOP];
            handles.extend(camera.map(|kind| kind.at([0, 0])));
        }
        if self.shows_objects() {
            handles.extend((0..self.objects().len()).map(object));
            let has_few = self.objects().len() <= MOST_WITH_CORNERS;
            let corners = |i: usize| [0, 1, 2].map(|corner| OBJECT_CORNER.at([i, corner]));
            let triangles = (0..self.objects().len())
                .filter(|&i| has_few && self.objects()[i].model().is_triangle());
            handles.extend(triangles.flat_map(corners));
        }
        handles
    }

    /// An object is called as it is in the picture.
    fn called(&self, handle: Handle) -> Message {
        let [i, corner] = handle.idx();
        let of_object = |key| Message::new(key).with("number", self.object_name(i));
        match handle.kind().id {
            "object" => of_object("handle-object"),
            "object-corner" => of_object("handle-object-corner").with("corner", corner + 1),
            _ => handle.name(),
        }
    }

    fn position(&self, handle: Handle) -> Option<[f64; 3]> {
        let [position, target, _] = self.camera.places();
        let [i, corner] = handle.idx();
        Some(match handle.kind().id {
            "camera" => position,
            "target" => target,
            "near" => self.middle_of(NEAR_EDGE).into(),
            "far" => self.middle_of(FAR_EDGE).into(),
            "top" => self.middle_of(TOP_EDGE).into(),
            "point" => self.places().point,
            "end" => *self.places().segment.get(i)?,
            "corner" => *self.places().triangle.get(i)?,
            "object-corner" => self.objects().get(i)?.points().nth(corner)?,
            _ => self.objects().get(i)?.at(),
        })
    }

    /// A triangle in its middle: the origin of its coordinates can be anywhere. An end where its method draws it.
    fn held_at(&self, handle: Handle) -> Option<[f64; 3]> {
        if handle.kind().id == "end" {
            let at = self.position(handle)?;
            return Some((self.method.info().drawn)(self, at));
        }
        let object = self.objects().get(handle.idx()[0]);
        let triangle = object.filter(|it| handle.is(&OBJECT) && it.model().is_triangle());
        let Some(triangle) = triangle else {
            return self.position(handle);
        };
        let sum: DVec3 = triangle.points().map(DVec3::from).sum();
        Some((sum / 3.0).into())
    }

    /// Planes go along the volume's side, its opening upwards.
    fn motion(&self, handle: Handle) -> Motion {
        match handle.kind().id {
            "near" | "far" => {
                Motion::Axis((self.middle_of(FAR_EDGE) - self.middle_of(NEAR_EDGE)).into())
            }
            "top" => {
                let [_, up, _] = self.camera.camera().axes();
                Motion::Axis(up)
            }
            _ => handle.kind().motion,
        }
    }

    /// While culling is frozen the planes that are named are not this camera's.
    fn seized(&self, link: Link) -> Option<Handle> {
        let own = [
            (side_link(VolumeSide::Near), &NEAR),
            (side_link(VolumeSide::Far), &FAR),
            (Link::to("camera"), &POSITION),
        ];
        let is_own = |kind: &HandleKind| self.frozen.is_none() || kind.id == POSITION.id;
        let mut own = own.into_iter().filter(|(_, kind)| is_own(kind));
        let own = own.find(|(of, _)| *of == link);
        // Faces are told of the object in hand only.
        let of_face = link.number_of("face").map(|_| self.focus());
        let object_idx = link.number_of("object").or(of_face);
        own.map(|(_, kind)| kind.at([0, 0]))
            .or(object_idx.map(object))
    }

    /// The distance of a plane, the opening of the view volume.
    fn measure(&self, handle: Handle) -> Option<f64> {
        let [near, far] = self.camera.depths();
        match handle.kind().id {
            "near" => Some(near),
            "far" => Some(far),
            "top" => Some(match self.camera.opening() {
                Opening::FovY(degrees) => degrees,
                Opening::Height(height) => height,
            }),
            _ => None,
        }
    }

    fn set_measure(&mut self, handle: Handle, to: f64) -> Result<(), Diagnostic> {
        self.camera = self.camera.with(|it| match handle.kind().id {
            "near" => it.depths[0] = to,
            "far" => it.depths[1] = to,
            _ => {
                it.opening = match it.opening {
                    Opening::FovY(_) => Opening::FovY(to),
                    Opening::Height(_) => Opening::Height(to),
                }
            }
        })?;
        Ok(())
    }

    fn drag(&mut self, handle: Handle, to: [f64; 3]) -> Result<(), Diagnostic> {
        let (camera, places) = (self.camera, self.places());
        let [_, height, depth] = camera.camera().view_from_world().point(to);
        let [i, corner] = handle.idx();
        match handle.kind().id {
            "camera" => self.camera = camera.with(|it| it.places[0] = to)?,
            "target" => self.camera = camera.with(|it| it.places[1] = to)?,
            "near" => self.camera = camera.with(|it| it.depths[0] = -depth)?,
            "far" => self.camera = camera.with(|it| it.depths[1] = -depth)?,
            "top" => {
                self.camera = camera.with(|it| {
                    let [_, far] = it.depths;
                    it.opening = match it.opening {
                        Opening::FovY(_) => {
                            Opening::FovY(2.0 * libm::atan2(height, far).to_degrees())
                        }
                        Opening::Height(_) => Opening::Height(2.0 * height),
                    };
                })?;
            }
            "point" => self.set_places(Places {
                point: to,
                ..places
            })?,
            "end" => {
                let segment = with(places.segment, i, to);
                self.set_places(Places { segment, ..places })?;
            }
            "corner" => {
                let triangle = with(places.triangle, i, to);
                self.set_places(Places { triangle, ..places })?;
            }
            id => {
                let Some(object) = self.objects().get(i) else {
                    return Ok(());
                };
                let moved = match id {
                    "object-corner" => object.with_corner(corner, to)?,
                    _ => object.moved(to)?,
                };
                self.set_object(i, moved);
            }
        }
        Ok(())
    }
}

impl Scene {
    fn middle_of(&self, edge: [usize; 2]) -> DVec3 {
        let corners = self.camera.camera().corners_in_world();
        let [a, b] = edge.map(|i| DVec3::from(corners[i]));
        a.midpoint(b)
    }
}

fn with<const N: usize>(mut places: [[f64; 3]; N], i: usize, to: [f64; 3]) -> [[f64; 3]; N] {
    if let Some(place) = places.get_mut(i) {
        *place = to;
    }
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::labs::frustum;

    #[test]
    fn planes_and_opening_follow_along_their_axes_and_keep_off_the_cameras_own() {
        let scene = (frustum::LAB.first_scene)();
        let first: &Scene = scene.get().expect("a scene in space");
        for id in ["near", "far", "top"] {
            let mut scene = first.clone();
            let mut handles = scene.handles().into_iter();
            let handle = handles.find(|it| it.kind().id == id).expect(id);
            let at = |scene: &Scene| DVec3::from(scene.position(handle).expect(id));
            let Motion::Axis(axis) = scene.motion(handle) else {
                panic!("{id} has an axis");
            };
            let to = at(&scene) + 0.05 * DVec3::from(axis);
            scene.drag(handle, to.into()).expect("it can be there");
            assert!(at(&scene).distance(to) < 1e-9, "{id}: {} {to}", at(&scene));
            let off = scene.camera.camera().view_from_world().point(to.into());
            assert!(off[0].hypot(off[1]) > 0.1, "{id}: {off:?}");
        }
    }
}
