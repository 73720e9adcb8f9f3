//! What the polygons lab's scene shows, and how it is changed.

use std::sync::Arc;

use crate::{
    figure::{Link, Mark, Run},
    geom::{Point, Polygon},
    labs::{ChangeOf, Click, Document, Handle, Lab, MethodCard, Own, Verdict},
    text::Diagnostic,
};

use super::{
    LAB, Method, PolygonsChange, Scene,
    backdrop::{backdrop, bounds},
    change::{clicked, vertex_of},
    verdict::{asked, verdict},
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
}

impl Document for Scene {
    fn lab(&self) -> &'static dyn Lab {
        LAB
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
        let record = |method: Method| method.info().record(self);
        self.on_stage().map(record).collect()
    }

    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        asked(self, click)
    }

    fn verdict(&self, about: Link, run: &dyn Run) -> Option<Verdict> {
        verdict(self, about, run)
    }

    fn takes(&self, id: &str) -> bool {
        Method::by_id(id).is_some_and(|method| method.info().takes(self))
    }

    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark> {
        let method = self.on_stage().nth(column).unwrap_or(self.method);
        backdrop(self, method, at_end)
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        bounds(self)
    }

    fn handles(&self) -> Vec<Handle> {
        self.all_handles()
    }

    fn position(&self, handle: Handle) -> Option<[f64; 3]> {
        self.position_of(handle)
    }

    fn drag(&mut self, handle: Handle, [x, y, _]: [f64; 3]) -> Result<(), Diagnostic> {
        self.drag_handle(handle, Point::new(x, y)?)
    }

    fn add(&mut self, after: Option<Handle>) -> Result<Option<Handle>, Diagnostic> {
        PolygonsChange::Insert(vertex_of(self, after), None).make(self)
    }

    fn remove(&mut self, handle: Option<Handle>) -> Result<(), Diagnostic> {
        PolygonsChange::Delete(vertex_of(self, handle)).make(self)?;
        Ok(())
    }

    fn click(&self, click: &Click<'_>) -> Option<Own> {
        Some(Arc::new(clicked(self, click)?))
    }

    fn size(&self) -> usize {
        self.n_vertices()
    }
}
