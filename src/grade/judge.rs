//! Where an answer first differs from what is true.

use std::collections::{BTreeSet, HashMap};

use serde_json::{Map, Value as Json};

use crate::case::Solvers;

use super::{
    answer::{Answer, Said},
    compare::{Difference, Fields, Tolerance},
    fault::{EventFault, Fault},
    rings::{self, LATER},
    truth::{Right, Steps, Truth, kind_of},
};

/// By what answers are judged.
#[derive(Clone, Copy)]
pub(super) struct Judge {
    pub solvers: Solvers,
    pub tolerance: Tolerance,
}

/// The kinds of event that a program tells, of each algorithm: no others are compared.
#[derive(Default)]
pub(super) struct Kinds(HashMap<&'static str, BTreeSet<String>>);

/// More kinds than any algorithm has are not kept.
const MOST_KINDS: usize = 64;

impl Kinds {
    pub(super) fn has(&self, right: &Right, kind: &str) -> bool {
        self.has_of(right.solver.card.id, kind)
    }

    pub(super) fn has_of(&self, algorithm: &str, kind: &str) -> bool {
        let kinds = self.0.get(algorithm);
        kinds.is_some_and(|kinds| kinds.contains(kind))
    }

    fn learn(&mut self, right: &Right, events: &[Json]) {
        let kinds = self.0.entry(right.solver.card.id).or_default();
        for kind in events.iter().filter_map(kind_of) {
            if kinds.len() < MOST_KINDS && !kinds.contains(kind) {
                kinds.insert(kind.to_owned());
            }
        }
    }
}

/// An answer as it is compared.
pub(super) struct Claim<'a> {
    said: Said<'a>,
    /// None where it tells no steps; of what is no list, nothing but that.
    events: Option<Vec<Json>>,
}

impl<'a> Claim<'a> {
    pub(super) fn of(said: Said<'a>) -> Self {
        let events = said.events.filter(|text| *text != "null");
        let list = |text| serde_json::from_str(text).unwrap_or_else(|_| vec![Json::Null]);
        Self {
            said,
            events: events.map(list),
        }
    }

    pub(super) fn teach(&self, truth: &Truth, kinds: &mut Kinds) {
        if let (Ok(right), Some(events)) = (truth, &self.events) {
            kinds.learn(right, events);
        }
    }

    pub(super) const fn tells_steps(&self) -> bool {
        self.events.is_some()
    }
}

impl Judge {
    /// None where it is right.
    pub(super) fn fault(self, answer: &Answer, truth: &Truth, kinds: &Kinds) -> Option<Fault> {
        match answer.said() {
            Ok(said) => self.fault_of(&Claim::of(said), truth, kinds),
            Err(problem) => Some(Fault::BadJson {
                line: answer.line,
                problem: problem.clone(),
            }),
        }
    }

    pub(super) fn fault_of(self, claim: &Claim<'_>, truth: &Truth, kinds: &Kinds) -> Option<Fault> {
        let output = || claim.said.output.map_or(Json::Null, shown);
        match (truth, claim.said.is_refusal) {
            (Err(_), true) => None,
            (Err(code), false) => Some(Fault::Refusable {
                said: output(),
                code: *code,
            }),
            // With its steps it is refused.
            (Ok(right), true) if right.steps(self.solvers).is_none() => None,
            (Ok(right), true) => Some(Fault::Refuses {
                truth: right.output.clone(),
            }),
            (Ok(right), false) => {
                let event = claim.events.as_ref().and_then(|events| {
                    let steps = right.steps(self.solvers)?;
                    self.event_fault(events, steps, |kind| kinds.has(right, kind))
                });
                event.map(Fault::Event).or_else(|| {
                    let difference = self.output_difference(claim.said.output, right)?;
                    let truth = right.output.clone();
                    Some(Fault::Output {
                        said: output(),
                        truth,
                        difference,
                    })
                })
            }
        }
    }

