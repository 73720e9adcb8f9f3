//! What the lines lab's scene shows, and what of it can be dragged.

use crate::{
    algo::line::End,
    figure::{Mark, Run},
    geom::{ConvexPolygon, GeomError, Point, Segment},
    labs::{Document, Handle, Lab, MethodCard},
    trace::Counts,
};

use super::{
    Method, Scene,
    backdrop::{backdrop, bounds},
};

impl Scene {
    /// The method on stage in this column.
    fn method_in(&self, column: usize) -> Method {
        self.compare.filter(|_| column > 0).unwrap_or(self.method)
    }

    fn drag_segment(&mut self, handle: Handle, to: Point) -> Result<(), GeomError> {
        let Segment { p1, p2 } = self.focused();
        let moved = match handle {
            Handle::End(End::P1) => Segment { p1: to, p2 },
            Handle::End(End::P2) => Segment { p1, p2: to },
            _ => {
                let [x, y] = middle(&self.focused());
                let [dx, dy] = [to.x() - x, to.y() - y];
                Segment::new(p1.x() + dx, p1.y() + dy, p2.x() + dx, p2.y() + dy)?
            }
        };
        self.set_segment(self.focus(), moved);
        Ok(())
    }

    fn drag_vertex(&mut self, vertex_idx: usize, to: Point) -> Result<(), GeomError> {
        if let Some(clip) = self.polygon_in_use() {
            let mut outline: Vec<[f64; 2]> = clip.clone().into();
            if let Some(vertex) = outline.get_mut(vertex_idx) {
                *vertex = to.to_array();
            }
            self.clip = Some(ConvexPolygon::new(&outline)?);
        }
        Ok(())
    }
}

impl Document for Scene {
    fn lab(&self) -> Lab {
        Lab::Lines
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        let on_stage = [Some(self.method), self.compare];
        on_stage.into_iter().flatten().map(Method::card).collect()
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
        let on_stage = [Some(self.method), self.compare];
        let record = |method: Method| method.record(self, self.focused());
        on_stage.into_iter().flatten().map(record).collect()
    }

    /// The first method of the registry is the plainest.
    fn baseline(&self) -> Option<(&'static MethodCard, Counts)> {
        let plainest = Method::all().next();
        let method = plainest.filter(|&method| method != self.method)?;
        Some((method.card(), method.cost(self, self.focused()).1))
    }

    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark> {
        backdrop(self, self.method_in(column), at_end)
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        bounds(self)
    }

    fn handles(&self) -> Vec<Handle> {
        let mut handles = vec![Handle::End(End::P1), Handle::End(End::P2), Handle::Segment];
        match self.polygon_in_use() {
            Some(clip) => handles.extend((0..clip.vertices().len()).map(Handle::ClipVertex)),
            None => handles.extend(Handle::of_window()),
        }
        handles
    }

    fn position(&self, handle: Handle) -> Option<[f64; 2]> {
        match handle {
            Handle::End(end) => Some(end.of(&self.focused()).to_array()),
            Handle::Segment => Some(middle(&self.focused())),
            Handle::ClipVertex(i) => {
                let vertex = self.polygon_in_use()?.vertices().get(i)?;
                Some(vertex.to_array())
            }
            _ => handle.on_window(&self.window),
        }
    }

    fn drag(&mut self, handle: Handle, [x, y]: [f64; 2]) -> Result<(), GeomError> {
        let to = Point::new(x, y)?;
        match handle {
            Handle::End(_) | Handle::Segment => self.drag_segment(handle, to)?,
            Handle::ClipVertex(i) => self.drag_vertex(i, to)?,
            _ => self.window = handle.drag_window(&self.window, to)?,
        }
        Ok(())
    }

    fn size(&self) -> usize {
        self.segments().len()
    }
}

fn middle(segment: &Segment) -> [f64; 2] {
    let [x1, y1, x2, y2] = segment.to_array();
    [x1.midpoint(x2), y1.midpoint(y2)]
}
