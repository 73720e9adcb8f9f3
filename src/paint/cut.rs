//! The part of a line that is seen.

use egui::{Pos2, Rect, pos2};

use crate::{
    algo::line::kernel,
    geom::{Segment, Window},
};

/// The part of a line that is inside a rectangle on the screen, so that dashes of lines that reach far beyond it are
/// not laid in vain. Runs on this crate's own clipper.
pub fn cut_to([a, b]: [Pos2; 2], rect: Rect) -> Option<[Pos2; 2]> {
    let [left, top, right, bottom] =
        [rect.left(), rect.top(), rect.right(), rect.bottom()].map(f64::from);
    let window = Window::new(left, top, right, bottom).ok()?;
    let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(f64::from);
    let segment = Segment::new(ax, ay, bx, by).ok()?;
    let visible = kernel::clip(&window, &segment)?;
    Some([visible.p1, visible.p2].map(|p| pos2(p.x() as f32, p.y() as f32)))
}
