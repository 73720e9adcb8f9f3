//! Help towards the open step's goal: a hint in two parts, what decided its run and the equation; and where its runs have ended.

use std::ops::ControlFlow;

use crate::{
    figure::{Caption, Decides},
    lesson::{Block, Inline},
    text::Formula,
};

use super::{App, desk::Page, prelude::*};

/// What is compared or decides, and the equation.
pub const PARTS: usize = 2;
/// In longer runs nobody looks for what decided them while something is dragged.
const LONGEST: usize = 4096;

#[derive(Default)]
pub struct Help {
    /// So many parts of the hint are shown.
    pub n_shown: usize,
    pub hint: Hint,
    pub ended: Vec<Ended>,
    /// The recording whose end has been counted last.
    counted: Option<u64>,
}

#[derive(Clone, PartialEq, Debug, Default)]
pub struct Hint {
    pub decides: Option<Message>,
    pub equation: Vec<Formula>,
    /// The least change that turns what was decided.
    pub turned: Option<Message>,
    /// What the first part of the goal that does not hold compares, where that is two numbers.
    pub compared: Option<Message>,
}

impl Hint {
    /// What its first part says: the two numbers of the goal, or what decided.
    pub fn first(&self) -> Option<&Message> {
        self.compared.as_ref().or(self.decides.as_ref())
    }

    /// What its second part says besides the equation.
    pub fn second(&self) -> impl Iterator<Item = &Message> {
        let decides = self.compared.as_ref().and(self.decides.as_ref());
        decides.into_iter().chain(&self.turned)
    }
}

/// A way in which runs have ended, as the last of them said it.
pub struct Ended {
    pub said: Message,
    pub so: Vec<Formula>,
    pub count: usize,
    pub is_now: bool,
}

impl App {
    /// Shows the next part of the hint: it counts as seen.
    pub(super) fn show_hint(&mut self) {
        let Some(Page::Step(lesson, step)) = self.bookmark.page() else {
            return;
        };
        if self.met().is_empty() || self.is_reached() {
            return;
        }
        let help = &mut self.goals.help;
        help.n_shown = (help.n_shown + 1).min(PARTS);
        let progress = &mut self.settings.progress;
        self.is_touched |= progress.hint(&lesson, &step, help.n_shown);
        self.look_for_hint();
    }

    /// The hint for the scene as it is now, where a part of it is shown.
    pub(super) fn look_for_hint(&mut self) {
        let help = &self.goals.help;
        if help.n_shown == 0 || self.is_reached() {
            return;
        }
        let scene = self.playback.scene();
        let run = self.playback.main();
        let n_steps = run.n_steps();
        let named = self
            .bookmark
            .step()
            .and_then(|step| step.goal.as_ref()?.hint.as_ref());
        let named = named.and_then(|moment| run.find(moment));
        let mut last: Option<(Link, usize)> = None;
        run.visit([1, n_steps.min(LONGEST)], &mut |step, shown| {
            let decision = shown.decision();
            if let Some((_, about)) = decision.filter(|(it, _)| *it != Decides::Nothing) {
                last = Some((about, step));
            }
            ControlFlow::Continue(())
        });
        let mut hint = Hint::default();
        if let Some(step) = named {
            let why = run.caption(step);
            (hint.decides, hint.equation) = (Some(why.decision), why.arithmetic);
        } else if let Some((about, step)) = last {
            let verdict = scene.document().verdict(about, (run, n_steps));
            hint.turned = verdict.as_ref().and_then(|it| it.notes.last().cloned());
            let why = verdict.map_or_else(|| run.caption(step), |verdict| verdict.why);
            (hint.decides, hint.equation) = (Some(why.decision), why.arithmetic);
        }
        hint.compared = self.compared();
        self.goals.help.hint = hint;
    }

    fn compared(&self) -> Option<Message> {
        let open = self.met().iter().position(|is_met| !is_met)?;
        let goal = self.bookmark.step()?.goal.as_ref()?;
        let scene = self.playback.scene();
        let runs = scene.by_method(self.playback.runs());
        let (now, sign, wanted) = goal.compared(open, scene, &runs)?;
        let [_, step_idx] = self.bookmark.at;
        let text = self
            .bookmark
            .lesson()?
            .step_text(step_idx, self.settings.lang)?;
        let part = text.body.iter().find_map(|block| match block {
            Block::Goal { nth, text } if *nth == open => Some(plain(text)),
            _ => None,
        })?;
        // A sign only where the number itself is not the goal.
        let sign = if sign == "=" {
            String::new()
        } else {
            format!("{sign} ")
        };
        let message = Message::new("goal-hint-now").with("part", part);
        let message = message.with("now", now);
        Some(message.with("sign", sign).with("wanted", wanted))
    }

    /// Counts where the run of the scene ends, once nothing is dragged any more; not that of the step's own scene.
    pub(super) fn count_end(&mut self) {
        let recording = self.playback.recording;
        let is_counted = self.goals.help.counted == Some(recording);
        if is_counted || self.met().is_empty() || self.history.is_in_gesture() {
            return;
        }
        let is_first = self.goals.help.counted.replace(recording).is_none();
        if is_first || self.pending.is_some() || self.playback.main().is_refused() {
            return;
        }
        let run = self.playback.main();
        let Caption {
            decision: said,
            arithmetic: so,
            ..
        } = run.caption(run.n_steps());
        let ended = &mut self.goals.help.ended;
        for known in &mut *ended {
            known.is_now = false;
        }
        let known = ended.iter_mut().find(|known| known.said.key == said.key);
        match known {
            Some(known) => {
                (known.said, known.so, known.is_now) = (said, so, true);
                known.count += 1;
            }
            None => ended.push(Ended {
                said,
                so,
                count: 1,
                is_now: true,
            }),
        }
    }
}

fn plain(text: &[Inline]) -> String {
    text.iter().map(|part| &*part.text).collect()
}
