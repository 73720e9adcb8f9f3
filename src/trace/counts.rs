//! Operation counts, taken from the run itself.

use std::{
    cell::Cell,
    cmp::Ordering,
    iter::Sum,
    ops::{Add, Div, Mul, Neg, Sub},
};

use serde::Serialize;

use crate::geom::{Wide, times_power};

/// The scalar that an algorithm computes with: `f64` in production, [`Counted`] when its cost is asked, [`Wide`] where a number has
/// turned out to leave the range of `f64`.
pub trait Real:
    Copy
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// From a coordinate.
    fn new(x: f64) -> Self;
    /// The number itself, for events and for guards that are not part of the algorithm.
    fn get(self) -> f64;
}

impl Real for f64 {
    #[inline]
    fn new(x: f64) -> Self {
        x
    }
    #[inline]
    fn get(self) -> f64 {
        self
    }
}

impl Real for Wide {
    fn new(x: f64) -> Self {
        Self::new(x)
    }
    fn get(self) -> f64 {
        self.get()
    }
}

/// Of what has been worked out already, all but the division, which is counted.
#[must_use]
pub fn wide_quotient<R: Real>(num: Wide, den: Wide) -> R {
    let ((num, by), (den, own)) = (num.parts(), den.parts());
    let quotient = R::new(num) / R::new(den);
    let [quotient] = times_power([quotient.get()], by - own);
    R::new(quotient)
}

/// How many operations of each kind a run has done.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize)]
pub struct Counts {
    /// Additions and subtractions.
    pub add: u64,
    /// Multiplications.
    pub mul: u64,
    /// Divisions.
    pub div: u64,
    /// Comparisons of numbers.
    pub cmp: u64,
}

impl Counts {
    const ZERO: Self = Self {
        add: 0,
        mul: 0,
        div: 0,
        cmp: 0,
    };

    /// Operations of any kind.
    #[must_use]
    pub const fn total(&self) -> u64 {
        self.add + self.mul + self.div + self.cmp
    }

    /// What `work` counts on this thread, and its result.
    pub fn of<T>(work: impl FnOnce() -> T) -> (T, Self) {
        let outer = TALLY.with(|tally| tally.replace(Self::ZERO));
        let result = work();
        (result, TALLY.with(|tally| tally.replace(outer)))
    }

    /// What the innermost [`Counts::of`] on this thread has counted up to now.
    #[must_use]
    pub fn so_far() -> Self {
        TALLY.with(Tally::get)
    }
}

impl Add for Counts {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            add: self.add + other.add,
            mul: self.mul + other.mul,
            div: self.div + other.div,
            cmp: self.cmp + other.cmp,
        }
    }
}

impl Sum for Counts {
    fn sum<I: Iterator<Item = Self>>(iter: I) -> Self {
        iter.fold(Self::ZERO, Add::add)
    }
}

/// What has been counted on a thread: each number by itself, so that an operation touches one of them.
struct Tally {
    add: Cell<u64>,
    mul: Cell<u64>,
    div: Cell<u64>,
    cmp: Cell<u64>,
}

impl Tally {
    fn get(&self) -> Counts {
        Counts {
            add: self.add.get(),
            mul: self.mul.get(),
            div: self.div.get(),
            cmp: self.cmp.get(),
        }
    }

    fn replace(&self, counts: Counts) -> Counts {
        Counts {
            add: self.add.replace(counts.add),
            mul: self.mul.replace(counts.mul),
            div: self.div.replace(counts.div),
            cmp: self.cmp.replace(counts.cmp),
        }
    }
}

thread_local! {
    static TALLY: Tally = const {
        Tally {
            add: Cell::new(0),
            mul: Cell::new(0),
            div: Cell::new(0),
            cmp: Cell::new(0),
        }
    };
}

#[inline(always)]
fn count(field: impl FnOnce(&Tally) -> &Cell<u64>) {
    TALLY.with(|tally| field(tally).update(|n| n + 1));
}

/// An `f64` whose every operation is counted on this thread. Negation changes a sign bit and is free.
#[derive(Clone, Copy, Debug)]
pub struct Counted(f64);

impl Real for Counted {
    #[inline(always)]
    fn new(x: f64) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn get(self) -> f64 {
        self.0
    }
}

macro_rules! counted_operator {
    ($operator:ident, $method:ident, $field:ident) => {
        impl $operator for Counted {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                count(|tally| &tally.$field);
                Self(self.0.$method(other.0))
            }
        }
    };
}
counted_operator!(Add, add, add);
counted_operator!(Sub, sub, add);
counted_operator!(Mul, mul, mul);
counted_operator!(Div, div, div);

impl Neg for Counted {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl PartialEq for Counted {
    #[inline(always)]
    fn eq(&self, other: &Self) -> bool {
        count(|tally| &tally.cmp);
        self.0 == other.0
    }
}

impl PartialOrd for Counted {
    #[inline(always)]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        count(|tally| &tally.cmp);
        self.0.partial_cmp(&other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operator_counts_once() {
        let [a, b] = [1.0, 2.0].map(Counted::new);
        let (result, counts) = Counts::of(|| {
            let less = a < b;
            let same = a == b;
            ((a + b - a) * b / -a, less, same)
        });
        assert_eq!((result.0.get(), result.1, result.2), (-4.0, true, false));
        let Counts { add, mul, div, cmp } = counts;
        assert_eq!([add, mul, div, cmp], [2, 1, 1, 2]);
    }

    #[test]
    fn more_than_four_thousand_million_are_counted() {
        let large = Counts {
            cmp: u64::from(u32::MAX),
            ..Counts::default()
        };
        let (_, counts) = Counts::of(|| {
            TALLY.with(|tally| tally.replace(large));
            Counted::new(1.0) < Counted::new(2.0)
        });
        assert_eq!(counts.cmp, 4_294_967_296);
        let sum: Counts = [counts, large].into_iter().sum();
        assert_eq!(sum.cmp, 8_589_934_591);
    }

    #[test]
    fn an_inner_count_leaves_the_outer_one_alone() {
        let one = Counted::new(1.0);
        let (_, outer) = Counts::of(|| {
            let sum = one + one;
            let (_, inner) = Counts::of(|| one * one);
            assert_eq!(inner.mul, 1);
            sum
        });
        assert_eq!((outer.add, outer.mul), (1, 0));
    }
}
