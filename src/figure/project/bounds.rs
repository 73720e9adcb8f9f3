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

    /// Has it a place in common with the line through these two? Where rounding leaves that open, it has.
    pub fn meets_line(&self, [a, b]: [[f64; 2]; 2]) -> bool {
        let along = [b[0] - a[0], b[1] - a[1]];
        let half = |i: usize| 0.5 * (self.max[i] - self.min[i]);
        let middle = |i: usize| 0.5 * (self.max[i] + self.min[i]) - a[i];
        let beside = (along[0] * middle(1) - along[1] * middle(0)).abs();
        let reach = along[0].abs() * half(1) + along[1].abs() * half(0);
        let size = along[0].abs() * middle(1).abs() + along[1].abs() * middle(0).abs();
        beside <= reach + 1e-9 * (reach + size)
    }

    /// Have they a place in common?
    pub fn meets(&self, other: &Self) -> bool {
        (0..2).all(|i| self.min[i] <= other.max[i] && other.min[i] <= self.max[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_meets_a_box_or_passes_beside_it() {
        let unit = Bounds::around([[1.0, 1.0], [2.0, 3.0]]);
        for (line, meets) in [
            ([[0.0, 0.0], [4.0, 4.0]], true),
            ([[0.0, 0.0], [4.0, 1.0]], false),
            // It goes through a corner, or along a side.
            ([[0.0, 0.0], [4.0, 2.0]], true),
            ([[2.0, -7.0], [2.0, -5.0]], true),
            ([[2.5, -7.0], [2.5, -5.0]], false),
            // A point, of which no line is known.
            ([[9.0, 9.0], [9.0, 9.0]], true),
        ] {
            assert_eq!(unit.meets_line(line), meets, "{line:?}");
        }
        assert!(!Bounds::NOWHERE.meets_line([[0.0, 0.0], [1.0, 1.0]]));
    }
}
