//! What became of a face, and where in a run that was decided.

use crate::geom::VolumeSide;

/// What was asked of a face when its fate was decided.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FaceTest {
    /// The sphere of its object, which was culled whole.
    Sphere,
    /// Its corners: all of them lie beyond this plane.
    Corners(VolumeSide),
    /// Its corners: it crosses planes, and nothing of it was left when they had cut it.
    Cut,
    /// Which side it shows.
    Facing,
}

/// The step that decided a face's fate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct FaceFate {
    /// Where in the run.
    pub step: usize,
    /// What was asked there.
    pub test: FaceTest,
}
