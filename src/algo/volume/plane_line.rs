//! A segment against any planes, oblique ones included.
//!
//! ```text
//!    P₁ ●                      a = n·(p₀ − P₁) / n·(P₂ − P₁)       p₀: any point of the plane
//!        ╲   ▲ n
//!   ──────╲──┴───── n·p + d = 0
//!          ╲                   with d₁ = n·P₁ + d and d₂ = n·P₂ + d that is
//!           ● P₂               a = d₁ / (d₁ − d₂)
//! ```
//!
//! For n·p₀ = −d the numerator is −d₁, and the denominator is d₂ − d₁, because d falls out of the difference: so a plane is
//! asked twice what it is asked of any point ([`super::weighted_sum`]), and the rest is [`super::LineClip`]'s, with q = d₁ and
//! p = d₁ − d₂. A normal need not be of length 1: its length falls out of the quotient.
//!
//! *Conventions*: planes in the order in which they are given; normals point inside; all is closed. *Degenerate*: a point is
//! accepted if no plane has it outside. *Exact*: the signs of d₁ and d₂ are, where products and sums are; a plane square to an
//! axis assigns its coordinate, −d over the normal's; elsewhere a crossing is on the plane but for rounding. *Cost*: six
//! multiplications and seven additions a plane, a division where it is crossed, and three for an oblique crossing.
//!
//! *Source*: M. Cyrus and J. Beck, "Generalized two- and three-dimensional clipping", Computers & Graphics 3, 1978, pp. 23–28.
//!
//! ```
//! use clipscope::{algo::volume::{LineInput, PlaneLine}, geom::Plane, trace::silent};
//! let bounds = vec![Plane::new([1.0, 1.0, 1.0, 0.0])?];
//! let ends = [[-1.0, -1.0, -1.0], [3.0, 3.0, 3.0]];
//! let visible = silent::<PlaneLine>(&LineInput { bounds, ends });
//! assert_eq!(visible, Some([[0.0; 3], [3.0; 3]]));
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use crate::{
    algo::{
        parameter::{Share, clamp_between},
        segment::{Bounds, EventOf, LineClip, LineInput, LineRules, PlaneRow, VisibleLine},
    },
    geom::Plane,
    trace::Real,
};

use super::weighted_sum;

/// The algorithm; see the module.
pub type PlaneLine = LineClip<3, Vec<Plane>>;

/// Numbers whose products leave the range of f64 are made smaller by this first: 2⁻⁵⁴⁰. What that loses is too small to count
/// beside them.
const SMALLER: f64 = 2.778_448_436_856_347e-163;

/// d₁ and d₂: n·p + d of both ends. Where they or their difference are beyond all numbers, both made smaller by the same power
/// of two: only their ratio counts.
pub fn plane_distances<R: Real>(plane: &Plane, ends: &[[f64; 3]; 2]) -> [R; 2] {
    let distances = ends.map(|at| weighted_sum::<R>(plane, at));
    let [d1, d2] = distances.map(R::get);
    if (d1 - d2).is_finite() {
        return distances;
    }
    ends.map(|at| {
        let products = (0..3).map(|i| (SMALLER * plane.normal()[i]) * (SMALLER * at[i]));
        R::new(products.sum::<f64>() + SMALLER * (SMALLER * plane.d()))
    })
}

/// The coordinate that a plane square to an axis fixes, and the axis.
fn fixed(plane: &Plane) -> Option<(usize, f64)> {
    let normal = plane.normal();
    let mut across = (0..3).filter(|&axis| normal[axis] != 0.0);
    let axis = across.next()?;
    let border = 0.0 - plane.d() / normal[axis];
    (across.next().is_none() && border.is_finite()).then_some((axis, border))
}

impl Bounds<3> for Vec<Plane> {
    type Plane = usize;
    type Row = PlaneRow;
    type Once<R: Real> = ();
    type Input = LineInput<3, Self>;
    type Output = VisibleLine<3>;

    fn answer(visible: VisibleLine<3>) -> VisibleLine<3> {
        visible
    }

    fn planes(&self) -> impl Iterator<Item = usize> {
        0..self.len()
    }

    fn begin<R: Real, L: LineRules>(
        &self,
        _: &mut [[f64; 3]; 2],
    ) -> (Option<EventOf<3, Self>>, Option<()>) {
        (None, Some(()))
    }

    fn inequality<R: Real>(
        &self,
        plane: usize,
        ends: &[[f64; 3]; 2],
        (): &(),
    ) -> ([R; 2], PlaneRow) {
        let [d1, d2] = plane_distances::<R>(&self[plane], ends);
        let p_and_q = [d1 - d2, d1];
        (p_and_q, PlaneRow::of(p_and_q))
    }

    fn quotient<R: Real>(&self, _: usize, _: &[[f64; 3]; 2], [p, q]: [R; 2]) -> R {
        R::new((q / p).get() + 0.0)
    }

    fn distances(&self, plane: usize, ends: &[[f64; 3]; 2]) -> [f64; 2] {
        plane_distances(&self[plane], ends)
    }

    fn crossing<R: Real>(
        &self,
        plane: usize,
        touched: Option<usize>,
        ends: &[[f64; 3]; 2],
    ) -> [f64; 3] {
        let [d1, d2] = plane_distances::<R>(&self[plane], ends);
        let share = Share {
            weights: [-d1, d2],
            whole: d2 - d1,
            raw: [d1.get(), d2.get(), 0.0],
        };
        let assigned = [Some(plane), touched].map(|plane| fixed(&self[plane?]));
        std::array::from_fn(|axis| {
            let own = ends.map(|at| at[axis]);
            let given = assigned.into_iter().flatten().find(|(of, _)| *of == axis);
            given.map_or_else(
                || share.mean(own[0], own[1]),
                |(_, border)| clamp_between(border, own[0], own[1]),
            )
        })
    }
}
