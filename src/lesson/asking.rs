//! What a step asks: `ask = true`, what comes, before it shows that, `ask = "run"` before every decision from the start on; `goal = ["output.visible = false"]`, a scene of which all that
//! holds, with one that reaches it: `reached = "lower"`.

use std::{collections::BTreeMap, sync::Arc};

use serde_json::Value as Json;
use toml::de::DeValue;

use crate::{
    figure::{Moment, Run, Tick},
    labs::Scene,
    text::{Catalog, Value},
};

use super::{prelude::*, reference::Condition, toml_fields::Node};

/// In place of `true`: every decision is asked.
const WHOLE_RUN: &str = "run";
/// A goal of more parts is none that anybody keeps in mind.
const MAX_PARTS: usize = 6;

/// A longer run is not counted to its end.
const MOST_COUNTED: usize = 4096;

/// What is asked of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Asks {
    /// The last decision up to the step's moment.
    Decision,
    /// Every decision, from the start on.
    Run,
}

/// What a scene is to be changed to.
#[derive(Clone, PartialEq, Debug)]
pub struct Goal {
    pub(super) conditions: Vec<Condition>,
    /// A scene that reaches it.
    pub reached: Arc<Scene>,
    /// The moments of the run that its hint tells, each while that part is open, the last for those after it as well; none where
    /// it tells what decided last.
    pub hints: Vec<Moment>,
}

impl Goal {
    /// What its hint tells while this part is the first that is open.
    pub fn hint(&self, part: usize) -> Option<&Moment> {
        self.hints.get(part).or(self.hints.last())
    }

    pub const fn n_parts(&self) -> usize {
        self.conditions.len()
    }

