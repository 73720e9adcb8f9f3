//! Where the two borders run at an intersection, and what that makes of it.

use serde::Serialize;

/// Where an edge runs, by the other polygon, close to an intersection.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// Through the interior.
    Inside,
    /// Through the outside.
    Outside,
    /// Along the other border in the same direction.
    Along,
    /// Along the other border in the opposite direction.
    Against,
}

/// What happens to the walk at an intersection.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum IntersectionLabel {
    /// The subject goes from outside to inside: from here the result follows the subject.
    Entering,
    /// The subject goes from inside to outside: from here the result follows the clip polygon.
    Leaving,
    /// The subject stays inside, or outside: the walk goes on in its list.
    Touching,
    /// Both borders pass inside the other and touch: the walk changes lists, so that each of the two pieces keeps to its own.
    Pinching,
}

/// An intersection's label and what it comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Labelled {
    /// For the walk.
    pub label: IntersectionLabel,
    /// The subject's edges before and after.
    pub subject: [Side; 2],
    /// The clip polygon's edges before and after.
    pub clip: [Side; 2],
}

impl Labelled {
    /// Does the subject run along an edge of the clip polygon here, in the same direction?
    #[must_use]
    pub fn shares_an_edge(&self) -> bool {
        self.subject.contains(&Side::Along)
    }
}

/// Of the subject's edges. Of the clip polygon's only those inside do.
pub const fn bounds_the_result(side: Side) -> bool {
    matches!(side, Side::Inside | Side::Along)
}
