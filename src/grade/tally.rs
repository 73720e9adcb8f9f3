//! What is counted and kept of one submission, so that the report can be made when its last answer is in.
//!
//! Which kinds of event are compared is known at the end only, since a kind counts that a program ever tells. An answer that is
//! right by the kinds told so far is in doubt as long as its true run has others: it is kept, and looked at again if one of those
//! comes. Of each combination of such kinds only so many are kept as a report lists; the others are counted.

use std::collections::{BTreeMap, HashMap};

use crate::{case::Id, text::Message};

use super::{
    answer::Answer,
    fault::{Fault, Kind},
    judge::{Claim, Judge, Kinds},
    truth::Known,
    whole::Whole,
};

use serde_json::Value as Json;

/// More wrong answers are counted, not listed.
pub(super) const MOST_LISTED: usize = 10_000;

/// Of so many cases a report knows each by name.
const MOST_NAMED: usize = 1_000;

/// What came of a submission.
pub struct Report {
    /// None where there is but one.
    pub submission: Option<Id>,
    /// How many cases there were.
    pub n_cases: usize,
    /// How many were answered rightly.
    pub n_right: usize,
    /// The first of the others, in the order of the cases, then answers to no case.
    pub wrong: Vec<Wrong>,
    /// How many more there are.
    pub n_unlisted: usize,
    /// What the first cases are called.
    pub names: Vec<Id>,
}

impl Report {
    /// Is every case answered rightly, and nothing else said?
    #[must_use]
    pub const fn is_all_right(&self) -> bool {
        self.n_right == self.n_cases && self.wrong.is_empty()
    }
}

/// An answer that is not right.
pub struct Wrong {
    /// Which case, from 1; none where it answers none.
    pub case: Option<usize>,
    /// Of the case, or of an answer to none.
    pub id: Id,
    /// Where the case stands among the cases, or such an answer among the answers.
    pub line: usize,
    /// What is wrong.
    pub kind: Kind,
    /// Of the program's own steps, from 1.
    pub step: Option<usize>,
    /// Null where there is nothing.
    pub said: Json,
    /// Null where there is nothing.
    pub truth: Json,
    /// The known mistake that comes to the same: its id, and the key of its name.
    pub mistake: Option<[&'static str; 2]>,
    /// What is wrong, in a sentence.
    pub message: Message,
    pub(super) known: Option<Known>,
    /// Of the first of a report.
    pub(super) whole: Option<Whole>,
}

impl Wrong {
    /// Catalogue key of the algorithm's name, where the case has an answer.
    #[must_use]
    pub fn algorithm_key(&self) -> Option<&'static str> {
        let right = self.known.as_ref()?.truth.as_ref().as_ref().ok()?;
        Some(right.solver.card.name_key)
    }
}

/// A case with its answer, as far as they are there.
struct Held {
    known: Option<Known>,
    answer: Option<Answer>,
}

/// Answers that are right unless a program tells one of these kinds later.
struct Doubt {
    kinds: Vec<String>,
    n: usize,
    held: BTreeMap<usize, Held>,
}

/// One submission.
pub(super) struct Tally {
    judge: Judge,
    n_cases: usize,
    n_right: usize,
    kinds: Kinds,
    names: Vec<Id>,
    /// By the place of the case; answers to none come after all cases, by their line.
    wrong: BTreeMap<(bool, usize), Held>,
    n_wrong: usize,
    doubts: HashMap<(&'static str, String), Doubt>,
}

impl Tally {
    pub(super) fn new(judge: Judge) -> Self {
        Self {
            judge,
            n_cases: 0,
            n_right: 0,
            kinds: Kinds::default(),
            names: Vec::new(),
            wrong: BTreeMap::new(),
            n_wrong: 0,
            doubts: HashMap::new(),
        }
    }

    /// A case has been read; its place is how many there are now.
    pub(super) fn begin(&mut self, known: &Known) -> usize {
        self.n_cases += 1;
        if self.names.len() < MOST_NAMED {
            self.names.push(known.id.clone());
        }
        self.n_cases
    }

    pub(super) const fn n_cases(&self) -> usize {
        self.n_cases
    }

    pub(super) fn joined(&mut self, place: usize, known: Known, answer: Answer) {
        let Ok(said) = answer.said() else {
            return self.keep((false, place), Some(known), Some(answer));
        };
        let claim = Claim::of(said);
        claim.teach(&known.truth, &mut self.kinds);
        if self
            .judge
            .fault_of(&claim, &known.truth, &self.kinds)
            .is_some()
        {
            return self.keep((false, place), Some(known), Some(answer));
        }
        self.n_right += 1;
        if claim.tells_steps() {
            self.doubt(place, known, answer);
        }
    }

