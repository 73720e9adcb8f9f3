//! **Wrong on purpose.** Clipping a line in clip space with a mistake that is found in course notes, to be stepped beside the
//! right one, on the student's own scene.
//!
//! It runs through the very same inequalities with one choice changed ([`LineRules`] says which), and reports the same events,
//! so that the first differing step is the first differing event. Only the lab's "what is wrong here?" knows this room.

use super::{ClipSpace, LineClip, LineRules};

/// Erratum E10 of S4: both ends are divided by w first, and then clipped against −1 ≤ x, y, z ≤ 1. A point behind the eye lands
/// on the screen's other side, or right in the cube, and the segment to its image is a piece that was never there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DividesFirst;

impl LineRules for DividesFirst {
    const DIVIDES_FIRST: bool = true;
}

/// The line that is divided before it is clipped.
pub type DividedLine = LineClip<4, ClipSpace, DividesFirst>;
