//! What is on stage whatever the method and the step: the window and the segments out of focus.

use crate::{
    figure::{Mark, Role, Shape},
    geom::extent,
    labs::Backdrop,
};

use super::{Scene, crowd::crowd};

impl Backdrop for Scene {
    /// What lies under a step's marks: the clip region of `method`, and the segments out of focus. These show
    /// what becomes of them once the focused one is decided (`at_end`), so as not to answer first.
    fn backdrop(&self, column: usize, at_end: bool) -> Vec<Mark> {
        let method = self.on_stage().nth(column).unwrap_or(self.method);
        let region = self.region(method);
        let outline = region.vertices().iter().map(|p| p.to_array()).collect();
        let mut marks = vec![Mark::new(Role::Ink, Shape::Area(vec![outline])).linked("window")];
        marks.extend(crowd(self, at_end));
        marks
    }

    /// The world rectangle that holds the clip region and the segments that matter: what a view shows at first.
    fn bounds(&self) -> [[f64; 2]; 2] {
        let focused = [self.focused()];
        let segments = match self.segments() {
            few if few.len() <= MAX_FITTED => few,
            _ => &focused,
        };
        let region = self.region(self.method);
        let ends = segments.iter().flat_map(|s| [s.p1, s.p2]);
        extent(region.vertices().iter().copied().chain(ends))
    }
}

/// Up to this many segments are looked at one by one: a view shows all of them at first. Of more, the one in focus.
pub const MAX_FITTED: usize = 20;
