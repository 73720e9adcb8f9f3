//! What the views of a step of Sutherland–Hodgman show.

use crate::{
    algo::polygon::{
        RingOutcome, SutherlandHodgman, SutherlandHodgmanEvent as Event,
        SutherlandHodgmanInput as Input,
    },
    labs::rings::RingStep,
    trace::Step,
};

use super::{clip_edge::ClipEdge, skin::LabVertex, variant::Variant};

/// A step, as it is drawn.
pub struct Picture<'a, V> {
    pub input: &'a Input<V>,
    pub rings: RingStep<'a, V>,
    /// The clip edge whose turn it is.
    pub edge: Option<ClipEdge<'a>>,
    pub event: Option<Event<V>>,
    /// What is left, at the end.
    pub outcome: Option<RingOutcome>,
}

impl<'a, V: LabVertex> Picture<'a, V> {
    pub fn of<L: Variant>(step: &Step<'a, SutherlandHodgman<V, L>>) -> Self {
        let is_turn = |event: &Event<V>| matches!(event, Event::Edge { .. });
        let outcome = if let Some(Event::Done { outcome }) = step.event() {
            Some(outcome)
        } else {
            None
        };
        Self {
            input: step.input,
            rings: RingStep::of(&step.held.lists, step.past, is_turn),
            edge: edge(step),
            event: step.event(),
            outcome,
        }
    }
}

/// The clip edge whose turn it is.
pub fn edge<'a, V: LabVertex, L: Variant>(
    step: &Step<'a, SutherlandHodgman<V, L>>,
) -> Option<ClipEdge<'a>> {
    let region = &step.input.region;
    let nth = step.held.lists.n_passed();
    let idx = match step.event()? {
        Event::Edge { edge_idx, .. } | Event::Pass { edge_idx, .. } => edge_idx,
        Event::Done { .. } => return None,
        Event::First { .. } | Event::Test { .. } | Event::Cross { .. } | Event::Output { .. } => {
            if L::CLOCKWISE {
                region.n_edges() - 1 - nth
            } else {
                nth
            }
        }
    };
    Some(ClipEdge::new(region, idx, L::LOOK))
}
