//! The search for an order in which everything that must come before something does.

use crate::trace::Real;

use super::{PainterEvent, PairTally, PairTest, SurfaceRules, Surfaces, precedence::Occupant};

#[derive(Clone, Copy, PartialEq, Eq)]
enum Progress {
    Untouched,
    Waiting,
    Placed,
}

/// How far it has come.
pub(super) struct Search<'a> {
    surfaces: &'a Surfaces,
    /// The largest key first.
    sorted: &'a [Occupant],
    progress: Vec<Progress>,
    /// Ids, the one painted first first.
    pub placed: Vec<u32>,
    pub tally: PairTally,
}

impl<'a> Search<'a> {
    pub fn new(surfaces: &'a Surfaces, sorted: &'a [Occupant]) -> Self {
        Self {
            surfaces,
            sorted,
            progress: vec![Progress::Untouched; sorted.len()],
            placed: Vec::with_capacity(sorted.len()),
            tally: PairTally::default(),
        }
    }

    /// Places all, or finds a cycle.
    pub fn all<L: SurfaceRules, R: Real>(
        &mut self,
        emit: &mut impl FnMut(PainterEvent),
    ) -> Option<Vec<u32>> {
        (0..self.sorted.len()).find_map(|first| {
            if self.progress[first] == Progress::Placed {
                return None;
            }
            self.from::<L, R>(first, emit)
        })
    }

    /// Places one, and before it what must come before it.
    fn from<L: SurfaceRules, R: Real>(
        &mut self,
        first: usize,
        emit: &mut impl FnMut(PainterEvent),
    ) -> Option<Vec<u32>> {
        // Those that wait, each for the next, and whom each asks next.
        let mut waiting = vec![(first, 0)];
        self.progress[first] = Progress::Waiting;
        while let Some(&mut (p, ref mut next)) = waiting.last_mut() {
            let objector = if L::KEYS_ONLY {
                None
            } else {
                self.objector::<R>(p, next, emit)
            };
            let Some(q) = objector else {
                waiting.pop();
                self.progress[p] = Progress::Placed;
                let id = self.sorted[p].id;
                self.placed.push(id);
                emit(PainterEvent::Place { id });
                continue;
            };
            let [before, after] = [q, p].map(|i| self.sorted[i].id);
            emit(PainterEvent::Constraint { before, after });
            if self.progress[q] == Progress::Waiting {
                return Some(self.cycle(&waiting, q));
            }
            self.progress[q] = Progress::Waiting;
            waiting.push((q, 0));
        }
        None
    }

    /// The next that must come before p, from `next` on.
    fn objector<R: Real>(
        &mut self,
        p: usize,
        next: &mut usize,
        emit: &mut impl FnMut(PainterEvent),
    ) -> Option<usize> {
        while *next < self.sorted.len() {
            let q = *next;
            *next += 1;
            if q == p || self.progress[q] == Progress::Placed {
                continue;
            }
            let (one, other) = (&self.sorted[p], &self.sorted[q]);
            let (may, test) = one.may_precede::<R>(other, self.surfaces);
            self.tally.pairs += 1;
            let tests = PairTest::ALL.iter().zip(&mut self.tally.decided);
            for (_, decided) in tests.filter(|(known, _)| **known == test) {
                *decided += 1;
            }
            emit(PainterEvent::Pair {
                id: one.id,
                other: other.id,
                test,
                may,
                tally: self.tally,
            });
            if !may {
                return Some(q);
            }
            if test == PairTest::DepthExtents {
                // All that follow are nearer still.
                *next = self.sorted.len();
            }
        }
        None
    }

    /// `waiting` wait each for the next; the last one waits for q, which is one of them. Each is painted before the one that
    /// waits for it.
    fn cycle(&self, waiting: &[(usize, usize)], q: usize) -> Vec<u32> {
        let since_q = waiting.iter().skip_while(|(i, _)| *i != q);
        let mut cycle: Vec<u32> = since_q.map(|&(i, _)| self.sorted[i].id).collect();
        cycle.reverse();
        let smallest = cycle.iter().enumerate().min_by_key(|(_, id)| **id);
        let turn = smallest.map_or(0, |(i, _)| i);
        cycle.rotate_left(turn);
        cycle
    }
}
