//! How a line clipper is shown: its events' sentences, marks and watched values.

use serde_json::{Value as Json, json};

use crate::{
    algo::line::Visible,
    figure::{Caption, Frame, Mark, NumberLine, Run, Tick, Watch, mark_changes},
    geom::Segment,
    trace::{Algorithm, Counted, Counts, Trace, silent},
};

use super::{Scene, registry::CodeLine};

/// A line clipper that can be shown.
pub trait Demo:
    Algorithm<Output = Visible, Event: serde::Serialize + 'static> + Sized + 'static
{
    /// As JSON spells it.
    const ID: &'static str;
    /// Catalogue key of the name.
    const NAME_KEY: &'static str;
    /// Author and year.
    const SOURCE: &'static str;
    /// Its pseudocode.
    const CODE: &'static [CodeLine];
    /// Can it clip against any convex polygon?
    const TAKES_POLYGON: bool = false;
    /// Does it write outcodes, so that the order of their bits matters?
    const WRITES_CODES: bool = false;

    /// Its input, from the scene and one of its segments.
    fn input(scene: &Scene, segment: Segment) -> Self::Input;
    /// The shape of the event's tick.
    fn tick(event: &Self::Event) -> Tick;
    /// The line of pseudocode that the event belongs to; `before` is the state that it happened to.
    fn code_line(event: &Self::Event, before: &Self::State) -> usize;
    /// The sentence of an event; `before` is the state that it happened to.
    fn caption(event: &Self::Event, before: &Self::State, input: &Self::Input) -> Caption;
    /// What is said before the first event.
    fn opening(input: &Self::Input) -> Caption;
    /// What is drawn over the window.
    fn marks(step: &Step<'_, Self>) -> Vec<Mark>;
    /// The values that are alive.
    fn watch(step: &Step<'_, Self>) -> Watch;
    /// The second view, where there is one.
    fn number_line(_step: &Step<'_, Self>) -> Option<NumberLine> {
        None
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

struct Recorded<A: Demo>(Trace<A>);

/// Records one run, for the registry.
pub(super) fn record<A: Demo>(scene: &Scene, segment: Segment) -> Box<dyn Run> {
    Box::new(Recorded::<A>(Trace::record(A::input(scene, segment))))
}

/// The answer alone, for the registry.
pub(super) fn clip<A: Demo>(scene: &Scene, segment: Segment) -> Visible {
    silent::<A>(&A::input(scene, segment))
}

/// The answer and its cost, without recording, for the registry.
pub(super) fn cost<A: Demo>(scene: &Scene, segment: Segment) -> (Visible, Counts) {
    let input = A::input(scene, segment);
    Counts::of(|| A::run::<Counted>(&input, |_| {}))
}

/// An answer as the fields of `output` in `interfaces.md`.
#[must_use]
pub fn output_json(visible: &Visible) -> Json {
    json!({ "visible": visible.is_some(), "segment": visible })
}

impl<A: Demo> Recorded<A> {
    fn watch_at(&self, step: usize) -> Watch {
        A::watch(&Step {
            input: self.0.input(),
            state: &self.0.state_at(step),
            event: self.0.event_at(step),
        })
    }
}

impl<A: Demo> Run for Recorded<A> {
    fn n_steps(&self) -> usize {
        self.0.events().len()
    }

    fn tick(&self, step: usize) -> Tick {
        self.0
            .event_at(step)
            .map_or(Tick::Phase, |event| A::tick(&event))
    }

    fn event_json(&self, step: usize) -> Json {
        self.0
            .event_at(step)
            .and_then(|event| serde_json::to_value(event).ok())
            .unwrap_or(Json::Null)
    }

    fn counts_at(&self, step: usize) -> Counts {
        self.0.counts_at(step)
    }

    fn frame(&self, step: usize) -> Frame {
        let trace = &self.0;
        let (state, event) = (trace.state_at(step), trace.event_at(step));
        let shown = Step::<A> {
            input: trace.input(),
            state: &state,
            event,
        };
        let before = step.checked_sub(1).map(|step| trace.state_at(step));
        let mut watch = A::watch(&shown);
        if step > 0 {
            mark_changes(&mut watch, &self.watch_at(step - 1));
        }
        Frame {
            marks: A::marks(&shown),
            caption: match (event, &before) {
                (Some(event), Some(before)) => A::caption(&event, before, trace.input()),
                _ => A::opening(trace.input()),
            },
            code_line: event
                .zip(before)
                .map(|(event, before)| A::code_line(&event, &before)),
            watch,
            number_line: A::number_line(&shown),
            counts: trace.counts_at(step),
        }
    }

    fn output_json(&self) -> Json {
        output_json(self.0.output())
    }
}
