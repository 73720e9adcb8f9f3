//! What the lines lab's scene shows, and how it is changed.

use std::sync::Arc;

use crate::{
    algo::line::BitOrder,
    figure::{Run, Shape},
    geom::Segment,
    labs::{ChangeOf, Click, Document, Handle, Lab, MethodCard, Own},
    text::{Diagnostic, Message},
    trace::Counts,
};

use super::{LAB, Method, Scene, backdrop::MAX_FITTED, random_segments, verdict::under};

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
        let record = |method: Method| (method.info().record)(self, self.focused());
        self.on_stage().map(record).collect()
    }

    /// The first method of the registry is the plainest.
    fn baseline(&self) -> Option<(&'static MethodCard, Counts)> {
        let plainest = Method::all().next();
        let method = plainest.filter(|&method| method != self.method)?;
        Some((method.card(), (method.info().cost)(self, self.focused())))
    }

    fn cost_of_all(&self, column: usize) -> Option<Message> {
        let (n, method) = (self.segments().len(), self.on_stage().nth(column)?);
        if n <= MAX_FITTED {
            return None;
        }
        let cost = self.cost_by(method);
        let message = Message::new("cost-of-all-segments")
            .with("count", n)
            .with("divisions", cost.div as usize)
            .with("multiplications", cost.mul as usize)
            .with("additions", cost.add as usize)
            .with("comparisons", cost.cmp as usize);
        Some(message)
    }

    fn add(&mut self, _after: Option<Handle>) -> Result<Option<Handle>, Diagnostic> {
        let [_, ymin, _, ymax] = self.window.to_array();
        let by = 0.25 * (ymax - ymin);
        let [x1, y1, x2, y2] = self.focused().to_array();
        self.add_segment(Segment::new(x1, y1 + by, x2, y2 + by)?)?;
        Ok(None)
    }

    fn remove(&mut self, _handle: Option<Handle>) -> Result<(), Diagnostic> {
        self.remove_focused();
        Ok(())
    }

    fn click(&self, click: &Click<'_>) -> Option<Own> {
        let other = other_under(self, click)?;
        Some(Arc::new(LinesChange::Focus(other)))
    }

    fn pointed(&self, click: &Click<'_>) -> Option<Shape> {
        let other = &self.segments()[other_under(self, click)?];
        Some(Shape::Segment([other.p1.to_array(), other.p2.to_array()]))
    }

    fn size(&self) -> usize {
        self.segments().len()
    }
}

#[derive(Clone, PartialEq, Debug)]
pub enum LinesChange {
    BitOrder(BitOrder),
    Focus(usize),
    Random { count: usize, seed: u64 },
}

impl ChangeOf for LinesChange {
    type Of = Scene;

    fn make(&self, scene: &mut Scene) -> Result<Option<Handle>, Diagnostic> {
        match *self {
            Self::BitOrder(order) => scene.bit_order = order,
            Self::Focus(segment_idx) => scene.set_focus(segment_idx),
            Self::Random { count, seed } => {
                scene.set_segments(random_segments(&scene.window, count, seed))?;
            }
        }
        Ok(None)
    }

    fn is_another(&self) -> bool {
        matches!(self, Self::Random { .. })
    }
}

fn other_under(scene: &Scene, click: &Click<'_>) -> Option<usize> {
    under(scene, click).filter(|&segment_idx| segment_idx != scene.focus())
}
