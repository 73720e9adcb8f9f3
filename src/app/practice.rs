//! Asking what comes: practice does before every decision of a run, a step of a lesson before its own. What might come, what
//! does, and why are the step's own.

mod asked;
mod taken_back;

use std::{collections::BTreeSet, ops::ControlFlow};

use crate::{
    figure::{Chip, Choice},
    lesson::Asks,
};

use super::{App, Command, answers::Answer, desk::Page, prelude::*};

pub(super) use asked::{Asked, DIGITS};

/// Of so many steps the decisions are looked at to keep room for their questions.
const MOST_LOOKED_AT: usize = 512;

#[derive(Default)]
pub struct Practice {
    pub is_on: bool,
    pub(super) asked: Option<Asked>,
    /// The longest of each kind of question that is asked here, asked or not: they all have room from the start.
    pub(super) kept: Vec<Choice>,
    /// Steps of this recording that have been answered, or shown: they are not asked again.
    done: BTreeSet<usize>,
    recording: u64,
    /// Answered right before anything was shown, and all that were answered.
    pub(super) told: [usize; 2],
    /// What was answered of this recording.
    pub(super) answers: Vec<Answer>,
    /// The step of the course that asks its whole run, and whether an answer had to be shown.
    of: Option<Page>,
    is_helped: bool,
}

impl Practice {
    /// Is a question open, so that nothing may tell what comes?
    pub fn is_asking(&self) -> bool {
        self.open().is_some()
    }

    /// The question that has not been answered.
    pub(super) fn open(&self) -> Option<&Asked> {
        self.asked.as_ref().filter(|asked| asked.chosen.is_none())
    }

    /// What of the options is marked on the stage.
    pub(super) fn chips(&self) -> &[Chip] {
        self.asked.as_ref().map_or(&[], |asked| &asked.chips)
    }

    /// The step that is asked about.
    pub(super) fn step_asked(&self) -> Option<usize> {
        self.open().map(|asked| asked.step)
    }

    const fn is_answered(&self) -> bool {
        matches!(&self.asked, Some(it) if it.chosen.is_some())
    }

    /// Does the open step of the course wait for an answer, or for the rest of its run, and its text with it?
    pub fn asks_for_a_step(&self) -> bool {
        let is_of_run = self.is_on && self.of.is_some();
        is_of_run || self.open().is_some_and(|asked| asked.of.is_some())
    }

    /// The option that is about this.
    pub fn option_of(&self, link: Link) -> Option<usize> {
        let links = &self.open()?.choice.links;
        links.iter().position(|it| *it == Some(link))
    }
}

impl App {
    /// Begins to ask, from here on, or from the first step where the run is at its end; or asks no more.
    pub(super) fn practise(&mut self) {
        let is_on = !self.practice.is_on;
        self.practice = Practice {
            is_on,
            recording: self.playback.recording,
            ..Practice::default()
        };
        self.keep_room();
        if is_on {
            self.playback.transport.pause();
            if self.position() == self.playback.transport.n_steps() {
                self.seek(0);
            }
            self.walk_to(self.playback.transport.n_steps());
        }
    }

    /// Keeps room for whatever is asked of this run, so that no question and no answer moves the stage.
    pub(super) fn keep_room(&mut self) {
        let asks = self.bookmark.step().and_then(|step| step.asks);
        let asks = asks.filter(|_| self.settings.asks || self.practice.asked.is_some());
        let run = self.playback.main();
        let steps = if self.practice.is_on || asks == Some(Asks::Run) {
            Some([1, run.n_steps().min(MOST_LOOKED_AT)])
        } else {
            let home = self.own().filter(|_| asks.is_some());
            let decision = home.and_then(|(_, home)| run.decision_by(home));
            decision.map(|(step, _)| [step; 2])
        };
        let Some(steps) = steps else {
            self.practice.kept.clear();
            return;
        };
        let catalog = self.catalog();
        let length = |choice: &Choice| choice.said(catalog).concat().chars().count();
        let mut kept = std::mem::take(&mut self.practice.kept);
        run.visit(steps, &mut |_, shown| {
            if let Some(choice) = shown.options().filter(Choice::is_open) {
                let kind = |it: &Choice| (it.question, it.options.len());
                match kept.iter_mut().find(|it| kind(it) == kind(&choice)) {
                    Some(known) if length(known) < length(&choice) => *known = choice,
                    Some(_) => {}
                    None => kept.push(choice),
                }
            }
            ControlFlow::Continue(())
        });
        self.practice.kept = kept;
    }

