//! **Wrong on purpose.** Visible surfaces with one mistake each, as they are found in programs that students hand in: to be stepped
//! beside the right one, on the student's own scene.
//!
//! They run through the very same loops with one choice changed ([`SurfaceRules`] says which can be), and report the same events, so
//! that the first differing step is the first differing event. Only the lab's "what is wrong here?" knows this room.

use super::{DepthBuffer, Painter, SurfaceRules};

/// The buffer is cleared to the depth of the near plane: nothing is ever nearer, and the picture stays empty.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ClearsToNear;

impl SurfaceRules for ClearsToNear {
    const CLEARS_TO_NEAR: bool = true;
}

/// The comparison is turned: the farther fragment wins, and none is farther than nothing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TurnsComparison;

impl SurfaceRules for TurnsComparison {
    const TURNS_COMPARISON: bool = true;
}

/// Every fragment is written: what was drawn last is seen, the nearest or not.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WritesAlways;

impl SurfaceRules for WritesAlways {
    const COMPARES: bool = false;
}

/// Distances from the eye are interpolated straight across the screen, where they are not linear: surfaces bend.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct StraightDistance;

impl SurfaceRules for StraightDistance {
    const STRAIGHT_DISTANCE: bool = true;
}

/// The list is painted as it is sorted, though no key of one number tells which of two triangles hides the other.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct KeysOnly;

impl SurfaceRules for KeysOnly {
    const KEYS_ONLY: bool = true;
}

/// The same, sorted by the nearest vertex: a floor that begins before the feet of what stands on it is painted over it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct NearestKeys;

impl SurfaceRules for NearestKeys {
    const SORTS_BY_NEAREST: bool = true;
    const KEYS_ONLY: bool = true;
}

/// The depth buffer with the mistake `L`.
pub type FaultyDepthBuffer<L> = DepthBuffer<L>;

/// The painter with the mistake `L`.
pub type FaultyPainter<L> = Painter<L>;
