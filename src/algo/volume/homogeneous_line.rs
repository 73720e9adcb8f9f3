//! A segment against the clip volume −w ≤ x, y, z ≤ w, before anything is divided by w.
//!
//! ```text
//!     x = −w ╲    w    ╱ x = w       P₂ lies behind the eye. Divided first, it lands on the other side of the screen,
//!             ╲   │ P₁╱              and the segment between both images is a piece that was never there.
//!   ─ w = 1 ───╲──┼●─╱──────
//!               ╲ │ ╳                Clipped first: cut where x = w, a place that can be divided.
//!   ──────────── ╲│╱─╲────── x
//!                eye  ● P₂
//! ```
//!
//! 1. Where w < 0 at both ends, nothing is visible: all of the line is behind the eye.
//! 2. Each side is a plane through the eye, and how far a point lies inside is w + x, w − x, and so on: six inequalities, and
//!    the rest is [`super::LineClip`]'s.
//! 3. What is left has w ≥ 0, and can be divided.
//!
//! *Conventions*: sides in the order near, far, left, right, bottom, top; closed. *Degenerate*: (0, 0, 0, 0) is no point and
//! not taken as an end; a line through the eye ends there. *Exact*: the signs of w ± x; a clipped coordinate is assigned
//! (x = w, bit for bit), at a touched edge both; the others are kept within −w and w. *Cost*: two comparisons; two additions
//! for both ends and one for p a side, a division where it is crossed; a mean for each coordinate of a crossing but one.
//!
//! *Source*: J. F. Blinn and M. E. Newell, "Clipping using homogeneous coordinates", SIGGRAPH 1978, pp. 245–251.
//!
//! ```
//! use clipscope::{algo::volume::{ClipSpace, HomogeneousLine, LineInput}, trace::silent};
//! let ends = [[1.0, 0.0, 0.0, 2.0], [2.0, 0.0, 0.0, -1.0]];
//! let visible = silent::<HomogeneousLine>(&LineInput { bounds: ClipSpace, ends });
//! assert_eq!(visible, Some([[1.0, 0.0, 0.0, 2.0], [1.25, 0.0, 0.0, 1.25]]));
//! ```

use crate::{
    algo::{
        parameter::clamp_between,
        segment::{
            Bounds, EventOf, LineClip, LineEvent, LineInput, LineRules, PlaneRow, VisibleLine,
        },
    },
    geom::VolumeSide,
    trace::Real,
};

use super::clip_vertex::distance;

/// The algorithm; see the module.
pub type HomogeneousLine = LineClip<4, ClipSpace>;

/// −w ≤ x, y, z ≤ w
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ClipSpace;

/// How far both ends lie inside a side. Of a quarter of everything where a difference is beyond all numbers: only the ratio
/// counts.
pub fn side_distances<R: Real>(side: VolumeSide, ends: &[[f64; 4]; 2]) -> [R; 2] {
    let distances = ends.map(|at| distance::<R>(side, at));
    let [d1, d2] = distances.map(R::get);
    if (d1 - d2).is_finite() {
        distances
    } else {
        ends.map(|at| distance(side, at.map(|x| 0.25 * x)))
    }
}

/// x/w, y/w, z/w, 1: what has no image is put as far away as there are numbers.
fn divided<R: Real>([x, y, z, w]: [f64; 4]) -> [f64; 4] {
    let over_w = |a: f64| {
        let quotient = (R::new(a) / R::new(w)).get();
        if quotient.is_nan() {
            0.0
        } else {
            quotient.clamp(f64::MIN, f64::MAX)
        }
    };
    [over_w(x), over_w(y), over_w(z), 1.0]
}

impl Bounds<4> for ClipSpace {
    type Plane = VolumeSide;
    type Row = PlaneRow;
    type Once<R: Real> = ();
    type Input = LineInput<4, Self>;
    type Output = VisibleLine<4>;

    fn answer(visible: VisibleLine<4>) -> VisibleLine<4> {
        visible
    }

    fn planes(&self) -> impl Iterator<Item = VolumeSide> {
        VolumeSide::ALL.into_iter()
    }

    fn begin<R: Real, L: LineRules>(
        &self,
        ends: &mut [[f64; 4]; 2],
    ) -> (Option<EventOf<4, Self>>, Option<()>) {
        if L::DIVIDES_FIRST {
            *ends = ends.map(divided::<R>);
        }
        let behind = ends.map(|at| R::new(at[3]) < R::new(0.0));
        let ends = *ends;
        let depths = LineEvent::Depths { ends, behind };
        (Some(depths), (behind != [true; 2]).then_some(()))
    }

    fn inequality<R: Real>(
        &self,
        side: VolumeSide,
        ends: &[[f64; 4]; 2],
        (): &(),
    ) -> ([R; 2], PlaneRow) {
        let [d1, d2] = side_distances::<R>(side, ends);
        let p_and_q = [d1 - d2, d1];
        (p_and_q, PlaneRow::of(p_and_q))
    }

    fn quotient<R: Real>(&self, _: VolumeSide, _: &[[f64; 4]; 2], [p, q]: [R; 2]) -> R {
        R::new((q / p).get() + 0.0)
    }

    fn distances(&self, side: VolumeSide, ends: &[[f64; 4]; 2]) -> [f64; 2] {
        side_distances(side, ends)
    }

    fn crossing<R: Real>(
        &self,
        side: VolumeSide,
        touched: Option<VolumeSide>,
        ends: &[[f64; 4]; 2],
    ) -> [f64; 4] {
        let share = side.share::<R>(*ends, side_distances(side, ends));
        // What is inside of all sides has no w below 0: but for rounding.
        let w = share.mean(ends[0][3], ends[1][3]).max(0.0);
        let assigned = [Some(side), touched];
        let given = |axis| {
            assigned
                .into_iter()
                .flatten()
                .find(|side| side.axis() == axis)
        };
        std::array::from_fn(|axis| match given(axis) {
            _ if axis == 3 => w,
            Some(side) if side.is_high() => w,
            Some(_) => 0.0 - w,
            None => clamp_between(share.mean(ends[0][axis], ends[1][axis]), -w, w),
        })
    }
}
