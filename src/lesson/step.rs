//! One step of a lesson, and where in the run of its scene it stops.

use std::{
    ops::Deref,
    sync::{Arc, OnceLock},
};

use crate::{
    figure::{Moment, Run},
    labs::{Handle, Lock, Scene},
};

use super::{asking::Goal, prelude::*, toml_fields::Node};

/// One step of a lesson: a scene, and where its run stops.
#[derive(Clone, PartialEq, Debug)]
pub struct LessonStep {
    pub id: String,
    /// The id that it had: places and links of then still lead to it.
    pub was: Option<String>,
    pub(super) stop: Stop,
    /// The figure that export makes of it, unique in the lesson: lower-case letters, digits and hyphens.
    pub figure: Option<String>,
    /// What the figure shows, where that is not what the step begins with.
    pub(super) drawn: Option<Stop>,
    /// What the figure shows beside that: how it was before.
    pub before: Option<Stop>,
    pub locks: Vec<Lock>,
    /// The kinds of handles that its text asks for.
    pub drags: Vec<String>,
    pub code: CodeView,
    /// What is asked before the step shows it.
    pub asks: Option<Asks>,
    /// What the scene is to be changed to.
    pub goal: Option<Goal>,
}

/// What is asked of a run.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Asks {
    /// The last decision up to the step's moment.
    Decision,
    /// Every decision, from the start on.
    Run,
}

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

    fn problem(&self) -> Option<Problem> {
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

impl Deref for LessonStep {
    type Target = Stop;

    fn deref(&self) -> &Stop {
        &self.stop
    }
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

    /// What its figure shows.
    pub fn drawn(&self) -> &Stop {
        self.drawn.as_ref().unwrap_or(&self.stop)
    }

    /// All that its figure shows, in this order.
    pub fn shown(&self) -> impl Iterator<Item = &Stop> {
        self.before.iter().chain([self.drawn()])
    }

    pub fn problem(&self) -> Option<Problem> {
        let stops = [&self.stop].into_iter().chain(self.shown());
        stops.into_iter().find_map(Stop::problem)
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
