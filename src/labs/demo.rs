//! How an algorithm is shown: its events' sentences, marks and watched values.

use std::ops::ControlFlow;

use serde::Serialize;
use serde_json::Value as Json;

use crate::{
    figure::{Caption, Run, Shown, Tick, View, Watch, Words},
    text::Message,
    trace::{Algorithm, Counts, Trace},
};

use super::{CodeLine, MethodCard};

/// An answer that can be written down.
pub trait Answer {
    /// The fields of `output` in `interfaces.md`.
    fn json(&self) -> Json;
}

/// An algorithm that can be shown.
pub trait Demo: Algorithm<Output: Answer, Event: Serialize> + Sized + 'static {
    /// As JSON spells it.
    const ID: &'static str;
    /// Catalogue key of the name.
    const NAME_KEY: &'static str;
    /// Author and year.
    const SOURCE: &'static str;
    /// Its pseudocode.
    const CODE: &'static [CodeLine];
    /// Of one that is wrong on purpose: what is said at the first step that the right one does not do.
    const DIFFERS_KEY: Option<&'static str> = None;

    /// The shape of the event's tick.
    fn tick(event: &Self::Event) -> Tick;
    /// The line of pseudocode that the event belongs to; `before` is the state that it happened to.
    fn code_line(event: &Self::Event, before: &Self::State) -> usize;
    /// The sentence of an event; `before` is the state that it happened to.
    fn caption(event: &Self::Event, before: &Self::State, input: &Self::Input) -> Caption;
    /// What is said before the first event.
    fn opening(input: &Self::Input) -> Caption;
    /// What is shown: first the drawing, without the backdrop, then what the algorithm holds.
    fn views(step: &Step<'_, Self>) -> Vec<View>;
    /// The values that are alive.
    fn watch(step: &Step<'_, Self>) -> Watch;
}

impl MethodCard {
    /// The card of a method that can be shown.
    #[must_use]
    pub const fn of<A: Demo>() -> Self {
        Self {
            id: A::ID,
            name_key: A::NAME_KEY,
            source: A::SOURCE,
            code: A::CODE,
            is_faulty: A::DIFFERS_KEY.is_some(),
        }
    }
}

/// A step to be shown: the input, the state now, and the event that led to it.
pub struct Step<'a, A: Algorithm> {
    /// What the algorithm runs on.
    pub input: &'a A::Input,
    /// After the event.
    pub state: &'a A::State,
    /// `None` before the first event.
    pub event: Option<A::Event>,
}

/// Records one run, with its type erased.
pub(crate) fn record<A: Demo>(input: A::Input) -> Box<dyn Run> {
    Box::new(Recorded::<A> {
        trace: Trace::record(input),
        differs_at: None,
    })
}

/// The same by any rules: the run of one that is wrong on purpose knows where it first differs from the one of `Right`.
pub(crate) fn record_beside<A: Demo, Right>(input: A::Input) -> Box<dyn Run>
where
    Right: Algorithm<Input = A::Input, Event = A::Event>,
{
    let trace = Trace::<A>::record(input);
    let differs_at = A::DIFFERS_KEY.and_then(|_| trace.first_difference::<Right>());
    Box::new(Recorded { trace, differs_at })
}

struct Recorded<A: Demo> {
    trace: Trace<A>,
    differs_at: Option<usize>,
}

impl<A: Demo> Recorded<A> {
    /// The sentence of the event that leads to a step; `before` is the state that it happened to.
    fn sentence(&self, step: usize, event: &A::Event, before: &A::State) -> Caption {
        let mut caption = A::caption(event, before, self.trace.input());
        if let Some(key) = A::DIFFERS_KEY
            && self.differs_at == Some(step)
        {
            caption.decision = Message::new(key).with("step", step);
        }
        caption
    }
}

/// A step of a run, as it is told.
struct ShownStep<'a, A: Demo> {
    run: &'a Recorded<A>,
    step: usize,
    state: A::State,
}

impl<A: Demo> ShownStep<'_, A> {
    fn demo_step(&self) -> Step<'_, A> {
        let trace = &self.run.trace;
        Step {
            input: trace.input(),
            state: &self.state,
            event: trace.event_at(self.step),
        }
    }
}

impl<A: Demo> Shown for ShownStep<'_, A> {
    fn caption(&self) -> Caption {
        let trace = &self.run.trace;
        trace.event_at(self.step).map_or_else(
            || A::opening(trace.input()),
            |event| {
                let before = trace.state_at(self.step - 1);
                self.run.sentence(self.step, &event, &before)
            },
        )
    }

    fn watch(&self) -> Watch {
        A::watch(&self.demo_step())
    }

    fn views(&self) -> Vec<View> {
        A::views(&self.demo_step())
    }
}

impl<A: Demo> Run for Recorded<A> {
    fn n_steps(&self) -> usize {
        self.trace.events().len()
    }

    fn tick(&self, step: usize) -> Tick {
        if self.differs_at == Some(step) {
            return Tick::Reject;
        }
        let event = self.trace.event_at(step);
        event.map_or(Tick::Phase, |event| A::tick(&event))
    }

    fn event_json(&self, step: usize) -> Json {
        self.trace
            .event_at(step)
            .and_then(|event| serde_json::to_value(event).ok())
            .unwrap_or(Json::Null)
    }

    fn read_words(&self, step: usize, words: &mut Words) {
        words.read(&self.trace.event_at(step));
    }

    fn counts_at(&self, step: usize) -> Counts {
        self.trace.counts_at(step)
    }

    fn code_line(&self, step: usize) -> Option<usize> {
        let event = self.trace.event_at(step)?;
        Some(A::code_line(&event, &self.trace.state_at(step - 1)))
    }

    fn visit(
        &self,
        [from, to]: [usize; 2],
        look: &mut dyn FnMut(usize, &dyn Shown) -> ControlFlow<()>,
    ) {
        for step in from..=to.min(self.n_steps()) {
            let state = self.trace.state_at(step);
            if look(
                step,
                &ShownStep {
                    run: self,
                    step,
                    state,
                },
            )
            .is_break()
            {
                return;
            }
        }
    }

    fn output_json(&self) -> Json {
        self.trace.output().json()
    }

    fn differs_at(&self) -> Option<usize> {
        self.differs_at
    }
}
