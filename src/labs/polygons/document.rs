//! What the polygons lab's scene shows, and what of it can be dragged.

use crate::{
    figure::{Mark, Run},
    geom::{GeomError, Point, Polygon, extent},
    labs::{Document, Handle, Lab, MethodCard},
};

use super::{
    Method, Scene,
    backdrop::{backdrop, bounds},
};

impl Scene {
    /// The methods on stage.
    fn on_stage(&self) -> impl Iterator<Item = Method> {
        [Some(self.method), self.compare].into_iter().flatten()
    }

    /// The clip polygon, where there is one and a method on stage clips.
    #[must_use]
    pub fn clip_in_use(&self) -> Option<&Polygon> {
        self.clip.as_ref().filter(|_| self.clips())
    }

    /// Does a method on stage clip, so that there is a window or a clip polygon?
    #[must_use]
    pub fn clips(&self) -> bool {
        self.on_stage().any(|method| method.info().clips)
    }

    /// Does a method on stage know holes?
    #[must_use]
    pub fn knows_holes(&self) -> bool {
        self.on_stage().any(|method| method.info().knows_holes)
    }

    /// Does a method on stage carry texture coordinates along?
    #[must_use]
    pub fn carries_texture(&self) -> bool {
        self.on_stage().any(|method| method.info().carries_texture)
    }

    /// Where the handle of the whole subject lies: the middle of its box.
    fn middle(&self) -> [f64; 2] {
        let [min, max] = extent(self.subject.vertices().iter().copied());
        [min[0].midpoint(max[0]), min[1].midpoint(max[1])]
    }

    fn drag_subject(&mut self, to: Point) -> Result<(), GeomError> {
        let [x, y] = self.middle();
        let by = [to.x() - x, to.y() - y];
        let subject = moved(&self.subject, by)?;
        let holes = self.holes.iter().map(|hole| moved(hole, by));
        self.holes = holes.collect::<Result<_, _>>()?;
        self.subject = subject;
        Ok(())
    }
}

impl Document for Scene {
    fn lab(&self) -> Lab {
        Lab::Polygons
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        self.on_stage().map(Method::card).collect()
    }

    fn set_method(&mut self, id: &str) {
        if let Some(method) = Method::by_id(id) {
            self.method = method;
            self.compare = self.compare.filter(|&other| other != method);
        }
    }

    fn set_compare(&mut self, id: Option<&str>) {
        self.compare = id.and_then(Method::by_id);
    }

    fn record(&self) -> Vec<Box<dyn Run>> {
        self.on_stage().map(|method| method.record(self)).collect()
    }

    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark> {
        let method = self.on_stage().nth(column).unwrap_or(self.method);
        backdrop(self, method, at_end)
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        bounds(self)
    }

    fn handles(&self) -> Vec<Handle> {
        let n_vertices = self.subject.vertices().len();
        let mut handles: Vec<Handle> = (0..n_vertices).map(Handle::Vertex).collect();
        for (i, hole) in self.holes.iter().enumerate() {
            handles.extend((0..hole.vertices().len()).map(|k| Handle::HoleVertex(i, k)));
        }
        handles.push(Handle::Subject);
        match self.clip_in_use() {
            Some(clip) => handles.extend((0..clip.vertices().len()).map(Handle::ClipVertex)),
            None if self.clips() => handles.extend(Handle::of_window()),
            None => {}
        }
        handles
    }

    fn position(&self, handle: Handle) -> Option<[f64; 2]> {
        let vertex = |ring: &Polygon, i: usize| ring.vertices().get(i).map(|p| p.to_array());
        match handle {
            Handle::Vertex(i) => vertex(&self.subject, i),
            Handle::HoleVertex(hole, i) => vertex(self.holes.get(hole)?, i),
            Handle::ClipVertex(i) => vertex(self.clip_in_use()?, i),
            Handle::Subject => Some(self.middle()),
            _ => handle.on_window(&self.window),
        }
    }

    fn drag(&mut self, handle: Handle, [x, y]: [f64; 2]) -> Result<(), GeomError> {
        let to = Point::new(x, y)?;
        match handle {
            Handle::Vertex(i) => self.subject.set_vertex(i, to),
            Handle::HoleVertex(hole, i) => {
                if let Some(hole) = self.holes.get_mut(hole) {
                    hole.set_vertex(i, to);
                }
            }
            Handle::ClipVertex(i) => {
                if let Some(clip) = &mut self.clip {
                    clip.set_vertex(i, to);
                }
            }
            Handle::Subject => self.drag_subject(to)?,
            _ => self.window = handle.drag_window(&self.window, to)?,
        }
        Ok(())
    }

    fn size(&self) -> usize {
        self.n_vertices()
    }
}

fn moved(polygon: &Polygon, [dx, dy]: [f64; 2]) -> Result<Polygon, GeomError> {
    let vertices = polygon.vertices().iter();
    let outline: Vec<[f64; 2]> = vertices.map(|p| [p.x() + dx, p.y() + dy]).collect();
    Polygon::new(&outline)
}
