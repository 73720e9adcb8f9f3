//! A triangle and the planes that it is cut by, and the triangles that are left of it.

use crate::geom::Plane;

use super::{SpaceVertex, has_area};

/// What is cut, and by what.
#[derive(Clone, PartialEq, Debug)]
pub struct TrianglePlanes {
    /// Inside is what all of them have inside.
    pub planes: Vec<Plane>,
    /// With a place in a texture at every corner, or at none.
    pub triangle: [SpaceVertex; 3],
}

impl TrianglePlanes {
    /// Has every corner a place in a texture?
    #[must_use]
    pub fn has_uv(&self) -> bool {
        self.triangle.iter().all(|v| v.uv.is_some())
    }
}

/// What is left.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct CutTriangles {
    /// Next to each other, wound as the one that was given.
    pub triangles: Vec<[SpaceVertex; 3]>,
    /// How many crossings of edges and planes it took.
    pub n_crossings: usize,
    /// Have their corners places in a texture?
    pub has_uv: bool,
}

/// The fan from the first vertex: none where there is nothing to fill.
pub(super) fn fan(ring: &[SpaceVertex]) -> Vec<[SpaceVertex; 3]> {
    let Some((&first, rest)) = ring.split_first() else {
        return Vec::new();
    };
    let triangles = rest.windows(2).map(|pair| [first, pair[0], pair[1]]);
    let triangles: Vec<_> = triangles.collect();
    if triangles.iter().any(has_area) {
        triangles
    } else {
        Vec::new()
    }
}
