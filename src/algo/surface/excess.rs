//! How far what is seen lies from the range in which products of its numbers keep their bits.

use crate::geom::{Sight, ViewVolume, exponent};

/// By which power of two a volume, and what stands before its camera, is too large or too small.
pub(super) fn excess(volume: &ViewVolume, points: &[[f64; 3]]) -> i32 {
    let (near, far) = (volume.near(), volume.far());
    let (depth, plain) = match volume.sight() {
        Sight::Perspective => (far, -200..200),
        Sight::Parallel => (far - near, -20..200),
    };
    let own = exponent(&[depth]);
    if plain.contains(&own) {
        return 0;
    }
    if own < 0 {
        // Nothing may become infinite.
        let [half_width, half_height] = volume.half_size();
        let lengths = [near, far, half_width, half_height];
        let largest = exponent(&lengths).max(exponent(points.as_flattened()));
        return own.max(largest - 1000).min(0);
    }
    // Nor may what is close to the eye vanish, or a narrow volume.
    let [half_width, half_height] = volume.half_size();
    let least = match volume.sight() {
        Sight::Perspective => near,
        Sight::Parallel => half_width.min(half_height),
    };
    own.min(exponent(&[least]) + 500).max(0)
}
