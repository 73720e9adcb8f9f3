//! Clipping a segment by inequalities, shown: against a box, against planes, and in clip space.

mod bounds;
mod captions;
mod fates;
mod faulty;
mod look;
pub mod marks;
mod points;
mod table;
mod variants;
mod w_lens;

use serde_json::{Value as Json, json};

use crate::{
    algo::{
        ring::Right,
        volume::{LineClip, LineEvent, LineInput, LineRules, LineState, VisibleLine},
    },
    figure::{Body, Caption, Link, Run, Tick, View, Watch, WatchRow, WatchSection},
    labs::{
        Answer, CodeLine, Demo, Step, Verdict, record_beside,
        words::{end_link, end_name, end_name_now, name},
    },
    text::Value,
};

use super::super::{OnScene, OnSceneInput, Scene, Subject, demo::SpaceDemo, part::segment_verdict};

pub use bounds::{face_equation, unit_box};
pub use captions::accepted;

pub use look::end_formula;

use look::{Event, Input, LineLook, ShownLine, Variant, listed};

type Shown<const N: usize, B, L> = OnScene<LineClip<N, B, L>>;

const ROWS_VIEW: &str = "rows";
const AXIS_VIEW: &str = "axis";

impl<const N: usize> Answer for VisibleLine<N> {
    fn json(&self) -> Json {
        let segment = self.as_ref().map(|ends| ends.as_flattened());
        json!({ "visible": self.is_some(), "segment": segment })
    }
}

impl<const N: usize, B: LineLook<N>, L: LineRules + Variant<N, B>> SpaceDemo for Shown<N, B, L>
where
    Right: Variant<N, B>,
{
    const SUBJECT: Subject = B::SUBJECT;

    fn input(scene: &Scene) -> Input<N, B> {
        OnSceneInput::of(scene, B::input(scene))
    }

    fn verdict(scene: &Scene, about: Link, run: &dyn Run) -> Option<Verdict> {
        let input = B::input(scene);
        let fate = |end| fates::fate::<N, B, L>(&input, end);
        segment_verdict(scene, (B::SUBJECT, about), fate, run)
    }

    fn record(scene: &Scene) -> Box<dyn Run> {
        record_beside::<Self, Shown<N, B, Right>>(Self::input(scene))
    }
}

impl<const N: usize, B: LineLook<N>, L: LineRules + Variant<N, B>> Demo for Shown<N, B, L> {
    const ID: &'static str = L::ID;
    const NAME_KEY: &'static str = L::NAME_KEY;
    const SOURCE: &'static str = B::SOURCE;
    const CODE: &'static [CodeLine] = L::CODE;
    const DIFFERS_KEY: Option<&'static str> = L::DIFFERS_KEY;

    fn tick(event: &Self::Event) -> Tick {
        match event {
            Event::Row { .. } => Tick::Phase,
            Event::Delta { .. }
            | Event::Depths { .. }
            | Event::Parallel { .. }
            | Event::Interval { .. } => Tick::Test,
            Event::Enter { .. } | Event::Leave { .. } | Event::Put { .. } => Tick::Cut,
            Event::Accept { .. } => Tick::Accept,
            Event::Reject { .. } => Tick::Reject,
        }
    }

    fn code_line(event: &Self::Event, _: &Self::State) -> usize {
        match event {
            Event::Delta { .. } | Event::Depths { .. } | Event::Reject { plane: None } => {
                variants::START
            }
            Event::Row { .. } => variants::EACH,
            Event::Parallel { .. } => variants::PARALLEL,
            Event::Enter { .. } => variants::ENTER,
            Event::Leave { .. } => variants::LEAVE,
            Event::Interval { .. } | Event::Reject { plane: Some(_) } => variants::EMPTY,
            Event::Put { .. } | Event::Accept { .. } => variants::ACCEPT,
        }
    }

    fn opening(input: &Input<N, B>) -> Caption {
        let [p1, p2] = &input.own.ends;
        Caption::new(input.own.bounds.opening())
            .so(end_formula("P₁", p1))
            .so(end_formula("P₂", p2))
    }

    fn caption(event: &Self::Event, before: &Self::State, input: &Input<N, B>) -> Caption {
        captions::caption::<N, B, L>(event, before, input)
    }

    fn views(step: &Step<'_, Self>) -> Vec<View> {
        let scenery = step.input.scenery.as_deref();
        let shown = shown_line::<N, B, L>(step);
        let mut views = scenery.map_or_else(Vec::new, |scenery| B::drawing(&shown, scenery));
        let rows = || table::rows_table(&shown, step.event, scenery);
        let table = B::points(&shown).unwrap_or_else(rows);
        views.push(View::new(ROWS_VIEW, Body::Table(table)));
        if B::SHOWS_PLANES {
            let reach = reach(step.input);
            let axis = Body::NumberLine(shown.interval.number_line(reach));
            views.push(View::new(AXIS_VIEW, axis));
        }
        views
    }

    fn watch(step: &Step<'_, Self>) -> Watch {
        let scenery = step.input.scenery.as_deref();
        let shown = shown_line::<N, B, L>(step);
        let [first, second] = B::HEADER;
        let header = vec![first, second, B::SYMBOLS[1]];
        let bounds = shown.interval.bound_rows().collect();
        let ends = WatchSection::list(end_rows(step.state));
        let rows = WatchSection::table(header, table::row_values(&shown, scenery));
        let bounds = WatchSection::list(bounds);
        if B::SHOWS_PLANES {
            vec![ends, rows.seen_in(ROWS_VIEW), bounds.seen_in(AXIS_VIEW)]
        } else {
            vec![ends, rows, bounds]
        }
    }
}

fn shown_line<'a, const N: usize, B: LineLook<N>, L: LineRules>(
    step: &'a Step<'_, Shown<N, B, L>>,
) -> ShownLine<'a, N, B>
where
    Shown<N, B, L>:
        Demo<Input = Input<N, B>, State = LineState<B::Plane, N>, Event = LineEvent<B::Plane, N>>,
{
    let scenery = step.input.scenery.as_deref();
    ShownLine {
        input: &step.input.own,
        state: step.state,
        in_hand: table::plane_in_hand(step.state, step.event),
        is_divided: L::DIVIDES_FIRST,
        interval: table::interval::<N, B>(step.state, step.event, scenery),
    }
}

/// Both ends, P₂ − P₁ where it is worked out, and the ends that have been put in place.
fn end_rows<P, const N: usize>(state: &LineState<P, N>) -> Vec<WatchRow> {
    use crate::algo::parameter::End;
    let place = |at: &[f64; N]| Value::Formula(listed(at));
    let mut rows: Vec<WatchRow> = End::BOTH
        .into_iter()
        .map(|end| {
            let at = place(&state.ends[end.idx()]);
            WatchRow::new(end_name(end), Some(at)).linked(end_link(end))
        })
        .collect();
    if let Some(delta) = &state.delta {
        rows.push(WatchRow::new(name("Δ"), Some(place(delta))));
    }
    rows.extend(End::BOTH.into_iter().filter_map(|end| {
        let at = state.put[end.idx()].as_ref()?;
        let row = WatchRow::new(end_name_now(end, true), Some(place(at)));
        Some(row.linked(end_link(end)))
    }));
    rows
}

/// Where the segment's line crosses the planes, to make room for it.
fn reach<const N: usize, B: LineLook<N>>(input: &Input<N, B>) -> impl Iterator<Item = f64> + '_ {
    let LineInput { bounds, ends } = &input.own;
    bounds.planes().map(|plane| {
        let [d1, d2] = bounds.distances(plane, ends);
        d1 / (d1 - d2)
    })
}
