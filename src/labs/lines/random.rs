//! Seeded segments around a window.

use crate::{
    geom::{Point, Segment, Window},
    labs::split_mix::SplitMix64,
};

/// `count` segments whose ends lie in a box of twice the window's size around it, on a grid of "short"
/// decimals. Only +, −, ×, ÷ and rounding are used, which IEEE 754 defines to the last bit.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn random_segments_are_the_same_every_time() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).expect("a window");
        let segments = random_segments(&window, 1_000, 7);
        assert_eq!(segments, random_segments(&window, 1_000, 7));
        assert_ne!(segments, random_segments(&window, 1_000, 8));
        assert_eq!(segments[0].to_array(), [-0.44, -1.93, 1.6, 0.33]);
        let numbers = segments.iter().flat_map(|s| s.to_array());
        assert!(numbers.clone().all(|x| (-2.0..=2.0).contains(&x)));
        assert!(numbers.clone().any(|x| x > 1.9) && numbers.clone().any(|x| x < -1.9));
        for [a, b] in [
            [-1e308, 1e308],
            [1.0, 1.0 + f64::EPSILON],
            [-f64::MAX, f64::MAX],
            [0.0, 5e-324],
        ] {
            let window = Window::new(a, a, b, b).expect("a window");
            assert_eq!(
                random_segments(&window, 100, 1).len(),
                100,
                "[{a}, {b}]: finite"
            );
        }
    }
}
