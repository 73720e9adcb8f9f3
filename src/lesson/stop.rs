//! Where in the run of a scene a step or its figure stops.

use std::sync::{Arc, OnceLock};

use crate::{
    figure::{Moment, Run},
    labs::Scene,
};

use super::{prelude::*, toml_fields::Node};

/// A scene, and where in its run a step or its figure stops.
#[derive(Clone, Debug)]
pub struct Stop {
    /// Shared by the steps that show it, since it may be large.
    pub scene: Arc<Scene>,
    pub moment: Moment,
    /// Where the moment is written, should it never come.
    pub(super) file: String,
    pub(super) place: Option<Place>,
    pub(super) found: OnceLock<Option<usize>>,
}

/// How the moment is found is no part of what a stop is.
impl PartialEq for Stop {
    fn eq(&self, other: &Self) -> bool {
        (&self.scene, &self.moment) == (&other.scene, &other.moment)
    }
}

impl Stop {
    /// The step of the first method's run at which its moment comes; `None` where it never does. The run is recorded
    /// when this is first asked for.
    pub fn position(&self) -> Option<usize> {
        let find = || self.scene.document().record().first()?.find(&self.moment);
        *self.found.get_or_init(find)
    }

    pub(super) fn problem(&self) -> Option<Problem> {
        if self.position().is_some() {
            return None;
        }
        let runs = self.scene.document().record();
        Some(Problem {
            file: self.file.clone(),
            place: self.place.clone(),
            severity: Severity::Error,
            what: never_comes(&self.moment, &**runs.first()?),
        })
    }
}

/// The step of the first method's run at which this moment comes.
pub(super) fn moment_in(scene: &Scene, moment: &Moment) -> Result<usize, Diagnostic> {
    // There is one at least.
    let run = &scene.document().record()[0];
    run.find(moment).ok_or_else(|| never_comes(moment, &**run))
}

/// The most moments that an error lists.
const MAX_MOMENTS: usize = 60;

pub(super) fn moment(node: Node<'_>) -> Option<Moment> {
    node.accept(node.text()?.parse::<Moment>())
}

pub(super) fn never_comes(moment: &Moment, run: &dyn Run) -> Diagnostic {
    let steps = 0..=run.n_steps().min(MAX_MOMENTS);
    let mut moments: Vec<String> = steps.map(|step| run.moment(step).to_string()).collect();
    moments.push(Moment::End.to_string());
    let wanted = moment.to_string();
    let names: Vec<&str> = moments.iter().map(String::as_str).collect();
    // The event and any of its words are enough: `cut left` is a name for `cut p1 left`.
    let shorter: Vec<String> = names.iter().flat_map(|name| short_names(name)).collect();
    let candidates = moments.iter().chain(&shorter).map(String::as_str);
    let meant = nearest(&wanted, candidates);
    let message = Message::new("problem-moment-never-happens").with("name", clipped(&wanted));
    let notes = suggestion(meant, &names).into_iter();
    notes.fold(Diagnostic::new(message), Diagnostic::noting)
}

/// `cut`, `cut p1` and `cut left` for `cut p1 left`.
fn short_names(moment: &str) -> Vec<String> {
    let mut words = moment.split_whitespace();
    let event = words.next().unwrap_or_default();
    let with_one = words.map(|word| format!("{event} {word}"));
    std::iter::once(event.to_owned()).chain(with_one).collect()
}
