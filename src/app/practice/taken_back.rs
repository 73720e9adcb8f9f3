//! What is shown of an option before it is known, and how a decision is taken back.

use std::borrow::Cow;

use crate::figure::{Glimpse, Mark, Run};

use super::{super::prelude::*, App, Asked, Practice};

impl Practice {
    /// With what the drawing shows besides while this is pointed at.
    pub fn with_glimpse<'a>(&self, marks: Cow<'a, [Mark]>, lit: Option<Link>) -> Cow<'a, [Mark]> {
        let mut marks = marks;
        if let Some(mark) = self.glimpse(lit) {
            marks.to_mut().insert(0, mark.clone());
        }
        marks
    }

    pub fn glimpse(&self, lit: Option<Link>) -> Option<&Mark> {
        let nth = self.option_of(lit?)?;
        match self.open()?.choice.glimpses.get(nth)? {
            Glimpse::Mark(mark) => Some(mark),
            Glimpse::Nothing | Glimpse::Pixels(_) => None,
        }
    }

    /// What was answered of another recording than this one goes. Was there another?
    pub(super) fn forget_answers(&mut self, recording: u64) -> bool {
        let is_another = self.recording != recording;
        if is_another {
            self.recording = recording;
            self.done.clear();
            self.answers.clear();
        }
        is_another
    }

    /// Is there an answer to take back?
    pub fn has_answered(&self) -> bool {
        self.is_on && !self.done.is_empty()
    }

    /// The last decision of the run that has been answered and not been taken back is asked once more; where the run stands for it.
    /// What was answered stays, and counts.
    pub(super) fn take_back(&mut self, run: &dyn Run) -> Option<usize> {
        let mut answers = self.answers.iter().rev();
        let last = answers.find(|answer| self.done.contains(&answer.step))?;
        self.done.remove(&last.step);
        let asked = Asked::in_run(run, last.step, last.choice.clone());
        Some(self.asked.insert(asked).stands)
    }
}

impl App {
    /// Is it asked what comes?
    pub fn is_asking(&self) -> bool {
        self.practice.is_asking()
    }
}
