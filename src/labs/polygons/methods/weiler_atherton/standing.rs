//! What every entry of the two lists is at a step: this step's, walked, kept, dropped, or still to come; the same in
//! the lists as in the drawing.

use std::ops::Range;

use crate::{
    algo::polygon::weiler_atherton::{
        IntersectionLabel, List, ListEntry, Passed, WeilerAtherton, WeilerAthertonEvent as Event,
        WeilerAthertonState as State,
    },
    figure::Role,
    labs::Step,
};

use super::names;

/// Both lists.
pub const BOTH: [List; 2] = [List::Subject, List::Clip];

/// The roles of a stretch of each list.
pub struct Standing {
    ranges: [Range<usize>; 2],
    roles: [Vec<Role>; 2],
}

impl Standing {
    /// Of the entries in these ranges of the subject's list and the clip polygon's.
    pub fn of(step: &Step<'_, WeilerAtherton>, ranges: [Range<usize>; 2]) -> Self {
        let roles = BOTH.map(|list| {
            let places = ranges[list.idx()].clone();
            places.map(|place| at_rest(step, list, place)).collect()
        });
        let mut standing = Self { ranges, roles };
        standing.walked(step.state);
        for (list, place) in current(step) {
            standing.set(list, place, Role::Signal);
        }
        if let Some(Event::Whole {
            list,
            places: [start, end],
            kind,
            ..
        }) = step.event
        {
            let role = kind.map_or(Role::Discarded, |_| Role::Signal);
            for place in start as usize..end as usize {
                standing.set(list, place, role);
            }
        }
        standing
    }

    /// Of an entry, if it is in range.
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
    fn walked(&mut self, state: &State) {
        let twins = self.twins(state);
        let kept = state
            .kept
            .iter()
            .map(|&(list, place)| (list, place, Role::Accepted));
        let on_path = |&Passed { list, place, .. }: &Passed| (list, place, Role::Accent);
        for (list, place, role) in kept.chain(state.passed.iter().map(on_path)) {
            self.set(list, place as usize, role);
            // The walk changes lists where it enters, leaves or pinches: there it has been in both.
            let Some(&Some((node, twin))) = twins[list.idx()].get(place as usize) else {
                continue;
            };
            let is_start = list == List::Subject && state.start == Some(node);
            let stays = label(state, node).is_none_or(|label| label == IntersectionLabel::Touching);
            if !(stays || is_start && role == Role::Accent) {
                self.set(list.other(), twin, role);
            }
        }
    }

    /// For each place of both lists the intersection there and its place in the other list, where that is in range.
    fn twins(&self, state: &State) -> [Vec<Option<(u32, usize)>>; 2] {
        let mut twins = BOTH.map(|list| vec![None; state.lists[list.idx()].len()]);
        for &[node, in_clip] in state.inserted.iter() {
            let Some(in_subject) = place_of(state, List::Subject, node) else {
                continue;
            };
            let places = [in_subject, in_clip as usize];
            for list in BOTH {
                let twin = places[list.other().idx()];
                if self.ranges[list.other().idx()].contains(&twin) {
                    twins[list.idx()][places[list.idx()]] = Some((node, twin));
                }
            }
        }
        twins
    }
}

/// Of an entry that nothing happens to.
fn at_rest(step: &Step<'_, WeilerAtherton>, list: List, place: usize) -> Role {
    match step.state.lists[list.idx()].get(place) {
        None => Role::Faint,
        Some(_) if step.state.relation.is_some() => Role::Discarded,
        Some(entry) if entry.node.is_some() => Role::Ink,
        Some(_) => Role::Soft,
    }
}

