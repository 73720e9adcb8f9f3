//! What a drawing is seen through: how places in the world and on it belong together.

use glam::DVec3;

use crate::geom::{Camera, Matrix, Orbit, Sight};

use super::space::Seer;

#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Lens {
    /// The drawing is the plane z = 0.
    Plane,
    /// The drawing is what the viewer's eye sees: from −1 at its lower edge to 1 at its upper.
    Eye(Orbit),
    /// The drawing is a camera's picture: y from −1 to 1, x from minus to plus its width over its height.
    Camera(Camera),
}

impl From<Seer> for Lens {
    fn from(seer: Seer) -> Self {
        match seer {
            Seer::Eye(eye) | Seer::Apart(eye) => Self::Eye(eye),
            Seer::Camera(camera) => Self::Camera(camera),
        }
    }
}

impl Lens {
    pub fn drawing_from_world(&self, at: [f64; 3]) -> Option<[f64; 2]> {
        let Some(optics) = Optics::of(self) else {
            return Some([at[0], at[1]]);
        };
        optics.seen(at.into())
    }

    pub fn world_from_drawing(&self, at: [f64; 2], beside: [f64; 3]) -> [f64; 3] {
        let Some(optics) = Optics::of(self) else {
            return [at[0], at[1], 0.0];
        };
        let depth = optics.view_from_world(beside.into()).z;
        optics
            .world_from_view(optics.view_from_picture(at, depth))
            .into()
    }

    /// How long in the world is, at the depth of a place there, what is 1 long on the drawing.
    pub fn unit_at(&self, at: [f64; 3]) -> f64 {
        Optics::of(self).map_or(1.0, |optics| {
            optics.half_height_at(optics.view_from_world(at.into()).z)
        })
    }

    /// Moved away from the eye on its sight line, as far as `by` is on the drawing at its depth.
    pub fn deeper(&self, at: [f64; 3], by: f64) -> [f64; 3] {
        let Some(optics) = Optics::of(self).filter(|_| by != 0.0) else {
            return at;
        };
        let view = optics.view_from_world(at.into());
        let away = -optics.toward_eye(view).normalize_or_zero();
        let moved = view + away * (by * optics.half_height_at(view.z));
        optics.world_from_view(moved).into()
    }

    /// Width over height of what has to be seen, of a camera all that is seen.
    pub fn least_aspect(&self) -> f64 {
        match self {
            Self::Plane => 1.0,
            Self::Eye(eye) => eye.aspect(),
            Self::Camera(_) => self.aspect().unwrap_or(1.0),
        }
    }

    pub fn aspect(&self) -> Option<f64> {
        match self {
            Self::Plane | Self::Eye(_) => None,
            Self::Camera(camera) => {
                let [width, height] = camera.volume().half_size();
                Some(width / height)
            }
        }
    }
}

/// An eye or a camera, ready to be asked for many points. Its own axes: x to the right, y up, what is seen at negative z.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Optics {
    axes: [DVec3; 3],
    position: DVec3,
    sight: Sight,
    half_height: f64,
    pub near: f64,
    pub far: f64,
}

impl Optics {
    pub fn of(lens: &Lens) -> Option<Self> {
        Some(match lens {
            Lens::Plane => return None,
            Lens::Eye(eye) => Self {
                axes: eye.axes().map(DVec3::from),
                position: eye.position().into(),
                sight: Sight::Perspective,
                half_height: eye.half_height(),
                near: eye.near(),
                far: f64::INFINITY,
            },
            Lens::Camera(camera) => Self {
                axes: camera.axes().map(DVec3::from),
                position: camera.position().into(),
                sight: camera.volume().sight(),
                half_height: camera.volume().half_size()[1],
                near: camera.volume().near(),
                far: camera.volume().far(),
            },
        })
    }

    pub fn view_from_world(&self, at: DVec3) -> DVec3 {
        let from_eye = at - self.position;
        self.axes.map(|axis| axis.dot(from_eye)).into()
    }

    /// On the picture; none where it is not before the eye.
    pub fn seen(&self, at: DVec3) -> Option<[f64; 2]> {
        let view = self.view_from_world(at);
        (view.z < -self.near).then(|| self.picture_from_view(view))
    }

    pub fn all_from_world(&self, places: &[[f64; 3]]) -> Vec<DVec3> {
        let places = places.iter();
        places.map(|&at| self.view_from_world(at.into())).collect()
    }

    pub fn world_from_view(&self, at: DVec3) -> DVec3 {
        let [right, up, back] = self.axes;
        self.position + right * at.x + up * at.y + back * at.z
    }

    pub fn picture_from_view(&self, at: DVec3) -> [f64; 2] {
        let scale = self.half_height_at(at.z);
        [at.x / scale, at.y / scale]
    }

    pub fn view_from_picture(&self, [x, y]: [f64; 2], z: f64) -> DVec3 {
        let scale = self.half_height_at(z);
        DVec3::new(x * scale, y * scale, z)
    }

