//! Far to near: what is painted later hides what was painted before.
//!
//! ```text
//!   eye ●      B        A     C              keys: the farthest vertex.  C 4.9 · A 4.1 · B 2.3
//!             ╱        ╱     ╱               painted in that order, unless one that comes later
//!            ╱        ╱     ╱                must come before: then that one first
//! ```
//!
//! 1. Each triangle's key: how far its farthest vertex lies before the eye's plane. Sort, the largest first.
//! 2. The first that is not placed, P, asks all others that are not: may P come before you ([`PairTest`])? If all say yes, P is placed.
//! 3. If Q says no, Q must come before P: Q asks in the same way, and P goes on when Q has been placed.
//! 4. If Q itself is waiting for P, there is no order: a cycle is found.
//! 5. Paint what is placed, in that order, over everything.
//!
//! *Conventions*: as in [`PairTest`]; triangles that are culled are left out, those that cover no pixel are not. Two that pierce each other are a cycle of two. Of
//! equal keys the higher id is asked first. What lies deeper than any that follows in the list needs not ask further.
//! *Bound*: for each triangle its key, its place in the list, its turn to be painted; each ordered pair
//! at most once; a constraint, a placing and a place in the cycle for each triangle; the end. *Cost*: of the comparisons of keys and extents; the exact
//! signs of determinants, up to some forty a pair, are not counted.
//!
//! *Source*: M. E. Newell, R. G. Newell and T. L. Sancha, "A solution to the hidden surface problem", Proceedings of the ACM
//! Annual Conference, 1972, pp. 443–450.
//!
//! ```
//! use clipscope::{
//!     algo::surface::{Painter, PainterAnswer, Surfaces},
//!     geom::ViewVolume,
//!     trace::silent,
//! };
//! let volume = ViewVolume::perspective(90.0, 1.0, 1.0, 10.0)?;
//! let wall = |z: f64| [[-20.0, -20.0, z], [20.0, -20.0, z], [0.0, 40.0, z]];
//! let surfaces = Surfaces::new([2, 2], volume, [wall(-5.0), wall(-2.0), wall(-9.0)], false).expect("finite");
//! let PainterAnswer::Order { order, picture } = silent::<Painter>(&surfaces).answer else {
//!     panic!("there is an order");
//! };
//! assert_eq!(order, [2, 0, 1]);
//! assert_eq!(picture.ids(), [1, 1, 1, 1]);
//! # Ok::<(), clipscope::geom::SpaceError>(())
//! ```

use std::{cmp::Ordering, marker::PhantomData, sync::Arc};

use crate::{
    algo::ring::Right,
    trace::{Algorithm, Real},
};

use super::{
    PainterEvent, PairTally, PairTest, Picture, SurfaceRules, Surfaces, coverage::Rows,
    painting_order::Search, precedence::Occupant,
};

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct Painter<L = Right>(PhantomData<L>);

/// Is there an order?
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum PainterAnswer {
    /// There is.
    Order {
        /// Ids, the one painted first first.
        order: Vec<u32>,
        /// What comes of it.
        picture: Picture,
    },
    /// There is none.
    Cycle {
        /// Each must be painted before the next, and the last before the first. The smallest id stands first.
        cycle: Vec<u32>,
    },
}

/// The answer.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct PainterOutput {
    /// Is there an order?
    pub answer: PainterAnswer,
    /// How many pairs were asked.
    pub tally: PairTally,
}

/// What the picture of a step needs.
#[derive(Clone, PartialEq, Debug)]
pub struct PainterState {
    /// The key, and the nearest and the farthest vertex, of each triangle so far.
    pub keys: Vec<(u32, f64, [f64; 2])>,
    /// The sorted list so far.
    pub sorted: Vec<u32>,
    /// P, the one that was asked, the test that decided, and the answer.
    pub pair: Option<(u32, u32, PairTest, bool)>,
    /// The first of each must come before the second, as far as it has been found.
    pub constraints: Vec<[u32; 2]>,
    /// Those that are placed, the one painted first first.
    pub placed: Vec<u32>,
    /// The cycle, where there is one.
    pub cycle: Vec<u32>,
    /// What has been painted so far.
    pub picture: Picture,
    /// The one that is painted.
    pub painting: Option<u32>,
    /// How many pairs have been asked so far.
    pub tally: PairTally,
    /// Is nothing left to do?
    pub is_done: bool,
    /// What each covers.
    rows: Arc<[Rows]>,
}

