//! What Weiler–Atherton is given, and which of the two polygons something belongs to.

use serde::Serialize;

use crate::geom::{Region, SimplePolygon};

/// What to clip, and against what.
#[derive(Clone, PartialEq, Debug)]
pub struct WeilerAthertonInput {
    /// With its holes.
    pub subject: Region,
    /// A window or a convex polygon will do.
    pub clip: SimplePolygon,
}

/// One of the two lists, and the polygon that it belongs to.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum List {
    /// The polygon that is clipped.
    Subject,
    /// The polygon that it is clipped against.
    Clip,
}

impl List {
    /// Place in a pair that belongs to both.
    #[must_use]
    pub const fn idx(self) -> usize {
        self as usize
    }

    /// The other one.
    #[must_use]
    pub const fn other(self) -> Self {
        match self {
            Self::Subject => Self::Clip,
            Self::Clip => Self::Subject,
        }
    }
}
