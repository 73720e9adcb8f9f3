//! The choices that a clipper makes, and that are easily got wrong.

/// What may be got wrong. The values given here are right; [`super::super::polygon::faulty`] has the others. Known at compile
/// time, so that the right clipper pays nothing for them.
pub trait Rules: Copy {
    /// Is a vertex on the border inside?
    const BORDER_IS_INSIDE: bool = true;
    /// Is the edge from the last vertex to the first one clipped too?
    const CLOSES: bool = true;
    /// How many times a crossing is put out.
    const COPIES: usize = 1;
    /// Does P come before the crossing where an edge comes in?
    const END_FIRST: bool = false;
    /// Are the clip edges walked clockwise, with the inside still to their left?
    const CLOCKWISE: bool = false;
}

/// As Sutherland and Hodgman have it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Right;

impl Rules for Right {}
