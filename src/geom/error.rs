//! Why a primitive was refused.

use std::fmt;

/// One of the two coordinate axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    /// Horizontal.
    X,
    /// Vertical, pointing up.
    Y,
}

/// Why numbers do not make a primitive. `Display` is for logs; people read the sentence of
/// [`Diagnostic`](crate::text::Diagnostic).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum GeomError {
    /// A coordinate is NaN or infinite; `index` counts the numbers in the order in which they were given.
    NotFinite {
        /// Position of the number in the flat list of coordinates.
        index: usize,
        /// The number itself.
        value: f64,
    },
    /// A window whose minimum is not below its maximum.
    EmptyWindow {
        /// The axis on which it is empty.
        axis: Axis,
        /// Given minimum.
        min: f64,
        /// Given maximum.
        max: f64,
    },
    /// Fewer than three vertices.
    TooFewVertices,
    /// A repeated vertex, or no area.
    Degenerate {
        /// The vertex at which it shows.
        vertex_idx: usize,
    },
    /// The outline turns both ways at this vertex.
    NotConvex {
        /// The vertex at which it turns the wrong way.
        vertex_idx: usize,
    },
    /// Every turn goes the same way, but the outline runs around more than once.
    SelfIntersecting {
        /// A vertex of the second round.
        vertex_idx: usize,
    },
    /// Two edges of one outline cross, touch or overlap, other than two neighbours in the vertex that they
    /// share.
    EdgesMeet {
        /// The edges, the lower number first; edge `i` runs from the given vertex `i` to the next.
        edges: [usize; 2],
    },
    /// A hole that does not lie inside the outline, clear of its edges and of every other hole.
    MisplacedHole {
        /// The hole.
        hole_idx: usize,
    },
}

impl GeomError {
    /// The stable code of `interfaces.md`.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "not-finite",
            Self::EmptyWindow { .. } => "empty-window",
            Self::TooFewVertices | Self::Degenerate { .. } => "degenerate",
            Self::NotConvex { .. } => "not-convex",
            Self::SelfIntersecting { .. } | Self::EdgesMeet { .. } | Self::MisplacedHole { .. } => {
                "self-intersecting"
            }
        }
    }
}

impl fmt::Display for GeomError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {self:?}", self.code())
    }
}

impl std::error::Error for GeomError {}
