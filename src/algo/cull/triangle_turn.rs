//! What decided a triangle's fate in the funnel, and the smallest change that would turn it.
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
    algo::{parameter::moves_allowed, ring::Right, volume::signed_distance},
    geom::Plane,
    trace::Algorithm,
};

use super::{BackFace, BackFaceEvent, BackFaceInput, CullRules, Funnel, FunnelEvent, FunnelInput};

/// How a triangle has to be turned so that it shows its other side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FaceTurn {
    /// Of length 1, through V0: about it the normal turns straight towards the viewer.
    pub axis: [f64; 3],
    /// By how many degrees until it is edge-on: negative away from the viewer.
    pub degrees: f64,
}

/// The step that decided a triangle's fate, from 1, and what was said there: of the tests that it came to, the last one.
#[must_use]
pub fn triangle_fate<L: CullRules>(
    input: &FunnelInput,
    object_idx: usize,
    triangle_idx: usize,
) -> Option<(usize, FunnelEvent)> {
    let (mut step, mut object, mut last) = (0, None, None);
    Funnel::<L>::run::<f64>(input, |event| {
        step += 1;
        let is_about = match event {
            FunnelEvent::Object { object_idx, .. } => {
                object = Some(object_idx);
                false
            }
            FunnelEvent::Sphere { .. } => true,
            FunnelEvent::Triangle {
                triangle_idx: i, ..
            }
            | FunnelEvent::Face {
                triangle_idx: i, ..
            } => i == triangle_idx,
            FunnelEvent::Plane { .. } | FunnelEvent::Done => false,
        };
        if is_about && object == Some(object_idx) {
            last = Some((step, event));
        }
    });
    last
}

/// How far a triangle has to be moved along a plane's normal so that no plane has all of its corners outside; none where no
/// such move is there.
#[must_use]
pub fn triangle_move(planes: &[Plane], triangle: &[[f64; 3]; 3], plane_idx: usize) -> Option<f64> {
    let along = planes.get(plane_idx)?.unit_normal();
    let [low, _] = moves_allowed(planes.iter().map(|plane| {
        let distances = triangle.map(|corner| signed_distance::<f64>(plane, corner));
        let both = plane.unit_normal().into_iter().zip(along);
        let slope: f64 = both.map(|(a, b)| a * b).sum();
        [
            distances.into_iter().fold(f64::NEG_INFINITY, f64::max),
            slope,
        ]
    }))?;
    Some(low)
}

/// How a triangle has to be turned so that it shows its other side; none where it has no normal.
#[must_use]
pub fn face_turn(input: &BackFaceInput) -> Option<FaceTurn> {
    let (mut normal, mut to_viewer) = (None, None);
    BackFace::<Right>::run::<f64>(input, |event| match event {
        BackFaceEvent::Normal { normal: n, .. } => normal = Some(DVec3::from(n)),
        BackFaceEvent::ToViewer { to_viewer: e } => to_viewer = Some(DVec3::from(e)),
        BackFaceEvent::Products { .. } | BackFaceEvent::Done { .. } => {}
    });
    let (n, e) = (normal?.try_normalize()?, to_viewer?.try_normalize()?);
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
