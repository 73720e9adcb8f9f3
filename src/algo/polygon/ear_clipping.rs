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
//! 2. Go around and ask every vertex whether it is an ear. It is where it is convex and no vertex that is not
//!    convex lies in the closed triangle with its neighbours. Cut it off and classify the two neighbours again:
//!    their corners have changed, and both are asked in the next round.
//! 3. Where three vertices are left they are the last triangle; else begin the next round.
//!
//! A round asks those alone whose corner has changed in the round before. That is enough: a vertex that is no
//! ear becomes one only when a neighbour of its is cut off. (The diagonal across an ear lies inside what is left,
//! so it lay inside before.) And it comes to an end: any simple polygon of more than three vertices has an ear,
//! so each round cuts one off. Letting the next vertex wait, too, cuts about every second corner of a convex
//! stretch, instead of a fan of slivers that all meet in one vertex.
//!
//! Only vertices that are not convex need to be asked whether they lie in a triangle: of those inside a corner,
//! the one nearest to its tip belongs to a chain that turns back there. `rivals` keeps them by x.
//!
//! *Conventions*: vertices have the numbers that they were given with; the ring runs counter-clockwise whichever
//! way they were given, and so does every triangle. A corner's own three vertices do not block it, any other one in
//! the closed triangle does. *Degenerate*: of repeated vertices a [`SimplePolygon`] keeps the first one; a straight vertex is never the tip of an ear, as its triangle would
//! have no area, but it stays in the ring until it has become a corner. Dropping it instead would leave a crack:
//! the neighbour across that edge still has it. So n vertices give n − 2 triangles, always, none of them without
//! area. *Exactness*: only signs decide, and they are exact ([`Corner`]); the triangles' vertices are the
//! input's, bit for bit.
//!
//! *Bound*: n − 3 cuts in at most as many rounds; n vertices are asked, and two more after each cut, with two
//! events each, and as many classified: at most 11n − 22 events. *Cost*: O(n·r) for r vertices that are not
//! convex, O(n²) at worst; where corners are small against the polygon, few of them are asked and the rest is
//! O(n log n).
//!
//! *Source*: G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975, pp. 648–651,
//! doi:10.2307/2319703. That a cut changes its two neighbours alone: J. O'Rourke, *Computational Geometry in C*,
//! 2nd edition, 1998, chapter 1. See also H. ElGindy, H. Everett and G. Toussaint, "Slicing an ear using
//! prune-and-search", Pattern Recognition Letters 14(9), 1993, pp. 719–722, doi:10.1016/0167-8655(93)90141-Y.
//!
//! ```
//! use clipscope::{algo::polygon::EarClipping, geom::SimplePolygon, trace::silent};
//! let arrowhead = SimplePolygon::new(&[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [2.0, 4.0]])?;
//! assert_eq!(silent::<EarClipping>(&arrowhead).triangles(), [[3, 0, 1], [1, 2, 3]]);
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

mod corner;
mod ring;
mod rivals;
mod triangulation;

use serde::Serialize;

use crate::{
    geom::{Point, SimplePolygon},
    trace::{Algorithm, Real},
};

use self::{
    corner::double_area,
    rivals::{Rival, Rivals},
    triangulation::order_of,
};

pub use self::{
    corner::Corner,
    ring::Ring,
    triangulation::{Triangle, Triangulation},
};

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
    /// A round begins.
    Round {
        /// From 0.
        round_idx: usize,
        /// How many vertices are left.
        n_left: usize,
    },
    /// A vertex that is not convex is no ear.
    Pass {
        /// The vertex.
        vertex_idx: usize,
        /// Straight or reflex.
        corner: Corner,
    },
    /// A vertex is convex: is it an ear?
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
        /// From the first vertex of what is left on.
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
    /// The vertex that is asked.
    pub stand: Option<usize>,
    /// Its corner where it is convex, also when it has just been cut off.
    pub candidate: Option<Triangle>,
    /// The vertex that lies in it.
    pub blocked_by: Option<usize>,
    /// Is the candidate known to be an ear?
    pub is_ear: bool,
    /// What has been cut off so far.
    pub cut_off: Triangulation,
    /// Is everything cut off?
    pub is_done: bool,
}

impl Algorithm for EarClipping {
    type Input = SimplePolygon;
    type Output = Triangulation;
    type Event = EarClippingEvent;
    type State = EarClippingState;

