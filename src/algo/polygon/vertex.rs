//! What a polygon is made of: a point, and whatever travels with it.

use serde::{Deserialize, Serialize};

use crate::{geom::Point, trace::Real};

use super::super::parameter::Share;

/// A corner of a polygon that can be cut: a position, and attributes that a crossing interpolates.
pub trait Vertex: Copy + PartialEq {
    /// Where it is.
    fn at(&self) -> Point;

    /// Where the edge from `self`, inside, to `outside` crosses a border: at `at`; all but the position is mixed by `share`.
    #[must_use]
    fn crossing<R: Real>(&self, outside: &Self, at: Point, share: &Share<R>) -> Self;
}

impl Vertex for Point {
    #[inline]
    fn at(&self) -> Point {
        *self
    }

    #[inline]
    fn crossing<R: Real>(&self, _: &Self, at: Point, _: &Share<R>) -> Self {
        at
    }
}

/// A point with texture coordinates.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Textured {
    /// Where it is.
    pub at: Point,
    /// The place in the texture that is to appear there. It need not be finite; it only travels along.
    pub uv: [f64; 2],
}

impl Vertex for Textured {
    #[inline]
    fn at(&self) -> Point {
        self.at
    }

    #[inline]
    fn crossing<R: Real>(&self, outside: &Self, at: Point, share: &Share<R>) -> Self {
        let [u, v] = [0, 1].map(|i| share.mean(self.uv[i], outside.uv[i]));
        Self { at, uv: [u, v] }
    }
}
