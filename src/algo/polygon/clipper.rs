//! Sutherland–Hodgman as a renderer would call it: many polygons, one after the other, against one region, without allocating.
//!
//! ```text
//!   polygon ──► extent ──► beyond a border: Outside        no vertex is moved
//!                    ├───► within all:      Inside         nor here
//!                    └───► the borders that it crosses, one pass each, between two buffers
//! ```
//!
//! Against a window only the borders that the extent crosses get a pass of [`SutherlandHodgman`]'s: any other would copy the list, and
//! a crossing lies between the ends of its edge, so the vertices are the same, bit for bit. Against oblique edges, where a rounded
//! crossing may need a pass that its polygon did not, all passes are run, unless every vertex is inside.
//!
//! *Conventions*, *source*: as in [`SutherlandHodgman`]. *Degenerate*: [`Clipped::has_area`] is asked by those who need to know.
//!
//! ```
//! use clipscope::{algo::polygon::{Clipped, Clipper}, geom::{Polygon, Window}};
//! let mut clipper = Clipper::new(&Window::new(-1.0, -1.0, 1.0, 1.0)?.into());
//! let polygon = Polygon::new(&[[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]])?;
//! let clipped = clipper.clip(polygon.vertices());
//! assert!(matches!(clipped, Clipped::Cut(_)) && clipped.has_area());
//! assert_eq!(clipped.vertices().len(), 4);
//! let corner = Polygon::new(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]])?;
//! assert_eq!(clipper.clip(corner.vertices()), Clipped::Inside(corner.vertices()));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use crate::geom::{Axis, Point};

#[cfg(doc)]
use super::SutherlandHodgman;
use super::{
    super::ring::{Right, pass},
    ClipRegion, Vertex,
    border::{AlongAxis, Border, BorderLine, Borders, NthBorder},
    clipped_ring,
};

/// Clips polygons against one region.
#[derive(Clone, Debug)]
pub struct Clipper<V = Point> {
    borders: Borders,
    lists: [Vec<V>; 2],
}

/// What is left of a polygon, borrowed from it or from the clipper.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Clipped<'a, V = Point> {
    /// Every vertex is inside or on the border: the polygon as it was given.
    Inside(&'a [V]),
    /// One ring, not empty; with bridges perhaps, or without any area where the polygon only touches the region.
    Cut(&'a [V]),
    /// Nothing of the polygon is in the region, not even on its border.
    Outside,
}

impl<'a, V: Vertex> Clipped<'a, V> {
    /// The ring; empty where nothing is left.
    #[must_use]
    pub const fn vertices(&self) -> &'a [V] {
        match self {
            Self::Inside(vertices) | Self::Cut(vertices) => vertices,
            Self::Outside => &[],
        }
    }

    /// Is there anything to fill? One more look at every vertex.
    #[must_use]
    pub fn has_area(&self) -> bool {
        clipped_ring::has_area(self.vertices())
    }
}

impl<V: Vertex> Clipper<V> {
    /// With empty lists.
    #[must_use]
    pub fn new(region: &ClipRegion) -> Self {
        Self {
            borders: Borders::by::<Right>(region),
            lists: [Vec::new(), Vec::new()],
        }
    }

    /// What of `polygon` lies in the region. A ring of any shape; the last vertex is joined to the first.
    #[inline]
    pub fn clip<'a>(&'a mut self, polygon: &'a [V]) -> Clipped<'a, V> {
        if self.borders.has_oblique() {
            return self.clip_obliquely(polygon);
        }
        let extent = Extent::of(polygon);
        let sides = || {
            self.borders
                .all()
                .iter()
                .map(|border| extent.side_of(border))
        };
        if sides().any(|side| side == BoxSide::Outside) {
            return Clipped::Outside;
        }
        if sides().all(|side| side == BoxSide::Inside) {
            return Clipped::Inside(polygon);
        }
        self.pass_all(polygon, |border| extent.side_of(border) == BoxSide::Inside)
    }

