//! Two values of JSON, one of which is true.

use std::fmt::Write;

use serde_json::{Map, Value as Json};

/// Where two values first differ.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Difference {
    /// Such as `segment[2]`; empty where it is the value as a whole.
    pub path: String,
    /// None where there is nothing.
    pub said: Option<Json>,
    pub truth: Option<Json>,
}

/// How much a number may be off, of one that is larger than 1 as a part of it.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Tolerance(f64);

impl Tolerance {
    /// None where it is negative or not finite.
    #[must_use]
    pub fn new(tolerance: f64) -> Option<Self> {
        (tolerance.is_finite() && tolerance >= 0.0).then_some(Self(tolerance))
    }
}

impl Default for Tolerance {
    fn default() -> Self {
        Self(1e-9)
    }
}

/// What is asked of the fields of an object.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Fields {
    /// All true ones are there; others do not matter.
    All,
    /// None but true ones are there; what is left out does not matter.
    Some,
}

impl Tolerance {
    /// Do they agree? Numbers as far as this allows, what counts or names exactly.
    pub(super) fn agree(self, said: &Json, truth: &Json) -> bool {
        match (said, truth) {
            (Json::Number(said), Json::Number(truth)) => {
                let is_whole = !truth.is_f64();
                let numbers = said.as_f64().zip(truth.as_f64());
                numbers.is_some_and(|(said, truth)| {
                    let most = if is_whole {
                        0.0
                    } else {
                        self.0 * truth.abs().max(1.0)
                    };
                    said == truth || (said - truth).abs() <= most
                })
            }
            (Json::Array(said), Json::Array(truth)) => {
                let mut pairs = said.iter().zip(truth);
                said.len() == truth.len() && pairs.all(|(said, truth)| self.agree(said, truth))
            }
            (Json::Object(said), Json::Object(truth)) => {
                let is_there = |(name, truth): (&String, &Json)| {
                    said.get(name).is_some_and(|said| self.agree(said, truth))
                };
                truth.iter().all(is_there)
            }
            _ => said == truth,
        }
    }

    /// Where they first differ.
    pub(super) fn first_difference(self, said: &Json, truth: &Json) -> Option<Difference> {
        self.difference_at(String::new(), Some(said), Some(truth))
    }

    fn difference_at(
        self,
        path: String,
        said: Option<&Json>,
        truth: Option<&Json>,
    ) -> Option<Difference> {
        match (said, truth) {
            (Some(Json::Array(said)), Some(Json::Array(truth))) => {
                let n = said.len().max(truth.len());
                (0..n).find_map(|i| {
                    self.difference_at(format!("{path}[{i}]"), said.get(i), truth.get(i))
                })
            }
            (Some(Json::Object(said)), Some(Json::Object(truth))) => {
                self.difference_in(&path, said, truth, Fields::All)
            }
            (Some(one), Some(other)) if self.agree(one, other) => None,
            (said, truth) => Some(Difference {
                path,
                said: said.cloned(),
                truth: truth.cloned(),
            }),
        }
    }

    /// The first field that differs.
    pub(super) fn difference_in(
        self,
        path: &str,
        said: &Map<String, Json>,
        truth: &Map<String, Json>,
        fields: Fields,
    ) -> Option<Difference> {
        let at = |name: &str| {
            let mut at = path.to_owned();
            let dot = if path.is_empty() { "" } else { "." };
            let _ = write!(at, "{dot}{name}");
            at
        };
        let is_asked =
            |(name, _): &(&String, &Json)| fields == Fields::All || said.contains_key(*name);
        let known = truth
            .iter()
            .filter(is_asked)
            .find_map(|(name, truth)| self.difference_at(at(name), said.get(name), Some(truth)));
        let unknown = || {
            let mut others = said.iter().filter(|_| fields == Fields::Some);
            let (name, said) = others.find(|(name, _)| !truth.contains_key(*name))?;
            self.difference_at(at(name), Some(said), None)
        };
        known.or_else(unknown)
    }
}
