//! The step that decided what became of a segment, or of one of its ends.

use crate::{
    algo::segment::{EventOf, Given, LineClip, LineEvent as Event, LineRules},
    labs::frustum::prelude::*,
};

use super::super::super::part::{Fate, Outcome};

const NEAR: usize = VolumeSide::Near as usize;

pub fn fate<const N: usize, B: LineLook<N>, L: LineRules>(
    input: &B::Input,
    end: Option<End>,
) -> Option<Fate> {
    let recording = Recording::<LineClip<N, B, L>>::new(input.clone());
    let events = (1..).zip(recording.events().iter().copied());
    let number = |plane| input.bounds().planes().position(|it| it == plane);
    let number = |plane| number(plane).unwrap_or_default();
    match end {
        None => of_segment::<N, B>(events, number),
        Some(end) => of_end::<N, B>(events, number, (input, end)),
    }
}

/// The test after which nothing is left; else the first plane that takes something, or the last look at the interval.
fn of_segment<const N: usize, B: LineLook<N>>(
    events: impl Iterator<Item = (usize, EventOf<N, B>)>,
    number: impl Fn(B::Plane) -> usize,
) -> Option<Fate> {
    let (mut looked, mut fate) = (0, None);
    for (step, event) in events {
        let (step, outcome) = match event {
            Event::Enter {
                plane,
                raises: true,
                ..
            }
            | Event::Leave {
                plane,
                lowers: true,
                ..
            } if fate.is_none() => (step, Outcome::Cut(number(plane))),
            Event::Reject { plane } => (looked, Outcome::Lost(plane.map_or(NEAR, &number))),
            Event::Accept { .. } if fate.is_none() => (looked, Outcome::Kept),
            Event::Depths { .. } | Event::Interval { .. } | Event::Parallel { .. } => {
                looked = step;
                continue;
            }
            Event::Delta { .. }
            | Event::Row { .. }
            | Event::Put { .. }
            | Event::Enter { .. }
            | Event::Leave { .. }
            | Event::Accept { .. } => continue,
        };
        fate = Some(Fate { step, outcome });
    }
    fate
}

/// The first plane that it lies beyond decides; of one that is kept, the last.
fn of_end<const N: usize, B: LineLook<N>>(
    events: impl Iterator<Item = (usize, EventOf<N, B>)>,
    number: impl Fn(B::Plane) -> usize,
    (input, end): (&B::Input, End),
) -> Option<Fate> {
    let mut fate = None;
    let mut ends = input.ends();
    for (step, event) in events {
        let outcome = match event {
            Event::Depths {
                behind: [true, true],
                ..
            } => Outcome::Lost(NEAR),
            Event::Depths { ends: now, .. } => {
                ends = now;
                continue;
            }
            Event::Row { plane, .. } if input.bounds().distances(plane, &ends)[end.idx()] < 0.0 => {
                Outcome::Lost(number(plane))
            }
            Event::Row { .. } => Outcome::Kept,
            Event::Delta { .. }
            | Event::Put { .. }
            | Event::Interval { .. }
            | Event::Parallel { .. }
            | Event::Enter { .. }
            | Event::Leave { .. }
            | Event::Accept { .. }
            | Event::Reject { .. } => continue,
        };
        fate = Some(Fate { step, outcome });
        if outcome != Outcome::Kept {
            break;
        }
    }
    fate
}
