//! Where an eye stands that goes round what it looks at.

use glam::DVec3;

/// An eye on a sphere around its target: right-handed, y up, looking along −z of its own axes.
///
/// ```
/// use clipscope::geom::Orbit;
/// let eye = Orbit::new([0.0; 3], [0.0, 0.0], 5.0, 30.0);
/// assert_eq!(eye.position(), [0.0, 0.0, 5.0]);
/// ```
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Orbit {
    target: DVec3,
    yaw_deg: f64,
    pitch_deg: f64,
    distance: f64,
    fov_y_deg: f64,
    aspect: f64,
}

/// Straight above and below there is no telling which way is up.
const MAX_PITCH_DEG: f64 = 89.0;
/// As near, and as far, as numbers of a scene are told apart.
const DISTANCES: [f64; 2] = [1e-6, 1e6];
/// A long lens and a wide one.
const FOVS_DEG: [f64; 2] = [1.0, 120.0];
/// Of what has to be seen, width over height, where nothing else is asked for.
const ASPECT: f64 = 1.4;
/// What is nearer than this part of the distance is not seen.
const NEAR: f64 = 0.01;

impl Orbit {
    /// Around `target`, turned by yaw (to the right) and pitch (upwards) in degrees, at a distance and with a field of
    /// view from bottom to top in degrees. Each is kept within what can be seen; what is no number becomes the least.
    #[must_use]
    pub fn new(
        target: [f64; 3],
        [yaw_deg, pitch_deg]: [f64; 2],
        distance: f64,
        fov_y_deg: f64,
    ) -> Self {
        let within = |x: f64, [low, high]: [f64; 2]| x.max(low).min(high);
        let finite = |x: f64| if x.is_finite() { x } else { 0.0 };
        Self {
            target: DVec3::from(target.map(finite)),
            yaw_deg: finite(yaw_deg) % 360.0,
            pitch_deg: within(pitch_deg, [-MAX_PITCH_DEG, MAX_PITCH_DEG]),
            distance: within(distance, DISTANCES),
            fov_y_deg: within(fov_y_deg, FOVS_DEG),
            aspect: ASPECT,
        }
    }

    /// The same eye, where so much is to be seen from left to right as its height times `aspect`.
    #[must_use]
    pub const fn wide(self, aspect: f64) -> Self {
        Self { aspect, ..self }
    }

    /// Of what has to be seen, its width over its height.
    #[must_use]
    pub const fn aspect(&self) -> f64 {
        self.aspect
    }

    /// What it goes round.
    #[must_use]
    pub fn target(&self) -> [f64; 3] {
        self.target.into()
    }

    /// Yaw and pitch, in degrees.
    #[must_use]
    pub const fn angles_deg(&self) -> [f64; 2] {
        [self.yaw_deg, self.pitch_deg]
    }

    /// From its target.
    #[must_use]
    pub const fn distance(&self) -> f64 {
        self.distance
    }

    /// From bottom to top, in degrees.
    #[must_use]
    pub const fn fov_y_deg(&self) -> f64 {
        self.fov_y_deg
    }

    /// Gone round by these angles, in degrees: what is seen turns with the pointer.
    #[must_use]
    pub fn turned(self, [yaw_deg, pitch_deg]: [f64; 2]) -> Self {
        let angles = [self.yaw_deg + yaw_deg, self.pitch_deg + pitch_deg];
        self.at(self.target(), angles, self.distance)
    }

    /// Nearer by this factor.
    #[must_use]
    pub fn zoomed(self, factor: f64) -> Self {
        let distance = self.distance / factor;
        self.at(self.target(), self.angles_deg(), distance)
    }

    /// Moved sideways, by so much of half the picture's height: what is seen goes the other way.
    #[must_use]
    pub fn panned(self, [x, y]: [f64; 2]) -> Self {
        let [right, up, _] = self.basis();
        let half = self.distance * self.half_height();
        let target = self.target + (right * x + up * y) * half;
        self.at(target.into(), self.angles_deg(), self.distance)
    }

    fn at(self, target: [f64; 3], angles_deg: [f64; 2], distance: f64) -> Self {
        Self::new(target, angles_deg, distance, self.fov_y_deg).wide(self.aspect)
    }

    /// Where the eye is, in world coordinates.
    #[must_use]
    pub fn position(&self) -> [f64; 3] {
        let [_, _, back] = self.basis();
        (self.target + back * self.distance).into()
    }

    /// What is nearer is not seen.
    #[must_use]
    pub fn near(&self) -> f64 {
        NEAR * self.distance
    }

    /// Half of what is seen from bottom to top, at the distance 1.
    #[must_use]
    pub fn half_height(&self) -> f64 {
        libm::tan(0.5 * self.fov_y_deg.to_radians())
    }

    /// To the right, upwards and back from what is seen, each of length 1.
    #[must_use]
    pub fn axes(&self) -> [[f64; 3]; 3] {
        self.basis().map(Into::into)
    }

    fn basis(&self) -> [DVec3; 3] {
        let (sin_yaw, cos_yaw) = libm::sincos(self.yaw_deg.to_radians());
        let (sin_pitch, cos_pitch) = libm::sincos(self.pitch_deg.to_radians());
        let back = DVec3::new(cos_pitch * sin_yaw, sin_pitch, cos_pitch * cos_yaw);
        let right = DVec3::new(cos_yaw, 0.0, -sin_yaw);
        [right, back.cross(right), back]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_is_asked_for_makes_an_eye_that_cannot_see() {
        for x in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0] {
            let eye = Orbit::new([x; 3], [x; 2], x, x);
            let eye = eye.turned([x; 2]).zoomed(x).panned([x; 2]);
            assert!(eye.position().iter().all(|c| c.is_finite()), "{x}: {eye:?}");
        }
    }
}
