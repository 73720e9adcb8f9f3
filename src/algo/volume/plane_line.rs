//! A segment against any planes, oblique ones included: with d₁ = n·P₁ + d and d₂ = n·P₂ + d it meets a plane at a = d₁ / (d₁ − d₂),
//! whatever the length of n, and the rest is [`LineClip`]'s. A plane square to an axis assigns its coordinate, −d over the normal's;
//! elsewhere a crossing is on the plane but for rounding. *Cost*: six multiplications and seven additions a plane, a division where it
//! is crossed, and three for an oblique crossing.
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
        segment::{Bounds, Ends, LineClip, LineInput, PlaneRow, VisibleLine},
    },
    geom::Plane,
    trace::Real,
};

use super::point_plane::{is_plain, scaled_sums, weighted_sum};

/// The algorithm; see the module.
pub type PlaneLine = LineClip<3, Vec<Plane>>;

/// n·p + d of both ends; times the same power of two where they or their difference would leave the range of f64.
#[must_use]
pub fn plane_distances<R: Real>(plane: &Plane, ends: &Ends<3>) -> [R; 2] {
    in_range(plane, ends, ends.map(|at| weighted_sum(plane, at)))
}

/// Of both ends as they were computed.
fn in_range<R: Real>(plane: &Plane, ends: &Ends<3>, sums: [R; 2]) -> [R; 2] {
    let [d1, d2] = sums.map(R::get);
    if (d1 - d2).is_finite() && is_plain(d1) && is_plain(d2) {
        sums
    } else {
        scaled_sums(plane, *ends).map(R::new)
    }
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
    type Input = LineInput<3, Self>;
    type Output = VisibleLine<3>;

    fn planes(&self) -> impl Iterator<Item = usize> {
        0..self.len()
    }

    fn inequality<R: Real>(&self, plane: usize, ends: &Ends<3>, _: &[R; 3]) -> ([R; 2], PlaneRow) {
        let plane = &self[plane];
        let told = ends.map(|at| weighted_sum::<R>(plane, at));
        let [d1, d2] = in_range(plane, ends, told);
        let told = PlaneRow::of([told[0].get() - told[1].get(), told[0].get()]);
        ([d1 - d2, d1], told)
    }

    fn distances(&self, plane: usize, ends: &Ends<3>) -> [f64; 2] {
        plane_distances(&self[plane], ends)
    }

    fn crossing<R: Real>(&self, plane: usize, touched: Option<usize>, ends: &Ends<3>) -> [f64; 3] {
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
