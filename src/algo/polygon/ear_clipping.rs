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
//! 1. Classify every vertex as convex, straight or reflex, by the sign of its corner's area.
//! 2. Ask every vertex, round by round, whether it is an ear: convex, and no vertex that is not convex in the closed triangle with its
//!    neighbours. Cut it off, classify both neighbours again and ask them in the next round.
//! 3. Where three vertices are left they are the last triangle.
//!
//! A round asks those alone whose corner changed in the round before: a vertex becomes an ear only when a neighbour of its is cut off.
//! Any simple polygon of more than three vertices has an ear, so each round cuts one. That the next vertex waits, too, cuts about every
//! second corner of a convex stretch, instead of a fan of slivers.
//!
//! *Conventions*: vertices keep their numbers; ring and triangles run counter-clockwise. *Degenerate*: a straight vertex is never the
//! tip of an ear, but stays in the ring until it has become a corner, so that no crack opens to a neighbour: n vertices give n − 2
//! triangles, all with area. *Exact*: only exact signs decide ([`Corner`]). *Bound*: n − 3 cuts in as many rounds; n vertices asked, and
//! two more after each cut, with two events each, and as many classified: 11n − 22 events. *Cost*: of r vertices that are not convex a
//! candidate asks those in boxes that it cannot pass by, about √r, and all r at worst, where they cling to its sides: O(n·r). Boxes are
//! counted as vertices are; where r is at most 32 there is one.
//!
//! *Source*: G. H. Meisters, "Polygons Have Ears", American Mathematical Monthly 82(6), 1975, pp. 648–651, doi:10.2307/2319703. That a
//! cut changes its two neighbours alone: J. O'Rourke, *Computational Geometry in C*, 2nd edition, 1998, chapter 1. See also H. ElGindy,
//! H. Everett and G. Toussaint, "Slicing an ear using prune-and-search", Pattern Recognition Letters 14(9), 1993, pp. 719–722,
//! doi:10.1016/0167-8655(93)90141-Y.
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

use std::sync::Arc;

use serde::Serialize;

use crate::{
    geom::{Point, SimplePolygon},
    trace::{Includes, Method, Real, Tell, Told},
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

/// What is left of the polygon, and what has been cut off it.
#[derive(Clone, PartialEq, Debug)]
pub struct EarClippingHeld {
    /// What has been cut off so far: after the end, the answer.
    pub cut_off: Triangulation,
    /// What is left.
    pub ring: Ring,
    /// By vertex, once they are known; those that have been cut off keep theirs.
    pub corners: Vec<Option<Corner>>,
    points: Arc<[Point]>,
    rivals: Rivals,
    /// The last round in which a vertex was asked, or the next one in which it will be.
    due: Vec<usize>,
    round_idx: usize,
    round: Vec<usize>,
    n_turns: usize,
    next_round: Vec<usize>,
}

impl Method for EarClipping {
    type Input = SimplePolygon;
    type Held = EarClippingHeld;
    type Output = Triangulation;
    type Event = EarClippingEvent;

    #[inline]
    fn begin(input: &SimplePolygon) -> EarClippingHeld {
        let order = order_of(input);
        let cut_off = Triangulation::new(input, &order);
        let points = cut_off.points();
        EarClippingHeld {
            cut_off,
            ring: Ring::through(&order),
            corners: vec![None; points.len()],
            rivals: Rivals::default(),
            due: vec![0; points.len()],
            points,
            round_idx: 0,
            round: order,
            n_turns: 0,
            next_round: Vec::new(),
        }
    }

    #[inline]
    fn run<R: Real, T: Tell<Self>>(
        _: &SimplePolygon,
        held: &mut EarClippingHeld,
        tell: &mut T,
    ) -> Told<T::Stop> {
        cut_all::<Self, R, T>(held, tell)
    }

    #[inline]
    fn output(held: EarClippingHeld) -> Triangulation {
        held.cut_off
    }

    fn max_events(input: &SimplePolygon) -> usize {
        let n = input.vertices().len();
        3 * (3 * n - 6) + 2 * (n - 3) + 2
    }
}

impl EarClippingHeld {
    /// The vertex whose turn it is in this round.
    #[must_use]
    pub fn asked(&self) -> Option<usize> {
        self.round.get(self.n_turns.checked_sub(1)?).copied()
    }

    fn ask_again(&mut self, vertex_idx: usize) {
        if self.due[vertex_idx] <= self.round_idx {
            self.due[vertex_idx] = self.round_idx + 1;
            self.next_round.push(vertex_idx);
        }
    }

    fn end_turn(&mut self) {
        if self.n_turns == self.round.len() {
            self.round = std::mem::take(&mut self.next_round);
            (self.round_idx, self.n_turns) = (self.round_idx + 1, 0);
        }
    }
}

#[inline]
pub(super) fn cut_all<M: Includes<EarClipping>, R: Real, T: Tell<M>>(
    held: &mut M::Held,
    tell: &mut T,
) -> Told<T::Stop> {
    Cutting { held, tell }.run::<R>()
}

struct Cutting<'a, M: Method, T> {
    held: &'a mut M::Held,
    tell: &'a mut T,
}

