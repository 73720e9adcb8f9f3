//! **Wrong on purpose.** Clipping lines and triangles in space with one mistake each, as they are found in lecture notes,
//! tutorials and programs that students hand in. They run through the very same algorithms with one choice changed
//! ([`LineRules`], [`VolumeRules`] and [`Rules`] say which can be), so that the first differing step is the first differing
//! event. Only "what is wrong here?" knows this room.

use crate::algo::ring::Rules;

use super::{ClipSpace, LineClip, LineRules, VolumeRules};

/// Erratum E5 of S0: a triangle is split where p₀·p₁ < 0 or p₀·p₂ < 0. With p₀ = 0 neither holds, and the triangle is kept
/// whole, with the part that sticks out.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct MissesEdge;

impl Rules for MissesEdge {}

impl VolumeRules for MissesEdge {
    const CUTS_FROM_PLANE: bool = false;
}

/// Erratum E6 of S3, in space: "inside" means a distance *greater* than 0, and an edge is cut only where the product of both
/// distances is *less* than 0. A vertex on the plane is neither: it is lost, and nothing stands in for it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DropsOnPlane;

impl Rules for DropsOnPlane {
    const BORDER_IS_INSIDE: bool = false;
}

impl VolumeRules for DropsOnPlane {}

/// A crossing keeps the texture coordinates of the vertex that it stands for: the picture shifts and stretches.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct KeepsPlaceInTexture;

impl Rules for KeepsPlaceInTexture {}

impl VolumeRules for KeepsPlaceInTexture {
    const MIXES_UV: bool = false;
}

/// Erratum E16 of S4: "Cohen–Sutherland for triangles too". The three edges are clipped as lines, and what is left of them is taken
/// for the outline of what is left of the triangle: the volume's own corners, where two planes meet within it, are missing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EdgeByEdge;

impl Rules for EdgeByEdge {
    const CLOSES: bool = false;
}

impl VolumeRules for EdgeByEdge {
    const EDGE_BY_EDGE: bool = true;
}

/// All six sides are asked in a row, also those that no outcode names: the same answer, dearer.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct AllSides;

impl Rules for AllSides {}

impl VolumeRules for AllSides {
    const ASKS_CODES: bool = false;
}

/// Erratum E10 of S4: every vertex is divided by its w first, and then clipped against −1 ≤ x, y, z ≤ 1. A point behind the eye lands
/// on the screen's other side, or right in the cube, and what is drawn to its image was never there.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DividesFirst;

impl Rules for DividesFirst {}

impl VolumeRules for DividesFirst {
    const DIVIDES_FIRST: bool = true;
}

impl LineRules for DividesFirst {
    const DIVIDES_FIRST: bool = true;
}

/// The line that is divided before it is clipped.
pub type DividedLine = LineClip<4, ClipSpace, DividesFirst>;
