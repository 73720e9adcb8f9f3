//! Why numbers make nothing in space.

use std::fmt;

/// Why a plane, a box, a sphere, a matrix or a camera was refused. `Display` is for logs; people read the sentence of
/// [`Diagnostic`](crate::text::Diagnostic).
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
            Self::ZeroNormal
            | Self::NegativeRadius(_)
            | Self::NoVertices
            | Self::TargetAtPosition
            | Self::UpAlongView
            | Self::FieldOfView(_)
            | Self::Size(_)
            | Self::Height(_)
            | Self::Aspect(_)
            | Self::Near(_)
            | Self::Far { .. }
            | Self::NotAffine => "degenerate",
        }
    }
}

impl SpaceError {
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
            Self::NotFinite { .. }
            | Self::EmptyBox { .. }
            | Self::ZeroNormal
            | Self::NegativeRadius(_)
            | Self::NoVertices
            | Self::Size(_)
            | Self::NotAffine => return None,
        })
    }
}

impl fmt::Display for SpaceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for SpaceError {}

/// Refuses the first number that is not finite.
pub(super) fn finite(numbers: &[f64]) -> Result<(), SpaceError> {
    match numbers.iter().position(|x| !x.is_finite()) {
        Some(index) => Err(SpaceError::NotFinite {
            index,
            value: numbers[index],
        }),
        None => Ok(()),
    }
}