    /// What is left to be done of a command: on the way forward the run stops at the next question.
    pub(super) fn practised(&mut self, command: Command) -> Option<Command> {
        // What lies over the question closes first.
        if matches!(command, Command::Cancel) && self.is_covered() {
            return Some(command);
        }
        // Why a thing is kept or dropped would answer.
        if self.practice.is_asking() && matches!(command, Command::Ask(Some(_)) | Command::Verdict)
        {
            return None;
        }
        if !self.practice.is_on {
            return self.answered(command);
        }
        let (now, last) = (self.position(), self.playback.transport.n_steps());
        let is_answered = self.practice.is_answered();
        let to = match command {
            Command::Step(by) => now.saturating_add_signed(by),
            Command::Seek(step) => step,
            Command::Phase(by) => self.playback.phase(by),
            Command::Play => last,
            Command::Lesson { forward: true } | Command::CloseOutline if is_answered => last,
            Command::Choose(nth) => {
                self.choose(Some(nth));
                return None;
            }
            Command::ShowMe => {
                self.choose(None);
                return None;
            }
            Command::TakeBack if self.practice.has_answered() => {
                if let Some(stands) = self.practice.take_back(self.playback.main()) {
                    self.seek(stands);
                }
                return None;
            }
            Command::Cancel if self.practice.asked.is_some() => {
                self.practice.is_on = false;
                self.practice.asked = None;
                return None;
            }
            command => return Some(command),
        };
        if to > now {
            if !self.practice.is_asking() {
                self.walk_to(to.min(last));
            }
            return None;
        }
        self.practice.asked = None;
        Some(command)
    }

    /// What is left to be done of a command while a step of the course has asked, or nothing has.
    fn answered(&mut self, command: Command) -> Option<Command> {
        let is_answered = self.practice.is_answered();
        let Some(asked) = &self.practice.asked else {
            return Some(command);
        };
        let now = self.position();
        let is_forward = match command {
            Command::Step(by) | Command::Phase(by) => by > 0,
            Command::Seek(step) => step > now,
            Command::Play => true,
            _ => false,
        };
        // What the step says is true of its own moment.
        let is_left = matches!(command, Command::Cancel);
        let goes_on = matches!(command, Command::Play | Command::CloseOutline);
        // In a presentation the lesson's own question comes in the place of this one.
        let asks_next = matches!(command, Command::Lesson { forward: true })
            && self.is_presenting()
            && self.has_answer()
            && !self.shown.is_answered;
        match command {
            Command::Choose(nth) => self.choose(Some(nth)),
            Command::ShowMe => self.choose(None),
            // Whoever pages through a lesson is shown what comes.
            Command::Lesson { forward: true } if !is_answered => self.choose(None),
            _ if is_left || is_answered && (goes_on || asks_next) => {
                let home = self.own().map_or(asked.step, |(_, position)| position);
                self.practice.asked = None;
                self.seek(home);
            }
            _ if is_forward && !is_answered => {}
            Command::Step(_) | Command::Seek(_) | Command::Phase(_) => {
                self.practice.asked = None;
                return Some(command);
            }
            command => return Some(command),
        }
        None
    }

    /// Where the open step of the course asks what comes, and that has not been told yet, or is to be asked `again`, the run
    /// waits before it.
    pub(super) fn ask_of_step(&mut self, again: bool) {
        if self.practice.of.take().is_some() {
            // Another page is open.
            self.practice.is_on = false;
        }
        if self.practice.is_on {
            return;
        }
        self.practice.asked = None;
        self.practice.kept.clear();
        if self.practice.forget_answers(self.playback.recording) {
            self.practice.told = [0; 2];
        }
        self.keep_room();
        let page = self.bookmark.page();
        let asks = self.bookmark.step().and_then(|step| step.asks);
        let is_told = || self.told_of_step() >= Told::AfterTheNumbers;
        let is_asked = again || (self.settings.asks && !is_told());
        let is_asked = is_asked && self.composed().is_none();
        let Some(asks) = asks.filter(|_| is_asked && self.is_untouched()) else {
            return;
        };
        if self.pending.is_some() {
            return;
        }
        if asks == Asks::Run {
            self.seek(0);
            self.practise();
            self.practice.of = page;
            return;
        }
        let Some((_, home)) = self.own() else { return };
        let Some((step, choice)) = self.playback.main().decision_by(home) else {
            return;
        };
        let asked = Asked::in_run(self.playback.main(), step, choice);
        let stands = asked.stands;
        self.practice.asked = Some(Asked { of: page, ..asked });
        self.keep_room();
        self.seek(stands);
    }

