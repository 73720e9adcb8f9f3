//! Cohen–Sutherland in space: six bits instead of four, 27 regions instead of nine ([`CodeClip`]); near is zmin. *Bound*: at most 6
//! cuts. *Cost*: 12 comparisons for the codes; 5 +, 4 ×, 2 ÷ and 12 comparisons a cut.
//!
//! *Source*: Newman and Sproull, *Principles of Interactive Computer Graphics*, 1973, pp. 123–124; in three dimensions J. D.
//! Foley and A. van Dam, *Fundamentals of Interactive Computer Graphics*, 1982, section 8.4.
//!
//! ```
//! use clipscope::{algo::volume::{CohenSutherland3d, CohenSutherland3dInput}, geom::AlignedBox, trace::silent};
//! let bounds = AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0])?;
//! let ends = [[-2.0, 0.0, 0.0], [0.0, 0.0, 2.0]];
//! let visible = silent::<CohenSutherland3d>(&CohenSutherland3dInput { bounds, ends });
//! assert_eq!(visible, Some([[-1.0, 0.0, 1.0]; 2]), "it touches an edge of the box");
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use crate::{
    algo::{
        parameter::{Ratio, clamp_between},
        segment::{CodeClip, CodeEvent, Coded, Ends, LineInput, VisibleLine},
    },
    geom::{AlignedBox, VolumeSide},
    trace::Real,
};

use super::{SideCode, liang_barsky_3d::upright};

/// The algorithm; see the module.
pub type CohenSutherland3d = CodeClip<3, CohenSutherland3dInput>;

/// What happens, in order.
pub type CohenSutherland3dEvent = CodeEvent<3, SideCode, VolumeSide>;

/// What to clip, and against what.
pub type CohenSutherland3dInput = LineInput<3, AlignedBox>;

impl Coded<3> for CohenSutherland3dInput {
    type Side = VolumeSide;
    type Code = SideCode;
    type Output = VisibleLine<3>;
    const N_SIDES: usize = 6;

    fn ends(&self) -> Ends<3> {
        self.ends
    }

    fn code<R: Real>(&self, at: [f64; 3]) -> SideCode {
        SideCode::of_box(at.map(R::new), &self.bounds)
    }

    fn lowest(&self, code: SideCode) -> Option<VolumeSide> {
        code.lowest()
    }

    fn has(&self, code: SideCode, side: VolumeSide) -> bool {
        code.has(side)
    }

    fn crossing<R: Real>(&self, side: VolumeSide, left: &Ends<3>) -> ([f64; 3], Ratio) {
        let share = upright(&self.bounds, side, &self.ends).share::<R>();
        let to = std::array::from_fn(|axis| {
            if axis == side.axis() {
                return self.bounds.border(side);
            }
            let mean = share.mean(self.ends[0][axis], self.ends[1][axis]);
            clamp_between(mean, left[0][axis], left[1][axis])
        });
        (to, share.ratio(true))
    }
}
