//! Parts of a segment, as intervals of its parameter.

use glam::DVec3;

use crate::algo::parameter::{Interval, Param};

/// Parts of a segment shorter than this share of it are what rounding leaves at its ends, not to be seen.
const SLIVER: f64 = 1e-6;

/// The part of a segment that lies on the inner side of all planes: n·p − d ≥ 0 for each normal and distance.
pub fn inside(
    [a, b]: [DVec3; 2],
    planes: impl IntoIterator<Item = (DVec3, f64)>,
) -> Option<[f64; 2]> {
    let mut left = Interval::<f64, [f64; 2]>::whole();
    for (normal, d) in planes {
        let distances = [a, b].map(|p| normal.dot(p) - d);
        let [d1, d2] = distances;
        match distances.map(|distance| distance < 0.0) {
            [true, true] => return None,
            [false, false] => continue,
            [true, false] | [false, true] => {}
        }
        let crossing = Param {
            u: d1 / (d1 - d2),
            border: Some(distances),
            leaving: d2 < d1,
        };
        left.shrink(crossing, |border| border, |_| false);
        if left.is_empty(|border| border) {
            return None;
        }
    }
    let [from, to] = left.values();
    (to - from > SLIVER).then_some([from, to])
}

pub fn union(mut intervals: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    intervals.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for [from, to] in intervals {
        match joined.last_mut() {
            Some(last) if from <= last[1] + SLIVER => last[1] = last[1].max(to),
            _ => joined.push([from, to]),
        }
    }
    joined
}

pub fn complement(intervals: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let starts = std::iter::once(0.0).chain(intervals.iter().map(|part| part[1]));
    let ends = intervals.iter().map(|part| part[0]).chain([1.0]);
    let gaps = starts.zip(ends).map(|(from, to)| [from, to]);
    gaps.filter(|[from, to]| to - from > SLIVER).collect()
}

/// On the way from `a` to `b`; at 0 and 1 exactly these.
pub fn between(a: DVec3, b: DVec3, t: f64) -> DVec3 {
    a * (1.0 - t) + b * t
}