    /// Which of its parts hold of a scene with these runs, each with its method's id.
    pub fn met(&self, scene: &Scene, runs: &[(&'static str, &dyn Run)]) -> Vec<bool> {
        let conditions = self.conditions.iter();
        conditions.map(|it| it.holds(scene, runs)).collect()
    }

    /// What can be asked of a scene that is to become like this one: what comes out, and how often what decides it happens.
    pub fn offered(scene: &Scene) -> Vec<String> {
        let recorded = scene.document().record();
        let Some(run) = recorded.first() else {
            return Vec::new();
        };
        let output = run.output_json();
        let said = |(key, value): (&String, &Json)| match value {
            Json::Bool(_) | Json::Null => Some(format!("output.{key} = {value}")),
            Json::String(word) => Some(format!("output.{key} = '{word}'")),
            Json::Number(_) | Json::Array(_) | Json::Object(_) => None,
        };
        let mut all: Vec<String> = output
            .as_object()
            .into_iter()
            .flatten()
            .filter_map(said)
            .collect();
        let mut counts = BTreeMap::<String, usize>::new();
        let mut decided = Vec::new();
        for step in 1..=run.n_steps().min(MOST_COUNTED) {
            let is_decisive = matches!(run.tick(step), Tick::Cut | Tick::Accept | Tick::Reject);
            if is_decisive || run.tick(step) == Tick::Test {
                let event = run.event_json(step);
                let name = event.get("event").and_then(Json::as_str);
                let name = name.unwrap_or_default().to_owned();
                let n = counts.entry(name.clone()).or_default();
                *n += 1;
                let words = is_decisive.then(|| words_of(&event, &name, *n));
                decided = words.filter(|it| !it.is_empty()).unwrap_or(decided);
            }
        }
        all.extend(decided);
        all.extend(
            counts
                .iter()
                .map(|(name, n)| format!("events({name}) = {n}")),
        );
        let runs = scene.by_method(recorded.iter().map(|run| &**run));
        let holds = |text: &String| Condition::parse(text).is_ok_and(|it| it.holds(scene, &runs));
        all.retain(holds);
        all.truncate(MAX_PARTS);
        all
    }

    /// What one of its parts compares, where that is two numbers of which one says what the other should be: what is, the sign,
    /// and what should be.
    pub fn compared(
        &self,
        part: usize,
        scene: &Scene,
        runs: &[(&'static str, &dyn Run)],
    ) -> Option<(f64, &'static str, f64)> {
        self.conditions.get(part)?.compared(scene, runs)
    }

    /// The same of a scene by itself.
    pub fn met_by(&self, scene: &Scene) -> Vec<bool> {
        let recorded = scene.document().record();
        let runs = scene.by_method(recorded.iter().map(|run| &**run));
        self.met(scene, &runs)
    }

    /// The scene that is said to reach it does, and the one at first does not.
    pub(super) fn check(&self, node: Node<'_>, first: &Scene) {
        let missed = self
            .met_by(&self.reached)
            .into_iter()
            .position(|is_met| !is_met);
        if let Some(part) = missed {
            let message = Message::new("problem-goal-missed").with("count", part + 1);
            node.error(message, [Message::new("expect-reached")]);
        } else if self.met_by(first).into_iter().all(|is_met| is_met) {
            let expected = [Message::new("expect-reached")];
            node.error(Message::new("problem-goal-met"), expected);
        }
    }
}

/// How students read a condition that is offered, until the author has put it better; any other as it is spelt.
pub fn in_words(part: &str, lang: Lang) -> String {
    let said = worded(part).map(|message| Catalog::of(lang).message(&message));
    said.unwrap_or_else(|| format!("`{part}`"))
}

fn worded(part: &str) -> Option<Message> {
    let (what, value) = part.split_once(" = ")?;
    let value = value.trim_matches('\'').to_owned();
    if let Some(name) = what.strip_prefix("events(") {
        let name = name.strip_suffix(')')?.to_owned();
        let count = Value::Count(value.parse().ok()?);
        return Some(
            Message::new("goal-words-count")
                .with("name", name)
                .with("count", count),
        );
    }
    if let Some((key, event)) = what
        .strip_prefix("event.")
        .and_then(|it| it.split_once(" @ "))
    {
        let (event, nth) = event.split_once(" #").unwrap_or((event, "1"));
        let message = Message::new("goal-words-event").with("name", key.to_owned());
        let message = message.with("event", event.to_owned()).with("value", value);
        return Some(message.with("nth", Value::Count(nth.parse().ok()?)));
    }
    let key = what.strip_prefix("output.")?;
    let is_plain = key.chars().all(|c| c.is_ascii_lowercase() || c == '_');
    let message = match (key, &*value) {
        ("visible", "true") => Message::new("goal-words-visible"),
        ("visible", "false") => Message::new("goal-words-invisible"),
        _ => Message::new("goal-words-output")
            .with("name", key.to_owned())
            .with("value", value),
    };
    is_plain.then_some(message)
}

/// What an event says in words, the `nth` of its name: what decides is asked so.
fn words_of(event: &Json, name: &str, nth: usize) -> Vec<String> {
    let nth = if nth > 1 {
        format!(" #{nth}")
    } else {
        String::new()
    };
    let fields = event.as_object().into_iter().flatten();
    let words = fields
        .filter(|(key, _)| *key != "event")
        .filter_map(|(key, value)| {
            let word = value.as_str()?;
            Some(format!("event.{key} @ {name}{nth} = '{word}'"))
        });
    words.collect()
}

/// What is asked. Where the run of its scene is known, it has a decision by the step's own position, or at all.
pub(super) fn asks(node: Node<'_>, stands: Option<(&dyn Run, usize)>) -> Option<Asks> {
    let asks = match node.value_of() {
        DeValue::Boolean(false) => return None,
        DeValue::Boolean(true) => Asks::Decision,
        DeValue::String(word) if word == WHOLE_RUN => Asks::Run,
        _ => {
            node.wrong_type("expect-ask");
            return None;
        }
    };
    let (run, position) = stands.unzip();
    let position = match asks {
        Asks::Decision => position,
        Asks::Run => run.map(Run::n_steps),
    };
    if let Some((run, position)) = run.zip(position)
        && run.decision_by(position).is_none()
    {
        let expected = [Message::new("expect-decision")];
        node.error(Message::new("problem-nothing-asked"), expected);
    }
    Some(asks)
}

/// The parts of a goal; `None` where one cannot be read.
pub(super) fn conditions(node: Node<'_>) -> Option<Vec<Condition>> {
    let nodes = node.list("expect-goal")?;
    let count = nodes.len();
    if !(1..=MAX_PARTS).contains(&count) {
        let message = Message::new("problem-goal-parts").with("count", count);
        node.error(
            message.with("limit", MAX_PARTS),
            [Message::new("expect-goal")],
        );
        return None;
    }
    let read = |node: Node<'_>| node.accept(Condition::parse(node.text()?));
    nodes.map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lesson::Course;

    #[test]
    fn whatever_is_offered_is_said_in_words() {
        let course = Course::embedded();
        let mut n = 0;
        for goal in course.lessons.iter().flat_map(|lesson| &lesson.steps) {
            for part in Goal::offered(&goal.scene) {
                for lang in Lang::ALL {
                    let said = in_words(&part, lang);
                    assert!(!said.contains(['`', '=', '⟦']), "{part}: {said}");
                }
                n += 1;
            }
        }
        assert!(n > 100, "{n}");
    }
}
