//! Far to near: what is painted later hides what was painted before.
//!
//! ```text
//!   eye ●      B        A     C              keys: the farthest vertex.  C 4.9 · A 4.1 · B 2.3
//!             ╱        ╱     ╱               painted in that order, unless one that comes later
//!            ╱        ╱     ╱                must come before: then that one first
//! ```
//!
//! 1. Sort by each triangle's key, how far its farthest vertex lies before the eye's plane, the largest first.
//! 2. The first that is not placed, P, asks all others that are not: may P come before you ([`PairTest`])? If all say yes, it is placed.
//! 3. If Q says no, Q asks in the same way, and P goes on when Q has been placed; if Q is waiting for P, a cycle is found.
//! 4. Paint what is placed, in that order, over everything.
//!
//! *Conventions*: as in [`PairTest`]; what is culled is left out. Two that pierce each other are a cycle of two. Of equal keys the higher id
//! is asked first. What lies deeper than any that follows needs not ask further. *Bound*: for each triangle its key, its place in the
//! list, a constraint, a placing, a place in the cycle, its painting; each ordered pair at most once; the end. *Cost*: the comparisons of
//! keys and extents, and the determinants of each pair ([`PairTest`]).
//!
//! *Source*: M. E. Newell, R. G. Newell and T. L. Sancha, "A solution to the hidden surface problem", Proceedings of the ACM Annual
//! Conference, 1972, pp. 443–450.
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

use std::{cmp::Ordering, marker::PhantomData};

use serde::Serialize;

use crate::{
    algo::ring::Right,
    trace::{Method, Real, Tell, Told},
};

use super::{PairTest, Picture, SurfaceRules, Surfaces, coverage::Rows, precedence::Occupant};
use PainterEvent as Event;

/// The algorithm; see the module. `L` are its rules.
#[derive(Clone, Copy, Debug)]
pub struct Painter<L = Right>(PhantomData<L>);

/// How many pairs have been asked, and by which test each was decided, in the order of [`PairTest::ALL`].
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct PairTally {
    /// Ordered pairs.
    pub pairs: u64,
    /// By each of the tests.
    pub decided: [u64; 5],
}

/// A run rests after so many pairs, which take about a millisecond, or so many triangles that have been painted.
const REST_EVERY: u64 = 1024;

/// What happens, in order.
#[derive(Clone, Copy, PartialEq, Debug, Serialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum PainterEvent {
    /// A triangle's depths.
    Key {
        /// Whose.
        id: u32,
        /// By which it is sorted.
        key: f64,
        /// Its nearest and its farthest vertex.
        depths: [f64; 2],
    },
    /// The next in the sorted list.
    Sort {
        /// Which.
        id: u32,
    },
    /// Another one is asked whether P may come before it.
    Pair {
        /// P
        id: u32,
        /// The one that is asked.
        other: u32,
        /// The test that decided.
        test: PairTest,
        /// May P come first?
        may: bool,
        /// So far.
        tally: PairTally,
    },
    /// One must come before another.
    Constraint {
        /// First this one.
        before: u32,
        /// Then this one.
        after: u32,
    },
    /// Nothing that is left must come before it: the next to be painted.
    Place {
        /// Which.
        id: u32,
    },
    /// The next of a cycle, in which each must come before the next.
    Cycle {
        /// Which.
        id: u32,
    },
    /// It is painted over everything.
    Paint {
        /// Which.
        id: u32,
    },
    /// Nothing is left to do.
    Done,
}

/// Is there an order?
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
#[serde(untagged)]
pub enum PainterAnswer {
    /// There is.
    Order {
        /// What comes of it.
        #[serde(rename = "ids")]
        picture: Picture,
        /// Ids, the one painted first first.
        order: Vec<u32>,
    },
    /// There is none.
    Cycle {
        /// Each must be painted before the next, and the last before the first. The smallest id stands first.
        cycle: Vec<u32>,
    },
}

/// The answer.
#[derive(Clone, PartialEq, Debug, Serialize)]
pub struct PainterOutput {
    /// Is there an order?
    #[serde(flatten)]
    pub answer: PainterAnswer,
    /// How bright each pixel is, row by row; empty where there is no order, or no surface has a tint.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub brightness: Vec<f64>,
    /// How many pairs were asked.
    #[serde(skip)]
    pub tally: PairTally,
}

