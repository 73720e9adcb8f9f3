//! What is clipped by planes: a triangle of points in space, with their places in a texture where they have one.

use std::marker::PhantomData;

use serde::Serialize;

use crate::{
    algo::{
        parameter::Share,
        ring::{Crossing, Limit},
    },
    geom::{Plane, sign_of_three},
    trace::Real,
};

use super::{
    VolumeRules,
    plane_cut::{distance, plane_cut, told},
};

/// A corner of a triangle in space.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct SpaceVertex {
    /// Where it is, all finite.
    pub at: [f64; 3],
    /// The place in the texture that is to appear there. It need not be finite; it only travels along.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub uv: Option<[f64; 2]>,
}

impl SpaceVertex {
    /// Without a place in a texture.
    #[must_use]
    pub const fn new(at: [f64; 3]) -> Self {
        Self { at, uv: None }
    }

    /// What of both ends' places in the texture is in a crossing.
    fn uv_at_crossing<R: Real>(&self, outside: &Self, share: &Share<R>) -> Option<[f64; 2]> {
        let (inside, outside) = (self.uv?, outside.uv?);
        Some([0, 1].map(|i| share.mean(inside[i], outside[i])))
    }
}

/// Has a triangle an area? Exact: not where its corners lie on one line.
#[must_use]
pub fn has_area(triangle: &[SpaceVertex; 3]) -> bool {
    independent(triangle.map(|v| [v.at[0], v.at[1], v.at[2], 1.0]))
}

/// Do three points in homogeneous coordinates span a plane? Exact: some three of the four columns are independent.
#[inline]
pub(super) fn independent([a, b, c]: [[f64; 4]; 3]) -> bool {
    const MINORS: [[usize; 3]; 4] = [[0, 1, 3], [0, 1, 2], [0, 2, 3], [1, 2, 3]];
    MINORS.iter().any(|&[i, j, k]| {
        sign_of_three([[a[i], a[j], a[k]], [b[i], b[j], b[k]], [c[i], c[j], c[k]]]).is_ne()
    })
}

/// The last of some planes, by which the others have clipped before, and by the rules of `L`.
#[derive(Clone, Copy)]
pub struct LastPlane<'a, L> {
    planes: &'a [Plane],
    plane: &'a Plane,
    rules: PhantomData<L>,
}

impl<'a, L> LastPlane<'a, L> {
    pub fn all(planes: &'a [Plane]) -> impl Iterator<Item = Self> {
        planes.iter().enumerate().map(|(idx, plane)| Self {
            planes: &planes[..=idx],
            plane,
            rules: PhantomData,
        })
    }

    pub const fn idx(&self) -> usize {
        self.planes.len() - 1
    }
}

impl<L: VolumeRules> Limit<SpaceVertex> for LastPlane<'_, L> {
    #[inline]
    fn distance<R: Real>(&self, vertex: &SpaceVertex) -> R {
        distance(self.plane, vertex.at)
    }

    /// In lengths of 1, not of n.
    #[inline]
    fn told(&self, vertex: &SpaceVertex, distance: f64) -> f64 {
        told(self.plane, vertex.at, distance)
    }

    fn crossing<R: Real>(
        &self,
        ends: [&SpaceVertex; 2],
        distances: [R; 2],
    ) -> Option<Crossing<SpaceVertex>> {
        let cut = plane_cut(self.planes, ends.map(|end| end.at), distances)?;
        let [first, second] = ends;
        let (inside, outside) = if cut.is_leaving {
            (first, second)
        } else {
            (second, first)
        };
        let uv = if L::MIXES_UV {
            inside.uv_at_crossing(outside, &cut.share)
        } else {
            outside.uv
        };
        let at = SpaceVertex { at: cut.at, uv };
        Some(Crossing { at, t: cut.t })
    }
}

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
    let mut triangles: Vec<_> = triangles.collect();
    if !triangles.iter().any(has_area) {
        triangles.clear();
    }
    triangles
}
