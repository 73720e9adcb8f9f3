//! Cases and answers, joined by their ids; where a case has none, by their order.
//!
//! Both are read in step. What has not found its other half waits, and only so many wait: an answer may come that much before or
//! after its place, however long the streams are.

use std::collections::{BTreeMap, HashMap, VecDeque};

use rustc_hash::FxBuildHasher;

use crate::case::Id;

use super::{answer::Answer, tally::Tally, truth::Known};

/// So many cases, and so many answers, wait at most.
const MOST_WAITING: usize = 100_000;

/// Answers that wait take no more room than this.
const MOST_BYTES: usize = 256 << 20;

/// Lines that are no answers and say not whose they are: more are counted.
const MOST_NOISE: usize = 10_000;

type NextOf<'a, T, E> = &'a mut dyn FnMut() -> Result<Option<T>, E>;

/// Joins all cases with all answers, and tells `tally` of each.
pub(super) fn join<E>(
    tally: &mut Tally,
    next_case: NextOf<'_, Known, E>,
    next_answer: NextOf<'_, Answer, E>,
) -> Result<(), E> {
    let mut join = Join {
        tally,
        cases: Waiting::default(),
        answers: Waiting::default(),
        noise: BTreeMap::new(),
        n_answers: 0,
        cases_are_out: false,
        answers_are_out: false,
    };
    while join.step(next_case, next_answer)? {}
    join.finish();
    Ok(())
}

struct Join<'t> {
    tally: &'t mut Tally,
    cases: Waiting<Known>,
    answers: Waiting<Answer>,
    /// Lines that are no answers, by their place.
    noise: BTreeMap<usize, Answer>,
    n_answers: usize,
    cases_are_out: bool,
    answers_are_out: bool,
}

impl Join<'_> {
    /// Reads a case or an answer; false where there is neither.
    fn step<E>(
        &mut self,
        next_case: NextOf<'_, Known, E>,
        next_answer: NextOf<'_, Answer, E>,
    ) -> Result<bool, E> {
        let is_full = self.cases.len() >= MOST_WAITING;
        let is_due = self.tally.n_cases() <= self.n_answers || self.answers.len() > 0;
        let wants_case = self.answers_are_out || (is_due && !is_full);
        if wants_case && !self.cases_are_out {
            match next_case()? {
                Some(known) => self.take_case(known),
                None => self.cases_are_out = true,
            }
            return Ok(true);
        }
        if self.answers_are_out {
            return Ok(false);
        }
        match next_answer()? {
            Some(answer) => self.take_answer(answer),
            None => self.answers_are_out = true,
        }
        Ok(true)
    }

    fn take_case(&mut self, known: Known) {
        let place = self.tally.begin(&known);
        if let Some((_, answer)) = self.answers.take_by_id(&known.id) {
            self.answers.n_bytes -= answer.n_bytes();
            return self.tally.joined(place, known, answer);
        }
        if self.answers_are_out {
            return self.without_answer(place, known);
        }
        let id = known.id.clone();
        self.cases.insert(place, id, known);
    }

    fn take_answer(&mut self, answer: Answer) {
        self.n_answers += 1;
        let place = self.n_answers;
        if answer.is_noise() {
            if self.noise.len() < MOST_NOISE {
                self.noise.insert(place, answer);
            } else {
                self.tally.stray(answer);
            }
            return;
        }
        let by_id = answer.id.as_ref().and_then(|id| self.cases.take_by_id(id));
        let by_place = |cases: &mut Waiting<Known>| {
            let of_none = |known: &Known| known.id.is_null() || answer.id.is_none();
            cases.take_if(place, of_none)
        };
        if let Some((place, known)) = by_id.or_else(|| by_place(&mut self.cases)) {
            return self.tally.joined(place, known, answer);
        }
        match answer.id.clone() {
            Some(id) if !self.cases_are_out => self.wait(place, id, answer),
            Some(_) | None => self.tally.stray(answer),
        }
    }

    /// What has waited longest makes room, and so does the oldest case, so that the next can be read.
    fn wait(&mut self, place: usize, id: Id, answer: Answer) {
        self.answers.n_bytes += answer.n_bytes();
        self.answers.insert(place, id, answer);
        let is_too_much = |answers: &Waiting<Answer>| {
            answers.len() > MOST_WAITING || answers.n_bytes > MOST_BYTES
        };
        while is_too_much(&self.answers)
            && let Some((_, oldest)) = self.answers.take_first()
        {
            self.answers.n_bytes -= oldest.n_bytes();
            self.tally.stray(oldest);
            if let Some((place, known)) = self.cases.take_first() {
                self.without_answer(place, known);
            }
        }
    }

    /// A line that is none stands for the answer in its place.
    fn without_answer(&mut self, place: usize, known: Known) {
        match self.noise.remove(&place) {
            Some(noise) => self.tally.joined(place, known, noise),
            None => self.tally.missing(place, known),
        }
    }

    fn finish(mut self) {
        while let Some((place, known)) = self.cases.take_first() {
            self.without_answer(place, known);
        }
        while let Some((_, answer)) = self.answers.take_first() {
            self.tally.stray(answer);
        }
        for answer in std::mem::take(&mut self.noise).into_values() {
            self.tally.stray(answer);
        }
    }
}

/// By their places, and by their ids.
struct Waiting<T> {
    by_place: BTreeMap<usize, (Id, T)>,
    by_id: HashMap<Id, VecDeque<usize>, FxBuildHasher>,
    n_bytes: usize,
}

impl<T> Default for Waiting<T> {
    fn default() -> Self {
        Self {
            by_place: BTreeMap::new(),
            by_id: HashMap::default(),
            n_bytes: 0,
        }
    }
}

impl<T> Waiting<T> {
    fn len(&self) -> usize {
        self.by_place.len()
    }

    fn insert(&mut self, place: usize, id: Id, one: T) {
        if !id.is_null() {
            self.by_id.entry(id.clone()).or_default().push_back(place);
        }
        self.by_place.insert(place, (id, one));
    }

    /// The first of this id.
    fn take_by_id(&mut self, id: &Id) -> Option<(usize, T)> {
        let place = *self.by_id.get(id)?.front()?;
        self.take(place)
    }

    fn take_if(&mut self, place: usize, is_meant: impl Fn(&T) -> bool) -> Option<(usize, T)> {
        let (_, one) = self.by_place.get(&place)?;
        is_meant(one).then(|| self.take(place))?
    }

    fn take_first(&mut self) -> Option<(usize, T)> {
        let (&place, _) = self.by_place.first_key_value()?;
        self.take(place)
    }

    fn take(&mut self, place: usize) -> Option<(usize, T)> {
        let (id, one) = self.by_place.remove(&place)?;
        if let Some(places) = self.by_id.get_mut(&id) {
            places.retain(|&other| other != place);
            if places.is_empty() {
                self.by_id.remove(&id);
            }
        }
        Some((place, one))
    }
}
