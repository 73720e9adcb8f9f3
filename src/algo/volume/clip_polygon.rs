//! What is left of a triangle in the clip volume: a convex polygon without a heap.

use crate::algo::ring::Ring;

use super::{clip_vertex::ClipVertex, space_vertex::independent};

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

    /// A triangle.
    #[inline]
    pub(super) const fn of(&[a, b, c]: &[ClipVertex<A>; 3]) -> Self {
        Self {
            vertices: [a, b, c, a, a, a, a, a, a],
            len: 3,
            first_given: a,
        }
    }

    /// Becomes a triangle.
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

    /// Does it go around anything? Exact: not where all vertices lie on one line of space, that is, where every three of the
    /// four rows that their coordinates make are dependent.
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

    /// A tenth, which only rounding could make of a polygon as thin as rounding, or a clipper that is wrong on purpose, is left
    /// out.
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
