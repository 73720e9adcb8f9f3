//! Seeded segments and polygons around a window: the same on every machine.

use crate::geom::{GeomError, Point, Polygon, Segment, Window};

/// `count` segments whose ends lie in a box of twice the window's size around it, on a grid of "short"
/// decimals. Only +, −, ×, ÷ and rounding are used, which IEEE 754 defines to the last bit.
#[must_use]
pub fn random_segments(window: &Window, count: usize, seed: u64) -> Vec<Segment> {
    let mut bits = SplitMix64(seed);
    let x = Span::around(window.min().x(), window.max().x());
    let y = Span::around(window.min().y(), window.max().y());
    let mut point = || {
        let (u, v) = (bits.unit(), bits.unit());
        Point::from_finite(x.at(u), y.at(v))
    };
    (0..count)
        .map(|_| Segment {
            p1: point(),
            p2: point(),
        })
        .collect()
}

/// Of more vertices than this, a random polygon is a coarse one with a rough outline: spikes so close together
/// would be a blot.
const COARSE: usize = 24;

/// A star-shaped polygon of `count` vertices around the window's middle, some near it and some beyond the
/// window. The directions go round a square, so that no sine is needed.
///
/// # Errors
/// [`GeomError::Degenerate`] where `count` is less than 3.
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

/// From well inside the window to well beyond it.
fn radius(unit: f64) -> f64 {
    0.35 + 1.25 * unit
}

/// The value at a part of the way round a closed row of knots.
fn between(knots: &[f64; COARSE], part: f64) -> f64 {
    let at = part * COARSE as f64;
    let knot = at as usize;
    let t = at - at.floor();
    knots[knot % COARSE] * (1.0 - t) + knots[(knot + 1) % COARSE] * t
}

/// An interval of twice the window's extent, and the grid on it.
struct Span {
    min: f64,
    max: f64,
    /// Grid lines per unit, a power of ten; `None` where the window is too small for decimals.
    per_unit: Option<f64>,
}

impl Span {
    fn around(min: f64, max: f64) -> Self {
        let half = max / 2.0 - min / 2.0;
        let mut per_unit = 1.0;
        // At least 100 grid lines across half the window; 10¹⁵ is still an exact double.
        while half * per_unit < 100.0 && per_unit < 1e15 {
            per_unit *= 10.0;
        }
        Self {
            min: (min - half).max(f64::MIN),
            max: (max + half).min(f64::MAX),
            per_unit: (half * per_unit >= 100.0).then_some(per_unit),
        }
    }

    fn at(&self, u: f64) -> f64 {
        let x = self.min * (1.0 - u) + self.max * u;
        match self.per_unit {
            Some(per_unit) if x.abs() < f64::MAX / per_unit => (x * per_unit).round() / per_unit,
            _ => x,
        }
    }
}

/// Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
struct SplitMix64(u64);

impl SplitMix64 {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// In [0, 1): 53 bits.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}