impl<L: SurfaceRules> Algorithm for Painter<L> {
    type Input = Surfaces;
    type Output = PainterOutput;
    type Event = PainterEvent;
    type State = PainterState;

    fn run<R: Real>(surfaces: &Self::Input, mut emit: impl FnMut(Self::Event)) -> Self::Output {
        use PainterEvent as Event;
        let mut sorted: Vec<(Occupant, f64)> = Vec::new();
        for (id, corners) in surfaces.ids().zip(surfaces.triangles()) {
            if surfaces.culls_backs() && !surfaces.shows(corners) {
                continue;
            }
            let occupant = Occupant::new(surfaces, id, *corners);
            let depths = occupant.depths();
            let key = depths[usize::from(!L::SORTS_BY_NEAREST)];
            emit(Event::Key { id, key, depths });
            sorted.push((occupant, key));
        }
        sorted.sort_by(|(one, key), (other, other_key)| {
            let by_key = R::new(*other_key).partial_cmp(&R::new(*key));
            let by_id = other.id.cmp(&one.id);
            by_key.unwrap_or(Ordering::Equal).then(by_id)
        });
        let sorted: Vec<Occupant> = sorted.into_iter().map(|(occupant, _)| occupant).collect();
        for occupant in &sorted {
            emit(Event::Sort { id: occupant.id });
        }
        let mut search = Search::new(surfaces, &sorted);
        let cycle = search.all::<L, R>(&mut emit);
        let (order, tally) = (search.placed, search.tally);
        let answer = if let Some(cycle) = cycle {
            for &id in &cycle {
                emit(Event::Cycle { id });
            }
            PainterAnswer::Cycle { cycle }
        } else {
            let mut picture = Picture::empty(surfaces.size());
            for &id in &order {
                Rows::of(surfaces, id).paint(&mut picture, id);
                emit(Event::Paint { id });
            }
            PainterAnswer::Order { order, picture }
        };
        emit(Event::Done);
        PainterOutput { answer, tally }
    }

    fn start(surfaces: &Self::Input) -> Self::State {
        PainterState {
            keys: Vec::new(),
            sorted: Vec::new(),
            pair: None,
            constraints: Vec::new(),
            placed: Vec::new(),
            cycle: Vec::new(),
            picture: Picture::empty(surfaces.size()),
            painting: None,
            tally: PairTally::default(),
            is_done: false,
            rows: surfaces.ids().map(|id| Rows::of(surfaces, id)).collect(),
        }
    }

    fn apply(state: &mut Self::State, event: Self::Event) {
        use PainterEvent as Event;
        match event {
            Event::Key { id, key, depths } => state.keys.push((id, key, depths)),
            Event::Sort { id } => state.sorted.push(id),
            Event::Pair {
                id,
                other,
                test,
                may,
                tally,
            } => {
                state.pair = Some((id, other, test, may));
                state.tally = tally;
            }
            Event::Constraint { before, after } => state.constraints.push([before, after]),
            Event::Place { id } => {
                state.pair = None;
                state.placed.push(id);
            }
            Event::Cycle { id } => state.cycle.push(id),
            Event::Paint { id } => {
                state.painting = Some(id);
                if let Some(rows) = state.rows.get(id as usize) {
                    rows.paint(&mut state.picture, id);
                }
            }
            Event::Done => {
                (state.pair, state.painting) = (None, None);
                state.is_done = true;
            }
        }
    }

    fn finish(state: &Self::State) -> Self::Output {
        let answer = if state.cycle.is_empty() {
            PainterAnswer::Order {
                order: state.placed.clone(),
                picture: state.picture.clone(),
            }
        } else {
            PainterAnswer::Cycle {
                cycle: state.cycle.clone(),
            }
        };
        PainterOutput {
            answer,
            tally: state.tally,
        }
    }

    /// Key, place in the list, constraint, placing, place in a cycle and painting of each; each ordered pair; the end. A constraint leads to
    /// another triangle that asks, or ends everything.
    fn max_events(surfaces: &Self::Input) -> usize {
        let n = surfaces.triangles().len();
        1 + 6 * n + n * n.saturating_sub(1)
    }
}
