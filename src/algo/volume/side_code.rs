//! Outcodes in space: one bit for each side of the clip volume that a point lies beyond.

use crate::{
    algo::segment::Code,
    geom::{AlignedBox, VolumeSide},
    trace::Real,
};

/// Six bits, written far, near, top, bottom, right, left: the last four are those of the plane.
pub type SideCode = Code<6>;

impl SideCode {
    /// As they are written, from the first digit to the last.
    pub const WRITTEN: [VolumeSide; 6] = [
        VolumeSide::Far,
        VolumeSide::Near,
        VolumeSide::Top,
        VolumeSide::Bottom,
        VolumeSide::Right,
        VolumeSide::Left,
    ];

    const fn bit(side: VolumeSide) -> u8 {
        match side {
            VolumeSide::Left => 1,
            VolumeSide::Right => 2,
            VolumeSide::Bottom => 4,
            VolumeSide::Top => 8,
            VolumeSide::Near => 16,
            VolumeSide::Far => 32,
        }
    }

    /// Of a point in clip space: beyond a side where −w ≤ x, y, z ≤ w fails. Six comparisons and no branch.
    #[inline]
    #[must_use]
    pub fn of<R: Real>([x, y, z, w]: [R; 4]) -> Self {
        let beyond = |low: bool, high: bool| u8::from(low) | u8::from(high) << 1;
        let [across, up, deep] = [x, y, z].map(|a| beyond(a < -w, a > w));
        Self(across | up << 2 | deep << 4)
    }

    /// Of a point in space: beyond a face of the box. Six comparisons and no branch.
    #[inline]
    #[must_use]
    pub fn of_box<R: Real>(at: [R; 3], bounds: &AlignedBox) -> Self {
        let beyond = |axis: usize| {
            let [low, high] = [bounds.min()[axis], bounds.max()[axis]].map(R::new);
            u8::from(at[axis] < low) | u8::from(at[axis] > high) << 1
        };
        Self(beyond(0) | beyond(1) << 2 | beyond(2) << 4)
    }

    /// The side of the lowest bit that is set; `None` for 000000.
    #[inline]
    #[must_use]
    pub fn lowest(self) -> Option<VolumeSide> {
        let mut from_lowest = Self::WRITTEN.into_iter().rev();
        from_lowest.find(|&side| self.has(side))
    }

    /// The sides whose bits are set, as they are written.
    pub fn sides(self) -> impl Iterator<Item = VolumeSide> {
        let is_set = move |&side: &VolumeSide| self.has(side);
        Self::WRITTEN.into_iter().filter(is_set)
    }

    /// Is the point beyond this side?
    #[inline]
    #[must_use]
    pub const fn has(self, side: VolumeSide) -> bool {
        self.0 & Self::bit(side) != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twenty_seven_regions_and_their_lowest_bits() {
        let bounds = AlignedBox::new([-1.0, -1.0, -1.0, 1.0, 1.0, 1.0]).unwrap();
        let places = [-2.0, 0.0, 2.0];
        let mut seen = Vec::new();
        for z in places {
            for y in places {
                for x in places {
                    let code = SideCode::of_box([x, y, z], &bounds);
                    assert_eq!(code, SideCode::of([x, y, z, 1.0]), "({x}, {y}, {z})");
                    let lowest = code.sides().last();
                    assert_eq!(code.lowest(), lowest, "{code}");
                    seen.push(code.to_string());
                }
            }
        }
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen.len(), 27);
        assert_eq!(seen[0], "000000");
    }

    #[test]
    fn digits_from_far_to_left() {
        let cases = [
            ([0.0, 0.0, 0.0, 1.0], "000000", "in the middle"),
            ([-2.0, 0.0, 0.0, 1.0], "000001", "on the left"),
            ([2.0, 3.0, 0.0, 1.0], "001010", "top right"),
            ([0.0, -1.5, 4.0, 1.0], "100100", "far below"),
            ([1.0, 1.0, -1.0, 1.0], "000000", "closed"),
            ([0.0, 0.0, 0.0, -1.0], "111111", "behind the eye"),
            ([0.0; 4], "000000", "no point"),
        ];
        for (at, expected, what) in cases {
            assert_eq!(SideCode::of(at).to_string(), expected, "{what}");
        }
    }
}
