//! The choice that clipping a line before the divide makes, and that is easily got wrong.

use crate::algo::ring::Right;

/// What may be got wrong. The value given here is right; [`crate::algo::volume::faulty`] has the other. Known at compile time.
pub trait LineRules: Copy + 'static {
    /// Are both ends divided by w before anything is clipped?
    const DIVIDES_FIRST: bool = false;
}

impl LineRules for Right {}
