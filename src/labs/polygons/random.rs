//! A seeded polygon around a window.

use crate::{
    geom::{GeomError, Polygon, Window},
    labs::split_mix::SplitMix64,
};

/// Of more vertices than this, a random polygon is a coarse one with a rough outline: spikes so close together
/// would be a blot.
const COARSE: usize = 24;

/// A star-shaped polygon of `count` vertices, three or more, around the window's middle, some near it and some beyond the
/// window. The directions go round a square, so that no sine is needed.
pub fn random_polygon(window: &Window, count: usize, seed: u64) -> Result<Polygon, GeomError> {
    let mut bits = SplitMix64(seed);
    let [xmin, ymin, xmax, ymax] = window.to_array();
    let (cx, cy) = (xmin.midpoint(xmax), ymin.midpoint(ymax));
    let (half_width, half_height) = (0.5 * xmax - 0.5 * xmin, 0.5 * ymax - 0.5 * ymin);
    let is_rough = count > COARSE;
    let knots: [f64; COARSE] = if is_rough {
        std::array::from_fn(|_| radius(bits.unit()))
    } else {
        [0.0; COARSE]
    };
    let vertex = |i: usize| {
        let along = 8.0 * (i as f64 + 0.5 * bits.unit()) / count as f64;
        let [x, y] = match along {
            a if a < 2.0 => [1.0, a - 1.0],
            a if a < 4.0 => [3.0 - a, 1.0],
            a if a < 6.0 => [-1.0, 5.0 - a],
            a => [a - 7.0, -1.0],
        };
        let radius = if is_rough {
            // As rough as its vertices are far apart.
            let deviation = (bits.unit() - 0.5) * 8.0 / count as f64;
            between(&knots, along / 8.0) + deviation
        } else {
            radius(bits.unit())
        };
        [cx + half_width * radius * x, cy + half_height * radius * y]
    };
    let outline: Vec<[f64; 2]> = (0..count).map(vertex).collect();
    Polygon::new(&outline)
}

fn radius(unit: f64) -> f64 {
    0.35 + 1.25 * unit
}

fn between(knots: &[f64; COARSE], part: f64) -> f64 {
    let at = part * COARSE as f64;
    let knot = at as usize;
    let t = at - at.floor();
    knots[knot % COARSE] * (1.0 - t) + knots[(knot + 1) % COARSE] * t
}
