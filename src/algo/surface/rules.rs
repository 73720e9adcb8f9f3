//! The choices that visible surfaces are found by, and that are easily got wrong.

use crate::algo::ring::Right;

/// What may be got wrong, known at compile time. The values given here are right; [`super::faulty`] has the others.
pub trait SurfaceRules: Copy + 'static {
    /// Is the depth buffer cleared to the near plane's depth, and not to nothing at all?
    const CLEARS_TO_NEAR: bool = false;
    /// Does the farther fragment win?
    const TURNS_COMPARISON: bool = false;
    /// Is a fragment compared before it is written?
    const COMPARES: bool = true;
    /// Is the distance in view space interpolated straight across the screen, and not the depth after the divide?
    const STRAIGHT_DISTANCE: bool = false;
    /// Are triangles sorted by their nearest vertex, and not by the farthest?
    const SORTS_BY_NEAREST: bool = false;
    /// Is the sorted list painted as it is, without asking which triangle hides which?
    const KEYS_ONLY: bool = false;
}

impl SurfaceRules for Right {}
