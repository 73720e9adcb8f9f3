//! A box along the axes.

use serde::Serialize;

use super::{SpaceError, error::finite};

/// One of the six sides of a view volume, of the clip volume −w ≤ x, y, z ≤ w, and of a box.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Hash, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum VolumeSide {
    /// Before the eye; z = −w.
    Near,
    /// Farthest from it; z = w.
    Far,
    /// x = −w
    Left,
    /// x = w
    Right,
    /// y = −w
    Bottom,
    /// y = w
    Top,
}

impl VolumeSide {
    /// All six, in the order in which everything here asks them.
    pub const ALL: [Self; 6] = [
        Self::Near,
        Self::Far,
        Self::Left,
        Self::Right,
        Self::Bottom,
        Self::Top,
    ];

    /// The axis across it: 0 is x.
    #[must_use]
    pub const fn axis(self) -> usize {
        match self {
            Self::Left | Self::Right => 0,
            Self::Bottom | Self::Top => 1,
            Self::Near | Self::Far => 2,
        }
    }

    /// Is it the side of the larger coordinate, in clip space?
    #[must_use]
    pub const fn is_high(self) -> bool {
        matches!(self, Self::Far | Self::Right | Self::Top)
    }
}

/// All points between two corners, both included. It may be flat, an edge or a point.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct AlignedBox {
    min: [f64; 3],
    max: [f64; 3],
}

impl AlignedBox {
    /// `[xmin, ymin, zmin, xmax, ymax, zmax]`.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::EmptyBox`] where a minimum is above its maximum.
    pub fn new(bounds: [f64; 6]) -> Result<Self, SpaceError> {
        finite(&bounds)?;
        let [x, y, z, right, top, front] = bounds;
        let (min, max) = ([x, y, z], [right, top, front]);
        match (0..3).find(|&axis| min[axis] > max[axis]) {
            Some(axis) => Err(SpaceError::EmptyBox {
                axis,
                min: min[axis],
                max: max[axis],
            }),
            None => Ok(Self { min, max }),
        }
    }

    /// The smallest one around some points.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`]; [`SpaceError::NoVertices`].
    pub fn around(points: impl IntoIterator<Item = [f64; 3]>) -> Result<Self, SpaceError> {
        let mut bounds: Option<Self> = None;
        for (i, at) in points.into_iter().enumerate() {
            if let Some(axis) = at.iter().position(|x| !x.is_finite()) {
                let (index, value) = (3 * i + axis, at[axis]);
                return Err(SpaceError::NotFinite { index, value });
            }
            let bounds = bounds.get_or_insert(Self { min: at, max: at });
            for (axis, x) in at.into_iter().enumerate() {
                bounds.min[axis] = bounds.min[axis].min(x);
                bounds.max[axis] = bounds.max[axis].max(x);
            }
        }
        bounds.ok_or(SpaceError::NoVertices)
    }

    /// The lowest corner.
    #[must_use]
    pub const fn min(&self) -> [f64; 3] {
        self.min
    }

    /// The highest corner.
    #[must_use]
    pub const fn max(&self) -> [f64; 3] {
        self.max
    }

    /// The coordinate of a face, along the axis across it. Near is the lowest z.
    #[must_use]
    pub const fn border(&self, side: VolumeSide) -> f64 {
        let corner = if side.is_high() { self.max } else { self.min };
        corner[side.axis()]
    }

    /// All twelve, by their ends: corners whose numbers differ in one bit.
    pub fn edges(&self) -> impl Iterator<Item = [[f64; 3]; 2]> + use<> {
        let corners = self.corners();
        (0..8_usize).flat_map(move |i| {
            let others = [1, 2, 4].into_iter().filter(move |bit| i & bit == 0);
            others.map(move |bit| [corners[i], corners[i | bit]])
        })
    }

    /// All eight: bit 0 of a corner's number says right rather than left, bit 1 top, bit 2 the higher z.
    #[must_use]
    pub fn corners(&self) -> [[f64; 3]; 8] {
        std::array::from_fn(|i| {
            let is_high = |axis: usize| i >> axis & 1 == 1;
            [0, 1, 2].map(|axis| if is_high(axis) { self.max } else { self.min }[axis])
        })
    }
}
