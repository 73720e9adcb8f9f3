//! What can be taken hold of in the polygons lab.

use crate::{
    figure::Link,
    geom::{Point, Polygon, extent},
    labs::{
        Draggable, Handle, HandleKind,
        window_handles::{self, CLIP_VERTEX},
    },
    text::{Diagnostic, Message},
};

use super::Scene;

static VERTEX: HandleKind = HandleKind {
    is_vertex: true,
    link: Some(|[i, _]| corner_link(i)),
    ..HandleKind::new("vertex", "polygon", |[i, _]| {
        Message::new("handle-vertex").with("number", i + 1)
    })
};
static HOLE_VERTEX: HandleKind = HandleKind {
    is_vertex: true,
    ..HandleKind::new("hole-vertex", "polygon", |[hole, i]| {
        Message::new("handle-hole-vertex")
            .with("hole", hole + 1)
            .with("number", i + 1)
    })
};
static SUBJECT: HandleKind = HandleKind {
    is_whole: true,
    ..HandleKind::new("subject", "polygon", |_| Message::new("handle-polygon"))
};

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneVertex {
    Subject(usize),
    /// Of one of its holes: which hole, which vertex.
    Hole(usize, usize),
    Clip(usize),
}

/// What is asked about where a vertex of the subject is clicked. Lists number theirs anew.
pub const fn corner_link(vertex_idx: usize) -> Link {
    Link::nth("corner", vertex_idx)
}

impl SceneVertex {
    pub const fn handle(self) -> Handle {
        match self {
            Self::Subject(i) => VERTEX.at([i, 0]),
            Self::Hole(hole, i) => HOLE_VERTEX.at([hole, i]),
            Self::Clip(i) => CLIP_VERTEX.at([i, 0]),
        }
    }

    pub fn of(handle: Handle) -> Option<Self> {
        let [i, j] = handle.idx();
        let all = [Self::Subject(i), Self::Hole(i, j), Self::Clip(i)];
        all.into_iter().find(|vertex| vertex.handle() == handle)
    }

    /// The one after it on its outline; not wrapped round.
    pub const fn next(self) -> Self {
        match self {
            Self::Subject(i) => Self::Subject(i + 1),
            Self::Hole(hole, i) => Self::Hole(hole, i + 1),
            Self::Clip(i) => Self::Clip(i + 1),
        }
    }

    pub const fn idx(self) -> usize {
        match self {
            Self::Subject(i) | Self::Hole(_, i) | Self::Clip(i) => i,
        }
    }
}

impl Draggable for Scene {
    fn handles(&self) -> Vec<Handle> {
        let mut handles: Vec<Handle> = self.subject_vertices().map(SceneVertex::handle).collect();
        handles.push(SUBJECT.at([0, 0]));
        handles.extend(self.clip_vertices().map(SceneVertex::handle));
        if self.clips() && self.clip_in_use().is_none() {
            handles.extend(window_handles::handles());
        }
        handles
    }

    fn position(&self, handle: Handle) -> Option<[f64; 3]> {
        let [x, y] = if let Some(vertex) = SceneVertex::of(handle) {
            self.ring_of(vertex)?.vertices()[vertex.idx()].to_array()
        } else if handle.is(&SUBJECT) {
            self.middle()
        } else {
            return window_handles::position(handle, &self.window);
        };
        Some([x, y, 0.0])
    }

    fn drag(&mut self, handle: Handle, [x, y, _]: [f64; 3]) -> Result<(), Diagnostic> {
        let to = Point::new(x, y)?;
        if let Some(vertex) = SceneVertex::of(handle) {
            if let Some(ring) = self.ring_mut(vertex) {
                ring.set_vertex(vertex.idx(), to);
            }
        } else if handle.is(&SUBJECT) {
            self.drag_subject(to)?;
        } else {
            self.window = window_handles::dragged(handle, &self.window, to)?;
        }
        Ok(())
    }
}

impl Scene {
    /// The outline that a vertex belongs to, where the scene has that vertex: a handle may be older than the scene.
    pub fn ring_of(&self, vertex: SceneVertex) -> Option<&Polygon> {
        let ring = match vertex {
            SceneVertex::Subject(_) => &self.subject,
            SceneVertex::Hole(hole, _) => self.holes.get(hole)?,
            SceneVertex::Clip(_) => self.clip.as_ref()?,
        };
        (vertex.idx() < ring.vertices().len()).then_some(ring)
    }

    pub fn ring_mut(&mut self, vertex: SceneVertex) -> Option<&mut Polygon> {
        self.ring_of(vertex)?;
        match vertex {
            SceneVertex::Subject(_) => Some(&mut self.subject),
            SceneVertex::Hole(hole, _) => self.holes.get_mut(hole),
            SceneVertex::Clip(_) => self.clip.as_mut(),
        }
    }

    pub(super) fn subject_vertices(&self) -> impl Iterator<Item = SceneVertex> {
        let holes = self.holes.iter().enumerate();
        let holes = holes.flat_map(|(hole, ring)| {
            (0..ring.vertices().len()).map(move |i| SceneVertex::Hole(hole, i))
        });
        (0..self.subject.vertices().len())
            .map(SceneVertex::Subject)
            .chain(holes)
    }

    pub(super) fn clip_vertices(&self) -> impl Iterator<Item = SceneVertex> {
        let n = self.clip_in_use().map_or(0, |clip| clip.vertices().len());
        (0..n).map(SceneVertex::Clip)
    }

    /// Where the handle of the whole subject lies: the middle of its box.
    fn middle(&self) -> [f64; 2] {
        let [min, max] = extent(self.subject.vertices().iter().copied());
        [min[0].midpoint(max[0]), min[1].midpoint(max[1])]
    }

    fn drag_subject(&mut self, to: Point) -> Result<(), Diagnostic> {
        let [x, y] = self.middle();
        let by = [to.x() - x, to.y() - y];
        let subject = moved(&self.subject, by)?;
        let holes = self.holes.iter().map(|hole| moved(hole, by));
        self.holes = holes.collect::<Result<_, _>>()?;
        self.subject = subject;
        Ok(())
    }
}

fn moved(polygon: &Polygon, [dx, dy]: [f64; 2]) -> Result<Polygon, Diagnostic> {
    let vertices = polygon.vertices().iter();
    let outline: Vec<[f64; 2]> = vertices.map(|p| [p.x() + dx, p.y() + dy]).collect();
    Ok(Polygon::new(&outline)?)
}