    fn run<R: Real>(
        input: &SimplePolygon,
        mut emit: impl FnMut(EarClippingEvent),
    ) -> Triangulation {
        use EarClippingEvent as Event;
        let mut round = order_of(input);
        let mut answer = Triangulation::new(input, &round);
        let points = answer.points();
        let mut left = Left::classified::<R>(&points, &round, &mut emit);
        let mut rivals = Rivals::new(&points, &left.ring, &left.corners);
        // The last round in which a vertex was asked, or the next one in which it will be.
        let mut due = vec![0; points.len()];
        for round_idx in 0..round.len() - 3 {
            let n_left = left.ring.len();
            if n_left == 3 {
                break;
            }
            emit(Event::Round { round_idx, n_left });
            let mut next_round = Vec::new();
            for vertex_idx in round {
                let is_due = due[vertex_idx] == round_idx && left.ring.len() > 3;
                if !is_due || !left.is_ear::<R>(vertex_idx, &rivals, &mut emit) {
                    continue;
                }
                answer.push(left.ring.corner(vertex_idx));
                for neighbour in left.cut::<R>(vertex_idx, &mut rivals, &mut emit) {
                    if due[neighbour] <= round_idx {
                        due[neighbour] = round_idx + 1;
                        next_round.push(neighbour);
                    }
                }
            }
            round = next_round;
        }
        debug_assert_eq!(left.ring.len(), 3, "a simple polygon has an ear");
        let triangle = left.ring.corner(left.ring.next(left.ring.first()));
        answer.push(triangle);
        emit(Event::Last { triangle });
        let n_triangles = answer.triangles().len();
        emit(Event::Done { n_triangles });
        answer
    }

    fn start(input: &SimplePolygon) -> EarClippingState {
        let order = order_of(input);
        let cut_off = Triangulation::new(input, &order);
        EarClippingState {
            ring: Ring::through(&order),
            corners: vec![None; cut_off.points().len()],
            stand: None,
            candidate: None,
            blocked_by: None,
            is_ear: false,
            cut_off,
            is_done: false,
        }
    }

    fn apply(state: &mut EarClippingState, event: EarClippingEvent) {
        use EarClippingEvent as Event;
        match event {
            Event::Classify {
                vertex_idx, corner, ..
            } => state.corners[vertex_idx] = Some(corner),
            Event::Round { .. } => {
                state.stand = None;
                state.candidate = None;
            }
            Event::Pass { vertex_idx, .. } => state.stand_at(vertex_idx, None),
            Event::Candidate { triangle } => state.stand_at(triangle[1], Some(triangle)),
            Event::Blocked { by_idx, .. } => state.blocked_by = Some(by_idx),
            Event::Ear { .. } => state.is_ear = true,
            Event::Cut { triangle, .. } => {
                state.ring.remove(triangle[1]);
                state.cut_off.push(triangle);
            }
            Event::Last { triangle } => {
                state.stand_at(triangle[1], Some(triangle));
                state.cut_off.push(triangle);
            }
            Event::Done { .. } => {
                state.candidate = None;
                state.stand = None;
                state.is_done = true;
            }
        }
    }

    fn finish(state: &EarClippingState) -> Triangulation {
        state.cut_off.clone()
    }

    /// n classifications and two a cut; two events for as many vertices asked; n − 3 rounds and cuts; the last
    /// triangle, and the end.
    fn max_events(input: &SimplePolygon) -> usize {
        let n = input.vertices().len();
        3 * (3 * n - 6) + 2 * (n - 3) + 2
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
    fn classified<R: Real>(
        points: &'a [Point],
        order: &[usize],
        emit: &mut impl FnMut(EarClippingEvent),
    ) -> Self {
        let mut left = Self {
            points,
            ring: Ring::through(order),
            corners: vec![Corner::Straight; points.len()],
        };
        for &vertex_idx in order {
            left.corners[vertex_idx] = left.classify::<R>(vertex_idx, emit);
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

    /// Cuts an ear off and gives its neighbours. The angles at both have become smaller, so that only one that
    /// was not convex can have changed its kind.
    fn cut<R: Real>(
        &mut self,
        vertex_idx: usize,
        rivals: &mut Rivals<'_>,
        emit: &mut impl FnMut(EarClippingEvent),
    ) -> [usize; 2] {
        let triangle @ [prev, _, next] = self.ring.corner(vertex_idx);
        self.ring.remove(vertex_idx);
        let n_left = self.ring.len();
        emit(EarClippingEvent::Cut { triangle, n_left });
        for neighbour in [prev, next] {
            if n_left == 3 || self.corners[neighbour] == Corner::Convex {
                continue;
            }
            self.corners[neighbour] = self.classify::<R>(neighbour, emit);
            if self.corners[neighbour] == Corner::Convex {
                rivals.one_less(&self.corners);
            }
        }
        [prev, next]
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
