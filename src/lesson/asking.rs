//! What a step asks: `ask = true`, what comes, before it shows that; `goal = ["output.visible = false"]`, a scene of which all that
//! holds, with one that reaches it: `reached = "lower"`.

use std::sync::Arc;

use toml::de::DeValue;

use crate::{figure::Run, labs::Scene};

use super::{prelude::*, reference::Condition, toml_fields::Node};

/// A goal of more parts is none that anybody keeps in mind.
const MAX_PARTS: usize = 6;

/// What a scene is to be changed to.
#[derive(Clone, PartialEq, Debug)]
pub struct Goal {
    pub(super) conditions: Vec<Condition>,
    /// A scene that reaches it.
    pub reached: Arc<Scene>,
}

impl Goal {
    pub const fn n_parts(&self) -> usize {
        self.conditions.len()
    }

    /// Which of its parts hold of a scene with these runs, each with its method's id.
    pub fn met(&self, scene: &Scene, runs: &[(&'static str, &dyn Run)]) -> Vec<bool> {
        let conditions = self.conditions.iter();
        conditions.map(|it| it.holds(scene, runs)).collect()
    }

    /// The same of a scene by itself.
    pub fn met_by(&self, scene: &Scene) -> Vec<bool> {
        let recorded = scene.document().record();
        let ids = scene.document().methods().into_iter().map(|card| card.id);
        let runs: Vec<_> = ids.zip(recorded.iter().map(|run| &**run)).collect();
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

/// Is it asked what comes? Where the run of its scene is known, it has a decision by the step's own position.
pub(super) fn asks(node: Node<'_>, stands: Option<(&dyn Run, usize)>) -> bool {
    let &DeValue::Boolean(is_asked) = node.value_of() else {
        node.wrong_type("expect-true-or-false");
        return false;
    };
    if let Some((run, position)) = stands.filter(|_| is_asked)
        && run.decision_by(position).is_none()
    {
        let expected = [Message::new("expect-decision")];
        node.error(Message::new("problem-nothing-asked"), expected);
    }
    is_asked
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
