//! Ear clipping: cut off one triangle after the other, wherever a corner has nothing else in it.
//!
//! ```text
//!  V₄ ●                ● V₂    V₁ is convex, but V₃ lies in V₀V₁V₂: no ear.
//!     │ ╲            ╱ │       V₂ is convex, and no other vertex lies in V₁V₂V₃: an ear.
//!     │   ╲        ╱   │       Its diagonal V₁V₃ runs inside, so that what is left when it
//!     │     ╲    ╱     │       is cut off, V₀V₁V₃V₄, is a simple polygon again.
//!     │    V₃ ●╌╌╌     │
//!     │            ╌╌╌ │
//!  V₀ ●────────────────● V₁
//! ```
//!
//! 1. Classify every vertex by the sign of (x₂ − x₁)(y₃ − y₂) − (y₂ − y₁)(x₃ − x₂), with its two neighbours
//!    before and after: convex, straight or reflex.
//! 2. Stand at V₁ and walk. Not convex: go on. Convex: ask whether a vertex that is not convex lies in the
//!    closed triangle with the neighbours. If one does, go on; if none does, this is an ear: cut it off,
//!    classify its two neighbours again, and step back to the one before, whose corner has changed.
//! 3. Where three vertices are left they are the last triangle.
//!
//! One walk is enough. A vertex that is no ear becomes one only when a neighbour of its is cut off: the
//! diagonal across its corner lies inside what is left, so it lay inside before. Stepping back asks all such
//! vertices again but V₀. And of any simple polygon with more than three vertices two that are not neighbours
//! are ears, so that back at V₀, with none between, only a triangle can be left.
//!
//! Only vertices that are not convex need to be asked: of those inside the corner, the one nearest to its tip
//! belongs to a chain that turns back there. `rivals` keeps them by x.
//!
//! *Conventions*: triangles are numbers of vertices, counter-clockwise like the outline; the corner's own three
//! vertices do not block it, any other one in the closed triangle does. *Degenerate*: a straight vertex is
//! never the tip of an ear, as its triangle would have no area, but it stays in the ring until it has become a
//! corner. Dropping it instead would leave a crack: the neighbour across that edge still has it. So n vertices
//! give n − 2 triangles, always, none of them without area. *Exactness*: only signs decide, and they are exact
//! ([`Corner`]); the triangles' vertices are the input's, bit for bit.
//!
//! *Bound*: n − 3 cuts, and a walk that steps back after each: at most 2n − 5 corners are tried, each with two
//! events; with n and then 2 classifications a cut no more than 8n − 17 events. *Cost*: O(n·r) for r vertices
//! that are not convex, O(n²) at worst; where corners are small against the polygon, few are asked and the
//! rest is O(n log n).
//!
//! *Source*: G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975, pp. 648–651,
//! doi:10.2307/2319703 (two ears). The walk that steps back: X. Kong, H. Everett and G. Toussaint, "The Graham
//! scan triangulates simple polygons", Pattern Recognition Letters 11(11), 1990, pp. 713–716,
//! doi:10.1016/0167-8655(90)90089-K. See also H. ElGindy, H. Everett and G. Toussaint, "Slicing an ear using
//! prune-and-search", Pattern Recognition Letters 14(9), 1993, pp. 719–722, doi:10.1016/0167-8655(93)90141-Y.
//!
//! ```
//! use clipscope::{algo::polygon::EarClipping, geom::Polygon, trace::silent};
//! let arrowhead = Polygon::new(&[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [2.0, 4.0]])?;
//! assert_eq!(silent::<EarClipping>(&arrowhead), [[1, 2, 3], [0, 1, 3]]);
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

mod corner;
mod ring;
mod rivals;

use serde::Serialize;

use crate::{
    geom::{Point, Polygon},
    trace::{Algorithm, Real},
};

use self::{
    corner::double_area,
    rivals::{Rival, Rivals},
};

pub use self::{corner::Corner, ring::Ring};

