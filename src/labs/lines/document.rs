//! What the lines lab's scene shows, and how it is changed.

use std::sync::Arc;

use crate::{
    figure::{Link, Mark, Run, Shape},
    geom::Point,
    labs::{Click, Document, Handle, Lab, MethodCard, Own, Verdict},
    text::{Diagnostic, Message},
    trace::Counts,
};

use super::{
    LAB, Method, Scene,
    backdrop::{MAX_FITTED, backdrop, bounds},
    change::{beside, clicked, other_under, under},
    verdict::{segment_link, verdict},
};

impl Scene {
    /// The methods on stage.
    fn on_stage(&self) -> impl Iterator<Item = Method> {
        [Some(self.method), self.compare].into_iter().flatten()
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
        let record = |method: Method| method.info().record(self, self.focused());
        self.on_stage().map(record).collect()
    }

    /// The first method of the registry is the plainest.
    fn baseline(&self) -> Option<(&'static MethodCard, Counts)> {
        let plainest = Method::all().next();
        let method = plainest.filter(|&method| method != self.method)?;
        Some((method.card(), method.info().cost(self, self.focused()).1))
    }

    fn cost_of_all(&self, column: usize) -> Option<Message> {
        let (n, method) = (self.segments().len(), self.on_stage().nth(column)?);
        if n <= MAX_FITTED {
            return None;
        }
        let segments = self.segments().iter();
        let cost: Counts = segments.map(|&s| method.info().cost(self, s).1).sum();
        let message = Message::new("cost-of-all-segments").with("count", n);
        let kinds = [
            ("divisions", cost.div),
            ("multiplications", cost.mul),
            ("additions", cost.add),
            ("comparisons", cost.cmp),
        ];
        let with = |message: Message, (kind, n)| message.with(kind, n as usize);
        Some(kinds.into_iter().fold(message, with))
    }

    fn asked(&self, click: &Click<'_>) -> Option<Link> {
        under(self, click).map(segment_link)
    }

    fn verdict(&self, about: Link, run: &dyn Run) -> Option<Verdict> {
        verdict(self, about, run)
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

    fn add(&mut self, _after: Option<Handle>) -> Result<Option<Handle>, Diagnostic> {
        self.add_segment(beside(self)?)?;
        Ok(None)
    }

    fn remove(&mut self, _handle: Option<Handle>) -> Result<(), Diagnostic> {
        self.remove_focused();
        Ok(())
    }

    fn click(&self, click: &Click<'_>) -> Option<Own> {
        Some(Arc::new(clicked(self, click)?))
    }

    fn pointed(&self, click: &Click<'_>) -> Option<Shape> {
        let other = &self.segments()[other_under(self, click)?];
        Some(Shape::Segment([other.p1.to_array(), other.p2.to_array()]))
    }

    fn size(&self) -> usize {
        self.segments().len()
    }
}
