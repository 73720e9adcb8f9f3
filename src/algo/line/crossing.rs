//! Where a segment crosses a border: with `d1` and `d2` the signed distances of P₁ and P₂ from it (inside positive), at u = d1 /
//! (d1 − d2). The free coordinate of a crossing is a [`weighted_mean`] of the ends' coordinates.

use std::hint::select_unpredictable;

use crate::{
    geom::{Axis, Edge, Point, Segment, Window},
    trace::Real,
};

use super::{
    super::parameter::{Upright, clamp_between, weighted_mean},
    End,
};

/// Where the line through a segment meets a border.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Crossing<R> {
    /// The other coordinate; between the ends' own, up to rounding, where the segment reaches across the border.
    pub free: R,
    /// `c − a1` over `a2 − a1`: the parameter u.
    pub ratio: [R; 2],
}

/// The coordinate along `axis` and the other one.
#[inline]
pub fn split<R: Real>(point: Point, axis: Axis) -> [R; 2] {
    in_order(axis, point.to_array()).map(R::new)
}

/// The point with coordinate `c` along `axis` and `free` on the other.
#[inline]
pub fn join<R: Real>(axis: Axis, c: R, free: R) -> Point {
    let [x, y] = in_order(axis, [c.get(), free.get()]);
    Point::from_finite(x, y)
}

/// Swaps the two for the y axis, without a branch: neither axis is likelier.
#[inline]
fn in_order(axis: Axis, [a, b]: [f64; 2]) -> [f64; 2] {
    let pick = |x, y| select_unpredictable(axis == Axis::X, x, y);
    [pick(a, b), pick(b, a)]
}

#[inline]
pub fn crossing<R: Real>(segment: &Segment, window: &Window, edge: Edge) -> Crossing<R> {
    crossing_at(segment, edge.axis(), window.border(edge))
}

/// Of the line through `segment`, which is not parallel to it, with that on which the `axis` coordinate is `border`.
#[inline]
pub fn crossing_at<R: Real>(segment: &Segment, axis: Axis, border: f64) -> Crossing<R> {
    let [a1, o1] = split::<R>(segment.p1, axis);
    let [a2, o2] = split::<R>(segment.p2, axis);
    let c = R::new(border);
    let (w1, w2, whole) = (c - a1, a2 - c, a2 - a1);
    let raw = [a1, a2, c].map(R::get);
    Crossing {
        free: weighted_mean([o1, o2], [w1, w2], whole, raw),
        ratio: if whole.get().is_finite() && w1.get().is_finite() {
            [w1, whole]
        } else {
            let [a1, a2, c] = raw.map(|x| 0.5 * x);
            [R::new(c - a1), R::new(a2 - a1)]
        },
    }
}

/// Distances of P₁ and P₂ from a border, inside positive: see [`Upright::distances`].
pub fn signed_distances<R: Real>(segment: &Segment, window: &Window, edge: Edge) -> [R; 2] {
    upright(segment, window, edge).distances()
}

pub fn upright(segment: &Segment, window: &Window, edge: Edge) -> Upright {
    Upright {
        ends: End::BOTH.map(|end| split::<f64>(end.of(segment), edge.axis())[0]),
        at: window.border(edge),
        is_max: edge.is_max(),
    }
}

/// The crossing with a side, which is known to lie on the window's border.
#[inline]
pub fn on_border<R: Real>(segment: &Segment, window: &Window, edge: Edge) -> Point {
    let corners = [window.min(), window.max()];
    on_line::<R>(segment, edge.axis(), window.border(edge), corners)
}

/// The same, kept within the box between two corners and within the segment's own extent.
#[inline]
pub fn on_line<R: Real>(segment: &Segment, axis: Axis, border: f64, corners: [Point; 2]) -> Point {
    let free = crossing_at::<R>(segment, axis, border).free;
    let within = |x: R, [p, q]: [Point; 2]| {
        let [[_, bound], [_, other]] = [p, q].map(|p| split::<R>(p, axis));
        clamp_between(x, bound, other)
    };
    let free = within(within(free, [segment.p1, segment.p2]), corners);
    join(axis, R::new(border), free)
}

/// The corner of the window between two sides; `None` where they are opposite or the same.
pub fn corner_between(window: &Window, [e, f]: [Edge; 2]) -> Option<Point> {
    match (e.axis(), f.axis()) {
        (Axis::X, Axis::Y) => Some(Point::from_finite(window.border(e), window.border(f))),
        (Axis::Y, Axis::X) => Some(Point::from_finite(window.border(f), window.border(e))),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(s: [f64; 4]) -> Segment {
        Segment::try_from(s).unwrap()
    }

    #[test]
    fn a_crossing_is_the_same_from_both_ends() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
        for s in [
            [-2.0, -1.0, 2.0, 1.5],
            [-0.1, 0.3, 0.7, 0.9],
            [-1e308, -3.0, 1.5e308, 7.0],
            [-1e-310, 2e-310, 3e-310, -1.0],
        ] {
            let s = segment(s);
            for edge in Edge::ALL {
                let [there, back] =
                    [s, s.reversed()].map(|s| crossing::<f64>(&s, &window, edge).free);
                assert_eq!(there.to_bits(), back.to_bits(), "{edge:?} of {s:?}");
            }
        }
    }

    #[test]
    fn huge_coordinates_do_not_overflow() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
        let s = segment([-1.5e308, -1.5e308, 1.5e308, 1.5e308]);
        let free = crossing::<f64>(&s, &window, Edge::Left).free;
        assert!(free.abs() <= 1e293, "{free}: only rounding is far from −1");
    }

    #[test]
    fn tiny_coordinates_do_not_vanish() {
        let window = Window::new(-1e-200, -1e-200, 1e-200, 1e-200).unwrap();
        let s = segment([-2e-200, -2e-200, 2e-200, 2e-200]);
        let free = crossing::<f64>(&s, &window, Edge::Left).free;
        assert!((free + 1e-200).abs() < 1e-215, "{free}");
    }
}
