//! Cohen–Sutherland in space: six bits instead of four, 27 regions instead of nine.
//!
//! ```text
//!        ┌──────┬──────┬──────┐           one bit a face, written far near top bottom right left
//!       ╱ 1001 ╱ 1000 ╱ 1010 ╱│
//!      ├──────┼──────┼──────┤ ╱│          before zmin each of the nine codes has 01 in front,
//!     ╱ 0001 ╱ 0000 ╱ 0010 ╱│╱ │          behind zmax 10, between the two 00
//!    ├──────┼──────┼──────┤ ╱│╱
//!   ╱ 0101 ╱ 0100 ╱ 0110 ╱│╱              OR  = 000000  both ends inside: accept
//!  └──────┴──────┴──────┘ ╱               AND ≠ 000000  both beyond one face: reject
//! ```
//!
//! 1. Give both ends a code.
//! 2. Accept or reject by OR and AND where that is possible.
//! 3. Take the lowest bit set in the OR. As the AND is 0, exactly one end has it: the segment crosses that face. Replace that
//!    end by the crossing, give it a new code, go to 2.
//!
//! The face is taken from the OR of both codes, as in the plane ([`CodeClip`]); crossings come from the ends as they were given,
//! and a cut end is kept within what is left.
//!
//! *Conventions*: closed box, near is zmin. *Degenerate*: a point is accepted or rejected by its codes; a touch is accepted.
//! *Bound*: each cut clears a bit of the OR for good, so there are at most 6. *Cost*: 12 comparisons for the codes; 5 +, 4 ×,
//! 2 ÷ and 12 comparisons a cut.
//!
//! *Source*: Newman and Sproull, *Principles of Interactive Computer Graphics*, 1973, pp. 123–124; in three dimensions J. D.
//! Foley and A. van Dam, *Fundamentals of Interactive Computer Graphics*, 1982, section 8.4.
//!
//! ```
//! use clipscope::{
//!     algo::volume::{CohenSutherland3d, CohenSutherland3dInput},
//!     geom::AlignedBox,
//!     trace::silent,
//! };
//! let bounds = AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0])?;
//! let ends = [[-2.0, 0.0, 0.0], [0.0, 0.0, 2.0]];
//! let visible = silent::<CohenSutherland3d>(&CohenSutherland3dInput { bounds, ends });
//! assert_eq!(visible, Some([[-1.0, 0.0, 1.0]; 2]), "it touches an edge of the box");
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use crate::{
    algo::{
        parameter::{Ratio, clamp_between},
        segment::{CodeClip, CodeEvent, Coded, VisibleLine},
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
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherland3dInput {
    /// Closed.
    pub bounds: AlignedBox,
    /// P₁ and P₂, finite.
    pub ends: [[f64; 3]; 2],
}

impl Coded<3> for CohenSutherland3dInput {
    type Side = VolumeSide;
    type Code = SideCode;
    type Output = VisibleLine<3>;
    const N_SIDES: usize = 6;

    fn ends(&self) -> [[f64; 3]; 2] {
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

    fn crossing<R: Real>(&self, side: VolumeSide, left: &[[f64; 3]; 2]) -> ([f64; 3], Ratio) {
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

    fn answer(visible: VisibleLine<3>) -> VisibleLine<3> {
        visible
    }
}
