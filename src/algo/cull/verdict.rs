//! Why a sphere was kept or culled, and the smallest change that would turn that, or a triangle's fate in the funnel.
//!
//! A move along the normal n of plane k by s changes the distance from plane j by s · n_j·n_k (unit normals). Each plane says for
//! which s it does not reject; what all of them allow is an interval, and its end that is nearer to 0 is the answer. A triangle is
//! also turned about V0, straight towards the viewer or away from him, by the angle between n and e less 90°: e stays as it is,
//! so the angle is exact as far as floats go.

use glam::DVec3;

use crate::{
    algo::{parameter::moves_allowed, volume::signed_distance},
    geom::Plane,
    trace::{Recording, silent},
};

use super::{BackFace, BackFaceEvent, BackFaceInput, Containment, SphereCull, SphereCullInput};

/// What decided a sphere's fate.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SphereVerdict {
    /// What all planes say.
    pub class: Containment,
    /// The plane that rejected it; of one that is kept, the plane that would reject it first.
    pub plane_idx: usize,
    /// Of its centre from that plane.
    pub distance: f64,
    /// How far along that plane's normal it had to be moved to be culled instead of kept, or kept; none where no such move turns it.
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

/// How a triangle has to be turned so that it shows its other side.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct FaceTurn {
    /// Of length 1, through V0: about it the normal turns straight towards the viewer.
    pub axis: [f64; 3],
    /// By how many degrees until it is edge-on: negative away from the viewer.
    pub degrees: f64,
}

/// How far a triangle has to be moved along a plane's normal so that no plane has all of its corners outside.
#[must_use]
pub fn triangle_move(planes: &[Plane], triangle: &[[f64; 3]; 3], plane_idx: usize) -> Option<f64> {
    move_along(planes, plane_idx, |plane| {
        let distances = triangle.map(|corner| signed_distance::<f64>(plane, corner));
        distances.into_iter().fold(f64::NEG_INFINITY, f64::max)
    })
}

/// The least move along a plane's normal by which no plane rejects something any more, where each plane leaves it `room`.
fn move_along(planes: &[Plane], plane_idx: usize, room: impl Fn(&Plane) -> f64) -> Option<f64> {
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