/// Three vertices by number, counter-clockwise.
pub type Triangle = [usize; 3];

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct EarClipping;

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum EarClippingEvent {
    /// Which way the outline turns at a vertex: at first, and again where its corner has changed.
    Classify {
        /// The vertex.
        vertex_idx: usize,
        /// Before it in what is left.
        prev_idx: usize,
        /// After it.
        next_idx: usize,
        /// Of the triangle that it forms with them; its sign is exact.
        double_area: f64,
        /// What the sign says.
        corner: Corner,
    },
    /// The walk stands at a vertex that is not convex, and goes on.
    Pass {
        /// The vertex.
        vertex_idx: usize,
        /// Straight or reflex.
        corner: Corner,
    },
    /// The walk stands at a convex vertex: is it an ear?
    Candidate {
        /// The vertex before, the vertex, and the one after.
        triangle: Triangle,
    },
    /// It is not: another vertex lies in the closed triangle.
    Blocked {
        /// The convex vertex.
        vertex_idx: usize,
        /// The one in its triangle.
        by_idx: usize,
        /// Twice the area that it spans with each side of the triangle in turn: none negative.
        double_areas: [f64; 3],
    },
    /// It is: no vertex lies in the triangle.
    Ear {
        /// Its tip.
        vertex_idx: usize,
    },
    /// The ear is cut off, along the diagonal from its first vertex to its last.
    Cut {
        /// The vertex before, the tip, and the one after.
        triangle: Triangle,
        /// How many vertices are left.
        n_left: usize,
    },
    /// What is left is a triangle.
    Last {
        /// From the outline's first vertex on.
        triangle: Triangle,
    },
    /// All triangles are there.
    Done {
        /// n − 2
        n_triangles: usize,
    },
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct EarClippingState {
    /// What is left.
    pub ring: Ring,
    /// By vertex, once known; those cut off keep theirs.
    pub corners: Vec<Option<Corner>>,
    /// Where the walk stands.
    pub stand: Option<usize>,
    /// The corner that is tried, or was cut off last.
    pub candidate: Option<Triangle>,
    /// The vertex that lies in it.
    pub blocked_by: Option<usize>,
    /// Is the candidate known to be an ear?
    pub is_ear: bool,
    /// Cut off so far.
    pub triangles: Vec<Triangle>,
    /// Is everything cut off?
    pub is_done: bool,
}

impl Algorithm for EarClipping {
    type Input = Polygon;
    type Output = Vec<Triangle>;
    type Event = EarClippingEvent;
    type State = EarClippingState;

    fn run<R: Real>(input: &Polygon, mut emit: impl FnMut(EarClippingEvent)) -> Vec<Triangle> {
        use EarClippingEvent as Event;
        let mut left = Left::classified::<R>(input.vertices(), &mut emit);
        let mut rivals = Rivals::new(left.points, &left.corners);
        let mut triangles = Vec::with_capacity(left.ring.len() - 2);
        let mut stand = left.ring.next(0);
        // Back at V₀ at the latest: see the module.
        while left.ring.len() > 3 && stand != 0 {
            let triangle @ [prev, _, next] = left.ring.corner(stand);
            if !left.is_ear::<R>(stand, &rivals, &mut emit) {
                stand = next;
                continue;
            }
            left.ring.remove(stand);
            triangles.push(triangle);
            let n_left = left.ring.len();
            emit(Event::Cut { triangle, n_left });
            if n_left > 3 {
                for neighbour in [prev, next] {
                    left.open::<R>(neighbour, &mut rivals, &mut emit);
                }
            }
            stand = if prev == 0 { next } else { prev };
        }
        debug_assert_eq!(left.ring.len(), 3, "a simple polygon has an ear");
        let [_, first, second] = left.ring.corner(0);
        let triangle = [first, second, left.ring.next(second)];
        triangles.push(triangle);
        emit(Event::Last { triangle });
        let n_triangles = triangles.len();
        emit(Event::Done { n_triangles });
        triangles
    }

    fn start(input: &Polygon) -> EarClippingState {
        let n = input.vertices().len();
        EarClippingState {
            ring: Ring::new(n),
            corners: vec![None; n],
            stand: None,
            candidate: None,
            blocked_by: None,
            is_ear: false,
            triangles: Vec::new(),
            is_done: false,
        }
    }

    fn apply(state: &mut EarClippingState, event: EarClippingEvent) {
        use EarClippingEvent as Event;
        match event {
            Event::Classify {
                vertex_idx, corner, ..
            } => state.corners[vertex_idx] = Some(corner),
            Event::Pass { vertex_idx, .. } => state.stand_at(vertex_idx, None),
            Event::Candidate { triangle } => state.stand_at(triangle[1], Some(triangle)),
            Event::Blocked { by_idx, .. } => state.blocked_by = Some(by_idx),
            Event::Ear { .. } => state.is_ear = true,
            Event::Cut { triangle, .. } => {
                state.ring.remove(triangle[1]);
                state.triangles.push(triangle);
            }
            Event::Last { triangle } => {
                state.stand_at(triangle[1], Some(triangle));
                state.triangles.push(triangle);
            }
            Event::Done { .. } => {
                state.candidate = None;
                state.stand = None;
                state.is_done = true;
            }
        }
    }

    fn finish(state: &EarClippingState) -> Vec<Triangle> {
        state.triangles.clone()
    }

    /// n classifications and two a cut, 2n − 5 corners with two events each, n − 3 cuts, the last triangle, and
    /// the end.
    fn max_events(input: &Polygon) -> usize {
        let n = input.vertices().len();
        (3 * n - 6) + 2 * (2 * n - 5) + (n - 3) + 2
    }
}

impl EarClippingState {
    fn stand_at(&mut self, vertex_idx: usize, candidate: Option<Triangle>) {
        self.stand = Some(vertex_idx);
        self.candidate = candidate;
        self.blocked_by = None;
        self.is_ear = false;
    }
}

/// What is left of the polygon, with the kind of each vertex.
struct Left<'a> {
    points: &'a [Point],
    ring: Ring,
    corners: Vec<Corner>,
}