    pub fn toward_eye(&self, at: DVec3) -> DVec3 {
        match self.sight {
            Sight::Perspective => -at,
            Sight::Parallel => DVec3::Z,
        }
    }

    /// The sight line that meets the picture in a place: a point on it, and its direction away from the eye.
    pub fn sight_line(&self, at: [f64; 2]) -> (DVec3, DVec3) {
        match self.sight {
            Sight::Perspective => (DVec3::ZERO, self.view_from_picture(at, -1.0)),
            Sight::Parallel => (self.view_from_picture(at, 0.0), DVec3::NEG_Z),
        }
    }

    /// To clip space, for the part of the picture from `min` to `max`, and for depths between two distances.
    pub fn clip_from_world(
        &self,
        [min, max]: [[f64; 2]; 2],
        [near, far]: [f64; 2],
    ) -> Option<Matrix> {
        let depth = far - near;
        let axis = |i: usize| {
            let scale = 2.0 / (max[i] - min[i]);
            (scale / self.half_height, -scale * min[i].midpoint(max[i]))
        };
        let [(x, x0), (y, y0)] = [axis(0), axis(1)];
        let rows = match self.sight {
            Sight::Perspective => [
                [x, 0.0, -x0, 0.0],
                [0.0, y, -y0, 0.0],
                [0.0, 0.0, -(far + near) / depth, -2.0 * far * near / depth],
                [0.0, 0.0, -1.0, 0.0],
            ],
            Sight::Parallel => [
                [x, 0.0, 0.0, x0],
                [0.0, y, 0.0, y0],
                [0.0, 0.0, -2.0 / depth, -(far + near) / depth],
                [0.0, 0.0, 0.0, 1.0],
            ],
        };
        let row = |axis: DVec3| [axis.x, axis.y, axis.z, -axis.dot(self.position)];
        let [right, up, back] = self.axes.map(row);
        let view_from_world = Matrix::new([right, up, back, [0.0, 0.0, 0.0, 1.0]]).ok()?;
        Some(Matrix::new(rows).ok()?.after(&view_from_world))
    }

    pub fn is_parallel(&self) -> bool {
        self.sight == Sight::Parallel
    }

    /// Half of the picture's height at this depth, in the world.
    pub fn half_height_at(&self, z: f64) -> f64 {
        match self.sight {
            Sight::Perspective => -z * self.half_height,
            Sight::Parallel => self.half_height,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn eyes() -> impl Iterator<Item = Orbit> {
        let angles = [[0.0, 0.0], [30.0, 20.0], [-135.0, -80.0], [400.0, 95.0]];
        let eye = |angles| Orbit::new([1.0, -2.0, 3.0], angles, 7.0, 24.0);
        angles.into_iter().map(eye)
    }

    fn seen(eye: Orbit, at: [f64; 3]) -> [f64; 2] {
        let seen = Lens::Eye(eye).drawing_from_world(at);
        seen.expect("before the eye")
    }

    #[test]
    fn an_eye_looks_along_its_own_z_axis_backwards() {
        let eye = Orbit::new([0.0; 3], [0.0, 0.0], 5.0, 30.0);
        let optics = Optics::of(&Lens::Eye(eye)).expect("an eye");
        let view = optics.view_from_world(DVec3::new(1.0, 2.0, 0.0));
        assert_eq!(view, DVec3::new(1.0, 2.0, -5.0));
    }

    #[test]
    fn world_and_picture_lead_back_to_each_other() {
        let at = [0.5, -1.0, 2.5];
        for eye in eyes() {
            let optics = Optics::of(&Lens::Eye(eye)).expect("an eye");
            let view = optics.view_from_world(at.into());
            let back = optics.world_from_view(view);
            let again = optics.view_from_picture(optics.picture_from_view(view), view.z);
            for i in 0..3 {
                assert!((back[i] - at[i]).abs() < 1e-12, "{eye:?}: {back:?}");
                assert!((again[i] - view[i]).abs() < 1e-12, "{eye:?}: {again:?}");
            }
        }
    }

    #[test]
    fn the_target_is_in_the_middle_and_goes_the_other_way_by_as_much_as_the_eye_is_moved() {
        for eye in eyes() {
            let [middle, above] = [-2.0, -1.0].map(|y| seen(eye, [1.0, y, 3.0]));
            assert!(middle.iter().all(|x| x.abs() < 1e-12), "{eye:?}");
            assert!(above[1] > middle[1], "{eye:?}: {above:?}: up is up");
            let moved = eye.panned([0.25, -0.5]);
            let at = seen(moved, [1.0, -2.0, 3.0]);
            let off = [at[0] + 0.25, at[1] - 0.5];
            assert!(off.iter().all(|x| x.abs() < 1e-12), "{eye:?}: {at:?}");
        }
    }
}
