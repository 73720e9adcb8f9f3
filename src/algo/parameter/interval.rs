//! The interval of the parameter that is left, while one border after the other makes it shorter. All comparisons are exact
//! ([`Param::compare`]), and so are the questions that are asked of distances alone, whatever the borders are.

use std::cmp::Ordering;

use crate::trace::Real;

use super::{End, Param};

/// What is left, and the borders that set it; closed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Interval<R, B> {
    /// u_min and u_max.
    pub bounds: [Param<R, B>; 2],
}

impl<R: Real, B: Copy> Interval<R, B> {
    /// The whole segment: from 0 to 1.
    #[must_use]
    pub fn whole() -> Self {
        Self {
            bounds: End::BOTH.map(Param::at_end),
        }
    }

    /// Both bounds as they were computed.
    #[must_use]
    pub fn values(&self) -> [f64; 2] {
        self.bounds.map(|bound| bound.u.get())
    }

    /// Raises u_min to a parameter where the line enters, or lowers u_max to one where it leaves. Of two borders that
    /// are crossed at the same place the first keeps the bound, unless `wins_tie` against it. Does it move?
    #[inline]
    pub fn shrink(
        &mut self,
        to: Param<R, B>,
        distances: impl Fn(B) -> [f64; 2],
        wins_tie: impl Fn(B) -> bool,
    ) -> bool {
        // Two calls, so that each knows at compile time which bound it moves.
        if to.leaving {
            tighten(&mut self.bounds[1], to, Ordering::Less, distances, wins_tie)
        } else {
            tighten(
                &mut self.bounds[0],
                to,
                Ordering::Greater,
                distances,
                wins_tie,
            )
        }
    }

    /// u_min > u_max: nothing is left.
    #[inline]
    pub fn is_empty(&self, distances: impl Fn(B) -> [f64; 2]) -> bool {
        let [u_min, u_max] = &self.bounds;
        u_max.compare(u_min, distances).is_lt()
    }

    /// The borders that set both bounds; `None` where an end of the segment is one.
    pub fn borders(&self) -> Option<[B; 2]> {
        let [u_min, u_max] = &self.bounds;
        Some([u_min.border?, u_max.border?])
    }

    /// u_min = u_max: the line touches there.
    #[inline]
    pub fn is_touch(&self, distances: impl Fn(B) -> [f64; 2]) -> bool {
        let [u_min, u_max] = &self.bounds;
        u_min.compare(u_max, distances).is_eq()
    }
}

/// Moves a bound to a parameter that lies inwards of it, or takes its place at a tie. Does it move?
#[inline]
fn tighten<R: Real, B: Copy>(
    bound: &mut Param<R, B>,
    to: Param<R, B>,
    inwards: Ordering,
    distances: impl Fn(B) -> [f64; 2],
    wins_tie: impl Fn(B) -> bool,
) -> bool {
    let order = to.compare(bound, distances);
    let moves = order == inwards || order.is_eq() && bound.border.is_some_and(wins_tie);
    if moves {
        *bound = to;
    }
    moves
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Borders by their distances from both ends.
    fn crossing(distances: [f64; 2]) -> Param<f64, [f64; 2]> {
        let [d1, d2] = distances;
        Param {
            u: d1 / (d1 - d2),
            border: Some(distances),
            leaving: d2 < d1,
        }
    }

    #[test]
    fn each_border_moves_its_own_bound_inwards_only() {
        let mut left = Interval::whole();
        let cases = [
            ("enters at 1/4", [-1.0, 3.0], true, [0.25, 1.0]),
            ("entered before", [-1.0, 9.0], false, [0.25, 1.0]),
            ("leaves at 3/4", [3.0, -1.0], true, [0.25, 0.75]),
            ("left only later", [9.0, -1.0], false, [0.25, 0.75]),
            ("at the same place", [6.0, -2.0], false, [0.25, 0.75]),
        ];
        for (what, distances, moves, bounds) in cases {
            let moved = left.shrink(crossing(distances), |b| b, |_| false);
            assert_eq!((moved, left.values()), (moves, bounds), "{what}");
        }
        assert!(!left.is_empty(|b| b));
    }

    #[test]
    fn a_tie_goes_to_the_later_border_only_where_it_wins() {
        let mut left = Interval::whole();
        left.shrink(crossing([-1.0, 1.0]), |b| b, |_| true);
        let again = crossing([-2.0, 2.0]);
        assert!(!left.shrink(again, |b| b, |_| false));
        assert!(left.shrink(again, |b| b, |old| old == [-1.0, 1.0]));
        assert_eq!(left.bounds[0].border, Some([-2.0, 2.0]));
    }

    #[test]
    fn a_touch_is_told_from_nothing_beyond_rounding() {
        // 1/3 from the left, and a hair before or at 1/3 from above: the quotients are the same.
        let enters = [-1.0, 2.0];
        for (leaves, is_empty) in [([3.0, -6.0], false), ([3.0 - 4e-16, -6.0], true)] {
            let mut left = Interval::whole();
            left.shrink(crossing(enters), |b| b, |_| false);
            left.shrink(crossing(leaves), |b| b, |_| false);
            assert_eq!(left.is_empty(|b| b), is_empty, "{leaves:?}");
            assert_eq!(left.is_touch(|b| b), !is_empty, "{leaves:?}");
        }
    }
}
