//! Of two triangles, may the first be painted before the second?
//!
//! ```text
//!   eye ●        ╱ Q       P before Q is right where at least one of these holds, asked in this order:
//!               ╱            1  all of P lies deeper than all of Q
//!              ╱  ╲ P        2  their extents on the screen do not meet
//!             ╱    ╲         3  P lies on the far side of Q's plane
//!                            4  Q lies on the near side of P's plane
//!                            5  nowhere on the screen is P nearer than Q
//! ```
//!
//! The last is the exact truth, the others are cheaper and imply it. Only what is seen counts: the parts in the view volume, and the
//! area that they share on the screen. Where they share none, or only touch, either may come first; where they lie in one plane, the lower
//! id is painted later.
//!
//! *Cost*: comparisons of extents, and 30 ×, 18 + and a comparison for each side of a plane, 9 ×, 6 + and a comparison for each turn on the
//! screen. Clipping by the volume is not counted.
//!
//! *Exact*: every side is the sign of a determinant of the given coordinates; the vertices at which the volume cuts a
//! triangle are rounded.
//!
//! *Source*: M. E. Newell, R. G. Newell and T. L. Sancha, "A solution to the hidden surface problem", Proceedings of the ACM
//! Annual Conference, 1972, pp. 443–450.

use std::cmp::Ordering;

use serde::Serialize;

use crate::{algo::volume::clipped, geom::Sight, trace::Real};

use super::{
    Surfaces,
    sides::{point, side_of, turn_of},
};

/// The questions, in the order in which they are asked.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PairTest {
    /// Does all of P lie deeper than all of Q?
    DepthExtents,
    /// Do their extents on the screen not meet?
    ScreenExtents,
    /// Does P lie on the far side of Q's plane?
    BehindPlane,
    /// Does Q lie on the near side of P's plane?
    BeforePlane,
    /// Is P nearer nowhere on the screen?
    Overlap,
}

impl PairTest {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::DepthExtents,
        Self::ScreenExtents,
        Self::BehindPlane,
        Self::BeforePlane,
        Self::Overlap,
    ];
}

/// May these surfaces be painted in this order? Each pair is asked about.
#[must_use]
pub fn is_order(surfaces: &Surfaces, order: &[u32]) -> bool {
    let occupant = |&id: &u32| {
        let corners = surfaces.triangles().get(id as usize)?;
        Some(Occupant::new::<f64>(surfaces, id, *corners))
    };
    let Some(all) = order.iter().map(occupant).collect::<Option<Vec<_>>>() else {
        return false;
    };
    let may_go_first = |(i, one): (usize, &Occupant)| {
        let mut later = all[i + 1..].iter();
        later.all(|other| one.may_precede::<f64>(other, surfaces).0)
    };
    all.iter().enumerate().all(may_go_first)
}

/// A triangle as pairs are asked about.
#[derive(Clone, PartialEq, Debug)]
pub struct Occupant {
    /// Which.
    pub id: u32,
    corners: [[f64; 3]; 3],
    /// `Equal` where nothing of it can be seen.
    turn: Ordering,
    visible: Vec<[f64; 3]>,
    depths: [f64; 2],
    screen: [[f64; 2]; 2],
}

impl Occupant {
    /// One of these surfaces.
    #[must_use]
    pub fn new<R: Real>(surfaces: &Surfaces, id: u32, corners: [[f64; 3]; 3]) -> Self {
        let [a, b, c] = corners.map(|[_, _, z]| -z);
        let mut visible = corners.to_vec();
        for plane in surfaces.volume().planes() {
            visible = clipped(&visible, &plane);
        }
        let mut screen = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for &[x, y, z] in &visible {
            let w = match surfaces.volume().sight() {
                Sight::Perspective => -z,
                Sight::Parallel => 1.0,
            };
            for (extent, at) in screen.iter_mut().zip([x / w, y / w]) {
                *extent = [extent[0].min(at), extent[1].max(at)];
            }
        }
        Self {
            id,
            corners,
            turn: if visible.is_empty() {
                Ordering::Equal
            } else {
                shown_turn::<R>(surfaces, corners)
            },
            visible,
            depths: [a.min(b).min(c), a.max(b).max(c)],
            screen,
        }
    }

    /// Before the eye's plane: the nearest and the farthest vertex.
    #[must_use]
    pub const fn depths(&self) -> [f64; 2] {
        self.depths
    }

