//! What the painter comes past.

use serde::Serialize;

use super::PairTest;

/// How many pairs have been asked, and by which test each was decided, in the order of [`PairTest::ALL`].
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct PairTally {
    /// Ordered pairs.
    pub pairs: u64,
    /// By each of the tests.
    pub decided: [u64; 5],
}

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
