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
//! 1. Find where the edges meet (`meeting`, candidates by `grid`), and put the intersections into both lists in
//!    order (`lists`).
//! 2. Label each *entering*, *leaving*, *touching* or *pinching* (`labels`).
//! 3. Walk (`walk`); borders that change no lists are inside or outside as a whole.
//! 4. Give each hole to the piece that it lies in (`rings`).
//!
//! The textbook form asks for general position. This one is right for every input, because each decision is the
//! sign of an exact determinant of three given vertices: which edges meet and how, in what order along an edge,
//! and what a border does at an intersection. Only crossings are computed, and nothing is asked of them.
//!
//! *Conventions*: closed regions; interiors to the left of every border, so outer rings run counter-clockwise
//! and holes clockwise. The answer is the closure of the common interior: common points and common edges with no
//! area on either side are not polygons, and [`Relation`] tells of them. Each piece has a connected interior and
//! simple rings: where borders only touch in a point, rings are cut there. A crossing is the same point bit for
//! bit whichever way its edges run and whichever polygon is the subject; a vertex stays as given. *Degenerate*:
//! vertices on edges and on vertices, shared edges in either direction and identical polygons are labelled on
//! the spot (`labels`). A piece so thin that its rounded corners have no area is left out
//! ([`RingKind::Sliver`]). *Bound*: at most n·m + n + m intersections; walks take at most as many steps as both
//! lists have entries. *Cost*: O(n + m + k log k) and the tests of the grid's candidates, about √(n + m) times as
//! many as edges where edges are of like length, and n·m at worst.
//!
//! *Sources*: K. Weiler and P. Atherton, "Hidden surface removal using polygon area sorting", SIGGRAPH 1977,
//! pp. 214–222, doi:10.1145/563858.563896; G. Greiner and K. Hormann, "Efficient clipping of arbitrary polygons",
//! ACM Transactions on Graphics 17(2), 1998, pp. 71–83, doi:10.1145/274363.274364; E. L. Foster, K. Hormann and
//! R. T. Popa, "Clipping simple polygons with degenerate intersections", Computers & Graphics: X 2, 2019, 100007,
//! doi:10.1016/j.cagx.2019.100007.
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

mod answer;
mod event;
mod grid;
mod input;
mod labels;
mod lists;
mod meeting;
mod predicate;
mod rings;
mod side;
mod state;
mod walk;

use crate::{
    geom::{Location, Rings},
    trace::{Algorithm, Real},
};

use labels::label;
use lists::{LinkedLists, NONE};
use rings::{BorderRing, owners, pieces};
use walk::{Walker, kind, whole_ring, whole_ring_bounds};

pub use answer::{OutputPolygon, Relation, WeilerAthertonOutput};
pub use event::WeilerAthertonEvent;
pub use input::{List, WeilerAthertonInput};
pub use meeting::Contact;
pub use rings::RingKind;
pub use side::{IntersectionLabel, Labelled, Side};
pub use state::{ListEntry, ListNode, NodeLabel, Passed, StateRing, WeilerAthertonState};

/// The algorithm; see the module.
#[derive(Clone, Copy, Debug)]
pub struct WeilerAtherton;

impl Algorithm for WeilerAtherton {
    type Input = WeilerAthertonInput;
    type Output = WeilerAthertonOutput;
    type Event = WeilerAthertonEvent;
    type State = WeilerAthertonState;

    fn run<R: Real>(
        input: &Self::Input,
        mut emit: impl FnMut(Self::Event),
    ) -> WeilerAthertonOutput {
        let (subject, clip) = (input.subject.rings(), input.clip.rings());
        let lists = LinkedLists::build::<R>(subject, clip, &mut emit);
        let labels = label::<R>(subject, clip, &lists, &mut emit);
        let mut walker = Walker::new([subject, clip], &lists, &labels);
        walker.walk_all(&mut emit);
        let mut rings = walker.rings;
        let mut sides = Sides::of(&labels);
        for list in [List::Subject, List::Clip] {
            whole_rings(
                list,
                input,
                (&lists, &labels),
                &mut rings,
                &mut sides,
                &mut emit,
            );
        }
        let owners = owners(&rings);
        for &[hole_idx, outer_idx] in &owners {
            emit(Self::Event::Hole {
                hole_idx,
                outer_idx,
            });
        }
        let relation = sides.relation(!rings.is_empty(), !labels.is_empty());
        emit(Self::Event::Done { relation });
        let rings = rings.iter().map(|ring| (&ring.points[..], ring.kind));
        WeilerAthertonOutput {
            relation,
            pieces: pieces(rings, owners),
        }
    }