    /// May it be painted before another one? And by which test, the last that was asked.
    #[must_use]
    pub fn may_precede<R: Real>(&self, other: &Self, surfaces: &Surfaces) -> (bool, PairTest) {
        let [[nearest, _], [_, farthest]] = [self.depths, other.depths].map(|d| d.map(R::new));
        if nearest > farthest {
            return (true, PairTest::DepthExtents);
        }
        if self.is_apart::<R>(other) {
            return (true, PairTest::ScreenExtents);
        }
        let sides = self.sides_of::<R>(&other.corners, surfaces);
        let is_coplanar = sides == [Ordering::Equal; 3];
        if !is_coplanar && !sides.contains(&Ordering::Greater) {
            return (true, PairTest::BehindPlane);
        }
        let sides = other.sides_of::<R>(&self.corners, surfaces);
        if !is_coplanar && !sides.contains(&Ordering::Less) {
            return (true, PairTest::BeforePlane);
        }
        let may = !self.shares_area::<R>(other, surfaces)
            || if is_coplanar {
                self.id > other.id
            } else {
                !self.is_nearer_somewhere::<R>(other, surfaces)
            };
        (may, PairTest::Overlap)
    }

    /// Is there room between them on the screen, by more than rounding? Of what cannot be seen, always.
    fn is_apart<R: Real>(&self, other: &Self) -> bool {
        if self.turn == Ordering::Equal || other.turn == Ordering::Equal {
            return true;
        }
        self.screen.iter().zip(other.screen).any(|(one, other)| {
            let [low, high, other_low, other_high] =
                [one[0], one[1], other[0], other[1]].map(R::new);
            let clear = |from: R, to: R| {
                from < to && to.get() - from.get() > 8.0 * f64::EPSILON * to.get().abs()
            };
            clear(high, other_low) || clear(other_high, low)
        })
    }

    /// Where its corners lie, as seen from the plane of a triangle: `Greater` on the eye's side.
    fn sides_of<R: Real>(&self, triangle: &[[f64; 3]; 3], surfaces: &Surfaces) -> [Ordering; 3] {
        let eye = side_of::<R>(triangle, surfaces.eye());
        self.corners
            .map(|corner| relative(side_of::<R>(triangle, point(corner)), eye))
    }

    /// Have they an area in common on the screen? Not if everything of one lies beyond an edge of the other.
    fn shares_area<R: Real>(&self, other: &Self, surfaces: &Surfaces) -> bool {
        !self.has_dividing_edge::<R>(other, surfaces)
            && !other.has_dividing_edge::<R>(self, surfaces)
    }

    fn has_dividing_edge<R: Real>(&self, other: &Self, surfaces: &Surfaces) -> bool {
        self.edges().any(|[a, b]| {
            let turns = other
                .visible
                .iter()
                .map(|&v| turn::<R>(surfaces, [a, b, v]));
            let mut has_any = false;
            for turn in turns {
                if turn == self.turn {
                    return false;
                }
                has_any |= turn != Ordering::Equal;
            }
            has_any
        })
    }

    /// Given that they share an area and no plane: is it nearer at a corner of that area, a vertex inside the other or a crossing of edges?
    fn is_nearer_somewhere<R: Real>(&self, other: &Self, surfaces: &Surfaces) -> bool {
        let nearer_side = |a: &Self, b: &Self, is_nearer: Ordering| {
            let eye = side_of::<R>(&b.corners, surfaces.eye());
            let inside = a.visible.iter().filter(|v| b.holds::<R>(**v, surfaces));
            let mut sides = inside.map(|&v| relative(side_of::<R>(&b.corners, point(v)), eye));
            sides.any(|side| side == is_nearer)
        };
        nearer_side(self, other, Ordering::Greater)
            || nearer_side(other, self, Ordering::Less)
            || self.edges().any(|edge| {
                let mut crossed = other.edges();
                crossed.any(|crossed| passes_before::<R>(edge, crossed, surfaces))
            })
    }

    /// Does a vertex lie in it, or on its outline, as they are seen?
    fn holds<R: Real>(&self, v: [f64; 3], surfaces: &Surfaces) -> bool {
        let outside = self.turn.reverse();
        self.edges()
            .all(|[a, b]| turn::<R>(surfaces, [a, b, v]) != outside)
    }

    fn edges(&self) -> impl Iterator<Item = [[f64; 3]; 2]> + '_ {
        let n = self.visible.len();
        (0..n).map(move |i| [self.visible[i], self.visible[(i + 1) % n]])
    }
}

