//! An answer as a line of JSON.

use serde::Serialize;
use serde_json::Value as Json;

use crate::trace::Counts;

use super::{Case, Detail, Id, Refused};

#[derive(Serialize)]
struct Answer<'a> {
    id: &'a Id,
    algorithm: &'static str,
    output: Json,
    counts: Counts,
    #[serde(skip_serializing_if = "Option::is_none")]
    events: Option<Vec<Json>>,
}

#[derive(Serialize)]
struct RefusedAnswer<'a> {
    id: &'a Id,
    error: ErrorJson<'a>,
}

#[derive(Serialize)]
struct ErrorJson<'a> {
    code: &'static str,
    field: &'a str,
    message: String,
}

impl Case {
    /// Its answer, without a line break.
    ///
    /// # Errors
    /// None that an answer could cause: `serde_json` states one.
    pub fn write_json(&self, detail: Detail, out: &mut Vec<u8>) -> serde_json::Result<()> {
        let (id, algorithm) = (&self.id, self.solver.id());
        let answer = if detail == Detail::Steps {
            let run = self.problem.run();
            let n_steps = run.n_steps();
            Answer {
                id,
                algorithm,
                output: self.problem.output_of(&*run),
                counts: run.counts_at(n_steps),
                events: Some((1..=n_steps).map(|step| run.event_json(step)).collect()),
            }
        } else {
            let (output, counts) = self.problem.cost();
            Answer {
                id,
                algorithm,
                output,
                counts,
                events: None,
            }
        };
        serde_json::to_writer(out, &answer)
    }
}

impl Refused {
    /// Its answer, without a line break.
    ///
    /// # Errors
    /// None that an answer could cause: `serde_json` states one.
    pub fn write_json(&self, out: &mut Vec<u8>) -> serde_json::Result<()> {
        let answer = RefusedAnswer {
            id: &self.id,
            error: ErrorJson {
                code: self.refusal.code.id(),
                field: &self.refusal.field,
                message: self.refusal.message(),
            },
        };
        serde_json::to_writer(out, &answer)
    }
}