/// The entries that this step is about.
pub fn current(step: &Step<'_, WeilerAtherton>) -> Vec<(List, usize)> {
    let state = step.state;
    let last = |list: List| Some((list, state.lists[list.idx()].len().checked_sub(1)?));
    let of_node = |list, node| Some((list, place_of(state, list, node)?));
    let both = |node| BOTH.map(|list| of_node(list, node));
    let entries = match step.event {
        None | Some(Event::Whole { .. } | Event::Hole { .. } | Event::Done { .. }) => [None; 2],
        Some(Event::Vertex { list, .. }) => [last(list), None],
        Some(Event::Found { .. }) => [last(List::Subject), None],
        Some(Event::Inserted { node_idx, .. }) => {
            [of_node(List::Subject, node_idx), last(List::Clip)]
        }
        Some(Event::Labelled { node_idx, .. } | Event::Switch { node_idx, .. }) => both(node_idx),
        Some(Event::Start { node_idx }) => [of_node(List::Subject, node_idx), None],
        Some(Event::Visit { list, place, .. }) => [Some((list, place as usize)), None],
        Some(Event::Closed { .. }) => taken(step).map_or([None; 2], |(node, _)| both(node)),
    };
    entries.into_iter().flatten().collect()
}

/// The intersection at which lists are changed at this step, and the list that is left there.
pub fn taken(step: &Step<'_, WeilerAtherton>) -> Option<(u32, List)> {
    match step.event? {
        Event::Inserted { node_idx, .. } => Some((node_idx, List::Subject)),
        Event::Switch { node_idx, to, .. } => Some((node_idx, to.other())),
        // Back where the walk has been, by the clip polygon's list.
        Event::Closed { .. } => {
            let (list, place) = step.state.position?;
            let next = next_place(step, list, place as usize);
            let entry = step.state.lists[list.idx()].get(next)?;
            Some((entry.node?, list)).filter(|&(_, left)| left == List::Clip)
        }
        Event::Vertex { .. }
        | Event::Found { .. }
        | Event::Labelled { .. }
        | Event::Start { .. }
        | Event::Visit { .. }
        | Event::Whole { .. }
        | Event::Hole { .. }
        | Event::Done { .. } => None,
    }
}

/// The place of an intersection in a list, once it is there.
pub fn place_of(state: &State, list: List, node: u32) -> Option<usize> {
    match list {
        List::Subject => Some(state.nodes.get(node as usize)?.place as usize),
        List::Clip => {
            let mut inserted = state.inserted.iter();
            let [_, place] = inserted.find(|[inserted, _]| *inserted == node)?;
            Some(*place as usize)
        }
    }
}

/// The place after this one, in its ring.
pub fn next_place(step: &Step<'_, WeilerAtherton>, list: List, place: usize) -> usize {
    let entries = &step.state.lists[list.idx()];
    let rings = names::border(step.input, list);
    let begins = |entry: &ListEntry| {
        let vertex = entry.vertex.map(|vertex| vertex as usize);
        vertex.filter(|&vertex| rings.bounds(rings.ring_of(vertex))[0] == vertex)
    };
    let next = place + 1;
    match entries.get(next) {
        Some(entry) if begins(entry).is_none() => next,
        Some(_) | None => (0..=place)
            .rev()
            .find(|&place| entries.get(place).and_then(begins).is_some())
            .unwrap_or(0),
    }
}

/// What the subject does at an intersection, once that is known.
pub fn label(state: &State, node: u32) -> Option<IntersectionLabel> {
    let label = state.labels.get(node as usize)?;
    Some(label.label)
}

/// How many entries a list will have without the intersections that are not found yet.
pub fn len(step: &Step<'_, WeilerAtherton>, list: List) -> usize {
    step.state.lists[list.idx()].len() + names::border(step.input, list).points().len()
        - n_vertices(step.state, list)
}

/// How many of a polygon's own vertices are in its list.
pub fn n_vertices(state: &State, list: List) -> usize {
    let entries = &state.lists[list.idx()];
    let mut vertices = (0..entries.len())
        .rev()
        .filter_map(|place| entries.get(place)?.vertex);
    vertices.next().map_or(0, |last| last as usize + 1)
}