    /// The first step that differs, of those whose kind is compared.
    pub(super) fn event_fault(
        self,
        said: &[Json],
        steps: &Steps,
        is_compared: impl Fn(&str) -> bool,
    ) -> Option<EventFault> {
        let is_told = |(_, event): &(usize, &Json)| kind_of(event).is_some_and(&is_compared);
        let told = (1..).zip(&steps.events).filter(is_told);
        let (places, truth): (Vec<usize>, Vec<&Json>) = told.unzip();
        let n = said.len().max(truth.len());
        let i = (0..n).find(|&i| match (said.get(i), truth.get(i)) {
            (Some(said), Some(truth)) => self.step_difference(said, truth).is_some(),
            _ => true,
        })?;
        let [next_said, next_true] = [said.get(i + 1), truth.get(i + 1).copied()];
        let (said, truth) = (said.get(i), truth.get(i).copied());
        let crosswise = [(said, next_true), (next_said, truth)];
        let is_same = |(said, truth): (Option<&Json>, Option<&Json>)| {
            said.zip(truth)
                .is_some_and(|(said, truth)| self.step_difference(said, truth).is_none())
        };
        let is_same_kind = said
            .zip(truth)
            .filter(|(said, truth)| kind_of(said) == kind_of(truth));
        Some(EventFault {
            step: i + 1,
            said: said.cloned(),
            truth: truth.cloned(),
            true_step: places.get(i).copied(),
            is_swapped: crosswise.into_iter().all(is_same),
            difference: is_same_kind.and_then(|(said, truth)| self.step_difference(said, truth)),
        })
    }

    fn step_difference(self, said: &Json, truth: &Json) -> Option<Difference> {
        let (Json::Object(fields), Json::Object(true_fields)) = (said, truth) else {
            return self.tolerance.first_difference(said, truth);
        };
        if kind_of(said).is_none() {
            return self.tolerance.first_difference(said, truth);
        }
        self.tolerance
            .difference_in("", fields, true_fields, Fields::Some)
    }

    fn output_difference(self, said: Option<&str>, right: &Right) -> Option<Difference> {
        if said == Some(&right.text) {
            return None;
        }
        let parsed = said.and_then(|text| serde_json::from_str::<Json>(text).ok());
        let (Some(Json::Object(fields)), Json::Object(truth)) = (&parsed, &right.output) else {
            return Some(Difference {
                path: String::new(),
                said: said.map(shown),
                truth: Some(right.output.clone()),
            });
        };
        self.difference_of_outputs(fields, truth, |field, said| {
            right.problem.admits(field, said)
        })
        .or_else(|| claims_too_much(fields, right))
    }

    fn difference_of_outputs(
        self,
        said: &Map<String, Json>,
        truth: &Map<String, Json>,
        admits: impl Fn(&str, &Json) -> bool,
    ) -> Option<Difference> {
        let plain = truth.iter().filter(|(name, _)| !rings::is_of_rings(name));
        let is_asked = |name: &str| match said.get(name) {
            Some(said) => !admits(name, said),
            None => !LATER.contains(&name),
        };
        let mut plain = plain.filter(|(name, _)| is_asked(name));
        let first = plain.find_map(|(name, truth)| {
            let Some(said) = said.get(name) else {
                let (path, truth) = (name.clone(), Some(truth.clone()));
                return Some(Difference {
                    path,
                    said: None,
                    truth,
                });
            };
            let difference = self.tolerance.first_difference(said, truth)?;
            let path = format!("{name}{}", separated(&difference.path));
            Some(Difference { path, ..difference })
        });
        first.or_else(|| rings::first_difference(said, truth, self.tolerance))
    }

    /// Which known mistake makes exactly this of the case.
    pub(super) fn mistake(self, claim: &Claim<'_>, right: &Right, kinds: &Kinds) -> Option<usize> {
        if claim.said.is_refusal {
            return None;
        }
        let output: Json = serde_json::from_str(claim.said.output?).ok()?;
        let fields = output.as_object()?;
        right.mistaken().iter().position(|mistaken| {
            let Some(truth) = mistaken.output.as_object() else {
                return false;
            };
            let is_answer = self
                .difference_of_outputs(fields, truth, |_, _| false)
                .is_none();
            is_answer
                && claim.events.as_ref().is_none_or(|events| {
                    let steps = Steps {
                        events: mistaken.events.clone(),
                        kinds: Vec::new(),
                    };
                    self.event_fault(events, &steps, |kind| kinds.has(right, kind))
                        .is_none()
                })
        })
    }
}

/// A field that an answer of this algorithm may have, and this one has not.
fn claims_too_much(said: &Map<String, Json>, right: &Right) -> Option<Difference> {
    let fields = right.solver.output.iter().map(|field| field.name);
    let mut absent = fields.filter(|name| right.output.get(name).is_none());
    let (name, said) = absent.find_map(|name| {
        let said = said.get(name).filter(|said| !said.is_null())?;
        Some((name, said))
    })?;
    Some(Difference {
        path: name.to_owned(),
        said: Some(said.clone()),
        truth: None,
    })
}

fn separated(path: &str) -> String {
    let is_field = !path.is_empty() && !path.starts_with('[');
    if is_field {
        format!(".{path}")
    } else {
        path.to_owned()
    }
}

/// What was written, as JSON; what is none, as text.
fn shown(text: &str) -> Json {
    serde_json::from_str(text).unwrap_or_else(|_| Json::String(text.to_owned()))
}
