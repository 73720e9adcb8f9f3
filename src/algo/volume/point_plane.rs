//! Which side of a plane is a point on? Inside is n·p + d ≥ 0, for every volume here is closed.

use serde::Serialize;

use crate::{
    geom::{Plane, Wide},
    trace::{Real, wide_quotient},
};

/// The three answers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PlaneSide {
    /// On the side that the normal points to.
    Inside,
    /// On the plane itself, which counts as inside.
    On,
    /// On the other side.
    Outside,
}

impl PlaneSide {
    /// From n·p + d, or the distance.
    pub fn of<R: Real>(value: R) -> Self {
        let zero = R::new(0.0);
        if value > zero {
            Self::Inside
        } else if value == zero {
            Self::On
        } else {
            Self::Outside
        }
    }
}

/// n·p + d: the distance of p from the plane, |n| times as long. Exact where products and sums are, and so is its sign.
#[inline]
#[must_use]
pub fn weighted_sum<R: Real>(plane: &Plane, p: [f64; 3]) -> R {
    let [x, y, z] = p.map(R::new);
    let [a, b, c] = plane.normal().map(R::new);
    a * x + b * y + c * z + R::new(plane.d())
}

/// Has nothing of n·p + d been lost above or below the range of f64? Where it comes to next to nothing only [`Wide`] knows.
#[inline]
pub fn is_plain(sum: f64) -> bool {
    /// 2⁻⁹⁰⁰
    const SMALL: f64 = 1.183_052_186_166_774_7e-271;
    (SMALL..f64::INFINITY).contains(&sum.abs())
}

/// n·p + d; beyond the range of f64 the largest or the smallest number, so that the sign is right.
#[cold]
pub fn bounded_sum(plane: &Plane, p: [f64; 3]) -> f64 {
    weighted_sum::<Wide>(plane, p).bounded()
}

/// n·p + d of both ends of a segment, over the same power of two.
#[cold]
pub fn scaled_sums(plane: &Plane, ends: [[f64; 3]; 2]) -> [f64; 2] {
    Wide::near_one(ends.map(|end| weighted_sum(plane, end))).0
}

/// (n·p + d) / |n|: positive on the side that the normal points to, infinite where it is larger than any number. A normal of length 1
/// costs no division.
#[inline]
#[must_use]
pub fn signed_distance<R: Real>(plane: &Plane, p: [f64; 3]) -> R {
    let sum = weighted_sum::<R>(plane, p);
    if !is_plain(sum.get()) {
        return wide_distance(plane, p);
    }
    match plane.length() {
        1.0 => sum,
        length => sum / R::new(length),
    }
}

#[cold]
fn wide_distance<R: Real>(plane: &Plane, p: [f64; 3]) -> R {
    let sum = weighted_sum::<Wide>(plane, p);
    let length = plane.length();
    if length == 1.0 {
        return R::new(sum.get());
    }
    wide_quotient(sum, Wide::new(length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::times_power;

    fn distance(plane: [f64; 4], p: [f64; 3]) -> f64 {
        signed_distance(&Plane::new(plane).unwrap(), p)
    }

    #[test]
    fn distances_are_right_wherever_they_are_numbers() {
        let (max, min) = (f64::MAX, 5e-324);
        for (plane, at, expected) in [
            ([1e160, 1e160, 0.0, 0.0], [1e160, -1e160, 0.0], 0.0),
            ([1e160, 0.0, 0.0, 0.0], [-1e160, 0.0, 0.0], -1e160),
            ([0.0, 1e-200, 0.0, 0.0], [7.0, 1e-200, 7.0], 1e-200),
            ([max, 0.0, 0.0, 0.0], [max, 0.0, 0.0], max),
            ([0.0, 0.0, max, max], [0.0, 0.0, 1.0], 2.0),
            ([min, 0.0, 0.0, -min], [3.0, max, max], 2.0),
            ([1e-300, 0.0, 0.0, 0.0], [1e-300, max, 0.0], 1e-300),
            ([0.0, min, 0.0, 0.0], [0.0, -min, 0.0], -min),
            ([max, 0.0, 0.0, -max], [1.0, max, max], 0.0),
            ([1.0, 0.0, 0.0, max], [max, 0.0, 0.0], f64::INFINITY),
            ([1.0, 0.0, 0.0, -max], [max, 0.0, 0.0], 0.0),
            ([1e-300, 0.0, 0.0, 1e300], [0.0; 3], f64::INFINITY),
            ([1e300, 0.0, 0.0, 1e-300], [0.0, 5.0, 0.0], 0.0),
        ] {
            let found = distance(plane, at);
            let is_near = (found - expected).abs() <= f64::EPSILON * expected.abs();
            assert!(
                found == expected || is_near,
                "{found} of {plane:?} from {at:?}"
            );
        }
        // |n| is √2 times as large as any number.
        let found = distance([max, max, 0.0, 0.0], [1.0, 0.0, 0.0]);
        assert!((found - 0.5_f64.sqrt()).abs() < 1e-15, "{found}");
    }

    #[test]
    fn a_normal_as_many_times_as_long_makes_no_difference() {
        let (plane, at) = ([0.3, -0.7, 0.2, 1.1], [1.7, 0.4, -0.9]);
        let plain = distance(plane, at);
        for power in (-900..=900).step_by(50) {
            let scaled = distance(times_power(plane, power), at);
            assert_eq!(scaled, plain, "2^{power}");
        }
    }
}
