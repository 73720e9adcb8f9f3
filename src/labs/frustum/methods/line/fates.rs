//! The step that decided what became of a segment, or of one of its ends.

use crate::{
    algo::{
        parameter::End,
        segment::{EventOf, Given, LineClip, LineEvent as Event, LineRules},
    },
    geom::VolumeSide,
    trace::Recording,
};

use super::{
    super::super::part::{Fate, Outcome},
    look::SpaceLine,
};

/// Of an end, or of the whole segment; none where the run never says.
pub fn fate<const N: usize, B: SpaceLine<N>, L: LineRules>(
    input: &B::Input,
    end: Option<End>,
) -> Option<Fate> {
    match end {
        Some(end) => end_fate::<N, B, L>(input, end),
        None => whole_fate::<N, B, L>(input),
    }
}

/// The first plane that an end lies beyond decides; of one that is kept, the last.
fn end_fate<const N: usize, B: SpaceLine<N>, L: LineRules>(
    input: &B::Input,
    end: End,
) -> Option<Fate> {
    let (bounds, mut ends) = (input.bounds(), input.ends());
    let (mut fate, mut is_lost) = (None, false);
    for (i, event) in events::<N, B, L>(input).into_iter().enumerate() {
        let step = i + 1;
        let outcome = match event {
            Event::Depths { ends: now, behind } => {
                ends = now;
                let near = VolumeSide::Near as usize;
                (behind == [true; 2]).then_some(Outcome::Lost(near))
            }
            Event::Row { plane, .. } => {
                let is_outside = bounds.distances(plane, &ends)[end.idx()] < 0.0;
                Some(if is_outside {
                    Outcome::Lost(B::idx(plane))
                } else {
                    Outcome::Kept
                })
            }
            Event::Delta { .. }
            | Event::Parallel { .. }
            | Event::Enter { .. }
            | Event::Leave { .. }
            | Event::Interval { .. }
            | Event::Put { .. }
            | Event::Accept { .. }
            | Event::Reject { .. } => None,
        };
        if let Some(outcome) = outcome.filter(|_| !is_lost) {
            is_lost = outcome != Outcome::Kept;
            fate = Some(Fate { step, outcome });
        }
    }
    fate
}

fn events<const N: usize, B: SpaceLine<N>, L: LineRules>(input: &B::Input) -> Vec<EventOf<N, B>> {
    let recording = Recording::<LineClip<N, B, L>>::new(input.clone());
    recording.events().to_vec()
}

/// The test after which nothing is left; else the first plane that takes something, or the last look at the interval.
fn whole_fate<const N: usize, B: SpaceLine<N>, L: LineRules>(input: &B::Input) -> Option<Fate> {
    let (mut looked, mut fate) = (0, None);
    for (i, event) in events::<N, B, L>(input).into_iter().enumerate() {
        let step = i + 1;
        let outcome = match event {
            Event::Enter {
                plane,
                raises: true,
                ..
            }
            | Event::Leave {
                plane,
                lowers: true,
                ..
            } => Some(Outcome::Cut(B::idx(plane))).filter(|_| fate.is_none()),
            Event::Reject { plane } => {
                let plane = plane.map_or(VolumeSide::Near as usize, B::idx);
                let (step, outcome) = (looked, Outcome::Lost(plane));
                fate = Some(Fate { step, outcome });
                None
            }
            Event::Accept { .. } => {
                let (step, outcome) = (looked, Outcome::Kept);
                fate = fate.or(Some(Fate { step, outcome }));
                None
            }
            Event::Depths { .. } | Event::Interval { .. } | Event::Parallel { .. } => {
                looked = step;
                None
            }
            Event::Delta { .. }
            | Event::Row { .. }
            | Event::Enter { .. }
            | Event::Leave { .. }
            | Event::Put { .. } => None,
        };
        if let Some(outcome) = outcome {
            fate = Some(Fate { step, outcome });
        }
    }
    fate
}