impl<'a> Left<'a> {
    fn classified<R: Real>(points: &'a [Point], emit: &mut impl FnMut(EarClippingEvent)) -> Self {
        let mut left = Self {
            points,
            ring: Ring::new(points.len()),
            corners: Vec::with_capacity(points.len()),
        };
        for vertex_idx in 0..points.len() {
            let corner = left.classify::<R>(vertex_idx, emit);
            left.corners.push(corner);
        }
        left
    }

    fn classify<R: Real>(
        &self,
        vertex_idx: usize,
        emit: &mut impl FnMut(EarClippingEvent),
    ) -> Corner {
        let [prev_idx, _, next_idx] = self.ring.corner(vertex_idx);
        let [a, b, c] = [prev_idx, vertex_idx, next_idx].map(|i| self.points[i]);
        let double_area = double_area::<R>(a, b, c);
        let corner = Corner::of(double_area);
        emit(EarClippingEvent::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            double_area: double_area.get(),
            corner,
        });
        corner
    }

    /// A neighbour has been cut off: the angle inside has become smaller, so that only a vertex that is not
    /// convex can have changed its kind.
    fn open<R: Real>(
        &mut self,
        vertex_idx: usize,
        rivals: &mut Rivals<'_>,
        emit: &mut impl FnMut(EarClippingEvent),
    ) {
        if self.corners[vertex_idx] == Corner::Convex {
            return;
        }
        self.corners[vertex_idx] = self.classify::<R>(vertex_idx, emit);
        if self.corners[vertex_idx] == Corner::Convex {
            rivals.one_less(&self.corners);
        }
    }

    fn is_ear<R: Real>(
        &self,
        vertex_idx: usize,
        rivals: &Rivals<'_>,
        emit: &mut impl FnMut(EarClippingEvent),
    ) -> bool {
        use EarClippingEvent as Event;
        let corner = self.corners[vertex_idx];
        if corner != Corner::Convex {
            emit(Event::Pass { vertex_idx, corner });
            return false;
        }
        let triangle = self.ring.corner(vertex_idx);
        emit(Event::Candidate { triangle });
        match rivals.inside::<R>(triangle, &self.corners) {
            Some(Rival {
                vertex_idx: by_idx,
                double_areas,
            }) => {
                emit(Event::Blocked {
                    vertex_idx,
                    by_idx,
                    double_areas,
                });
                false
            }
            None => {
                emit(Event::Ear { vertex_idx });
                true
            }
        }
    }
}
