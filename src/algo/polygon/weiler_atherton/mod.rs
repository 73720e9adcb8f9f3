//! Weiler–Atherton: cut any simple polygon, holes and all, with any other, by walking along both borders.
//!
//! ```text
//!          ●───────────●          Both polygons become lists of vertices, counter-clockwise, with every
//!          │   subject │          intersection in both. Follow the subject from where it enters the clip
//!      ┌───×━━━━━━━━━━━×───┐      polygon to where it leaves, there change to the clip polygon's list, follow
//!      │ leaves     enters │      that to where the subject enters again, and so on, until the ring is
//!      │   ┃           ┃   │      closed. Then take the next entering intersection that is left.
//!      │   ●━━━━━━━━━━━●   │
//!      └───────────────────┘      × I = (s₁·|a₂| + s₂·|a₁|) / (|a₁| + |a₂|)      a: distances from the clip edge
//! ```
//!
//! 1. Find where edges meet (`grid`, `meeting`) and put the intersections into both lists (`lists`).
//! 2. Label each *entering*, *leaving*, *touching* or *pinching* (`labels`).
//! 3. Walk (`walk`); borders that change no lists are inside or outside as a whole.
//! 4. Give each hole to the piece that it lies in (`rings`).
//!
//! The textbook form asks for general position. This one is right for every input, because each decision is the sign of an exact
//! determinant of three given vertices. Only crossings are computed, and nothing is asked of them.
//!
//! *Conventions*: closed regions; interiors to the left, so holes run clockwise. The answer is the closure of the common interior;
//! [`Relation`] tells of common points and edges. Pieces have a connected interior and simple rings, cut where borders only touch.
//! Neither direction nor role changes a bit of a crossing. *Degenerate*: vertices on edges and vertices, shared edges and identical
//! polygons are labelled on the spot; a piece whose rounded corners have no area is left out ([`RingKind::Sliver`]). *Bound*:
//! n·m + n + m intersections; walks take at most as many steps as both lists have entries. *Cost*: O(n + m + k log k) and the tests of
//! the grid's candidates; counted are those, the comparisons of edges with the common box, and the search for a vertex in the other border.
//! Candidates are about √(n + m) times as many as edges where edges are of like length, and n·m at worst.
//!
//! *Sources*: K. Weiler and P. Atherton, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977, pp. 214–222,
//! doi:10.1145/563858.563896; G. Greiner and K. Hormann, "Efficient clipping of arbitrary polygons", ACM Transactions on Graphics
//! 17(2), 1998, pp. 71–83, doi:10.1145/274363.274364; E. L. Foster, K. Hormann and R. T. Popa, "Clipping simple polygons with degenerate
//! intersections", Computers & Graphics: X 2, 2019, 100007, doi:10.1016/j.cagx.2019.100007.
//!
//! ```
//! use clipscope::{algo::polygon::weiler_atherton::*, geom::{SimplePolygon, Window}, trace::silent};
//! // A "U" through whose arms the window cuts leaves two pieces.
//! let u = [[0.0, 0.0], [6.0, 0.0], [6.0, 4.0], [4.0, 4.0], [4.0, 2.0], [2.0, 2.0], [2.0, 4.0], [0.0, 4.0]];
//! let subject = SimplePolygon::new(&u)?.into();
//! let clip = Window::new(-1.0, 3.0, 7.0, 5.0)?.into();
//! let clipped = silent::<WeilerAtherton>(&WeilerAthertonInput { subject, clip });
//! assert_eq!(clipped.relation, Relation::Crossing);
//! let outer: Vec<Vec<[f64; 2]>> = clipped.pieces.iter()
//!     .map(|piece| piece.outer.iter().map(|p| p.to_array()).collect())
//!     .collect();
//! assert_eq!(outer, [
//!     [[6.0, 3.0], [6.0, 4.0], [4.0, 4.0], [4.0, 3.0]],
//!     [[2.0, 3.0], [2.0, 4.0], [0.0, 4.0], [0.0, 3.0]],
//! ]);
//! # Ok::<(), clipscope::geom::GeomError>(())
//! ```

mod event;
mod grid;
mod input;
mod labels;
mod lists;
mod meeting;
mod predicate;
mod rings;
mod side;
mod walk;
mod whole;

use crate::{
    geom::Rings,
    trace::{Method, Real, Tell, Told},
};

