//! Why numbers make no primitive, in the plane and in space.

use std::fmt;

/// One of the two coordinate axes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Axis {
    /// Horizontal.
    X,
    /// Vertical, pointing up.
    Y,
}

/// Why numbers do not make a primitive. `Display` is for logs, people read a `Diagnostic`.
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
    /// Two edges of one outline meet, other than two neighbours in the vertex that they share.
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

/// Why a plane, a box, a sphere, a matrix or a camera was refused. `Display` is for logs, people read a `Diagnostic`.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum SpaceError {
    /// A number is NaN or infinite; `index` counts the numbers in the order in which they were given.
    NotFinite {
        /// Position of the number in the flat list.
        index: usize,
        /// The number itself.
        value: f64,
    },
    /// A box whose minimum is above its maximum.
    EmptyBox {
        /// 0 is x, 1 is y, 2 is z.
        axis: usize,
        /// Given minimum.
        min: f64,
        /// Given maximum.
        max: f64,
    },
    /// A plane without a direction.
    ZeroNormal,
    /// A sphere of this radius.
    NegativeRadius(f64),
    /// A mesh without a vertex has no bounding volume.
    NoVertices,
    /// A camera that looks at where it stands.
    TargetAtPosition,
    /// The way up is zero, or the way that the camera looks.
    UpAlongView,
    /// A field of view, in degrees, that is not between 0 and 180.
    FieldOfView(f64),
    /// Something enlarged by a factor that is not above 0.
    Size(f64),
    /// A parallel volume of no height.
    Height(f64),
    /// A width over height that is not above 0.
    Aspect(f64),
    /// A near plane that is not before the eye.
    Near(f64),
    /// A far plane that is not behind the near one.
    Far {
        /// Given near distance.
        near: f64,
        /// Given far distance.
        far: f64,
    },
    /// The last row of an affine matrix is not 0 0 0 1.
    NotAffine,
}

impl SpaceError {
    /// The stable code of `interfaces.md`.
    #[must_use]
    pub const fn code(self) -> &'static str {
        match self {
            Self::NotFinite { .. } => "not-finite",
            Self::EmptyBox { .. } => "empty-window",
            _ => "degenerate",
        }
    }

    /// The number or the place of a camera that is to blame, as files and cases spell it; none where it is no camera's.
    #[must_use]
    pub const fn camera_field(&self) -> Option<&'static str> {
        Some(match self {
            Self::TargetAtPosition => "target",
            Self::UpAlongView => "up",
            Self::FieldOfView(_) => "fov_y_deg",
            Self::Height(_) => "height",
            Self::Aspect(_) => "aspect",
            Self::Near(_) => "near",
            Self::Far { .. } => "far",
            _ => return None,
        })
    }
}

impl fmt::Display for SpaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for SpaceError {}

pub(super) fn finite(numbers: &[f64]) -> Result<(), SpaceError> {
    match numbers.iter().position(|x| !x.is_finite()) {
        Some(index) => Err(SpaceError::NotFinite {
            index,
            value: numbers[index],
        }),
        None => Ok(()),
    }
}
