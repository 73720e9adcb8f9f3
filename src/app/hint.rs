//! Help towards the open step's goal: a hint in two parts, what decided its run and the equation; and where its runs have ended.

use std::{ops::ControlFlow, sync::Arc};

use crate::{
    figure::{Caption, Decides, Run},
    labs::{Difference, listed, moved},
    lesson::{Block, Inline, LessonStep},
    text::{Catalog, Formula},
};

use super::{App, desk::Page, prelude::*};

/// What is compared or decides, and the equation.
pub const PARTS: usize = 2;
/// Of more handles nobody keeps in mind which a solution moves.
const MOST_MOVED: usize = 4;
/// In longer runs nobody looks for what decided them while something is dragged.
const LONGEST: usize = 4096;

#[derive(Default)]
pub struct Help {
    /// So many parts of the hint are shown.
    pub n_shown: usize,
    pub hint: Hint,
    /// Found when the hint is first asked for: it is the same whatever becomes of the scene.
    solution: Option<Solution>,
    pub ended: Vec<Ended>,
    /// The recording whose end has been counted last.
    counted: Option<u64>,
}

/// What the lesson's own solution shows.
struct Solution {
    scene: Arc<Scene>,
    /// What it moves, unless that is all that may be moved.
    way: Option<Message>,
    /// Where the two programs of a hunt part in it, and the equation there.
    parted: Option<Message>,
    equation: Vec<Formula>,
}

#[derive(Clone, PartialEq, Debug, Default)]
pub struct Hint {
    pub decides: Option<Message>,
    pub equation: Vec<Formula>,
    /// The least change that turns what was decided.
    pub turned: Option<Message>,
    /// The first part of the goal that does not hold, with the two numbers that it compares, where there are any.
    pub open: Option<Message>,
    /// What one solution moves: of a hunt that comes first.
    pub way: Option<Message>,
    is_of_hunt: bool,
}

impl Hint {
    /// Its sentences in order, the equation behind what decides. The first part is the first of them: which part of the goal is open,
    /// or what a solution moves, or what decided.
    pub fn said(&self, catalog: &Catalog) -> Vec<String> {
        let way = |of_hunt| self.way.iter().filter(move |_| self.is_of_hunt == of_hunt);
        let before = self.open.iter().chain(way(true)).chain(&self.decides);
        let after = self.turned.iter().chain(way(false));
        let mut said: Vec<String> = before.map(|it| catalog.message(it)).collect();
        said.extend(self.equation.iter().map(|it| catalog.formula(it)));
        said.extend(after.map(|it| catalog.message(it)));
        said
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
        if self.goals.help.n_shown == 0 || self.is_reached() {
            return;
        }
        let known = self.goals.help.solution.take();
        let step = self.bookmark.step();
        self.goals.help.solution = step.and_then(|step| Solution::of(step, known));
        let scene = self.playback.scene();
        let run = self.playback.main();
        let n_steps = run.n_steps();
        let goal = self.bookmark.step().and_then(|step| step.goal.as_ref());
        let named = goal.zip(self.first_open());
        let named = named.and_then(|(goal, part)| run.find(goal.hint(part)?));
        let solution = self.goals.help.solution.as_ref();
        let mut hint = Hint {
            open: self.open_part(),
            way: solution.and_then(|it| it.way.clone()),
            is_of_hunt: self.is_hunting(),
            ..Hint::default()
        };
        if let Some(solution) = solution.filter(|_| hint.is_of_hunt) {
            hint.decides.clone_from(&solution.parted);
            hint.equation.clone_from(&solution.equation);
        } else if let Some(step) = named {
            let why = run.caption(step);
            (hint.decides, hint.equation) = (Some(why.decision), why.arithmetic);
        } else if let Some((about, step)) = last_decision(run) {
            let verdict = scene.document().verdict(about, (run, n_steps));
            hint.turned = verdict.as_ref().and_then(|it| it.notes.last().cloned());
            let why = verdict.map_or_else(|| run.caption(step), |verdict| verdict.why);
            (hint.decides, hint.equation) = (Some(why.decision), why.arithmetic);
        }
        self.goals.help.hint = hint;
    }

    /// The first part of the goal that does not hold.
    fn first_open(&self) -> Option<usize> {
        self.met().iter().position(|is_met| !is_met)
    }

    /// A goal of one part says itself what is open, unless that is a number.
    fn open_part(&self) -> Option<Message> {
        let open = self.first_open()?;
        let goal = self.bookmark.step()?.goal.as_ref()?;
        let scene = self.playback.scene();
        let runs = scene.by_method(self.playback.runs());
        let [_, step_idx] = self.bookmark.at;
        let text = self
            .bookmark
            .lesson()?
            .step_text(step_idx, self.settings.lang)?;
        let part = text.body.iter().find_map(|block| match block {
            Block::Goal { nth, text } if *nth == open => Some(plain(text)),
            _ => None,
        })?;
        let Some((now, sign, wanted)) = goal.compared(open, scene, &runs) else {
            let is_one_of_many = goal.n_parts() > 1;
            return is_one_of_many.then(|| Message::new("goal-hint-open").with("part", part));
        };
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

impl Solution {
    /// The `known` one, unless the lesson has another by now.
    fn of(step: &LessonStep, known: Option<Self>) -> Option<Self> {
        let reached = &step.goal.as_ref()?.reached;
        if let Some(known) = known.filter(|known| Arc::ptr_eq(&known.scene, reached)) {
            return Some(known);
        }
        let handles = moved(&step.scene, reached);
        let all = step.scene.document().handles().into_iter();
        let free = all.filter(|it| it.is_part() && !Lock::any_holds(&step.locks, *it));
        let is_said = (1..=MOST_MOVED).contains(&handles.len()) && handles.len() < free.count();
        let way = is_said.then(|| listed(&step.scene, &handles));
        let parted = where_they_part(reached);
        Some(Self {
            scene: reached.clone(),
            way: way.map(|handles| Message::new("goal-hint-way").with("handles", handles)),
            equation: parted
                .as_ref()
                .map_or_else(Vec::new, |why| why.arithmetic.clone()),
            parted: parted.map(|why| Message::new("goal-hint-parts").with("said", why.decision)),
        })
    }
}

/// What the right one of two programs says where a wrong one parts from it.
fn where_they_part(scene: &Scene) -> Option<Caption> {
    let recorded = scene.document().record();
    let difference = Difference::in_scene(scene, &recorded)?;
    let right = recorded.get(1 - difference.column.min(1))?;
    Some(right.caption(difference.step?.min(right.n_steps())))
}

/// What is decided last, and at which step.
fn last_decision(run: &dyn Run) -> Option<(Link, usize)> {
    let mut last = None;
    run.visit([1, run.n_steps().min(LONGEST)], &mut |step, shown| {
        let decision = shown.decision();
        if let Some((_, about)) = decision.filter(|(it, _)| *it != Decides::Nothing) {
            last = Some((about, step));
        }
        ControlFlow::Continue(())
    });
    last
}

fn plain(text: &[Inline]) -> String {
    text.iter().map(|part| &*part.text).collect()
}
