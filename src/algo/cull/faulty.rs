//! **Wrong on purpose.** Culling with one mistake each, as they are found in lecture notes, tutorials and programs that students
//! hand in. They run through the very same tests with one choice changed ([`CullRules`] says which can be), so that the first
//! differing step is the first differing event. Only the lab's "what is wrong here?" knows this room.

use super::CullRules;

/// Erratum E7 of S3: the field of view from bottom to top is taken for that from left to right, too. In a wide window what stands
/// at the sides vanishes although it is to be seen.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OneAngle;

impl CullRules for OneAngle {
    const ONE_ANGLE: bool = true;
}

/// Erratum E11 of S0, answered wrongly: normals point inside, and what lies on that side is taken for outside.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TurnsSign;

impl CullRules for TurnsSign {
    const TURNS_SIGN: bool = true;
}

/// The radius is measured from the centroid, and the sphere then put around the origin: of a mesh that was not modelled around
/// its origin a part stands out of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AroundOrigin;

impl CullRules for AroundOrigin {
    const AROUND_ORIGIN: bool = true;
}

/// Corners are taken to run clockwise: every normal points inside, fronts are culled and backs drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Clockwise;

impl CullRules for Clockwise {
    const CLOCKWISE: bool = true;
}

/// Erratum E9 of S2: one direction of sight for all faces, which in perspective judges faces near the outline wrongly.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ConstantView;

impl CullRules for ConstantView {
    const CONSTANT_VIEW: bool = true;
}
