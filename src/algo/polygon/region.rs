//! What Sutherland–Hodgman clips against.

use crate::geom::{ConvexPolygon, Edge, HalfPlane, Window};

/// What a polygon is clipped against: closed and convex.
#[derive(Clone, PartialEq, Debug)]
pub enum ClipRegion {
    /// Its edges are numbered as [`Edge::ALL`]: left, right, bottom, top.
    Window(Window),
    /// Its edges are numbered from vertex 0, counter-clockwise.
    Convex(ConvexPolygon),
}

impl ClipRegion {
    /// How many edges it has.
    #[must_use]
    pub fn n_edges(&self) -> usize {
        match self {
            Self::Window(_) => Edge::ALL.len(),
            Self::Convex(polygon) => polygon.vertices().len(),
        }
    }

    /// One half-plane an edge, in the order in which they clip.
    #[must_use]
    pub fn half_planes(&self) -> Vec<HalfPlane> {
        match self {
            Self::Window(window) => Edge::ALL.map(|edge| window.half_plane(edge)).to_vec(),
            Self::Convex(polygon) => polygon.half_planes().collect(),
        }
    }
}

impl From<Window> for ClipRegion {
    fn from(window: Window) -> Self {
        Self::Window(window)
    }
}

impl From<ConvexPolygon> for ClipRegion {
    fn from(polygon: ConvexPolygon) -> Self {
        Self::Convex(polygon)
    }
}