    /// To this step, or as far as the first decision on the way that has not been answered.
    fn walk_to(&mut self, to: usize) {
        self.practice.asked = None;
        let now = self.position();
        let done = &self.practice.done;
        let mut asked = None;
        if to > now {
            let run = self.playback.main();
            run.visit([now + 1, to], &mut |step, shown| {
                if done.contains(&step) {
                    return ControlFlow::Continue(());
                }
                let choice = shown.options().filter(Choice::is_open);
                let found = choice.map(|choice| Asked::in_run(run, step, choice));
                // What a whole phase leads to is told, where its steps have been asked.
                asked = found.filter(|asked| asked.stands >= now);
                match asked {
                    None => ControlFlow::Continue(()),
                    Some(_) => ControlFlow::Break(()),
                }
            });
        }
        self.seek(asked.as_ref().map_or(to, |asked| asked.stands));
        self.practice.asked = asked;
        if self.practice.asked.is_none() && to == self.playback.transport.n_steps() {
            self.finish_run();
        }
    }

    /// The whole run of a step has been asked: no more is, and its text and claim open.
    fn finish_run(&mut self) {
        let [right, all] = self.practice.told;
        let is_whole = right == all && !self.practice.is_helped;
        if let Some(Page::Step(lesson, step)) = self.practice.of.take() {
            self.settings.progress.finish(&lesson, &step, is_whole);
            self.practice.is_on = false;
        }
    }

    /// Answers the open question, or has its answer shown; then the run shows what comes.
    fn choose(&mut self, nth: Option<usize>) {
        let practice = &mut self.practice;
        let Some(asked) = practice.asked.as_mut().filter(|it| it.chosen.is_none()) else {
            return;
        };
        let right = asked.choice.right;
        let chosen = nth.unwrap_or(right);
        if chosen >= asked.choice.options.len() {
            return;
        }
        (asked.chosen, asked.is_shown) = (Some(chosen), nth.is_none());
        asked.chips = asked.choice.chips(asked.chosen, DIGITS.len());
        if nth.is_some() {
            practice.told[0] += usize::from(chosen == right);
            practice.told[1] += 1;
            if let Some(Page::Step(lesson, step)) = &asked.of {
                let progress = &mut self.settings.progress;
                progress.answer(lesson, step, chosen == right);
            }
        }
        practice.is_helped |= nth.is_none();
        practice.done.insert(asked.step);
        let step = asked.step;
        practice.answers.push(Answer {
            step,
            choice: asked.choice.clone(),
            chosen,
            is_shown: nth.is_none(),
        });
        self.seek(step);
        if self.practice.is_on && self.settings.marks_at_end {
            self.walk_to(self.playback.transport.n_steps());
        }
    }

    /// Another recording has other decisions: it is asked where the run stands now.
    pub(super) fn ask_anew(&mut self) {
        if !self.practice.forget_answers(self.playback.recording) {
            return;
        }
        // Of a scene that was changed no answer is the step's.
        self.practice.of = None;
        if self.practice.is_on {
            self.keep_room();
        }
        let was_asking = self.practice.is_asking();
        self.practice.asked = None;
        if self.practice.is_on && was_asking {
            self.walk_to(self.playback.transport.n_steps());
        }
    }
}

/// While a question is open digits belong to it, and S shows what comes.
pub fn keys(app: &App, ctx: &Context) -> Vec<Command> {
    let Some(asked) = app.practice.open() else {
        return Vec::new();
    };
    if ctx.input(|input| input.modifiers.any()) {
        return Vec::new();
    }
    let n = asked.choice.options.len();
    let digits = DIGITS.iter().take(n).enumerate();
    let keys = digits.map(|(nth, key)| (*key, Command::Choose(nth)));
    let keys = keys.chain([(Key::S, Command::ShowMe)]);
    ctx.input_mut(|input| {
        let pressed = keys.filter(|(key, _)| input.consume_key(Modifiers::NONE, *key));
        pressed.map(|(_, command)| command).collect()
    })
}
