//! Cohen–Sutherland: decide by outcodes first, cut only what they leave open ([`CodeClip`]).
//!
//! Crossings are computed from the original ends, so that no rounding piles up, and kept within the part that is left, so that a
//! bit once cleared stays clear. *Degenerate*: a point is accepted or rejected by its codes; a touch is accepted. *Bound*: at
//! most 4 cuts. *Cost*: 8 comparisons for the codes; 4 +, 2 ×, 1 ÷ and 7 comparisons a cut.
//!
//! *Source*: Danny Cohen and Ivan Sutherland, 1967; first printed in W. M. Newman and R. F. Sproull, *Principles of Interactive
//! Computer Graphics*, 1973, pp. 123–124.
//!
//! ```
//! use clipscope::{algo::line::{BitOrder, CohenSutherland, CohenSutherlandInput}, geom::{Segment, Window}, trace::silent};
//! let window = Window::new(-1.0, -1.0, 1.0, 1.0)?;
//! let segment = Segment::new(-2.0, -1.0, 2.0, 1.5)?;
//! let input = CohenSutherlandInput { window, segment, bit_order: BitOrder::Tbrl };
//! assert_eq!(silent::<CohenSutherland>(&input), Some(Segment::new(-1.0, -0.375, 1.0, 0.875)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::{Deserialize, Serialize};

use crate::{
    algo::{
        parameter::{Ratio, clamp_between},
        segment::{Code, CodeClip, CodeEvent, Coded, Ends},
    },
    geom::{Edge, Point, Segment, Window},
    trace::Real,
};

use super::{
    Visible,
    crossing::{crossing_at, join, split},
    ends_of,
};

/// The algorithm; see the module.
pub type CohenSutherland = CodeClip<2, CohenSutherlandInput>;

/// What happens, in order.
pub type CohenSutherlandEvent = CodeEvent<2, Outcode, Edge>;

/// What to clip, and how codes are written.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CohenSutherlandInput {
    /// Closed.
    pub window: Window,
    /// Directed from P₁ to P₂.
    pub segment: Segment,
    /// Also the order of the cuts: lowest bit first.
    pub bit_order: BitOrder,
}

impl Coded<2> for CohenSutherlandInput {
    type Side = Edge;
    type Code = Outcode;
    type Output = Visible;
    const N_SIDES: usize = 4;

    #[inline]
    fn ends(&self) -> Ends<2> {
        ends_of(&self.segment)
    }

    #[inline]
    fn code<R: Real>(&self, at: [f64; 2]) -> Outcode {
        Outcode::of(at.map(R::new), &self.window, self.bit_order)
    }

    #[inline]
    fn lowest(&self, code: Outcode) -> Option<Edge> {
        code.lowest(self.bit_order)
    }

    #[inline]
    fn has(&self, code: Outcode, edge: Edge) -> bool {
        code.has(edge, self.bit_order)
    }

    #[inline]
    fn crossing<R: Real>(&self, edge: Edge, left: &Ends<2>) -> ([f64; 2], Ratio) {
        let (axis, border) = (edge.axis(), self.window.border(edge));
        let cut = crossing_at::<R>(&self.segment, axis, border);
        let [[_, free1], [_, free2]] =
            left.map(|[x, y]| split::<R>(Point::from_finite(x, y), axis));
        let free = clamp_between(cut.free, free1, free2);
        let [num, den] = cut.ratio.map(R::get);
        let to = join(axis, R::new(border), free).to_array();
        (to, Ratio { num, den })
    }
}

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
pub type Outcode = Code<4>;

impl Outcode {
    /// The code of a point. A point on a border is inside it. Four comparisons and no branch.
    #[inline]
    pub fn of<R: Real>([x, y]: [R; 2], window: &Window, order: BitOrder) -> Self {
        let border = |edge: Edge| R::new(window.border(edge));
        let across = [x < border(Edge::Left), x > border(Edge::Right)];
        let upright = [y < border(Edge::Bottom), y > border(Edge::Top)];
        let [[left, right], [bottom, top]] = [across, upright].map(|sides| sides.map(u8::from));
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
        let is_set = move |&edge: &Edge| self.has(edge, order);
        order.written().into_iter().filter(is_set)
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
