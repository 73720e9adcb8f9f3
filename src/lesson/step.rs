//! One step of a lesson, and where in the run of its scene it stops.

use std::ops::Deref;

use crate::{
    figure::Moment,
    labs::{Handle, Lock, Scene},
};

use super::{
    asking::{Asks, Goal},
    prelude::*,
    stop::Stop,
};

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

    /// Where its run stands when it is opened: the end of two runs side by side is that of the longer one.
    pub fn opens_at(&self) -> usize {
        match self.moment {
            Moment::End => usize::MAX,
            Moment::Start | Moment::Event { .. } => self.position().unwrap_or_default(),
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