/// What it works in.
#[derive(Clone, PartialEq, Debug)]
pub struct PainterHeld {
    /// Triangles with their keys, in the order of their ids; once they are sorted, the largest key first.
    pub list: Vec<(Occupant, f64)>,
    /// So many of the list stand where they belong.
    pub n_sorted: usize,
    /// The first of each must come before the second, as far as it has been found.
    pub constraints: Vec<[u32; 2]>,
    /// Ids of those that are placed, the one painted first first.
    pub placed: Vec<u32>,
    /// Each must be painted before the next, and the last before the first; empty where there is an order.
    pub cycle: Vec<u32>,
    /// What has been painted so far.
    pub picture: Picture,
    /// The same in brightness; empty where no surface has a tint.
    pub brightness: Vec<f64>,
    /// How many pairs have been asked so far.
    pub tally: PairTally,
    /// How many of the placed have been painted.
    n_painted: usize,
    progress: Vec<Progress>,
    /// Those that wait, each for the next, and whom each asks next.
    waiting: Vec<(usize, usize)>,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Progress {
    Untouched,
    Waiting,
    Placed,
}

impl<L: SurfaceRules> Method for Painter<L> {
    type Input = Surfaces;
    type Held = PainterHeld;
    type Output = PainterOutput;
    type Event = Event;

    fn begin(surfaces: &Self::Input) -> Self::Held {
        PainterHeld {
            list: Vec::new(),
            n_sorted: 0,
            constraints: Vec::new(),
            placed: Vec::new(),
            cycle: Vec::new(),
            picture: Picture::empty(surfaces.size()),
            brightness: surfaces.paper(),
            tally: PairTally::default(),
            n_painted: 0,
            progress: Vec::new(),
            waiting: Vec::new(),
        }
    }

    fn run<R: Real, T: Tell<Self>>(
        surfaces: &Self::Input,
        held: &mut Self::Held,
        tell: &mut T,
    ) -> Told<T::Stop> {
        if held.progress.is_empty() {
            sort::<L, R, T>(surfaces, held, tell)?;
            held.progress = vec![Progress::Untouched; held.list.len()];
        }
        let mut rested_at = held.tally.pairs;
        for first in 0..held.list.len() {
            if held.waiting.is_empty() && held.progress[first] == Progress::Untouched {
                held.waiting.push((first, 0));
                held.progress[first] = Progress::Waiting;
            }
            place::<L, R, T>(surfaces, held, &mut rested_at, tell)?;
            if !held.cycle.is_empty() {
                return tell.tell(held, Event::Done);
            }
        }
        while let Some(&id) = held.placed.get(held.n_painted) {
            if (held.n_painted as u64).is_multiple_of(REST_EVERY) {
                tell.rest(held);
            }
            let rows = Rows::of(surfaces, id);
            rows.paint(&mut held.picture, id);
            if let Some(tint) = surfaces.tint(id) {
                rows.paint_over::<R>(&mut held.brightness, surfaces.size()[0], tint);
            }
            held.n_painted += 1;
            tell.tell(held, Event::Paint { id })?;
        }
        tell.tell(held, Event::Done)
    }

    fn output(held: Self::Held) -> Self::Output {
        let (answer, brightness) = if held.cycle.is_empty() {
            let (order, picture) = (held.placed, held.picture);
            let answer = PainterAnswer::Order { picture, order };
            (answer, held.brightness)
        } else {
            let cycle = held.cycle;
            (PainterAnswer::Cycle { cycle }, Vec::new())
        };
        PainterOutput {
            answer,
            brightness,
            tally: held.tally,
        }
    }