impl<M: Includes<EarClipping>, T: Tell<M>> Cutting<'_, M, T> {
    #[inline]
    fn run<R: Real>(&mut self) -> Told<T::Stop> {
        if self.ears().corners[self.ears().ring.first()].is_none() {
            for i in 0..self.ears().round.len() {
                self.classify::<R>(self.ears().round[i])?;
            }
            let ears = self.ears_mut();
            ears.rivals = Rivals::new(&ears.points, &ears.ring, &ears.corners);
        }
        // A simple polygon has an ear, so no round is without anyone to ask.
        while self.ears().ring.len() > 3 && !self.ears().round.is_empty() {
            self.tell.rest(self.held);
            self.turn::<R>()?;
            self.ears_mut().end_turn();
        }
        let ears = self.ears_mut();
        debug_assert_eq!(ears.ring.len(), 3, "a simple polygon has an ear");
        let triangle = ears.ring.corner(ears.ring.next(ears.ring.first()));
        ears.cut_off.push(triangle);
        let n_triangles = ears.cut_off.triangles().len();
        self.tell(EarClippingEvent::Last { triangle })?;
        self.tell(EarClippingEvent::Done { n_triangles })
    }

    #[inline]
    fn turn<R: Real>(&mut self) -> Told<T::Stop> {
        let ears = self.ears();
        let (n_turns, round_idx) = (ears.n_turns, ears.round_idx);
        let vertex_idx = ears.round[n_turns];
        if n_turns == 0 {
            let n_left = ears.ring.len();
            self.tell(EarClippingEvent::Round { round_idx, n_left })?;
        }
        self.ears_mut().n_turns += 1;
        if self.ears().due[vertex_idx] == round_idx && self.is_ear::<R>(vertex_idx)? {
            self.cut::<R>(vertex_idx)?;
        }
        Told::Continue(())
    }

    #[inline]
    fn classify<R: Real>(&mut self, vertex_idx: usize) -> Told<T::Stop> {
        let ears = self.ears_mut();
        let [prev_idx, _, next_idx] = ears.ring.corner(vertex_idx);
        let [a, b, c] = [prev_idx, vertex_idx, next_idx].map(|i| ears.points[i]);
        let double_area = double_area::<R>(a, b, c);
        let corner = Corner::of(double_area);
        ears.corners[vertex_idx] = Some(corner);
        self.tell(EarClippingEvent::Classify {
            vertex_idx,
            prev_idx,
            next_idx,
            double_area: double_area.get(),
            corner,
        })
    }

    #[inline]
    fn is_ear<R: Real>(&mut self, vertex_idx: usize) -> Told<T::Stop, bool> {
        use EarClippingEvent as Event;
        if let Some(corner @ (Corner::Straight | Corner::Reflex)) = self.ears().corners[vertex_idx]
        {
            self.tell(Event::Pass { vertex_idx, corner })?;
            return Told::Continue(false);
        }
        let triangle = self.ears().ring.corner(vertex_idx);
        self.tell(Event::Candidate { triangle })?;
        let ears = self.ears();
        let rivals = &ears.rivals;
        let rival = rivals.inside::<R>(&ears.points, triangle, &ears.corners);
        let is_ear = rival.is_none();
        self.tell(match rival {
            Some(Rival {
                vertex_idx: by_idx,
                double_areas,
            }) => Event::Blocked {
                vertex_idx,
                by_idx,
                double_areas,
            },
            None => Event::Ear { vertex_idx },
        })?;
        Told::Continue(is_ear)
    }

    /// Both neighbours' angles become smaller, so only one that was not convex can change its kind.
    #[inline]
    fn cut<R: Real>(&mut self, vertex_idx: usize) -> Told<T::Stop> {
        let ears = self.ears_mut();
        let triangle @ [prev, _, next] = ears.ring.corner(vertex_idx);
        ears.cut_off.push(triangle);
        ears.ring.remove(vertex_idx);
        let n_left = ears.ring.len();
        self.tell(EarClippingEvent::Cut { triangle, n_left })?;
        for neighbour in [prev, next] {
            let is_convex =
                |ears: &EarClippingHeld| ears.corners[neighbour] == Some(Corner::Convex);
            if n_left > 3 && !is_convex(self.ears()) {
                self.classify::<R>(neighbour)?;
                let ears = self.ears_mut();
                if is_convex(ears) {
                    ears.rivals.one_less(neighbour, &ears.points, &ears.corners);
                }
            }
            self.ears_mut().ask_again(neighbour);
        }
        Told::Continue(())
    }

    #[inline]
    fn ears(&self) -> &EarClippingHeld {
        M::part(self.held)
    }

    #[inline]
    fn ears_mut(&mut self) -> &mut EarClippingHeld {
        M::part_mut(self.held)
    }

    #[inline]
    fn tell(&mut self, event: EarClippingEvent) -> Told<T::Stop> {
        self.tell.tell(self.held, M::as_own(event))
    }
}
