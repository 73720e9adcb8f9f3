//! Why a sphere was kept or culled, and the smallest change that would turn it.
//!
//! ```text
//!        plane k                       culled by plane k:  d < −r
//!    out   ┊  in                       moved along its normal by −r − d it touches, and another plane may still reject it;
//!   ◯ ───► ◯                           so the least move is asked of all planes, along this one normal
//!          ┊
//! ```
//!
//! A move along the normal n of plane k by s changes the distance from plane j by s · n_j·n_k (unit normals). Each plane then says
//! for which s it does not reject; what all of them allow is an interval, and its end that is nearer to 0 is the answer. Where there
//! is none, no move along this normal turns the verdict.

use crate::{algo::volume::signed_distance, trace::silent};

use super::{Containment, SphereCull, SphereCullInput, triangle_turn::move_along};

/// What decided a sphere's fate.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SphereVerdict {
    /// What all planes say.
    pub class: Containment,
    /// The plane that rejected it; of one that is kept, the plane that would reject it first.
    pub plane_idx: usize,
    /// Of its centre from that plane.
    pub distance: f64,
    /// How far along that plane's normal it had to be moved so that it is culled instead of kept, or kept instead of culled; none
    /// where no such move turns it.
    pub turn: Option<f64>,
}

/// Asks the planes, and how far the sphere is from another answer. None where there is no plane.
#[must_use]
pub fn sphere_verdict(input: &SphereCullInput) -> Option<SphereVerdict> {
    let SphereCullInput { planes, sphere } = input;
    let output = silent::<SphereCull>(input);
    let is_culled = output.class == Containment::Outside;
    let mut distances = output.distances.iter().copied().enumerate();
    let (plane_idx, distance) = if is_culled {
        distances.next_back()
    } else {
        distances.min_by(|a, b| a.1.total_cmp(&b.1))
    }?;
    let turn = if is_culled {
        move_along(planes, plane_idx, |plane| {
            let distance: f64 = signed_distance(plane, sphere.center());
            distance + sphere.radius()
        })
    } else {
        // One step beyond the touch, which is kept.
        Some(-(distance + sphere.radius()))
    };
    Some(SphereVerdict {
        class: output.class,
        plane_idx,
        distance,
        turn,
    })
}
