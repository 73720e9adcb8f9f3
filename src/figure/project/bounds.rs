//! Boxes on the picture: what does not lie over one another hides nothing of it.

/// The smallest box around some places.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Bounds {
    min: [f64; 2],
    max: [f64; 2],
}

impl Bounds {
    /// Around nothing.
    pub const NOWHERE: Self = Self {
        min: [f64::INFINITY; 2],
        max: [f64::NEG_INFINITY; 2],
    };

    /// Around these places.
    pub fn around(places: impl IntoIterator<Item = [f64; 2]>) -> Self {
        let grown = |of: Self, [x, y]: [f64; 2]| Self {
            min: [of.min[0].min(x), of.min[1].min(y)],
            max: [of.max[0].max(x), of.max[1].max(y)],
        };
        places.into_iter().fold(Self::NOWHERE, grown)
    }

    /// The lowest coordinates and the highest; `None` around nothing.
    pub fn corners(&self) -> Option<[[f64; 2]; 2]> {
        (self.min[0] <= self.max[0]).then_some([self.min, self.max])
    }

    /// Have they a place in common?
    pub fn meets(&self, other: &Self) -> bool {
        (0..2).all(|i| self.min[i] <= other.max[i] && other.min[i] <= self.max[i])
    }
}
