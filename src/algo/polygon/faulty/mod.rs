//! **Wrong on purpose.** Sutherland–Hodgman with one mistake each, as found in lecture notes and in programs that students hand in: the
//! same step with one rule changed ([`Rules`]), and the same events, so that the first differing step is the first differing event.
//! Only the lab's "what is wrong here?" knows this room: `tests/architecture/` holds the rest of the house to that.
//!
//! ```
//! use clipscope::{algo::polygon::{faulty::{DropsOnBorder, Faulty}, SutherlandHodgman, SutherlandHodgmanInput}, geom::{Polygon, Window}, trace::silent};
//! // One vertex on the left border: the mistake loses it.
//! let region = Window::new(-1.0, -1.0, 1.0, 1.0)?.into();
//! let polygon = Polygon::new(&[[0.0, 0.0], [-1.0, 0.5], [0.0, 0.5]])?;
//! let input = SutherlandHodgmanInput::new(region, &polygon);
//! assert_eq!(silent::<SutherlandHodgman>(&input).vertices.len(), 3);
//! assert_eq!(silent::<Faulty<DropsOnBorder>>(&input).vertices.len(), 2);
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::{Deserialize, Serialize};

use crate::{geom::Point, trace::Real};

use super::{Rules, Share, SutherlandHodgman, Vertex};

/// Erratum E6: inside is a distance *greater* than 0, and a product of distances *less* than 0 is cut: a vertex on the border is lost.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct DropsOnBorder;

impl Rules for DropsOnBorder {
    const BORDER_IS_INSIDE: bool = false;
}

/// The edge from the last vertex to the first is forgotten: a crossing is missing, and a corner is cut off.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LeavesOpen;

impl Rules for LeavesOpen {
    const CLOSES: bool = false;
}

/// The clip edges are walked clockwise, and their left is taken for the inside: every half-plane is the wrong one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct WalksClockwise;

impl Rules for WalksClockwise {
    const CLOCKWISE: bool = true;
}

/// A crossing ends one edge and is put out again to begin the next: the picture stays the same, and the list grows.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CutsTwice;

impl Rules for CutsTwice {
    const COPIES: usize = 2;
}

/// Where an edge comes in, its end is put out before the crossing: the outline goes back and forth, and crosses itself.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct EndFirst;

impl Rules for EndFirst {
    const END_FIRST: bool = true;
}

/// An edge is cut at its inside end on the border, too, which is then put out twice.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CutsOnBorder;

impl Rules for CutsOnBorder {
    const CUTS_ON_BORDER: bool = true;
}

/// Sutherland–Hodgman with the mistake `L`.
pub type Faulty<L, V = Point> = SutherlandHodgman<V, L>;

/// A vertex that is moved to the border and keeps its place in the texture: the picture shifts and stretches as it is cut.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct KeepsUv {
    /// Where it is.
    pub at: Point,
    /// The place in the texture that is to appear there.
    pub uv: [f64; 2],
}

impl Vertex for KeepsUv {
    fn at(&self) -> Point {
        self.at
    }

    fn crossing<R: Real>(&self, outside: &Self, at: Point, _: &Share<R>) -> Self {
        Self { at, uv: outside.uv }
    }
}