    fn start(_: &Self::Input) -> Self::State {
        WeilerAthertonState::default()
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        state.apply(event);
    }

    fn finish(state: &Self::State) -> WeilerAthertonOutput {
        state.finish()
    }

    /// With k intersections: a vertex for each of both polygons' n; each intersection found, inserted and
    /// labelled; a start and two switches for each at most; the n + 2k entries of both lists passed; as each ring
    /// takes an entry, so many closed; every ring of both polygons as a whole, and as a hole; the end.
    fn max_events(input: &Self::Input) -> usize {
        let (subject, clip) = (input.subject.rings(), input.clip.rings());
        let [s, c] = [subject, clip].map(|rings| rings.points().len());
        let (n, k) = (s + c, s * c + s + c);
        n + 3 * k + 3 * k + 2 * (n + 2 * k) + 2 * (subject.n_rings() + 1) + 1
    }
}

/// Where the parts of both borders lie, by the other polygon: all that [`Relation`] asks.
#[derive(Default)]
struct Sides {
    subject_inside: bool,
    subject_outside: bool,
    clip_outside: bool,
}

impl Sides {
    fn of(labels: &[Labelled]) -> Self {
        let mut sides = Self::default();
        for labelled in labels {
            for side in labelled.subject {
                sides.add(List::Subject, side);
            }
            for side in labelled.clip {
                sides.add(List::Clip, side);
            }
        }
        sides
    }

    fn add(&mut self, list: List, side: Side) {
        let outside = matches!(side, Side::Outside | Side::Against);
        match list {
            List::Subject => {
                self.subject_inside |= side == Side::Inside;
                self.subject_outside |= outside;
            }
            List::Clip => self.clip_outside |= outside,
        }
    }

    fn relation(&self, common_area: bool, common_points: bool) -> Relation {
        if !common_area {
            return if common_points {
                Relation::Touching
            } else {
                Relation::Disjoint
            };
        }
        match (
            self.subject_outside,
            self.clip_outside || self.subject_inside,
        ) {
            (false, false) => Relation::Equal,
            (false, true) => Relation::SubjectInside,
            (true, false) => Relation::ClipInside,
            (true, true) => Relation::Crossing,
        }
    }
}

/// Rings of one polygon that the walk cannot reach: where nothing crosses them, they bound the result all along
/// or nowhere. One of their intersections tells, or where they have none, one of their vertices.
fn whole_rings(
    list: List,
    input: &WeilerAthertonInput,
    (lists, labels): (&LinkedLists, &[Labelled]),
    rings: &mut Vec<BorderRing>,
    sides: &mut Sides,
    emit: &mut impl FnMut(WeilerAthertonEvent),
) {
    let borders: &Rings = match list {
        List::Subject => input.subject.rings(),
        List::Clip => input.clip.rings(),
    };
    for ring_idx in 0..borders.n_rings() {
        let starts = &lists.starts[list.idx()];
        let places = [starts[ring_idx], starts[ring_idx + 1]];
        let entries = &lists.entries[list.idx()][places[0] as usize..places[1] as usize];
        let mut nodes = entries.iter().filter(|entry| entry.node != NONE);
        let labelled = |node: u32| &labels[node as usize];
        if nodes
            .clone()
            .any(|entry| labelled(entry.node).label != IntersectionLabel::Touching)
        {
            continue;
        }
        let first = nodes.next().map(|entry| labelled(entry.node));
        let side = first.map_or_else(
            || {
                let at = borders.ring(ring_idx)[0];
                let location = match list {
                    List::Subject => input.clip.locate(at),
                    List::Clip => input.subject.locate(at),
                };
                let side = if location == Location::Outside {
                    Side::Outside
                } else {
                    Side::Inside
                };
                sides.add(list, side);
                side
            },
            |labelled| match list {
                List::Subject => labelled.subject[1],
                List::Clip => labelled.clip[1],
            },
        );
        let is_hole = list == List::Subject && ring_idx > 0;
        let ring = whole_ring_bounds(list, side).then(|| {
            let points = whole_ring(entries, borders, lists, labels);
            let kind = kind(&points, is_hole);
            BorderRing { points, kind }
        });
        emit(WeilerAthertonEvent::Whole {
            list,
            ring_idx: ring_idx as u32,
            places,
            side,
            kind: ring.as_ref().map(|ring| ring.kind),
        });
        rings.extend(ring);
    }
}
