//! How far a point is from a segment.

use glam::DVec2;

/// Distance of a point from the segment between two others.
#[must_use]
pub fn distance_to_segment(at: [f64; 2], ends: [[f64; 2]; 2]) -> f64 {
    let [at, a, b] = [at, ends[0], ends[1]].map(DVec2::from);
    let along = b - a;
    let length_sq = along.length_squared();
    let t = if length_sq > 0.0 {
        ((at - a).dot(along) / length_sq).clamp(0.0, 1.0)
    } else {
        0.0
    };
    at.distance(a + along * t)
}
