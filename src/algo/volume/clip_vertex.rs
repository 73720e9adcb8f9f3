//! What is clipped before the divide: a point in clip space with whatever travels with it, and a polygon of such, without a heap.

use serde::Serialize;

use crate::{
    algo::{
        parameter::Share,
        ring::{Crossing, Limit, Ring},
    },
    geom::VolumeSide,
    trace::Real,
};

use super::{plane_cut::inside_first, space_vertex::independent};

/// What a crossing interpolates besides its position: texture coordinates, a colour, a normal.
pub trait Attributes: Copy + PartialEq {
    /// Those where an edge from `self`, at the inside end, to `outside` is cut; both ends share as `share` says.
    #[must_use]
    fn crossing<R: Real>(&self, outside: &Self, share: &Share<R>) -> Self;
}

impl Attributes for () {
    #[inline]
    fn crossing<R: Real>(&self, (): &Self, _: &Share<R>) -> Self {}
}

impl<A: Attributes> Attributes for Option<A> {
    #[inline]
    fn crossing<R: Real>(&self, outside: &Self, share: &Share<R>) -> Self {
        Some(self.as_ref()?.crossing(outside.as_ref()?, share))
    }
}

impl<const N: usize> Attributes for [f64; N] {
    #[inline]
    fn crossing<R: Real>(&self, outside: &Self, share: &Share<R>) -> Self {
        share.means(*self, *outside)
    }
}

impl<const N: usize> Attributes for [f32; N] {
    #[inline]
    fn crossing<R: Real>(&self, outside: &Self, share: &Share<R>) -> Self {
        let wide = |ends: &Self| std::array::from_fn(|i| f64::from(ends[i]));
        let means: [f64; N] = share.means(wide(self), wide(outside));
        std::array::from_fn(|i| means[i] as f32)
    }
}

/// A vertex in clip space.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize)]
pub struct ClipVertex<A = ()> {
    /// x, y, z, w, all finite.
    pub at: [f64; 4],
    /// What travels with it.
    pub attributes: A,
}

/// By w, and then a point with w = 1; one with w = 0, which no point is, stays where it is.
pub(super) fn divided<R: Real>(at: [f64; 4]) -> [f64; 4] {
    let [x, y, z, w] = at.map(R::new);
    let at_one = [(x / w).get(), (y / w).get(), (z / w).get(), 1.0];
    let is_point = at_one.iter().all(|x| x.is_finite());
    if is_point { at_one } else { at }
}

/// w + x for the left side, w − x for the right: not below 0 inside. The sign is exact.
#[inline]
pub(super) fn distance<R: Real>(side: VolumeSide, at: [f64; 4]) -> R {
    let [along, w] = [at[side.axis()], at[3]].map(R::new);
    if side.is_high() { w - along } else { w + along }
}

impl VolumeSide {
    /// Is a point inside the side across from this one?
    fn has_across(self, at: [f64; 4]) -> bool {
        let (along, w) = (at[self.axis()], at[3]);
        if self.is_high() {
            -w <= along
        } else {
            along <= w
        }
    }

    /// By the ends' distances; by those of half of everything where a difference is too large for f64.
    #[inline]
    pub(super) fn share<R: Real>(self, ends: [[f64; 4]; 2], [d1, d2]: [R; 2]) -> Share<R> {
        let whole = d1 - d2;
        let [d1, d2, whole] = if whole.get().is_finite() {
            [d1, d2, whole]
        } else {
            let [d1, d2] = ends.map(|at| R::new(distance(self, at.map(|x| 0.25 * x))));
            [d1, d2, R::new(d1.get() - d2.get())]
        };
        Share {
            weights: [d1, -d2],
            whole,
            raw: [-d1.get(), -d2.get(), 0.0],
        }
    }
}

impl<A: Attributes> Limit<ClipVertex<A>> for VolumeSide {
    #[inline]
    fn distance<R: Real>(&self, vertex: &ClipVertex<A>) -> R {
        distance(*self, vertex.at)
    }

