//! Liang–Barsky in space: six inequalities, one for each face of a box ([`LineClip`]).
//!
//! *Conventions*: closed box, near is zmin. *Degenerate*: a point has all p = 0 and is accepted if all q ≥ 0; a box may be flat.
//! *Exact*: the face's own coordinate is assigned, at a touched edge both; the others are weighted means of the given ends', kept
//! within the box. *Cost*: at most 19 +, 8 ×, 10 ÷ and 37 comparisons. *Source*: Liang and Barsky, 1984, section 5.
//!
//! ```
//! use clipscope::{algo::volume::{LiangBarsky3d, LineInput}, geom::AlignedBox, trace::silent};
//! let bounds = AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0])?;
//! let ends = [[-2.0, -1.0, 0.0], [2.0, 1.0, 4.0]];
//! let visible = silent::<LiangBarsky3d>(&LineInput { bounds, ends });
//! assert_eq!(visible, Some([[-1.0, -0.5, 1.0]; 2]), "it comes in by left at u = 1/4, and leaves there by far");
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use crate::{
    algo::{
        parameter::{Upright, clamp_between},
        segment::{
            Bounds, Ends, EventOf, LineClip, LineEvent, LineInput, LineRules, PlaneRow, VisibleLine,
        },
    },
    geom::{AlignedBox, VolumeSide},
    trace::Real,
};

/// The algorithm; see the module.
pub type LiangBarsky3d = LineClip<3, AlignedBox>;

/// A face and both ends, along the axis across it.
pub fn upright(bounds: &AlignedBox, side: VolumeSide, ends: &Ends<3>) -> Upright {
    Upright {
        ends: ends.map(|at| at[side.axis()]),
        at: bounds.border(side),
        is_max: side.is_high(),
    }
}

impl Bounds<3> for AlignedBox {
    type Plane = VolumeSide;
    type Row = PlaneRow;
    type Input = LineInput<3, Self>;
    type Output = VisibleLine<3>;

    fn planes(&self) -> impl Iterator<Item = VolumeSide> {
        VolumeSide::ALL.into_iter()
    }

    fn begin<R: Real, L: LineRules>(
        &self,
        [p1, p2]: &mut Ends<3>,
    ) -> (Option<EventOf<3, Self>>, Option<[R; 3]>) {
        let delta = std::array::from_fn(|axis| R::new(p2[axis]) - R::new(p1[axis]));
        (Some(LineEvent::delta(delta)), Some(delta))
    }

    fn inequality<R: Real>(
        &self,
        side: VolumeSide,
        ends: &Ends<3>,
        delta: &[R; 3],
    ) -> ([R; 2], PlaneRow) {
        let axis = side.axis();
        let [from, border] = [ends[0][axis], self.border(side)].map(R::new);
        let p_and_q = if side.is_high() {
            [delta[axis], border - from]
        } else {
            [-delta[axis], from - border]
        };
        (p_and_q, PlaneRow::of(p_and_q))
    }

    fn quotient<R: Real>(&self, side: VolumeSide, ends: &Ends<3>, [p, q]: [R; 2]) -> R {
        upright(self, side, ends).quotient(q, p)
    }

    fn distances(&self, side: VolumeSide, ends: &Ends<3>) -> [f64; 2] {
        upright(self, side, ends).distances()
    }

    fn crossing<R: Real>(
        &self,
        side: VolumeSide,
        touched: Option<VolumeSide>,
        ends: &Ends<3>,
    ) -> [f64; 3] {
        let share = upright(self, side, ends).share::<R>();
        let assigned = [Some(side), touched].map(|side| Some((side?.axis(), self.border(side?))));
        std::array::from_fn(|axis| {
            let given = assigned.into_iter().flatten().find(|(of, _)| *of == axis);
            given.map_or_else(
                || {
                    let mean = share.mean(ends[0][axis], ends[1][axis]);
                    clamp_between(mean, self.min()[axis], self.max()[axis])
                },
                |(_, border)| border,
            )
        })
    }
}
