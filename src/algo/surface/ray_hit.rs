//! What a ray finds where it meets the plane of a triangle.

use serde::Serialize;

use crate::trace::Real;

use super::Rays;

/// What a line of sight has to do with a triangle.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Meeting {
    /// Not asked: the triangle is edge-on, or shows its back and such are left out.
    Culled,
    /// n·r = 0: they never meet.
    Parallel,
    /// t < 0: it would be behind the eye.
    Behind,
    /// t < 1: before the near plane.
    BeforeNear,
    /// Beyond the far plane.
    BeyondFar,
    /// It meets the plane beside the triangle.
    Beside,
    /// It meets the triangle.
    Hit,
}

/// A question and its answer.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct PlaneHit {
    /// n·o + d
    pub numerator: f64,
    /// n·r
    pub denominator: f64,
    /// −numerator / denominator; none where the plane is not met.
    pub t: Option<f64>,
    /// What is found.
    pub meeting: Meeting,
}

/// A triangle that is met.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
pub struct RayHit {
    /// Of the triangle.
    pub id: u32,
    /// Where on the ray.
    pub t: f64,
    /// (z/w + 1) / 2 there.
    pub depth: f64,
}

impl PlaneHit {
    pub(super) fn hit<R: Real>(&self, id: u32, rays: &Rays) -> Option<RayHit> {
        let t = self.t.filter(|_| self.meeting == Meeting::Hit)?;
        let depth = rays.depth(R::new(t)).get().clamp(0.0, 1.0);
        Some(RayHit { id, t, depth })
    }
}

impl RayHit {
    /// Is it seen before another one? Of two as near, the lower id.
    pub(super) fn is_nearer<R: Real>(&self, other: Option<&Self>) -> bool {
        other.is_none_or(|other| {
            let [t, other_t] = [self.t, other.t].map(R::new);
            t < other_t || (self.id < other.id && t == other_t)
        })
    }
}
