//! What can be taken hold of in a scene.

use glam::DVec3;

use crate::{
    labs::{Draggable, Handle, HandleKind, Motion},
    text::{Diagnostic, Message},
};

use super::{Opening, Places, Scene, Subject, stage::object_link};

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
    Message::new("handle-space-corner").with("number", i)
});
static OBJECT: HandleKind = HandleKind {
    is_vertex: true,
    is_whole: true,
    link: Some(|[i, _]| object_link(i)),
    ..kind("object", "object", |[i, _]| {
        Message::new("handle-object").with("number", i + 1)
    })
};

static OBJECT_CORNER: HandleKind = kind("object-corner", "object", |[i, corner]| {
    Message::new("handle-object-corner")
        .with("number", i + 1)
        .with("corner", corner + 1)
});

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

    fn position(&self, handle: Handle) -> Option<[f64; 3]> {
        let [position, target, _] = self.camera.places();
        let [near, far] = self.camera.depths();
        let camera = self.camera.camera();
        let [i, corner] = handle.idx();
        Some(match handle.kind().id {
            "camera" => position,
            "target" => target,
            "near" => camera.world_from_view([0.0, 0.0, -near]),
            "far" => camera.world_from_view([0.0, 0.0, -far]),
            "top" => {
                let [left, right] = [6, 7].map(|i| DVec3::from(camera.corners_in_world()[i]));
                left.midpoint(right).into()
            }
            "point" => self.places().point,
            "end" => *self.places().segment.get(i)?,
            "corner" => *self.places().triangle.get(i)?,
            "object-corner" => self.objects().get(i)?.points().nth(corner)?,
            _ => self.objects().get(i)?.at(),
        })
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

fn with<const N: usize>(mut places: [[f64; 3]; N], i: usize, to: [f64; 3]) -> [[f64; 3]; N] {
    if let Some(place) = places.get_mut(i) {
        *place = to;
    }
    places
}