use rings::{owners, pieces};

pub use event::WeilerAthertonEvent;
pub use input::{List, WeilerAthertonInput};
pub use lists::{Entry, Intersection, LinkedLists};
pub use meeting::{Contact, Meeting};
pub use rings::{BorderRing, OutputPolygon, Relation, RingKind, WeilerAthertonOutput};
pub use side::{IntersectionLabel, Labelled, Side};
pub use walk::Walk;

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct WeilerAtherton;

/// What it works in: the two lists, the walk, and what the walks leave.
#[derive(Clone, PartialEq, Debug)]
pub struct WeilerAthertonHeld {
    /// Both lists, with the intersections that link them.
    pub lists: LinkedLists,
    /// Of the intersections, as far as they have one.
    pub labels: Vec<Labelled>,
    /// The walks, one after the other.
    pub walk: Walk,
    /// Closed rings.
    pub rings: Vec<BorderRing>,
    /// Numbers of a hole and of the ring that it lies in.
    owners: Vec<[u32; 2]>,
    relation: Relation,
}

impl Method for WeilerAtherton {
    type Input = WeilerAthertonInput;
    type Held = WeilerAthertonHeld;
    type Output = WeilerAthertonOutput;
    type Event = WeilerAthertonEvent;

    fn begin(input: &Self::Input) -> Self::Held {
        WeilerAthertonHeld {
            lists: LinkedLists::empty([input.subject.rings(), input.clip.rings()]),
            labels: Vec::new(),
            walk: Walk::default(),
            rings: Vec::new(),
            owners: Vec::new(),
            relation: Relation::Disjoint,
        }
    }

    fn run<R: Real, T: Tell<Self>>(
        input: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        let mut clipping = Clipping {
            borders: [input.subject.rings(), input.clip.rings()],
            held,
            tell,
        };
        clipping.find::<R>()?;
        clipping.insert::<R>()?;
        clipping.label::<R>()?;
        clipping.walk_all()?;
        let sides = clipping.whole_rings::<R>()?;
        for owner @ [hole_idx, outer_idx] in owners(&clipping.held.rings) {
            clipping.held.owners.push(owner);
            clipping.tell(WeilerAthertonEvent::Hole {
                hole_idx,
                outer_idx,
            })?;
        }
        let held = &mut *clipping.held;
        let relation = sides.relation(!held.rings.is_empty(), !held.labels.is_empty());
        held.relation = relation;
        held.walk.end();
        clipping.tell(WeilerAthertonEvent::Done { relation })
    }

    fn output(held: Self::Held) -> WeilerAthertonOutput {
        WeilerAthertonOutput {
            relation: held.relation,
            pieces: pieces(&held.rings, held.owners),
        }
    }

    /// With k intersections: both polygons' n vertices; each intersection found, inserted, labelled, a start and two switches; the n + 2k
    /// entries of both lists passed, as many rings closed; every ring as a whole, and as a hole; the end.
    fn max_events(input: &Self::Input) -> usize {
        let (subject, clip) = (input.subject.rings(), input.clip.rings());
        let [s, c] = [subject, clip].map(|rings| rings.points().len());
        let (n, k) = (s + c, s * c + s + c);
        n + 3 * k + 3 * k + 2 * (n + 2 * k) + 2 * (subject.n_rings() + 1) + 1
    }
}

struct Clipping<'a, T> {
    borders: [&'a Rings; 2],
    held: &'a mut WeilerAthertonHeld,
    tell: &'a mut T,
}

/// A stage of the work rests so many times at most: copies of the lists are large.
const MOST_RESTS: usize = 8;
/// Between two rests there is at least so much to do: short runs need none.
const FEWEST_BETWEEN_RESTS: usize = 1000;

impl<T: Tell<WeilerAtherton>> Clipping<'_, T> {
    #[inline]
    fn tell(&mut self, event: WeilerAthertonEvent) -> Told<T::Stop> {
        self.tell.tell(self.held, event)
    }

    /// At the head of a stage's loop, `n_done` of `n` times through.
    #[inline]
    fn rest(&mut self, n_done: usize, n: usize) {
        let stride = n.div_ceil(MOST_RESTS).max(FEWEST_BETWEEN_RESTS);
        if n_done > 0 && n_done.is_multiple_of(stride) {
            self.tell.rest(self.held);
        }
    }
}
