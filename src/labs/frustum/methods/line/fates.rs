//! The step that decided what became of a segment, or of one of its ends.

use crate::{
    algo::{
        parameter::End,
        volume::{LineClip, LineInput, LineRules},
    },
    geom::VolumeSide,
    trace::Algorithm,
};

use super::{
    super::super::part::{Fate, Outcome},
    look::{Event, LineLook, PlaneLook},
};

/// Of an end, or of the whole segment; none where the run never says.
pub fn fate<const N: usize, B: LineLook<N>, L: LineRules>(
    input: &LineInput<N, B>,
    end: Option<End>,
) -> Option<Fate> {
    match end {
        Some(end) => end_fate::<N, B, L>(input, end),
        None => whole_fate::<N, B, L>(input),
    }
}

/// The first plane that an end lies beyond decides; of one that is kept, the last.
fn end_fate<const N: usize, B: LineLook<N>, L: LineRules>(
    LineInput { bounds, ends }: &LineInput<N, B>,
    end: End,
) -> Option<Fate> {
    let (input, mut ends) = (
        LineInput {
            bounds: bounds.clone(),
            ends: *ends,
        },
        *ends,
    );
    let (mut step, mut fate) = (0, None);
    let mut is_lost = false;
    LineClip::<N, B, L>::run::<f64>(&input, |event| {
        step += 1;
        let outcome = match event {
            Event::Depths { ends: now, behind } => {
                ends = now;
                let near = VolumeSide::Near as usize;
                (behind == [true; 2]).then_some(Outcome::Lost(near))
            }
            Event::Row { plane, .. } => {
                let is_outside = bounds.distances(plane, &ends)[end.idx()] < 0.0;
                Some(if is_outside {
                    Outcome::Lost(plane.idx())
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
    });
    fate
}

/// The test after which nothing is left; else the first plane that takes something, or the last look at the interval.
fn whole_fate<const N: usize, B: LineLook<N>, L: LineRules>(
    input: &LineInput<N, B>,
) -> Option<Fate> {
    let (mut step, mut looked, mut fate) = (0, 0, None);
    LineClip::<N, B, L>::run::<f64>(input, |event| {
        step += 1;
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
            } => Some(Outcome::Cut(plane.idx())).filter(|_| fate.is_none()),
            Event::Reject { plane } => {
                let plane = plane.map_or(VolumeSide::Near as usize, PlaneLook::idx);
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
    });
    fate
}