    fn clip_obliquely<'a>(&'a mut self, polygon: &'a [V]) -> Clipped<'a, V> {
        let is_inside = |border: &Border| {
            let mut distances = polygon.iter().map(|v| border.distance::<f64>(v.at()));
            distances.all(|d| d >= 0.0)
        };
        if polygon.is_empty() {
            Clipped::Outside
        } else if self.borders.all().iter().all(is_inside) {
            Clipped::Inside(polygon)
        } else {
            self.pass_all(polygon, |_| false)
        }
    }

    fn pass_all<'a>(
        &'a mut self,
        polygon: &[V],
        is_left_out: impl Fn(&Border) -> bool,
    ) -> Clipped<'a, V> {
        let [list, output] = &mut self.lists;
        let mut is_first = true;
        for (idx, border) in self.borders.all().iter().enumerate() {
            if is_left_out(border) {
                continue;
            }
            let input = if is_first { polygon } else { &list[..] };
            pass_border(&self.borders, idx, input, output);
            std::mem::swap(list, output);
            is_first = false;
            if list.is_empty() {
                return Clipped::Outside;
            }
        }
        Clipped::Cut(list)
    }
}

/// Along an axis, the axis and the side are known when the pass is compiled.
fn pass_border<V: Vertex>(borders: &Borders, idx: usize, input: &[V], output: &mut Vec<V>) {
    match borders.all()[idx].line() {
        BorderLine::Upright { axis, c, is_max } if !borders.has_oblique() => match (axis, is_max) {
            (Axis::X, false) => pass(&AlongAxis::<false, false>(c), input, output),
            (Axis::X, true) => pass(&AlongAxis::<false, true>(c), input, output),
            (Axis::Y, false) => pass(&AlongAxis::<true, false>(c), input, output),
            (Axis::Y, true) => pass(&AlongAxis::<true, true>(c), input, output),
        },
        _ => pass(&NthBorder { borders, idx }, input, output),
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum BoxSide {
    Inside,
    Outside,
    Both,
}

struct Extent {
    min: [f64; 2],
    max: [f64; 2],
}

impl Extent {
    const NOTHING: Self = Self {
        min: [f64::INFINITY; 2],
        max: [f64::NEG_INFINITY; 2],
    };

    #[inline]
    fn of<V: Vertex>(polygon: &[V]) -> Self {
        let (fours, rest) = polygon.as_chunks::<4>();
        // Four by themselves: each waits for the one before.
        let mut parts = [Self::NOTHING; 4];
        for vertices in fours {
            for (part, vertex) in parts.iter_mut().zip(vertices) {
                part.add(vertex.at());
            }
        }
        let [mut whole, others @ ..] = parts;
        for part in &others {
            whole.join(part);
        }
        for vertex in rest {
            whole.add(vertex.at());
        }
        whole
    }

    #[inline]
    fn add(&mut self, p: Point) {
        let p = p.to_array();
        self.join(&Self { min: p, max: p });
    }

    #[inline]
    fn join(&mut self, other: &Self) {
        for i in 0..2 {
            let ([min, max], [a, b]) = ([self.min[i], self.max[i]], [other.min[i], other.max[i]]);
            self.min[i] = if a < min { a } else { min };
            self.max[i] = if b > max { b } else { max };
        }
    }

    /// Of a border along an axis. A polygon without vertices is outside.
    #[inline]
    fn side_of(&self, border: &Border) -> BoxSide {
        let BorderLine::Upright { axis, c, is_max } = border.line() else {
            return BoxSide::Both;
        };
        let i = usize::from(axis == Axis::Y);
        let (is_inside, is_outside) = if is_max {
            (self.max[i] <= c, self.min[i] > c)
        } else {
            (self.min[i] >= c, self.max[i] < c)
        };
        if is_outside {
            BoxSide::Outside
        } else if is_inside {
            BoxSide::Inside
        } else {
            BoxSide::Both
        }
    }
}
