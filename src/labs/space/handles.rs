//! What can be taken hold of in a scene.

use glam::DVec3;

use crate::{
    geom::Camera,
    labs::{Draggable, Handle, HandleKind, Motion},
    text::{Diagnostic, Message},
};

use super::{Opening, Scene, Subject, stage::object_link};

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

static POSITION: HandleKind = kind("camera", "camera", |_| Message::new("handle-camera"));
static TARGET: HandleKind = kind("target", "camera", |_| Message::new("handle-target"));
static NEAR: HandleKind = kind("near", "volume", |_| Message::new("handle-near"));
static FAR: HandleKind = kind("far", "volume", |_| Message::new("handle-far"));
static TOP: HandleKind = kind("top", "volume", |_| Message::new("handle-top"));
static POINT: HandleKind = HandleKind {
    is_marked: true,
    ..kind("point", "point", |_| Message::new("handle-point"))
};
static END: HandleKind = HandleKind {
    is_marked: true,
    ..kind("end", "segment", |[i, _]| {
        Message::new("handle-space-end").with("number", i + 1)
    })
};
static CORNER: HandleKind = HandleKind {
    is_marked: true,
    ..kind("corner", "triangle", |[i, _]| {
        Message::new("handle-space-corner").with("number", i)
    })
};
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
        Some(if handle.is(&POSITION) {
            position
        } else if handle.is(&TARGET) {
            target
        } else if handle.is(&NEAR) {
            camera.world_from_view([0.0, 0.0, -near])
        } else if handle.is(&FAR) {
            camera.world_from_view([0.0, 0.0, -far])
        } else if handle.is(&TOP) {
            let [left, right] = [6, 7].map(|i| DVec3::from(camera.corners_in_world()[i]));
            left.midpoint(right).into()
        } else if handle.is(&POINT) {
            self.places.point()
        } else if handle.is(&END) {
            *self.places.segment().get(handle.idx()[0])?
        } else if handle.is(&CORNER) {
            *self.places.triangle().get(handle.idx()[0])?
        } else {
            let [object_idx, corner] = handle.idx();
            let object = self.objects().get(object_idx)?;
            if handle.is(&OBJECT_CORNER) {
                object.points().nth(corner)?
            } else {
                object.at()
            }
        })
    }

    fn drag(&mut self, handle: Handle, to: [f64; 3]) -> Result<(), Diagnostic> {
        let camera = self.camera;
        let [position, target, up] = camera.places();
        let [near, far] = camera.depths();
        let [_, height, depth] = in_view(camera.camera(), to);
        if handle.is(&POSITION) {
            self.camera = camera.placed([to, target, up])?;
        } else if handle.is(&TARGET) {
            self.camera = camera.placed([position, to, up])?;
        } else if handle.is(&NEAR) {
            self.camera = camera.deep([-depth, far])?;
        } else if handle.is(&FAR) {
            self.camera = camera.deep([near, -depth])?;
        } else if handle.is(&TOP) {
            self.camera = camera.opened(match camera.opening() {
                Opening::FovY(_) => Opening::FovY(2.0 * libm::atan2(height, far).to_degrees()),
                Opening::Height(_) => Opening::Height(2.0 * height),
            })?;
        } else if handle.is(&POINT) {
            self.places = self.places.with_point(to)?;
        } else if handle.is(&END) {
            let moved = with(self.places.segment(), handle, to);
            self.places = self.places.with_segment(moved)?;
        } else if handle.is(&CORNER) {
            let moved = with(self.places.triangle(), handle, to);
            self.places = self.places.with_triangle(moved)?;
        } else if let Some(object) = self.objects().get(handle.idx()[0]) {
            let [object_idx, corner] = handle.idx();
            let moved = if handle.is(&OBJECT_CORNER) {
                object.with_corner(corner, to)?
            } else {
                object.moved(to)?
            };
            self.set_object(object_idx, moved);
        }
        Ok(())
    }
}

fn with<const N: usize>(mut places: [[f64; 3]; N], handle: Handle, to: [f64; 3]) -> [[f64; 3]; N] {
    if let Some(place) = places.get_mut(handle.idx()[0]) {
        *place = to;
    }
    places
}

fn in_view(camera: &Camera, at: [f64; 3]) -> [f64; 3] {
    camera.view_from_world().point(at)
}
