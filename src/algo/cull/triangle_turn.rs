//! The smallest change that would turn a triangle's fate in the funnel.
//!
//! ```text
//!      ┊   V0 ●                     all corners beyond plane k: moved along its normal until the nearest corner touches,
//!   out┊ in  ╱ ╲                    unless all of them are beyond another plane then
//!   ◁──┊────●───●
//!
//!      n ▲   ╱ e                    a back: turned about V0, straight towards the viewer, by the angle between n and e less 90°;
//!        │ ╱ ← 90° is edge-on       a front: away from him by 90° less that angle
//!     V0 ●────
//! ```
//!
//! A plane leaves a triangle as much room as its farthest corner lies inside: it does not reject it where that is not negative.
//! Turned about V0 the way e to the viewer stays as it is, so the angle is exact as far as floats go.

use glam::DVec3;

use crate::{
    algo::{parameter::moves_allowed, volume::signed_distance},
    geom::Plane,
    trace::Recording,
};

use super::{BackFace, BackFaceEvent, BackFaceInput};

/// How a triangle has to be turned so that it shows its other side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FaceTurn {
    /// Of length 1, through V0: about it the normal turns straight towards the viewer.
    pub axis: [f64; 3],
    /// By how many degrees until it is edge-on: negative away from the viewer.
    pub degrees: f64,
}

/// How far a triangle has to be moved along a plane's normal so that no plane has all of its corners outside; none where no
/// such move is there.
#[must_use]
pub fn triangle_move(planes: &[Plane], triangle: &[[f64; 3]; 3], plane_idx: usize) -> Option<f64> {
    move_along(planes, plane_idx, |plane| {
        let distances = triangle.map(|corner| signed_distance::<f64>(plane, corner));
        distances.into_iter().fold(f64::NEG_INFINITY, f64::max)
    })
}

/// The least move along a plane's normal by which no plane rejects something any more, where each plane leaves it `room`.
pub(super) fn move_along(
    planes: &[Plane],
    plane_idx: usize,
    room: impl Fn(&Plane) -> f64,
) -> Option<f64> {
    let along = planes.get(plane_idx)?.unit_normal();
    let [low, _] = moves_allowed(planes.iter().map(|plane| {
        let both = plane.unit_normal().into_iter().zip(along);
        let slope: f64 = both.map(|(a, b)| a * b).sum();
        [room(plane), slope]
    }))?;
    // The deciding plane rejects it where it is, so that the move leads inwards.
    Some(low)
}

/// How a triangle has to be turned so that it shows its other side; none where it has no normal.
#[must_use]
pub fn face_turn(input: &BackFaceInput) -> Option<FaceTurn> {
    let recording = Recording::<BackFace>::new(*input);
    let [
        BackFaceEvent::Normal { normal, .. },
        BackFaceEvent::ToViewer { to_viewer },
        ..,
    ] = recording.events()
    else {
        return None;
    };
    let [n, e] = [normal, to_viewer].map(|&at| DVec3::from(at).try_normalize());
    let (n, e) = (n?, e?);
    let across = n.cross(e);
    // Straight towards the viewer or away from him any way round is as near.
    let axis = across
        .try_normalize()
        .unwrap_or_else(|| n.any_orthonormal_vector());
    let angle = libm::atan2(across.length(), n.dot(e)).to_degrees();
    Some(FaceTurn {
        axis: axis.into(),
        degrees: angle - 90.0,
    })
}
