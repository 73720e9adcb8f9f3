//! Outcodes: one bit for each side of the window that a point lies beyond.

use std::ops::{BitAnd, BitOr};

use serde::{Deserialize, Serialize, Serializer};

use crate::{
    geom::{Edge, Point, Window},
    trace::Real,
};

/// The order in which the bits of a code are written. The lowest bit, written last, is tested first.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum BitOrder {
    /// Top, bottom, right, left: Newman and Sproull, Foley and van Dam.
    #[default]
    Tbrl,
    /// Left, right, bottom, top: common in course notes.
    Lrbt,
}

impl BitOrder {
    /// Sides as they are written, from the first digit to the last.
    #[must_use]
    pub const fn written(self) -> [Edge; 4] {
        match self {
            Self::Tbrl => [Edge::Top, Edge::Bottom, Edge::Right, Edge::Left],
            Self::Lrbt => [Edge::Left, Edge::Right, Edge::Bottom, Edge::Top],
        }
    }

    /// The bit that stands for a side.
    #[inline]
    const fn bit(self, edge: Edge) -> u8 {
        let k = match edge {
            Edge::Left => 0,
            Edge::Right => 1,
            Edge::Bottom => 2,
            Edge::Top => 3,
        };
        match self {
            Self::Tbrl => 1 << k,
            Self::Lrbt => 8 >> k,
        }
    }
}

/// Four bits, in the order of a [`BitOrder`]. Written as its four binary digits.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Outcode(u8);

impl Outcode {
    /// The code of a point. A point on a border is inside it. Four comparisons and no branch.
    #[inline]
    pub fn of<R: Real>([x, y]: [R; 2], window: &Window, order: BitOrder) -> Self {
        let border = |edge: Edge| R::new(window.border(edge));
        let [left, right, bottom, top] = [
            x < border(Edge::Left),
            x > border(Edge::Right),
            y < border(Edge::Bottom),
            y > border(Edge::Top),
        ]
        .map(u8::from);
        Self(match order {
            BitOrder::Tbrl => top << 3 | bottom << 2 | right << 1 | left,
            BitOrder::Lrbt => left << 3 | right << 2 | bottom << 1 | top,
        })
    }

    /// The code of a point, uncounted: for labels of regions and for tests.
    #[must_use]
    pub fn of_point(point: Point, window: &Window, order: BitOrder) -> Self {
        Self::of::<f64>(point.to_array(), window, order)
    }

    /// The code with exactly these sides set.
    #[must_use]
    pub fn from_edges(edges: &[Edge], order: BitOrder) -> Self {
        Self(edges.iter().fold(0, |code, &e| code | order.bit(e)))
    }

    /// Bitwise OR.
    #[inline]
    #[must_use]
    pub const fn or(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Bitwise AND.
    #[inline]
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// 0000: inside every border.
    #[inline]
    #[must_use]
    pub const fn is_inside(self) -> bool {
        self.0 == 0
    }

    /// Is the point beyond this side?
    #[inline]
    #[must_use]
    pub const fn has(self, edge: Edge, order: BitOrder) -> bool {
        self.0 & order.bit(edge) != 0
    }

    /// The side of the lowest bit that is set; `None` for 0000.
    #[inline]
    #[must_use]
    pub const fn lowest(self, order: BitOrder) -> Option<Edge> {
        if self.is_inside() {
            return None;
        }
        let k = self.0.trailing_zeros();
        let k = match order {
            BitOrder::Tbrl => k,
            BitOrder::Lrbt => 3 - k,
        };
        Some(match k {
            0 => Edge::Left,
            1 => Edge::Right,
            2 => Edge::Bottom,
            _ => Edge::Top,
        })
    }

    /// The sides that are set, in written order.
    pub fn edges(self, order: BitOrder) -> impl Iterator<Item = Edge> {
        order
            .written()
            .into_iter()
            .filter(move |&edge| self.has(edge, order))
    }
}

impl BitOr for Outcode {
    type Output = Self;

    #[inline]
    fn bitor(self, other: Self) -> Self {
        self.or(other)
    }
}

impl BitAnd for Outcode {
    type Output = Self;

    #[inline]
    fn bitand(self, other: Self) -> Self {
        self.and(other)
    }
}

impl std::fmt::Display for Outcode {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:04b}", self.0)
    }
}

impl Serialize for Outcode {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nine_regions_in_both_orders() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
        let rows = [
            (2.0, ["1001", "1000", "1010"], ["1001", "0001", "0101"]),
            (0.0, ["0001", "0000", "0010"], ["1000", "0000", "0100"]),
            (-2.0, ["0101", "0100", "0110"], ["1010", "0010", "0110"]),
        ];
        for (y, tbrl, lrbt) in rows {
            for (i, x) in [-2.0, 0.0, 2.0].into_iter().enumerate() {
                let p = Point::new(x, y).unwrap();
                for (order, expected) in [(BitOrder::Tbrl, tbrl[i]), (BitOrder::Lrbt, lrbt[i])] {
                    let code = Outcode::of_point(p, &window, order);
                    assert_eq!(code.to_string(), expected, "({x}, {y}) in {order:?}");
                }
            }
        }
    }

    #[test]
    fn borders_and_corners_are_inside() {
        let window = Window::new(-1.0, -1.0, 1.0, 1.0).unwrap();
        for corner in window.corners() {
            assert!(Outcode::of_point(corner, &window, BitOrder::Tbrl).is_inside());
        }
    }

    #[test]
    fn the_lowest_bit_is_the_last_written() {
        for order in [BitOrder::Tbrl, BitOrder::Lrbt] {
            for edge in Edge::ALL {
                let code = Outcode::from_edges(&[edge], order);
                assert_eq!(code.lowest(order), Some(edge));
                assert_eq!(code.edges(order).collect::<Vec<_>>(), [edge]);
            }
            let all = Outcode::from_edges(&Edge::ALL, order);
            assert_eq!(all.lowest(order), Some(order.written()[3]));
            assert_eq!(Outcode::default().lowest(order), None);
        }
    }
}
