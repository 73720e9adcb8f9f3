//! Cohen–Sutherland and Liang–Barsky as `clipscope` has them, written out without `emit`, without a scalar
//! to be generic over, and without a state: what the traced ones must not be slower than. They live here and
//! nowhere else.

use std::{cmp::Ordering, hint::select_unpredictable as pick};

use clipscope::{
    algo::line::{CohenSutherlandInput, WindowInput},
    geom::Segment,
};

type Point = [f64; 2];

fn ends(segment: &Segment) -> [Point; 2] {
    [segment.p1, segment.p2].map(clipscope::geom::Point::to_array)
}

/// Numbered as in `clipscope::geom::Edge::ALL`.
const N_EDGES: usize = 4;

const fn axis(edge: usize) -> usize {
    edge / 2
}

const fn is_max(edge: usize) -> bool {
    edge % 2 == 1
}

/// xmin, ymin, xmax, ymax
fn border(window: &[f64; 4], edge: usize) -> f64 {
    let [xmin, ymin, xmax, ymax] = *window;
    let corner = [
        pick(is_max(edge), xmax, xmin),
        pick(is_max(edge), ymax, ymin),
    ];
    pick(axis(edge) == 0, corner[0], corner[1])
}

fn split(p: Point, axis: usize) -> [f64; 2] {
    [pick(axis == 0, p[0], p[1]), pick(axis == 0, p[1], p[0])]
}

fn crossing(ends: &[Point; 2], axis: usize, c: f64) -> f64 {
    let [[a1, o1], [a2, o2]] = ends.map(|p| split(p, axis));
    let (w1, w2, whole) = (c - a1, a2 - c, a2 - a1);
    if w1 == 0.0 {
        return o1;
    }
    if w2 == 0.0 {
        return o2;
    }
    let sign = whole.to_bits() & (1 << 63);
    let [w1, w2, whole] = [w1, w2, whole].map(|w| f64::from_bits(w.to_bits() ^ sign));
    let sum = o1 * w2 + o2 * w1;
    if (3.054_936_363_499_605e-151..=3.273_390_607_896_142e150).contains(&whole) && sum.is_finite()
    {
        sum / whole
    } else {
        out_of_range()
    }
}

/// The benchmark's segments have ordinary coordinates.
#[cold]
fn out_of_range() -> f64 {
    panic!("a segment out of the ordinary")
}

fn clamp_between(x: f64, bound: f64, other: f64) -> f64 {
    let ordered = bound < other;
    let low = if ordered { bound } else { other };
    let high = if ordered { other } else { bound };
    let x = if x < low { low } else { x };
    if x > high { high } else { x }
}

fn code([x, y]: Point, [xmin, ymin, xmax, ymax]: &[f64; 4]) -> u8 {
    u8::from(x < *xmin)
        | u8::from(x > *xmax) << 1
        | u8::from(y < *ymin) << 2
        | u8::from(y > *ymax) << 3
}

/// Cohen–Sutherland with codes written top, bottom, right, left.
#[inline(never)]
pub fn cohen_sutherland(input: &CohenSutherlandInput) -> Option<[Point; 2]> {
    let (window, segment) = (&input.window.to_array(), &ends(&input.segment));
    let mut ends = *segment;
    let mut codes = ends.map(|p| code(p, window));
    loop {
        let or = codes[0] | codes[1];
        if or == 0 {
            return Some(ends);
        }
        if codes[0] & codes[1] != 0 {
            return None;
        }
        let edge = or.trailing_zeros() as usize;
        let end = usize::from(codes[0] & 1 << edge == 0);
        let (c, axis) = (border(window, edge), axis(edge));
        let free = crossing(segment, axis, c);
        let [[_, free1], [_, free2]] = ends.map(|p| split(p, axis));
        let free = clamp_between(free, free1, free2);
        ends[end] = split([c, free], axis);
        codes[end] = code(ends[end], window);
    }
}

#[derive(Clone, Copy)]
struct Param {
    u: f64,
    edge: Option<usize>,
    leaving: bool,
}

impl Param {
    fn distances(&self, window: &[f64; 4], segment: &[Point; 2]) -> [f64; 2] {
        let Some(edge) = self.edge else {
            return if self.leaving { [1.0, 0.0] } else { [0.0, 1.0] };
        };
        let c = border(window, edge);
        segment.map(|p| {
            let [a, _] = split(p, axis(edge));
            if is_max(edge) { c - a } else { a - c }
        })
    }

    fn compare(&self, other: &Self, window: &[f64; 4], segment: &[Point; 2]) -> Ordering {
        let (u, v) = (self.u, other.u);
        let largest = u.abs().max(v.abs());
        let far_apart = (u - v).abs() > 4.0 * f64::EPSILON * largest;
        match u.partial_cmp(&v) {
            Some(order) if far_apart && largest > 2f64.powi(-900) => order,
            _ => {
                let [a1, a2] = self.distances(window, segment);
                let [b1, b2] = other.distances(window, segment);
                let Some(order) = (a1 * b2).partial_cmp(&(b1 * a2)) else {
                    out_of_range();
                    return Ordering::Equal;
                };
                if self.leaving == other.leaving {
                    order.reverse()
                } else {
                    order
                }
            }
        }
    }
}

/// Liang–Barsky as it is taught: a table of p, q and r.
#[inline(never)]
pub fn liang_barsky(input: &WindowInput) -> Option<[Point; 2]> {
    let (window, segment) = (&input.window.to_array(), &ends(&input.segment));
    let [[x1, y1], [x2, y2]] = *segment;
    let (dx, dy) = (x2 - x1, y2 - y1);
    let [mut u_min, mut u_max] = [false, true].map(|leaving| Param {
        u: f64::from(u8::from(leaving)),
        edge: None,
        leaving,
    });
    for edge in 0..N_EDGES {
        let c = border(window, edge);
        let (p, q) = [(-dx, x1 - c), (dx, c - x1), (-dy, y1 - c), (dy, c - y1)][edge];
        if p == 0.0 {
            if q < 0.0 {
                return None;
            }
            continue;
        }
        if !(p.is_finite() && q.is_finite()) {
            out_of_range();
        }
        let leaving = p > 0.0;
        let (u, edge) = (q / p + 0.0, Some(edge));
        let param = Param { u, edge, leaving };
        if leaving {
            if param.compare(&u_max, window, segment).is_lt() {
                u_max = param;
            }
        } else if u_min.compare(&param, window, segment).is_lt() {
            u_min = param;
        }
        if u_max.compare(&u_min, window, segment).is_lt() {
            return None;
        }
    }
    let touch = u_min.edge.is_some()
        && u_max.edge.is_some()
        && u_min.compare(&u_max, window, segment).is_eq();
    if touch {
        out_of_range();
    }
    let put =
        |p: Point, edge: Option<usize>| edge.map_or(p, |edge| on_border(window, segment, edge));
    Some([put(segment[0], u_min.edge), put(segment[1], u_max.edge)])
}

fn on_border(window: &[f64; 4], segment: &[Point; 2], edge: usize) -> Point {
    let (c, axis) = (border(window, edge), axis(edge));
    let free = crossing(segment, axis, c);
    let [[_, o1], [_, o2]] = segment.map(|p| split(p, axis));
    let [xmin, ymin, xmax, ymax] = *window;
    let [[_, low], [_, high]] = [[xmin, ymin], [xmax, ymax]].map(|p| split(p, axis));
    split(
        [c, clamp_between(clamp_between(free, o1, o2), low, high)],
        axis,
    )
}
