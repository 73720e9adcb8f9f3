//! Cyrus–Beck: clip the parameter interval against any convex polygon, by the signs of dot products ([`LineClip`]). An edge from E has
//! n·w = n·(P₁ − E), the distance of P₁, and n·D, its growth along the segment: the line meets it at t = −(n·w) / (n·D).
//!
//! n·D is computed as the difference of both ends' distances, so that its sign and theirs always agree. On an edge along an axis the
//! border coordinate is assigned, and of edges crossed at the same t a vertical one sets the interval, else the first: a window gives
//! what Liang–Barsky gives. *Bound*: one row an edge. *Cost*: for n edges at most 7n +, 4n × and n ÷; for each end that is cut at most
//! 4 +, 4 × and 2 ÷ more.
//!
//! *Source*: M. Cyrus and J. Beck, "Generalized Two- and Three-Dimensional Clipping", Computers & Graphics 3(1), 1978, pp. 23–28,
//! doi:10.1016/0097-8493(78)90021-3.
//!
//! ```
//! use clipscope::{algo::line::{CyrusBeck, CyrusBeckInput}, geom::{ConvexPolygon, Segment}, trace::silent};
//! let clip = ConvexPolygon::new(&[[0.0, -2.0], [2.0, 0.0], [0.0, 2.0], [-2.0, 0.0]])?;
//! let segment = Segment::new(-3.0, 1.0, 1.0, 1.0)?;
//! assert_eq!(silent::<CyrusBeck>(&CyrusBeckInput { clip, segment }), Some(Segment::new(-1.0, 1.0, 1.0, 1.0)?));
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

use serde::Serializer;

use crate::{
    algo::{
        parameter::Interval,
        segment::{Bounds, Ends, Fields, Given, LineClip, LineEvent, RowNumbers, Spelling},
    },
    geom::{ConvexPolygon, Point, Segment},
    trace::Real,
};

use super::{
    Visible,
    convex_border::{ConvexBorder, in_range, plane_distances, told_distances},
    ends_of, segment_of,
};

/// The algorithm; see the module.
pub type CyrusBeck = LineClip<2, ConvexPolygon>;

/// What happens, in order.
pub type CyrusBeckEvent = LineEvent<usize, 2, CyrusBeckRow>;

/// What to clip, and against what.
#[derive(Clone, PartialEq, Debug)]
pub struct CyrusBeckInput {
    /// Closed. Edges are numbered from vertex 0, counter-clockwise.
    pub clip: ConvexPolygon,
    /// Directed from P₁ to P₂.
    pub segment: Segment,
}

/// One edge's dot products.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct CyrusBeckRow {
    /// n, pointing inside; of length 1 along an axis only.
    pub normal: [f64; 2],
    /// E, the vertex that the edge starts from.
    pub origin: Point,
    /// n·(P₁ − E): how far P₁ lies inside, in lengths of n.
    pub d1: f64,
    /// n·(P₂ − E): the same for P₂.
    pub d2: f64,
    /// n·D = d₂ − d₁: into the polygon where positive.
    pub slope: f64,
}

impl RowNumbers for CyrusBeckRow {
    const SPELLING: Spelling = Spelling {
        row: "edge",
        plane: ["edge_idx"; 2],
        q: "d1",
        r: "t",
        u: "t",
        bounds: ["t_min", "t_max"],
    };

    fn p_and_q(&self) -> [f64; 2] {
        [0.0 - self.slope, self.d1]
    }

    fn turned(self) -> Self {
        let [d1, d2, slope] = [self.d1, self.d2, self.slope].map(|x| 0.0 - x);
        Self {
            normal: self.normal.map(|x| 0.0 - x),
            d1,
            d2,
            slope,
            ..self
        }
    }

    fn with<S: Serializer>(&self, fields: Fields<S>) -> Result<Fields<S>, S::Error> {
        let fields = fields.with("normal", &self.normal)?;
        let fields = fields.with("origin", &self.origin)?.with("d1", &self.d1)?;
        fields.with("d2", &self.d2)?.with("slope", &self.slope)
    }
}

impl Given<2, ConvexPolygon> for CyrusBeckInput {
    #[inline]
    fn bounds(&self) -> &ConvexPolygon {
        &self.clip
    }

    #[inline]
    fn ends(&self) -> Ends<2> {
        ends_of(&self.segment)
    }
}

impl Bounds<2> for ConvexPolygon {
    type Plane = usize;
    type Row = CyrusBeckRow;
    type Input = CyrusBeckInput;
    type Output = Visible;

    #[inline]
    fn planes(&self) -> impl Iterator<Item = usize> {
        0..self.vertices().len()
    }

    #[inline]
    fn inequality<R: Real>(
        &self,
        edge_idx: usize,
        ends: &Ends<2>,
        _: &[R; 2],
    ) -> ([R; 2], CyrusBeckRow) {
        let plane = self.half_plane(edge_idx);
        let segment = segment_of(*ends);
        let told = told_distances::<R>(&segment, &plane);
        let [d1, d2] = in_range(&segment, &plane, told);
        let slope = d2 - d1;
        let told = told.map(R::get);
        let row = CyrusBeckRow {
            normal: plane.normal(),
            origin: plane.origin(),
            d1: told[0],
            d2: told[1],
            slope: told[1] - told[0],
        };
        ([-slope, d1], row)
    }

    #[inline]
    fn shown(q: f64) -> f64 {
        q
    }

    /// The signs of n·D are those of the distances: nothing is compared again.
    #[inline]
    fn is_leaving<R: Real>(p: R) -> bool {
        p.get() > 0.0
    }

    #[inline]
    fn distances(&self, edge_idx: usize, ends: &Ends<2>) -> [f64; 2] {
        plane_distances(&segment_of(*ends), &self.half_plane(edge_idx))
    }

    /// Of two at the same place a vertical one wins.
    #[inline]
    fn wins_tie(&self, other: usize, first: usize) -> bool {
        let is_vertical = |edge_idx| self.half_plane(edge_idx).normal()[1] == 0.0;
        is_vertical(other) && !is_vertical(first)
    }

    /// Where it comes in across one edge and goes out across its neighbour: a vertex.
    #[inline]
    fn touched<R: Real>(
        &self,
        interval: &Interval<R, usize>,
        ends: &Ends<2>,
    ) -> Option<[usize; 2]> {
        let edges = interval.borders()?;
        shared_vertex(self.vertices().len(), edges)?;
        let is_touch = interval.is_touch(|edge_idx| self.distances(edge_idx, ends));
        is_touch.then_some(edges)
    }

    #[inline]
    fn crossing<R: Real>(
        &self,
        edge_idx: usize,
        touched: Option<usize>,
        ends: &Ends<2>,
    ) -> [f64; 2] {
        let vertices = self.vertices();
        let shared = touched.and_then(|other| shared_vertex(vertices.len(), [edge_idx, other]));
        let at = match shared {
            Some(vertex_idx) => vertices[vertex_idx],
            None => {
                let border = ConvexBorder {
                    edge_idx,
                    plane: self.half_plane(edge_idx),
                    distances: self.distances(edge_idx, ends),
                };
                border.crossing::<R>(&segment_of(*ends), self)
            }
        };
        at.to_array()
    }
}

/// The vertex where two of `n` edges meet.
const fn shared_vertex(n: usize, [i, j]: [usize; 2]) -> Option<usize> {
    if (i + 1) % n == j {
        Some(j)
    } else if (j + 1) % n == i {
        Some(i)
    } else {
        None
    }
}