    /// From the inside end to the outside one: two triangles that share the edge get the same bits. Every coordinate is a mean by the
    /// same weights, so that what holds of both ends (x ≤ w) holds of it; the one that is clipped is assigned.
    #[inline]
    fn crossing<R: Real>(
        &self,
        ends: [&ClipVertex<A>; 2],
        distances: [R; 2],
    ) -> Option<Crossing<ClipVertex<A>>> {
        let is_leaving = distances[0].get() > 0.0;
        let ([inside, outside], distances) = inside_first(ends, distances);
        let share = self.share([inside.at, outside.at], distances);
        let axis = self.axis();
        // The last is w, the others are the axes that are not clipped.
        let free = [(axis + 1) % 3, (axis + 2) % 3, 3];
        let [one, other, mut w] = share.means(
            std::array::from_fn(|i| inside.at[free[i]]),
            std::array::from_fn(|i| outside.at[free[i]]),
        );
        if w < 0.0 && self.has_across(inside.at) && self.has_across(outside.at) {
            // What has −w ≤ x and x = w has no w below 0: but for rounding.
            w = 0.0;
        }
        let clipped = if self.is_high() { w } else { -w };
        let at = match axis {
            0 => [clipped, one, other, w],
            1 => [other, clipped, one, w],
            _ => [one, other, clipped, w],
        };
        let attributes = inside.attributes.crossing(&outside.attributes, &share);
        let t = share.ratio(is_leaving);
        let vertex = ClipVertex { at, attributes };
        (at != inside.at).then_some(Crossing { at: vertex, t })
    }
}

/// At most nine vertices in clip space: three, and one more for each of six sides.
#[derive(Clone, Copy, Debug)]
pub struct ClipPolygon<A = ()> {
    /// What lies beyond `len` means nothing.
    vertices: [ClipVertex<A>; 9],
    len: usize,
    first_given: ClipVertex<A>,
}

impl<A: PartialEq> PartialEq for ClipPolygon<A> {
    fn eq(&self, other: &Self) -> bool {
        self.first_given == other.first_given
            && self.vertices[..self.len] == other.vertices[..other.len]
    }
}

impl<A: Copy> ClipPolygon<A> {
    /// A side that cuts a convex polygon takes one vertex or more and adds two.
    pub const MAX_VERTICES: usize = 9;

    #[inline]
    pub(super) const fn of(&[a, b, c]: &[ClipVertex<A>; 3]) -> Self {
        Self {
            vertices: [a, b, c, a, a, a, a, a, a],
            len: 3,
            first_given: a,
        }
    }

    #[inline]
    pub(super) const fn begin(&mut self, &[a, b, c]: &[ClipVertex<A>; 3]) {
        [self.vertices[0], self.vertices[1], self.vertices[2]] = [a, b, c];
        self.len = 3;
        self.first_given = a;
    }

    /// The same triangle's, without a vertex.
    #[inline]
    pub(super) const fn emptied(mut self) -> Self {
        self.len = 0;
        self
    }

    /// In order.
    #[inline]
    #[must_use]
    pub fn vertices(&self) -> &[ClipVertex<A>] {
        &self.vertices[..self.len]
    }

    /// The triangle's first vertex, whatever has become of it.
    #[must_use]
    pub const fn first_given(&self) -> ClipVertex<A> {
        self.first_given
    }

    /// The fan from the first vertex: none where there is nothing to fill.
    pub fn triangles(&self) -> impl Iterator<Item = [ClipVertex<A>; 3]> + '_ {
        let vertices = self.vertices();
        let n = if self.has_area() { self.len } else { 0 };
        (2..n).map(|i| [vertices[0], vertices[i - 1], vertices[i]])
    }

    /// Does it go around anything? Exact: not where all vertices lie on one line of space.
    #[must_use]
    pub fn has_area(&self) -> bool {
        let vertices = self.vertices();
        (2..self.len).any(|i| {
            let [a, b, c] = [&vertices[0], &vertices[i - 1], &vertices[i]];
            independent([a.at, b.at, c.at])
        })
    }
}

impl<A: Copy> Ring for ClipPolygon<A> {
    type Vertex = ClipVertex<A>;

    #[inline]
    fn vertices(&self) -> &[ClipVertex<A>] {
        self.vertices()
    }

    /// A tenth, which only rounding or a clipper that is wrong on purpose could make, is left out.
    #[inline]
    fn push(&mut self, vertex: ClipVertex<A>) {
        if let Some(place) = self.vertices.get_mut(self.len) {
            *place = vertex;
            self.len += 1;
        }
    }

    #[inline]
    fn clear(&mut self) {
        self.len = 0;
    }
}
