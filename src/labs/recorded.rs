//! A recorded run of a method that can be told, with its type erased.

use std::{ops::ControlFlow, sync::Arc};

use serde_json::{Value as Json, json};

use crate::{
    figure::{Body, Caption, Choice, Decides, Link, Run, Shown, Tick, View, Watch, Words},
    labs::Answer,
    text::{Message, Value},
    trace::{Counts, Method, Recording},
};

use super::telling::{At, Row, Telling, known_lists, known_names};

pub struct Recorded<M: Telling> {
    recording: Recording<M>,
    /// Kept, so that ticks, lines and decisions need no run: of step 1 the first.
    rows: Vec<&'static Row>,
    scenery: Option<Arc<M::Scenery>>,
    differs_at: Option<usize>,
    /// What is beside the drawing at the end, in place of what the method holds.
    last: Option<Body>,
}

impl<M: Telling> Recorded<M> {
    pub fn new(input: M::Input, scenery: Option<Arc<M::Scenery>>) -> Self {
        let mut rows = Vec::new();
        Self {
            recording: Recording::looking(input, |step| rows.push(M::row(step))),
            rows,
            scenery,
            differs_at: None,
            last: None,
        }
    }

    pub fn ending_in(self, last: Option<Body>) -> Self {
        Self { last, ..self }
    }

    /// The same of a method that may be wrong on purpose: such a run knows where it first differs from the one of `Right`.
    pub fn beside<Right>(input: M::Input, scenery: Option<Arc<M::Scenery>>) -> Self
    where
        Right: Method<Input = M::Input, Event = M::Event>,
    {
        let run = Self::new(input, scenery);
        let differs_at = M::DIFFERS_KEY.and_then(|_| run.recording.first_difference::<Right>());
        Self { differs_at, ..run }
    }

    fn row(&self, step: usize) -> Option<&'static Row> {
        self.rows.get(step.checked_sub(1)?).copied()
    }
}

struct ShownStep<'a, M: Telling> {
    at: At<'a, M>,
    /// The step's number, where the run differs from the right one here for the first time.
    differs: Option<usize>,
    last: Option<&'a Body>,
}

impl<M: Telling> Shown for ShownStep<'_, M> {
    fn caption(&self) -> Caption {
        let mut caption = self.at.caption();
        if let Some((step, key)) = self.differs.zip(M::DIFFERS_KEY) {
            caption.decision = Message::new(key).with("step", step);
        }
        caption
    }

    fn unnumbered(&self) -> Caption {
        self.at.caption()
    }

    fn watch(&self) -> Watch {
        M::watch(&self.at)
    }

    fn views(&self) -> Vec<View> {
        let mut views = M::views(&self.at);
        if let Some(last) = self.last {
            views.truncate(2);
            if let [_, View { body, .. }] = &mut views[..] {
                *body = last.clone();
            }
        }
        views
    }

    fn decision(&self) -> Option<(Decides, Link)> {
        self.at.decision()
    }

    fn question(&self) -> Option<&'static str> {
        self.at.row().answers.map(|question| question.id)
    }

    fn options(&self) -> Option<Choice> {
        self.at.options()
    }

    fn named(&self, name: &str) -> Option<Value> {
        self.at.value(name)
    }

    fn listed(&self, list: &str) -> Vec<Value> {
        let entries = M::listed(&self.at, list).into_iter();
        entries.filter_map(|entry| entry.value).collect()
    }

    fn names(&self) -> Vec<&'static str> {
        known_names(M::ROWS, &M::OPENING, M::WATCH)
    }

    fn lists(&self) -> Vec<&'static str> {
        known_lists(M::ROWS, M::WATCH)
    }
}

impl<M: Telling> Run for Recorded<M> {
    fn n_steps(&self) -> usize {
        self.rows.len()
    }

    fn tick(&self, step: usize) -> Tick {
        if self.differs_at == Some(step) {
            return Tick::Reject;
        }
        match self.row(step).map_or(Tick::Phase, |row| row.tick) {
            // What has gone another way than the right one is not accepted at its end.
            Tick::Accept if self.differs_at.is_some() => Tick::Phase,
            tick => tick,
        }
    }

    fn code_line(&self, step: usize) -> Option<usize> {
        self.row(step).map(|row| row.line)
    }

    fn event_json(&self, step: usize) -> Json {
        let event = self.recording.event_at(step);
        let json = event.and_then(|event| serde_json::to_value(event).ok());
        json.unwrap_or(Json::Null)
    }

    fn read_words(&self, step: usize, words: &mut Words) {
        words.read(&self.recording.event_at(step));
    }

    fn counts_at(&self, step: usize) -> Counts {
        self.recording.counts_at(step)
    }

    fn visit(
        &self,
        from_to: [usize; 2],
        look: &mut dyn FnMut(usize, &dyn Shown) -> ControlFlow<()>,
    ) {
        let scenery = self.scenery.as_deref();
        self.recording.walk(from_to, |n, &step| {
            let at = At { step, scenery };
            let differs = self.differs_at.filter(|&at| at == n);
            let last = self.last.as_ref().filter(|_| n == self.n_steps());
            look(n, &ShownStep { at, differs, last })
        });
    }

    fn output_json(&self) -> Json {
        json!(self.recording.output().told())
    }

    fn differs_at(&self) -> Option<usize> {
        self.differs_at
    }
}
