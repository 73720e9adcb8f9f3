//! What every entry of the two lists is at a step: this step's, walked, kept, dropped, or still to come; the same in
//! the lists as in the drawing.

use std::ops::Range;

use super::{names, prelude::*};

pub const BOTH: [List; 2] = [List::Subject, List::Clip];

pub struct Standing {
    ranges: [Range<usize>; 2],
    roles: [Vec<Role>; 2],
}

impl Standing {
    pub fn of(step: &Step<'_, WeilerAtherton>, ranges: [Range<usize>; 2]) -> Self {
        let roles = BOTH.map(|list| {
            let places = ranges[list.idx()].clone();
            places.map(|place| at_rest(step, list, place)).collect()
        });
        let mut standing = Self { ranges, roles };
        standing.walked(step);
        for (list, place) in current(step) {
            standing.set(list, place, Role::Signal);
        }
        if let Some(Event::Whole {
            list,
            places: [start, end],
            kind,
            ..
        }) = step.event()
        {
            let role = kind.map_or(Role::Discarded, |_| Role::Signal);
            for place in start as usize..end as usize {
                standing.set(list, place, role);
            }
        }
        standing
    }

    pub fn role(&self, list: List, place: usize) -> Option<Role> {
        let idx = place.checked_sub(self.ranges[list.idx()].start)?;
        self.roles[list.idx()].get(idx).copied()
    }

    fn set(&mut self, list: List, place: usize, role: Role) {
        let idx = place.checked_sub(self.ranges[list.idx()].start);
        if let Some(known) = idx.and_then(|idx| self.roles[list.idx()].get_mut(idx)) {
            *known = role;
        }
    }

    /// What walks have passed: kept where its ring is closed.
    fn walked(&mut self, step: &Step<'_, WeilerAtherton>) {
        let held = step.held;
        let Walked { passed, kept } = Walked::so_far(step.past);
        let kept = kept
            .iter()
            .map(|&(list, place)| (list, place, Role::Accepted));
        let on_path = |&Passed { list, place, .. }: &Passed| (list, place, Role::Accent);
        for (list, place, role) in kept.chain(passed.iter().map(on_path)) {
            self.set(list, place as usize, role);
            // The walk changes lists where it enters, leaves or pinches: there it has been in both.
            let entry = held.lists.entries[list.idx()][place as usize];
            let Some(node) = entry.node() else {
                continue;
            };
            let is_start = list == List::Subject && held.walk.start == Some(node);
            let stays = label(held, node).is_none_or(|label| label == IntersectionLabel::Touching);
            let twin = place_of(held, list.other(), node);
            if let Some(twin) = twin.filter(|_| !(stays || is_start && role == Role::Accent)) {
                self.set(list.other(), twin, role);
            }
        }
    }
}

pub struct Passed {
    pub list: List,
    pub place: u32,
    /// How many corners the path had before.
    n_before: u32,
}

#[derive(Default)]
pub struct Walked {
    /// Since the last start: entries that belong to no ring yet.
    pub passed: Vec<Passed>,
    pub kept: Vec<(List, u32)>,
}

impl Walked {
    pub fn so_far(past: &[Event]) -> Self {
        let (mut walked, mut n_corners) = (Self::default(), 0);
        let Self { passed, kept } = &mut walked;
        for event in past {
            match *event {
                Event::Start { .. } => {
                    passed.clear();
                    n_corners = 0;
                }
                Event::Visit {
                    list,
                    place,
                    corner,
                    ..
                } => {
                    let n_before = n_corners;
                    passed.push(Passed {
                        list,
                        place,
                        n_before,
                    });
                    n_corners += u32::from(corner);
                }
                Event::Closed { from, .. } => {
                    let n_left = passed.partition_point(|passed| passed.n_before < from);
                    kept.extend(passed.drain(n_left..).map(|it| (it.list, it.place)));
                    n_corners = from;
                }
                Event::Whole {
                    list,
                    places: [start, end],
                    kind: Some(_),
                    ..
                } => kept.extend((start..end).map(|place| (list, place))),
                Event::Whole { kind: None, .. }
                | Event::Vertex { .. }
                | Event::Found { .. }
                | Event::Inserted { .. }
                | Event::Labelled { .. }
                | Event::Switch { .. }
                | Event::Hole { .. }
                | Event::Done { .. } => {}
            }
        }
        walked
    }
}

