//! The choices that clipping triangles in space makes, and that are easily got wrong.

use crate::algo::ring::{Right, Rules};

/// What may be got wrong besides what any clipper of rings may. The values given here are right; [`super::faulty`] has the others.
/// Known at compile time, so that the right clippers pay nothing for them.
pub trait VolumeRules: Rules + 'static {
    /// Is a triangle cut whose first vertex lies on the plane?
    const CUTS_FROM_PLANE: bool = true;
    /// Does a crossing get its own place in the texture, and not that of the end it stands for?
    const MIXES_UV: bool = true;
    /// Are the three edges clipped each by itself, and not the ring that they make?
    const EDGE_BY_EDGE: bool = false;
    /// Do outcodes say which sides there are to clip by?
    const ASKS_CODES: bool = true;
    /// Are the vertices divided by w before they are clipped?
    const DIVIDES_FIRST: bool = false;
}

impl VolumeRules for Right {}
