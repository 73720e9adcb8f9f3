//! The choices that culling makes, and that are easily got wrong.

use crate::algo::ring::Right;

/// What may be got wrong. The values given here are right; [`super::faulty`] has the others. Known at compile time, so that the
/// right tests pay nothing for them.
pub trait CullRules: Copy + 'static {
    /// Is the one angle of the field of view taken for width and height alike?
    const ONE_ANGLE: bool = false;
    /// Is a sphere beyond a plane taken for one on the inner side of it?
    const TURNS_SIGN: bool = false;
    /// Does the sphere stand around the object's origin, with the radius that it has around the centroid?
    const AROUND_ORIGIN: bool = false;
    /// Are corners taken to run clockwise as seen from outside?
    const CLOCKWISE: bool = false;
    /// Is the way to the viewer the same for all faces, whatever the projection?
    const CONSTANT_VIEW: bool = false;
}

impl CullRules for Right {}
