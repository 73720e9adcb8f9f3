//! One step of a lesson, and where in the run of its scene it stops.

use std::sync::{Arc, OnceLock};

use crate::{
    figure::{Moment, Run},
    labs::{Handle, Lock, Scene},
};

use super::{prelude::*, toml_fields::Node};

/// One step of a lesson: a scene, and where its run stops.
#[derive(Clone, PartialEq, Debug)]
pub struct LessonStep {
    pub id: String,
    /// Shared by the steps that show it, since it may be large.
    pub scene: Arc<Scene>,
    pub moment: Moment,
    /// The figure that export makes of it, unique in the lesson: lower-case letters, digits and hyphens.
    pub figure: Option<String>,
    pub locks: Vec<Lock>,
    pub code: CodeView,
    pub(super) stop: Stop,
}

impl LessonStep {
    /// What it locks among these handles of a scene, as long as that lies where the lesson has it: in another scene all is
    /// free.
    pub fn locks_in(&self, scene: &Scene, handles: &[Handle]) -> &[Lock] {
        let (own, now) = (self.scene.document(), scene.document());
        let is_elsewhere = |&handle: &Handle| {
            Lock::any_holds(&self.locks, handle) && own.position(handle) != now.position(handle)
        };
        if handles.iter().any(is_elsewhere) {
            &[]
        } else {
            &self.locks
        }
    }

    /// The step of the first method's run at which its moment comes; `None` where it never does. The run is recorded
    /// when this is first asked for.
    pub fn position(&self) -> Option<usize> {
        let find = || self.scene.document().record().first()?.find(&self.moment);
        *self.stop.found.get_or_init(find)
    }

    pub fn problem(&self) -> Option<Problem> {
        if self.position().is_some() {
            return None;
        }
        let runs = self.scene.document().record();
        Some(Problem {
            file: self.stop.file.clone(),
            place: self.stop.place.clone(),
            severity: Severity::Error,
            what: never_comes(&self.moment, &**runs.first()?),
        })
    }
}

/// How a step's moment is found, and where it is written, should it never come: no part of what the step is.
#[derive(Clone, Debug, Default)]
pub(super) struct Stop {
    pub file: String,
    pub place: Option<Place>,
    pub found: OnceLock<Option<usize>>,
}

impl PartialEq for Stop {
    fn eq(&self, _other: &Self) -> bool {
        true
    }
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

#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Hash)]
pub enum CodeView {
    #[default]
    Full,
    Words,
    /// Not at all, so that a class can be asked first.
    Hidden,
}

impl CodeView {
    pub const ALL: [Self; 3] = [Self::Full, Self::Words, Self::Hidden];

    pub const fn id(self) -> &'static str {
        match self {
            Self::Full => "full",
            Self::Words => "words",
            Self::Hidden => "hidden",
        }
    }
}