    fn doubt(&mut self, place: usize, known: Known, answer: Answer) {
        let Some(right) = known.truth.as_ref().as_ref().ok() else {
            return;
        };
        let Some(steps) = right.steps(self.judge.solvers) else {
            return;
        };
        let untold = steps
            .kinds
            .iter()
            .filter(|kind| !self.kinds.has(right, kind));
        let kinds: Vec<String> = untold.cloned().collect();
        if kinds.is_empty() {
            return;
        }
        let key = (right.solver.card.id, kinds.join("\0"));
        let doubt = self.doubts.entry(key).or_insert_with(|| Doubt {
            kinds,
            n: 0,
            held: BTreeMap::new(),
        });
        doubt.n += 1;
        let (known, answer) = (Some(known), Some(answer));
        doubt.held.insert(place, Held { known, answer });
        if doubt.held.len() > MOST_LISTED {
            doubt.held.pop_last();
        }
    }

    pub(super) fn missing(&mut self, place: usize, known: Known) {
        self.keep((false, place), Some(known), None);
    }

    /// An answer to no case, or a line that is none.
    pub(super) fn stray(&mut self, answer: Answer) {
        self.keep((true, answer.line), None, Some(answer));
    }

    fn keep(&mut self, place: (bool, usize), known: Option<Known>, answer: Option<Answer>) {
        self.n_wrong += 1;
        self.wrong.insert(place, Held { known, answer });
        if self.wrong.len() > MOST_LISTED {
            self.wrong.pop_last();
        }
    }

    pub(super) fn finish(mut self, submission: Option<Id>) -> Report {
        for ((algorithm, _), doubt) in std::mem::take(&mut self.doubts) {
            if doubt
                .kinds
                .iter()
                .any(|kind| self.kinds.has_of(algorithm, kind))
            {
                self.n_right -= doubt.n;
                self.n_wrong += doubt.n;
                let held = doubt
                    .held
                    .into_iter()
                    .map(|(place, held)| ((false, place), held));
                self.wrong.extend(held);
            }
        }
        let listed = std::mem::take(&mut self.wrong)
            .into_iter()
            .take(MOST_LISTED);
        let wrong: Vec<Wrong> = listed
            .enumerate()
            .map(|(nth, (place, held))| self.wrong_of(place, held, nth == 0))
            .collect();
        Report {
            submission,
            n_cases: self.n_cases,
            n_right: self.n_right,
            n_unlisted: self.n_wrong - wrong.len(),
            wrong,
            names: self.names,
        }
    }

    fn wrong_of(&self, (is_stray, place): (bool, usize), held: Held, is_drawn: bool) -> Wrong {
        let Held { known, answer } = held;
        let fault = match (&known, &answer) {
            (Some(known), Some(answer)) => self.judge.fault(answer, &known.truth, &self.kinds),
            (None, Some(answer)) => Some(match answer.said() {
                Ok(_) => Fault::Extra { line: answer.line },
                Err(problem) => Fault::BadJson {
                    line: answer.line,
                    problem: problem.clone(),
                },
            }),
            (_, None) => None,
        };
        let fault = fault.unwrap_or(Fault::Missing);
        let [said, truth] = fault.said_and_true();
        let id = known.as_ref().map(|known| known.id.clone());
        let right = known
            .as_ref()
            .and_then(|known| known.truth.as_ref().as_ref().ok());
        let whole = is_drawn.then(|| fault.whole(right.map(|right| &right.output)));
        Wrong {
            case: (!is_stray).then_some(place),
            id: id
                .or_else(|| answer.as_ref()?.id.clone())
                .unwrap_or_default(),
            line: known.as_ref().map_or(place, |known| known.line),
            kind: fault.kind(),
            step: fault.step(),
            said,
            truth,
            mistake: self.mistake(known.as_ref(), answer.as_ref()),
            message: fault.message(),
            whole,
            known,
        }
    }

    fn mistake(&self, known: Option<&Known>, answer: Option<&Answer>) -> Option<[&'static str; 2]> {
        let right = known?.truth.as_ref().as_ref().ok()?;
        let claim = Claim::of(answer?.said().ok()?);
        let which = self.judge.mistake(&claim, right, &self.kinds)?;
        let mistaken = &right.mistaken()[which];
        Some([mistaken.id, mistaken.name_key])
    }
}