/// Do two edges cross as they are seen, and is the first one nearer there?
fn passes_before<R: Real>(
    [a, b]: [[f64; 3]; 2],
    [c, d]: [[f64; 3]; 2],
    surfaces: &Surfaces,
) -> bool {
    let is_between = |one: Ordering, other: Ordering| {
        one != Ordering::Equal && other != Ordering::Equal && one != other
    };
    let [to_c, to_d] = [c, d].map(|v| turn::<R>(surfaces, [a, b, v]));
    if !is_between(to_c, to_d) {
        return false;
    }
    let [to_a, to_b] = [a, b].map(|v| turn::<R>(surfaces, [c, d, v]));
    // The tetrahedron of all four turns one way where the first edge is before the second, the other way where it is behind.
    is_between(to_a, to_b) && side_of::<R>(&[a, b, c], point(d)) == to_d.reverse()
}

/// [`Surfaces::turn`], counted.
fn turn<R: Real>(surfaces: &Surfaces, points: [[f64; 3]; 3]) -> Ordering {
    turn_of::<R>(points.map(|point| surfaces.sight_line(point))).reverse()
}

/// [`Surfaces::shown_turn`], counted.
fn shown_turn<R: Real>(surfaces: &Surfaces, corners: [[f64; 3]; 3]) -> Ordering {
    match turn::<R>(surfaces, corners) {
        Ordering::Less if surfaces.culls_backs() => Ordering::Equal,
        turn => turn,
    }
}

/// `Greater` on the same side as the eye, which is not in the plane.
fn relative(side: Ordering, eye: Ordering) -> Ordering {
    if eye == Ordering::Greater {
        side
    } else {
        side.reverse()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::ViewVolume;

    fn may(triangles: [[[f64; 3]; 3]; 2]) -> [(bool, PairTest); 2] {
        let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 100.0).unwrap();
        let surfaces = Surfaces::new([8, 8], volume, triangles, false).unwrap();
        let [p, q] = [0, 1].map(|i| Occupant::new::<f64>(&surfaces, i as u32, triangles[i]));
        [
            p.may_precede::<f64>(&q, &surfaces),
            q.may_precede::<f64>(&p, &surfaces),
        ]
    }

    #[test]
    fn each_test_decides_where_it_can() {
        use PairTest::*;
        let wall = |x: f64, z: f64| [[x - 1.0, -1.0, z], [x + 1.0, -1.0, z], [x, 1.0, z]];
        let [near, far] = [wall(0.0, -4.0), wall(0.0, -6.0)];
        assert_eq!(may([far, near]), [(true, DepthExtents), (false, Overlap)]);
        let aside = wall(3.0, -5.0);
        assert_eq!(
            may([near, aside]),
            [(true, ScreenExtents), (true, DepthExtents)]
        );
        // It comes nearer than the wall's depth, but not before the wall.
        let slanted = [[-1.0, -1.0, -6.0], [1.0, -1.0, -6.0], [0.0, 30.0, -3.0]];
        let half = wall(0.0, -5.9);
        let [first, _] = may([slanted, half]);
        assert_eq!(first, (false, Overlap), "its top stands before the plane");
        let low = [[-1.0, -1.0, -6.0], [1.0, -1.0, -6.0], [0.0, 1.0, -4.0]];
        assert_eq!(may([low, near]), [(true, BehindPlane), (false, Overlap)]);
    }

    #[test]
    fn what_pierces_allows_neither() {
        let one = [[-2.0, -1.0, -4.0], [2.0, -1.0, -6.0], [0.0, 2.0, -5.0]];
        let other = [[-2.0, -1.0, -6.0], [2.0, -1.0, -4.0], [0.0, 2.0, -5.0]];
        assert_eq!(may([one, other]).map(|(may, _)| may), [false; 2]);
    }

    #[test]
    fn what_touches_allows_both_and_one_plane_is_a_tie() {
        let [a, b, c, d] = [
            [-1.0, -1.0, -4.0],
            [1.0, -1.0, -4.0],
            [1.0, 1.0, -6.0],
            [-1.0, 1.0, -6.0],
        ];
        assert_eq!(may([[a, b, c], [a, c, d]]).map(|(may, _)| may), [true; 2]);
        assert_eq!(
            may([[a, b, c], [a, b, d]]),
            [(false, PairTest::Overlap), (true, PairTest::Overlap)]
        );
    }
}
