//! Round things as they are seen.
//!
//! ```text
//!            ╭───╮      the sight lines that touch a ball touch it in a circle, nearer to the eye than its middle
//!   eye ●────│─┊ │      by r²/d, of radius r √(1 − r²/d²), d being the distance of the middle: what that circle
//!            ╰───╯      is projected to is the outline, an ellipse
//! ```

use glam::DVec3;

use super::{Seen, facets::cut_at};

const N_OUTLINE: usize = 96;
const ARC_STEP_RAD: f64 = 0.1;
/// Radius of an arc, and side of the square of a right angle, where half of the picture's height is 1.
const ARC: f64 = 0.13;
const SQUARE: f64 = 0.045;
const OF_ARM: f64 = 0.45;

impl Seen {
    pub(super) fn ball_outline(&self, centre: [f64; 3], radius: f64) -> Vec<[f64; 2]> {
        let centre = self.optics.view_from_world(centre.into());
        let Some(circle) = self.contour(centre, radius) else {
            return Vec::new();
        };
        let near = -self.optics.near * (1.0 + 1e-9);
        let seen = if circle.iter().all(|at| at.z <= near) {
            circle
        } else {
            cut_at(&circle, near)
        };
        seen.into_iter().map(|at| self.on_picture(at)).collect()
    }

    fn contour(&self, centre: DVec3, radius: f64) -> Option<Vec<DVec3>> {
        let toward = self.optics.toward_eye(centre);
        let axis = toward.try_normalize()?;
        let nearer = if self.optics.is_parallel() {
            0.0
        } else {
            radius / centre.length()
        };
        if nearer >= 1.0 {
            return None;
        }
        let middle = centre + axis * radius * nearer;
        let radius = radius * (1.0 - nearer * nearer).sqrt();
        let (right, up) = axis.any_orthonormal_pair();
        let turn = std::f64::consts::TAU / N_OUTLINE as f64;
        let at = |i: usize| {
            let (sin, cos) = libm::sincos(turn * i as f64);
            middle + (right * cos + up * sin) * radius
        };
        Some((0..N_OUTLINE).map(at).collect())
    }

    pub(super) fn right_angle_corner(&self, points: [[f64; 3]; 3]) -> Option<[[f64; 2]; 3]> {
        let (apex, [a, b], side) = self.arms(points, SQUARE)?;
        let corners = [a * side, (a + b) * side, b * side].map(|offset| apex + offset);
        let is_seen = corners.iter().all(|at| at.z < -self.optics.near);
        is_seen.then(|| corners.map(|at| self.on_picture(at)))
    }

    pub(super) fn arc(&self, points: [[f64; 3]; 3]) -> Option<(Vec<[f64; 2]>, [f64; 2])> {
        let (apex, [a, b], radius) = self.arms(points, ARC)?;
        let across = (b - a * a.dot(b)).try_normalize()?;
        let angle = libm::atan2(across.dot(b), a.dot(b));
        let n = (angle / ARC_STEP_RAD).ceil().max(2.0);
        let at = |i: usize| {
            let (sin, cos) = libm::sincos(angle * i as f64 / n);
            apex + (a * cos + across * sin) * radius
        };
        let arc: Vec<DVec3> = (0..=n as usize).map(at).collect();
        let is_seen = arc.iter().all(|at| at.z < -self.optics.near);
        let arc = arc.into_iter().map(|at| self.on_picture(at)).collect();
        is_seen.then(|| (arc, self.on_picture(apex)))
    }

    fn arms(&self, points: [[f64; 3]; 3], size: f64) -> Option<(DVec3, [DVec3; 2], f64)> {
        let [apex, a, b] = points.map(|at| self.optics.view_from_world(at.into()));
        if apex.z >= -self.optics.near {
            return None;
        }
        let arms = [a - apex, b - apex];
        let shorter = arms[0].length().min(arms[1].length());
        let length = (size * self.optics.half_height_at(apex.z)).min(OF_ARM * shorter);
        let [a, b] = arms.map(DVec3::try_normalize);
        Some((apex, [a?, b?], length))
    }
}
