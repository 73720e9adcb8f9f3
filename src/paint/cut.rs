//! The part of a line that is in a rectangle on the screen: all of it by this crate's own clipper.

use egui::{Pos2, Rect, pos2};

use crate::{
    algo::line::kernel,
    geom::{Segment, Window},
};

/// The part of a line that is inside a rectangle: dashes of lines that reach far beyond the stage are not laid in vain.
pub fn cut_to([a, b]: [Pos2; 2], rect: Rect) -> Option<[Pos2; 2]> {
    if rect.contains(a) && rect.contains(b) {
        return Some([a, b]);
    }
    // Most of what is asked lies beyond one side.
    if !Rect::from_two_pos(a, b).intersects(rect) {
        return None;
    }
    let [left, top, right, bottom] =
        [rect.left(), rect.top(), rect.right(), rect.bottom()].map(f64::from);
    let window = Window::new(left, top, right, bottom).ok()?;
    let [ax, ay, bx, by] = [a.x, a.y, b.x, b.y].map(f64::from);
    let segment = Segment::new(ax, ay, bx, by).ok()?;
    let visible = kernel::clip(&window, &segment)?;
    Some([visible.p1, visible.p2].map(|p| pos2(p.x() as f32, p.y() as f32)))
}

pub fn length_in(ends: [Pos2; 2], rect: Rect) -> f32 {
    cut_to(ends, rect).map_or(0.0, |[a, b]| a.distance(b))
}

/// Does a line come into a rectangle? Along its border it does not.
pub fn crosses(ends: [Pos2; 2], rect: Rect) -> bool {
    cut_to(ends, rect).is_some_and(|[a, b]| {
        // What is seen of a line is a chord of the rectangle: it is on the border if its middle is.
        let middle = a.lerp(b, 0.5);
        let is_between = |at, min, max| min < at && at < max;
        is_between(middle.x, rect.left(), rect.right())
            && is_between(middle.y, rect.top(), rect.bottom())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_comes_into_a_rectangle_or_passes_it() {
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(10.0, 10.0));
        assert!(crosses([pos2(-5.0, 5.0), pos2(5.0, 5.0)], rect));
        assert!(crosses([pos2(5.0, -5.0), pos2(5.0, 15.0)], rect));
        assert!(!crosses([pos2(-5.0, 0.0), pos2(0.0, 11.0)], rect));
        assert!(!crosses([pos2(-5.0, 10.0), pos2(15.0, 10.0)], rect));
        assert!(
            !crosses([pos2(-5.0, 5.0), pos2(5.0, -5.0)], rect),
            "a corner"
        );
    }
}
