//! What the polygons lab's scene shows, and how it is changed.

use std::sync::Arc;

use crate::{
    figure::Run,
    geom::Polygon,
    labs::{ChangeOf, Click, Document, Handle, Lab, MethodCard, Own},
    text::Diagnostic,
};

use super::{
    LAB, Method, PolygonsChange, Scene,
    change::{clicked, vertex_of},
};

impl Scene {
    /// The clip polygon, where there is one and a method on stage clips.
    pub fn clip_in_use(&self) -> Option<&Polygon> {
        self.clip.as_ref().filter(|_| self.clips())
    }

    pub fn clips(&self) -> bool {
        self.on_stage().any(|method| method.info().clips)
    }

    pub fn knows_holes(&self) -> bool {
        self.on_stage().any(|method| method.info().knows_holes)
    }

    pub fn carries_texture(&self) -> bool {
        self.on_stage().any(|method| method.info().carries_texture)
    }
}

impl Document for Scene {
    fn lab(&self) -> &'static Lab {
        LAB
    }

    fn methods(&self) -> Vec<&'static MethodCard> {
        self.on_stage().map(Method::card).collect()
    }

    fn set_method(&mut self, id: &str) {
        self.method.change(&mut self.compare, id);
    }

    fn set_compare(&mut self, id: Option<&str>) {
        self.compare = id.and_then(Method::by_id);
    }

    fn record(&self) -> Vec<Box<dyn Run>> {
        let record = |method: Method| (method.info().record)(self);
        self.on_stage().map(record).collect()
    }

    /// One that knows no holes would draw them away.
    fn takes(&self, id: &str) -> bool {
        Method::by_id(id).is_some_and(|method| {
            let info = method.info();
            (info.knows_holes || self.holes.is_empty()) && (info.takes)(self)
        })
    }

    fn mended(&self) -> Option<(&'static str, Own)> {
        let hole = (self.method.info().unfit_hole)(self)?;
        Some(("action-no-hole", Arc::new(PolygonsChange::NoHole(hole))))
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