fn at_rest(step: &Step<'_, WeilerAtherton>, list: List, place: usize) -> Role {
    match step.held.lists.entries[list.idx()].get(place) {
        None => Role::Faint,
        Some(_) if is_done(step.event()) => Role::Discarded,
        Some(entry) if entry.node().is_some() => Role::Ink,
        Some(_) => Role::Soft,
    }
}

pub fn current(step: &Step<'_, WeilerAtherton>) -> Vec<(List, usize)> {
    let held = step.held;
    let last = |list: List| Some((list, held.lists.entries[list.idx()].len().checked_sub(1)?));
    let of_node = |list, node| Some((list, place_of(held, list, node)?));
    let both = |node| BOTH.map(|list| of_node(list, node));
    let entries = match step.event() {
        None | Some(Event::Whole { .. } | Event::Hole { .. } | Event::Done { .. }) => [None; 2],
        Some(Event::Vertex { list, .. }) => [last(list), None],
        Some(
            Event::Found { node_idx, .. }
            | Event::Inserted { node_idx, .. }
            | Event::Labelled { node_idx, .. }
            | Event::Switch { node_idx, .. },
        ) => both(node_idx),
        Some(Event::Start { node_idx }) => [of_node(List::Subject, node_idx), None],
        Some(Event::Visit { list, place, .. }) => [Some((list, place as usize)), None],
        Some(Event::Closed { .. }) => taken(step).map_or([None; 2], |(node, _)| both(node)),
    };
    entries.into_iter().flatten().collect()
}

/// The intersection at which lists are changed at this step, and the list that is left there.
pub fn taken(step: &Step<'_, WeilerAtherton>) -> Option<(u32, List)> {
    let event = step.event()?;
    if let Event::Inserted { node_idx, .. } = event {
        return Some((node_idx, List::Subject));
    }
    if let Event::Switch { node_idx, to, .. } = event {
        return Some((node_idx, to.other()));
    }
    let Event::Closed { .. } = event else {
        return None;
    };
    // Back where the walk has been, by the clip polygon's list.
    let (list, place) = step.held.walk.position?;
    let next = next_place(step.held, list, place as usize);
    let entry = step.held.lists.entries[list.idx()].get(next)?;
    Some((entry.node()?, list)).filter(|&(_, left)| left == List::Clip)
}

/// The polygon's own vertex at a place, also where it is still to come.
pub fn vertex_at(step: &Step<'_, WeilerAtherton>, list: List, place: usize) -> Option<usize> {
    let entries = &step.held.lists.entries[list.idx()];
    match entries.get(place) {
        Some(entry) => entry.vertex().map(|vertex| vertex as usize),
        None => Some(n_vertices(step.held, list) + place - entries.len()),
    }
}

pub fn place_of(held: &Held, list: List, node: u32) -> Option<usize> {
    held.lists.nodes.get(node as usize)?.place(list)
}

pub fn next_place(held: &Held, list: List, place: usize) -> usize {
    held.lists.entries[list.idx()][place].next as usize
}

pub fn label(held: &Held, node: u32) -> Option<IntersectionLabel> {
    let label = held.labels.get(node as usize)?;
    Some(label.label)
}

/// How many entries a list will have without the intersections that are not found yet.
pub fn len(step: &Step<'_, WeilerAtherton>, list: List) -> usize {
    step.held.lists.entries[list.idx()].len() + names::border(step.input, list).points().len()
        - n_vertices(step.held, list)
}

/// How many of a polygon's own vertices are in its list.
pub fn n_vertices(held: &Held, list: List) -> usize {
    let mut entries = held.lists.entries[list.idx()].iter().rev();
    let last = entries.find_map(Entry::vertex);
    last.map_or(0, |last| last as usize + 1)
}

pub const fn is_done(event: Option<Event>) -> bool {
    matches!(event, Some(Event::Done { .. }))
}

/// Filled where the subject enters, hollow where it leaves, a cross where it does neither, or is not known to, and a
/// ring with a cross where both borders pinch.
pub const fn marker(label: Option<IntersectionLabel>) -> ItemMarker {
    match label {
        Some(IntersectionLabel::Entering) => ItemMarker::Dot,
        Some(IntersectionLabel::Leaving) => ItemMarker::Ring,
        Some(IntersectionLabel::Pinching) => ItemMarker::CrossedRing,
        Some(IntersectionLabel::Touching) | None => ItemMarker::Cross,
    }
}
