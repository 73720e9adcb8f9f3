//! A segment against the clip volume −w ≤ x, y, z ≤ w, before anything is divided by w: an end behind the eye would else land on the
//! other side of the screen. How far a point lies inside a side is w + x, w − x, and so on; left, right, bottom and top are planes
//! through the eye, behind which w + x and w − x add up to 2w < 0. The rest is [`LineClip`]'s. Where w < 0 at both ends, nothing is visible; what is left has w ≥ 0.
//!
//! *Exact*: the signs of w ± x; a clipped coordinate is assigned (x = w, bit for bit), at a touched edge both; the others are kept
//! within −w and w. *Source*: J. F. Blinn and M. E. Newell, "Clipping using homogeneous coordinates", SIGGRAPH 1978, pp. 245–251.
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
            Bounds, Ends, EventOf, LineClip, LineEvent, LineInput, LineRules, PlaneRow, VisibleLine,
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

/// How far both ends lie inside a side; of a quarter of everything where a difference is beyond all numbers.
#[must_use]
pub fn side_distances<R: Real>(side: VolumeSide, ends: &Ends<4>) -> [R; 2] {
    in_range(side, ends, ends.map(|at| distance(side, at)))
}

/// Of both ends as they were computed.
fn in_range<R: Real>(side: VolumeSide, ends: &Ends<4>, distances: [R; 2]) -> [R; 2] {
    let [d1, d2] = distances.map(R::get);
    if (d1 - d2).is_finite() {
        distances
    } else {
        ends.map(|at| R::new(distance(side, at.map(|x| 0.25 * x))))
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
    type Input = LineInput<4, Self>;
    type Output = VisibleLine<4>;

    fn planes(&self) -> impl Iterator<Item = VolumeSide> {
        VolumeSide::ALL.into_iter()
    }

    fn begin<R: Real, L: LineRules>(
        &self,
        ends: &mut Ends<4>,
    ) -> (Option<EventOf<4, Self>>, Option<[R; 4]>) {
        if L::DIVIDES_FIRST {
            *ends = ends.map(divided::<R>);
        }
        let behind = ends.map(|at| R::new(at[3]) < R::new(0.0));
        let ends = *ends;
        let depths = LineEvent::Depths { ends, behind };
        (
            Some(depths),
            (behind != [true; 2]).then_some([R::new(0.0); 4]),
        )
    }

    fn inequality<R: Real>(
        &self,
        side: VolumeSide,
        ends: &Ends<4>,
        _: &[R; 4],
    ) -> ([R; 2], PlaneRow) {
        let told = ends.map(|at| distance::<R>(side, at));
        let [d1, d2] = in_range(side, ends, told);
        let told = PlaneRow::of([told[0].get() - told[1].get(), told[0].get()]);
        ([d1 - d2, d1], told)
    }

    fn distances(&self, side: VolumeSide, ends: &Ends<4>) -> [f64; 2] {
        side_distances(side, ends)
    }

    fn crossing<R: Real>(
        &self,
        side: VolumeSide,
        touched: Option<VolumeSide>,
        ends: &Ends<4>,
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