    fn max_events(surfaces: &Self::Input) -> usize {
        let n = surfaces.triangles().len();
        1 + 6 * n + n * n.saturating_sub(1)
    }
}

/// The list, the largest key first.
fn sort<L: SurfaceRules, R: Real, T: Tell<Painter<L>>>(
    surfaces: &Surfaces,
    held: &mut PainterHeld,
    tell: &mut T,
) -> Told<T::Stop> {
    for (id, corners) in surfaces.ids().zip(surfaces.triangles()) {
        if surfaces.culls_backs() && !surfaces.shows(corners) {
            continue;
        }
        let occupant = Occupant::new::<R>(surfaces, id, *corners);
        let depths = occupant.depths();
        let key = depths[usize::from(!L::SORTS_BY_NEAREST)];
        held.list.push((occupant, key));
        tell.tell(held, Event::Key { id, key, depths })?;
    }
    held.list.sort_by(|(one, key), (other, other_key)| {
        let by_key = R::new(*other_key).partial_cmp(&R::new(*key));
        let by_id = other.id.cmp(&one.id);
        by_key.unwrap_or(Ordering::Equal).then(by_id)
    });
    for i in 0..held.list.len() {
        held.n_sorted = i + 1;
        let id = held.list[i].0.id;
        tell.tell(held, Event::Sort { id })?;
    }
    Told::Continue(())
}

/// Places those that wait, and whatever must come before them, or finds a cycle.
fn place<L: SurfaceRules, R: Real, T: Tell<Painter<L>>>(
    surfaces: &Surfaces,
    held: &mut PainterHeld,
    rested_at: &mut u64,
    tell: &mut T,
) -> Told<T::Stop> {
    while let Some(&(p, _)) = held.waiting.last() {
        if held.tally.pairs - *rested_at >= REST_EVERY {
            *rested_at = held.tally.pairs;
            tell.rest(held);
        }
        let objector = if L::KEYS_ONLY {
            None
        } else {
            objector::<L, R, T>(surfaces, held, tell)?
        };
        let Some(q) = objector else {
            held.waiting.pop();
            held.progress[p] = Progress::Placed;
            let id = held.list[p].0.id;
            held.placed.push(id);
            tell.tell(held, Event::Place { id })?;
            continue;
        };
        let [before, after] = [q, p].map(|i| held.list[i].0.id);
        held.constraints.push([before, after]);
        tell.tell(held, Event::Constraint { before, after })?;
        if held.progress[q] == Progress::Waiting {
            let cycle = cycle(held, q);
            for id in cycle {
                held.cycle.push(id);
                tell.tell(held, Event::Cycle { id })?;
            }
            return Told::Continue(());
        }
        held.progress[q] = Progress::Waiting;
        held.waiting.push((q, 0));
    }
    Told::Continue(())
}

/// The next that must come before the one that waits last.
fn objector<L: SurfaceRules, R: Real, T: Tell<Painter<L>>>(
    surfaces: &Surfaces,
    held: &mut PainterHeld,
    tell: &mut T,
) -> Told<T::Stop, Option<usize>> {
    let Some(&(p, from)) = held.waiting.last() else {
        return Told::Continue(None);
    };
    let n = held.list.len();
    let mut next = from;
    while next < n {
        let q = next;
        next += 1;
        if q == p || held.progress[q] == Progress::Placed {
            continue;
        }
        let (one, other) = (&held.list[p].0, &held.list[q].0);
        let (may, test) = one.may_precede::<R>(other, surfaces);
        let [id, other] = [one.id, other.id];
        if test == PairTest::DepthExtents {
            // All that follow are nearer still.
            next = n;
        }
        held.tally.pairs += 1;
        let tests = PairTest::ALL.iter().zip(&mut held.tally.decided);
        for (_, decided) in tests.filter(|(known, _)| **known == test) {
            *decided += 1;
        }
        // A run that is stopped where Q lets P pass goes on from here.
        if let Some((_, from)) = held.waiting.last_mut() {
            *from = next;
        }
        let event = Event::Pair {
            id,
            other,
            test,
            may,
            tally: held.tally,
        };
        tell.tell(held, event)?;
        if !may {
            return Told::Continue(Some(q));
        }
    }
    Told::Continue(None)
}

/// Each is painted before the one that waits for it; q waits for itself.
fn cycle(held: &PainterHeld, q: usize) -> Vec<u32> {
    let since_q = held.waiting.iter().skip_while(|(i, _)| *i != q);
    let mut cycle: Vec<u32> = since_q.map(|&(i, _)| held.list[i].0.id).collect();
    cycle.reverse();
    let smallest = cycle.iter().enumerate().min_by_key(|(_, id)| **id);
    let turn = smallest.map_or(0, |(i, _)| i);
    cycle.rotate_left(turn);
    cycle
}
