//! One question: what is asked of which step, where the run waits for it, and what was said.

use crate::figure::{Chip, Choice, Run};

use super::super::{desk::Page, prelude::*};

/// What has a digit of its own; more options than these are a list.
pub(in super::super) const DIGITS: [Key; 9] = [
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::Num5,
    Key::Num6,
    Key::Num7,
    Key::Num8,
    Key::Num9,
];

pub struct Asked {
    /// The decision's.
    pub(super) step: usize,
    /// Until it is answered the stage shows this one.
    pub(super) stands: usize,
    pub(in super::super) choice: Choice,
    /// What was answered; the right one where the answer was asked for.
    pub(in super::super) chosen: Option<usize>,
    pub(in super::super) is_shown: bool,
    pub(super) chips: Vec<Chip>,
    /// The step of the course that asks it, where none of a practice does.
    pub(super) of: Option<Page>,
}

impl Asked {
    /// Of a run that asks before this step, or before the phase that leads to it.
    pub(super) fn in_run(run: &dyn Run, step: usize, choice: Choice) -> Self {
        Self {
            step,
            stands: run.asked_at(step, &choice),
            chips: choice.chips(None, DIGITS.len()),
            choice,
            chosen: None,
            is_shown: false,
            of: None,
        }
    }
}
